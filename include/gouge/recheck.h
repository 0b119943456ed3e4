/*
 * recheck - fitted motions looked at again: does the ball go into the part between the points, and
 * by how much must these be lifted that it does not?
 */
#ifndef CLOUDMILL_RECHECK_H
#define CLOUDMILL_RECHECK_H

#include "gouge/guard.h"
#include "curve/motion.h"
#include "curve/run.h"

struct recheck_rule {
    const struct guard *guard; /* NULL: nothing is looked at */
    double radius;             /* of the ball, mm */
    double tolerance;          /* how deep it may go, mm */
    bool centre;               /* the motions are those of the ball's centre, not of the tip */
};

/* A place where the ball goes deeper. */
struct deep {
    struct vec3 ball;
    double depth; /* mm */
};

struct deeps {
    size_t n, cap;
    struct deep *item;
};

/*
 * Appends the deepest place of each millimetre or so of the motion where the ball goes deeper than
 * 0.95 of the tolerance (the points of a scan are not quite the part), found on straight pieces
 * within a twentieth of the tolerance of its centre's way, or closer where that decides, down to a
 * thousandth.
 */
void recheck_motion(const struct recheck_rule *rule, const struct motion *motion,
                    struct deeps *deeps);

/*
 * Lifts the points of the run around those places along their normals (without one, along the
 * axis): by the depth less half the tolerance next to the place and evenly less over three times
 * that reach.  Both ends stay, for what comes before and behind knows them.  Returns the largest
 * lift, mm.
 */
double recheck_lift(const struct recheck_rule *rule, const struct deeps *deeps, struct run *run);

/* The deepest of them; depth 0 when there is none. */
struct deep recheck_deepest(const struct deeps *deeps);

/* The same, depth 0 also when it is within the tolerance. */
struct deep recheck_beyond(const struct recheck_rule *rule, const struct deeps *deeps);

struct recheck_result {
    struct deep deepest; /* that is left beyond the tolerance; depth 0: none */
    double lift;         /* of the points, all rounds together at most, mm */
};

/*
 * Has the run fitted, and again with its points lifted where the motions go too deep, up to eight
 * times.  `fit` makes the motions of the run anew and appends to `deeps` what recheck_motion finds
 * of them.
 */
struct recheck_result
recheck_fit(const struct recheck_rule *rule, struct run *run,
            void (*fit)(void *context, const struct run *run, struct deeps *deeps), void *context);

#endif
