/*
 * verify_kinematics - a machine's rotary axes as the readers of programs evaluate them: by
 * matrices, with no code in common with the writers of programs (machine/kinematics.h).
 *
 * Axis 0 is the one nearest the work; tables come before heads.  A word of a table's axis is in
 * ISO sense (the tool against the work), so that table and head have one formula for the tool
 * axis: a = R0(q0) R1(q1) t.  Angles in degrees, lengths in mm.
 */
#ifndef CLOUDMILL_VERIFY_KINEMATICS_H
#define CLOUDMILL_VERIFY_KINEMATICS_H

#include <stdbool.h>

#include "math/vec.h"

enum { VERIFY_KINEMATICS_AXES = 2 };

struct verify_kinematics_axis {
    char letter;        /* A, B or C: its word */
    bool table;         /* in the table; else in the head */
    struct vec3 axis;   /* unit direction at zero; the other way round it turns the other way */
    struct vec3 centre; /* a point on it; of a head's, seen from the tip at zero */
    double min, max;    /* travel */
};

struct verify_kinematics {
    int n; /* rotary axes, 0 to VERIFY_KINEMATICS_AXES */
    struct verify_kinematics_axis axis[VERIFY_KINEMATICS_AXES];
    struct vec3 tool; /* from the tip to the spindle when all stand at zero */
};

/* The tool axis in the frame of the work. */
struct vec3 verify_kinematics_axis_at(const struct verify_kinematics *kinematics, const double q[]);

/* The tip in the frame of the work when the linear axes stand at `linear`; at zero it is there. */
struct vec3 verify_kinematics_tip(const struct verify_kinematics *kinematics, struct vec3 linear,
                                  const double q[]);

/* Where the linear axes stand for the tip to be at `tip`: the inverse of verify_kinematics_tip. */
struct vec3 verify_kinematics_linear(const struct verify_kinematics *kinematics, struct vec3 tip,
                                     const double q[]);

/*
 * The angles for a tool axis, of the two solutions in whole turns the one nearest to `near` (the
 * sum of both moves) that is within the travel, if there is one; an axis that may have any angle
 * stays.  Returns false when it is out of
 * reach by more than `slack` degrees; q is then the nearest.  Two axes by the second subproblem of
 * Paden and Kahan (Murray, Li, Sastry, A Mathematical Introduction to Robotic Manipulation, 3.2).
 */
bool verify_kinematics_angles(const struct verify_kinematics *kinematics, struct vec3 axis,
                              const double near[], double slack, double q[]);

/* Two tables, A or B carrying C, through the zero point; `sense` -1: they turn the other way. */
struct verify_kinematics verify_kinematics_trunnion(char master, int sense);

#endif
