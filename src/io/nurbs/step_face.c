/* step_face - see step_face.h. */
#include "step_face.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "nurbs/construct.h"
#include "nurbs/primitive.h"
#include "step_assembly.h"
#include "step_source.h"

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

/* Does a word of the name say that it is a surface? */
static bool names_surface(const struct step_value *record)
{
    static const char word[] = "SURFACE";
    size_t n = sizeof word - 1;
    for (size_t i = 0; i + n <= record->length; i++)
        if (memcmp(record->text + i, word, n) == 0)
            return true;
    return step_is(record, "PLANE");
}

/* What is not read is left out; what is no surface at all has no place in a face. */
static int check_surface(const struct step_place *place, const struct step_values *v,
                         const struct step_value *reference, struct error *error)
{
    struct step_values surface;
    if (step_follow(place->step, v, reference, &surface, error) < 0)
        return -1;
    const struct step_value *first = step_item(surface.item, 0), *r = first;
    while (r && !names_surface(r))
        r = step_next(surface.item, r);
    int status = r || !first
                     ? 0
                     : error_at(error, place->step->name, v->instance->line,
                                "#%ld: a face on #%ld, which is a %.*s, expected a surface",
                                v->instance->id, surface.instance->id,
                                (int)(first->length < 39 ? first->length : 39), first->text);
    array_free(&surface);
    return status;
}

int step_face(const struct step_place *place, const struct step_values *v,
              const struct step_value *face, struct patch patch, struct patches *patches,
              struct error *error)
{
    struct vec3s points = {0};
    char kind[40] = "";
    const struct step_value *list = step_item(face, 1);
    bool same;
    int got = step_flag(place->step, v, step_item(face, 3), &same, error);
    if (got == 0 && (!list || list->kind != STEP_LIST))
        got = error_at(error, place->step->name, v->instance->line,
                       "#%ld: no list of bounds where one belongs, expected it", v->instance->id);
    for (const struct step_value *i = step_item(list, 0); i && got == 0; i = step_next(list, i))
        got = add_bound(place, v, i, same, &patch, &points, error);
    if (got == 0)
        got = step_surface(place, v, step_item(face, 2), &points, &patch.surface, &patch.rough,
                           kind, error);
    array_free(&points);
    if (got == 0) {
        patch.file = mem_string(place->step->name, strlen(place->step->name));
        patch.open = patch.ignored > 0;
        *array_push(patches) = patch;
        return 0;
    }
    if (got > 0)
        got = check_surface(place, v, step_item(face, 2), error) < 0 ? -1 : got;
    if (got > 0)
        patches_leave_out(patches, place->step->name, kind, patch.entity);
    patch_free(&patch);
    return got < 0 ? -1 : 0;
}
