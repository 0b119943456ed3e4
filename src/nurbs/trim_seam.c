/* trim_seam - see trim_steps.h: loops moved into the range of a surface that closes on itself, and
 * split at its seam. */
#include <stdlib.h>

#include "base/array.h"
#include "trim_steps.h"

/* The part of a polygon above the limit (side 1) or below it (-1): Sutherland and Hodgman 1974. */
static void clip_loop(struct uvs *loop, bool u, double limit, double side)
{
    struct uvs kept = {0};
    for (size_t i = 0; i < loop->n; i++) {
        struct uv a = loop->item[i], b = loop->item[(i + 1) % loop->n];
        double x = side * (trim_coordinate(a, u) - limit),
               y = side * (trim_coordinate(b, u) - limit);
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

/* Appends a loop of an area, else frees it. */
static void append_loop(struct uvs *loop, struct uv_polygon *to)
{
    if (loop->n >= 3)
        *array_push(to) = *loop;
    else
        array_free(loop);
}

/* The loop in the range of one parameter, as often as it reaches into it; takes it over. */
static void wrap_loop(const struct pullback *s, struct uvs *loop, bool u, struct uv_polygon *to)
{
    const struct nurbs_axis *a = trim_axis(s, u);
    double low = HUGE_VAL, high = -HUGE_VAL, width = a->to - a->from;
    for (size_t i = 0; i < loop->n; i++) {
        low = fmin(low, trim_coordinate(loop->item[i], u));
        high = fmax(high, trim_coordinate(loop->item[i], u));
    }
    double first = floor((low - a->from) / width + TRIM_ROUNDING);
    double last = ceil((high - a->from) / width - TRIM_ROUNDING) - 1;
    if (!(u ? s->closed_u : s->closed_v) || !(last >= first) || last - first > 2) {
        append_loop(loop, to);
        return;
    }
    for (double k = first; k <= last; k++) {
        struct uvs copy = {0};
        for (size_t i = 0; i < loop->n; i++)
            *array_push(&copy) = trim_moved(loop->item[i], u, -k * width);
        if (last > first) {
            clip_loop(&copy, u, a->from, 1);
            clip_loop(&copy, u, a->to, -1);
        }
        append_loop(&copy, to);
    }
    array_free(loop);
}

/* Lets a loop that goes round begin, and end, where it crosses the seam. */
static void begin_at_seam(const struct pullback *s, struct uvs *loop, bool u, int rounds)
{
    const struct nurbs_axis *a = trim_axis(s, u);
    struct uvs turned = {0};
    size_t i = 0;
    double k = 0, wide = trim_width(a);
    for (; i + 1 < loop->n; i++) {
        double x = (trim_coordinate(loop->item[i], u) - a->from) / wide;
        double y = (trim_coordinate(loop->item[i + 1], u) - a->from) / wide;
        k = rounds > 0 ? floor(y) : ceil(y);
        if (rounds > 0 ? x < k && y >= k : x > k && y <= k)
            break;
    }
    if (i + 1 >= loop->n)
        return;
    struct uv p = loop->item[i], q = loop->item[i + 1];
    double limit = a->from + k * wide;
    double t = (limit - trim_coordinate(p, u)) / (trim_coordinate(q, u) - trim_coordinate(p, u));
    struct uv first = trim_between(p, q, t);
    *(u ? &first.u : &first.v) = limit;
    *array_push(&turned) = first;
    for (size_t m = i + 1; m < loop->n; m++)
        *array_push(&turned) = loop->item[m];
    for (size_t m = 1; m <= i; m++)
        *array_push(&turned) = trim_moved(loop->item[m], u, rounds * wide);
    *array_push(&turned) = trim_moved(first, u, rounds * wide);
    array_free(loop);
    *loop = turned;
}

/* Closes a loop that goes round over one of the ends of the other parameter.  One that is alone and
 * runs along that end, so that nothing is between them, is closed over the other end. */
static void close_round(const struct pullback *s, struct uvs *loop, bool u, bool high, bool alone)
{
    const struct nurbs_axis *other = trim_axis(s, !u);
    double range = trim_width(trim_axis(s, u)) * trim_width(other);
    size_t n = loop->n;
    for (int side = 0; side < 2; side++) {
        double end = high == (side == 0) ? other->to : other->from;
        struct uv first = loop->item[0], last = loop->item[n - 1];
        *(u ? &first.v : &first.u) = end;
        *(u ? &last.v : &last.u) = end;
        loop->n = n;
        *array_push(loop) = last;
        *array_push(loop) = first;
        if (!alone || fabs(uv_loop_area(loop)) > TRIM_ROUNDING * range)
            return;
    }
}

static bool is_same_place(const struct pullback *s, struct uv a, struct uv b)
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
            round[u] += trim_rounds(s, &from->item[i], u == 1) != 0;
    for (size_t i = 0; i < from->n; i++) {
        struct uvs loop = {0};
        struct uv_polygon once = {0};
        int n[2] = {trim_rounds(s, &from->item[i], false), trim_rounds(s, &from->item[i], true)};
        if (abs(n[0]) + abs(n[1]) > 1 || trim_too_large(s, &from->item[i])) {
            to->lost++;
            continue;
        }
        for (size_t k = 0; k < from->item[i].n; k++)
            *array_push(&loop) = from->item[i].item[k];
        bool u = n[1] != 0, is_round = n[0] != 0 || u;
        while (!is_round && loop.n > 1 && is_same_place(s, loop.item[0], loop.item[loop.n - 1]))
            loop.n--;
        /* The left of a loop along u is at higher v, of one along v at lower u. */
        if (is_round) {
            begin_at_seam(s, &loop, u, n[u]);
            bool high = round[u] % 2 == 0 || (n[u] > 0) == u;
            close_round(s, &loop, u, high, round[u] == 1);
        }
        wrap_loop(s, &loop, true, &once);
        for (size_t k = 0; k < once.n; k++)
            wrap_loop(s, &once.item[k], false, to);
        array_free(&once);
    }
}
