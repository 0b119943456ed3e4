/*
 * gouge_refit - a run fitted, checked, lifted and fitted again until the ball is clear of the part.
 *
 * The points of a run were checked by the tool that made them, and are clear.  A curve fitted to
 * them may go deeper between two points.  So gouge_refit_fit, the driver of the fitters,
 *
 *   1. has the run fitted by the function it is given, which checks each of its motions by
 *      gouge_refit_motion against the scan (gouge.h),
 *   2. has it go straight between points where the curve alone is too deep, not the line
 *      (gouge_refit_straighten), and lifts the points of the run around all other places that are
 *      too deep (gouge_refit_lift),
 *   3. and begins again, a few rounds at most.
 *
 * Who spends what of the tolerance (-e of the fitters; how deep the ball may go):
 *
 *   constant       of            what for
 *   GOUGE_SAFE     tolerance     deeper than this is lifted (gouge.h): the rest is ncpost's
 *   GOUGE_CHORD    tolerance     straight pieces off the motion while it is checked, ...
 *   GOUGE_FINEST   tolerance     ... and at closest, where that decides
 *   GOUGE_SWEPT    tolerance     what shank and holder move between two poses that are looked at
 *   GOUGE_LIFTED   tolerance     depth that is left at a place when it is lifted
 *   GOUGE_PRINTED  tolerance     above all of it: what the digits of the points leave
 */
#ifndef CLOUDMILL_GOUGE_REFIT_H
#define CLOUDMILL_GOUGE_REFIT_H

#include "curve/motion.h"
#include "curve/run.h"
#include "gouge/gouge.h"
#include "gouge/gouge_track.h"

#define GOUGE_CHORD (1.0 / 20)
#define GOUGE_FINEST 1e-3
#define GOUGE_SWEPT 0.25
#define GOUGE_LIFTED 0.5
#define GOUGE_PRINTED 1e-3

struct gouge_refit_options {
    const struct gouge_check *guard; /* NULL: nothing is checked */
    double radius;                   /* of the ball, mm */
    double tolerance;                /* how deep it may go, mm */
    bool centre;          /* the motions are those of the ball's centre, not of the tip */
    bool any;             /* no more is asked for than whether there is a place too deep */
    struct holder holder; /* what of the tool is above the ball; without parts: the ball alone */
};

/* Frees the guard, for whoever owns it. */
void gouge_refit_free(struct gouge_refit_options *options);

/* What of a tool is in the part: the ball, what is above it and no wider, or wider. */
enum tool_part { TOOL_BALL, TOOL_SHAFT, TOOL_HOLDER };

/* Its name in a message. */
const char *tool_part_name(enum tool_part part);

/* A place where the tool goes too deep. */
struct gouge {
    struct vec3 ball; /* its centre there */
    double depth;     /* mm */
    enum tool_part part;
};

struct gouges {
    size_t n, cap;
    struct gouge *item;
};

/*
 * Appends the deepest place of each millimetre or so of the motion where the tool goes deeper than
 * GOUGE_SAFE.  The ball: found on straight pieces within GOUGE_CHORD of its centre's path, or
 * closer where that decides, down to GOUGE_FINEST.  What is above it: the motion is halved until
 * what it is clear by at both ends is more than any place of it can move between them, or that is
 * less than GOUGE_SWEPT.  `track`: of the motions before and of earlier fits, which this one adds
 * to.  With `any` one such place, and nothing after the first.
 */
void gouge_refit_motion(const struct gouge_refit_options *options, const struct motion *motion,
                        struct gouge_track *track, struct gouges *gouges);

/*
 * What was found of the motions of the fits before: a line or an arc that a refit leaves as it was
 * is not looked at again.  Starts as all zero; one is for one thread and one guard.
 */
struct gouge_memo {
    struct gouge_track track;
    struct gouge_seens {
        size_t n, cap;
        struct gouge_seen {
            struct motion motion;
            size_t first, n; /* of `found` */
        } * item;
    } seen;    /* in the order of the way */
    size_t at; /* of `seen`: the next one */
    struct gouges found;
};

void gouge_memo_free(struct gouge_memo *memo);

/* gouge_refit_motion of it, or what that found of the same motion. */
void gouge_refit_once(const struct gouge_refit_options *options, const struct motion *motion,
                      struct gouge_memo *memo, struct gouges *gouges);

/*
 * Has the path go straight between those points of the run between which the ball is deeper than
 * any fit to the straight line would be, though it is clear on that line: the smooth curve through
 * points swings out where a long interval follows a kink.  Such gouges are taken off the list;
 * true: there were some.
 */
bool gouge_refit_straighten(const struct gouge_refit_options *options, struct gouges *gouges,
                            struct run *run);

/*
 * Lifts the points of the run around those places where the ball is too deep along their normals
 * (without one, along the axis): by the depth less GOUGE_LIFTED next to the place and evenly less
 * over three times that reach.  Both ends stay, for what comes before and after joins them.
 * Returns the largest lift, mm.
 */
double gouge_refit_lift(const struct gouge_refit_options *options, const struct gouges *gouges,
                        struct run *run);

/* The deepest of them; depth 0 when there is none. */
struct gouge gouge_refit_deepest(const struct gouges *gouges);

/* The same, depth 0 also when it is within the tolerance. */
struct gouge gouge_refit_beyond(const struct gouge_refit_options *options,
                                const struct gouges *gouges);

struct gouge_refit_result {
    struct gouge deepest; /* that is left beyond the tolerance; depth 0: none */
    double lift;          /* of the points, all rounds together at most, mm */
    struct gouges left; /* all places where it is too deep at the end, if the deepest is beyond the
                             tolerance; the caller frees it (array_free) */
};

/*
 * Has the run fitted, and again with its points lifted where the motions go too deep.  `fit` makes
 * the motions of the run anew and appends to `gouges` what gouge_refit_motion finds of them.
 */
struct gouge_refit_result
gouge_refit_fit(const struct gouge_refit_options *options, struct run *run,
                void (*fit)(void *context, const struct run *run, struct gouges *gouges),
                void *context);

#endif
