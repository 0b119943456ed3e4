/*
 * planners - the post's planner on machines of every kind, for unit tests.
 */
#ifndef CLOUDMILL_TEST_PLANNERS_H
#define CLOUDMILL_TEST_PLANNERS_H

#include "post/post_planner.h"

/* A planner with what it points to. */
struct bench {
    struct machine machine;
    struct path path;
    struct nc_plan plan;
    struct error error;
    struct nc_planner planner;
};

/*
 * One that stands at q (radians) with the tip at `tip`, on a chain of a kind (chains.h) whose axes
 * turn a whole turn and a half either way: 5 decimals of mm and degrees, 8 of a vector; each block
 * may be 0.01 mm and 0.1 degrees off; 50 mm to retract.  A bench stays where it is, and is freed.
 */
void bench_begin(struct bench *bench, int kind, enum interpolation_mode mode, struct vec3 tip,
                 const double q[]);
void bench_free(struct bench *bench);

/* A direction as the machine has it at q: Rodrigues' rotation of the tool, axis by axis. */
struct vec3 bench_axis(const struct bench *bench, const double q[]);

/* The tracked point where a move of the plan ends. */
struct vec3 bench_tip(const struct bench *bench, const struct nc_move *move);

#endif
