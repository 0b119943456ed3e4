/*
 * bspline - evaluation by the basis functions that are not zero (Piegl and Tiller, The NURBS Book,
 * A2.1 to A2.3) and knot insertion after Boehm (A5.1).
 */
#include "curve/bspline.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"

/* Room for the basis functions of the highest degree that are not zero at one place. */
enum { WIDTH = BSPLINE_DEGREE_MAX + 1 };

struct bspline bspline_new(int degree, size_t poles, bool with_head)
{
    struct bspline b = {.degree = degree, .poles = poles};

    b.knot = mem_alloc(poles + (size_t)degree + 1, sizeof *b.knot);
    b.pole = mem_alloc(poles, sizeof *b.pole);
    if (with_head)
        b.head = mem_alloc(poles, sizeof *b.head);
    return b;
}

struct bspline bspline_copy(const struct bspline *b)
{
    struct bspline copy = bspline_new(b->degree, b->poles, b->head != NULL);

    copy.length = b->length;
    memcpy(copy.knot, b->knot, (b->poles + (size_t)b->degree + 1) * sizeof *b->knot);
    memcpy(copy.pole, b->pole, b->poles * sizeof *b->pole);
    if (b->head != NULL)
        memcpy(copy.head, b->head, b->poles * sizeof *b->head);
    return copy;
}

void bspline_free(struct bspline *b)
{
    free(b->knot);
    free(b->pole);
    free(b->head);
    *b = (struct bspline){0};
}

size_t bspline_span(int degree, size_t poles, const double *knot, double u)
{
    size_t low = (size_t)degree, high = poles;

    if (!(u < knot[high])) { /* at the end, or beyond: the last span that is not empty */
        size_t i = poles - 1;
        while (i > low && knot[i] >= knot[high])
            i--;
        return i;
    }
    while (high - low > 1) {
        size_t mid = low + (high - low) / 2;
        if (u < knot[mid])
            high = mid;
        else
            low = mid;
    }
    return low;
}

size_t bspline_span_from(int degree, size_t poles, const double *knot, double u, size_t from)
{
    if (!(knot[from] <= u && u < knot[poles]))
        return bspline_span(degree, poles, knot, u);
    while (knot[from + 1] <= u)
        from++;
    return from;
}

static inline void basis_of(int degree, const double *knot, size_t span, double u, double *value)
{
    double left[WIDTH], right[WIDTH];

    value[0] = 1;
    for (int j = 1; j <= degree; j++) {
        size_t step = (size_t)j;
        double saved = 0;

        left[j] = u - knot[span + 1 - step];
        right[j] = knot[span + step] - u;
        for (int r = 0; r < j; r++) {
            double t = value[r] / (right[r + 1] + left[j - r]);
            value[r] = saved + right[r + 1] * t;
            saved = left[j - r] * t;
        }
        value[j] = saved;
    }
}

/* Most curves are cubic: what is known of the loops there takes a third of the time away. */
void bspline_basis(int degree, const double *knot, size_t span, double u, double *value)
{
    if (degree == 3)
        basis_of(3, knot, span, u, value);
    else
        basis_of(degree, knot, span, u, value);
}

/* Upper triangle and diagonal: basis functions of each degree; lower triangle: knot differences. */
static void basis_triangle(int degree, const double *knot, size_t span, double u,
                           double ndu[WIDTH][WIDTH])
{
    double left[WIDTH], right[WIDTH];

    ndu[0][0] = 1;
    for (int j = 1; j <= degree; j++) {
        size_t step = (size_t)j;
        double saved = 0;

        left[j] = u - knot[span + 1 - step];
        right[j] = knot[span + step] - u;
        for (int r = 0; r < j; r++) {
            ndu[j][r] = right[r + 1] + left[j - r];
            double t = ndu[r][j - 1] / ndu[j][r];
            ndu[r][j] = saved + right[r + 1] * t;
            saved = left[j - r] * t;
        }
        ndu[j][j] = saved;
    }
}

/* Derivatives 1..order of the basis function r of the span, still without the factorials. */
static void basis_column(int degree, int r, int order, double ndu[WIDTH][WIDTH], double *value)
{
    double a[2][WIDTH] = {{1}, {0}};
    int now = 0;

    for (int k = 1; k <= order; k++) {
        int next = 1 - now, rk = r - k, pk = degree - k;
        double d = 0;

        if (r >= k) {
            a[next][0] = a[now][0] / ndu[pk + 1][rk];
            d = a[next][0] * ndu[rk][pk];
        }
        int first = rk >= -1 ? 1 : -rk;
        int last = r - 1 <= pk ? k - 1 : degree - r;
        for (int j = first; j <= last; j++) {
            a[next][j] = (a[now][j] - a[now][j - 1]) / ndu[pk + 1][rk + j];
            d += a[next][j] * ndu[rk + j][pk];
        }
        if (r <= pk) {
            a[next][k] = -a[now][k - 1] / ndu[pk + 1][r];
            d += a[next][k] * ndu[r][pk];
        }
        value[k * (degree + 1) + r] = d;
        now = next;
    }
}

void bspline_basis_derivatives(int degree, const double *knot, size_t span, double u, int order,
                               double *value)
{
    double ndu[WIDTH][WIDTH] = {{0}};
    int real = order < degree ? order : degree;
    double factor = degree;

    basis_triangle(degree, knot, span, u, ndu);
    for (int r = 0; r <= degree; r++) {
        value[r] = ndu[r][degree];
        basis_column(degree, r, real, ndu, value);
    }
    for (int k = 1; k <= real; k++) {
        for (int r = 0; r <= degree; r++)
            value[k * (degree + 1) + r] *= factor;
        factor *= degree - k;
    }
    for (int k = real + 1; k <= order; k++)
        for (int r = 0; r <= degree; r++)
            value[k * (degree + 1) + r] = 0;
}

struct vec3 bspline_at(const struct bspline *b, const struct vec3 *pole, double u)
{
    double value[WIDTH];
    size_t span = bspline_span(b->degree, b->poles, b->knot, u);
    const struct vec3 *first = &pole[span - (size_t)b->degree];
    struct vec3 p = {0, 0, 0};

    bspline_basis(b->degree, b->knot, span, u, value);
    for (int i = 0; i <= b->degree; i++)
        p = vec_along(p, value[i], first[i]);
    return p;
}

void bspline_both_at(const struct bspline *b, double u, struct vec3 *point, struct vec3 *head)
{
    double value[WIDTH];
    size_t span = bspline_span(b->degree, b->poles, b->knot, u), first = span - (size_t)b->degree;
    struct vec3 p = {0, 0, 0}, h = {0, 0, 0};

    bspline_basis(b->degree, b->knot, span, u, value);
    for (int i = 0; i <= b->degree; i++) {
        p = vec_along(p, value[i], b->pole[first + (size_t)i]);
        h = vec_along(h, value[i], b->head[first + (size_t)i]);
    }
    *point = p;
    *head = h;
}

void bspline_derivatives(const struct bspline *b, const struct vec3 *pole, double u, int order,
                         struct vec3 *result)
{
    double value[WIDTH * WIDTH];
    int real = order < b->degree ? order : b->degree;
    size_t span = bspline_span(b->degree, b->poles, b->knot, u);
    const struct vec3 *first = &pole[span - (size_t)b->degree];

    bspline_basis_derivatives(b->degree, b->knot, span, u, real, value);
    for (int k = 0; k <= order; k++) {
        result[k] = vec(0, 0, 0);
        for (int i = 0; k <= real && i <= b->degree; i++)
            result[k] = vec_along(result[k], value[k * (b->degree + 1) + i], first[i]);
    }
}

/* A new array: the poles with one more of them, for a knot more at u in the span. */
static struct vec3 *insert_pole(const struct bspline *b, const struct vec3 *pole, size_t span,
                                double u)
{
    size_t p = (size_t)b->degree;
    struct vec3 *more = mem_alloc(b->poles + 1, sizeof *more);

    for (size_t i = 0; i <= b->poles; i++) {
        if (i + p <= span)
            more[i] = pole[i];
        else if (i > span)
            more[i] = pole[i - 1];
        else
            more[i] =
                vec_mix(pole[i - 1], pole[i], (u - b->knot[i]) / (b->knot[i + p] - b->knot[i]));
    }
    return more;
}

double bspline_span_length(const struct bspline *b, size_t i)
{
    return vec_distance(bspline_at(b, b->pole, b->knot[i]), bspline_at(b, b->pole, b->knot[i + 1]));
}

bool bspline_has_short_span(const struct bspline *b, double least)
{
    for (size_t i = (size_t)b->degree; least > 0 && i < b->poles; i++)
        if (bspline_span_length(b, i) < least)
            return true;
    return false;
}

void bspline_insert(struct bspline *b, double u)
{
    size_t span = bspline_span(b->degree, b->poles, b->knot, u);
    size_t knots = b->poles + (size_t)b->degree + 1;
    struct vec3 *pole = insert_pole(b, b->pole, span, u);
    struct vec3 *head = b->head != NULL ? insert_pole(b, b->head, span, u) : NULL;
    double *knot = mem_alloc(knots + 1, sizeof *knot);

    memcpy(knot, b->knot, (span + 1) * sizeof *knot);
    knot[span + 1] = u;
    memcpy(knot + span + 2, b->knot + span + 1, (knots - span - 1) * sizeof *knot);
    free(b->knot);
    free(b->pole);
    free(b->head);
    b->knot = knot;
    b->pole = pole;
    b->head = head;
    b->poles++;
}

/* Knots at u until the curve passes through a pole there. */
static void split_at(struct bspline *b, double u)
{
    size_t p = (size_t)b->degree, times = 0;
    if (u <= b->knot[p] || u >= b->knot[b->poles])
        return;
    for (size_t i = p + 1; i < b->poles; i++)
        times += b->knot[i] == u;
    for (; times < p; times++)
        bspline_insert(b, u);
}

/* The knot that u is but for rounding, or u. */
static double knot_or(const struct bspline *b, double u)
{
    double close = 1e-12 * (b->knot[b->poles] - b->knot[b->degree]);
    for (size_t i = (size_t)b->degree; i <= b->poles; i++)
        if (fabs(b->knot[i] - u) <= close)
            return b->knot[i];
    return u;
}

struct bspline bspline_part(const struct bspline *b, double u0, double u1)
{
    struct bspline whole = bspline_copy(b);
    u0 = knot_or(b, u0);
    u1 = knot_or(b, u1);
    split_at(&whole, u0);
    split_at(&whole, u1);
    size_t p = (size_t)b->degree, first = p, last = whole.poles;
    while (first + 1 < last && whole.knot[first + 1] <= u0)
        first++;
    while (last - 1 > first && whole.knot[last - 1] >= u1)
        last--;
    struct bspline part = bspline_new(b->degree, last - first + p, b->head != NULL);
    part.length = b->length;
    for (size_t i = 0; i < part.poles; i++) {
        part.pole[i] = whole.pole[first - p + i];
        if (b->head)
            part.head[i] = whole.head[first - p + i];
    }
    for (size_t i = 0; i < part.poles + p + 1; i++)
        part.knot[i] = i <= p            ? whole.knot[first]
                       : i >= part.poles ? whole.knot[last]
                                         : whole.knot[first - p + i];
    bspline_free(&whole);
    return part;
}

bool bspline_uniform(const struct bspline *b)
{
    size_t p = (size_t)b->degree, spans = b->poles - p;
    double from = b->knot[p], range = b->knot[b->poles] - from;
    double within = fmax(1e-9 * range, 1e-6); /* 1e-6: the last digit of a printed knot */

    for (size_t i = 1; i < spans; i++)
        if (fabs(b->knot[p + i] - from - range * (double)i / (double)spans) > within)
            return false;
    return range > 0;
}
