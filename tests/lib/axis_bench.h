/*
 * axis_bench - a pass along X on a floor with nothing in its way, and its nodes, for the unit tests
 * of how axes are planned step by step (src/gouge/axis_plan_steps.h).
 */
#ifndef CLOUDMILL_TEST_AXIS_BENCH_H
#define CLOUDMILL_TEST_AXIS_BENCH_H

#include "gouge/axis_plan_steps.h"

enum { AXIS_BENCH_POINTS = 61 };

struct axis_bench {
    struct gouge_check *guard;
    struct axis_planner *planner;
    struct run run;
    struct work work;
};

/* Points 0.5 mm apart, a ball of 5 mm; the axis at each leans by lean(i) radians along Y.  A bench
 * stays where it is, and is freed. */
void axis_bench_begin(struct axis_bench *bench, double play, double (*lean)(int i));
void axis_bench_free(struct axis_bench *bench);

/* All its nodes, with what is open at them. */
void axis_bench_nodes(struct axis_bench *bench);

#endif
