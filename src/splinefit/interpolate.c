/* interpolate - see interpolate.h. */
#include "interpolate.h"

#include <stdlib.h>

#include "base/array.h"
#include "spline_lsq.h"

/* A tridiagonal system: row k has below[k], at[k], above[k]. */
struct tridiagonal {
    size_t n;
    double *below, *at, *above;
    struct vec3 *right;
};

static struct tridiagonal tridiagonal_new(size_t n)
{
    double *row = mem_alloc(3 * n, sizeof *row);

    return (struct tridiagonal){n, row, row + n, row + 2 * n, mem_alloc(n, sizeof(struct vec3))};
}

static void tridiagonal_free(struct tridiagonal *t)
{
    free(t->below);
    free(t->right);
}

/* Leaves the solution in `right`.  Without pivots: rows of B-splines at their knots need none. */
static void tridiagonal_solve(struct tridiagonal *t)
{
    for (size_t k = 1; k < t->n; k++) {
        double part = t->below[k] / t->at[k - 1];
        t->at[k] -= part * t->above[k - 1];
        t->right[k] = vec_along(t->right[k], -part, t->right[k - 1]);
    }
    for (size_t k = t->n; k-- > 0;) {
        if (k + 1 < t->n)
            t->right[k] = vec_along(t->right[k], -t->above[k], t->right[k + 1]);
        t->right[k] = vec_scale(1 / t->at[k], t->right[k]);
    }
}

/* The derivative at the first of three points of the parabola through them: at parameters 0, a and
 * a + b. */
static struct vec3 parabola_slope(struct vec3 p, struct vec3 q, struct vec3 r, double a, double b)
{
    struct vec3 first = vec_scale(1 / a, vec_sub(q, p)), second = vec_scale(1 / b, vec_sub(r, q));

    return vec_along(first, -a / (a + b), vec_sub(second, first));
}

/* The derivative that an end condition states, at the first of three points of the parameters u,
 * towards the second; n: 2 if there are no three. */
static struct vec3 slope_of(enum spline_ends ends, size_t n, struct vec3 p, struct vec3 q,
                            struct vec3 r, const double u[3])
{
    double a = u[1] - u[0], b = u[2] - u[1];
    struct vec3 chord = vec_scale(1 / a, vec_sub(q, p));

    if (n == 2)
        return chord;
    if (ends == ENDS_BESSEL)
        return parabola_slope(p, q, r, a, b);
    struct vec3 v = vec_unit(chord);
    struct vec3 t = vec_unit(parabola_slope(q, p, r, -a, a + b));
    return vec_scale(vec_length(chord), vec_along(vec_scale(-1, t), 2 * vec_dot(v, t), v));
}

/* At the start (end 0) or the end (1), along rising parameters. */
static struct vec3 end_slope(enum spline_ends ends, const struct vec3 *point, const double *u,
                             size_t n, int end)
{
    size_t k[3] = {0, 1, n > 2 ? 2 : 1};

    for (int i = 0; i < 3 && end == 1; i++)
        k[i] = n - 1 - k[i];
    return slope_of(ends, n, point[k[0]], point[k[1]], point[k[2]],
                    (double[3]){u[k[0]], u[k[1]], u[k[2]]});
}

/* The condition at an end, as the first or last row: of the two poles next to the end's own. */
static void end_row(struct tridiagonal *t, const struct bspline *b, const struct vec3 *pole,
                    int end, bool natural, struct vec3 slope)
{
    size_t row = end == 0 ? 0 : t->n - 1, span = end == 0 ? 3 : b->poles - 1;
    double value[3 * 4], u = b->knot[end == 0 ? 3 : b->poles];
    int order = natural ? 2 : 1;

    bspline_basis_derivatives(3, b->knot, span, u, order, value);
    const double *d = value + order * 4;
    struct vec3 right = natural ? vec(0, 0, 0) : slope;
    t->right[row] = vec_along(right, end == 0 ? -d[0] : -d[3], pole[end == 0 ? 0 : b->poles - 1]);
    t->below[row] = end == 0 ? 0 : d[1];
    t->at[row] = end == 0 ? d[1] : d[2];
    t->above[row] = end == 0 ? d[2] : 0;
}

/* Finds the poles of the curve through n points at the knots u. */
static void find_poles(const struct bspline *b, const double *u, const struct vec3 *point, size_t n,
                       bool natural, const struct vec3 slope[2], struct vec3 *pole)
{
    struct tridiagonal t = tridiagonal_new(n);

    pole[0] = point[0];
    pole[n + 1] = point[n - 1];
    for (int end = 0; end < 2; end++)
        end_row(&t, b, pole, end, natural, slope[end]);
    for (size_t k = 1; k + 1 < n; k++) {
        double value[4];
        bspline_basis(3, b->knot, k + 3, u[k], value);
        t.below[k] = value[0];
        t.at[k] = value[1];
        t.above[k] = value[2];
        t.right[k] = point[k];
    }
    tridiagonal_solve(&t);
    for (size_t k = 0; k < n; k++)
        pole[k + 1] = t.right[k];
    tridiagonal_free(&t);
}

static void fill_knots(const double *u, size_t n, double *knot)
{
    for (size_t k = 0; k < n + 6; k++)
        knot[k] = u[k < 3 ? 0 : k > n + 2 ? n - 1 : k - 3];
}

/* The poles of the curve through n points, one of the two curves of the tool. */
static void pass_through(const struct bspline *b, const struct reference *reference,
                         const struct vec3 *point, enum spline_ends ends, struct vec3 *pole)
{
    struct vec3 slope[2];

    for (int end = 0; end < 2; end++)
        slope[end] = end_slope(ends, point, reference->length, reference->n, end);
    find_poles(b, reference->length, point, reference->n, ends == ENDS_NATURAL, slope, pole);
}

struct bspline spline_through(const struct reference *reference, enum spline_ends ends)
{
    struct bspline b = spline_new(reference, 3, reference->n + 2);

    fill_knots(reference->length, reference->n, b.knot);
    pass_through(&b, reference, reference->point, ends, b.pole);
    if (b.head != NULL) {
        struct vec3 *head = spline_heads(reference);
        pass_through(&b, reference, head, ends, b.head);
        free(head);
    }
    return b;
}
