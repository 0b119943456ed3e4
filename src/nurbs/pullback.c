/* pullback - see pullback.h. */
#include "pullback.h"

enum { ACROSS = 40, STARTS = 6, LOOKED_AT = 9 };

/* Sides of the range so near each other, by their length, are one. */
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
    for (int i = 0; i <= LOOKED_AT; i++) {
        double along_v = s->v.from + width(&s->v) * i / LOOKED_AT;
        double along_u = s->u.from + width(&s->u) * i / LOOKED_AT;
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
static double turns(const struct nurbs_axis *a, bool closed, double x)
{
    return closed ? floor((x - a->from) / width(a)) : 0;
}

struct vec3 pullback_point(const struct pullback *p, struct uv at)
{
    const struct nurbs *s = p->surface;
    at.u -= width(&s->u) * turns(&s->u, p->closed_u, at.u);
    at.v -= width(&s->v) * turns(&s->v, p->closed_v, at.v);
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
    double ku = turns(&s->u, p->closed_u, guess.u), kv = turns(&s->v, p->closed_v, guess.v);
    struct uv base = {guess.u - ku * width(&s->u), guess.v - kv * width(&s->v)};
    struct uv best = nurbs_foot(s, q, base);
    double least = vec_distance(q, nurbs_point(s, best));
    best.u += ku * width(&s->u);
    best.v += kv * width(&s->v);
    /* A search that ends at the seam goes on behind it. */
    for (int i = 0; i < 4; i++) {
        bool along_u = i < 2;
        double way = i % 2 == 0 ? 1 : -1;
        const struct nurbs_axis *a = along_u ? &s->u : &s->v;
        double at = along_u ? best.u - ku * width(a) : best.v - kv * width(a);
        if (!(along_u ? p->closed_u : p->closed_v) || (way > 0 ? at < a->to : at > a->from))
            continue;
        struct uv t = {best.u - ku * width(&s->u), best.v - kv * width(&s->v)};
        *(along_u ? &t.u : &t.v) = way > 0 ? a->from : a->to;
        t = nurbs_foot(s, q, t);
        double d = vec_distance(q, nurbs_point(s, t));
        if (d < least) {
            least = d;
            ku += along_u ? way : 0;
            kv += along_u ? 0 : way;
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
