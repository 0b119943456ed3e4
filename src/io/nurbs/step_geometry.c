/* step_geometry - see step_geometry.h. */
#include "step_geometry.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "nurbs/construct.h"
#include "nurbs/primitive.h"

enum { DEPTH_MAX = 20 }; /* curves of curves */

/* mm: points so near are one. */
static const double NEAR = 1e-6;

/* What a reader of one kind of curve or surface works on. */
struct source {
    const struct step_place *place;
    const struct step_values *v;
    const struct step_value *record; /* of the kind; its attributes from `first` on are its own */
    const struct vec3 *ends;
    const struct vec3s *points;
    struct patch_loop *loop;
    struct nurbs *surface;
    int depth;
};

static int refuse(const struct step *step, const struct step_values *v, const char *what,
                  struct error *error)
{
    return error_at(error, step->name, v->instance->line, "#%ld: %s", v->instance->id, what);
}

int step_follow(const struct step *step, const struct step_values *from,
                const struct step_value *reference, struct step_values *to, struct error *error)
{
    const struct step_instance *i = NULL;
    if (!reference || reference->kind != STEP_REFERENCE)
        return refuse(step, from, "no reference where one belongs, expected # and a number", error);
    i = step_find(step, (long)reference->number);
    if (!i)
        return error_at(error, step->name, from->instance->line,
                        "#%ld refers to #%.0f, expected an instance that there is",
                        from->instance->id, reference->number);
    return step_values(step, i, to, error);
}

static int number_of(const struct step *step, const struct step_values *v,
                     const struct step_value *value, double most, double *number,
                     struct error *error)
{
    /* a number may be wrapped: LENGTH_MEASURE(5.) */
    if (value && value->kind == STEP_RECORD)
        value = step_item(value, 0);
    if (!value || value->kind != STEP_NUMBER || !(fabs(value->number) <= most))
        return refuse(step, v, "no number, or one too large, where one belongs, expected it",
                      error);
    *number = value->number;
    return 0;
}

/* The coordinates of a CARTESIAN_POINT or the ratios of a DIRECTION. */
static int read_coordinates(const struct step *step, const struct step_values *from,
                            const struct step_value *reference, const char *name, struct vec3 *to,
                            struct error *error)
{
    struct step_values v = {0};
    double x[3] = {0, 0, 0};
    if (step_follow(step, from, reference, &v, error) < 0)
        return -1;
    const struct step_value *record = step_record(&v, name), *list = step_item(record, 1);
    int status = 0;
    if (!list || list->kind != STEP_LIST || list->size < 3)
        status = error_at(error, step->name, v.instance->line, "#%ld: no %s, expected one",
                          v.instance->id, name);
    const struct step_value *item = step_item(list, 0);
    for (size_t i = 0; i < 3 && item && status == 0; i++, item = step_next(list, item))
        status = number_of(step, &v, item, 1e12, &x[i], error);
    array_free(&v);
    *to = vec(x[0], x[1], x[2]);
    return status;
}

int step_axes(const struct step *step, const struct step_values *from,
              const struct step_value *reference, struct transform *axes, struct error *error)
{
    struct step_values v = {0};
    struct vec3 at = {0, 0, 0}, z = {0, 0, 1}, x = {1, 0, 0};
    if (step_follow(step, from, reference, &v, error) < 0)
        return -1;
    const struct step_value *r = step_record(&v, "AXIS2_PLACEMENT_3D");
    if (!r)
        r = step_record(&v, "AXIS1_PLACEMENT");
    const struct step_value *axis = step_item(r, 2), *ref = step_item(r, 3);
    int status = r ? read_coordinates(step, &v, step_item(r, 1), "CARTESIAN_POINT", &at, error)
                   : refuse(step, &v, "no axis placement, expected one", error);
    if (status == 0 && axis && axis->kind == STEP_REFERENCE)
        status = read_coordinates(step, &v, axis, "DIRECTION", &z, error);
    if (status == 0 && ref && ref->kind == STEP_REFERENCE)
        status = read_coordinates(step, &v, ref, "DIRECTION", &x, error);
    array_free(&v);
    *axes = construct_place(at, z, x);
    return status;
}

static struct vec3 column(const struct transform *t, int k)
{
    return vec(t->m[0][k], t->m[1][k], t->m[2][k]);
}

/* The same in mm and placed: axes are perpendicular unit vectors again. */
static int placed_axes(const struct source *s, const struct step_value *reference,
                       struct transform *axes, struct error *error)
{
    if (step_axes(s->place->step, s->v, reference, axes, error) < 0)
        return -1;
    struct transform t = transform_product(s->place->to, *axes);
    *axes = construct_place(column(&t, 3), column(&t, 2), column(&t, 0));
    return 0;
}

static int point_at(const struct source *s, const struct step_value *reference, struct vec3 *point,
                    struct error *error)
{
    if (read_coordinates(s->place->step, s->v, reference, "CARTESIAN_POINT", point, error) < 0)
        return -1;
    *point = transform_point(&s->place->to, *point);
    return 0;
}

int step_vertex(const struct step_place *place, const struct step_values *from,
                const struct step_value *reference, struct vec3 *point, struct error *error)
{
    struct step_values v = {0};
    if (step_follow(place->step, from, reference, &v, error) < 0)
        return -1;
    struct source s = {.place = place, .v = &v};
    const struct step_value *r = step_record(&v, "VERTEX_POINT");
    struct source self = {.place = place, .v = from};
    int status =
        r ? point_at(&s, step_item(r, 1), point, error) : point_at(&self, reference, point, error);
    array_free(&v);
    return status;
}

/* A VECTOR, of unit length in the file, to mm. */
static int vector_at(const struct source *s, const struct step_value *reference, struct vec3 *to,
                     struct error *error)
{
    struct step_values v = {0};
    *to = vec(0, 0, 0);
    if (step_follow(s->place->step, s->v, reference, &v, error) < 0)
        return -1;
    const struct step_value *r = step_record(&v, "VECTOR");
    int status = r ? read_coordinates(s->place->step, &v, step_item(r, 1), "DIRECTION", to, error)
                   : refuse(s->place->step, &v, "no VECTOR, expected one", error);
    array_free(&v);
    if (status < 0)
        return status;
    struct vec3 zero = transform_point(&s->place->to, vec(0, 0, 0));
    *to = vec_unit(vec_sub(transform_point(&s->place->to, *to), zero));
    if (!(vec_length(*to) > 0))
        status = refuse(s->place->step, s->v, "a direction of no length, expected one", error);
    return status;
}

/* ---- splines */

/* The attributes of a spline, whether it is one record or several. */
struct spline {
    const struct step_value *poles, *weights;
    const struct step_value *degree[2], *multiplicity[2], *knots[2];
    bool uniform, bezier;
};

static size_t list_length(const struct step_value *list)
{
    size_t n = 0;
    for (const struct step_value *i = step_item(list, 0); i; i = step_next(list, i))
        n++;
    return n;
}

/* `surface`: two degrees, two lists of knots.  False when it is no spline. */
static bool find_spline(const struct step_values *v, bool surface, struct spline *s)
{
    static const char *const kind[2][5] = {
        {"B_SPLINE_CURVE_WITH_KNOTS", "BEZIER_CURVE", "QUASI_UNIFORM_CURVE", "UNIFORM_CURVE",
         "B_SPLINE_CURVE"},
        {"B_SPLINE_SURFACE_WITH_KNOTS", "BEZIER_SURFACE", "QUASI_UNIFORM_SURFACE",
         "UNIFORM_SURFACE", "B_SPLINE_SURFACE"}};
    const struct step_value *base = step_record(v, kind[surface][4]), *own = NULL;
    size_t n = surface ? 2 : 1;
    int which = 0;
    for (which = 0; which < 4 && !own; which++)
        own = step_record(v, kind[surface][which]);
    which -= own != NULL;
    *s = (struct spline){.uniform = which == 3, .bezier = which == 1};
    if (!own)
        return false;
    size_t first = base ? 0 : 1;
    const struct step_value *from = base ? base : own;
    for (size_t i = 0; i < n; i++)
        s->degree[i] = step_item(from, first + i);
    s->poles = step_item(from, first + n);
    size_t knots = base ? 0 : first + n + (surface ? 5 : 4);
    for (size_t i = 0; i < n && which == 0; i++) {
        s->multiplicity[i] = step_item(own, knots + i);
        s->knots[i] = step_item(own, knots + n + i);
    }
    const struct step_value *rational =
        step_record(v, surface ? "RATIONAL_B_SPLINE_SURFACE" : "RATIONAL_B_SPLINE_CURVE");
    s->weights = step_item(rational, 0);
    return true;
}

/* Knots that the kind of spline implies. */
static void implied_knots(const struct spline *s, struct nurbs_axis *a)
{
    size_t p = (size_t)a->degree;
    for (size_t i = 0; i < a->poles + p + 1; i++) {
        double x = (double)i - (double)p;
        double inner = s->bezier ? ceil(x / (double)p) : x;
        double last =
            s->bezier ? ceil((double)(a->poles - p) / (double)p) : (double)a->poles - (double)p;
        a->knot[i] = s->uniform ? x : fmin(fmax(inner, 0), last);
    }
}

static int spline_axis(const struct source *s, const struct spline *sp, int k, size_t poles,
                       struct nurbs_axis *a, struct error *error)
{
    const struct step *step = s->place->step;
    double degree = 0, times = 0, knot = 0;
    struct error why;
    if (number_of(step, s->v, sp->degree[k], 1e6, &degree, error) < 0)
        return -1;
    if (!(degree >= 1 && degree <= NURBS_DEGREE_MAX) || poles < (size_t)degree + 1)
        return refuse(step, s->v, "a degree that is not 1 to 25, or fewer poles than it needs",
                      error);
    *a = (struct nurbs_axis){.degree = (int)degree, .poles = poles};
    size_t n = poles + (size_t)degree + 1, at = 0;
    a->knot = mem_alloc(n, sizeof *a->knot);
    a->from = -HUGE_VAL;
    a->to = HUGE_VAL;
    if (!sp->knots[k]) {
        implied_knots(sp, a);
        at = n;
    }
    const struct step_value *m = step_item(sp->multiplicity[k], 0);
    const struct step_value *x = step_item(sp->knots[k], 0);
    for (; m && x; m = step_next(sp->multiplicity[k], m), x = step_next(sp->knots[k], x)) {
        if (number_of(step, s->v, m, 1e6, &times, error) < 0 ||
            number_of(step, s->v, x, NURBS_LARGEST, &knot, error) < 0)
            return -1;
        for (double i = 0; i < times && at <= n; i++, at++)
            if (at < n)
                a->knot[at] = knot;
    }
    if (at != n || m || x)
        return refuse(step, s->v, "multiplicities of knots that do not fit poles and degree",
                      error);
    if (nurbs_axis_check(a, k == 0 ? "u" : "v", &why) < 0)
        return refuse(step, s->v, why.text, error);
    return 0;
}

/* One row of poles with their weights, `step` apart. */
static int read_poles(const struct source *s, const struct step_value *list,
                      const struct step_value *weights, struct nurbs_pole *pole, size_t apart,
                      size_t n, struct error *error)
{
    const struct step_value *w = weights ? step_item(weights, 0) : NULL, *p = step_item(list, 0);
    for (size_t i = 0; i < n; i++, p = p ? step_next(list, p) : NULL) {
        struct vec3 at;
        double weight = 1;
        if (weights && number_of(s->place->step, s->v, w, NURBS_LARGEST, &weight, error) < 0)
            return -1;
        w = w ? step_next(weights, w) : NULL;
        if (!(weight > 0))
            return refuse(s->place->step, s->v, "a weight that is not positive, expected positive",
                          error);
        if (point_at(s, p, &at, error) < 0)
            return -1;
        pole[i * apart] = (struct nurbs_pole){weight * at.x, weight * at.y, weight * at.z, weight};
    }
    return 0;
}

static int spline_curve(const struct source *s, const struct spline *sp, struct nurbs_curve *c,
                        struct error *error)
{
    size_t n = list_length(sp->poles);
    if (spline_axis(s, sp, 0, n, &c->t, error) < 0)
        return -1;
    c->pole = mem_alloc(n, sizeof *c->pole);
    return read_poles(s, sp->poles, sp->weights, c->pole, 1, n, error);
}

/* Rows of poles of one u each. */
static int spline_surface(const struct source *s, const struct spline *sp, struct error *error)
{
    struct nurbs *surface = s->surface;
    const struct step_value *row = step_item(sp->poles, 0);
    const struct step_value *w = sp->weights ? step_item(sp->weights, 0) : NULL;
    size_t nu = list_length(sp->poles), nv = list_length(row), i = 0;
    if (spline_axis(s, sp, 0, nu, &surface->u, error) < 0 ||
        spline_axis(s, sp, 1, nv, &surface->v, error) < 0)
        return -1;
    surface->pole = mem_alloc(nu * nv, sizeof *surface->pole);
    for (; row; row = step_next(sp->poles, row), i++) {
        if (list_length(row) != nv)
            return refuse(s->place->step, s->v, "rows of poles of different lengths", error);
        if (read_poles(s, row, sp->weights ? w : NULL, surface->pole + i, nu, nv, error) < 0)
            return -1;
        w = w ? step_next(sp->weights, w) : NULL;
        if (sp->weights && !w && i + 1 < nu)
            return refuse(s->place->step, s->v, "fewer weights than poles", error);
    }
    return 0;
}

/* ---- curves */

static int curve_of(const struct step_place *place, const struct step_values *from,
                    const struct step_value *reference, const struct vec3 *ends, int depth,
                    struct patch_loop *loop, struct error *error);

/* The part of a curve between its ends: one piece, or two where it goes on over its seam. */
static void push_part(const struct source *s, struct nurbs_curve c)
{
    if (s->ends) {
        double from = c.t.from, to = c.t.to;
        double low = nurbs_curve_foot(&c, s->ends[0]), high = nurbs_curve_foot(&c, s->ends[1]);
        if (vec_distance(nurbs_curve_point(&c, from), s->ends[0]) <= NEAR)
            low = from;
        if (vec_distance(nurbs_curve_point(&c, to), s->ends[1]) <= NEAR)
            high = to;
        if (!(low < high)) { /* over the seam of a closed curve */
            struct nurbs_curve first = construct_refined(&c, c.t.degree, NULL, 0);
            first.t.from = low;
            if (low < to)
                *array_push(s->loop) = construct_refined(&first, c.t.degree, NULL, 0);
            nurbs_curve_free(&first);
            low = from;
        }
        c.t.from = low;
        c.t.to = high;
        if (!(low < high)) {
            nurbs_curve_free(&c);
            return;
        }
    }
    *array_push(s->loop) = c;
}

static struct vec3 to_local(const struct transform *t, struct vec3 p)
{
    struct vec3 d = vec_sub(p, column(t, 3));
    return vec(vec_dot(d, column(t, 0)), vec_dot(d, column(t, 1)), vec_dot(d, column(t, 2)));
}

/* CIRCLE, ELLIPSE, HYPERBOLA, PARABOLA: axes, then one or two lengths. */
static int read_conic(const struct source *s, const char *kind, struct error *error)
{
    struct transform t;
    double a, b = 0, from = 0, to = 2 * PI, t0[2] = {0, 0};
    bool two = kind[0] == 'E' || kind[0] == 'H';
    if (placed_axes(s, step_item(s->record, 1), &t, error) < 0 ||
        number_of(s->place->step, s->v, step_item(s->record, 2), 1e12, &a, error) < 0 ||
        (two && number_of(s->place->step, s->v, step_item(s->record, 3), 1e12, &b, error) < 0))
        return -1;
    a *= s->place->mm;
    b = two ? b * s->place->mm : a;
    if (!(a > 0 && b > 0))
        return refuse(s->place->step, s->v, "a radius that is not positive, expected one", error);
    bool open = kind[0] == 'H' || kind[0] == 'P';
    if (open && !s->ends)
        return 1;
    for (int i = 0; i < 2 && s->ends; i++) {
        struct vec3 p = to_local(&t, s->ends[i]);
        t0[i] = kind[0] == 'H'   ? asinh(p.y / b)
                : kind[0] == 'P' ? p.y / (2 * a)
                                 : atan2(p.y / b, p.x / a);
    }
    if (s->ends) {
        from = t0[0];
        to = t0[1];
        bool whole = vec_distance(s->ends[0], s->ends[1]) <= NEAR;
        if (!open && whole)
            to = from + 2 * PI;
        else if (!open && to <= from)
            to += 2 * PI;
    }
    if (!(to > from))
        return refuse(s->place->step, s->v, "an edge that runs against its curve", error);
    *array_push(s->loop) = kind[0] == 'H'   ? construct_hyperbola(&t, a, b, from, to)
                           : kind[0] == 'P' ? construct_parabola(&t, a, from, to)
                                            : construct_ellipse(&t, a, b, from, to);
    return 0;
}

static int read_polyline(const struct source *s, struct error *error)
{
    const struct step_value *list = step_item(s->record, 1), *i = step_item(list, 0);
    struct vec3s point = {0};
    int status = 0;
    for (; i && status == 0; i = step_next(list, i))
        status = point_at(s, i, array_push(&point), error);
    if (status == 0 && point.n < 2)
        status = refuse(s->place->step, s->v, "a polyline of less than two points", error);
    if (status == 0)
        push_part(s, construct_polyline(point.item, point.n));
    array_free(&point);
    return status;
}

static int known_curve(const struct source *from, struct error *error)
{
    static const char *const conics[] = {"CIRCLE", "ELLIPSE", "HYPERBOLA", "PARABOLA"};
    static const char *const others[] = {"SURFACE_CURVE", "SEAM_CURVE", "INTERSECTION_CURVE",
                                         "TRIMMED_CURVE"};
    struct source s = *from;
    struct spline sp;
    if ((s.record = step_record(s.v, "LINE"))) {
        if (s.ends)
            *array_push(s.loop) = construct_line(s.ends[0], s.ends[1]);
        return s.ends ? 0 : 1;
    }
    for (size_t i = 0; i < 4; i++)
        if ((s.record = step_record(s.v, conics[i])))
            return read_conic(&s, conics[i], error);
    for (size_t i = 0; i < 4; i++)
        if ((s.record = step_record(s.v, others[i])))
            return curve_of(s.place, s.v, step_item(s.record, 1), s.ends, s.depth + 1, s.loop,
                            error);
    if ((s.record = step_record(s.v, "POLYLINE")))
        return read_polyline(&s, error);
    if (find_spline(s.v, false, &sp)) {
        struct nurbs_curve c = {{0}, NULL};
        if (spline_curve(&s, &sp, &c, error) < 0) {
            nurbs_curve_free(&c);
            return -1;
        }
        push_part(&s, c);
        return 0;
    }
    return 1;
}

static int curve_of(const struct step_place *place, const struct step_values *from,
                    const struct step_value *reference, const struct vec3 *ends, int depth,
                    struct patch_loop *loop, struct error *error)
{
    struct step_values v = {0};
    if (depth > DEPTH_MAX)
        return refuse(place->step, from, "curves of curves without end, expected simple ones",
                      error);
    if (step_follow(place->step, from, reference, &v, error) < 0)
        return -1;
    struct source s = {.place = place, .v = &v, .ends = ends, .loop = loop, .depth = depth};
    int got = known_curve(&s, error);
    array_free(&v);
    return got;
}

int step_curve(const struct step_place *place, const struct step_values *from,
               const struct step_value *reference, const struct vec3 *ends, struct patch_loop *loop,
               struct error *error)
{
    return curve_of(place, from, reference, ends, 0, loop, error);
}

/* ---- surfaces */

/* PLANE and the surfaces about an axis: axes, then none, one or two numbers. */
static int read_primitive(const struct source *s, enum primitive_kind kind, struct error *error)
{
    struct primitive p = {.kind = kind};
    const struct step *step = s->place->step;
    bool one = kind != PRIMITIVE_PLANE, two = kind == PRIMITIVE_CONE || kind == PRIMITIVE_TORUS;
    if (placed_axes(s, step_item(s->record, 1), &p.place, error) < 0 ||
        (one && number_of(step, s->v, step_item(s->record, 2), 1e12, &p.radius, error) < 0) ||
        (two && number_of(step, s->v, step_item(s->record, 3), 1e12, &p.other, error) < 0))
        return -1;
    p.radius *= s->place->mm;
    p.other *= kind == PRIMITIVE_CONE ? s->place->angle : s->place->mm;
    if (primitive_surface(&p, s->points, s->surface) < 0)
        return refuse(step, s->v, "a surface of no size, or without edges, expected some", error);
    return 0;
}

/* A whole curve, or a line that reaches from one parameter to another. */
static int read_profile(const struct source *s, struct nurbs_curve *c, struct error *error)
{
    struct patch_loop loop = {0};
    int got = curve_of(s->place, s->v, step_item(s->record, 1), NULL, 0, &loop, error);
    if (got == 0) {
        *c = loop.item[0];
        loop.n = 0;
    }
    patch_loop_free(&loop);
    return got;
}

/* A line as a profile: its point and unit direction; false when it is no line. */
static bool line_profile(const struct source *s, struct vec3 *at, struct vec3 *along)
{
    struct step_values v = {0};
    struct error ignored;
    if (step_follow(s->place->step, s->v, step_item(s->record, 1), &v, &ignored) < 0)
        return false;
    struct source line = {.place = s->place, .v = &v, .record = step_record(&v, "LINE")};
    bool got = line.record && point_at(&line, step_item(line.record, 1), at, &ignored) == 0 &&
               vector_at(&line, step_item(line.record, 2), along, &ignored) == 0;
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

static int read_extrusion(const struct source *s, struct error *error)
{
    struct vec3 along, at, line;
    struct nurbs_curve c = {{0}, NULL};
    double low, high, first, last;
    if (vector_at(s, step_item(s->record, 2), &along, error) < 0)
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

static int read_revolution(const struct source *s, struct error *error)
{
    struct transform axes;
    struct vec3 at, line;
    struct nurbs_curve c = {{0}, NULL};
    if (placed_axes(s, step_item(s->record, 2), &axes, error) < 0)
        return -1;
    struct vec3 axis = column(&axes, 2), middle = column(&axes, 3);
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

static int known_surface(const struct source *from, struct error *error)
{
    static const char *const primitives[] = {"PLANE", "CYLINDRICAL_SURFACE", "CONICAL_SURFACE",
                                             "SPHERICAL_SURFACE", "TOROIDAL_SURFACE"};
    struct source s = *from;
    struct spline sp;
    for (size_t i = 0; i < 5; i++)
        if ((s.record = step_record(s.v, primitives[i])))
            return read_primitive(&s, (enum primitive_kind)i, error);
    if ((s.record = step_record(s.v, "SURFACE_OF_LINEAR_EXTRUSION")))
        return read_extrusion(&s, error);
    if ((s.record = step_record(s.v, "SURFACE_OF_REVOLUTION")))
        return read_revolution(&s, error);
    if ((s.record = step_record(s.v, "RECTANGULAR_TRIMMED_SURFACE")) && s.depth < DEPTH_MAX) {
        struct step_values v = {0};
        if (step_follow(s.place->step, s.v, step_item(s.record, 1), &v, error) < 0)
            return -1;
        struct source basis = s;
        basis.v = &v;
        basis.depth++;
        int got = known_surface(&basis, error);
        array_free(&v);
        return got;
    }
    return find_spline(s.v, true, &sp) ? spline_surface(&s, &sp, error) : 1;
}

int step_surface(const struct step_place *place, const struct step_values *from,
                 const struct step_value *reference, const struct vec3s *points,
                 struct nurbs *surface, char kind[40], struct error *error)
{
    struct step_values v = {0};
    if (step_follow(place->step, from, reference, &v, error) < 0)
        return -1;
    struct source s = {.place = place, .v = &v, .points = points, .surface = surface};
    int got = known_surface(&s, error);
    const struct step_value *name = step_item(v.item, 0);
    snprintf(kind, 40, "%.*s", name ? (int)fmin((double)name->length, 39) : 0,
             name ? name->text : "");
    array_free(&v);
    return got;
}
