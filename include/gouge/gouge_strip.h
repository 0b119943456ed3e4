/*
 * gouge_strip - a run of contact points made clear of the part: each centre lifted along its
 * normal.
 *
 * A run holds, strip by strip, where the ball of the tool touches: contact, normal, centre, axis
 * and tip (run.h).  The centre stands off the contact point by an offset, the radius of the ball
 * and what a layer leaves on the part, and by the lift.
 */
#ifndef CLOUDMILL_GOUGE_STRIP_H
#define CLOUDMILL_GOUGE_STRIP_H

#include "gouge/gouge_point.h"

/* What became of the points.  Starts as all zero. */
struct gouge_strip_report {
    size_t points;
    size_t lifted;          /* along their normals, within the limit */
    double highest;         /* lift of those, mm */
    struct vec3 highest_at; /* contact point */
    size_t missed;          /* points that the ball can't reach within the limit */
    double miss;            /* how far it passes at most, mm */
    struct vec3 miss_at;    /* contact point there */
};

/*
 * A place where a lifted ball may leave something standing, as far as can be told from there: so
 * much farther down goes a ball of half the radius with the same lowest point.  Where the contact
 * point alone was too low it is nothing.
 */
struct uncut {
    struct vec3 contact;
    double height; /* mm */
};

/* Runs end to end, and where each of them ends: where there is no way but over the clearance
 * plane to the next. */
struct gouge_strip {
    struct run run;
    struct sizes end; /* of each piece, as index of run.item; the last one is run.n */
    struct gouge_strip_report report;
    struct {
        size_t n, cap;
        struct uncut *item;
    } stand; /* those above rule.stands */
};

void gouge_strip_free(struct gouge_strip *lifted);

/* Appends the point that touches at `contact`: centre, axis and tip by the rule, not lifted. */
void gouge_strip_add(struct run *run, const struct gouge_lift_options *rule, struct vec3 contact,
                     struct vec3 normal);

/*
 * Appends each point of the run lifted, its axis turned where that depends on the centre.  A point
 * that a lift along its normal within the limit does not clear, or that a tool from outside can't
 * come to, is lifted straight up in z as far as it takes, and loses its normal: nothing is touched
 * there.  Between such a point and its neighbours come points that the tool needs to go over what
 * is between; they have no normal either.
 *
 * With rule.between there are points between, on the smooth curve of run_densify, lifted too: so
 * many that straight lines and a smooth curve through them stay within the tolerance of the lifted
 * curve, centre and tip, or under it where they may, for the ball on the lines goes no deeper than
 * the tolerance into the guard.  They are no nearer than `step`, but where the lift jumps.
 */
void gouge_strip_lift(const struct run *run, const struct gouge_lift_options *rule,
                      struct gouge_strip *to);

#endif
