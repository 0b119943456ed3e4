/* iges_surface - see iges_surface.h. */
#include "iges_surface.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "iges_curve.h"
#include "iges_trim.h"

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

static int read_poles(const struct source *s, const struct iges_entity *e,
                      const struct transform *outer, const struct iges_values *v,
                      const struct layout *l, struct nurbs *surface, struct error *error)
{
    size_t n = surface->u.poles * surface->v.poles;
    struct transform matrix;
    if (iges_matrix(s->iges, e->matrix, &matrix, error) < 0)
        return -1;
    matrix = transform_product(*outer, matrix);
    surface->pole = mem_alloc(n, sizeof *surface->pole);
    for (size_t i = 0; i < n; i++) {
        const struct iges_value *p = &v->item[l->poles + 3 * i];
        const struct iges_value *weight = &v->item[l->weights + i];
        double w = weight->number;
        if (!(w > 0))
            return error_at(error, s->iges->name, weight->line,
                            "weight %g of pole %zu, expected a positive one", w, i + 1);
        struct vec3 at = transform_point(&matrix, vec(p[0].number, p[1].number, p[2].number));
        at = vec_scale(s->mm * w, at);
        surface->pole[i] = (struct nurbs_pole){at.x, at.y, at.z, w};
    }
    return 0;
}

static int surface_of(const struct source *s, const struct iges_entity *e,
                      const struct transform *outer, const struct iges_values *v,
                      struct nurbs *surface, struct error *error)
{
    struct layout l;
    if (iges_whole(s->iges, v, 0, 128, 128, "entity type", &l.k1, error) < 0 ||
        read_layout(s->iges, v, &l, error) < 0 ||
        iges_numbers(s->iges, v, HEAD, l.range + 4, NURBS_LARGEST, error) < 0 ||
        iges_numbers(s->iges, v, l.poles, l.range, COORDINATE_MAX / s->mm, error) < 0 ||
        read_axis(s->iges, v, l.k1, l.m1, HEAD, l.range, "u", &surface->u, error) < 0 ||
        read_axis(s->iges, v, l.k2, l.m2, l.knots_v, l.range + 2, "v", &surface->v, error) < 0)
        return -1;
    return read_poles(s, e, outer, v, &l, surface, error);
}

/* The 128 as a patch without loops, appended; `trim` is what trims it, or NULL. */
static int add_patch(const struct source *s, const struct iges_entity *e,
                     const struct iges_entity *trim, struct error *error)
{
    struct iges_values v;
    struct transform outer;
    if (iges_matrix(s->iges, trim ? trim->matrix : 0, &outer, error) < 0 ||
        iges_values(s->iges, e, &v, error) < 0)
        return -1;
    struct patch *patch = array_push(s->patches);
    *patch = (struct patch){.entity = e->number};
    patch->file = mem_string(s->iges->name, strlen(s->iges->name));
    int status = surface_of(s, e, &outer, &v, &patch->surface, error);
    array_free(&v);
    return status;
}

/* The loops of a 144 (outer one, then the holes) or of a 143 from parameter `at` on. */
static int add_loops(const struct source *s, const struct iges_values *v, size_t at, size_t n,
                     const struct transform *outer, struct error *error)
{
    struct patch *patch = &s->patches->item[s->patches->n - 1];
    struct iges_trimming trimming = {s->iges, s->mm, *outer};
    for (size_t i = 0; i < n; i++) {
        const struct iges_entity *e;
        if (iges_pointer(s->iges, v, at + i, &e, error) < 0 ||
            iges_trim(&trimming, patch, e, error) < 0)
            return -1;
    }
    return 0;
}

/* What a 144 or 143 trims: parameter 1 or 2, an entity 128; NULL when it is something else. */
static int trimmed_by(const struct source *s, const struct iges_entity *e,
                      const struct iges_values *v, const struct iges_entity **surface,
                      struct error *error)
{
    if (iges_pointer(s->iges, v, e->type == 144 ? 1 : 2, surface, error) < 0)
        return -1;
    if ((*surface)->type != 128)
        *surface = NULL;
    return 0;
}

static int add_trimmed(const struct source *s, const struct iges_entity *e,
                       const struct iges_entity *surface, const struct iges_values *v,
                       struct error *error)
{
    long outer = 1, inner;
    bool is_144 = e->type == 144;
    struct transform at;
    if (add_patch(s, surface, e, error) < 0 || iges_matrix(s->iges, e->matrix, &at, error) < 0)
        return -1;
    struct patch *patch = &s->patches->item[s->patches->n - 1];
    if (is_144 && iges_whole(s->iges, v, 2, 0, 1, "flag of the outer loop", &outer, error) < 0)
        return -1;
    if (iges_whole(s->iges, v, 3, 0, COUNT_MAX, "count of loops", &inner, error) < 0)
        return -1;
    patch->open = is_144 && outer == 0;
    if (is_144 && outer == 1 && add_loops(s, v, 4, 1, &at, error) < 0)
        return -1;
    if (patch->ignored > 0)
        patch->open = true; /* without its outer loop the whole range counts */
    return add_loops(s, v, is_144 ? 5 : 4, (size_t)inner, &at, error);
}

/* All that trim the surface, or all that trim anything but a 128 where it is NULL: how many. */
static int add_all_trimmed(const struct source *s, const struct iges_entity *surface, int *count,
                           struct error *error)
{
    *count = 0;
    for (size_t i = 0; i < s->iges->entity.n; i++) {
        const struct iges_entity *e = &s->iges->entity.item[i], *of;
        struct iges_values v;
        if (e->type != 144 && e->type != 143)
            continue;
        if (iges_values(s->iges, e, &v, error) < 0)
            return -1;
        int status = trimmed_by(s, e, &v, &of, error);
        if (status == 0 && of == surface) {
            (*count)++;
            status = add_trimmed(s, e, surface, &v, error);
        }
        array_free(&v);
        if (status < 0)
            return -1;
    }
    return 0;
}

/* Surfaces of other kinds: plane, parametric spline, ruled, of revolution, tabulated, offset, and
 * those of solids. */
static bool is_other_surface(int type)
{
    static const int other[] = {108, 114, 118, 120, 122, 140, 186, 190, 192, 194, 196, 198};
    for (size_t i = 0; i < sizeof other / sizeof *other; i++)
        if (type == other[i])
            return true;
    return false;
}

static void count_others(const struct iges *iges, struct patches *patches)
{
    for (size_t i = 0; i < iges->entity.n; i++) {
        const struct iges_entity *e = &iges->entity.item[i];
        if (is_other_surface(e->type) && patches->others++ == 0) {
            patches->other_entity = e->number;
            patches->other_type = e->type;
        }
    }
}

int iges_surfaces(const struct iges *iges, double mm, struct patches *patches, struct error *error)
{
    struct source s = {iges, mm > 0 ? mm : iges->unit, patches};
    size_t before = patches->n;
    int count;
    for (size_t i = 0; i < iges->entity.n; i++) {
        const struct iges_entity *e = &iges->entity.item[i];
        if (e->type != 128)
            continue;
        if (add_all_trimmed(&s, e, &count, error) < 0 ||
            (count == 0 && add_patch(&s, e, NULL, error) < 0))
            return -1;
    }
    count_others(iges, patches);
    if (patches->n == before)
        return error_at(error, iges->name, 0,
                        "no surface of entity type 128 among %zu entities, expected one",
                        iges->entity.n);
    return 0;
}
