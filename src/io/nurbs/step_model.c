/* step_model - see step_model.h. */
#include "step_model.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "nurbs/construct.h"
#include "nurbs/primitive.h"
#include "step_assembly.h"
#include "step_source.h"

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

/* ---- units */

/* Metres or radians in an SI_UNIT with its prefix. */
static double si_factor(const struct step_value *unit)
{
    static const struct {
        const char *name;
        double factor;
    } prefix[] = {{"EXA", 1e18},  {"PETA", 1e15},  {"TERA", 1e12},  {"GIGA", 1e9},
                  {"MEGA", 1e6},  {"KILO", 1e3},   {"HECTO", 100},  {"DECA", 10},
                  {"DECI", 0.1},  {"CENTI", 0.01}, {"MILLI", 1e-3}, {"MICRO", 1e-6},
                  {"NANO", 1e-9}, {"PICO", 1e-12}, {"FEMTO", 1e-15}};
    for (size_t i = 0; i < sizeof prefix / sizeof *prefix; i++)
        if (step_is(step_item(unit, 0), prefix[i].name))
            return prefix[i].factor;
    return 1;
}

/* The factor of a unit to metres or radians; a unit by conversion is some of another one. */
static int unit_factor(const struct model *m, const struct step_values *v, int depth,
                       double *factor, struct error *error)
{
    const struct step_value *si = step_record(v, "SI_UNIT");
    const struct step_value *converted = step_record(v, "CONVERSION_BASED_UNIT");
    struct step_values measure, unit;
    *factor = si ? si_factor(si) : 1;
    if (si || !converted || depth > 4)
        return 0;
    if (follow_reference(m, v, step_item(converted, 1), &measure, error) < 0)
        return -1;
    const struct step_value *with = step_item(measure.item, 0);
    for (const struct step_value *r = with; r; r = step_next(measure.item, r))
        with = step_item(r, 1) ? r : with; /* the one that holds value and unit */
    const struct step_value *value = step_item(with, 0);
    value = value && value->kind == STEP_RECORD ? step_item(value, 0) : value;
    int status = follow_reference(m, &measure, step_item(with, 1), &unit, error);
    if (status == 0) {
        status = unit_factor(m, &unit, depth + 1, factor, error);
        if (value && value->kind == STEP_NUMBER && value->number > 0)
            *factor *= value->number;
        array_free(&unit);
    }
    array_free(&measure);
    return status;
}

/* The units of a representation's context: mm, and radians of an angle. */
static int read_units(const struct model *m, const struct step_values *from,
                      const struct step_value *context, double *mm, double *angle,
                      struct error *error)
{
    struct step_values v, unit;
    *mm = m->mm > 0 ? m->mm : 1;
    *angle = 1;
    if (step_reference(context) == 0)
        return 0;
    if (follow_reference(m, from, context, &v, error) < 0)
        return -1;
    const struct step_value *list = step_item(step_record(&v, "GLOBAL_UNIT_ASSIGNED_CONTEXT"), 0);
    int status = 0;
    for (const struct step_value *i = step_item(list, 0); i && status == 0;
         i = step_next(list, i)) {
        double factor;
        status = follow_reference(m, &v, i, &unit, error);
        if (status < 0)
            break;
        status = unit_factor(m, &unit, 0, &factor, error);
        if (step_record(&unit, "LENGTH_UNIT"))
            *mm = 1000 * factor;
        if (step_record(&unit, "PLANE_ANGLE_UNIT"))
            *angle = factor;
        array_free(&unit);
    }
    array_free(&v);
    if (m->mm > 0)
        *mm = m->mm;
    return status;
}

/* ---- faces */

/* An ORIENTED_EDGE: the curve of its edge between the edge's vertices.  `edge` gets the number of
 * the EDGE_CURVE.  0, 1 when the curve is not read, or -1. */
static int add_edge(const struct step_place *place, const struct step_values *from,
                    const struct step_value *reference, struct patch_loop *loop, long *edge,
                    struct error *error)
{
    struct step_values oriented, v;
    struct vec3 ends[2];
    size_t first = loop->n;
    if (step_follow(place->step, from, reference, &oriented, error) < 0)
        return -1;
    const struct step_value *r = step_record(&oriented, "ORIENTED_EDGE");
    bool forwards, same;
    *edge = step_reference(step_item(r, 3));
    int got = step_follow(place->step, &oriented, step_item(r, 3), &v, error);
    if (got < 0) {
        array_free(&oriented);
        return -1;
    }
    const struct step_value *c = step_record(&v, "EDGE_CURVE");
    got = step_flag(place->step, &oriented, step_item(r, 4), &forwards, error);
    array_free(&oriented);
    if (got == 0)
        got = step_flag(place->step, &v, step_item(c, 4), &same, error);
    if (got == 0)
        got = step_vertex(place, &v, step_item(c, same ? 1 : 2), &ends[0], error);
    if (got == 0)
        got = step_vertex(place, &v, step_item(c, same ? 2 : 1), &ends[1], error);
    if (got == 0)
        got = step_curve(place, &v, step_item(c, 3), ends, loop, error);
    if (got == 0 && same != forwards)
        patch_loop_turn(loop, first);
    array_free(&v);
    return got;
}

/* Does every edge occur twice?  Then the loop runs along seams alone and bounds nothing. */
static bool is_all_seams(const long *edge, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        size_t times = 0;
        for (size_t k = 0; k < n && n <= 8; k++)
            times += edge[k] == edge[i];
        if (times != 2)
            return false;
    }
    return n > 0;
}

/* The straight lines between the corners of a POLY_LOOP. */
static int read_polygon(const struct step_place *place, const struct step_values *v,
                        const struct step_value *corners, struct patch_loop *loop,
                        struct error *error)
{
    struct vec3s corner = {0};
    int status = 0;
    for (const struct step_value *i = step_item(corners, 0); i && status == 0;
         i = step_next(corners, i))
        status = step_vertex(place, v, i, array_push(&corner), error);
    for (size_t i = 0; i < corner.n && status == 0 && corner.n > 2; i++)
        *array_push(loop) = construct_line(corner.item[i], corner.item[(i + 1) % corner.n]);
    array_free(&corner);
    return status;
}

/* The edges of an EDGE_LOOP, or the points of a POLY_LOOP or a VERTEX_LOOP. */
static int read_loop(const struct step_place *place, const struct step_values *v,
                     struct patch_loop *loop, struct vec3s *points, struct error *error)
{
    struct {
        size_t n, cap;
        long *item;
    } edge = {0};
    const struct step_value *list = step_item(step_record(v, "EDGE_LOOP"), 1);
    const struct step_value *vertex = step_record(v, "VERTEX_LOOP");
    const struct step_value *corners = step_item(step_record(v, "POLY_LOOP"), 1);
    int got = 0;
    for (const struct step_value *i = step_item(list, 0); i && got == 0; i = step_next(list, i))
        got = add_edge(place, v, i, loop, array_push(&edge), error);
    if (corners)
        got = read_polygon(place, v, corners, loop, error);
    else if (vertex)
        got = step_vertex(place, v, step_item(vertex, 1), array_push(points), error);
    else if (!list)
        got = 1;
    struct patch_loops one = {1, 1, loop};
    if (got == 0)
        primitive_points(&one, points);
    if (got == 0 && is_all_seams(edge.item, edge.n))
        patch_loop_free(loop);
    array_free(&edge);
    return got;
}

/* A FACE_BOUND or FACE_OUTER_BOUND, so that what counts is on its left as the surface has it. */
static int add_bound(const struct step_place *place, const struct step_values *from,
                     const struct step_value *reference, bool same_sense, struct patch *patch,
                     struct vec3s *points, struct error *error)
{
    struct step_values bound, v;
    if (step_follow(place->step, from, reference, &bound, error) < 0)
        return -1;
    const struct step_value *r = step_record(&bound, "FACE_OUTER_BOUND");
    r = r ? r : step_record(&bound, "FACE_BOUND");
    bool forwards = false;
    int got = step_follow(place->step, &bound, step_item(r, 1), &v, error);
    if (got < 0) {
        array_free(&bound);
        return -1;
    }
    struct patch_loop loop = {.space = true, .directed = true};
    got = step_flag(place->step, &bound, step_item(r, 2), &forwards, error);
    array_free(&bound);
    if (got == 0)
        got = read_loop(place, &v, &loop, points, error);
    if (got > 0 && patch->ignored++ == 0)
        patch->ignored_entity = (int)v.instance->id;
    array_free(&v);
    if (forwards != same_sense)
        patch_loop_turn(&loop, 0);
    if (got == 0 && loop.n > 0)
        *array_push(&patch->loop) = loop;
    else
        patch_loop_free(&loop);
    return got < 0 ? -1 : 0;
}

static int add_face(struct model *m, const struct step_place *place, const struct step_values *v,
                    const struct step_value *face, struct error *error)
{
    struct patch patch = {
        .entity = (int)v->instance->id, .body = m->body, .cavity = m->body > 0 && m->cavity};
    struct vec3s points = {0};
    char kind[40] = "";
    const struct step_value *list = step_item(face, 1);
    bool same;
    int got = step_flag(m->step, v, step_item(face, 3), &same, error);
    for (const struct step_value *i = step_item(list, 0); i && got == 0; i = step_next(list, i))
        got = add_bound(place, v, i, same, &patch, &points, error);
    if (got == 0)
        got = step_surface(place, v, step_item(face, 2), &points, &patch.surface, &patch.rough,
                           kind, error);
    array_free(&points);
    if (got == 0) {
        patch.file = mem_string(m->step->name, strlen(m->step->name));
        patch.open = patch.ignored > 0;
        *array_push(&m->patches[0]) = patch;
        return 0;
    }
    if (got > 0)
        patches_leave_out(m->patches, m->step->name, kind, patch.entity);
    patch_free(&patch);
    return got < 0 ? -1 : 0;
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
    if (status == 0 && face)
        status = add_face(m, place, &v, face, error);
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
    if (read_units(m, v, step_item(record, 2), &place.mm, &place.angle, error) < 0)
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
    int status =
        step_is_representation(r) ? read_units(m, &v, step_item(r, 2), mm, &angle, error) : 0;
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

static int compare_entities(const void *p, const void *q)
{
    int a = *(const int *)p, b = *(const int *)q;
    return (a > b) - (a < b);
}

static void sort_entities(struct ints *entity)
{
    if (entity->n > 0)
        qsort(entity->item, entity->n, sizeof *entity->item, compare_entities);
}

static bool has_entity(const struct ints *sorted, int entity)
{
    return sorted->n > 0 &&
           bsearch(&entity, sorted->item, sorted->n, sizeof entity, compare_entities) != NULL;
}

/* Drops the faces that are marked. */
static void drop_marked(struct patches *patches, size_t from, const bool *marked)
{
    size_t kept = from;
    for (size_t i = from; i < patches->n; i++) {
        if (marked[i])
            patch_free(&patches->item[i]);
        else
            patches->item[kept++] = patches->item[i];
    }
    patches->n = kept;
}

/* Drops what a representation that is part of no assembly shows of a component, as some systems
 * write for the solid that a volume or an area is told of: it is where the assembly has it. */
static void drop_unplaced(struct model *m, size_t from)
{
    struct patches *patches = m->patches;
    struct ints placed = {0};
    bool *marked = mem_alloc(patches->n + 1, sizeof *marked);
    for (size_t i = 0; i + 1 < m->unplaced.n; i += 2)
        for (size_t k = m->unplaced.item[i]; k < m->unplaced.item[i + 1]; k++)
            marked[k] = true;
    for (size_t i = from; i < patches->n; i++)
        if (!marked[i])
            *array_push(&placed) = patches->item[i].entity;
    sort_entities(&placed);
    for (size_t i = from; i < patches->n; i++)
        marked[i] = marked[i] && has_entity(&placed, patches->item[i].entity);
    drop_marked(patches, from, marked);
    array_free(&placed);
    free(marked);
}

/* Drops faces that a representation names by themselves, as the place of a tolerance or a colour,
 * when they are faces of a closed shell too. */
static void drop_named_faces(struct patches *patches, size_t from)
{
    struct ints of_shell = {0};
    bool *marked = mem_alloc(patches->n + 1, sizeof *marked);
    for (size_t i = from; i < patches->n; i++)
        if (patches->item[i].body > 0)
            *array_push(&of_shell) = patches->item[i].entity;
    sort_entities(&of_shell);
    for (size_t i = from; i < patches->n; i++)
        marked[i] = patches->item[i].body == 0 && has_entity(&of_shell, patches->item[i].entity);
    drop_marked(patches, from, marked);
    array_free(&of_shell);
    free(marked);
}

/* A face among all. */
struct placed {
    const struct patch *patch;
    size_t index;
};

static int compare_surfaces(const struct nurbs *a, const struct nurbs *b)
{
    size_t n = a->u.poles * a->v.poles, k = b->u.poles * b->v.poles;
    return n != k ? (n > k) - (n < k) : memcmp(a->pole, b->pole, n * sizeof *a->pole);
}

/* By entity, by place, then as they come. */
static int compare_placed(const void *p, const void *q)
{
    const struct placed *a = p, *b = q;
    int by = compare_entities(&a->patch->entity, &b->patch->entity);
    if (by == 0)
        by = compare_surfaces(&a->patch->surface, &b->patch->surface);
    return by != 0 ? by : (a->index > b->index) - (a->index < b->index);
}

/* Drops what several representations show in the same place: it is there once. */
static void drop_repeated(struct patches *patches, size_t from)
{
    size_t n = patches->n - from;
    struct placed *all = mem_alloc(n + 1, sizeof *all);
    bool *again = mem_alloc(patches->n + 1, sizeof *again);
    for (size_t i = 0; i < n; i++)
        all[i] = (struct placed){&patches->item[from + i], from + i};
    if (n > 0)
        qsort(all, n, sizeof *all, compare_placed);
    for (size_t i = 1; i < n; i++)
        again[all[i].index] =
            all[i].patch->entity == all[i - 1].patch->entity &&
            compare_surfaces(&all[i].patch->surface, &all[i - 1].patch->surface) == 0;
    drop_marked(patches, from, again);
    free(all);
    free(again);
}

int step_surfaces(const struct step *step, double mm, struct patches *patches, struct error *error)
{
    struct model m = {.step = step, .patches = patches, .mm = mm};
    size_t before = patches->n, left = patches->left.n;
    int status = step_assembly_read(step, &m.assembly, error);
    if (status == 0)
        status = add_roots(&m, error);
    step_assembly_free(&m.assembly);
    drop_unplaced(&m, before);
    array_free(&m.unplaced);
    drop_named_faces(patches, before);
    drop_repeated(patches, before);
    if (status == 0 && patches->n == before)
        return error_at(error, step->name, step->lines,
                        "no face of a solid or a shell %samong %zu instances, expected one",
                        patches->left.n > left ? "that is read " : "", step->instance.n);
    return status;
}
