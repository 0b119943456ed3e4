/* trim_loops - see trim_loops.h. */
#include "trim_loops.h"

#include <stdlib.h>

#include "base/array.h"
#include "pullback.h"
#include "trim_seam.h"

enum { DEPTH_MAX = 10, SPACE_PARTS = 8 };

/* A curve in the parameters or in space, followed on the surface. */
struct follower {
    struct pullback on;
    const struct nurbs_curve *curve;
    double tolerance;
    bool space;
    double off; /* the farthest that the curve was off the surface */
    struct uvs *to;
};

/* The curve's place; near the guess where the curve is in space. */
static struct uv uv_at(struct follower *f, double t, struct uv guess)
{
    struct vec3 p = nurbs_curve_point(f->curve, t);
    if (!f->space)
        return (struct uv){p.x, p.y};
    struct uv at = pullback_foot(&f->on, p, guess);
    f->off = fmax(f->off, vec_distance(p, pullback_point(&f->on, at)));
    return at;
}

static double distance_to_chord(struct vec3 p, struct vec3 a, struct vec3 b)
{
    struct vec3 d = vec_sub(b, a), r = vec_sub(p, a);
    double l = vec_dot(d, d);
    double t = l > 0 ? fmin(fmax(vec_dot(r, d) / l, 0), 1) : 0;
    return vec_distance(p, vec_along(a, t, d));
}

static struct uv mix(struct uv a, struct uv b, double t)
{
    return (struct uv){a.u + (b.u - a.u) * t, a.v + (b.v - a.v) * t};
}

/* Is the straight way in the parameters, and on the surface, near the curve at three places? */
static bool is_near(struct follower *f, double t0, struct uv a, double t1, struct uv b)
{
    struct vec3 p = pullback_point(&f->on, a), q = pullback_point(&f->on, b);
    for (int i = 1; i < 4; i++) {
        struct uv m = mix(a, b, i / 4.0);
        struct vec3 on = pullback_point(&f->on, uv_at(f, t0 + (t1 - t0) * i / 4, m));
        if (distance_to_chord(on, p, q) > f->tolerance ||
            distance_to_chord(pullback_point(&f->on, m), p, q) > f->tolerance)
            return false;
    }
    return true;
}

/* All points of the curve from t0 to t1 but the last. */
static void follow(struct follower *f, double t0, struct uv a, double t1, struct uv b, int depth)
{
    if (depth == DEPTH_MAX || is_near(f, t0, a, t1, b)) {
        *array_push(f->to) = a;
        return;
    }
    double middle = t0 + (t1 - t0) / 2;
    struct uv m = uv_at(f, middle, mix(a, b, 0.5));
    follow(f, t0, a, middle, m, depth + 1);
    follow(f, middle, m, t1, b, depth + 1);
}

/* One curve, span by span, from t0 to t1, with its last point; a span that bends is parted first.
 * `start` is its place at t0, where t0 is an end of the range. */
static void interpolation_curve(struct follower *f, bool backwards, struct uv start)
{
    const struct nurbs_axis *t = &f->curve->t;
    size_t spans = t->poles - (size_t)t->degree;
    struct uv a = start;
    for (size_t k = 0; k < spans; k++) {
        size_t i = (size_t)t->degree + (backwards ? spans - 1 - k : k);
        double low = fmax(t->knot[i], t->from), high = fmin(t->knot[i + 1], t->to);
        double from = backwards ? high : low, step = backwards ? low - high : high - low;
        int parts = f->space ? SPACE_PARTS : t->degree > 1 ? 2 : 1;
        for (int p = 0; p < parts && high > low; p++) {
            double t0 = from + step * p / parts, t1 = from + step * (p + 1) / parts;
            struct uv b = uv_at(f, t1, a);
            follow(f, t0, a, t1, b, 0);
            a = b;
        }
    }
    *array_push(f->to) = a;
}

static double square(struct uv a, struct uv b, const struct nurbs *s)
{
    double u = (a.u - b.u) / (s->u.to - s->u.from), v = (a.v - b.v) / (s->v.to - s->v.from);
    return u * u + v * v;
}

static struct vec3 end_of(const struct nurbs_curve *c, bool last)
{
    return nurbs_curve_point(c, last ? c->t.to : c->t.from);
}

/* How far the loop's curves are apart in u and v, or in space, squared. */
static double apart(const struct patch *patch, const struct patch_loop *loop, struct vec3 a,
                    struct vec3 b)
{
    if (loop->space)
        return vec_dot(vec_sub(a, b), vec_sub(a, b));
    return square((struct uv){a.x, a.y}, (struct uv){b.x, b.y}, &patch->surface);
}

/* Does curve k run backwards, when the loop has come to `at`?  The first one runs so that its end
 * is near an end of the second. */
static bool is_backwards(const struct patch *patch, const struct patch_loop *loop, size_t k,
                         struct vec3 at)
{
    struct vec3 first = end_of(&loop->item[k], false), last = end_of(&loop->item[k], true);
    if (k > 0)
        return apart(patch, loop, at, last) < apart(patch, loop, at, first);
    if (loop->n == 1)
        return false;
    struct vec3 p = end_of(&loop->item[1], false), q = end_of(&loop->item[1], true);
    return fmin(apart(patch, loop, first, p), apart(patch, loop, first, q)) <
           fmin(apart(patch, loop, last, p), apart(patch, loop, last, q));
}

/* All curves of a loop, one behind the other, without repeated points: from its first place to its
 * last one, which may be the first again a turn further on. */
static void interpolation_loop(const struct patch *patch, const struct patch_loop *loop,
                               struct follower *f, struct uvs *to)
{
    struct uvs all = {0};
    struct vec3 at = {0, 0, 0};
    struct uv guess = {0, 0};
    f->to = &all;
    f->space = loop->space;
    for (size_t k = 0; k < loop->n; k++) {
        bool backwards = is_backwards(patch, loop, k, at);
        f->curve = &loop->item[k];
        at = end_of(f->curve, backwards);
        if (k == 0 && loop->space)
            guess = pullback_seek(&f->on, at);
        interpolation_curve(f, backwards,
                            uv_at(f, backwards ? f->curve->t.to : f->curve->t.from, guess));
        guess = all.item[all.n - 1];
        at = end_of(f->curve, !backwards);
    }
    for (size_t i = 0; i < all.n; i++)
        if (to->n == 0 || square(to->item[to->n - 1], all.item[i], &patch->surface) > 1e-18)
            *array_push(to) = all.item[i];
    array_free(&all);
}

void trim_loops(const struct patch *patch, double tolerance, struct uv_polygon *loops)
{
    struct uv_polygon raw = {0};
    struct follower f = {.on = pullback_new(&patch->surface), .tolerance = tolerance};
    for (size_t i = 0; i < patch->loop.n; i++) {
        struct uvs loop = {0};
        interpolation_loop(patch, &patch->loop.item[i], &f, &loop);
        *array_push(&raw) = loop;
    }
    trim_seam(&f.on, &raw, loops);
    loops->off = f.off;
    uv_polygon_free(&raw);
}
