/* iges_parameters - see iges_parameters.h. */
#include "iges_parameters.h"

#include <stdlib.h>

#include "math/elementary.h"
#include "base/array.h"
#include "iges_curve.h"
#include "iges_ruled.h"
#include "nurbs/approximate.h"

/* mm: as near as that loops are brought over; places of a curve that are looked at for crossings of
 * a knot, in a span. */
static const double NEAR = 1e-7;
enum { LOOKS = 16, HALVINGS = 60 };

/* ---- along a curve */

/* The span of the axis that t is in. */
static void span_around(const struct nurbs_axis *a, double t, double *low, double *high)
{
    *low = a->from;
    *high = a->to;
    for (size_t i = 0; i < a->poles + (size_t)a->degree + 1; i++) {
        double k = a->knot[i];
        if (k > *low && k <= t)
            *low = k;
        if (k < *high && k > t)
            *high = k;
    }
    if (!(*low < *high)) { /* at the end */
        *low = a->from;
        for (size_t i = 0; i < a->poles + (size_t)a->degree + 1; i++)
            *low = a->knot[i] < a->to ? fmax(*low, a->knot[i]) : *low;
        *high = a->to;
    }
}

/* Within a span of an arc, whose ends have the same weight: the tangent of half the angle from its
 * middle grows evenly. */
static double within_arc(const struct nurbs_axis *a, double t, double scale, bool back)
{
    double low, high;
    span_around(a, t, &low, &high);
    double half = scale * (high - low) / 2, x = 2 * (t - low) / (high - low) - 1;
    double y = back ? 2 * atan(x * tan(half / 2)) / half : tan(x * half / 2) / tan(half / 2);
    return low + (high - low) * (1 + y) / 2;
}

double iges_parameter(const struct nurbs_curve *c, const struct iges_range *r, double t)
{
    double scale = (r->to - r->from) / (c->t.to - c->t.from);
    double own = c->t.from + fmin(fmax(t - r->from, 0), r->to - r->from) / scale;
    return r->angle ? within_arc(&c->t, own, scale, false) : own;
}

double iges_parameter_back(const struct nurbs_curve *c, const struct iges_range *r, double own)
{
    double scale = (r->to - r->from) / (c->t.to - c->t.from);
    if (r->angle)
        own = within_arc(&c->t, own, scale, true);
    return r->from + (own - c->t.from) * scale;
}

size_t iges_range_of(const struct iges_ranges *ranges, double t)
{
    size_t i = 0;
    while (i + 1 < ranges->n && t > ranges->item[i].to)
        i++;
    return i;
}

/* ---- on a surface */

/* How the parameters u, v of the file become those of the NURBS surface. */
struct map {
    int type;
    struct patch_loop base; /* the curve that the surface is made of ... */
    struct iges_ranges range;
    struct iges_side side[2]; /* of a ruled surface */
    const struct nurbs *surface;
    double mm_u, mm_v; /* how far the surface goes for one of its parameter, about */
};

/* ... whose parameter runs over 0..n when there are several curves, and over its own range or 0..1
 * when there is one. */
static double along_base(const struct map *m, double t, const struct nurbs_axis *to)
{
    size_t i = iges_range_of(&m->range, t), n = m->base.n;
    const struct nurbs_curve *c = &m->base.item[i];
    double own = (iges_parameter(c, &m->range.item[i], t) - c->t.from) / (c->t.to - c->t.from);
    return to->from + (to->to - to->from) * ((double)i + own) / (double)n;
}

static struct uv mapped(const struct map *m, double u, double v)
{
    const struct nurbs *s = m->surface;
    if (m->type == 120) { /* along the curve, and the angle */
        double turn = s->u.to - s->u.from, angle = fmin(fmax(v - s->u.from, 0), turn);
        return (struct uv){within_arc(&s->u, s->u.from + angle, 1, false), along_base(m, u, &s->v)};
    }
    v = s->v.from + fmin(fmax(v, 0), 1) * (s->v.to - s->v.from);
    if (m->type == 118)
        return (struct uv){s->u.from + iges_ruled_own(&m->side[0], u) * (s->u.to - s->u.from), v};
    double from = m->range.item[0].from, to = m->range.item[m->range.n - 1].to;
    return (struct uv){along_base(m, from + u * (to - from), &s->u), v};
}

struct mapped_curve {
    const struct map *map;
    const struct nurbs_curve *curve;
};

/* In mm, so that both parameters count alike. */
static struct vec3 mapped_point(const void *context, double t)
{
    const struct mapped_curve *c = context;
    struct vec3 at = nurbs_curve_point(c->curve, t);
    struct uv to = mapped(c->map, at.x, at.y);
    return vec(to.u * c->map->mm_u, to.v * c->map->mm_v, 0);
}

/* How often a knot of the axis lies below x. */
static size_t knots_below(const struct nurbs_axis *a, double x)
{
    size_t n = 0;
    while (n < a->poles + (size_t)a->degree + 1 && a->knot[n] < x)
        n++;
    return n;
}

static bool in_one_span(const struct map *m, struct vec3 a, struct vec3 b)
{
    const struct nurbs *s = m->surface;
    return knots_below(&s->u, a.x / m->mm_u) == knots_below(&s->u, b.x / m->mm_u) &&
           knots_below(&s->v, a.y / m->mm_v) == knots_below(&s->v, b.y / m->mm_v);
}

/* Where the mapped curve may have kinks: at its own breaks, and where it crosses a knot of the
 * surface. */
static void kinks_of(const struct mapped_curve *c, struct doubles *at)
{
    const struct nurbs_axis *t = &c->curve->t;
    struct doubles place = {0};
    for (size_t i = (size_t)t->degree; i < t->poles; i++)
        for (int k = 0; k < LOOKS; k++) {
            double x = t->knot[i] + (t->knot[i + 1] - t->knot[i]) * k / LOOKS;
            if (x > t->from && x < t->to && (place.n == 0 || x > place.item[place.n - 1]))
                *array_push(&place) = x;
        }
    *array_push(&place) = t->to;
    size_t n = nurbs_axis_breaks(t, NULL, 0), next = 0;
    double *own = mem_alloc(n + 1, sizeof *own), low = t->from;
    nurbs_axis_breaks(t, own, n);
    *array_push(at) = t->from;
    for (size_t i = 0; i < place.n; low = place.item[i++]) {
        double a = low, b = place.item[i];
        bool crosses = !in_one_span(c->map, mapped_point(c, a), mapped_point(c, b));
        for (int k = 0; k < HALVINGS && crosses; k++) {
            double x = (a + b) / 2;
            *(in_one_span(c->map, mapped_point(c, low), mapped_point(c, x)) ? &a : &b) = x;
        }
        for (; next < n && own[next] <= place.item[i]; next++)
            if (own[next] > at->item[at->n - 1] && own[next] < t->to)
                *array_push(at) = own[next];
        if (crosses && b > at->item[at->n - 1] && b < t->to)
            *array_push(at) = b;
    }
    *array_push(at) = t->to;
    array_free(&place);
    free(own);
}

static void map_curve(const struct map *m, struct nurbs_curve *c, double *rough)
{
    struct mapped_curve from = {m, c};
    struct doubles at = {0};
    double off;
    kinks_of(&from, &at);
    struct nurbs_curve to = approximate_curve(mapped_point, &from, at.item, at.n - 1, NEAR, &off);
    *rough = fmax(*rough, off);
    for (size_t i = 0; i < to.t.poles; i++) {
        to.pole[i].wx /= m->mm_u;
        to.pole[i].wy /= m->mm_v;
    }
    array_free(&at);
    nurbs_curve_free(c);
    *c = to;
}

/* The length of the longest line of poles along u, or along v, for one of the parameter. */
static double mm_for_one(const struct nurbs *s, bool along_u)
{
    size_t nu = s->u.poles, n = along_u ? nu : s->v.poles, lines = along_u ? s->v.poles : nu;
    double most = 0;
    for (size_t line = 0; line < lines; line++) {
        double length = 0;
        struct vec3 last = {0, 0, 0};
        for (size_t i = 0; i < n; i++) {
            const struct nurbs_pole *p = &s->pole[along_u ? line * nu + i : i * nu + line];
            struct vec3 q = vec_scale(1 / p->w, vec(p->wx, p->wy, p->wz));
            length += i > 0 ? vec_distance(q, last) : 0;
            last = q;
        }
        most = fmax(most, length);
    }
    const struct nurbs_axis *a = along_u ? &s->u : &s->v;
    return fmax(most, 1e-6) / (a->to - a->from);
}

/* The surface that offsets are made of, and its curve. */
static int read_map(const struct iges *iges, const struct iges_entity *e, struct map *m,
                    struct error *error)
{
    const struct iges_entity *base, *unknown;
    struct iges_values v;
    m->type = e->type;
    if (e->type != 118 && e->type != 120 && e->type != 122 && e->type != 140)
        return 1; /* a spline's parameters are its own */
    if (e->type == 118) {
        int got = iges_ruled_read(iges, e, m->side, error);
        return got == 0 && !iges_ruled_exact(m->side) ? 1
                                                      : got; /* approximated: these parameters */
    }
    if (iges_values(iges, e, &v, error) < 0)
        return -1;
    int status = iges_pointer(iges, &v, e->type == 140 ? 5 : e->type == 120 ? 2 : 1, &base, error);
    array_free(&v);
    if (status < 0 || e->type == 140)
        return status < 0 ? -1 : base->type == 140 ? 1 : read_map(iges, base, m, error);
    return iges_curve_ranges(iges, base, &m->base, &m->range, &unknown, error);
}

/* ---- what tells the side */

/* The whole turns that bring what lies between low and high nearest to the middle of a range. */
static double turns_to(double from, double to, double low, double high)
{
    const double turn = 2 * M_PI;
    return turn * floor((from + to - low - high) / 2 / turn + 0.5);
}

/* By how much the loops that tell the side are moved: files count an arc's angle from another turn
 * than the arc. */
static struct uv told_shift(const struct map *m, const struct patch *patch)
{
    struct uv low = {HUGE_VAL, HUGE_VAL}, high = {-HUGE_VAL, -HUGE_VAL}, shift = {0, 0};
    const struct nurbs *s = m->surface;
    if (m->type != 120)
        return shift;
    for (size_t i = 0; i < patch->told.n; i++)
        for (size_t k = 0; k < patch->told.item[i].n; k++) {
            const struct nurbs_curve *c = &patch->told.item[i].item[k];
            for (int j = 0; j <= LOOKS; j++) {
                double t = c->t.from + (c->t.to - c->t.from) * j / LOOKS;
                struct vec3 at = nurbs_curve_point(c, t);
                low = (struct uv){fmin(low.u, at.x), fmin(low.v, at.y)};
                high = (struct uv){fmax(high.u, at.x), fmax(high.v, at.y)};
            }
        }
    const struct iges_range *first = m->range.item, *last = first + m->range.n - 1;
    if (first->angle && last->angle)
        shift.u = turns_to(first->from, last->to, low.u, high.u);
    shift.v = turns_to(s->u.from, s->u.to, low.v, high.v);
    return shift;
}

/* A curve of those as a line through places of it in the parameters of the surface. */
static void tell_curve(const struct map *m, bool own, struct uv shift, struct nurbs_curve *c)
{
    size_t spans = c->t.poles - (size_t)c->t.degree, n = spans * LOOKS + 1;
    struct nurbs_curve to = patch_curve(1, n);
    for (size_t i = 0; i < n; i++) {
        double part = (double)i / (double)(n - 1);
        struct vec3 p = nurbs_curve_point(c, c->t.from + (c->t.to - c->t.from) * part);
        struct uv at = {p.x, p.y};
        if (!own)
            at = mapped(m, p.x + shift.u, p.y + shift.v);
        to.t.knot[i + 1] = part;
        to.pole[i] = (struct nurbs_pole){at.u, at.v, 0, 1};
    }
    nurbs_curve_free(c);
    *c = to;
}

static void tell_curves(const struct map *m, bool own, struct patch *patch)
{
    struct uv shift = own ? (struct uv){0, 0} : told_shift(m, patch);
    for (size_t i = 0; i < patch->told.n; i++)
        for (size_t k = 0; k < patch->told.item[i].n; k++)
            tell_curve(m, own, shift, &patch->told.item[i].item[k]);
}

int iges_parameters(const struct iges *iges, const struct iges_entity *surface, struct patch *patch,
                    struct error *error)
{
    struct map m = {.surface = &patch->surface};
    bool any = patch->told.n > 0;
    for (size_t i = 0; i < patch->loop.n; i++)
        any = any || !patch->loop.item[i].space;
    if (!any)
        return 0;
    m.mm_u = mm_for_one(&patch->surface, true);
    m.mm_v = mm_for_one(&patch->surface, false);
    int got = read_map(iges, surface, &m, error);
    for (size_t i = 0; i < patch->loop.n && got == 0; i++) {
        struct patch_loop *l = &patch->loop.item[i];
        for (size_t k = 0; k < l->n && !l->space; k++)
            map_curve(&m, &l->item[k], &l->rough);
    }
    if (got >= 0)
        tell_curves(&m, got > 0, patch);
    patch_loop_free(&m.base);
    array_free(&m.range);
    iges_ruled_free(m.side);
    return got < 0 ? -1 : 0;
}
