/*
 * ppform - Taylor's polynomials at the middle of each span.
 */
#include "ppform.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"

enum { ORDER_MAX = BSPLINE_DEGREE_MAX + 1, KNOTS_MAX = 3 * ORDER_MAX };

struct ppform ppform_new(const struct bspline *curve)
{
    struct ppform f = {.degree = curve->degree, .width = curve->head != NULL ? 6 : 3};
    size_t order = (size_t)f.degree + 1, width = (size_t)f.width;

    f.spans = curve->poles - (size_t)f.degree;
    f.curve = mem_alloc(f.spans * order * width, sizeof(double));
    f.basis = mem_alloc(f.spans * order * order, sizeof(double));
    f.slope = mem_alloc(f.spans * 2 * (size_t)f.degree * order * width, sizeof(double));
    return f;
}

void ppform_free(struct ppform *form)
{
    free(form->curve);
    free(form->basis);
    free(form->slope);
    *form = (struct ppform){0};
}

/* Adds  factor (sign s + shift) from[]  to the polynomial to[], from of `n` coefficients. */
static void add_product(double *to, const double *from, int n, double factor, double sign,
                        double shift)
{
    for (int k = 0; k < n; k++) {
        to[k] += factor * shift * from[k];
        to[k + 1] += factor * sign * from[k];
    }
}

/*
 * The coefficients by power of the basis functions of a span: c[function * order + power]; by the
 * recurrence of Cox and de Boor (The NURBS Book, A2.2) on polynomials instead of values.
 */
static void basis_powers(int degree, const double *knot, size_t span, double *c)
{
    int order = degree + 1;
    double half = (knot[span + 1] - knot[span]) / 2, middle = knot[span] + half;
    double before[ORDER_MAX * ORDER_MAX], by = 1 / half;

    memset(c, 0, (size_t)(order * order) * sizeof *c);
    c[0] = 1;
    for (int q = 1; q <= degree; q++) {
        memcpy(before, c, (size_t)(q * order) * sizeof *c);
        memset(c, 0, (size_t)((q + 1) * order) * sizeof *c);
        for (int r = 0; r < q; r++) {
            double right = (knot[span + 1 + (size_t)r] - middle) * by;
            double left = (knot[span + 1 + (size_t)r - (size_t)q] - middle) * by;
            double factor = 1 / (right - left);
            add_product(&c[r * order], &before[r * order], q, factor, -1, right);
            add_product(&c[(r + 1) * order], &before[r * order], q, factor, 1, -left);
        }
    }
}

/* sum += factor * polynomial[0..order-1] (one number each power) for all components of `pole`. */
static void add_pole(double *sum, int order, int width, const double *polynomial,
                     const double *pole)
{
    for (int k = 0; k < order; k++)
        for (int c = 0; c < width; c++)
            sum[k * width + c] += polynomial[k] * pole[c];
}

static void pole_values(const struct bspline *b, size_t i, double value[6])
{
    struct vec3 p = b->pole[i], h = b->head != NULL ? b->head[i] : vec(0, 0, 0);

    value[0] = p.x;
    value[1] = p.y;
    value[2] = p.z;
    value[3] = h.x;
    value[4] = h.y;
    value[5] = h.z;
}

void ppform_curve(struct ppform *form, const struct bspline *b)
{
    int order = form->degree + 1;
    size_t room = (size_t)(order * form->width), square = (size_t)(order * order);

    form->knot = b->knot;
    memset(form->curve, 0, form->spans * room * sizeof(double));
    for (size_t span = 0; span < form->spans; span++) {
        double *basis = &form->basis[span * square];
        basis_powers(form->degree, b->knot, span + (size_t)form->degree, basis);
        for (int i = 0; i < order; i++) {
            double pole[6];
            pole_values(b, span + (size_t)i, pole);
            add_pole(&form->curve[span * room], order, form->width, &basis[i * order], pole);
        }
    }
}

/* (P_i - P_(i-1)) / (t_(i+p) - t_i), for all components. */
static void pole_slope(const struct bspline *b, size_t i, double value[6])
{
    double before[6], width = b->knot[i + (size_t)b->degree] - b->knot[i];

    pole_values(b, i, value);
    pole_values(b, i - 1, before);
    for (int c = 0; c < 6; c++)
        value[c] = (value[c] - before[c]) / width;
}

/* The derivative by knot j in a span whose first knot is knot `at`. */
static void knot_slope(const struct ppform *form, const struct bspline *b, size_t at, size_t j,
                       double *slope)
{
    int order = form->degree + 1;
    size_t p = (size_t)form->degree;
    double doubled[KNOTS_MAX], c[ORDER_MAX * ORDER_MAX];
    size_t first = at - p, last = at + p + 1; /* knots that matter here */
    size_t n = 0;

    for (size_t i = first; i <= last; i++) {
        doubled[n++] = b->knot[i];
        if (i == j)
            doubled[n++] = b->knot[i];
    }
    size_t span = (j <= at ? at + 1 : at) - first;
    basis_powers(form->degree, doubled, span, c);
    memset(slope, 0, (size_t)(order * form->width) * sizeof *slope);
    for (int k = 0; k < order; k++) {
        size_t i = span - p + (size_t)k + first; /* number of the function among the doubled */
        double pole[6];
        if (i + p < j || i > j)
            continue;
        pole_slope(b, i, pole);
        for (int d = 0; d < 6; d++)
            pole[d] = -pole[d];
        add_pole(slope, order, form->width, &c[k * order], pole);
    }
}

void ppform_slopes(struct ppform *form, const struct bspline *b)
{
    size_t p = (size_t)form->degree, room = (p + 1) * (size_t)form->width;

    for (size_t span = 0; span < form->spans; span++)
        for (size_t k = 0; k < 2 * p; k++) {
            size_t j = span + 1 + k;
            if (j > p && j < b->poles)
                knot_slope(form, b, span + p, j, &form->slope[(span * 2 * p + k) * room]);
        }
}

double ppform_half(const struct ppform *form, size_t span)
{
    const double *from = &form->knot[(size_t)form->degree + span];
    return (from[1] - from[0]) / 2;
}

double ppform_place(const struct ppform *form, size_t span, double u)
{
    const double *from = &form->knot[(size_t)form->degree + span];
    return (2 * u - from[0] - from[1]) / (from[1] - from[0]);
}

size_t ppform_span(const struct ppform *form, size_t near, double u)
{
    const double *knot = &form->knot[form->degree];

    while (near + 1 < form->spans && u >= knot[near + 1])
        near++;
    while (near > 0 && u < knot[near])
        near--;
    return near;
}

/* Horner's rule for value and derivatives by s at once; inline, for a width that is known. */
static inline void horner(const double *c, int degree, int width, double s, double *value,
                          double *first, double *second)
{
    for (int i = 0; i < width; i++) {
        value[i] = c[degree * width + i];
        first[i] = second[i] = 0;
    }
    for (int k = degree - 1; k >= 0; k--)
        for (int i = 0; i < width; i++) {
            second[i] = second[i] * s + first[i];
            first[i] = first[i] * s + value[i];
            value[i] = value[i] * s + c[k * width + i];
        }
}

void ppform_at(const struct ppform *form, size_t span, double u, double *value, double *first,
               double *second)
{
    const double *from = &form->knot[(size_t)form->degree + span];
    double by = 2 / (from[1] - from[0]), s = (u - from[0]) * by - 1;
    const double *c = &form->curve[span * (size_t)((form->degree + 1) * form->width)];

    if (form->width == 3 && form->degree == 3)
        horner(c, 3, 3, s, value, first, second);
    else if (form->width == 3)
        horner(c, form->degree, 3, s, value, first, second);
    else
        horner(c, form->degree, 6, s, value, first, second);
    for (int i = 0; i < form->width; i++) {
        first[i] *= by;
        second[i] *= 2 * by * by;
    }
}
