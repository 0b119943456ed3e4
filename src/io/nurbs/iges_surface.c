/* iges_surface - see iges_surface.h. */
#include "iges_surface.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "iges_construct.h"
#include "iges_groups.h"
#include "iges_curve.h"
#include "iges_parts.h"
#include "iges_trim.h"
#include "nurbs/approximate.h"
#include "nurbs/construct.h"

enum { COUNT_MAX = 2147483647, HEAD = 10 }; /* HEAD: numbers of a 128 in front of its knots */

/* mm: a million kilometres, of which a double still knows a thousandth of a millimetre. */
static const double COORDINATE_MAX = 1e12;

struct source {
    const struct iges *iges;
    double mm;
    struct patches *patches;
};

/* Where the parts of a 128 begin among its parameters. */
struct layout {
    long k1, k2, m1, m2;
    size_t knots_v, weights, poles, range;
};

static int read_layout(const struct iges *iges, const struct iges_values *v, struct layout *l,
                       struct error *error)
{
    if (iges_whole(iges, v, 1, 1, COUNT_MAX, "upper index of poles in u (K1)", &l->k1, error) < 0 ||
        iges_whole(iges, v, 2, 1, COUNT_MAX, "upper index of poles in v (K2)", &l->k2, error) < 0 ||
        iges_whole(iges, v, 3, 1, NURBS_DEGREE_MAX, "degree in u (M1)", &l->m1, error) < 0 ||
        iges_whole(iges, v, 4, 1, NURBS_DEGREE_MAX, "degree in v (M2)", &l->m2, error) < 0)
        return -1;
    double poles = ((double)l->k1 + 1) * ((double)l->k2 + 1);
    double need = HEAD + (double)(l->k1 + l->m1 + 2) + (double)(l->k2 + l->m2 + 2) + 4 * poles;
    if (!(need <= (double)v->n))
        return error_at(error, iges->name, v->line,
                        "entity 128 with %ld x %ld poles of degree %ld x %ld but %zu numbers, "
                        "expected %.0f",
                        l->k1 + 1, l->k2 + 1, l->m1, l->m2, v->n, need);
    l->knots_v = HEAD + (size_t)(l->k1 + l->m1 + 2);
    l->weights = l->knots_v + (size_t)(l->k2 + l->m2 + 2);
    l->poles = l->weights + (size_t)poles;
    l->range = l->poles + 3 * (size_t)poles;
    return 0;
}

/* Degree, knots and range; the range of the knots where the entity ends before it gives one. */
static int read_axis(const struct iges *iges, const struct iges_values *v, long upper, long degree,
                     size_t knots, size_t range, const char *name, struct nurbs_axis *axis,
                     struct error *error)
{
    size_t n = (size_t)(upper + degree + 2);
    struct error why;
    *axis = (struct nurbs_axis){.degree = (int)degree, .poles = (size_t)upper + 1};
    axis->knot = mem_alloc(n, sizeof *axis->knot);
    for (size_t i = 0; i < n; i++)
        axis->knot[i] = v->item[knots + i].number;
    bool given = range + 1 < v->n;
    axis->from = given ? v->item[range].number : -HUGE_VAL;
    axis->to = given ? v->item[range + 1].number : HUGE_VAL;
    if (nurbs_axis_check(axis, name, &why) < 0)
        return error_at(error, iges->name, v->item[knots].line, "entity 128: %s", why.text);
    return 0;
}

static int read_poles(const struct source *s, const struct transform *matrix,
                      const struct iges_values *v, const struct layout *l, struct nurbs *surface,
                      struct error *error)
{
    size_t n = surface->u.poles * surface->v.poles;
    surface->pole = mem_alloc(n, sizeof *surface->pole);
    for (size_t i = 0; i < n; i++) {
        const struct iges_value *p = &v->item[l->poles + 3 * i];
        const struct iges_value *weight = &v->item[l->weights + i];
        double w = weight->number;
        if (!(w > 0))
            return error_at(error, s->iges->name, weight->line,
                            "weight %g of pole %zu, expected a positive one", w, i + 1);
        struct vec3 at = transform_point(matrix, vec(p[0].number, p[1].number, p[2].number));
        at = vec_scale(s->mm * w, at);
        surface->pole[i] = (struct nurbs_pole){at.x, at.y, at.z, w};
    }
    return 0;
}

static int spline_128(const struct source *s, const struct transform *matrix,
                      const struct iges_values *v, struct nurbs *surface, struct error *error)
{
    struct layout l;
    if (iges_whole(s->iges, v, 0, 128, 128, "entity type", &l.k1, error) < 0 ||
        read_layout(s->iges, v, &l, error) < 0 ||
        iges_numbers(s->iges, v, HEAD, l.range + 4, NURBS_LARGEST, error) < 0 ||
        iges_numbers(s->iges, v, l.poles, l.range, COORDINATE_MAX / s->mm, error) < 0 ||
        read_axis(s->iges, v, l.k1, l.m1, HEAD, l.range, "u", &surface->u, error) < 0 ||
        read_axis(s->iges, v, l.k2, l.m2, l.knots_v, l.range + 2, "v", &surface->v, error) < 0)
        return -1;
    return read_poles(s, matrix, v, &l, surface, error);
}

/* A surface and what trims it: an entity 144, 143 or 510, or NULL. */
struct trimmed {
    size_t surface; /* index among the entities */
    const struct iges_entity *trim;
    size_t order; /* of those with the same surface */
    struct transform to;
    int body;    /* as in struct iges_part, ... */
    bool cavity; /* ... and this too */
    int group;   /* as iges_groups has it */
};

struct all_trimmed {
    size_t n, cap;
    struct trimmed *item;
};

static bool is_surface(int type)
{
    static const int known[] = {108, 114, 118, 120, 122, 128, 140, 190, 192, 194, 196, 198};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (type == known[i])
            return true;
    return false;
}

/* Faces, and surfaces that may stand for themselves. */
static bool is_part(int type)
{
    return type == 144 || type == 143 || type == 510 || is_surface(type);
}

/* Solids that are not read: the primitives of constructive solids, and what they are combined
 * by. */
static bool is_other(int type)
{
    return type >= 150 && type <= 182 && type % 2 == 0;
}

static void leave_out(const struct source *s, const struct iges_entity *e)
{
    char kind[32];
    snprintf(kind, sizeof kind, "type %d", e->type);
    patches_leave_out(s->patches, s->iges->name, kind, e->number);
}

static int read_surface(const struct source *s, const struct iges_entity *e,
                        const struct transform *outer, struct patch *patch, struct error *error);

/* 140: a side, by a direction at the start of the parameters, a distance, a surface. */
static int read_offset(const struct source *s, const struct iges_values *v,
                       const struct transform *matrix, struct patch *patch, struct error *error)
{
    const struct iges_entity *basis;
    if (v->n < 6 || iges_numbers(s->iges, v, 1, 5, NURBS_LARGEST, error) < 0 ||
        iges_pointer(s->iges, v, 5, &basis, error) < 0)
        return v->n < 6 ? error_at(error, s->iges->name, v->line,
                                   "entity 140 with %zu numbers, expected 6", v->n)
                        : -1;
    if (!is_surface(basis->type) || basis->type == 140)
        return 1;
    int got = read_surface(s, basis, matrix, patch, error);
    if (got != 0)
        return got;
    struct nurbs base = patch->surface;
    struct vec3 zero = {0, 0, 0}, side = {v->item[1].number, v->item[2].number, v->item[3].number};
    side = vec_sub(transform_point(matrix, side), transform_point(matrix, zero));
    struct nurbs_place start = nurbs_place(&base, (struct uv){base.u.from, base.v.from});
    double scale = s->mm * cbrt(fabs(transform_determinant(matrix)));
    double distance = v->item[4].number * scale * (vec_dot(side, start.normal) < 0 ? -1 : 1);
    double off;
    patch->surface = approximate_offset(&base, distance, &off);
    patch->rough = fmax(patch->rough, off);
    nurbs_free(&base);
    return 0;
}

/* The surface of an entity, to mm: 0, 1 when it is not read, or -1. */
static int read_surface(const struct source *s, const struct iges_entity *e,
                        const struct transform *outer, struct patch *patch, struct error *error)
{
    struct iges_values v;
    struct transform matrix;
    if (iges_matrix(s->iges, e->matrix, e->at, &matrix, error) < 0)
        return -1;
    matrix = transform_product(*outer, matrix);
    if (e->type != 128 && e->type != 140) {
        struct transform place = transform_product(transform_scale(s->mm), matrix);
        return iges_construct(s->iges, e, &place, patch, error);
    }
    if (iges_values(s->iges, e, &v, error) < 0)
        return -1;
    int status = e->type == 140 ? read_offset(s, &v, &matrix, patch, error)
                                : spline_128(s, &matrix, &v, &patch->surface, error);
    array_free(&v);
    return status;
}

/* The loops of a 144 (outer one, then the holes), of a 143 or of a 510 from parameter `at` on. */
static int add_loops(const struct source *s, const struct iges_values *v, size_t at, size_t n,
                     const struct iges_trimming *trimming, struct patch *patch, struct error *error)
{
    for (size_t i = 0; i < n; i++) {
        const struct iges_entity *e;
        if (iges_pointer(s->iges, v, at + i, &e, error) < 0 ||
            iges_trim(trimming, patch, e, error) < 0)
            return -1;
    }
    return 0;
}

/* An outer loop that is said to be there, and none is named: some writers mean the border of the
 * surface, for which the standard has flag 0. */
static bool names_no_outer(const struct iges_values *v)
{
    return v->n > 4 && v->item[4].kind != IGES_TEXT && fabs(v->item[4].number) < 0.5;
}

static int read_loops(const struct source *s, const struct iges_entity *e,
                      const struct iges_values *v, const struct iges_trimming *trimming,
                      struct patch *patch, struct error *error)
{
    long outer = 1, inner;
    bool is_144 = e->type == 144;
    size_t count = e->type == 510 ? 2 : 3;
    if (is_144 && iges_whole(s->iges, v, 2, 0, 1, "flag of the outer loop", &outer, error) < 0)
        return -1;
    if (iges_whole(s->iges, v, count, 0, COUNT_MAX, "count of loops", &inner, error) < 0)
        return -1;
    patch->unnamed = is_144 && outer == 1 && names_no_outer(v);
    outer = patch->unnamed ? 0 : outer;
    patch->open = is_144 && outer == 0;
    patch->outer = is_144 && outer == 1;
    if (is_144 && outer == 1 && add_loops(s, v, 4, 1, trimming, patch, error) < 0)
        return -1;
    if (patch->ignored > 0)
        patch->open = true; /* without its outer loop the whole range counts */
    return add_loops(s, v, is_144 ? 5 : 4, (size_t)inner, trimming, patch, error);
}

/* A plane that is bounded by a curve of its own, which its place moves, too. */
static bool is_bounded_plane(const struct iges_entity *e)
{
    return e->type == 108 && e->form == 1;
}

static int bound_plane(const struct source *s, const struct iges_entity *e,
                       const struct iges_trimming *trimming, struct patch *patch,
                       struct error *error)
{
    struct iges_trimming inner = *trimming;
    if (iges_matrix(s->iges, e->matrix, e->at, &inner.outer, error) < 0)
        return -1;
    inner.outer = transform_product(trimming->outer, inner.outer);
    patch->outer = true;
    if (iges_trim(&inner, patch, e, error) < 0)
        return -1;
    return patch->loop.n == 0 ? 1 : 0;
}

/* No part of the model: a plane or another surface without an end that nothing trims. */
static bool is_endless(const struct trimmed *t, const struct iges_entity *e)
{
    return !t->trim && ((e->type == 108 && e->form == 0) || e->type >= 190);
}

/* A surface with its loops, appended.  The loops are read first: planes reach as far as they do. */
static int add_patch(const struct source *s, const struct trimmed *t, struct error *error)
{
    const struct iges_entity *e = &s->iges->entity.item[t->surface];
    struct iges_trimming trimming = {
        .iges = s->iges, .mm = s->mm, .space = e->type != 128 && e->type != 114};
    struct iges_values v;
    struct patch patch = {
        .entity = e->number, .body = t->body, .cavity = t->cavity, .group = t->group};
    if (iges_matrix(s->iges, t->trim ? t->trim->matrix : 0, t->trim ? t->trim->at : e->at,
                    &trimming.outer, error) < 0)
        return -1;
    trimming.outer = transform_product(t->to, trimming.outer);
    int status = t->trim ? iges_values(s->iges, t->trim, &v, error) : 0;
    if (t->trim && status == 0) {
        status = read_loops(s, t->trim, &v, &trimming, &patch, error);
        array_free(&v);
    }
    if (!t->trim && is_bounded_plane(e))
        status = bound_plane(s, e, &trimming, &patch, error);
    if (status == 0)
        status = read_surface(s, e, &trimming.outer, &patch, error);
    if (status == 0)
        status = iges_parameters(s->iges, e, &patch, error);
    if (status == 0) {
        patch.file = mem_string(s->iges->name, strlen(s->iges->name));
        *array_push(s->patches) = patch;
        return 0;
    }
    if (status > 0 && !is_endless(t, e))
        leave_out(s, e);
    patch_free(&patch);
    return status < 0 ? -1 : 0;
}

static int compare_trimmed(const void *p, const void *q)
{
    const struct trimmed *a = p, *b = q;
    if (a->surface != b->surface)
        return a->surface < b->surface ? -1 : 1;
    return a->order < b->order ? -1 : a->order > b->order;
}

/* The surface that a face trims, or that another one is made of; NULL: the entity is a surface. */
static int basis_of(const struct source *s, const struct iges_entity *e,
                    const struct iges_entity **basis, struct error *error)
{
    struct iges_values v;
    *basis = NULL;
    if (e->type != 144 && e->type != 143 && e->type != 510 && e->type != 140)
        return 0;
    if (iges_values(s->iges, e, &v, error) < 0)
        return -1;
    size_t at = e->type == 143 ? 2 : e->type == 140 ? 5 : 1;
    int status = iges_pointer(s->iges, &v, at, basis, error);
    array_free(&v);
    return status;
}

/* What a face lies on is none that is read: left out where it is of a kind that the standard leaves
 * to others, else an error. */
static int no_surface(const struct source *s, const struct iges_entity *face,
                      const struct iges_entity *on, struct error *error)
{
    const int others = 5000;
    if (on->type < others)
        return error_at(error, s->iges->name, face->at,
                        "entity %d of type %d on entity %d of type %d, expected a surface",
                        face->number, face->type, on->number, on->type);
    leave_out(s, on);
    return 0;
}

/* All faces where the file places them, in the order of their surfaces' directory entries: each
 * surface once for each entity that trims it, or once as it is. */
static int find_trimmed(const struct source *s, struct all_trimmed *all, struct error *error)
{
    const struct iges_entity *first = s->iges->entity.item, *basis;
    bool *used = mem_alloc(s->iges->entity.n + 1, sizeof *used);
    struct iges_parts parts = {0};
    int *group = iges_groups(s->iges, error);
    int status = group ? iges_parts(s->iges, is_part, &s->patches->bodies, &parts, error) : -1;
    for (size_t i = 0; i < s->iges->entity.n && status == 0; i++) {
        if (is_other(first[i].type))
            leave_out(s, &first[i]);
        status = basis_of(s, &first[i], &basis, error);
        if (status == 0 && basis)
            used[basis - first] = true;
    }
    for (size_t i = 0; i < parts.n && status == 0; i++) {
        const struct iges_part *p = &parts.item[i];
        bool surface = is_surface(p->entity->type);
        status = basis_of(s, p->entity, &basis, error);
        const struct iges_entity *on = surface ? p->entity : basis;
        if (status == 0 && !surface && !is_surface(on->type))
            status = no_surface(s, p->entity, on, error);
        if (status == 0 && is_surface(on->type) && !(surface && used[on - first]))
            *array_push(all) = (struct trimmed){(size_t)(on - first),
                                                surface ? NULL : p->entity,
                                                all->n,
                                                p->to,
                                                p->body,
                                                p->cavity,
                                                group[p->entity - first]};
    }
    if (all->n > 0)
        qsort(all->item, all->n, sizeof *all->item, compare_trimmed);
    array_free(&parts);
    free(group);
    free(used);
    return status;
}

/* Groups tell something where each loose face is in one, each once, and there are several of them:
 * they get numbers of their own among those of all files.  Else there are none. */
static void settle_groups(struct patches *patches, const struct all_trimmed *all, size_t before)
{
    bool several = false, each = true;
    int most = 0;
    for (size_t i = before; i < patches->n; i++) {
        const struct patch *p = &patches->item[i];
        each = each && (p->body != 0 || p->group != 0);
        several = several || p->group != patches->item[before].group;
        most = p->group > most ? p->group : most;
    }
    for (size_t i = 1; i < all->n; i++)
        each = each && (all->item[i].surface != all->item[i - 1].surface ||
                        all->item[i].trim != all->item[i - 1].trim);
    for (size_t i = before; i < patches->n; i++) {
        struct patch *p = &patches->item[i];
        p->group = several && each && p->body == 0 ? patches->groups + p->group : 0;
    }
    patches->groups += most;
}

int iges_surfaces(const struct iges *iges, double mm, struct patches *patches, struct error *error)
{
    struct source s = {iges, mm > 0 ? mm : iges->unit, patches};
    struct all_trimmed all = {0};
    size_t before = patches->n;
    int status = find_trimmed(&s, &all, error);
    for (size_t i = 0; i < all.n && status == 0; i++)
        status = add_patch(&s, &all.item[i], error);
    settle_groups(patches, &all, before);
    array_free(&all);
    if (status == 0 && patches->n == before)
        return error_at(error, iges->name, 1,
                        "no surface that is read (entity type 128 and others) among %zu entities, "
                        "expected one",
                        iges->entity.n);
    return status;
}
