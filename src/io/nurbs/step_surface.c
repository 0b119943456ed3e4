/* step_surface - see step_geometry.h. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "nurbs/approximate.h"
#include "nurbs/construct.h"
#include "step_source.h"

int step_primitive(const struct step_source *from, struct primitive *p, struct error *error)
{
    static const char *const name[] = {"PLANE",
                                       "CYLINDRICAL_SURFACE",
                                       "CONICAL_SURFACE",
                                       "SPHERICAL_SURFACE",
                                       "TOROIDAL_SURFACE",
                                       "DEGENERATE_TOROIDAL_SURFACE"};
    struct step_source s = *from;
    const struct step *step = s.place->step;
    size_t i = 0;
    while (i < 6 && !(s.record = step_record(s.v, name[i])))
        i++;
    if (i == 6)
        return 1;
    *p = (struct primitive){.kind = (enum primitive_kind)(i < 5 ? i : PRIMITIVE_TORUS)};
    bool one = i > 0, two = p->kind == PRIMITIVE_CONE || p->kind == PRIMITIVE_TORUS;
    if (step_placed_axes(&s, step_own(s.v, s.record, 1), &p->place, error) < 0 ||
        (one && step_number(step, s.v, step_own(s.v, s.record, 2), 1e12, &p->radius, error) < 0) ||
        (two && step_number(step, s.v, step_own(s.v, s.record, 3), 1e12, &p->other, error) < 0))
        return -1;
    p->radius *= s.place->mm;
    p->other *= p->kind == PRIMITIVE_CONE ? s.place->angle : s.place->mm;
    if (i == 5)
        p->part = step_is(step_own(s.v, s.record, 4), "F") ? PRIMITIVE_INNER : PRIMITIVE_OUTER;
    return 0;
}

static int make_primitive(const struct step_source *s, const struct primitive *p,
                          struct error *error)
{
    if (primitive_surface(p, s->points, s->surface) < 0)
        return step_refuse(s->place->step, s->v,
                           "a surface of no size, or without edges, expected some", error);
    return 0;
}

/* A whole curve, or a line that reaches from one parameter to another. */
static int read_profile(const struct step_source *s, struct nurbs_curve *c, struct error *error)
{
    struct patch_loop loop = {0};
    int got = step_curve_of(s->place, s->v, step_own(s->v, s->record, 1), NULL, 0, &loop, error);
    if (got == 0) {
        *c = loop.item[0];
        loop.n = 0;
        *s->rough = fmax(*s->rough, loop.rough);
    }
    patch_loop_free(&loop);
    return got;
}

/* A line as a profile: its point and unit direction; false when it is no line. */
static bool line_profile(const struct step_source *s, struct vec3 *at, struct vec3 *along)
{
    struct step_values v = {0};
    struct error ignored;
    if (step_follow(s->place->step, s->v, step_own(s->v, s->record, 1), &v, &ignored) < 0)
        return false;
    struct step_source line = {.place = s->place, .v = &v, .record = step_record(&v, "LINE")};
    bool got = line.record &&
               step_point(&line, step_own(line.v, line.record, 1), at, &ignored) == 0 &&
               step_direction(&line, step_own(line.v, line.record, 2), along, NULL, &ignored) == 0;
    array_free(&v);
    return got;
}

/* How far points reach along a unit direction. */
static void extent_along(const struct vec3s *points, struct vec3 along, double *low, double *high)
{
    *low = HUGE_VAL;
    *high = -HUGE_VAL;
    for (size_t i = 0; i < points->n; i++) {
        double x = vec_dot(points->item[i], along);
        *low = fmin(*low, x);
        *high = fmax(*high, x);
    }
}

static int read_extrusion(const struct step_source *s, struct error *error)
{
    struct vec3 along, at, line;
    struct nurbs_curve c = {{0}, NULL};
    double low, high, first, last;
    if (step_direction(s, step_own(s->v, s->record, 2), &along, NULL, error) < 0)
        return -1;
    if (line_profile(s, &at, &line)) {
        struct primitive p = {.kind = PRIMITIVE_PLANE};
        p.place = construct_place(at, vec_cross(line, along), line);
        return primitive_surface(&p, s->points, s->surface) < 0 ? 1 : 0;
    }
    int got = read_profile(s, &c, error);
    if (got != 0 || s->points->n == 0) {
        nurbs_curve_free(&c);
        return got != 0 ? got : 1;
    }
    struct vec3s poles = {0};
    for (size_t i = 0; i < c.t.poles; i++)
        *array_push(&poles) =
            vec_scale(1 / c.pole[i].w, vec(c.pole[i].wx, c.pole[i].wy, c.pole[i].wz));
    extent_along(s->points, along, &low, &high);
    extent_along(&poles, along, &first, &last);
    double margin = 0.01 * (high - low + last - first);
    low -= last + margin;
    high += margin - first;
    struct transform shift = transform_shift(vec_scale(low, along));
    construct_move(&shift, c.pole, c.t.poles);
    *s->surface = construct_extrusion(&c, vec_scale(high - low, along));
    array_free(&poles);
    nurbs_curve_free(&c);
    return 0;
}

static int read_revolution(const struct step_source *s, struct error *error)
{
    struct transform axes;
    struct vec3 at, line;
    struct nurbs_curve c = {{0}, NULL};
    if (step_placed_axes(s, step_own(s->v, s->record, 2), &axes, error) < 0)
        return -1;
    struct vec3 axis = step_axis(&axes, 2), middle = step_axis(&axes, 3);
    int got = 0;
    if (line_profile(s, &at, &line)) {
        double low, high, up = vec_dot(line, axis), height = vec_dot(at, axis);
        extent_along(s->points, axis, &low, &high);
        if (fabs(up) < 1e-6 || s->points->n == 0)
            return 1;
        double margin = 0.01 * (high - low);
        double a = (low - margin - height) / up, b = (high + margin - height) / up;
        c = construct_line(vec_along(at, fmin(a, b), line), vec_along(at, fmax(a, b), line));
    } else {
        got = read_profile(s, &c, error);
    }
    if (got == 0)
        *s->surface = construct_revolution(&c, middle, axis, 0, 2 * PI);
    nurbs_curve_free(&c);
    return got;
}

static int known_surface(const struct step_source *from, struct error *error);

/* The surface that another one is made of. */
static int read_basis(const struct step_source *s, struct error *error)
{
    struct step_values v = {0};
    if (s->depth > STEP_DEPTH_MAX)
        return step_refuse(s->place->step, s->v, "surfaces of surfaces without end", error);
    if (step_follow(s->place->step, s->v, step_own(s->v, s->record, 1), &v, error) < 0)
        return -1;
    struct step_source basis = *s;
    basis.v = &v;
    basis.depth++;
    int got = known_surface(&basis, error);
    array_free(&v);
    return got;
}

/* OFFSET_SURFACE: basis, distance along its normal.  One of a primitive is a primitive. */
static int read_offset(const struct step_source *s, struct error *error)
{
    struct primitive p;
    struct step_values v = {0};
    double distance;
    if (step_number(s->place->step, s->v, step_own(s->v, s->record, 2), 1e12, &distance, error) <
            0 ||
        step_follow(s->place->step, s->v, step_own(s->v, s->record, 1), &v, error) < 0)
        return -1;
    distance *= s->place->mm;
    struct step_source basis = *s;
    basis.v = &v;
    int got = step_primitive(&basis, &p, error);
    array_free(&v);
    if (got == 0 && primitive_offset(&p, distance) == 0)
        return make_primitive(s, &p, error);
    if (got >= 0)
        got = read_basis(s, error);
    if (got == 0) {
        struct nurbs base = *s->surface;
        double off = 0;
        *s->surface = approximate_offset(&base, distance, &off);
        *s->rough = fmax(*s->rough, off);
        nurbs_free(&base);
    }
    return got;
}

static int known_surface(const struct step_source *from, struct error *error)
{
    struct step_source s = *from;
    struct primitive p;
    struct step_spline sp;
    int got = step_primitive(&s, &p, error);
    if (got <= 0)
        return got < 0 ? -1 : make_primitive(&s, &p, error);
    if ((s.record = step_record(s.v, "SURFACE_OF_LINEAR_EXTRUSION")))
        return read_extrusion(&s, error);
    if ((s.record = step_record(s.v, "SURFACE_OF_REVOLUTION")))
        return read_revolution(&s, error);
    if ((s.record = step_record(s.v, "OFFSET_SURFACE")))
        return read_offset(&s, error);
    if ((s.record = step_record(s.v, "RECTANGULAR_TRIMMED_SURFACE")) ||
        (s.record = step_record(s.v, "CURVE_BOUNDED_SURFACE")))
        return read_basis(&s, error);
    return step_find_spline(s.v, true, &sp) ? step_spline_surface(&s, &sp, error) : 1;
}

static int parametric_of(const struct step_place *place, const struct step_values *from,
                         const struct step_value *reference, int depth, struct step_parametric *to,
                         struct error *error);

/* The same of an OFFSET_SURFACE: its parameters are those of its basis. */
static int offset_parametric(const struct step_source *s, struct step_parametric *to,
                             struct error *error)
{
    double distance;
    if (s->depth > STEP_DEPTH_MAX)
        return step_refuse(s->place->step, s->v, "surfaces of surfaces without end", error);
    if (step_number(s->place->step, s->v, step_own(s->v, s->record, 2), 1e12, &distance, error) < 0)
        return -1;
    int got = parametric_of(s->place, s->v, step_own(s->v, s->record, 1), s->depth + 1, to, error);
    distance *= s->place->mm;
    if (got == 0 && to->is_primitive)
        return primitive_offset(&to->primitive, distance) < 0 ? 1 : 0;
    if (got == 0) {
        struct nurbs base = to->spline;
        double off = 0;
        to->spline = approximate_offset(&base, distance, &off);
        to->rough = fmax(to->rough, off);
        nurbs_free(&base);
    }
    return got;
}

static int parametric_of(const struct step_place *place, const struct step_values *from,
                         const struct step_value *reference, int depth, struct step_parametric *to,
                         struct error *error)
{
    struct step_values v = {0};
    struct step_spline sp;
    *to = (struct step_parametric){.u = 1, .v = 1};
    if (step_follow(place->step, from, reference, &v, error) < 0)
        return -1;
    struct step_source s = {
        .place = place, .v = &v, .surface = &to->spline, .rough = &to->rough, .depth = depth};
    int got = step_primitive(&s, &to->primitive, error);
    if (got == 0) {
        enum primitive_kind kind = to->primitive.kind;
        to->is_primitive = true;
        to->u = kind == PRIMITIVE_PLANE ? place->mm : place->angle;
        to->v = kind == PRIMITIVE_SPHERE || kind == PRIMITIVE_TORUS ? place->angle : place->mm;
    } else if (got > 0 && step_find_spline(&v, true, &sp)) {
        got = step_spline_surface(&s, &sp, error);
    } else if (got > 0 && (s.record = step_record(&v, "OFFSET_SURFACE"))) {
        got = offset_parametric(&s, to, error);
    }
    array_free(&v);
    return got;
}

int step_parametric(const struct step_place *place, const struct step_values *from,
                    const struct step_value *reference, struct step_parametric *to,
                    struct error *error)
{
    return parametric_of(place, from, reference, 0, to, error);
}

struct vec3 step_parametric_point(const struct step_parametric *s, double u, double v)
{
    if (s->is_primitive)
        return primitive_point(&s->primitive, s->u * u, s->v * v);
    const struct nurbs *n = &s->spline;
    return nurbs_point(
        n, (struct uv){fmin(fmax(u, n->u.from), n->u.to), fmin(fmax(v, n->v.from), n->v.to)});
}

struct rectangle_side {
    const struct step_parametric *on;
    double u, v, to_u, to_v;
};

static struct vec3 rectangle_point(const void *context, double t)
{
    const struct rectangle_side *r = context;
    return step_parametric_point(r->on, r->u + t * (r->to_u - r->u), r->v + t * (r->to_v - r->v));
}

int step_rectangle(const struct step_place *place, const struct step_values *v,
                   struct patch_loop *loop, struct error *error)
{
    static const double ends[2] = {0, 1};
    const struct step_value *r = step_record(v, "RECTANGULAR_TRIMMED_SURFACE");
    struct step_parametric on;
    double x[4];
    for (size_t i = 0; i < 4; i++)
        if (step_number(place->step, v, step_item(r, 2 + i), NURBS_LARGEST, &x[i], error) < 0)
            return -1;
    int got = step_parametric(place, v, step_item(r, 1), &on, error);
    for (int i = 0; i < 4 && got == 0; i++) {
        static const int corner[5][2] = {{0, 2}, {1, 2}, {1, 3}, {0, 3}, {0, 2}};
        struct rectangle_side side = {&on, x[corner[i][0]], x[corner[i][1]], x[corner[i + 1][0]],
                                      x[corner[i + 1][1]]};
        double off = 0;
        *array_push(loop) = approximate_curve(rectangle_point, &side, ends, 1, STEP_NEAR, &off);
        loop->rough = fmax(loop->rough, fmax(off, on.rough));
    }
    nurbs_free(&on.spline);
    loop->space = true;
    return got;
}

int step_surface(const struct step_place *place, const struct step_values *from,
                 const struct step_value *reference, const struct vec3s *points,
                 struct nurbs *surface, double *rough, char kind[40], struct error *error)
{
    struct step_values v = {0};
    if (step_follow(place->step, from, reference, &v, error) < 0)
        return -1;
    struct step_source s = {
        .place = place, .v = &v, .points = points, .surface = surface, .rough = rough};
    int got = known_surface(&s, error);
    const struct step_value *name = step_item(v.item, 0);
    snprintf(kind, 40, "%.*s", name ? (int)fmin((double)name->length, 39) : 0,
             name ? name->text : "");
    array_free(&v);
    return got;
}
