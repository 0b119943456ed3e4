/* path_tilt - see path_tilt.h. */
#include "stage/path_tilt.h"

#include <stdlib.h>

#include "io/path/path_run.h"
#include "toolpath/tilt.h"

static const double SAME_AXIS = 1e-8;

/* The change at one end of a run. */
struct change {
    bool any;
    struct pose was, now;
};

/* A move with the old axis takes the new one; both points of the tool move as at the run's end. */
static bool shift_move(struct path *path, struct path_item *item, const struct change *c)
{
    if (!c->any || (item->kind != PATH_POINT && item->kind != PATH_ARC) ||
        vec_distance(item->to.a, c->was.a) > SAME_AXIS)
        return false;
    struct vec3 by = vec_sub(c->now.p, c->was.p);
    item->to.p = vec_add(item->to.p, by);
    item->to.a = c->now.a;
    if (item->kind == PATH_ARC) {
        struct path_arc *arc = &path->arc.item[item->index];
        arc->centre = vec_add(arc->centre, by);
    }
    return true;
}

/* The moves between two runs: back from the run after them, then on from the run before. */
static void shift_between(struct path *path, size_t from, size_t to, const struct change *before,
                          const struct change *next)
{
    size_t end = to;
    while (end > from) {
        struct path_item *item = &path->item.item[end - 1];
        bool move = item->kind == PATH_POINT || item->kind == PATH_ARC;
        if (move && !shift_move(path, item, next))
            break;
        end--;
    }
    for (size_t i = from; i < end; i++)
        shift_move(path, &path->item.item[i], before);
}

static struct pose tracked_pose(const struct path *path, const struct run_point *p)
{
    return (struct pose){path->head.track == TRACK_CENTRE ? p->ball : p->tip, p->axis};
}

/* The first cutting motion that is a curve already: its axis would stay; NULL: there is none. */
static const struct path_item *find_fitted(const struct path *path)
{
    for (size_t i = 0; i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        if (item->touches && (item->kind == PATH_ARC || item->kind == PATH_SPLINE))
            return item;
    }
    return NULL;
}

int path_set_tilt(struct path *path, double angle, bool frenet, struct error *error)
{
    if (path_ball(path) < 0)
        return error_set(error, "%s: found no ball cutter, expected one to tilt", path->name);
    const struct path_item *fitted = find_fitted(path);
    if (fitted)
        return error_set(error,
                         "%s:%u: found an arc or a spline in a cut, expected points to tilt at: "
                         "tilt before fitting",
                         path->name, fitted->line);
    struct vec3 side = {0};
    struct change before = {0};
    size_t done = 0;
    for (size_t from = 0, to; path_next_run(path, &from, &to); from = to) {
        if (!path->item.item[from].touches)
            return error_set(error, "%s: found no contact points, expected them to tilt by",
                             path->name);
        struct path_item *item = path->item.item;
        struct change next = {.any = true, .was = item[from].to};
        struct change after = {.any = true, .was = item[to - 1].to};
        struct run run = path_run_read(path, from, to);
        tilt_run(&run, angle, frenet, &side);
        for (size_t i = from; i < to; i++)
            item[i].to = tracked_pose(path, &run.item[i - from]);
        next.now = item[from].to;
        after.now = item[to - 1].to;
        array_free(&run);
        shift_between(path, done, from, &before, &next);
        before = after;
        done = to;
    }
    shift_between(path, done, path->item.n, &before, &(struct change){0});
    return 0;
}
