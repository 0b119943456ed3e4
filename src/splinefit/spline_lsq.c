/* spline_lsq - see spline_lsq.h. */
#include "spline_lsq.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/band.h"

/* ---- curves of a reference */

struct vec3 *spline_heads(const struct reference *reference)
{
    struct vec3 *head = mem_alloc(reference->n, sizeof *head);

    for (size_t k = 0; k < reference->n; k++)
        head[k] = spline_head(reference, k);
    return head;
}

struct bspline spline_new(const struct reference *reference, int degree, size_t poles)
{
    struct bspline curve = bspline_new(degree, poles, reference->turns);

    curve.length = HEAD_LENGTH;
    return curve;
}

static void set_pole(struct bspline *curve, size_t i, const struct reference *reference, size_t k)
{
    curve->pole[i] = reference->point[k];
    if (reference->turns)
        curve->head[i] = spline_head(reference, k);
}

struct bspline spline_straight(const struct reference *reference)
{
    struct bspline curve = spline_new(reference, 1, 2);

    set_pole(&curve, 0, reference, 0);
    set_pole(&curve, 1, reference, reference->n - 1);
    curve.knot[2] = curve.knot[3] = 1;
    return curve;
}

struct bspline spline_polyline(const struct reference *reference)
{
    struct bspline curve = spline_new(reference, 1, reference->n);

    for (size_t k = 0; k < reference->n; k++)
        set_pole(&curve, k, reference, k);
    for (size_t k = 1; k < reference->n; k++)
        curve.knot[k + 1] = reference->length[k];
    curve.knot[reference->n + 1] = curve.knot[reference->n];
    return curve;
}

/* ---- parameters and knots */

static double step_of(enum params_method method, double chord)
{
    switch (method) {
    case PARAMS_CENTRIPETAL:
        return sqrt(chord);
    case PARAMS_CHORD:
        return chord;
    default:
        return 1;
    }
}

void params_fill(enum params_method method, const double *chord, size_t n, double *u)
{
    double sum = 0;

    u[0] = 0;
    for (size_t k = 1; k < n; k++) {
        sum += step_of(method, chord[k - 1]);
        u[k] = sum;
    }
    if (!(sum > 0)) {
        params_fill(PARAMS_UNIFORM, chord, n, u);
        return;
    }
    for (size_t k = 1; k < n; k++)
        u[k] /= sum;
    u[n - 1] = 1;
}

/* Eq 9.68: the place of inner knot j among the data, and eq 9.69 between its two neighbours. */
static double average_of_data(const double *u, size_t n, size_t inner, size_t j)
{
    double d = (double)n / (double)(inner + 1), place = (double)j * d;
    size_t i = (size_t)place;
    double alpha = place - (double)i;

    return (1 - alpha) * u[i - 1] + alpha * u[i];
}

/* Eq 9.8: the mean of `degree` parameters, for interpolation. */
static double average_of_parameters(const double *u, int degree, size_t j)
{
    double sum = 0;

    for (size_t i = j; i < j + (size_t)degree; i++)
        sum += u[i];
    return sum / degree;
}

static double inner_knot(enum knots_method method, const double *u, size_t n, int degree,
                         size_t poles, size_t j)
{
    size_t inner = poles - (size_t)degree - 1;

    if (method == KNOTS_UNIFORM)
        return (double)j / (double)(inner + 1);
    if (poles == n)
        return average_of_parameters(u, degree, j);
    return average_of_data(u, n, inner, j);
}

void knots_fill(enum knots_method method, const double *u, size_t n, int degree, size_t poles,
                double *knot)
{
    size_t p = (size_t)degree;

    for (size_t i = 0; i <= p; i++) {
        knot[i] = 0;
        knot[poles + i] = 1;
    }
    for (size_t j = 1; j + p < poles; j++)
        knot[p + j] = inner_knot(method, u, n, degree, poles, j);
}

/* ---- least squares: normal equations of the inner poles, a band of width `degree`, by Cholesky */

/* Adds a point to its three columns of the right-hand side; what the end poles give is known. */
static void add_point(const struct bspline *curve, size_t first, const double *value,
                      const struct vec3 *pole, struct vec3 point, double *right, size_t columns)
{
    size_t last = curve->poles - 1;
    struct vec3 rest = point;

    for (size_t i = 0; i <= (size_t)curve->degree; i++)
        if (first + i == 0 || first + i == last)
            rest = vec_along(rest, -value[i], pole[first + i]);
    for (size_t i = 0; i <= (size_t)curve->degree; i++) {
        if (first + i == 0 || first + i == last)
            continue;
        double *row = &right[(first + i - 1) * columns];
        row[0] += value[i] * rest.x;
        row[1] += value[i] * rest.y;
        row[2] += value[i] * rest.z;
    }
}

/* Adds its products to the matrix. */
static void add_products(const struct bspline *curve, size_t first, const double *value,
                         struct band *matrix)
{
    size_t last = curve->poles - 1;

    for (size_t i = 0; i <= (size_t)curve->degree; i++) {
        if (first + i == 0 || first + i == last)
            continue;
        for (size_t j = 0; j <= i; j++)
            if (first + j != 0)
                *band_at(matrix, first + i - 1, first + j - 1) += value[i] * value[j];
    }
}

static void take_poles(const double *x, size_t columns, size_t inner, struct vec3 *pole)
{
    for (size_t i = 0; i < inner; i++)
        pole[i + 1] = vec(x[i * columns], x[i * columns + 1], x[i * columns + 2]);
}

bool lsq_fit(struct bspline *curve, const double *u, const struct vec3 *point,
             const struct vec3 *head, size_t n)
{
    size_t inner = curve->poles - 2, degree = (size_t)curve->degree, span = degree;
    size_t columns = curve->head != NULL ? 6 : 3;
    double value[BSPLINE_DEGREE_MAX + 1];

    if (curve->poles > n)
        return false;
    curve->pole[0] = point[0];
    curve->pole[inner + 1] = point[n - 1];
    if (curve->head != NULL) {
        curve->head[0] = head[0];
        curve->head[inner + 1] = head[n - 1];
    }
    struct band matrix = band_new(inner, degree);
    double *right = mem_alloc(columns * inner, sizeof *right);

    for (size_t k = 1; k + 1 < n; k++) {
        span = bspline_span_from(curve->degree, curve->poles, curve->knot, u[k], span);
        bspline_basis(curve->degree, curve->knot, span, u[k], value);
        add_products(curve, span - degree, value, &matrix);
        add_point(curve, span - degree, value, curve->pole, point[k], right, columns);
        if (curve->head != NULL)
            add_point(curve, span - degree, value, curve->head, head[k], right + 3, columns);
    }
    bool determined = band_factor(&matrix);
    if (determined) {
        band_solve(&matrix, right, columns);
        take_poles(right, columns, inner, curve->pole);
        if (curve->head != NULL)
            take_poles(right + 3, columns, inner, curve->head);
    }
    band_free(&matrix);
    free(right);
    return determined;
}

/* ---- paper 2's measures */

struct fit_error fit_error_of(const struct bspline *curve, const struct vec3 *pole,
                              const struct vec3 *point, const double *u, size_t n)
{
    struct fit_error d = {0};
    double sum = 0;

    for (size_t k = 0; k < n; k++) {
        double off = vec_distance(point[k], bspline_at(curve, pole, u[k]));
        d.c1 = fmax(d.c1, off);
        sum += off * off;
    }
    for (size_t k = 0; k + 1 < n; k++) {
        struct vec3 middle = vec_mix(point[k], point[k + 1], 0.5);
        struct vec3 there = bspline_at(curve, pole, (u[k] + u[k + 1]) / 2);
        d.middle = fmax(d.middle, vec_distance(middle, there));
    }
    d.c2 = sqrt(sum) / (double)n;
    d.rms = sqrt(sum / (double)n);
    return d;
}
