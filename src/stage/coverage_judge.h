/*
 * coverage_judge - who judges a program by the points of the scan asks of each that is not cut
 * whether the tool could have cut it (simulate/part_coverage.h): the same question, asked by who
 * makes the path, so that nothing that a path calls out of reach is found to be left.
 *
 * Stages to come widen what may be left, not how near a ball has to come: they make fewer points
 * ask for it, and the answers stay.
 */
#ifndef CLOUDMILL_COVERAGE_JUDGE_H
#define CLOUDMILL_COVERAGE_JUDGE_H

#include "base/array.h"
#include "gouge/holder.h"
#include "machine/kinematics.h"

struct coverage_judge_options {
    double radius;                       /* of the ball, mm */
    double limit;                        /* what a program may leave, mm */
    double near;                         /* so near a ball has to come that could cut a point, mm */
    double noise;                        /* of the points, one standard deviation, mm */
    const struct holder *holder;         /* what is above the ball */
    const struct kinematic_chain *chain; /* of the machine: what directions it has */
    bool scan;                           /* the points are a scan: material hangs below its rims */
    bool unseen;                         /* and goes on where no point tells that it does not */
    int threads;                         /* as of parallel_for */
};

/* Of n points those with something left on them (height, mm; 0: not asked) that are judged to be
 * within reach: how many.  What is on the others is set to 0.  `place`: what is in the way, these
 * points among it, or those of the scan that they are without noise; it is sorted, and of a scan
 * moved off its noise (cloud/judged_scan.h). */
size_t coverage_judge_left(const struct vec3 *point, double *height, size_t n, struct vec3s *place,
                           const struct coverage_judge_options *options);

/* Moves the points of a scan to where a judge takes them to be, without their noise. */
void coverage_judge_settle(struct vec3s *scan, double radius, double noise, int threads);

/* Unit vectors up the tool, evenly over the upper half of the sphere, that the machine's rotary
 * axes reach within their travel; the one at zero is the first. */
struct vec3s coverage_judge_axes(const struct kinematic_chain *chain);

#endif
