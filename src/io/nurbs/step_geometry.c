/* step_geometry - see step_geometry.h. */
#include "step_source.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "nurbs/construct.h"

int step_refuse(const struct step *step, const struct step_values *v, const char *what,
                struct error *error)
{
    return error_at(error, step->name, v->instance->line, "#%ld: %s", v->instance->id, what);
}

int step_follow(const struct step *step, const struct step_values *from,
                const struct step_value *reference, struct step_values *to, struct error *error)
{
    const struct step_instance *i = NULL;
    if (!reference || reference->kind != STEP_REFERENCE)
        return step_refuse(step, from, "no reference where one belongs, expected # and a number",
                           error);
    i = step_find(step, (long)reference->number);
    if (!i)
        return error_at(error, step->name, from->instance->line,
                        "#%ld refers to #%.0f, expected an instance that there is",
                        from->instance->id, reference->number);
    return step_values(step, i, to, error);
}

int step_number(const struct step *step, const struct step_values *v,
                const struct step_value *value, double most, double *number, struct error *error)
{
    /* a number may be wrapped: LENGTH_MEASURE(5.) */
    if (value && value->kind == STEP_RECORD)
        value = step_item(value, 0);
    if (!value || value->kind != STEP_NUMBER || !(fabs(value->number) <= most))
        return step_refuse(step, v, "no number, or one too large, where one belongs, expected it",
                           error);
    *number = value->number;
    return 0;
}

int step_flag(const struct step *step, const struct step_values *v, const struct step_value *value,
              bool *flag, struct error *error)
{
    *flag = step_is(value, "T");
    return *flag || step_is(value, "F")
               ? 0
               : step_refuse(step, v, "neither .T. nor .F. where one belongs, expected one", error);
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
        status = step_number(step, &v, item, 1e12, &x[i], error);
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
    if (!r && (r = step_record(&v, "AXIS2_PLACEMENT_2D"))) {
        axis = NULL;
        ref = step_item(r, 2);
    }
    int status = r ? read_coordinates(step, &v, step_item(r, 1), "CARTESIAN_POINT", &at, error)
                   : step_refuse(step, &v, "no axis placement, expected one", error);
    if (status == 0 && axis && axis->kind == STEP_REFERENCE)
        status = read_coordinates(step, &v, axis, "DIRECTION", &z, error);
    if (status == 0 && !(vec_length(z) > 0))
        status = step_refuse(step, &v, "an axis of no length, expected a direction", error);
    if (status == 0 && ref && ref->kind == STEP_REFERENCE)
        status = read_coordinates(step, &v, ref, "DIRECTION", &x, error);
    array_free(&v);
    *axes = construct_place(at, z, x);
    return status;
}

struct vec3 step_axis(const struct transform *t, int k)
{
    return vec(t->m[0][k], t->m[1][k], t->m[2][k]);
}

/* The same in mm and placed: axes are perpendicular unit vectors again. */
int step_placed_axes(const struct step_source *s, const struct step_value *reference,
                     struct transform *axes, struct error *error)
{
    if (step_axes(s->place->step, s->v, reference, axes, error) < 0)
        return -1;
    struct transform t = transform_product(s->place->to, *axes);
    *axes = construct_place(step_axis(&t, 3), step_axis(&t, 2), step_axis(&t, 0));
    return 0;
}

int step_point(const struct step_source *s, const struct step_value *reference, struct vec3 *point,
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
    struct step_source s = {.place = place, .v = &v};
    const struct step_value *r = step_record(&v, "VERTEX_POINT");
    struct step_source self = {.place = place, .v = from};
    int status = r ? step_point(&s, step_item(r, 1), point, error)
                   : step_point(&self, reference, point, error);
    array_free(&v);
    return status;
}

int step_direction(const struct step_source *s, const struct step_value *reference, struct vec3 *to,
                   double *length, struct error *error)
{
    struct step_values v = {0};
    const struct step *step = s->place->step;
    double size = 1;
    *to = vec(0, 0, 0);
    if (step_follow(step, s->v, reference, &v, error) < 0)
        return -1;
    const struct step_value *r = step_record(&v, "VECTOR");
    int status = r ? read_coordinates(step, &v, step_item(r, 1), "DIRECTION", to, error)
                   : step_refuse(step, &v, "no VECTOR, expected one", error);
    if (status == 0)
        status = step_number(step, &v, step_item(r, 2), 1e12, &size, error);
    array_free(&v);
    if (status < 0)
        return status;
    struct vec3 zero = transform_point(&s->place->to, vec(0, 0, 0));
    *to = vec_unit(vec_sub(transform_point(&s->place->to, *to), zero));
    if (length)
        *length = size * s->place->mm;
    if (!(vec_length(*to) > 0))
        status = step_refuse(step, s->v, "a direction of no length, expected one", error);
    return status;
}

int step_axis_direction(const struct step_source *s, const struct step_value *reference,
                        struct vec3 *to, struct error *error)
{
    const struct step *step = s->place->step;
    if (read_coordinates(step, s->v, reference, "DIRECTION", to, error) < 0)
        return -1;
    struct vec3 zero = transform_point(&s->place->to, vec(0, 0, 0));
    *to = vec_unit(vec_sub(transform_point(&s->place->to, *to), zero));
    return vec_length(*to) > 0 ? 0 : step_refuse(step, s->v, "a direction of no length", error);
}

struct nurbs_curve step_approximate(const struct nurbs_axis *axis, approximate_curve_fn *f,
                                    const void *context, double tolerance, double *rough)
{
    size_t n = nurbs_axis_breaks(axis, NULL, 0);
    double *at = mem_alloc(n + 2, sizeof *at), off;
    nurbs_axis_breaks(axis, at + 1, n);
    at[0] = axis->from;
    at[n + 1] = axis->to;
    struct nurbs_curve c = approximate_curve(f, context, at, n + 1, tolerance, &off);
    *rough = fmax(*rough, off);
    free(at);
    return c;
}

/* ---- splines */

static size_t list_length(const struct step_value *list)
{
    size_t n = 0;
    for (const struct step_value *i = step_item(list, 0); i; i = step_next(list, i))
        n++;
    return n;
}

bool step_find_spline(const struct step_values *v, bool surface, struct step_spline *s)
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
    *s = (struct step_spline){.uniform = which == 3, .bezier = which == 1};
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
static void implied_knots(const struct step_spline *s, struct nurbs_axis *a)
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

static int spline_axis(const struct step_source *s, const struct step_spline *sp, int k,
                       size_t poles, struct nurbs_axis *a, struct error *error)
{
    const struct step *step = s->place->step;
    double degree = 0, times = 0, knot = 0;
    struct error why;
    if (step_number(step, s->v, sp->degree[k], 1e6, &degree, error) < 0)
        return -1;
    if (!(degree >= 1 && degree <= NURBS_DEGREE_MAX) || poles < (size_t)degree + 1)
        return step_refuse(step, s->v, "a degree that is not 1 to 25, or fewer poles than it needs",
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
        if (step_number(step, s->v, m, 1e6, &times, error) < 0 ||
            step_number(step, s->v, x, NURBS_LARGEST, &knot, error) < 0)
            return -1;
        for (double i = 0; i < times && at <= n; i++, at++)
            if (at < n)
                a->knot[at] = knot;
    }
    if (at != n || m || x)
        return step_refuse(step, s->v, "multiplicities of knots that do not fit poles and degree",
                           error);
    if (nurbs_axis_check(a, k == 0 ? "u" : "v", &why) < 0)
        return step_refuse(step, s->v, why.text, error);
    return 0;
}

/* One row of poles with their weights, `step` apart. */
static int read_poles(const struct step_source *s, const struct step_value *list,
                      const struct step_value *weights, struct nurbs_pole *pole, size_t apart,
                      size_t n, struct error *error)
{
    const struct step_value *w = weights ? step_item(weights, 0) : NULL, *p = step_item(list, 0);
    for (size_t i = 0; i < n; i++, p = p ? step_next(list, p) : NULL) {
        struct vec3 at;
        double weight = 1;
        if (weights && step_number(s->place->step, s->v, w, NURBS_LARGEST, &weight, error) < 0)
            return -1;
        w = w ? step_next(weights, w) : NULL;
        if (!(weight > 0))
            return step_refuse(s->place->step, s->v,
                               "a weight that is not positive, expected positive", error);
        if (step_point(s, p, &at, error) < 0)
            return -1;
        pole[i * apart] = (struct nurbs_pole){weight * at.x, weight * at.y, weight * at.z, weight};
    }
    return 0;
}

int step_spline_curve(const struct step_source *s, const struct step_spline *sp,
                      struct nurbs_curve *c, struct error *error)
{
    size_t n = list_length(sp->poles);
    if (spline_axis(s, sp, 0, n, &c->t, error) < 0)
        return -1;
    c->pole = mem_alloc(n, sizeof *c->pole);
    return read_poles(s, sp->poles, sp->weights, c->pole, 1, n, error);
}

/* Rows of poles of one u each. */
int step_spline_surface(const struct step_source *s, const struct step_spline *sp,
                        struct error *error)
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
            return step_refuse(s->place->step, s->v, "rows of poles of different lengths", error);
        if (read_poles(s, row, sp->weights ? w : NULL, surface->pole + i, nu, nv, error) < 0)
            return -1;
        w = w ? step_next(sp->weights, w) : NULL;
        if (sp->weights && !w && i + 1 < nu)
            return step_refuse(s->place->step, s->v, "fewer weights than poles", error);
    }
    return 0;
}
