/*
 * ncstep - one motion of a path into blocks, from where the last one ended.
 */
#ifndef CLOUDMILL_NCSTEP_H
#define CLOUDMILL_NCSTEP_H

#include "post/ncplan.h"
#include "machine/ik_near.h"
#include "machine/ik_plan.h"

/* Where the program is. */
struct nc_state {
    bool begun;                /* pose and at are known */
    struct pose pose;          /* as the path means it */
    struct block_pose at;      /* as the last block says it */
    struct turned turned;      /* of its rotary axes */
    struct pose_deviation off; /* of `at` from `pose` by its rounding, see nc_reach_beside; NAN: not
                             known */
    double feed;               /* mm/min, 0: not given yet */
    double faster;             /* the tracked point goes faster than that by this factor */
    bool touches;              /* the contact at `pose` is known */
    struct contact contact;
    enum nc_why why; /* of the blocks that are made now */
    size_t pass;
    unsigned line;
};

/* What a look ahead (ncahead.h) has found for a motion. */
struct nc_course {
    size_t n; /* of its places, the one where it starts with them; 0:
                 none, the rotary axes go the nearest way */
    const struct ik_plan_place *place;
    const double *s; /* how far along the motion, but of the first, 0 to 1 */
};

/* Where on a motion, 0 to 1, the tool retracts and turns: to these angles. */
struct nc_stop {
    double s, q[ROTARY_MAX];
};

struct nc_stops {
    size_t n, cap;
    struct nc_stop *item;
};

struct nc_step {
    const struct path *path;
    const struct machine *machine;
    struct nc_plan *plan;
    struct interpolation follow;
    struct nc_plan_options wish;
    struct pose_deviation allowed; /* of a block, with rounding */
    double clear;                  /* z above which the path goes at rapid, NAN: not known */
    struct nc_state state;
    struct nc_course nc_motion; /* for the next motion */
    struct ik_near_table ways;  /* of the machine */
    double within;              /* nc_surely_within of the machine */
    size_t next;                /* the item of the path that comes next */
    size_t tilted;         /* looked for from there: the next whose tool axis is not singular */
    bool first;            /* the next motion may take either solution: the tool is off the part */
    bool doubt;            /* the nearest way may not have been the shortest of all */
    struct nc_stops stops; /* inside of the next motion */
    bool may_turn;         /* retract - turn - return is allowed */
    struct error *error;
};

/* At the machine's rapid, straight to a pose. */
int nc_step_rapid(struct nc_step *step, struct pose to);

/* At feed, straight to a pose. */
int nc_step_line(struct nc_step *step, struct pose to);

/* At feed, along a motion that starts where the program is. */
int nc_step_motion(struct nc_step *step, const struct motion *motion);

#endif
