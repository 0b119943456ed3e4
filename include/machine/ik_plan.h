/*
 * ik_plan - the rotary axes planned over a whole pass before any of it is programmed: which of the
 * two solutions and which whole turns to start with, and where to turn back.
 *
 * The shortest path through a graph, by dynamic programming in time proportional to the number of
 * places.  The nodes are the places along the pass, each in every state of the rotary axes
 * (ik_branch.h).  The cost is first the number of turns back (retract, turn, return), and among as
 * many of them how far the axes turn.
 */
#ifndef CLOUDMILL_IK_PLAN_H
#define CLOUDMILL_IK_PLAN_H

#include "machine/ik_branch.h"

/* A direction of the tool along the pass, so close to the one before that no angle jumps. */
struct ik_plan_place {
    struct vec3 axis;
    unsigned crossing;    /* one block may lead here from so many places before, past the singular
                             direction and all between; 0: no such block */
    bool may_turn;        /* the tool may retract and turn here before it goes on */
    bool inside;          /* of a motion: it rather turns elsewhere */
    bool shut[2];         /* not with this solution: the linear axes would leave their travel */
    bool turn;            /* found: it turns here */
    bool passed;          /* found: a block leads past it */
    double q[ROTARY_MAX]; /* found, where not passed: the angles with which it comes here */
    bool known;           /* what chain_angles finds; where not, it is worked out */
    struct chain_solutions solutions;
};

struct ik_plan {
    const struct kinematic_chain *chain;
    double cone; /* radians: so near the singular direction the first axis may turn at one place */
    /* may one block lead from one place to another, with these angles?  NULL: may_cross always may
     */
    bool (*may_cross)(const void *with, size_t from, size_t to, const double q0[],
                      const double q1[]);
    const void *with;
};

struct ik_plan_cost {
    unsigned turns; /* back */
    double travel;  /* as ik_travel says it */
};

/*
 * Fills in what is found of the places.  `from` is where the axes stand before; they may go to any
 * state from there, and the cost includes the way.  -1: no way.
 */
int ik_plan_make(const struct ik_plan *plan, struct ik_plan_place place[], size_t n,
                 const double from[], struct ik_plan_cost *cost);

#endif
