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

static void add_spline(struct nc_motion *nc_motion, const struct bspline *curve,
                       struct nc_piece *piece)
{
    size_t order = (size_t)curve->degree + 1;
    struct nc_motion_spline b = {.order = curve->degree + 1, .n = curve->poles};
    b.knot = copied(curve->knot, curve->poles + order, sizeof *b.knot);
    b.p = copied(curve->pole, curve->poles, sizeof *b.p);
    if (curve->head) {
        b.q = copied(curve->head, curve->poles, sizeof *b.q);
        piece->swing = SWING_HEAD;
    }
    nc_motion_add_spline(nc_motion, b, piece);
}

static void add_item(struct nc_motion *nc_motion, const struct path *path,
                     const struct path_item *item, struct pose from)
{
    struct nc_piece piece = {.rapid = item->rapid && item->kind == PATH_POINT,
                             .line = item->line,
                             .block = -1,
                             .touches = item->touches,
                             .p = {from.p, item->to.p},
                             .q = {from.a, item->to.a}};
    nc_motion->blocks++;
    if (item->kind == PATH_SPLINE) {
        add_spline(nc_motion, &path->spline.item[item->index].curve, &piece);
        return;
    }
    if (item->kind == PATH_ARC) {
        const struct path_arc *arc = &path->arc.item[item->index];
        piece.shape = SHAPE_ARC;
        piece.index = nc_motion->arc.n;
        *array_push(&nc_motion->arc) = (struct nc_motion_arc){arc->centre, vec_unit(arc->axis),
                                                              arc_angle(arc, from.p, item->to.p)};
        nc_motion->arcs++;
    } else if (!piece.rapid) {
        nc_motion->lines++;
    }
    *array_push(&nc_motion->piece) = piece;
}

static enum nc_motion_track track_of(enum path_track track)
{
    return track == TRACK_TIP      ? NC_MOTION_TIP
           : track == TRACK_CENTRE ? NC_MOTION_CENTRE
                                   : NC_MOTION_CONTACT;
}

int cl_read(const char *file, struct path *path, struct nc_motion *nc_motion, struct error *error)
{
    if (path_read(file, path, error) < 0)
        return -1;
    path_drill(path);
    nc_motion->name = file;
    nc_motion->track = track_of(path->head.track);
    const struct pose *from = NULL;
    for (size_t i = 0; i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        if (item->kind == PATH_PASS)
            nc_motion->passes++;
        if (item->kind != PATH_POINT && item->kind != PATH_ARC && item->kind != PATH_SPLINE)
            continue;
        /* The place before the first statement is not known: it is reached from itself. */
        if (!from && item->kind != PATH_POINT)
            return error_at(error, file, item->line, "a curve before the first GOTO");
        add_item(nc_motion, path, item, from ? *from : item->to);
        from = &item->to;
    }
    return 0;
}
