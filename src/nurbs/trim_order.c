/* trim_order - see trim_order.h. */
#include "trim_order.h"

#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/array.h"

/* By the length of a part: its ends are one place. */
static const double ONE_PLACE = 1e-6;

double trim_order_square(struct uv a, struct uv b, const struct nurbs *s)
{
    double u = (a.u - b.u) / (s->u.to - s->u.from), v = (a.v - b.v) / (s->v.to - s->v.from);
    return u * u + v * v;
}

struct vec3 trim_order_end(const struct nurbs_curve *c, bool last)
{
    return nurbs_curve_point(c, last ? c->t.to : c->t.from);
}

/* The squared distance of two points of the loop's curves: in parts of the range, or in space. */
static double loop_distance2(const struct patch *patch, const struct patch_loop *loop,
                             struct vec3 a, struct vec3 b)
{
    if (loop->space)
        return vec_dot(vec_sub(a, b), vec_sub(a, b));
    return trim_order_square((struct uv){a.x, a.y}, (struct uv){b.x, b.y}, &patch->surface);
}

/* Does the curve end where it begins, but for rounding, so that either way fits? */
static bool is_closed(const struct nurbs_curve *c)
{
    struct vec3 p = trim_order_end(c, false), q = trim_order_end(c, true);
    struct vec3 middle = nurbs_curve_point(c, c->t.from + (c->t.to - c->t.from) / 2);
    return vec_distance(p, q) <= ONE_PLACE * vec_distance(p, middle);
}

bool trim_order_backwards(const struct patch *patch, const struct patch_loop *loop, size_t k,
                          struct vec3 at)
{
    struct vec3 first = trim_order_end(&loop->item[k], false),
                last = trim_order_end(&loop->item[k], true);
    if (loop->directed || is_closed(&loop->item[k]))
        return false;
    if (k > 0)
        return loop_distance2(patch, loop, at, last) < loop_distance2(patch, loop, at, first);
    if (loop->n == 1)
        return false;
    struct vec3 p = trim_order_end(&loop->item[1], false), q = trim_order_end(&loop->item[1], true);
    return fmin(loop_distance2(patch, loop, first, p), loop_distance2(patch, loop, first, q)) <
           fmin(loop_distance2(patch, loop, last, p), loop_distance2(patch, loop, last, q));
}

/* The corners of a loop as it runs: where it begins, and where each curve ends. */
static struct vec3 *corners_of(const struct patch *patch, const struct patch_loop *loop)
{
    struct vec3 *corner = mem_alloc(loop->n + 1, sizeof *corner);
    corner[0] = trim_order_end(&loop->item[0], trim_order_backwards(patch, loop, 0, corner[0]));
    for (size_t k = 0; k < loop->n; k++)
        corner[k + 1] =
            trim_order_end(&loop->item[k], !trim_order_backwards(patch, loop, k, corner[k]));
    return corner;
}

/* Does what begins at corner i end at corner k, on a way of some length? */
static bool is_round(const struct patch_loop *loop, const struct vec3 *corner, size_t i, size_t k)
{
    double length = 0;
    for (size_t m = i; m < k; m++) {
        const struct nurbs_axis *t = &loop->item[m].t;
        struct vec3 middle = nurbs_curve_point(&loop->item[m], t->from + (t->to - t->from) / 2);
        length += vec_distance(corner[m], middle) + vec_distance(middle, corner[m + 1]);
    }
    return length > 0 && vec_distance(corner[i], corner[k]) <= ONE_PLACE * length;
}

static struct nurbs_curve copy_of(const struct nurbs_curve *c)
{
    struct nurbs_curve copy = *c;
    size_t knots = c->t.poles + (size_t)c->t.degree + 1;
    copy.t.knot = mem_alloc(knots, sizeof *copy.t.knot);
    copy.pole = mem_alloc(c->t.poles, sizeof *copy.pole);
    memcpy(copy.t.knot, c->t.knot, knots * sizeof *copy.t.knot);
    memcpy(copy.pole, c->pole, c->t.poles * sizeof *copy.pole);
    return copy;
}

static void turn_part(const struct patch_loop *loop, size_t i, size_t k, struct patch_loop *turned)
{
    *turned = (struct patch_loop){.space = true, .rough = loop->rough};
    for (size_t m = 0; m < k; m++)
        *array_push(turned) = copy_of(&loop->item[m < i ? m : i + k - 1 - m]);
    for (size_t m = i; m < k; m++)
        nurbs_curve_reverse(&turned->item[m]);
    for (size_t m = k; m < loop->n; m++)
        *array_push(turned) = copy_of(&loop->item[m]);
}

bool trim_order_turned(const struct patch *patch, const struct patch_loop *loop, size_t which,
                       struct patch_loop *turned)
{
    bool found = false;
    if (!loop->space || loop->directed || loop->n < 2)
        return false;
    struct vec3 *corner = corners_of(patch, loop);
    for (size_t i = 0; i < loop->n && !found; i++)
        for (size_t k = i + 1; k <= loop->n && !found; k++) {
            if (k - i == loop->n || !is_round(loop, corner, i, k))
                continue;
            found = which-- == 0;
            if (found)
                turn_part(loop, i, k, turned);
        }
    free(corner);
    return found;
}
