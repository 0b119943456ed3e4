/*
 * turnplan - the rotary axes looked at over a whole pass before any of it is programmed: which of
 * the two solutions and which whole turns to start with, and where to turn back.
 *
 * Dynamic programming over the directions along the way.  A state is a solution with the whole
 * turns of each axis; what it costs is first the number of turns back (retract - turn - return)
 * and then the way of both axes.  An axis whose travel is ten turns or more is taken to have no
 * end.
 */
#ifndef CLOUDMILL_TURNPLAN_H
#define CLOUDMILL_TURNPLAN_H

#include "kinematics.h"

/* One direction along the way, close enough to the one before that no angle jumps. */
struct turnplan_place {
    struct vec3 axis;
    bool may_turn;        /* the tool may retract and turn here before it goes on */
    double dear;          /* among ways with as many turns, what one here counts: radians of way */
    bool turn;            /* found: it does */
    double q[ROTARY_MAX]; /* found: the angles with which it comes here */
};

/*
 * Fills in the places' angles and turns: the number of turns back.  `from` is where the axes stand
 * before; they may go to any state from there.  -1: no way.
 */
int turnplan_make(const struct chain *chain, struct turnplan_place place[], size_t n,
                  const double from[]);

/*
 * True when the first axis, on its way from one direction to a near one, comes to an end of its
 * travel or to an angle whole turns from it, by one of the solutions: where a turn back gains most.
 * *share: how far on the way in its angle, 0 to 1.
 */
bool turnplan_end(const struct chain *chain, struct vec3 from, struct vec3 to, int solution,
                  double *share);

/* The most that the direction may change from one place to the next near this one, radians:
 * less near the direction in which the first axis is free. */
double turnplan_step(const struct chain *chain, struct vec3 axis);

#endif
