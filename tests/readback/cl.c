#include "cl.h"

#include <stdlib.h>

/* Angle of an arc by the right-hand rule, above 0 up to a full turn. */
static double arc_angle(const struct path_arc *arc, struct vec3 from, struct vec3 to)
{
    struct vec3 u = vec_reject(vec_sub(from, arc->centre), arc->axis);
    struct vec3 v = vec_reject(vec_sub(to, arc->centre), arc->axis);
    double angle = atan2(vec_dot(vec_cross(u, v), arc->axis), vec_dot(u, v));
    if (vec_distance(from, to) < 1e-9)
        return 2 * PI;
    return angle > 0 ? angle : angle + 2 * PI;
}

static void *copied(const void *from, size_t n, size_t size)
{
    char *to = mem_alloc(n, size);
    const char *s = from;
    for (size_t i = 0; i < n * size; i++)
        to[i] = s[i];
    return to;
}

static void add_spline(struct course *course, const struct bspline *curve, struct piece *piece)
{
    size_t order = (size_t)curve->degree + 1;
    struct course_spline b = {.order = curve->degree + 1, .n = curve->poles};
    b.knot = copied(curve->knot, curve->poles + order, sizeof *b.knot);
    b.p = copied(curve->pole, curve->poles, sizeof *b.p);
    if (curve->head) {
        b.q = copied(curve->head, curve->poles, sizeof *b.q);
        piece->swing = SWING_HEAD;
    }
    course_add_spline(course, b, piece);
}

static void add_item(struct course *course, const struct path *path, const struct path_item *item,
                     struct pose from)
{
    struct piece piece = {.rapid = item->rapid && item->kind == PATH_POINT,
                          .line = item->line,
                          .block = -1,
                          .touches = item->touches,
                          .p = {from.p, item->to.p},
                          .q = {from.a, item->to.a}};
    course->blocks++;
    if (item->kind == PATH_SPLINE) {
        add_spline(course, &path->spline.item[item->index].curve, &piece);
        return;
    }
    if (item->kind == PATH_ARC) {
        const struct path_arc *arc = &path->arc.item[item->index];
        piece.shape = SHAPE_ARC;
        piece.index = course->arc.n;
        *array_push(&course->arc) = (struct course_arc){arc->centre, vec_unit(arc->axis),
                                                        arc_angle(arc, from.p, item->to.p)};
        course->arcs++;
    } else if (!piece.rapid) {
        course->lines++;
    }
    *array_push(&course->piece) = piece;
}

static enum course_track track_of(enum path_track track)
{
    return track == TRACK_TIP ? COURSE_TIP : track == TRACK_CENTRE ? COURSE_CENTRE : COURSE_CONTACT;
}

int cl_read(const char *file, struct path *path, struct course *course, struct error *error)
{
    if (path_read(file, path, error) < 0)
        return -1;
    path_drill(path);
    course->name = file;
    course->track = track_of(path->head.track);
    const struct pose *from = NULL;
    for (size_t i = 0; i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        if (item->kind == PATH_PASS)
            course->passes++;
        if (item->kind != PATH_POINT && item->kind != PATH_ARC && item->kind != PATH_SPLINE)
            continue;
        /* The place before the first statement is not known: it is reached from itself. */
        if (!from && item->kind != PATH_POINT)
            return error_at(error, file, item->line, "a curve before the first GOTO");
        add_item(course, path, item, from ? *from : item->to);
        from = &item->to;
    }
    return 0;
}
