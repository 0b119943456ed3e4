/* trim_crossings - see trim_crossings.h. */
#include "trim_crossings.h"

#include <stdlib.h>

#include "base/array.h"
#include "trim_loops.h"

/* A side of a loop, by its lowest u. */
struct side {
    double low, high, low_v, high_v;
    size_t i;
};

static int compare_sides(const void *p, const void *q)
{
    const struct side *a = p, *b = q;
    if (a->low < b->low || a->low > b->low)
        return a->low < b->low ? -1 : 1;
    return (a->i > b->i) - (a->i < b->i);
}

/* Twice the area on the left of a triangle. */
static double turn(struct uv a, struct uv b, struct uv c)
{
    return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

/* Is the place p within rounding of q, for sides as long as those from p to a and from q to c? */
static bool is_corner(struct uv p, struct uv q, struct uv a, struct uv c)
{
    const double rounding = 1e-9;
    double size = fabs(a.u - p.u) + fabs(a.v - p.v) + fabs(c.u - q.u) + fabs(c.v - q.v);
    return fabs(p.u - q.u) + fabs(p.v - q.v) <= rounding * size;
}

/* Does the way from `from` by p to `to` part the two places, which are not on it? */
static bool parts(struct uv from, struct uv p, struct uv to, struct uv c, struct uv d)
{
    bool left = turn(from, p, to) > 0;
    bool is_c = left ? turn(from, p, c) > 0 && turn(p, to, c) > 0
                     : turn(from, p, c) > 0 || turn(p, to, c) > 0;
    bool is_d = left ? turn(from, p, d) > 0 && turn(p, to, d) > 0
                     : turn(from, p, d) > 0 || turn(p, to, d) > 0;
    return is_c != is_d;
}

/* Twice the area of the corners from `from` to `to` of a loop on the surface by their length, mm:
 * about the width of what is narrow. */
static double width_on(const struct nurbs *s, const struct uvs *loop, size_t from, size_t to,
                       struct uv at)
{
    struct vec3 first = nurbs_point(s, at), last = first, area = {0, 0, 0};
    double length = 0;
    for (size_t m = from; m <= to; m++) {
        struct vec3 next = nurbs_point(s, loop->item[m % loop->n]);
        length += vec_distance(last, next);
        area = vec_add(area, vec_cross(vec_sub(last, first), vec_sub(next, first)));
        last = next;
    }
    length += vec_distance(last, first);
    return length > 0 ? 2 * vec_length(area) / length : 0;
}

/* Where the sides that begin at i and k, i before k, cross but for their corners. */
static bool is_crossing(const struct uvs *loop, size_t i, size_t k, struct uv *at)
{
    struct uv a = loop->item[i], b = loop->item[(i + 1) % loop->n];
    struct uv c = loop->item[k], d = loop->item[(k + 1) % loop->n];
    double ta = turn(c, d, a), tb = turn(c, d, b);
    if (k - i < 2 || k - i + 1 >= loop->n || is_corner(b, d, a, c) || is_corner(a, c, b, d) ||
        is_corner(a, d, b, c) || is_corner(b, c, a, d))
        return false;
    /* A corner on the other side counts as left of it: curves may cross at their corners. */
    if ((ta >= 0) == (tb >= 0) || (turn(a, b, c) >= 0) == (turn(a, b, d) >= 0))
        return false;
    double t = ta / (ta - tb);
    *at = (struct uv){a.u + t * (b.u - a.u), a.v + t * (b.v - a.v)};
    return true;
}

/* Do the sides from a corner p to the two places lie on each other? */
static bool is_along(struct uv p, struct uv to, struct uv place)
{
    const double rounding = 1e-9;
    double u = to.u - p.u, v = to.v - p.v, other_u = place.u - p.u, other_v = place.v - p.v;
    return u * other_u + v * other_v > 0 &&
           fabs(turn(p, to, place)) <= rounding * hypot(u, v) * hypot(other_u, other_v);
}

/* Do the ways through one corner, by the sides that begin at i and k, cross there?  Where a loop
 * runs along a seam and comes back on it, they touch. */
static bool is_corner_crossed(const struct uvs *loop, size_t i, size_t k)
{
    struct uv a = loop->item[i], b = loop->item[(i + 1) % loop->n];
    struct uv c = loop->item[k], d = loop->item[(k + 1) % loop->n];
    struct uv to = loop->item[(i + 2) % loop->n], end = loop->item[(k + 2) % loop->n];
    return k - i > 1 && k - i + 1 < loop->n && is_corner(b, d, a, c) && !is_along(b, a, c) &&
           !is_along(b, a, end) && !is_along(b, to, c) && !is_along(b, to, end) &&
           parts(a, b, to, c, end);
}

/* A loop with its sides in order, and twice the areas that those up to each corner have about the
 * first one: what lies between two of them costs no walk. */
struct crossed {
    const struct uvs *loop;
    struct side *side;
    double *about;
};

/* Of the two parts of a loop that crosses itself: is the one from i to k the smaller, and does it
 * count, or is it as narrow as the tolerance? */
static bool is_part(const struct crossed *c, const struct nurbs *s, double tolerance, size_t i,
                    size_t k, struct uv at, bool *smaller)
{
    const double least = 1e-3;
    const struct uvs *loop = c->loop;
    double area = (c->about[k] - c->about[i + 1] + turn(loop->item[0], loop->item[k], at) +
                   turn(loop->item[0], at, loop->item[i + 1])) /
                  2;
    double rest = c->about[loop->n] / 2 - area;
    *smaller = fabs(area) < fabs(rest);
    return fmin(fabs(area), fabs(rest)) > least * fmax(fabs(area), fabs(rest)) &&
           (*smaller ? width_on(s, loop, i + 1, k, at)
                     : width_on(s, loop, k + 1, i + loop->n, at)) > tolerance;
}

static struct crossed crossed_make(const struct uvs *loop)
{
    struct crossed c = {loop, mem_alloc(loop->n + 1, sizeof *c.side),
                        mem_alloc(loop->n + 1, sizeof *c.about)};
    c.about[0] = 0;
    for (size_t i = 0; i < loop->n; i++) {
        struct uv a = loop->item[i], b = loop->item[(i + 1) % loop->n];
        c.side[i] =
            (struct side){fmin(a.u, b.u), fmax(a.u, b.u), fmin(a.v, b.v), fmax(a.v, b.v), i};
        c.about[i + 1] = c.about[i] + turn(loop->item[0], a, b);
    }
    if (loop->n > 0)
        qsort(c.side, loop->n, sizeof *c.side, compare_sides);
    return c;
}

static void crossed_free(struct crossed *c)
{
    free(c->side);
    free(c->about);
}

size_t trim_crossings(const struct uvs *loop, const struct nurbs *s, double tolerance)
{
    size_t count = 0;
    struct crossed c = crossed_make(loop);
    const struct side *side = c.side;
    for (size_t i = 0; i < loop->n; i++)
        for (size_t m = i + 1; m < loop->n && side[m].low <= side[i].high; m++) {
            size_t p = side[i].i, q = side[m].i, low = p < q ? p : q, high = p < q ? q : p;
            struct uv at;
            bool smaller;
            if (side[i].high_v < side[m].low_v || side[m].high_v < side[i].low_v)
                continue;
            count += is_corner_crossed(loop, low, high) ||
                     (is_crossing(loop, low, high, &at) &&
                      is_part(&c, s, tolerance, low, high, at, &smaller));
        }
    crossed_free(&c);
    return count;
}

bool trim_crossings_drop(const struct nurbs *s, double tolerance, struct uvs *loop)
{
    struct crossed c = crossed_make(loop);
    const struct side *side = c.side;
    size_t low = 0, high = 0;
    struct uv at = {0, 0};
    bool found = false, smaller = false;
    for (size_t i = 0; i < loop->n && !found; i++)
        for (size_t m = i + 1; m < loop->n && side[m].low <= side[i].high && !found; m++) {
            size_t p = side[i].i, q = side[m].i;
            low = p < q ? p : q;
            high = p < q ? q : p;
            if (side[i].high_v < side[m].low_v || side[m].high_v < side[i].low_v)
                continue;
            found = is_crossing(loop, low, high, &at) &&
                    !is_part(&c, s, tolerance, low, high, at, &smaller);
        }
    crossed_free(&c);
    if (!found)
        return false;
    struct uvs rest = {0};
    for (size_t m = 0; m < loop->n; m++) {
        bool between = m > low && m <= high;
        if (m == (smaller ? low + 1 : high + 1) % loop->n)
            *array_push(&rest) = at;
        if (between != smaller)
            *array_push(&rest) = loop->item[m];
    }
    array_free(loop);
    *loop = rest;
    return true;
}
