/*
 * post_planner - the planner between two blocks: where the program stands, what it may do next.
 *
 * Its modules, each using those before it: post_ik (a pose as words), post_way (the linear axes on
 * the way), post_feed (how fast a block may be), post_block (one more block), post_straight (a
 * motion as straight blocks), post_motion (as arcs and curves, too), post_rewind (retract, turn,
 * return), post_item (an item of the path), post_lookahead (the rotary axes of a group),
 * post_group (the whole path, group by group).
 */
#ifndef CLOUDMILL_POST_PLANNER_H
#define CLOUDMILL_POST_PLANNER_H

#include "machine/ik_near.h"
#include "machine/ik_plan.h"
#include "math/box.h"
#include "post_plan.h"

/* A linear axis that is out of its travel. */
struct nc_over {
    bool is; /* else the rest says nothing */
    int axis;
    double value;
    struct vec3 tip; /* where the tip is there */
};

/* Where the program stands. */
struct nc_state {
    bool begun;                /* pose and at are known */
    struct pose pose;          /* as the path means it */
    struct block_pose at;      /* as the last block says it */
    struct turned turned;      /* its rotary axes */
    struct pose_deviation off; /* of `at` from `pose` by rounding (post_ik_reach_near); NAN: not
                                  known */
    double feed;               /* mm/min, 0: not given yet */
    double faster;             /* the tracked point is to go faster than that by this factor */
    struct nc_over over;       /* the first on the way of a block so far */
    bool touches;              /* the contact at `pose` is known */
    struct contact contact;
    enum nc_why why; /* of the blocks that are made now */
    size_t pass;
    unsigned line;
    int tool; /* number of the one in the spindle */
};

/* The angles that the look ahead has found for a motion. */
struct nc_aim {
    size_t n; /* places, with the one where the motion starts; 0: none, the rotary axes go the
                 nearest way */
    const struct ik_plan_place *place;
    const double *s; /* how far along the motion, except of the first, 0 to 1 */
};

/* Where on a motion, 0 to 1, the tool retracts, turns to these angles, and returns. */
struct nc_rewind {
    double s, q[ROTARY_MAX];
};

struct nc_rewinds {
    size_t n, cap;
    struct nc_rewind *item;
};

struct nc_planner {
    const struct path *path;
    const struct machine *machine; /* own, of the tool in the spindle */
    const struct machine *base;    /* as its file has it */
    struct machine *own;
    struct nc_plan *plan;
    struct interpolation follow;
    struct nc_plan_options options;
    struct pose_deviation allowed; /* of a block, with rounding */
    double near_pole;              /* post_ik_near_pole by what is allowed */
    double clearance;              /* z above which the path goes at rapid, NAN: not known */
    struct box cut;                /* around the ends of all cuts */
    struct nc_state state;
    struct ik_near_table near; /* of the machine */
    double safe_radius;        /* post_ik_safe_radius of the machine */
    size_t next;               /* the item of the path that comes next */
    size_t next_tilted;        /* no item from `next` to before this one has a tool axis that is
                                  not singular */
    bool off_part;             /* so the next motion may take either solution */
    bool leaves;               /* the part, with a rapid: a free axis stays as it is */
    bool doubtful;             /* the nearest way may not have been the shortest of all */
    struct nc_aim aim;         /* of the next motion */
    struct nc_rewinds rewinds; /* inside of the next motion */
    /* Retracts, turns and returns where no block leads on to the goal (post_rewind_for); NULL: it
     * must not. */
    int (*rewind)(struct nc_planner *planner, struct pose goal);
    struct error *error;
};

#endif
