/* cubic_form - see cubic_form.h. */
#include "curve/cubic_form.h"

#include <stdlib.h>

#include "base/array.h"

enum { CUBIC = 3 };

static void repeat_knot(struct doubles *knots, double u, int times)
{
    for (int i = 0; i < times; i++)
        *array_push(knots) = u;
}

/* The inner knots of the curve: m times in a curve of degree p leave p - m derivatives whole. */
static void own_knots(const struct bspline *b, struct doubles *knots)
{
    for (size_t i = (size_t)b->degree + 1; i < b->poles;) {
        size_t end = i;
        while (end < b->poles && b->knot[end] == b->knot[i])
            end++;
        int whole = b->degree - (int)(end - i);
        repeat_knot(knots, b->knot[i], whole >= CUBIC - 1 ? 1 : whole >= 0 ? CUBIC - whole : CUBIC);
        i = end;
    }
}

static void sort_knots(struct doubles *knots)
{
    for (size_t i = 1; i < knots->n; i++) {
        double u = knots->item[i];
        size_t k = i;
        for (; k > 0 && knots->item[k - 1] > u; k--)
            knots->item[k] = knots->item[k - 1];
        knots->item[k] = u;
    }
}

/* The blossom at t[0], t[1], t[2] of the Taylor polynomial at their mean. */
static struct vec3 pole_at(const struct bspline *b, const struct vec3 *pole, const double *t)
{
    struct vec3 d[CUBIC + 1];
    double u = (t[0] + t[1] + t[2]) / 3, x = t[0] - u, y = t[1] - u, z = t[2] - u;
    bspline_derivatives(b, pole, u, CUBIC, d);
    struct vec3 p = vec_along(d[0], (x * y + y * z + z * x) / 6, d[2]);
    return vec_along(p, x * y * z / 6, d[3]); /* the factor of the first, x + y + z, is 0 */
}

struct bspline cubic_form(const struct bspline *b, const double *more, size_t n)
{
    struct doubles knots = {0};
    double from = b->knot[0], to = b->knot[b->poles];
    own_knots(b, &knots);
    for (size_t i = 0; i < n; i++)
        repeat_knot(&knots, more[i], 1);
    sort_knots(&knots);
    struct bspline c = bspline_new(CUBIC, knots.n + CUBIC + 1, b->head != NULL);
    for (size_t i = 0; i < c.poles + CUBIC + 1; i++)
        c.knot[i] = i <= CUBIC ? from : i < c.poles ? knots.item[i - CUBIC - 1] : to;
    array_free(&knots);
    for (size_t i = 0; i < c.poles; i++) {
        c.pole[i] = pole_at(b, b->pole, c.knot + i + 1);
        if (b->head)
            c.head[i] = pole_at(b, b->head, c.knot + i + 1);
    }
    c.length = b->length;
    return c;
}
