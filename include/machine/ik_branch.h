/*
 * ik_branch - the states in which the rotary axes can have a direction: by either solution, each
 * axis turned on by whole turns.  A state is a number, the same all along a pass.
 */
#ifndef CLOUDMILL_IK_BRANCH_H
#define CLOUDMILL_IK_BRANCH_H

#include "machine/ik_choose.h"

/* The whole turns that an axis may have: `many` of them from `least`; one that has no end is
 * always turned the nearest way. */
struct turn_range {
    int many, least;
    bool endless;
};

struct ik_branches {
    const struct kinematic_chain *chain;
    struct turn_range range[ROTARY_MAX];
    int n; /* states 0 to n - 1; the lower half is the first solution's */
};

/* A direction that the axes go to from the one before. */
struct ik_branch_target {
    struct chain_solutions found;
    bool stays; /* the first axis is free, and stays as it is */
    bool loose; /* it may turn as far as it likes from the direction before */
};

/* The most whole turns that are distinguished, of the first axis and of the second; one with a
 * longer travel is taken to have no end. */
enum { IK_BRANCH_TURNS_FIRST = 257, IK_BRANCH_TURNS_SECOND = 9 };

/* The states of a chain. */
struct ik_branches ik_branches(const struct kinematic_chain *chain);

/* The angles are within the travel, but for rounding. */
bool ik_branch_within(const struct kinematic_chain *chain, const double q[]);

/* The state of these angles, whole turns away from `base`, those of the k-th solution; -1: outside
 * of the travel. */
int ik_branch_at(const struct ik_branches *s, int k, const double q[], const double base[]);

/* The angles of a state, when those before were `from`; within the travel or not. */
void ik_branch_angles(const struct ik_branches *s, const struct ik_branch_target *target, int state,
                      const double from[], double q[]);

/*
 * True when an axis, on its way from the angles of one direction to those of a near one, comes to
 * an end of its travel or to an angle whole turns from it, by one of the solutions: where a turn
 * back gains most.  *share: how far on the way in its angle, 0 to 1, the first of them.
 */
bool ik_branch_end(const struct kinematic_chain *chain, const struct chain_solutions *from,
                   const struct chain_solutions *to, int solution, double *share);

/* The most that the direction may change from one place to the next near this one, radians:
 * less near the direction in which the first axis is free. */
double ik_branch_step(const struct kinematic_chain *chain, struct vec3 axis);

/*
 * The direction `axis`, at which chain_angles found `found`, gone to from `near`.  Where the first
 * axis is free it stays as it is; while it stays free it turns to where it will be needed (`ahead`:
 * found there, NULL: nowhere); where both directions are within `cone` radians of the singular one
 * it is loose.
 */
struct ik_branch_target ik_branch_target(const struct kinematic_chain *chain, double cone,
                                         struct vec3 near, struct vec3 axis,
                                         const struct chain_solutions *found,
                                         const struct chain_solutions *ahead);

#endif
