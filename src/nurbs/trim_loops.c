/* trim_loops - see trim_loops.h. */
#include "trim_loops.h"

#include <stdlib.h>

#include "base/array.h"

/* Does the loop go round the place?  Crossings of the ray to the right. */
static bool goes_round(const struct uvs *loop, struct uv p)
{
    bool inside = false;
    for (size_t i = 0, k = loop->n - 1; i < loop->n; k = i++) {
        struct uv a = loop->item[k], b = loop->item[i];
        if ((a.v > p.v) != (b.v > p.v) && p.u < a.u + (p.v - a.v) / (b.v - a.v) * (b.u - a.u))
            inside = !inside;
    }
    return inside;
}

bool uv_polygon_inside(const struct uv_polygon *loops, bool open, struct uv at)
{
    bool inside = open;
    for (size_t i = 0; i < loops->n; i++)
        if (goes_round(&loops->item[i], at))
            inside = !inside;
    return inside;
}

static double loop_area(const struct uvs *loop)
{
    double area = 0;
    struct uv o = loop->item[0];
    for (size_t i = 0, k = loop->n - 1; i < loop->n; k = i++) {
        struct uv a = loop->item[k], b = loop->item[i];
        area += (a.u - o.u) * (b.v - o.v) - (b.u - o.u) * (a.v - o.v);
    }
    return area / 2;
}

/* Corners of a loop that say whether it lies in another: one alone may be on the border of that. */
enum { ASKED = 7 };

bool uv_polygon_backwards(const struct uv_polygon *loops, size_t index, bool open)
{
    const struct uvs *loop = &loops->item[index];
    bool hole = open;
    for (size_t i = 0; i < loops->n; i++) {
        int inside = 0;
        for (size_t k = 0; k < ASKED && i != index; k++)
            inside += goes_round(&loops->item[i], loop->item[k * loop->n / ASKED]);
        hole = hole != (inside > ASKED / 2);
    }
    return (loop_area(loop) > 0) == hole;
}

/* A side of a loop, by its lowest u. */
struct side {
    double low, high;
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

/* Do the sides that begin at i and k cross, and part areas that count? */
static bool crosses(const struct uvs *loop, size_t i, size_t k)
{
    const double least = 1e-3;
    struct uv a = loop->item[i], b = loop->item[(i + 1) % loop->n];
    struct uv c = loop->item[k], d = loop->item[(k + 1) % loop->n];
    double ta = turn(c, d, a), tb = turn(c, d, b), area = 0;
    size_t apart = i < k ? k - i : i - k;
    /* A corner on the other side counts as left of it: curves may cross at their corners. */
    if (apart < 2 || apart + 1 >= loop->n || (ta >= 0) == (tb >= 0) ||
        (turn(a, b, c) >= 0) == (turn(a, b, d) >= 0))
        return false;
    double t = ta / (ta - tb);
    struct uv at = {a.u + t * (b.u - a.u), a.v + t * (b.v - a.v)};
    size_t from = i < k ? i : k, to = i < k ? k : i;
    for (size_t m = from + 1; m < to; m++)
        area += turn(at, loop->item[m], loop->item[m + 1]) / 2;
    double rest = loop_area(loop) - area;
    return fmin(fabs(area), fabs(rest)) > least * fmax(fabs(area), fabs(rest));
}

size_t uv_polygon_crossings(const struct uv_polygon *loops)
{
    size_t count = 0;
    for (size_t k = 0; k < loops->n; k++) {
        const struct uvs *loop = &loops->item[k];
        struct side *side = mem_alloc(loop->n + 1, sizeof *side);
        for (size_t i = 0; i < loop->n; i++) {
            double u = loop->item[i].u, next = loop->item[(i + 1) % loop->n].u;
            side[i] = (struct side){fmin(u, next), fmax(u, next), i};
        }
        if (loop->n > 0)
            qsort(side, loop->n, sizeof *side, compare_sides);
        for (size_t i = 0; i < loop->n; i++)
            for (size_t m = i + 1; m < loop->n && side[m].low <= side[i].high; m++)
                count += crosses(loop, side[i].i, side[m].i);
        free(side);
    }
    return count;
}

void uv_polygon_free(struct uv_polygon *loops)
{
    for (size_t i = 0; i < loops->n; i++)
        array_free(&loops->item[i]);
    array_free(loops);
    loops->off = 0;
    loops->lost = 0;
}

/* Samples of the whole range in each direction, of which the best are starts of a search; samples
 * along a side of the range. */
enum { ACROSS = 40, STARTS = 6, SIDE_SAMPLES = 9 };

/* By their length: two sides of the range so near each other are one. */
static const double CLOSED = 1e-6;

static double width(const struct nurbs_axis *a)
{
    return a->to - a->from;
}

/* Are the two sides of the range where u (or else v) ends one line? */
static bool is_closed(const struct nurbs *s, bool u)
{
    double apart = 0, length = 0;
    struct vec3 last = {0, 0, 0};
    for (int i = 0; i <= SIDE_SAMPLES; i++) {
        double along_v = s->v.from + width(&s->v) * i / SIDE_SAMPLES;
        double along_u = s->u.from + width(&s->u) * i / SIDE_SAMPLES;
        struct vec3 a =
            nurbs_point(s, u ? (struct uv){s->u.from, along_v} : (struct uv){along_u, s->v.from});
        struct vec3 b =
            nurbs_point(s, u ? (struct uv){s->u.to, along_v} : (struct uv){along_u, s->v.to});
        apart = fmax(apart, vec_distance(a, b));
        length += i > 0 ? vec_distance(a, last) : 0;
        last = a;
    }
    return apart <= CLOSED * length;
}

struct pullback pullback_new(const struct nurbs *surface)
{
    return (struct pullback){surface, is_closed(surface, true), is_closed(surface, false)};
}

/* Whole turns that bring x into the range. */
static double turns_into_range(const struct nurbs_axis *a, bool closed, double x)
{
    return closed ? floor((x - a->from) / width(a)) : 0;
}

struct vec3 pullback_point(const struct pullback *p, struct uv at)
{
    const struct nurbs *s = p->surface;
    at.u -= width(&s->u) * turns_into_range(&s->u, p->closed_u, at.u);
    at.v -= width(&s->v) * turns_into_range(&s->v, p->closed_v, at.v);
    at.u = fmin(fmax(at.u, s->u.from), s->u.to);
    at.v = fmin(fmax(at.v, s->v.from), s->v.to);
    return nurbs_point(s, at);
}

static double distance(const struct pullback *p, struct vec3 q, struct uv at)
{
    return vec_distance(q, pullback_point(p, at));
}

struct uv pullback_foot(const struct pullback *p, struct vec3 q, struct uv guess)
{
    const struct nurbs *s = p->surface;
    double ku = turns_into_range(&s->u, p->closed_u, guess.u),
           kv = turns_into_range(&s->v, p->closed_v, guess.v);
    struct uv base = {guess.u - ku * width(&s->u), guess.v - kv * width(&s->v)};
    struct uv best = nurbs_foot(s, q, base);
    double least = vec_distance(q, nurbs_point(s, best));
    best.u += ku * width(&s->u);
    best.v += kv * width(&s->v);
    /* A search that ends at the seam goes on beyond it. */
    for (int i = 0; i < 4; i++) {
        bool along_u = i < 2;
        double sign = i % 2 == 0 ? 1 : -1;
        const struct nurbs_axis *a = along_u ? &s->u : &s->v;
        double at = along_u ? best.u - ku * width(a) : best.v - kv * width(a);
        if (!(along_u ? p->closed_u : p->closed_v) || (sign > 0 ? at < a->to : at > a->from))
            continue;
        struct uv t = {best.u - ku * width(&s->u), best.v - kv * width(&s->v)};
        *(along_u ? &t.u : &t.v) = sign > 0 ? a->from : a->to;
        t = nurbs_foot(s, q, t);
        double d = vec_distance(q, nurbs_point(s, t));
        if (d < least) {
            least = d;
            ku += along_u ? sign : 0;
            kv += along_u ? 0 : sign;
            best = (struct uv){t.u + ku * width(&s->u), t.v + kv * width(&s->v)};
        }
    }
    return best;
}

struct uv pullback_seek(const struct pullback *p, struct vec3 q)
{
    const struct nurbs *s = p->surface;
    struct uv start[STARTS] = {{0, 0}}, best = {0, 0};
    double near[STARTS], least = HUGE_VAL;
    for (int i = 0; i < STARTS; i++)
        near[i] = HUGE_VAL;
    for (int k = 0; k < (ACROSS + 1) * (ACROSS + 1); k++) {
        struct uv at = {s->u.from + width(&s->u) * (k % (ACROSS + 1)) / ACROSS,
                        s->v.from + width(&s->v) * (k / (ACROSS + 1)) / ACROSS};
        double d = distance(p, q, at);
        int i = STARTS;
        for (; i > 0 && d < near[i - 1]; i--)
            if (i < STARTS) {
                near[i] = near[i - 1];
                start[i] = start[i - 1];
            }
        if (i < STARTS) {
            near[i] = d;
            start[i] = at;
        }
    }
    for (int i = 0; i < STARTS; i++) {
        struct uv at = pullback_foot(p, q, start[i]);
        double d = distance(p, q, at);
        if (d < least) {
            least = d;
            best = at;
        }
    }
    return best;
}

enum { DEPTH_MAX = 10, SPACE_PARTS = 8 };

/* Of the longer derivative: one so short is that of a pole; by a part of a span: how far from a
 * pole a curve still tells its direction. */
static const double POLE = 1e-7, POLE_STEP = 1e-3;

/* A curve in the parameters or in space that is being followed on the surface. */
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

static struct uv uv_between(struct uv a, struct uv b, double t)
{
    return (struct uv){a.u + (b.u - a.u) * t, a.v + (b.v - a.v) * t};
}

/* Is the chord in the parameters, and on the surface, near the curve at three places? */
static bool is_near(struct follower *f, double t0, struct uv a, double t1, struct uv b)
{
    struct vec3 p = pullback_point(&f->on, a), q = pullback_point(&f->on, b);
    for (int i = 1; i < 4; i++) {
        struct uv m = uv_between(a, b, i / 4.0);
        struct vec3 on = pullback_point(&f->on, uv_at(f, t0 + (t1 - t0) * i / 4, m));
        if (vec_segment_distance(p, q, on) > f->tolerance ||
            vec_segment_distance(p, q, pullback_point(&f->on, m)) > f->tolerance)
            return false;
    }
    return true;
}

/* All points of the curve from t0 to t1 but the last. */
static void follow_span(struct follower *f, double t0, struct uv a, double t1, struct uv b,
                        int depth)
{
    if (depth == DEPTH_MAX || is_near(f, t0, a, t1, b)) {
        *array_push(f->to) = a;
        return;
    }
    double middle = t0 + (t1 - t0) / 2;
    struct uv m = uv_at(f, middle, uv_between(a, b, 0.5));
    follow_span(f, t0, a, middle, m, depth + 1);
    follow_span(f, middle, m, t1, b, depth + 1);
}

/* At a pole a side of the range is one point, and the foot point of a curve that ends there says
 * nothing of the parameter along that side: it is taken from a place of the curve a little way from
 * the end, `inside`. */
static struct uv uv_at_pole(struct follower *f, struct uv at, double inside)
{
    const struct nurbs *s = f->on.surface;
    struct vec3 d[3][3];
    struct uv base = at;
    base.u -= turns_into_range(&s->u, f->on.closed_u, at.u) * width(&s->u);
    base.v -= turns_into_range(&s->v, f->on.closed_v, at.v) * width(&s->v);
    nurbs_derivatives(s, base, 1, d);
    double du = vec_length(d[1][0]) * width(&s->u), dv = vec_length(d[0][1]) * width(&s->v);
    if (!f->space || (du > POLE * dv && dv > POLE * du))
        return at;
    struct uv near = pullback_seek(&f->on, nurbs_curve_point(f->curve, inside));
    if (du <= POLE * dv)
        at.u = near.u +
               (f->on.closed_u ? floor((at.u - near.u) / width(&s->u) + 0.5) : 0) * width(&s->u);
    else
        at.v = near.v +
               (f->on.closed_v ? floor((at.v - near.v) / width(&s->v) + 0.5) : 0) * width(&s->v);
    return at;
}

/* All points of a curve, span by span, with its last one; a span that bends is split first.
 * `start` is the place of its first point. */
static void follow_curve(struct follower *f, bool backwards, struct uv start)
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
            if (p == 0 && k == 0)
                a = uv_at_pole(f, a, t0 + POLE_STEP * (t1 - t0));
            struct uv b = uv_at_pole(f, uv_at(f, t1, a), t1 - POLE_STEP * (t1 - t0));
            follow_span(f, t0, a, t1, b, 0);
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

/* The squared distance of two points of the loop's curves: in parts of the range, or in space. */
static double loop_distance2(const struct patch *patch, const struct patch_loop *loop,
                             struct vec3 a, struct vec3 b)
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
    if (loop->directed)
        return false;
    if (k > 0)
        return loop_distance2(patch, loop, at, last) < loop_distance2(patch, loop, at, first);
    if (loop->n == 1)
        return false;
    struct vec3 p = end_of(&loop->item[1], false), q = end_of(&loop->item[1], true);
    return fmin(loop_distance2(patch, loop, first, p), loop_distance2(patch, loop, first, q)) <
           fmin(loop_distance2(patch, loop, last, p), loop_distance2(patch, loop, last, q));
}

/* All curves of a loop in order, without repeated points: from its first place to its last one,
 * which may be the first again a turn further on. */
static void follow_loop(const struct patch *patch, const struct patch_loop *loop,
                        struct follower *f, struct uvs *to)
{
    struct uvs all = {0};
    struct vec3 at = {0, 0, 0};
    struct uv guess = {0, 0};
    f->to = &all; // cppcheck-suppress autoVariables
    f->space = loop->space;
    for (size_t k = 0; k < loop->n; k++) {
        bool backwards = is_backwards(patch, loop, k, at);
        f->curve = &loop->item[k];
        at = end_of(f->curve, backwards);
        if (k == 0 && loop->space)
            guess = pullback_seek(&f->on, at);
        follow_curve(f, backwards, uv_at(f, backwards ? f->curve->t.to : f->curve->t.from, guess));
        guess = all.item[all.n - 1];
        at = end_of(f->curve, !backwards);
    }
    for (size_t i = 0; i < all.n; i++)
        if (to->n == 0 || square(to->item[to->n - 1], all.item[i], &patch->surface) > 1e-18)
            *array_push(to) = all.item[i];
    array_free(&all);
}

/* By the width of the range: what is rounding. */
static const double ROUNDING = 1e-6;

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

/* Closes a loop that goes round over one of the ends of the other parameter. */
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
        if (abs(n[0]) + abs(n[1]) > 1) {
            to->lost++;
            continue;
        }
        for (size_t k = 0; k < from->item[i].n; k++)
            *array_push(&loop) = from->item[i].item[k];
        bool u = n[1] != 0, is_round = n[0] != 0 || u;
        while (!is_round && loop.n > 1 && is_same_place(s, loop.item[0], loop.item[loop.n - 1]))
            loop.n--;
        /* The left of a loop along u is at higher v, of one along v at lower u. */
        if (is_round)
            close_round(s, &loop, u, round[u] % 2 == 0 || (n[u] > 0) == u);
        wrap_loop(s, &loop, true, &once);
        for (size_t k = 0; k < once.n; k++)
            wrap_loop(s, &once.item[k], false, to);
        array_free(&once);
    }
}

void trim_loops(const struct patch *patch, double tolerance, struct uv_polygon *loops)
{
    struct uv_polygon raw = {0};
    struct follower f = {.on = pullback_new(&patch->surface), .tolerance = tolerance};
    for (size_t i = 0; i < patch->loop.n; i++) {
        struct uvs loop = {0};
        follow_loop(patch, &patch->loop.item[i], &f, &loop);
        *array_push(&raw) = loop;
    }
    trim_seam(&f.on, &raw, loops);
    loops->off = f.off;
    uv_polygon_free(&raw);
}
