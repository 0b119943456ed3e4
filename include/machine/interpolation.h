/*
 * interpolation - what the control makes of one block, measured against the motion that was meant.
 *
 * Between two blocks a control moves the tracked point straight and the tool axis in one of three
 * ways: on the great circle between two programmed vectors; by rotary axes that turn in
 * proportion, under tool-centre-point control; or it moves all five axes in proportion and knows
 * nothing of the tool's point.  Only the first is the motion of a path.
 */
#ifndef CLOUDMILL_INTERPOLATION_H
#define CLOUDMILL_INTERPOLATION_H

#include <stdbool.h>

#include "machine/kinematics.h"
#include "curve/motion.h"

enum interpolation_mode { INTERPOLATE_VECTOR, INTERPOLATE_ROTARY, INTERPOLATE_JOINT };

struct interpolation {
    enum interpolation_mode mode;
    const struct kinematic_chain *chain;
    double ball; /* from the tracked point along the tool axis to the other point whose place
                    matters: the ball's centre (or, where that is tracked, the tip); 0: none */
};

/* What a block says: the numbers as printed. */
struct block_pose {
    struct vec3 p;        /* X Y Z: the tracked point; in INTERPOLATE_JOINT the linear axes */
    struct vec3 a;        /* the tool axis: as the vector says it or, where there is none, as the
                             rotary axes do */
    double q[ROTARY_MAX]; /* the rotary axes, radians */
};

/* The same with the cosines and sines of the rotary axes. */
struct machine_pose {
    struct block_pose at;
    struct turned turned;
};

/* How far off: at the tracked point or the ball, mm, and at the tool axis, radians. */
struct pose_deviation {
    double point, axis;
};

static inline bool pose_deviation_within(struct pose_deviation d, struct pose_deviation allowed)
{
    return d.point <= allowed.point && d.axis <= allowed.axis;
}

static inline struct pose_deviation pose_deviation_worst(struct pose_deviation a,
                                                         struct pose_deviation b)
{
    return (struct pose_deviation){fmax(a.point, b.point), fmax(a.axis, b.axis)};
}

/* The largest of n deviations at equal steps, and between them: the top of the parabola through the
 * three about a peak. */
struct pose_deviation interpolation_peak(const struct pose_deviation *d, int n);

/* Between two poses. */
struct pose_deviation interpolation_difference(const struct interpolation *f, struct pose a,
                                               struct pose b);

/* The pose when a straight block is done to s, 0 to 1. */
struct pose interpolation_pose(const struct interpolation *f, const struct block_pose *from,
                               const struct block_pose *to, double s);

/*
 * A bound of the deviation of the straight block between two ends from the straight motion
 * between two poses; infinite where the block turns too far to say.
 *
 * Both move at the same time s, and e(s) is the difference of their axes (or points).  The parabola
 * through e(0), e(1/2), e(1) leaves the line through e(0) and e(1) by no more than |e(1/2) - (e(0)
 * + e(1)) / 2|; and e leaves the parabola by no more than max |e'''| sqrt(3) / 216, the remainder
 * of the interpolation.  Axes that turn through q0 and q1 have |a'''| <= (|q0| + |q1|)^3.  In
 * INTERPOLATE_JOINT the tip runs ahead or behind by its own e(s); what the axis turns meanwhile is
 * added.
 */
struct pose_deviation interpolation_line(const struct interpolation *f,
                                         const struct machine_pose *from,
                                         const struct machine_pose *to, struct pose start,
                                         struct pose goal, struct pose_deviation allowed);

/*
 * A bound, without a look between, of what the straight block adds to the errors of its ends, at
 * the same time of block and motion (INTERPOLATE_ROTARY, INTERPOLATE_JOINT).  What moves with |e''|
 * leaves the straight line between its ends by no more than |e''| / 8: the two tool axes by turn^2
 * / 8 each; the tip that linear axes carry along a turning arm by (turn^2 arm + 2 turn length) / 8.
 */
struct pose_deviation interpolation_bend(const struct interpolation *f,
                                         const struct block_pose *from,
                                         const struct block_pose *to);

/*
 * The largest deviation of the straight block between two ends from the motion between s0 and
 * s1, measured at both ends and between, closer the further the block turns, so that no peak is
 * missed between.  The time along the block is free: each place of the motion is compared with the
 * place of the block that is beside it.
 */
struct pose_deviation interpolation_block(const struct interpolation *f,
                                          const struct block_pose *from,
                                          const struct block_pose *to, const struct motion *motion,
                                          double s0, double s1);

/*
 * The same for a block on a curve: `printed` is the curve as printed, its place in proportion to
 * the motion's; the tool axis as in a straight block.  *point is the tracked point's own part.
 */
struct pose_deviation interpolation_curve(const struct interpolation *f,
                                          const struct block_pose *from,
                                          const struct block_pose *to, const struct motion *printed,
                                          const struct motion *motion, double s0, double s1,
                                          double *point);

#endif
