/*
 * gouge_refit - fitted motions looked at again: does the ball go into the part between the points,
 * and by how much must these be lifted that it does not?
 */
#ifndef CLOUDMILL_GOUGE_REFIT_H
#define CLOUDMILL_GOUGE_REFIT_H

#include "gouge/gouge.h"
#include "curve/motion.h"
#include "curve/run.h"

struct gouge_refit_options {
    const struct gouge_check *guard; /* NULL: nothing is looked at */
    double radius;                   /* of the ball, mm */
    double tolerance;                /* how deep it may go, mm */
    bool centre; /* the motions are those of the ball's centre, not of the tip */
};

/* A place where the ball goes deeper. */
struct gouge {
    struct vec3 ball;
    double depth; /* mm */
};

struct gouges {
    size_t n, cap;
    struct gouge *item;
};

/*
 * Appends the deepest place of each millimetre or so of the motion where the ball goes deeper than
 * 0.95 of the tolerance (the points of a scan are not quite the part), found on straight pieces
 * within a twentieth of the tolerance of its centre's way, or closer where that decides, down to a
 * thousandth.
 */
void gouge_refit_motion(const struct gouge_refit_options *rule, const struct motion *motion,
                        struct gouges *deeps);

/*
 * Lifts the points of the run around those places along their normals (without one, along the
 * axis): by the depth less half the tolerance next to the place and evenly less over three times
 * that reach.  Both ends stay, for what comes before and behind knows them.  Returns the largest
 * lift, mm.
 */
double gouge_refit_lift(const struct gouge_refit_options *rule, const struct gouges *deeps,
                        struct run *run);

/* The deepest of them; depth 0 when there is none. */
struct gouge gouge_refit_deepest(const struct gouges *deeps);

/* The same, depth 0 also when it is within the tolerance. */
struct gouge gouge_refit_beyond(const struct gouge_refit_options *rule, const struct gouges *deeps);

struct gouge_refit_result {
    struct gouge deepest; /* that is left beyond the tolerance; depth 0: none */
    double lift;          /* of the points, all rounds together at most, mm */
};

/*
 * Has the run fitted, and again with its points lifted where the motions go too deep, up to eight
 * times.  `fit` makes the motions of the run anew and appends to `deeps` what gouge_refit_motion
 * finds of them.
 */
struct gouge_refit_result gouge_refit_fit(const struct gouge_refit_options *rule, struct run *run,
                                          void (*fit)(void *context, const struct run *run,
                                                      struct gouges *deeps),
                                          void *context);

#endif
