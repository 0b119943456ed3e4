/* path_run - see path_run.h. */
#include "io/path/path_run.h"

struct run path_run_read(const struct path *path, size_t from, size_t to)
{
    double ball = path->head.track == TRACK_CONTACT ? 0 : path_ball(path);
    double up = path->head.track == TRACK_CENTRE ? 0 : 1; /* radii from the tracked point */
    struct run run = {.radius = ball > 0 ? ball : 0};

    for (size_t i = from; i < to; i++) {
        const struct path_item *item = &path->item.item[i];
        struct run_point p = {.axis = item->to.a, .given = true};

        p.ball = vec_along(item->to.p, up * run.radius, item->to.a);
        p.tip = vec_along(item->to.p, (up - 1) * run.radius, item->to.a);
        if (item->touches) {
            p.contact = path->contact.item[item->contact].p;
            p.normal = path->contact.item[item->contact].n;
        }
        *array_push(&run) = p;
    }
    return run;
}
