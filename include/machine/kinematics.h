/*
 * kinematics - a machine's rotary axes as one chain from the work to the tool, forward and inverse.
 *
 * The chain holds up to two rotary axes, the one nearest the work first: two in the table, two in
 * the head, one in each, nutating or not.  An axis of the table is in ISO sense, that is, its word
 * says how the *tool* turns against the work; so head and table are one formula.  With R0, R1 the
 * rotations about the axes' directions at zero and t the tool axis at zero, the tool axis against
 * the work is
 *
 *     a = R0(q0) R1(q1) t          for A/C:  a = (sin C sin A, -cos C sin A, cos A)
 *
 * Angles in radians, lengths in mm.
 */
#ifndef CLOUDMILL_KINEMATICS_H
#define CLOUDMILL_KINEMATICS_H

#include <stdbool.h>

#include "math/vec.h"

enum { ROTARY_MAX = 2 };

struct rotary {
    struct vec3 axis;   /* unit direction at zero; turned round, the axis turns the other way */
    struct vec3 centre; /* a point on it; of a head's axis, from the tool tip at zero */
    bool table;         /* in the table; else in the head */
    double min, max;    /* travel */
    double rapid;       /* a minute; 0: not known */
};

/* Of two axes, whatever the direction: the angles from the second to the first and to the tool at
 * zero, and that by which the second turns the tool nearest to the first. */
struct chain_triangle {
    double between, tool, zero;
};

struct kinematic_chain {
    int n;                            /* rotary axes, 0 to ROTARY_MAX */
    struct rotary rotary[ROTARY_MAX]; /* from the work to the tool: tables before heads */
    int master;                       /* the one that is to move least */
    struct vec3 tool;                 /* unit axis from tip to spindle when all stand at zero */
    bool measured;                    /* the triangle is known: chain_measure */
    struct chain_triangle triangle;
};

/* For a chain whose axes stay as they are: chain_angles need not find its triangle each time. */
void chain_measure(struct kinematic_chain *chain);

/* The angle q with as many whole turns more or fewer as bring it nearest to `from`. */
static inline double angle_nearest(double q, double from)
{
    return q + 2 * PI * round((from - q) / (2 * PI));
}

/* remainder(q, 2 PI), to the bit: one whole turn taken off is exact, and none needs no division. */
static inline double angle_remainder(double q)
{
    double turn = 2 * PI, size = fabs(q);

    if (size <= PI)
        return q;
    if (size < 1.49 * turn && size != turn)
        return q > 0 ? q - turn : q + turn;
    return remainder(q, turn);
}

/* Angles as their cosines and sines, where the trigonometry would be most of the time. */
struct turned {
    double cosine[ROTARY_MAX], sine[ROTARY_MAX];
};

struct turned chain_turned(const struct kinematic_chain *chain, const double q[]);

/* Half-way between two, less than half a turn apart. */
struct turned chain_turned_mid(const struct kinematic_chain *chain, struct turned a,
                               struct turned b);

/* The tool axis in the frame of the work. */
struct vec3 chain_axis(const struct kinematic_chain *chain, const double q[]);
struct vec3 chain_axis_of(const struct kinematic_chain *chain, const struct turned *at);

/* The tip in the frame of the work, when the linear axes stand at `linear` and tool-centre-point
 * control is off; at zero angles it is `linear` itself. */
struct vec3 chain_tip(const struct kinematic_chain *chain, struct vec3 linear, const double q[]);
struct vec3 chain_tip_of(const struct kinematic_chain *chain, struct vec3 linear,
                         const struct turned *at);

/* Where the linear axes must stand for the tip to be at `tip`: the inverse of chain_tip. */
struct vec3 chain_linear(const struct kinematic_chain *chain, struct vec3 tip, const double q[]);
struct vec3 chain_linear_of(const struct kinematic_chain *chain, struct vec3 tip,
                            const struct turned *at);

/* Its angles at zero, or as near as their travel lets them be; q[ROTARY_MAX], 0 beyond chain->n. */
void chain_zero(const struct kinematic_chain *chain, double q[]);

/* How far the tool of two axes can lean off `pole`, the first one's direction or its opposite, if
 * the axes turn without end, radians. */
double chain_most_lean(const struct kinematic_chain *chain, struct vec3 pole);

/* The direction is singular: the axis nearest the work may have any angle. */
bool chain_free(const struct kinematic_chain *chain, struct vec3 axis);

/* What chain_angles found. */
struct chain_solutions {
    int n;                   /* 0: out of the chain's reach, else 1 or 2 */
    double q[2][ROTARY_MAX]; /* each within -pi..pi */
    bool free;               /* singular: the axis nearest the work may have any angle */
};

/*
 * The angles that bring the tool axis to the unit vector `axis`, both solutions.  Two axes: the
 * angle between their directions and the tool's are sides of a spherical triangle; its half-angle
 * formula keeps its precision near the singular direction, where acos loses half its digits.
 */
struct chain_solutions chain_angles(const struct kinematic_chain *chain, struct vec3 axis);

#endif
