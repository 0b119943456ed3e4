/*
 * path_compare - a program against the path that it was made from: tip, tool axis and feed of one
 * along the other, both ways.
 *
 * What the program does at feed and the path does not, is no fault before the first and after the
 * last place on the path between two rapid moves: approach and retract.  Lengths in mm.
 */
#ifndef CLOUDMILL_PATH_COMPARE_H
#define CLOUDMILL_PATH_COMPARE_H

#include "simulate/axis_limits.h"

struct path_compare_options {
    double radius;     /* of the ball: a path may track its centre */
    double tolerance;  /* of the tip, mm */
    double axis;       /* of the tool axis, radians */
    double fast, slow; /* times the path's feed that a program may be faster, slower */
    const struct axis_limits *limits; /* how fast its axes are, and what F counts; NULL: any */
    bool part; /* the program is one of several that go along the path one after the other */
};

struct path_fault {
    size_t count;   /* places */
    size_t piece;   /* of the program, the worst; of `missed` of the path */
    size_t near;    /* `missed`: the piece of the program that is nearest */
    double value;   /* there: mm, radians, or times the path's feed */
    struct vec3 at; /* the tip */
};

struct path_compare {
    struct path_fault off;    /* the program is off the path */
    struct path_fault turned; /* on it, with another axis */
    struct path_fault missed; /* the path goes where the program does not, with its axis */
    struct path_fault beyond; /* the same before the first and after the last place of a part */
    struct path_fault fast, slow;
};

struct path_compare path_compare_run(const struct nc_motion *program, const struct nc_motion *path,
                                     const struct path_compare_options *options);

#endif
