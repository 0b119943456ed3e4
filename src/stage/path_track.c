/* path_track - see path_track.h. */
#include "stage/path_track.h"

static int refuse(const struct path *path, enum path_track track, struct error *error)
{
    bool touches = false;

    if (path->head.track == TRACK_CONTACT)
        return error_set(error,
                         "%s: found a path of contact points, expected one of tool positions",
                         path->name);
    if (path_ball(path) < 0)
        return error_set(error, "%s: found no ball cutter, expected one to track another point of",
                         path->name);
    for (size_t i = 0; i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        if (item->kind == PATH_ARC || item->kind == PATH_SPLINE)
            return error_set(error, "%s:%u: found an arc or a B-spline, expected points alone",
                             path->name, item->line);
        touches = touches || item->touches;
    }
    if (track == TRACK_CONTACT && !touches)
        return error_set(error, "%s: found no contact points, expected them ($$-> CONTCT)",
                         path->name);
    return 0;
}

int path_set_track(struct path *path, enum path_track track, struct error *error)
{
    if (path->head.track == track)
        return 0;
    if (refuse(path, track, error) != 0)
        return -1;
    double radius = path_ball(path);
    double up = track == TRACK_CENTRE ? radius : 0; /* from the tip */
    double was = path->head.track == TRACK_CENTRE ? radius : 0;

    for (size_t i = 0; i < path->item.n; i++) {
        struct path_item *item = &path->item.item[i];
        if (item->kind != PATH_POINT)
            continue;
        item->to.p = vec_along(item->to.p, up - was, item->to.a);
        if (track == TRACK_CONTACT && item->touches)
            item->to.p = path->contact.item[item->contact].p;
    }
    path->head.track = track;
    return 0;
}
