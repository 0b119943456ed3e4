/* step_model - see step_model.h. */
#include "step_model.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "nurbs/construct.h"
#include "nurbs/primitive.h"
#include "step_assembly.h"
#include "step_face.h"
#include "step_repeats.h"
#include "step_source.h"
#include "step_units.h"

enum { DEPTH_MAX = 60, FACES_MAX = 1000000, VISITS_MAX = 4000000 };

struct model {
    const struct step *step;
    struct patches *patches;
    double mm; /* of the command line, or 0 */
    struct step_assembly assembly;
    /* Faces that representations show which no other places: ranges of patches, from and end. */
    struct sizes unplaced;
    long visits;
    int body;    /* closed shell whose faces are read, 0: none */
    bool cavity; /* it bounds a void */
};

static int follow_reference(const struct model *m, const struct step_values *from,
                            const struct step_value *reference, struct step_values *to,
                            struct error *error)
{
    return step_follow(m->step, from, reference, to, error);
}

/* Every step of the walk through the model counts: one that refers to itself ends. */
static int count_visit(struct model *m, int depth, const struct step_values *at,
                       struct error *error)
{
    if (m->visits++ < VISITS_MAX && depth < DEPTH_MAX && m->patches->n < FACES_MAX)
        return 0;
    return error_at(error, m->step->name, at->instance->line,
                    "#%ld: parts within parts without end, expected a model of at most %d faces",
                    at->instance->id, FACES_MAX);
}

/* The curves that bound a CURVE_BOUNDED_SURFACE: a loop each. */
static int bounded_loops(const struct step_place *place, const struct step_values *v,
                         struct patch *patch, struct vec3s *points, struct error *error)
{
    const struct step_value *r = step_record(v, "CURVE_BOUNDED_SURFACE"), *list = step_item(r, 2);
    int got = step_flag(place->step, v, step_item(r, 3), &patch->open, error);
    for (const struct step_value *i = step_item(list, 0); i && got >= 0; i = step_next(list, i)) {
        struct patch_loop loop = {.space = true};
        struct patch_loops one = {1, 1, &loop};
        got = step_curve(place, v, i, NULL, &loop, error);
        if (got == 0 && loop.n > 0) {
            primitive_points(&one, points);
            *array_push(&patch->loop) = loop;
            continue;
        }
        patch_loop_free(&loop);
        if (got > 0 && patch->ignored++ == 0)
            patch->ignored_entity = (int)i->number;
    }
    return got < 0 ? -1 : 0;
}

/* A surface without topology: bounded by curves, by its parameters, or not at all. */
static int add_free_surface(struct model *m, const struct step_place *place,
                            const struct step_values *from, const struct step_value *reference,
                            const struct step_values *v, struct error *error)
{
    struct patch patch = {.entity = (int)v->instance->id};
    struct vec3s points = {0};
    struct patch_loop sides = {0};
    char kind[40] = "";
    int got = 0;
    if (step_record(v, "CURVE_BOUNDED_SURFACE"))
        got = bounded_loops(place, v, &patch, &points, error);
    if (step_record(v, "RECTANGULAR_TRIMMED_SURFACE"))
        got = step_rectangle(place, v, &sides, error);
    if (sides.n > 0) {
        *array_push(&patch.loop) = sides;
        primitive_points(&patch.loop, &points);
    }
    if (got == 0)
        got = step_surface(place, from, reference, &points, &patch.surface, &patch.rough, kind,
                           error);
    array_free(&points);
    if (got == 0) {
        patch.file = mem_string(m->step->name, strlen(m->step->name));
        *array_push(m->patches) = patch;
        return 0;
    }
    if (got > 0)
        patches_leave_out(m->patches, m->step->name, kind[0] ? kind : "a surface without ends",
                          patch.entity);
    patch_free(&patch);
    return got < 0 ? -1 : 0;
}

/* Surfaces that may stand in a set without a face; planes and the like have no end there. */
static bool is_free_surface(const struct step_values *v)
{
    static const char *const kind[] = {"CURVE_BOUNDED_SURFACE", "RECTANGULAR_TRIMMED_SURFACE",
                                       "B_SPLINE_SURFACE",      "B_SPLINE_SURFACE_WITH_KNOTS",
                                       "BEZIER_SURFACE",        "QUASI_UNIFORM_SURFACE",
                                       "UNIFORM_SURFACE"};
    for (size_t i = 0; i < sizeof kind / sizeof *kind; i++)
        if (step_record(v, kind[i]))
            return true;
    return false;
}

/* What holds faces: solids, shells, sets; all that they refer to is looked through. */
static bool holds_faces(const struct step_values *v)
{
    static const char *const kind[] = {"MANIFOLD_SOLID_BREP",
                                       "BREP_WITH_VOIDS",
                                       "FACETED_BREP",
                                       "SHELL_BASED_SURFACE_MODEL",
                                       "FACE_BASED_SURFACE_MODEL",
                                       "CLOSED_SHELL",
                                       "OPEN_SHELL",
                                       "ORIENTED_CLOSED_SHELL",
                                       "ORIENTED_OPEN_SHELL",
                                       "CONNECTED_FACE_SET",
                                       "ORIENTED_FACE",
                                       "GEOMETRIC_SET"};
    for (size_t i = 0; i < sizeof kind / sizeof *kind; i++)
        if (step_record(v, kind[i]))
            return true;
    return false;
}

/* Solids and surfaces of other kinds, which are left out by name. */
static bool is_other(const struct step_value *record)
{
    static const char *const kind[] = {"CSG_SOLID",
                                       "EXTRUDED_AREA_SOLID",
                                       "REVOLVED_AREA_SOLID",
                                       "TESSELLATED_SOLID",
                                       "TESSELLATED_SHELL",
                                       "TRIANGULATED_FACE",
                                       "COMPLEX_TRIANGULATED_FACE",
                                       "BOOLEAN_RESULT"};
    for (size_t i = 0; i < sizeof kind / sizeof *kind; i++)
        if (step_is(record, kind[i]))
            return true;
    return false;
}

static int add_item(struct model *m, const struct step_place *place, const struct step_values *from,
                    const struct step_value *reference, int depth, struct error *error);

/* A shell has a list of faces, a solid a shell: -1 where there is no reference. */
static int check_items(const struct model *m, const struct step_values *v, struct error *error)
{
    static const char *const shell[] = {"CLOSED_SHELL", "OPEN_SHELL", "CONNECTED_FACE_SET"};
    static const char *const solid[] = {"MANIFOLD_SOLID_BREP", "BREP_WITH_VOIDS", "FACETED_BREP"};
    const struct step_value *list = NULL, *one = NULL;
    for (size_t i = 0; i < 3; i++) {
        const struct step_value *a = step_item(step_record(v, shell[i]), 1);
        const struct step_value *b = step_item(step_record(v, solid[i]), 1);
        list = a ? a : list;
        one = b ? b : one;
    }
    if (list && list->kind == STEP_LIST && !step_item(list, 0))
        return step_refuse(m->step, v, "a shell without faces, expected some", error);
    for (const struct step_value *i = list ? step_item(list, 0) : NULL; i; i = step_next(list, i))
        if (i->kind != STEP_REFERENCE)
            return step_refuse(m->step, v, "no face where one belongs, expected # and a number",
                               error);
    if (one && one->kind != STEP_REFERENCE)
        return step_refuse(m->step, v, "no shell where one belongs, expected # and a number",
                           error);
    return 0;
}

/* All that the values of an instance refer to; of a solid with voids the first is its outer shell,
 * the others bound the voids. */
static int add_items(struct model *m, const struct step_place *place, const struct step_values *v,
                     int depth, struct error *error)
{
    bool voids = step_record(v, "BREP_WITH_VOIDS") != NULL, was = m->cavity;
    int status = check_items(m, v, error);
    for (size_t i = 0; i < v->n && status == 0; i++) {
        if (v->item[i].kind != STEP_REFERENCE)
            continue;
        status = add_item(m, place, v, &v->item[i], depth + 1, error);
        m->cavity = m->cavity || voids;
    }
    m->cavity = was;
    return status;
}

/* What it refers to ought to be faces. */
static bool is_shell(const struct step_values *v)
{
    return step_record(v, "CLOSED_SHELL") || step_record(v, "OPEN_SHELL");
}

static int add_item(struct model *m, const struct step_place *place, const struct step_values *from,
                    const struct step_value *reference, int depth, struct error *error)
{
    struct step_values v;
    if (follow_reference(m, from, reference, &v, error) < 0)
        return -1;
    const struct step_value *face = step_record(&v, "ADVANCED_FACE");
    face = face ? face : step_record(&v, "FACE_SURFACE");
    const struct step_value *first = step_item(v.item, 0);
    int status = count_visit(m, depth, &v, error), body = m->body;
    if (step_record(&v, "CLOSED_SHELL"))
        m->body = ++m->patches->bodies;
    struct patch patch = {.entity = (int)v.instance->id, .body = m->body};
    patch.cavity = m->body > 0 && m->cavity;
    if (status == 0 && face)
        status = step_face(place, &v, face, patch, m->patches, error);
    else if (status == 0 && holds_faces(&v))
        status = add_items(m, place, &v, depth, error);
    else if (status == 0 && is_free_surface(&v))
        status = add_free_surface(m, place, from, reference, &v, error);
    else if (status == 0 && (is_other(first) || is_shell(from))) {
        char kind[40] = "";
        memcpy(kind, first->text, first->length < 39 ? first->length : 39);
        patches_leave_out(m->patches, m->step->name, kind, (int)v.instance->id);
    }
    m->body = body;
    array_free(&v);
    return status;
}

/* ---- representations and assemblies */

static int add_group(struct model *m, long group, const struct transform *to, int depth,
                     struct error *error);

/* A representation is used in a place of another: `source` is its own axes, `target` those there.
 */
static int add_mapped(struct model *m, const struct step_place *place,
                      const struct step_values *mapped, int depth, struct error *error)
{
    const struct step_value *r = step_record(mapped, "MAPPED_ITEM");
    struct step_values map;
    struct transform source, target;
    if (follow_reference(m, mapped, step_item(r, 1), &map, error) < 0)
        return -1;
    const struct step_value *from = step_record(&map, "REPRESENTATION_MAP");
    long child = step_reference(step_item(from, 1));
    int status = step_axes(m->step, &map, step_item(from, 0), &source, error);
    array_free(&map);
    if (status < 0 || step_axes(m->step, mapped, step_item(r, 2), &target, error) < 0)
        return -1;
    target =
        transform_product(place->to, transform_product(target, step_assembly_inverse(&source)));
    /* the child's own unit comes with its items */
    target = transform_product(target, transform_scale(1 / place->mm));
    return add_group(m, step_assembly_leader(&m->assembly, child), &target, depth + 1, error);
}

/* The items of one representation, placed; `to` takes mm to mm. */
static int add_representation(struct model *m, const struct step_values *v,
                              const struct step_value *record, const struct transform *to,
                              int depth, struct error *error)
{
    struct step_place place = {.step = m->step};
    const struct step_value *list = step_item(record, 1);
    if (step_units(m->step, m->mm, v, step_item(record, 2), &place.mm, &place.angle, error) < 0)
        return -1;
    place.to = transform_product(*to, transform_scale(place.mm));
    for (const struct step_value *i = step_item(list, 0); i; i = step_next(list, i)) {
        struct step_values item;
        if (i->kind != STEP_REFERENCE)
            continue;
        if (follow_reference(m, v, i, &item, error) < 0)
            return -1;
        int status = count_visit(m, depth, &item, error);
        bool mapped = step_record(&item, "MAPPED_ITEM") != NULL;
        size_t before = m->patches->n;
        if (status == 0)
            status = mapped ? add_mapped(m, &place, &item, depth, error)
                            : add_item(m, &place, v, i, depth, error);
        if (depth == 0 && !mapped && m->patches->n > before) {
            *array_push(&m->unplaced) = before;
            *array_push(&m->unplaced) = m->patches->n;
        }
        array_free(&item);
        if (status < 0)
            return -1;
    }
    return 0;
}

/* The unit of one of the representations of a group. */
static int unit_of(struct model *m, long id, double *mm, struct error *error)
{
    const struct step_instance *i = step_find(m->step, id);
    struct step_values v;
    double angle;
    *mm = 1;
    if (!i || step_values(m->step, i, &v, error) < 0)
        return i ? -1 : 0;
    const struct step_value *r = step_item(v.item, 0);
    int status = step_is_representation(r)
                     ? step_units(m->step, m->mm, &v, step_item(r, 2), mm, &angle, error)
                     : 0;
    array_free(&v);
    return status;
}

static int add_component_group(struct model *m, const struct step_component *c,
                               const struct transform *to, int depth, struct error *error)
{
    double parent, child;
    if (unit_of(m, c->parent, &parent, error) < 0 || unit_of(m, c->child, &child, error) < 0)
        return -1;
    struct transform t = transform_product(transform_scale(parent), c->at);
    t = transform_product(t, transform_scale(1 / parent)); /* rotation, shift in mm */
    struct transform back = transform_product(transform_scale(child), c->to);
    back = transform_product(back, transform_scale(1 / child));
    t = transform_product(*to, transform_product(t, back));
    return add_group(m, step_assembly_leader(&m->assembly, c->child), &t, depth + 1, error);
}

/* All representations that are one, and their components. */
static int add_group(struct model *m, long group, const struct transform *to, int depth,
                     struct error *error)
{
    struct step_alias self = {group, group};
    /* all of them are gone through */
    m->visits += 1 + (long)((m->assembly.alias.n + m->assembly.component.n) / 64);
    const struct step_instance *first = step_find(m->step, group);
    if (m->visits > VISITS_MAX || depth > DEPTH_MAX)
        return error_at(error, m->step->name, first ? first->line : 1,
                        "representation #%ld is part of itself, or used too often, expected an "
                        "assembly that ends",
                        group);
    bool several = step_assembly_is_alias(&m->assembly, group);
    size_t n = several ? m->assembly.alias.n : 1;
    const struct step_alias *all = several ? m->assembly.alias.item : &self;
    for (size_t i = 0; i < n; i++) {
        const struct step_instance *instance = step_find(m->step, all[i].id);
        struct step_values v;
        if (step_assembly_leader(&m->assembly, all[i].id) != group || !instance)
            continue;
        if (step_values(m->step, instance, &v, error) < 0)
            return -1;
        const struct step_value *r = step_item(v.item, 0);
        int status = count_visit(m, depth, &v, error);
        if (status == 0 && step_is_representation(r))
            status = add_representation(m, &v, r, to, depth, error);
        array_free(&v);
        if (status < 0)
            return -1;
    }
    for (size_t i = 0; i < m->assembly.component.n; i++)
        if (step_assembly_leader(&m->assembly, m->assembly.component.item[i].parent) == group &&
            add_component_group(m, &m->assembly.component.item[i], to, depth, error) < 0)
            return -1;
    return 0;
}

/* Is the group a component of another, or mapped into one? */
static bool is_component(const struct model *m, const struct sizes *mapped, long group)
{
    for (size_t i = 0; i < m->assembly.component.n; i++)
        if (step_assembly_leader(&m->assembly, m->assembly.component.item[i].child) == group)
            return true;
    for (size_t i = 0; i < mapped->n; i++)
        if (step_assembly_leader(&m->assembly, (long)mapped->item[i]) == group)
            return true;
    return false;
}

/* The representations that items of one are mapped from. */
static int find_mapped(const struct model *m, const struct step_values *v,
                       const struct step_value *record, struct sizes *mapped, struct error *error)
{
    const struct step_value *list = step_item(record, 1);
    for (const struct step_value *i = step_item(list, 0); i; i = step_next(list, i)) {
        struct step_values item, map;
        if (i->kind != STEP_REFERENCE)
            continue;
        if (follow_reference(m, v, i, &item, error) < 0)
            return -1;
        const struct step_value *r = step_record(&item, "MAPPED_ITEM");
        int status = r ? follow_reference(m, &item, step_item(r, 1), &map, error) : 0;
        array_free(&item);
        if (status < 0)
            return -1;
        if (!r)
            continue;
        const struct step_value *from = step_record(&map, "REPRESENTATION_MAP");
        *array_push(mapped) = (size_t)step_reference(step_item(from, 1));
        array_free(&map);
    }
    return 0;
}

/* All groups of representations that are part of no other. */
static int add_roots(struct model *m, struct error *error)
{
    struct transform to = transform_identity();
    struct sizes mapped = {0}, root = {0};
    int status = 0;
    for (size_t i = 0; i < m->step->instance.n && status == 0; i++) {
        struct step_values v;
        status = step_values(m->step, &m->step->instance.item[i], &v, error);
        if (status < 0)
            break;
        const struct step_value *r = step_item(v.item, 0);
        if (step_is_representation(r))
            status = find_mapped(m, &v, r, &mapped, error);
        long id = m->step->instance.item[i].id;
        if (step_is_representation(r) && step_assembly_leader(&m->assembly, id) == id)
            *array_push(&root) = (size_t)id;
        array_free(&v);
    }
    for (size_t i = 0; i < root.n && status == 0; i++)
        if (!is_component(m, &mapped, (long)root.item[i]))
            status = add_group(m, (long)root.item[i], &to, 0, error);
    array_free(&mapped);
    array_free(&root);
    return status;
}

int step_surfaces(const struct step *step, double mm, struct patches *patches, struct error *error)
{
    struct model m = {.step = step, .patches = patches, .mm = mm};
    size_t before = patches->n, left = patches->left.n;
    int status = step_assembly_read(step, &m.assembly, error);
    if (status == 0)
        status = add_roots(&m, error);
    step_assembly_free(&m.assembly);
    step_drop_unplaced(patches, &m.unplaced, before);
    array_free(&m.unplaced);
    step_drop_named(patches, before);
    step_drop_repeated(patches, before);
    if (status == 0 && patches->n == before)
        return error_at(error, step->name, step->lines,
                        "no face of a solid or a shell %samong %zu instances, expected one",
                        patches->left.n > left ? "that is read " : "", step->instance.n);
    return status;
}
