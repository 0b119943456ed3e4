/* pullback - see pullback.h. */
#include "pullback.h"

#include <stdlib.h>

#include "math/elementary.h"
#include "base/array.h"

/* Samples of the whole range in each direction, at least, at most, and in a span, of which the best
 * are starts of a search; samples along a side of the range. */
enum { ACROSS = 40, ACROSS_MAX = 240, IN_SPAN = 3, STARTS = 6, SIDE_SAMPLES = 9 };

/* By their length: two sides of the range so near each other are one. */
static const double CLOSED = 1e-6;

/* By the size of the surface: a side so short is a pole. */
static const double POLE = 1e-9;

static double width(const struct nurbs_axis *a)
{
    return a->to - a->from;
}

/* Place i of SIDE_SAMPLES on one side of the range. */
static struct vec3 side_point(const struct nurbs *s, int side, int i)
{
    double u = s->u.from + width(&s->u) * i / SIDE_SAMPLES;
    double v = s->v.from + width(&s->v) * i / SIDE_SAMPLES;
    struct uv at = side == PULLBACK_U_LOW    ? (struct uv){s->u.from, v}
                   : side == PULLBACK_U_HIGH ? (struct uv){s->u.to, v}
                   : side == PULLBACK_V_LOW  ? (struct uv){u, s->v.from}
                                             : (struct uv){u, s->v.to};
    return nurbs_point(s, at);
}

/* Are the two sides of the range, from `low` on, one line? */
static bool is_closed(const struct nurbs *s, int low)
{
    double apart = 0, length = 0;
    struct vec3 last = {0, 0, 0};
    for (int i = 0; i <= SIDE_SAMPLES; i++) {
        struct vec3 a = side_point(s, low, i), b = side_point(s, low + 1, i);
        apart = fmax(apart, vec_distance(a, b));
        length += i > 0 ? vec_distance(a, last) : 0;
        last = a;
    }
    return apart <= CLOSED * length;
}

static void find_poles(struct pullback *p)
{
    double length[4] = {0, 0, 0, 0};
    for (int side = 0; side < 4; side++) {
        p->pole[side] = side_point(p->surface, side, 0);
        for (int i = 1; i <= SIDE_SAMPLES; i++)
            length[side] =
                fmax(length[side], vec_distance(p->pole[side], side_point(p->surface, side, i)));
        p->size = fmax(p->size, length[side]);
    }
    for (int side = 0; side < 4; side++)
        p->is_pole[side] = length[side] <= POLE * p->size;
}

struct pullback pullback_new(const struct nurbs *surface)
{
    struct pullback p = {.surface = surface,
                         .closed_u = is_closed(surface, PULLBACK_U_LOW),
                         .closed_v = is_closed(surface, PULLBACK_V_LOW)};
    find_poles(&p);
    return p;
}

int pullback_pole(const struct pullback *p, struct vec3 q, double near)
{
    for (int side = 0; side < 4; side++)
        if (p->is_pole[side] && vec_distance(p->pole[side], q) <= near)
            return side;
    return -1;
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

/* By whole turns to the place nearest to the guess. */
static double turned_near(const struct nurbs_axis *a, bool closed, double x, double guess)
{
    return x + (closed ? width(a) * floor((guess - x) / width(a) + 0.5) : 0);
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
    best.u = turned_near(&s->u, p->closed_u, best.u, guess.u);
    best.v = turned_near(&s->v, p->closed_v, best.v, guess.v);
    return best;
}

static size_t samples_of(const struct nurbs_axis *a)
{
    size_t n = IN_SPAN * (a->poles - (size_t)a->degree);
    return n < ACROSS ? ACROSS : n < ACROSS_MAX ? n : ACROSS_MAX;
}

/* The middles of equal cells: at a pole there is nothing to start from. */
static struct uv sample_at(const struct pullback *p, size_t k)
{
    const struct nurbs *s = p->surface;
    size_t column = k % p->across, row = k / p->across;
    double u = ((double)column + 0.5) / (double)p->across;
    double v = ((double)row + 0.5) / (double)p->along;
    return (struct uv){s->u.from + u * width(&s->u), s->v.from + v * width(&s->v)};
}

static void make_samples(struct pullback *p)
{
    p->across = samples_of(&p->surface->u);
    p->along = samples_of(&p->surface->v);
    p->sample = mem_alloc(p->across * p->along, sizeof *p->sample);
    for (size_t k = 0; k < p->across * p->along; k++)
        p->sample[k] = nurbs_point(p->surface, sample_at(p, k));
}

struct uv pullback_seek(struct pullback *p, struct vec3 q)
{
    struct uv best = {0, 0};
    size_t start[STARTS] = {0};
    double near[STARTS], least = HUGE_VAL;
    if (!p->sample)
        make_samples(p);
    for (int i = 0; i < STARTS; i++)
        near[i] = HUGE_VAL;
    for (size_t k = 0; k < p->across * p->along; k++) {
        struct vec3 r = vec_sub(q, p->sample[k]);
        double d = vec_dot(r, r);
        int i = STARTS;
        for (; i > 0 && d < near[i - 1]; i--)
            if (i < STARTS) {
                near[i] = near[i - 1];
                start[i] = start[i - 1];
            }
        if (i < STARTS) {
            near[i] = d;
            start[i] = k;
        }
    }
    for (int i = 0; i < STARTS && near[i] < HUGE_VAL; i++) {
        struct uv at = pullback_foot(p, q, sample_at(p, start[i]));
        double d = vec_distance(q, pullback_point(p, at));
        if (d < least) {
            least = d;
            best = at;
        }
    }
    return best;
}

struct uv pullback_seek_near(struct pullback *p, struct vec3 q, struct uv guess)
{
    struct uv at = pullback_seek(p, q);
    return (struct uv){turned_near(&p->surface->u, p->closed_u, at.u, guess.u),
                       turned_near(&p->surface->v, p->closed_v, at.v, guess.v)};
}

void pullback_free(struct pullback *p)
{
    free(p->sample);
    p->sample = NULL;
}
