/*
 * gouge_lift - how a ball is lifted: a run of contact points made clear of the part, each centre
 * raised along its normal.
 *
 * A run holds where the ball of the tool touches, strip by strip: contact, normal, centre, axis and
 * tip (run.h).  The centre is off the contact point by an offset, the radius of the ball and what a
 * layer leaves on the part, and by the lift: the least that clears the guard points (gouge.h).  The
 * contacts of a coarse mesh may float above the scan that it was made from, by its sagitta: with
 * `sink` the ball is let down from there until it touches.  So where it fits it touches, and where
 * it does not it runs on the envelope of the balls that do.  That has a corner at each point that
 * takes over from another; where more may stay, centres are lifted a little more (lift_smooth.h).
 * And the normals of single contacts, and lifts along them, put centres to
 * and fro across the row, though a ball touches as well a little beside: so normals are averaged
 * along a row first (`even`), and centres are moved along the surface, no more than `aside`, and
 * lifted anew there.
 */
#ifndef CLOUDMILL_GOUGE_LIFT_H
#define CLOUDMILL_GOUGE_LIFT_H

#include "curve/run.h"
#include "curve/tool_axis.h"
#include "gouge/gouge.h"

struct gouge_lift_options {
    const struct gouge_check *guard; /* NULL: nothing is lifted */
    double offset;                   /* of the centre from the part, mm */
    double limit;                    /* highest lift, mm */
    double sink;  /* contacts may float above what the guard points stand for by so much, mm: the
                    ball is let down on that where it is no farther; 0: contacts are taken as they
                    are */
    bool between; /* put points between those that are given */
    double tolerance; /* of straight lines against the curve and the part, mm */
    double step;      /* no points nearer than this are put between, mm */
    double aside;     /* centres may be moved sideways, along the surface, by so much, mm, so that
                         they run smoothly */
    double even;      /* normals of a run become their means over so much of it before and after,
                         mm (smooth_normals.h); 0: they stay */
    double uncut;     /* what may stay uncut under a ball that was lifted, mm */
    struct tool_axis_options axis;
    struct tool_axis_feed feed;
};

/* What became of the points.  Starts as all zero. */
struct gouge_lift_report {
    size_t points;
    size_t lifted;              /* along their normals, within the limit */
    double highest;             /* lift of those, mm */
    struct vec3 highest_at;     /* contact point */
    size_t unreachable;         /* points that the ball can't reach within the limit */
    double unreachable_by;      /* how far over them it passes at most, mm */
    struct vec3 unreachable_at; /* contact point there */
};

/*
 * A place where a lifted ball may leave material uncut, as far as can be seen from there: so much
 * farther down goes a ball of half the radius with the same lowest point.  Where the contact point
 * alone was too low it is nothing.
 */
struct uncut {
    struct vec3 contact;
    double height; /* mm */
};

/* Runs end to end, and where each of them ends: from there to the next the tool has to go over the
 * clearance plane. */
struct lifted_strip {
    struct run run;
    struct sizes end; /* of each part, as index of run.item; the last one is run.n */
    struct gouge_lift_report report;
    struct {
        size_t n, cap;
        struct uncut *item;
    } uncut; /* those above rule.uncut */
};

void lifted_strip_free(struct lifted_strip *strip);

/* Appends the point that touches at `contact`: centre, axis and tip by the rule, not lifted. */
void gouge_lift_contact(struct run *run, const struct gouge_lift_options *rule, struct vec3 contact,
                        struct vec3 normal);

/*
 * Appends each point of the run lifted, its axis turned where that depends on the centre.  A point
 * that a lift along its normal within the limit does not clear, or that a tool from outside can't
 * come to, is unreachable: it is lifted straight up in z as far as it takes, and loses its normal,
 * for nothing is touched there.  Between such a point and its neighbours come points that lead the
 * tool over what is between; they have no normal either.
 *
 * With rule.between there are points between, on the smooth curve of run_densify, lifted too: so
 * many that straight lines and a smooth curve through them stay within the tolerance of the lifted
 * curve, centre and tip, or under it where they may, for the ball on the lines goes no deeper than
 * the tolerance into the guard.  They are no nearer than `step`, but where the lift jumps.
 */
void gouge_lift_run(const struct run *run, const struct gouge_lift_options *rule,
                    struct lifted_strip *to);

#endif
