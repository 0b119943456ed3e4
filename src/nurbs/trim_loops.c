/* trim_loops - see trim_loops.h. */
#include "trim_loops.h"

#include <stdlib.h>

#include "base/array.h"
#include "pullback.h"
#include "trim_crossings.h"
#include "trim_order.h"
#include "trim_tidy.h"
#include "trim_told.h"

enum { ASKED = 7, DEPTH_MAX = 10, SPACE_PARTS = 8, SEEKS = 64, PARTS_MAX = 8, TURNED_TRIED = 16 };

/* How far from a pole, by a piece of a curve, its direction is still told; by the size of the
 * surface: how near to a pole a curve runs through it; by the width of the range: what is
 * rounding, and what is one way to a pole and back. */
static const double POLE_STEP = 1e-3, POLE_SLIT = 1e-3, POLE_NEAR = 1e-6, POLE = 1e-9,
                    ROUNDING = 1e-6;

/* By the width of the range: what is on a seam, and how far along it a loop runs there. */
static const double SEAM_NEAR = 1e-4, SEAM_LONG = 0.05;

/* A curve in the parameters or in space that is being followed on the surface. */
struct follower {
    struct pullback on;
    const struct nurbs_curve *curve;
    double tolerance;
    bool space, directed;
    bool bent;         /* corners so that what the chords bound is what the curve bounds */
    double off;        /* the farthest that the curve was off the surface */
    struct uv slit_at; /* beside that pole */
    bool slit;         /* a loop that is not directed went to a pole and back the same way ... */
    bool slit_seen;    /* some loop did */
    double pole_way;   /* ... and goes so many turns about it there instead */
    int seeks;         /* searches of the whole surface that may still fail */
    struct uvs *to;
};

static double width(const struct nurbs_axis *a)
{
    return a->to - a->from;
}

/* The curve's place; near the guess where the curve is in space, unless it is far from there. */
static struct uv uv_at(struct follower *f, double t, struct uv guess)
{
    struct vec3 p = nurbs_curve_point(f->curve, t);
    if (!f->space)
        return (struct uv){p.x, p.y};
    struct uv at = pullback_foot(&f->on, p, guess);
    double off = vec_distance(p, pullback_point(&f->on, at));
    if (off > f->tolerance / 2 && f->seeks > 0) {
        struct uv other = pullback_seek_near(&f->on, p, guess);
        double least = vec_distance(p, pullback_point(&f->on, other));
        f->seeks -= !(least < off / 2);
        at = least < off / 2 ? other : at;
        off = fmin(off, least);
    }
    f->off = fmax(f->off, off);
    return at;
}

static struct uv uv_between(struct uv a, struct uv b, double t)
{
    return (struct uv){a.u + (b.u - a.u) * t, a.v + (b.v - a.v) * t};
}

/* Is the chord in the parameters, and on the surface, near the curve at three places (`at`)? */
static bool is_near(struct follower *f, double t0, struct uv a, double t1, struct uv b,
                    struct uv at[3])
{
    struct vec3 p = pullback_point(&f->on, a), q = pullback_point(&f->on, b);
    for (int i = 1; i < 4; i++) {
        struct uv m = uv_between(a, b, i / 4.0);
        at[i - 1] = uv_at(f, t0 + (t1 - t0) * i / 4, m);
        struct vec3 on = pullback_point(&f->on, at[i - 1]);
        if (vec_segment_distance(p, q, on) > f->tolerance ||
            vec_segment_distance(p, q, pullback_point(&f->on, m)) > f->tolerance)
            return false;
    }
    return true;
}

/* The corners of a chord and of the curve at its quarters, moved off the chord so much further that
 * chords through them bound what the curve does: the trapezoids of these offsets are off by what
 * Boole's rule says, for a parabola a fifteenth. */
static void bend_chord(struct follower *f, struct uv a, struct uv b, const struct uv at[3])
{
    static const double rule[3] = {64 / 45.0, 24 / 45.0, 64 / 45.0};
    double chords = 0, curve = 0;
    for (int i = 0; i < 3; i++) {
        double off = (b.u - a.u) * (at[i].v - a.v) - (b.v - a.v) * (at[i].u - a.u);
        chords += off;
        curve += rule[i] * off;
    }
    bool even = curve > 0.5 * chords && curve < 2 * chords;
    bool odd = curve < 0.5 * chords && curve > 2 * chords;
    double by = even || odd ? curve / chords : 1;
    *array_push(f->to) = a;
    for (int i = 0; i < 3; i++) {
        struct uv m = uv_between(a, b, (i + 1) / 4.0);
        *array_push(f->to) = uv_between(m, at[i], by);
    }
}

/* All points of the curve from t0 to t1 but the last. */
static void follow_span(struct follower *f, double t0, struct uv a, double t1, struct uv b,
                        int depth)
{
    struct uv at[3] = {a, a, a};
    bool near = depth < DEPTH_MAX && is_near(f, t0, a, t1, b, at);
    if (near && f->bent)
        bend_chord(f, a, b, at);
    else if (near || depth == DEPTH_MAX)
        *array_push(f->to) = a;
    if (near || depth == DEPTH_MAX)
        return;
    double middle = t0 + (t1 - t0) / 2;
    struct uv m = uv_at(f, middle, uv_between(a, b, 0.5));
    follow_span(f, t0, a, middle, m, depth + 1);
    follow_span(f, middle, m, t1, b, depth + 1);
}

/* The pole that the curve is at, or -1. */
static int pole_at(const struct follower *f, double t)
{
    return f->space ? pullback_pole(&f->on, nurbs_curve_point(f->curve, t), POLE_NEAR * f->on.size)
                    : -1;
}

/* The place on the side of a pole where a curve meets it at t, told by places of the curve nearer
 * and nearer to it, up to a step from it: so near, a search may end anywhere about the pole. */
static struct uv uv_on_pole(struct follower *f, int pole, double t, double step, struct uv guess)
{
    enum { FAR = 64, NEARER = 4 };
    const struct nurbs *s = f->on.surface;
    struct uv at = pullback_seek_near(&f->on, nurbs_curve_point(f->curve, t + FAR * step), guess);
    for (int i = FAR / NEARER; i >= 1; i /= NEARER)
        at = pullback_foot(&f->on, nurbs_curve_point(f->curve, t + i * step), at);
    switch (pole) {
    case PULLBACK_U_LOW:
        at.u = s->u.from;
        break;
    case PULLBACK_U_HIGH:
        at.u = s->u.to;
        break;
    case PULLBACK_V_LOW:
        at.v = s->v.from;
        break;
    default:
        at.v = s->v.to;
    }
    return at;
}

/* A little way from an end of the range into it. */
static double pole_inside(const struct nurbs_axis *a, double end)
{
    return end + POLE_STEP * (2 * end < a->from + a->to ? width(a) : -width(a));
}

/*
 * Where a loop goes on from a pole that it came to: by whole turns so that the side of the range in
 * between is one that bounds what is on the loop's left; by the shorter way where it is not
 * directed.
 */
static struct uv uv_past_pole(struct follower *f, int pole, struct uv from, struct uv to)
{
    bool along_u = pole == PULLBACK_V_LOW || pole == PULLBACK_V_HIGH;
    double sign = pole == PULLBACK_V_LOW || pole == PULLBACK_U_HIGH ? 1 : -1;
    double turn = along_u ? width(&f->on.surface->u) : width(&f->on.surface->v);
    double by = along_u ? to.u - from.u : to.v - from.v;
    if (!(along_u ? f->on.closed_u : f->on.closed_v))
        return to;
    if (f->directed) {
        by *= sign;
        by -= turn * floor(by / turn);
        by = sign * (by < ROUNDING * turn ? turn : by);
    } else {
        by -= turn * floor(by / turn + 0.5);
        if (fabs(by) < POLE_SLIT * turn) {
            f->slit = f->slit_seen = true;
            f->slit_at = (struct uv){along_u ? from.u : pole_inside(&f->on.surface->u, to.u),
                                     along_u ? pole_inside(&f->on.surface->v, to.v) : from.v};
            by += f->pole_way * turn;
        }
    }
    return along_u ? (struct uv){from.u + by, to.v} : (struct uv){to.u, from.v + by};
}

/* All points from t0 to t1, span by span, with the last one; a span that bends is split first.  The
 * curve runs through no pole in between.  `last` and `pole` are where the loop came to, and change;
 * pole -2: this is its beginning. */
static void follow_piece(struct follower *f, double t0, double t1, struct uv *last, int *pole)
{
    const struct nurbs_axis *t = &f->curve->t;
    size_t spans = t->poles - (size_t)t->degree;
    int first_pole = pole_at(f, t0), last_pole = pole_at(f, t1);
    bool backwards = t1 < t0;
    double step = POLE_STEP * (t1 - t0), least = POLE * fabs(t1 - t0); /* knots are rounded */
    struct uv a;
    if (first_pole < 0)
        a = uv_at(f, t0, *last);
    else
        a = uv_on_pole(f, first_pole, t0, step, *last);
    if (first_pole >= 0 && first_pole == *pole)
        a = uv_past_pole(f, first_pole, *last, a);
    for (size_t k = 0; k < spans; k++) {
        size_t i = (size_t)t->degree + (backwards ? spans - 1 - k : k);
        double low = fmax(t->knot[i], fmin(t0, t1)), high = fmin(t->knot[i + 1], fmax(t0, t1));
        double from = backwards ? high : low, across = backwards ? low - high : high - low;
        int parts = f->space ? SPACE_PARTS : t->degree > 1 ? 2 : 1;
        for (int p = 0; p < parts && high - low > least; p++) {
            double s0 = from + across * p / parts, s1 = from + across * (p + 1) / parts;
            bool end = p + 1 == parts && (backwards ? low - least <= t1 : high + least >= t1);
            struct uv b =
                end && last_pole >= 0 ? uv_on_pole(f, last_pole, t1, -step, a) : uv_at(f, s1, a);
            follow_span(f, s0, a, s1, b, 0);
            a = b;
        }
    }
    *array_push(f->to) = a;
    *last = a;
    *pole = last_pole;
}

/* The places where the curve runs through a pole between its ends, in its direction. */
static void poles_between(const struct follower *f, double t0, double t1, struct doubles *at)
{
    double least = 1e-6 * fabs(t1 - t0);
    for (int side = 0; side < 4 && f->space; side++) {
        if (!f->on.is_pole[side])
            continue;
        double t = nurbs_curve_foot(f->curve, f->on.pole[side]);
        size_t k = at->n;
        if (fabs(t - t0) < least || fabs(t - t1) < least || pole_at(f, t) != side)
            continue;
        array_push(at);
        for (; k > 0 && (at->item[k - 1] - t) * (t1 - t0) > 0; k--)
            at->item[k] = at->item[k - 1];
        at->item[k] = t;
    }
}

static void follow_curve(struct follower *f, bool backwards, struct uv *last, int *pole)
{
    const struct nurbs_axis *t = &f->curve->t;
    double t0 = backwards ? t->to : t->from, t1 = backwards ? t->from : t->to;
    struct doubles at = {0};
    poles_between(f, t0, t1, &at);
    for (size_t i = 0; i < at.n; i++) {
        follow_piece(f, t0, at.item[i], last, pole);
        t0 = at.item[i];
    }
    follow_piece(f, t0, t1, last, pole);
    array_free(&at);
}

/* Is the curve one point in space? */
static bool is_point(const struct nurbs_curve *c, double near)
{
    struct vec3 p = nurbs_curve_point(c, c->t.from);
    for (int i = 1; i <= 4; i++)
        if (vec_distance(p, nurbs_curve_point(c, c->t.from + width(&c->t) * i / 4)) > near)
            return false;
    return true;
}

/* All curves of a loop in order, without repeated points: from its first place to its last one,
 * which may be the first again a turn further on. */
static void follow_loop(const struct patch *patch, const struct patch_loop *loop,
                        struct follower *f, struct uvs *to)
{
    struct uvs all = {0};
    struct vec3 at = {0, 0, 0};
    struct uv last = {0, 0};
    int pole = -2, first_pole = -1;
    f->to = &all; // cppcheck-suppress autoVariables
    f->space = loop->space;
    f->directed = loop->directed;
    for (size_t k = 0; k < loop->n; k++) {
        bool backwards = trim_order_backwards(patch, loop, k, at);
        f->curve = &loop->item[k];
        at = trim_order_end(f->curve, !backwards);
        if (loop->space && loop->n > 1 && is_point(f->curve, POLE * f->on.size))
            continue;
        if (pole == -2) {
            first_pole = pole_at(f, backwards ? f->curve->t.to : f->curve->t.from);
            last = loop->space ? pullback_seek(&f->on, trim_order_end(f->curve, backwards)) : last;
        }
        follow_curve(f, backwards, &last, &pole);
    }
    if (all.n > 0 && pole >= 0 && pole == first_pole) {
        struct uv end = uv_past_pole(f, pole, last, all.item[0]);
        *array_push(&all) = end;
    }
    for (size_t i = 0; i < all.n; i++)
        if (to->n == 0 ||
            trim_order_square(to->item[to->n - 1], all.item[i], &patch->surface) > 1e-18)
            *array_push(to) = all.item[i];
    f->to = NULL;
    array_free(&all);
}

static double coordinate(struct uv at, bool u)
{
    return u ? at.u : at.v;
}

static struct uv uv_moved(struct uv at, bool u, double by)
{
    return u ? (struct uv){at.u + by, at.v} : (struct uv){at.u, at.v + by};
}

static const struct nurbs_axis *axis_of(const struct pullback *s, bool u)
{
    return u ? &s->surface->u : &s->surface->v;
}

/* How often a loop goes round before it comes back to its start. */
static int loop_rounds(const struct pullback *s, const struct uvs *loop, bool u)
{
    const struct nurbs_axis *a = axis_of(s, u);
    if (!(u ? s->closed_u : s->closed_v) || loop->n < 2)
        return 0;
    double along = coordinate(loop->item[loop->n - 1], u) - coordinate(loop->item[0], u);
    return (int)floor(along / (a->to - a->from) + 0.5);
}

static bool is_astray(const struct follower *f, const struct uvs *loop)
{
    return loop_rounds(&f->on, loop, true) != 0 || loop_rounds(&f->on, loop, false) != 0;
}

/* Does a loop that comes back bound more than all of a surface that closes both ways? */
static bool is_too_large(const struct pullback *s, const struct uvs *loop)
{
    double range = width(&s->surface->u) * width(&s->surface->v);
    return s->closed_u && s->closed_v && loop_rounds(s, loop, true) == 0 &&
           loop_rounds(s, loop, false) == 0 && fabs(uv_loop_area(loop)) > (1 + POLE_STEP) * range;
}

static bool is_wrong(const struct follower *f, const struct uvs *loop)
{
    return is_astray(f, loop) || is_too_large(&f->on, loop);
}

/* A loop that goes once round and has a slit to a pole as part of it, there and back: it goes round
 * the pole, too, and so comes back. */
static void turn_at_pole(const struct patch *patch, const struct patch_loop *loop,
                         struct follower *f, struct uvs *to)
{
    for (int way = -1; way <= 1 && is_astray(f, to); way += 2) {
        struct uvs other = {0};
        f->pole_way = way;
        follow_loop(patch, loop, f, &other);
        if (!is_astray(f, &other)) {
            struct uvs swap = *to;
            *to = other;
            other = swap;
            f->slit = false;
        }
        array_free(&other);
    }
    f->pole_way = 0;
}

/* A loop; one that is not directed and does not come back, or bounds more than there is, with one
 * of its parts turned round with which it does (trim_order.h). */
static void follow_any(const struct patch *patch, const struct patch_loop *loop, struct follower *f,
                       struct uvs *to)
{
    struct patch_loop turned;
    f->slit = false;
    f->pole_way = 0;
    follow_loop(patch, loop, f, to);
    if (f->slit && is_astray(f, to))
        turn_at_pole(patch, loop, f, to);
    for (size_t i = 0; i < TURNED_TRIED && is_wrong(f, to); i++) {
        struct uvs other = {0};
        if (!trim_order_turned(patch, loop, i, &turned))
            return;
        follow_loop(patch, &turned, f, &other);
        patch_loop_free(&turned);
        if (!is_wrong(f, &other)) {
            struct uvs swap = *to;
            *to = other;
            other = swap;
        }
        array_free(&other);
    }
}

/* The part of a polygon above the limit (side 1) or below it (-1): Sutherland and Hodgman 1974. */
static void clip_loop(struct uvs *loop, bool u, double limit, double side)
{
    struct uvs kept = {0};
    for (size_t i = 0; i < loop->n; i++) {
        struct uv a = loop->item[i], b = loop->item[(i + 1) % loop->n];
        double x = side * (coordinate(a, u) - limit), y = side * (coordinate(b, u) - limit);
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
    const struct nurbs_axis *a = axis_of(s, u);
    double low = HUGE_VAL, high = -HUGE_VAL, width = a->to - a->from;
    for (size_t i = 0; i < loop->n; i++) {
        low = fmin(low, coordinate(loop->item[i], u));
        high = fmax(high, coordinate(loop->item[i], u));
    }
    double first = floor((low - a->from) / width + ROUNDING);
    double last = ceil((high - a->from) / width - ROUNDING) - 1;
    if (!(u ? s->closed_u : s->closed_v) || !(last >= first) || last - first > 2) {
        append_loop(loop, to);
        return;
    }
    for (double k = first; k <= last; k++) {
        struct uvs copy = {0};
        for (size_t i = 0; i < loop->n; i++)
            *array_push(&copy) = uv_moved(loop->item[i], u, -k * width);
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
    const struct nurbs_axis *a = axis_of(s, u);
    struct uvs turned = {0};
    size_t i = 0;
    double k = 0, wide = width(a);
    for (; i + 1 < loop->n; i++) {
        double x = (coordinate(loop->item[i], u) - a->from) / wide;
        double y = (coordinate(loop->item[i + 1], u) - a->from) / wide;
        k = rounds > 0 ? floor(y) : ceil(y);
        if (rounds > 0 ? x < k && y >= k : x > k && y <= k)
            break;
    }
    if (i + 1 >= loop->n)
        return;
    struct uv p = loop->item[i], q = loop->item[i + 1];
    double limit = a->from + k * wide;
    double t = (limit - coordinate(p, u)) / (coordinate(q, u) - coordinate(p, u));
    struct uv first = uv_between(p, q, t);
    *(u ? &first.u : &first.v) = limit;
    *array_push(&turned) = first;
    for (size_t m = i + 1; m < loop->n; m++)
        *array_push(&turned) = loop->item[m];
    for (size_t m = 1; m <= i; m++)
        *array_push(&turned) = uv_moved(loop->item[m], u, rounds * wide);
    *array_push(&turned) = uv_moved(first, u, rounds * wide);
    array_free(loop);
    *loop = turned;
}

/* Closes a loop that goes round over one of the ends of the other parameter.  One that is alone and
 * runs along that end, so that nothing is between them, is closed over the other end. */
static void close_round(const struct pullback *s, struct uvs *loop, bool u, bool high, bool alone)
{
    const struct nurbs_axis *other = axis_of(s, !u);
    double range = width(axis_of(s, u)) * width(other);
    size_t n = loop->n;
    for (int side = 0; side < 2; side++) {
        double end = high == (side == 0) ? other->to : other->from;
        struct uv first = loop->item[0], last = loop->item[n - 1];
        *(u ? &first.v : &first.u) = end;
        *(u ? &last.v : &last.u) = end;
        loop->n = n;
        *array_push(loop) = last;
        *array_push(loop) = first;
        if (!alone || fabs(uv_loop_area(loop)) > ROUNDING * range)
            return;
    }
}

static bool is_same_place(const struct pullback *s, struct uv a, struct uv b)
{
    double u = (a.u - b.u) / (s->surface->u.to - s->surface->u.from);
    double v = (a.v - b.v) / (s->surface->v.to - s->surface->v.from);
    return u * u + v * v <= 1e-18;
}

/* Brings loops into the range of a surface that closes on itself (trim_loops.h). */
static void trim_seam(const struct pullback *s, const struct uv_polygon *from,
                      struct uv_polygon *to)
{
    size_t round[2] = {0};
    *to = (struct uv_polygon){0};
    for (size_t i = 0; i < from->n; i++)
        for (int u = 0; u < 2; u++)
            round[u] += loop_rounds(s, &from->item[i], u == 1) != 0;
    for (size_t i = 0; i < from->n; i++) {
        struct uvs loop = {0};
        struct uv_polygon once = {0};
        int n[2] = {loop_rounds(s, &from->item[i], false), loop_rounds(s, &from->item[i], true)};
        if (abs(n[0]) + abs(n[1]) > 1 || is_too_large(s, &from->item[i])) {
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

/* Does a loop run along a seam, forth and, a turn further on, back?  What it bounds is on both
 * sides of the seam, and so between: OpenCASCADE writes some such loops of tori the wrong way
 * round. */
static bool is_seamed(const struct pullback *on, const struct uvs *loop)
{
    if (loop_rounds(on, loop, true) != 0 || loop_rounds(on, loop, false) != 0)
        return false;
    for (int u = 0; u < 2; u++) {
        double low = HUGE_VAL, high = -HUGE_VAL, wide = width(axis_of(on, u == 1));
        for (size_t i = 0; i < loop->n; i++) {
            low = fmin(low, coordinate(loop->item[i], u == 1));
            high = fmax(high, coordinate(loop->item[i], u == 1));
        }
        if ((u ? on->closed_u : on->closed_v) && fabs(high - low - wide) <= ROUNDING * wide)
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
    if (loop_rounds(on, loop, true) != 0 || loop_rounds(on, loop, false) != 0)
        return false;
    first.item = &copy;
    trim_seam(on, &first, &outer);
    for (size_t i = 0; i < outer.n; i++) {
        trim_tidy(s, tolerance, &outer.item[i]);
        area += outer.item[i].n < 3 ? 0 : fabs(uv_loop_area(&outer.item[i]));
    }
    uv_polygon_free(&outer);
    return loop->n > 0 && area <= ROUNDING * width(&s->u) * width(&s->v);
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
            loop_rounds(on, &raw->item[i], true) != 0 || loop_rounds(on, &raw->item[i], false) != 0)
            return false;
    trim_seam(on, &first, &outer);
    for (size_t i = 1; i < raw->n; i++)
        for (size_t k = 0; k < ASKED; k++, asked++) {
            struct uv at = raw->item[i].item[k * raw->item[i].n / ASKED];
            at.u -= on->closed_u ? width(u) * floor((at.u - u->from) / width(u)) : 0;
            at.v -= on->closed_v ? width(v) * floor((at.v - v->from) / width(v)) : 0;
            inside += uv_polygon_inside(&outer, false, at);
        }
    uv_polygon_free(&outer);
    return raw->n > 1 && 2 * inside < asked;
}

/* Does a slit that the only loop of a surface without borders has to a pole lie on the other side
 * of it?  It is drawn through what counts. */
static bool is_slit_outside(const struct patch *patch, const struct follower *f,
                            const struct uv_polygon *loops)
{
    const struct nurbs_axis *u = &f->on.surface->u, *v = &f->on.surface->v;
    struct uv at = f->slit_at;
    if (!f->slit || patch->loop.n != 1 || patch->loop.item[0].directed ||
        patch->told.n == patch->loop.n)
        return false;
    at.u -= f->on.closed_u ? width(u) * floor((at.u - u->from) / width(u)) : 0;
    at.v -= f->on.closed_v ? width(v) * floor((at.v - v->from) / width(v)) : 0;
    return !uv_polygon_inside(loops, loops->open, at);
}

/* Does a loop cross a seam, or go round along a parameter, so that it bounds nothing in the
 * range? */
static bool is_across(const struct pullback *on, const struct uvs *loop, bool u)
{
    const struct nurbs_axis *a = axis_of(on, u);
    double low = HUGE_VAL, high = -HUGE_VAL;
    if (!(u ? on->closed_u : on->closed_v))
        return false;
    for (size_t i = 0; i < loop->n; i++) {
        low = fmin(low, coordinate(loop->item[i], u));
        high = fmax(high, coordinate(loop->item[i], u));
    }
    double first = floor((low - a->from) / width(a) + ROUNDING);
    double last = ceil((high - a->from) / width(a) - ROUNDING) - 1;
    return loop_rounds(on, loop, u) != 0 || last > first;
}

/* Is the seam a part of a loop? */
static bool is_along_seam(const struct pullback *on, const struct uvs *loop, bool u)
{
    const struct nurbs_axis *a = axis_of(on, u);
    double along = 0;
    if (!(u ? on->closed_u : on->closed_v))
        return false;
    for (size_t i = 0; i < loop->n; i++) {
        struct uv p = loop->item[i], q = loop->item[(i + 1) % loop->n];
        double x = (coordinate(p, u) - a->from) / width(a);
        double y = (coordinate(q, u) - a->from) / width(a), k = floor(x + 0.5);
        if (fabs(x - k) <= SEAM_NEAR && fabs(y - k) <= SEAM_NEAR)
            along += fabs(coordinate(q, !u) - coordinate(p, !u));
    }
    return along > SEAM_LONG * width(axis_of(on, !u));
}

/* Which side of its only loop a surface without borders is on: where the loop is in the range the
 * part that it bounds there; where a seam or a slit is a part of it what these are drawn
 * through. */
static enum patch_side side_of(const struct patch *patch, const struct follower *f,
                               const struct uv_polygon *raw)
{
    const struct pullback *on = &f->on;
    if (!is_borderless(on) || patch->loop.n != 1 || patch->told.n == 1 || f->slit_seen ||
        patch->loop.item[0].directed || !patch->loop.item[0].space)
        return PATCH_SIDE_TOLD;
    const struct uvs *loop = &raw->item[0];
    bool round = loop_rounds(on, loop, true) != 0 || loop_rounds(on, loop, false) != 0;
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
    struct follower f = {
        .on = pullback_new(&patch->surface), .tolerance = tolerance, .bent = bent, .seeks = SEEKS};
    for (size_t i = 0; i < patch->loop.n; i++) {
        struct uvs loop = {0};
        follow_any(patch, &patch->loop.item[i], &f, &loop);
        *array_push(&raw) = loop;
    }
    trim_seam(&f.on, &raw, loops);
    for (size_t i = 0; i < loops->n; i++) {
        trim_tidy(&patch->surface, tolerance, &loops->item[i]);
        for (int k = 0;
             k < PARTS_MAX && trim_crossings_drop(&patch->surface, tolerance, &loops->item[i]);)
            k++;
    }
    loops->off = f.off;
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
