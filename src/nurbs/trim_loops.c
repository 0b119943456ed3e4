/* trim_loops - see trim_loops.h. */
#include "trim_loops.h"

#include <stdlib.h>

#include "base/array.h"
#include "trim_crossings.h"
#include "trim_gap.h"
#include "trim_steps.h"
#include "trim_tidy.h"
#include "trim_told.h"

enum { ASKED = 7, SEEKS = 64, PARTS_MAX = 8 };

/* By the width of the range: what is on a seam, and how far along it a loop runs there. */
static const double SEAM_NEAR = 1e-4, SEAM_LONG = 0.05;

/* Does a loop run along a seam, forth and, a turn further on, back?  What it bounds is on both
 * sides of the seam, and so between: OpenCASCADE writes some such loops of tori the wrong way
 * round. */
static bool is_seamed(const struct pullback *on, const struct uvs *loop)
{
    if (trim_rounds(on, loop, true) != 0 || trim_rounds(on, loop, false) != 0)
        return false;
    for (int u = 0; u < 2; u++) {
        double low = HUGE_VAL, high = -HUGE_VAL, wide = trim_width(trim_axis(on, u == 1));
        for (size_t i = 0; i < loop->n; i++) {
            low = fmin(low, trim_coordinate(loop->item[i], u == 1));
            high = fmax(high, trim_coordinate(loop->item[i], u == 1));
        }
        if ((u ? on->closed_u : on->closed_v) && fabs(high - low - wide) <= TRIM_ROUNDING * wide)
            return true;
    }
    return false;
}

/* Has the surface no border: does it close on itself, or end in poles, both ways? */
static bool is_borderless(const struct pullback *on)
{
    const bool *pole = on->is_pole;
    bool u = on->closed_u || (pole[PULLBACK_U_LOW] && pole[PULLBACK_U_HIGH]);
    bool v = on->closed_v || (pole[PULLBACK_V_LOW] && pole[PULLBACK_V_HIGH]);
    return u && v;
}

/* Are the directed loops all holes?  Then the largest polygon runs clockwise, and no loop (`raw`)
 * runs along the seam of the surface, which has no border that could bound the rest. */
static bool are_holes(const struct patch *patch, const struct pullback *on,
                      const struct uv_polygon *raw, const struct uv_polygon *loops)
{
    double most = 0;
    for (size_t i = 0; i < patch->loop.n; i++)
        if (!patch->loop.item[i].directed || is_seamed(on, &raw->item[i]))
            return false;
    for (size_t i = 0; i < loops->n; i++) {
        double area = uv_loop_area(&loops->item[i]);
        most = fabs(area) > fabs(most) ? area : most;
    }
    return most < 0;
}

/* Does a loop run along seams and back again, so that it bounds nothing? */
static bool is_slit(const struct pullback *on, const struct uvs *loop, double tolerance)
{
    struct uv_polygon first = {.n = 1}, outer;
    struct uvs copy = *loop;
    const struct nurbs *s = on->surface;
    double area = 0;
    if (trim_rounds(on, loop, true) != 0 || trim_rounds(on, loop, false) != 0)
        return false;
    first.item = &copy;
    trim_seam(on, &first, &outer);
    for (size_t i = 0; i < outer.n; i++) {
        trim_tidy(s, tolerance, &outer.item[i]);
        area += outer.item[i].n < 3 ? 0 : fabs(uv_loop_area(&outer.item[i]));
    }
    uv_polygon_free(&outer);
    return loop->n > 0 && area <= TRIM_ROUNDING * trim_width(&s->u) * trim_width(&s->v);
}

/* Does the outer loop of a surface without borders go round the others on its other side, or is it
 * a slit along its seam?  None of
 * them is on its inside in the range then, and on that side of it they bound what counts. */
static bool is_turned_out(const struct patch *patch, const struct pullback *on,
                          const struct uv_polygon *raw, double tolerance)
{
    struct uv_polygon first = {.n = 1, .item = raw->item}, outer;
    const struct nurbs_axis *u = &on->surface->u, *v = &on->surface->v;
    size_t inside = 0, asked = 0;
    if (!patch->outer || patch->told.n == patch->loop.n || raw->n < 1)
        return false;
    if (is_slit(on, &raw->item[0], tolerance))
        return true;
    for (size_t i = 0; i < raw->n; i++)
        if (raw->item[i].n < 3 || patch->loop.item[i].directed ||
            trim_rounds(on, &raw->item[i], true) != 0 || trim_rounds(on, &raw->item[i], false) != 0)
            return false;
    trim_seam(on, &first, &outer);
    for (size_t i = 1; i < raw->n; i++)
        for (size_t k = 0; k < ASKED; k++, asked++) {
            struct uv at = raw->item[i].item[k * raw->item[i].n / ASKED];
            at.u -= on->closed_u ? trim_width(u) * floor((at.u - u->from) / trim_width(u)) : 0;
            at.v -= on->closed_v ? trim_width(v) * floor((at.v - v->from) / trim_width(v)) : 0;
            inside += uv_polygon_inside(&outer, false, at);
        }
    uv_polygon_free(&outer);
    return raw->n > 1 && 2 * inside < asked;
}

/* Does a slit that the only loop of a surface without borders has to a pole lie on the other side
 * of it?  It is drawn through what counts. */
static bool is_slit_outside(const struct patch *patch, const struct trim_follower *f,
                            const struct uv_polygon *loops)
{
    const struct nurbs_axis *u = &f->on.surface->u, *v = &f->on.surface->v;
    struct uv at = f->slit_at;
    if (!f->slit || patch->loop.n != 1 || patch->loop.item[0].directed ||
        patch->told.n == patch->loop.n)
        return false;
    at.u -= f->on.closed_u ? trim_width(u) * floor((at.u - u->from) / trim_width(u)) : 0;
    at.v -= f->on.closed_v ? trim_width(v) * floor((at.v - v->from) / trim_width(v)) : 0;
    return !uv_polygon_inside(loops, loops->open, at);
}

/* Does a loop cross a seam, or go round along a parameter, so that it bounds nothing in the
 * range? */
static bool is_across(const struct pullback *on, const struct uvs *loop, bool u)
{
    const struct nurbs_axis *a = trim_axis(on, u);
    double low = HUGE_VAL, high = -HUGE_VAL;
    if (!(u ? on->closed_u : on->closed_v))
        return false;
    for (size_t i = 0; i < loop->n; i++) {
        low = fmin(low, trim_coordinate(loop->item[i], u));
        high = fmax(high, trim_coordinate(loop->item[i], u));
    }
    double first = floor((low - a->from) / trim_width(a) + TRIM_ROUNDING);
    double last = ceil((high - a->from) / trim_width(a) - TRIM_ROUNDING) - 1;
    return trim_rounds(on, loop, u) != 0 || last > first;
}

/* Is the seam a part of a loop? */
static bool is_along_seam(const struct pullback *on, const struct uvs *loop, bool u)
{
    const struct nurbs_axis *a = trim_axis(on, u);
    double along = 0;
    if (!(u ? on->closed_u : on->closed_v))
        return false;
    for (size_t i = 0; i < loop->n; i++) {
        struct uv p = loop->item[i], q = loop->item[(i + 1) % loop->n];
        double x = (trim_coordinate(p, u) - a->from) / trim_width(a);
        double y = (trim_coordinate(q, u) - a->from) / trim_width(a), k = floor(x + 0.5);
        if (fabs(x - k) <= SEAM_NEAR && fabs(y - k) <= SEAM_NEAR)
            along += fabs(trim_coordinate(q, !u) - trim_coordinate(p, !u));
    }
    return along > SEAM_LONG * trim_width(trim_axis(on, !u));
}

/* Which side of its only loop a surface without borders is on: where the loop is in the range the
 * part that it bounds there; where a seam or a slit is a part of it what these are drawn
 * through. */
static enum patch_side side_of(const struct patch *patch, const struct trim_follower *f,
                               const struct uv_polygon *raw)
{
    const struct pullback *on = &f->on;
    if (!is_borderless(on) || patch->loop.n != 1 || patch->told.n == 1 || f->slit_seen ||
        patch->loop.item[0].directed || !patch->loop.item[0].space)
        return PATCH_SIDE_TOLD;
    const struct uvs *loop = &raw->item[0];
    bool round = trim_rounds(on, loop, true) != 0 || trim_rounds(on, loop, false) != 0;
    if ((patch->open && !round) || (!is_across(on, loop, true) && !is_across(on, loop, false)) ||
        is_along_seam(on, loop, true) || is_along_seam(on, loop, false))
        return PATCH_SIDE_TOLD;
    if (on->closed_u && on->closed_v)
        return PATCH_SIDE_UNKNOWN;
    return round ? PATCH_SIDE_LEFT : PATCH_SIDE_WITHIN;
}

static void find_loops(const struct patch *patch, double tolerance, bool bent,
                       struct uv_polygon *loops)
{
    struct uv_polygon raw = {0};
    double gap = 0;
    struct vec3 at = {0, 0, 0}, gap_at = at;
    struct trim_follower f = {
        .on = pullback_new(&patch->surface), .tolerance = tolerance, .bent = bent, .seeks = SEEKS};
    for (size_t i = 0; i < patch->loop.n; i++) {
        struct uvs loop = {0};
        trim_follow(patch, &patch->loop.item[i], &f, &loop);
        *array_push(&raw) = loop;
        double open = trim_gap(patch, &patch->loop.item[i], &f.on, &loop, &at);
        gap_at = open > gap ? at : gap_at;
        gap = fmax(gap, open);
    }
    trim_seam(&f.on, &raw, loops);
    for (size_t i = 0; i < loops->n; i++) {
        trim_tidy(&patch->surface, tolerance, &loops->item[i]);
        for (int k = 0;
             k < PARTS_MAX && trim_crossings_drop(&patch->surface, tolerance, &loops->item[i]);)
            k++;
    }
    loops->off = f.off;
    loops->gap = gap;
    loops->gap_at = gap_at;
    loops->side = side_of(patch, &f, &raw);
    loops->open = is_borderless(&f.on) && (are_holes(patch, &f.on, &raw, loops) ||
                                           is_turned_out(patch, &f.on, &raw, tolerance));
    if (is_borderless(&f.on) && is_slit_outside(patch, &f, loops))
        loops->open = !loops->open;
    /* On what closes a slit to a border may be lost as a spur, and with it what is outside. */
    if (!loops->open && (f.on.closed_u || f.on.closed_v))
        loops->open = trim_told_outside(patch, loops);
    uv_polygon_free(&raw);
    pullback_free(&f.on);
}

void trim_loops(const struct patch *patch, double tolerance, struct uv_polygon *loops)
{
    find_loops(patch, tolerance, false, loops);
}

void trim_loops_bent(const struct patch *patch, double tolerance, struct uv_polygon *loops)
{
    find_loops(patch, tolerance, true, loops);
}
