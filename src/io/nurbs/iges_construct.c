/* iges_construct - see iges_construct.h. */
#include "iges_construct.h"

#include <stdlib.h>

#include "base/array.h"
#include "iges_curve.h"
#include "iges_ruled.h"
#include "nurbs/construct.h"
#include "nurbs/primitive.h"

enum { SPLINE_MAX = 100000 }; /* segments of a parametric spline in one direction */

/* Radians: some writers have a whole turn from angles of few digits. */
static const double TURN_ROUNDING = 1e-4;

/* What a reader of one kind of surface works on. */
struct source {
    const struct iges *iges;
    const struct iges_entity *entity;
    const struct iges_values *values;
    const struct transform *place;
    const struct patch_loops *loops;
    struct nurbs *surface;
    double *rough; /* of the surface */
};

static double value_at(const struct source *s, size_t index)
{
    return index < s->values->n ? s->values->item[index].number : 0;
}

static struct vec3 vec_at(const struct source *s, size_t index)
{
    return vec(value_at(s, index), value_at(s, index + 1), value_at(s, index + 2));
}

static int refuse(const struct source *s, const char *what, struct error *error)
{
    return error_at(error, s->iges->name, s->values->line, "entity %d (directory entry %d): %s",
                    s->entity->type, s->entity->number, what);
}

/* The curve that parameter `index` points to, its pieces joined: 0, 1 when it is of a kind that is
 * not read, or -1. */
static int curve_at(const struct source *s, size_t index, struct nurbs_curve *curve,
                    struct error *error)
{
    const struct iges_entity *e, *unknown;
    struct patch_loop pieces = {0};
    if (iges_pointer(s->iges, s->values, index, &e, error) < 0)
        return -1;
    int got = iges_curve(s->iges, e, &pieces, &unknown, error);
    if (got == 0 && pieces.n == 1) {
        *curve = pieces.item[0];
        pieces.n = 0;
    } else if (got == 0) {
        *curve = construct_joined(pieces.item, pieces.n);
    }
    *s->rough = fmax(*s->rough, pieces.rough);
    patch_loop_free(&pieces);
    return got;
}

static void place_curve(const struct source *s, struct nurbs_curve *c)
{
    construct_move(s->place, c->pole, c->t.poles);
}

static int ruled_118(const struct source *s, struct error *error)
{
    struct iges_side side[2];
    int got = iges_ruled_read(s->iges, s->entity, side, error);
    if (got == 0)
        *s->surface = iges_ruled_surface(side, s->place, s->rough);
    iges_ruled_free(side);
    return got;
}

/* 120: a curve turned about a line (110), from one angle to another, where the entity is drawn: a
 * place that mirrors would turn it the other way round. */
static int revolution_120(const struct source *s, struct error *error)
{
    struct nurbs_curve axis = {{0}, NULL}, c = {{0}, NULL};
    double from = value_at(s, 3), to = s->values->n > 4 ? value_at(s, 4) : 2 * PI;
    if (!(to > from) || !(to - from < 2 * PI + TURN_ROUNDING))
        return refuse(s, "angles that do not rise by up to one turn, expected such", error);
    to = fmin(to, from + 2 * PI);
    int got = curve_at(s, 1, &axis, error);
    if (got == 0)
        got = curve_at(s, 2, &c, error);
    if (got == 0) {
        struct vec3 a = nurbs_curve_point(&axis, axis.t.from);
        struct vec3 d = vec_sub(nurbs_curve_point(&axis, axis.t.to), a);
        got = vec_length(d) > 0 ? 0 : refuse(s, "an axis without length, expected a line", error);
        if (got == 0) {
            *s->surface = construct_revolution(&c, a, vec_unit(d), from, to);
            construct_move(s->place, s->surface->pole, s->surface->u.poles * s->surface->v.poles);
        }
    }
    nurbs_curve_free(&axis);
    nurbs_curve_free(&c);
    return got;
}

/* 122: a curve moved along a line, whose first point is on the curve's start. */
static int tabulated_122(const struct source *s, struct error *error)
{
    struct nurbs_curve c = {{0}, NULL};
    int got = curve_at(s, 1, &c, error);
    if (got == 0) {
        struct nurbs_curve unit = construct_unit_range(&c);
        place_curve(s, &unit);
        struct vec3 end = transform_point(s->place, vec_at(s, 2));
        *s->surface = construct_extrusion(&unit, vec_sub(end, nurbs_curve_point(&unit, 0)));
        nurbs_curve_free(&unit);
    }
    nurbs_curve_free(&c);
    return got;
}

/* 114: patches of cubic polynomials, a column of the patches after the other; each column, and the
 * whole, ends with a patch more, which is not used. */
static int spline_114(const struct source *s, struct error *error)
{
    long m, n;
    if (iges_whole(s->iges, s->values, 3, 1, SPLINE_MAX, "count of patches in u", &m, error) < 0 ||
        iges_whole(s->iges, s->values, 4, 1, SPLINE_MAX, "count of patches in v", &n, error) < 0)
        return -1;
    size_t mu = (size_t)m, nv = (size_t)n, first = 5 + mu + 1 + nv + 1;
    double need = (double)first + 48.0 * ((double)m * (double)(n + 1) - 1);
    if ((double)s->values->n < need)
        return refuse(s, "fewer coefficients than its patches need, expected 48 for each", error);
    double *u = mem_alloc(mu + 1, sizeof *u), *v = mem_alloc(nv + 1, sizeof *v);
    double *c = mem_alloc(48 * mu * nv, sizeof *c);
    bool rises = true;
    for (size_t i = 0; i <= mu; i++) {
        u[i] = value_at(s, 5 + i);
        rises = rises && (i == 0 || u[i] > u[i - 1]);
    }
    for (size_t j = 0; j <= nv; j++) {
        v[j] = value_at(s, 6 + mu + j);
        rises = rises && (j == 0 || v[j] > v[j - 1]);
    }
    for (size_t i = 0; i < mu; i++)
        for (size_t j = 0; j < nv; j++)
            for (size_t k = 0; k < 48; k++)
                c[48 * (i * nv + j) + k] = value_at(s, first + 48 * (i * (nv + 1) + j) + k);
    if (rises) {
        *s->surface = construct_spline_surface(u, mu, v, nv, c);
        construct_move(s->place, s->surface->pole, s->surface->u.poles * s->surface->v.poles);
    }
    free(u);
    free(v);
    free(c);
    return rises ? 0 : refuse(s, "breakpoints that do not rise, expected rising ones", error);
}

/* The point (116) or direction (123) that a parameter points to. */
static int vec_of(const struct source *s, size_t index, int type, struct vec3 *to,
                  struct error *error)
{
    const struct iges_entity *e;
    struct iges_values v;
    if (iges_pointer(s->iges, s->values, index, &e, error) < 0)
        return -1;
    if (e->type != type)
        return refuse(
            s, type == 116 ? "a place that is no entity 116" : "a direction that is no entity 123",
            error);
    if (iges_values(s->iges, e, &v, error) < 0)
        return -1;
    struct source point = {.values = &v};
    *to = vec_at(&point, 1);
    array_free(&v);
    return 0;
}

/* The unit direction that a local one is turned to. */
static struct vec3 turned_direction(const struct transform *t, struct vec3 d)
{
    struct vec3 zero = {0, 0, 0};
    return vec_unit(vec_sub(transform_point(t, d), transform_point(t, zero)));
}

static int add_primitive(const struct source *s, struct primitive p, struct vec3 at, struct vec3 z,
                         struct vec3 x)
{
    struct vec3s points = {0};
    double scale = cbrt(fabs(transform_determinant(s->place)));
    p.radius *= scale;
    p.other *= p.kind == PRIMITIVE_TORUS ? scale : RADIANS(1);
    p.place = construct_place(transform_point(s->place, at), turned_direction(s->place, z),
                              vec_length(x) > 0 ? turned_direction(s->place, x) : x);
    primitive_points(s->loops, &points);
    p.part = primitive_part_of(&p, s->loops);
    int status = primitive_surface(&p, &points, s->surface);
    array_free(&points);
    return status < 0 ? 1 : 0;
}

/* 108: A x + B y + C z = D. */
static int plane_108(const struct source *s, struct error *error)
{
    struct vec3 n = vec_at(s, 1);
    double l = vec_dot(n, n);
    struct primitive p = {.kind = PRIMITIVE_PLANE};
    return l > 0 ? add_primitive(s, p, vec_scale(value_at(s, 4) / l, n), n, vec(0, 0, 0))
                 : refuse(s, "a normal of no length, expected a direction", error);
}

/* 190 to 198: a place, an axis (but a sphere has none where its form is 0), radii, and in form 1 a
 * direction in which the angle is 0. */
static int solid_surface(const struct source *s, struct error *error)
{
    static const enum primitive_kind kind[] = {PRIMITIVE_PLANE, PRIMITIVE_CYLINDER, PRIMITIVE_CONE,
                                               PRIMITIVE_SPHERE, PRIMITIVE_TORUS};
    int type = s->entity->type;
    bool sphere = type == 196;
    struct vec3 at = {0, 0, 0}, z = {0, 0, 1}, x = {0, 0, 0};
    size_t numbers = type == 190 ? 0 : type == 192 || sphere ? 1 : 2, first = sphere ? 2 : 3;
    if (vec_of(s, 1, 116, &at, error) < 0)
        return -1;
    if (!sphere && vec_of(s, 2, 123, &z, error) < 0)
        return -1;
    if (s->entity->form == 1 && sphere &&
        (vec_of(s, 3, 123, &z, error) < 0 || vec_of(s, 4, 123, &x, error) < 0))
        return -1;
    if (s->entity->form == 1 && !sphere && vec_of(s, first + numbers, 123, &x, error) < 0)
        return -1;
    struct primitive p = {.kind = kind[(type - 190) / 2], .radius = value_at(s, first)};
    p.other = numbers > 1 ? value_at(s, first + 1) : 0;
    return add_primitive(s, p, at, z, x);
}

static int read_known(const struct source *s, struct error *error)
{
    switch (s->entity->type) {
    case 108:
        return plane_108(s, error);
    case 114:
        return spline_114(s, error);
    case 118:
        return ruled_118(s, error);
    case 120:
        return revolution_120(s, error);
    case 122:
        return tabulated_122(s, error);
    case 190:
    case 192:
    case 194:
    case 196:
    case 198:
        return solid_surface(s, error);
    default:
        return 1;
    }
}

int iges_construct(const struct iges *iges, const struct iges_entity *entity,
                   const struct transform *place, struct patch *patch, struct error *error)
{
    struct iges_values v;
    struct source s = {iges, entity, &v, place, &patch->loop, &patch->surface, &patch->rough};
    if (iges_values(iges, entity, &v, error) < 0)
        return -1;
    int got = iges_numbers(iges, &v, 1, v.n, NURBS_LARGEST, error);
    if (got == 0)
        got = read_known(&s, error);
    array_free(&v);
    return got;
}
