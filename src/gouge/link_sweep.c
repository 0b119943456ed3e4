/* link_sweep - see link_sweep.h. */
#include "link_sweep.h"

#include <stdlib.h>

struct vec3 link_outward(const struct run_point *p)
{
    return vec_length(p->normal) > 0 ? p->normal : p->axis;
}

static struct pose tip_of(const struct run_point *p, double radius)
{
    return (struct pose){vec_along(p->ball, -radius, p->axis), p->axis};
}

struct link_sweep link_sweep_begin(const struct link_options *options)
{
    return (struct link_sweep){.tool = {.guard = options->lift->guard,
                                        .radius = options->radius,
                                        .tolerance = options->lift->tolerance,
                                        .holder = *options->holder}};
}

void link_sweep_to(struct link_sweep *s, const struct run_point *from, const struct run_point *to)
{
    struct motion line = motion_line(tip_of(from, s->tool.radius), tip_of(to, s->tool.radius));

    gouge_refit_motion(&s->tool, &line, &s->track, &s->gouges);
}

void link_sweep_end(struct link_sweep *s)
{
    array_free(&s->gouges);
    gouge_track_free(&s->track);
}
