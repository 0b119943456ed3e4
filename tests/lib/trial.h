/* trial - a motion in 5 axes to try fits on, and its distance from a fit by brute force. */
#ifndef CLOUDMILL_TRIAL_H
#define CLOUDMILL_TRIAL_H

#include "arcfit/arcfit.h"
#include "curve/bspline.h"
#include "splinefit/minimax.h"
#include "curve/run.h"
#include "curve/reference.h"

/* n points: the tip on a wave, the axis swinging; radius of the ball, mm. */
struct run trial_motion(size_t n, double radius);

/* Distance of q from the nearest of the straight pieces between n points, mm. */
double trial_off_chain(struct vec3 q, const struct vec3 *point, size_t n);

/* n points on a screw line of radius 10, `step` radians apart, the axis leaning outward and turning
 * with it; radius 4. */
struct run trial_screw(size_t n, double step);

/* n points `step` mm apart in x on a wave in space, radius 6; with `lean` the axis swings along it,
 * with `kink` there is a corner in the middle. */
struct reference trial_wave(size_t n, double step, double lean, double kink);

/* Largest distance both ways between the curve, taken at 1,501 places, and the track's polyline,
 * mm; of the tracked point or of the other one. */
double trial_brute_force(const struct bspline *b, const struct reference *t, bool other);

/* The pieces lead from the reference's first point to its last, all of them joined, with no kink
 * and within the tolerances. */
void trial_assert_chain(const struct reference *t, const struct deviation *within,
                        const struct pieces *p);

/* A curve through the target by least squares, its knots spread by that power. */
struct candidate trial_candidate(const struct reference *t, const struct deviation *within,
                                 int degree, size_t poles, double power);

/* A curve through trial_motion, and all that it takes. */
struct trial_fit {
    struct run run;
    struct reference track;
    struct reference target;
    struct candidate candidate;
};

/* The motion's n points, with a `fixed` axis or turning, its tip tracked or its `centre`, sampled
 * at about `parts` places; the candidate is still to be made. */
struct trial_fit trial_fit_new(size_t n, double radius, bool fixed, bool centre, size_t parts);

void trial_fit_free(struct trial_fit *fit);

#endif
