/* path_motion - see path_motion.h. */
#include "stage/path_motion.h"

#include <string.h>

#include "base/array.h"

static struct nc_piece piece_from(const struct path_item *item, struct pose from, double feed)
{
    return (struct nc_piece){.interpolation = AXIS_GREAT_CIRCLE,
                             .rapid = item->kind == PATH_POINT && item->rapid,
                             .block = -1,
                             .line = item->line,
                             .feed = feed,
                             .p = {from.p, item->to.p},
                             .q = {from.a, item->to.a}};
}

/* By the right-hand rule; a start that is the end is a full turn. */
static void add_arc(struct nc_motion *motion, const struct path_arc *arc, struct nc_piece piece)
{
    struct vec3 u = vec_reject(vec_sub(piece.p[0], arc->centre), arc->axis);
    struct vec3 v = vec_reject(vec_sub(piece.p[1], arc->centre), arc->axis);
    double angle = atan2(vec_dot(vec_cross(u, v), arc->axis), vec_dot(u, v));
    piece.shape = SHAPE_ARC;
    piece.index = motion->arc.n;
    *array_push(&motion->arc) = (struct nc_motion_arc){
        arc->centre, arc->axis, vec_distance(u, v) < 1e-9 || angle <= 0 ? angle + 2 * PI : angle};
    *array_push(&motion->piece) = piece;
}

static void *copy_of(const void *from, size_t n, size_t size)
{
    void *copy = mem_alloc(n, size);
    return memcpy(copy, from, n * size);
}

static void add_spline(struct nc_motion *motion, const struct bspline *b, struct nc_piece piece)
{
    struct nc_motion_spline spline = {
        .order = b->degree + 1,
        .n = b->poles,
        .knot = copy_of(b->knot, b->poles + (size_t)b->degree + 1, sizeof *b->knot),
        .p = copy_of(b->pole, b->poles, sizeof *b->pole),
        .q = b->head ? copy_of(b->head, b->poles, sizeof *b->head) : NULL};
    if (b->head)
        piece.interpolation = AXIS_BY_HEAD;
    nc_motion_add_spline(motion, spline, &piece);
}

int path_motion_of(const struct path *path, struct nc_motion *motion, struct error *error)
{
    struct pose at = {{0, 0, 0}, {0, 0, 1}};
    bool known = false;
    double feed = 0;
    if (path->head.track == TRACK_CONTACT)
        return error_set(error,
                         "%s: found a path of contact points, expected the tip or the centre",
                         path->name);
    *motion = (struct nc_motion){.name = path->name,
                                 .kinematics = {.tool = {0, 0, 1}},
                                 .track = path->head.track == TRACK_CENTRE ? NC_MOTION_CENTRE
                                                                           : NC_MOTION_TIP};
    for (size_t i = 0; i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        struct pose from = known ? at : item->to;
        if (item->kind == PATH_FEED)
            feed = item->feed;
        if (item->kind == PATH_POINT)
            *array_push(&motion->piece) = piece_from(item, from, feed);
        else if (item->kind == PATH_ARC)
            add_arc(motion, &path->arc.item[item->index], piece_from(item, from, feed));
        else if (item->kind == PATH_SPLINE)
            add_spline(motion, &path->spline.item[item->index].curve, piece_from(item, from, feed));
        else if (item->kind != PATH_HOLE)
            continue;
        at = item->to;
        known = true;
    }
    return 0;
}
