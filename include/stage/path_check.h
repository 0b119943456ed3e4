/*
 * path_check - a path looked at once more as it is printed: is the whole tool clear of the guard in
 * cuts, links and rapids, does it stay from going far below the part, is every feed one that a
 * control can drive, and every axis one that the machine has?
 *
 * The tool that makes a path, or fits motions to one, checks what it makes while it makes it.  This
 * looks at the result alone: it follows the items one after the other, points, arcs, B-splines and
 * rapids, sweeps ball, shank and holder along each motion (gouge_refit.h), and keeps the worst.
 * Items may come in pieces, as a path is written.
 */
#ifndef CLOUDMILL_PATH_CHECK_H
#define CLOUDMILL_PATH_CHECK_H

#include "gouge/gouge_refit.h"
#include "io/path/path.h"
#include "machine/kinematics.h"

/* No feed below this is one, mm/min. */
#define PATH_CHECK_SLOWEST 0.1

enum path_motion { MOTION_CUT, MOTION_LINK, MOTION_RAPID };

/* The worst of one kind of motion. */
struct path_check_deep {
    size_t n; /* motions that are too deep */
    struct gouge deepest;
    size_t pass; /* in which, 0: before the first */
};

struct path_check {
    struct gouge_refit_options tool; /* the guard (NULL: nothing is swept), the tool, and how deep
                                        it may be */
    bool coarse; /* cuts are not looked at: straight lines between their points are not what will be
                    driven, but a curve that a fitter puts there */
    const bool *clear; /* by item of the path: whoever made it has found its motion clear, and it is
                          not swept again; NULL: none */
    int threads;       /* as of parallel_for */
    bool floored; /* the ball's centre has a least z ... */
    double floor; /* ..., mm */
    struct kinematic_chain
        chain; /* whose travel the axis stays in; of no axes: it is not looked at */

    /* What was found. */
    struct path_check_deep deep[3]; /* by enum path_motion */
    size_t low;                     /* places below the floor, the lowest, and in which pass */
    double lowest;
    size_t low_pass;
    size_t slow;                    /* motions at a feed below PATH_CHECK_SLOWEST */
    double slowest;                 /* mm/min */
    size_t slow_pass;
    size_t out; /* places whose axis the machine does not reach, or not on the straight way there at
                   feed, and the first of them */
    struct pose out_at;
    size_t out_pass;

    /* How far the path was followed. */
    struct pose at;
    bool begun;
    bool touched, contacts; /* at `at`; anywhere so far */
    size_t pass;
    double feed;
};

/* Follows items [from, to) of the path, after those before. */
void path_check_items(struct path_check *check, const struct path *path, size_t from, size_t to);

/* Follows items [from, to) without a look at them: they are somebody else's. */
void path_check_follow(struct path_check *check, const struct path *path, size_t from, size_t to);

/* Says with say() what is too deep, too slow and out of reach, kind by kind: how many motions, the
 * deepest with place, pass, depth and part of the tool; they are added to `unmet`.  EXIT_DONE or
 * EXIT_UNMET. */
int path_check_conclude(const struct path_check *check, struct unmets *unmet);

#endif
