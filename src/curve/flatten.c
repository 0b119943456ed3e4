/*
 * flatten - pieces by bounds of the second derivative in each span.
 *
 * With w = head - point, the axis a = w / |w| has |a"| <= |w"| / |w| + 3 |w'|^2 / |w|^2, which
 * bounds the path of the other point, point + offset a.
 */
#include "curve/flatten.h"

#include <stdlib.h>

static const double PIECES_MAX = 5000;

void flat_free(struct flat *flat)
{
    array_free(&flat->u);
    array_free(&flat->point);
    array_free(&flat->other);
    array_free(&flat->axis);
}

static bool finite_vec(struct vec3 v)
{
    return isfinite(v.x) && isfinite(v.y) && isfinite(v.z);
}

static bool usable(const struct bspline *c)
{
    for (size_t i = 0; i < c->poles; i++) {
        if (!finite_vec(c->pole[i]))
            return false;
        if (c->head != NULL && !finite_vec(c->head[i]))
            return false;
    }
    for (size_t i = 1; i < c->poles + (size_t)c->degree + 1; i++)
        if (!(c->knot[i] >= c->knot[i - 1]) || !isfinite(c->knot[i]))
            return false;
    return c->knot[c->poles] > c->knot[0];
}

/* Pole i of derivative `order` (0, 1, 2) of the curve through `pole` (Piegl and Tiller, eq 3.8). */
static struct vec3 slope_pole(const struct bspline *c, const struct vec3 *pole, int order, size_t i)
{
    if (order == 0)
        return pole[i];
    size_t degree = (size_t)c->degree + 1 - (size_t)order;
    double width = c->knot[i + (size_t)order + degree] - c->knot[i + (size_t)order];
    if (!(width > 0))
        return vec(0, 0, 0); /* goes with a basis function that is zero */
    return vec_scale((double)degree / width, vec_sub(slope_pole(c, pole, order - 1, i + 1),
                                                     slope_pole(c, pole, order - 1, i)));
}

/* Bound of |derivative| in the span, by the poles that act there. */
static double bound(const struct bspline *c, const struct vec3 *pole, const struct vec3 *minus,
                    int order, size_t span)
{
    double most = 0;

    if (order > c->degree)
        return 0;
    for (size_t i = span - (size_t)c->degree; i + (size_t)order <= span; i++) {
        struct vec3 d = slope_pole(c, pole, order, i);
        if (minus != NULL)
            d = vec_sub(d, slope_pole(c, minus, order, i));
        most = fmax(most, vec_length(d));
    }
    return most;
}

static double pieces_in_span(const struct bspline *c, double offset, double chord, size_t span)
{
    double h = c->knot[span + 1] - c->knot[span];
    double bend = bound(c, c->pole, NULL, 2, span);

    if (c->head != NULL && offset != 0) {
        double length = c->length / 2;
        double speed = bound(c, c->head, c->pole, 1, span) / length;
        double turn = bound(c, c->head, c->pole, 2, span) / length + 3 * speed * speed;
        bend += fabs(offset) * turn;
    }
    double pieces = ceil(h * sqrt(bend / (8 * chord)));
    return pieces < 1 ? 1 : pieces;
}

/* Adds the vertex at u; false when the head is too near. */
static bool add_vertex(const struct bspline *c, double offset, struct vec3 axis, double u,
                       struct flat *flat)
{
    struct vec3 p, head;

    if (c->head == NULL) {
        p = bspline_at(c, c->pole, u);
    } else {
        bspline_both_at(c, u, &p, &head);
        struct vec3 w = vec_sub(head, p);
        if (!(vec_length(w) > c->length / 2))
            return false;
        axis = vec_unit(w);
    }
    *array_push(&flat->u) = u;
    *array_push(&flat->point) = p;
    *array_push(&flat->other) = vec_along(p, offset, axis);
    *array_push(&flat->axis) = axis;
    return true;
}

bool flatten(const struct bspline *curve, double offset, struct vec3 axis, double chord,
             struct flat *flat)
{
    if (!usable(curve) || !add_vertex(curve, offset, axis, curve->knot[0], flat))
        return false;
    for (size_t span = (size_t)curve->degree; span < curve->poles; span++) {
        double from = curve->knot[span], to = curve->knot[span + 1];
        if (!(to > from))
            continue;
        double pieces = pieces_in_span(curve, offset, chord, span);
        if (!(pieces <= PIECES_MAX))
            return false;
        int last = (int)pieces;
        for (int k = 1; k <= last; k++) {
            double u = k < last ? from + (to - from) * k / pieces : to;
            if (!add_vertex(curve, offset, axis, u, flat))
                return false;
        }
    }
    return true;
}
