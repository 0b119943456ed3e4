/* trim_follow - see trim_steps.h: the curves of a loop followed on the surface. */
#include <stdlib.h>

#include "base/array.h"
#include "trim_order.h"
#include "trim_steps.h"

enum { DEPTH_MAX = 10, SPACE_PARTS = 8, TURNED_TRIED = 16 };

/* How far from a pole, by a piece of a curve, its direction is still told; by the size of the
 * surface: how near to a pole a curve runs through it; by the width of the range: what is one way
 * to a pole and back. */
static const double POLE_STEP = 1e-3, POLE_SLIT = 1e-3, POLE_NEAR = 1e-6, POLE = 1e-9;

/* The curve's place; near the guess where the curve is in space, unless it is far from there. */
static struct uv uv_at(struct trim_follower *f, double t, struct uv guess)
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

/* Is the chord in the parameters, and on the surface, near the curve at three places (`at`)? */
static bool is_near(struct trim_follower *f, double t0, struct uv a, double t1, struct uv b,
                    struct uv at[3])
{
    struct vec3 p = pullback_point(&f->on, a), q = pullback_point(&f->on, b);
    for (int i = 1; i < 4; i++) {
        struct uv m = trim_between(a, b, i / 4.0);
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
static void bend_chord(struct trim_follower *f, struct uv a, struct uv b, const struct uv at[3])
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
        struct uv m = trim_between(a, b, (i + 1) / 4.0);
        *array_push(f->to) = trim_between(m, at[i], by);
    }
}

/* All points of the curve from t0 to t1 but the last. */
static void follow_span(struct trim_follower *f, double t0, struct uv a, double t1, struct uv b,
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
    struct uv m = uv_at(f, middle, trim_between(a, b, 0.5));
    follow_span(f, t0, a, middle, m, depth + 1);
    follow_span(f, middle, m, t1, b, depth + 1);
}

/* The pole that the curve is at, or -1. */
static int pole_at(const struct trim_follower *f, double t)
{
    return f->space ? pullback_pole(&f->on, nurbs_curve_point(f->curve, t), POLE_NEAR * f->on.size)
                    : -1;
}

/* The place on the side of a pole where a curve meets it at t, told by places of the curve nearer
 * and nearer to it, up to a step from it: so near, a search may end anywhere about the pole. */
static struct uv uv_on_pole(struct trim_follower *f, int pole, double t, double step,
                            struct uv guess)
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
    return end + POLE_STEP * (2 * end < a->from + a->to ? trim_width(a) : -trim_width(a));
}

/*
 * Where a loop goes on from a pole that it came to: by whole turns so that the side of the range in
 * between is one that bounds what is on the loop's left; by the shorter way where it is not
 * directed.
 */
static struct uv uv_past_pole(struct trim_follower *f, int pole, struct uv from, struct uv to)
{
    bool along_u = pole == PULLBACK_V_LOW || pole == PULLBACK_V_HIGH;
    double sign = pole == PULLBACK_V_LOW || pole == PULLBACK_U_HIGH ? 1 : -1;
    double turn = along_u ? trim_width(&f->on.surface->u) : trim_width(&f->on.surface->v);
    double by = along_u ? to.u - from.u : to.v - from.v;
    if (!(along_u ? f->on.closed_u : f->on.closed_v))
        return to;
    if (f->directed) {
        by *= sign;
        by -= turn * floor(by / turn);
        by = sign * (by < TRIM_ROUNDING * turn ? turn : by);
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
static void follow_piece(struct trim_follower *f, double t0, double t1, struct uv *last, int *pole)
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
static void poles_between(const struct trim_follower *f, double t0, double t1, struct doubles *at)
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

static void follow_curve(struct trim_follower *f, bool backwards, struct uv *last, int *pole)
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
        if (vec_distance(p, nurbs_curve_point(c, c->t.from + trim_width(&c->t) * i / 4)) > near)
            return false;
    return true;
}

/* All curves of a loop in order, without repeated points: from its first place to its last one,
 * which may be the first again a turn further on. */
static void follow_loop(const struct patch *patch, const struct patch_loop *loop,
                        struct trim_follower *f, struct uvs *to)
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

int trim_rounds(const struct pullback *s, const struct uvs *loop, bool u)
{
    const struct nurbs_axis *a = trim_axis(s, u);
    if (!(u ? s->closed_u : s->closed_v) || loop->n < 2)
        return 0;
    double along = trim_coordinate(loop->item[loop->n - 1], u) - trim_coordinate(loop->item[0], u);
    return (int)floor(along / (a->to - a->from) + 0.5);
}

static bool is_astray(const struct trim_follower *f, const struct uvs *loop)
{
    return trim_rounds(&f->on, loop, true) != 0 || trim_rounds(&f->on, loop, false) != 0;
}

bool trim_too_large(const struct pullback *s, const struct uvs *loop)
{
    double range = trim_width(&s->surface->u) * trim_width(&s->surface->v);
    return s->closed_u && s->closed_v && trim_rounds(s, loop, true) == 0 &&
           trim_rounds(s, loop, false) == 0 && fabs(uv_loop_area(loop)) > (1 + POLE_STEP) * range;
}

static bool is_wrong(const struct trim_follower *f, const struct uvs *loop)
{
    return is_astray(f, loop) || trim_too_large(&f->on, loop);
}

/* A loop that goes once round and has a slit to a pole as part of it, there and back: it goes round
 * the pole, too, and so comes back. */
static void turn_at_pole(const struct patch *patch, const struct patch_loop *loop,
                         struct trim_follower *f, struct uvs *to)
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

void trim_follow(const struct patch *patch, const struct patch_loop *loop, struct trim_follower *f,
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
