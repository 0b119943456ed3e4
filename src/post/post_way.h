/*
 * post_way - whether the linear axes keep their travel on the way between two places.
 *
 * Where the control leads the tip and the rotary axes turn, the linear axes go on a curve that may
 * leave their travel between two places within it; so they may where the axes stand at zero first
 * (key tcp.frame), of which no place of the path says anything.
 */
#ifndef CLOUDMILL_POST_WAY_H
#define CLOUDMILL_POST_WAY_H

#include "post_planner.h"

/* No linear axis can leave its travel on a straight block, and at its end: both ends are so near to
 * 0, or, where the linear axes are what the block says, the end is within. */
static inline bool post_way_is_safe(const struct nc_planner *planner, const struct block_pose *from,
                                    const struct block_pose *to)
{
    const struct machine *m = planner->machine;
    double near = planner->safe_radius * planner->safe_radius;
    if (planner->follow.mode != INTERPOLATE_JOINT)
        return vec_dot(from->p, from->p) < near && vec_dot(to->p, to->p) < near;
    return to->p.x >= m->min[MACHINE_X] && to->p.x <= m->max[MACHINE_X] &&
           to->p.y >= m->min[MACHINE_Y] && to->p.y <= m->max[MACHINE_Y] &&
           to->p.z >= m->min[MACHINE_Z] && to->p.z <= m->max[MACHINE_Z];
}

/* A straight block, at its end and, by steps, on its way. */
struct nc_over post_way_over(const struct nc_planner *planner, const struct block_pose *from,
                             const struct block_pose *to);

/*
 * The way from home to the first place of a tool, `to`, as its axis `axis` is there: where the
 * rotary axes stand at zero first, there, then from zero on.  Where that leaves the travel, *by is
 * filled: a place as high, nearer to 0, from which they may turn and the tool then goes to `to` as
 * it stands; `to` must be above all that is cut.  .is: there is none.
 */
struct nc_over post_way_from_home(const struct nc_planner *planner, const struct block_pose *to,
                                  struct vec3 axis, struct block_pose *by);

/* -1 with the error filled and the plan unmet. */
int post_way_tell(struct nc_planner *planner, const struct nc_over *over, const char *what);

#endif
