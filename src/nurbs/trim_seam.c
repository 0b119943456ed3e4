/* trim_seam - see trim_seam.h. */
#include "trim_seam.h"

#include <stdlib.h>

#include "base/array.h"

/* Of the range: what is rounding. */
static const double NEAR = 1e-6;

static double mesh_for_rows_of(struct uv at, bool u)
{
    return u ? at.u : at.v;
}

static struct uv moved(struct uv at, bool u, double by)
{
    return u ? (struct uv){at.u + by, at.v} : (struct uv){at.u, at.v + by};
}

static const struct nurbs_axis *axis_of(const struct pullback *s, bool u)
{
    return u ? &s->surface->u : &s->surface->v;
}

/* How often a loop goes round before it comes back to its start. */
static int rounds(const struct pullback *s, const struct uvs *loop, bool u)
{
    const struct nurbs_axis *a = axis_of(s, u);
    if (!(u ? s->closed_u : s->closed_v) || loop->n < 2)
        return 0;
    double way = mesh_for_rows_of(loop->item[loop->n - 1], u) - mesh_for_rows_of(loop->item[0], u);
    return (int)floor(way / (a->to - a->from) + 0.5);
}

/* What of a polygon is above the limit (side 1) or below it (-1): Sutherland and Hodgman 1974. */
static void clip(struct uvs *loop, bool u, double limit, double side)
{
    struct uvs kept = {0};
    for (size_t i = 0; i < loop->n; i++) {
        struct uv a = loop->item[i], b = loop->item[(i + 1) % loop->n];
        double x = side * (mesh_for_rows_of(a, u) - limit),
               y = side * (mesh_for_rows_of(b, u) - limit);
        if (x >= 0)
            *array_push(&kept) = a;
        if ((x > 0 && y < 0) || (x < 0 && y > 0)) {
            double t = x / (x - y);
            struct uv at = {a.u + t * (b.u - a.u), a.v + t * (b.v - a.v)};
            *(u ? &at.u : &at.v) = limit;
            *array_push(&kept) = at;
        }
    }
    array_free(loop);
    *loop = kept;
}

static void put(struct uvs *loop, struct uv_polygon *to)
{
    if (loop->n >= 3)
        *array_push(to) = *loop;
    else
        array_free(loop);
}

/* The loop in the range of one parameter, as often as it reaches into it; takes it over. */
static void wrap(const struct pullback *s, struct uvs *loop, bool u, struct uv_polygon *to)
{
    const struct nurbs_axis *a = axis_of(s, u);
    double low = HUGE_VAL, high = -HUGE_VAL, width = a->to - a->from;
    for (size_t i = 0; i < loop->n; i++) {
        low = fmin(low, mesh_for_rows_of(loop->item[i], u));
        high = fmax(high, mesh_for_rows_of(loop->item[i], u));
    }
    double first = floor((low - a->from) / width + NEAR);
    double last = ceil((high - a->from) / width - NEAR) - 1;
    if (!(u ? s->closed_u : s->closed_v) || !(last >= first) || last - first > 2) {
        put(loop, to);
        return;
    }
    for (double k = first; k <= last; k++) {
        struct uvs copy = {0};
        for (size_t i = 0; i < loop->n; i++)
            *array_push(&copy) = moved(loop->item[i], u, -k * width);
        if (last > first) {
            clip(&copy, u, a->from, 1);
            clip(&copy, u, a->to, -1);
        }
        put(&copy, to);
    }
    array_free(loop);
}

/* A loop that goes round, closed over one of the ends of the other parameter. */
static void close_round(const struct pullback *s, struct uvs *loop, bool u, bool high)
{
    const struct nurbs_axis *other = axis_of(s, !u);
    double end = high ? other->to : other->from;
    struct uv first = loop->item[0], last = loop->item[loop->n - 1];
    *(u ? &first.v : &first.u) = end;
    *(u ? &last.v : &last.u) = end;
    *array_push(loop) = last;
    *array_push(loop) = first;
}

static bool same(const struct pullback *s, struct uv a, struct uv b)
{
    double u = (a.u - b.u) / (s->surface->u.to - s->surface->u.from);
    double v = (a.v - b.v) / (s->surface->v.to - s->surface->v.from);
    return u * u + v * v <= 1e-18;
}

void trim_seam(const struct pullback *s, const struct uv_polygon *from, struct uv_polygon *to)
{
    size_t round[2] = {0};
    *to = (struct uv_polygon){0};
    for (size_t i = 0; i < from->n; i++)
        for (int u = 0; u < 2; u++)
            round[u] += rounds(s, &from->item[i], u == 1) != 0;
    for (size_t i = 0; i < from->n; i++) {
        struct uvs loop = {0};
        struct uv_polygon once = {0};
        int n[2] = {rounds(s, &from->item[i], false), rounds(s, &from->item[i], true)};
        if (abs(n[0]) + abs(n[1]) > 1) {
            to->lost++;
            continue;
        }
        for (size_t k = 0; k < from->item[i].n; k++)
            *array_push(&loop) = from->item[i].item[k];
        bool u = n[1] != 0, is_round = n[0] != 0 || u;
        while (!is_round && loop.n > 1 && same(s, loop.item[0], loop.item[loop.n - 1]))
            loop.n--;
        /* What is on the left of the way along u lies at higher v, along v at lower u. */
        if (is_round)
            close_round(s, &loop, u, round[u] % 2 == 0 || (n[u] > 0) == u);
        wrap(s, &loop, true, &once);
        for (size_t k = 0; k < once.n; k++)
            wrap(s, &once.item[k], false, to);
        array_free(&once);
    }
}
