/* arcrun_read - runs out of a path, and reports put together; see arcrun.h. */
#include <math.h>
#include <stdlib.h>

#include "stage/arcrun.h"

struct run arcrun_read(const struct path *path, size_t from, size_t to)
{
    struct run run = {.radius = fmax(0, path_ball(path))};
    for (size_t i = from; i < to; i++) {
        const struct path_item *item = &path->item.item[i];
        struct run_point p = {.tip = item->to.p, .ball = item->to.p, .axis = item->to.a};
        p.given = true;
        if (path->head.track == TRACK_CENTRE)
            p.tip = vec_along(p.ball, -run.radius, p.axis);
        else
            p.ball = vec_along(p.tip, run.radius, p.axis);
        if (item->touches) {
            p.contact = path->contact.item[item->contact].p;
            p.normal = path->contact.item[item->contact].n;
        }
        *array_push(&run) = p;
    }
    return run;
}

void arcrun_add(struct arcrun_report *sum, const struct arcrun_report *report)
{
    sum->points += report->points;
    sum->arcs += report->arcs;
    sum->lines += report->lines;
    sum->c += report->c;
    sum->s += report->s;
    sum->loops += report->loops;
    sum->corners += report->corners;
    sum->kinks += report->kinks;
    sum->length += report->length;
    sum->spent = fmax(sum->spent, report->spent);
    sum->worst = deviation_worst(sum->worst, report->worst);
}
