/*
 * part_coverage - of every point of a part: is it cut, out of the tool's reach, kept off, or left?
 *
 * Cut is a point on which no more than `limit` is left.  Of the others, out of reach is one that no
 * ball touches (to within `near`) that is clear of all points, with the tool above it clear, by
 * a tenth of a millimetre, in one of the directions that the machine has.  Kept off is one that
 * only balls touch that are in the part between its points: the surface that faces up goes on over
 * them, past a wall that has too few points to keep them off, or a wall that has none may stand
 * there (unseen_wall.h).  All the rest is left.  The directions of the ball from the point and of
 * the tool are samples (constants in the .c), so that a narrow access may count as none.
 *
 * The tool comes from outside: the middle line of the axis, nine tenths of a radius thick, has to
 * leave the part, and where the part does not stand upright the ball is on its upper side.  Lengths
 * in mm.
 */
#ifndef CLOUDMILL_PART_COVERAGE_H
#define CLOUDMILL_PART_COVERAGE_H

#include <stdbool.h>

#include "base/array.h"
#include "simulate/tool_shape.h"
#include "simulate/verify_kinematics.h"

enum part_class {
    COVERAGE_CUT,
    COVERAGE_OUT_OF_REACH,
    COVERAGE_LEFT,
    COVERAGE_KEPT_OFF,
    COVERAGE_CLASSES
};

struct part_coverage_options {
    double radius, limit;
    double near; /* so near to a point a ball has to come that could cut it */
    const struct tool_shape *tool;
    const struct vec3s *axis;    /* unit vectors up the tool that the machine has */
    const struct vec3s *curtain; /* points in the way of ball and tool, and not of the part; NULL:
                                    none */
    bool whole;     /* the points are those of a mesh or of surfaces: no wall is without any */
    bool left_only; /* asked is which are left: of a cell each point is looked at, even where two
                       are out of reach, and one that is kept off counts as out of reach */
    int threads;    /* as of parallel_for */
};

/* What is of one class. */
struct part_coverage_sum {
    size_t points;
    double area;  /* mm^2, by how far points are apart */
    double worst; /* most that is left on one of them ... */
    size_t at;    /* ... this one */
};

struct part_coverage {
    unsigned char *of; /* enum part_class of each point */
    struct part_coverage_sum sum[COVERAGE_CLASSES];
};

/* `deviation` of each of n points: what is left on it, below zero where it is gouged.  `under`: 1
 * of each point that is known to be out of reach (NULL: none). */
void part_coverage_run(const struct vec3 *point, const double *deviation,
                       const unsigned char *under, size_t n,
                       const struct part_coverage_options *options, struct part_coverage *coverage);
void part_coverage_free(struct part_coverage *coverage);

/* Unit vectors up the tool, about AXES_APART degrees apart, that the machine's rotary axes reach
 * within their travel, none of them from below; the one at zero is the first. */
struct vec3s part_coverage_axes(const struct verify_kinematics *kinematics);

#endif
