/*
 * link - from the end of one cut to the start of the next: with the tool down over the surface, or
 * over the clearance plane, by a retract and an approach.  The whole tool is clear on all of it:
 * the ball, and what is above it (holder.h).
 */
#ifndef CLOUDMILL_LINK_H
#define CLOUDMILL_LINK_H

#include <stdbool.h>

#include "gouge/gouge_lift.h"
#include "machine/rotary_cost.h"

struct link_options {
    const struct gouge_lift_options *lift; /* the guard, and how clear of it the tool must be */
    const struct holder *holder;           /* kept clear too, where it has parts */
    double radius;                         /* of the ball, mm */
    double limit;                          /* highest lift of a low link, mm */
    double longest;                        /* a low link may be as long as this, mm */
    double rate; /* fastest turn of the axis on a low link, radians/mm; 0: any */
    const struct rotary_frame
        *frame;                /* the axis of a low link turns as rotary axes do, through their
                                         pole or wide of it; NULL: straight */
    struct vec3 leave, arrive; /* of a low link: directions of the ball's path before and after it,
                                  unit; zero: not known */
    double clearance;          /* least z of the tip on the clearance plane, mm */
    double approach;           /* last bit of the way down, mm */
};

/*
 * Appends the points between two to `link`.  With `leave` and `arrive` known first a curve that
 * goes on as the path does at both ends, a turn from row to row about as wide as the rows are
 * apart, and rises from there to a tenth of its chord.  Where that is not clear: an arch from
 * centre to centre (a tenth of its length high, for there may be material just outside the border
 * of the guard), lifted where that is not clear, so that the ball rolls over what is between; then
 * with a higher arch, and lifted along the axis instead of the normal.  They touch nothing; the
 * ends themselves are not appended.  Without a guard it is a straight line.  False if all of them
 * need a lift above the limit, come out longer than `longest`, are not clear for the whole tool
 * within the tolerance, or turn the axis too fast.
 */
bool link_low(const struct link_options *options, const struct run_point *from,
              const struct run_point *to, struct run *link);

/*
 * Leaves out points of a link, or of what is cut between two points, as it is now: of two whose
 * tips are no further than `least` mm apart the one or the other, where it is no further than `off`
 * mm beside the straight motion past it, on which the whole tool is clear: what was looked at
 * finely need not be so many blocks.  Where the axis passes the pole of options->frame the point
 * stays.
 */
void link_thin(const struct link_options *options, const struct run_point *from,
               const struct run_point *to, double least, double off, struct run *link);

/* Leaves out points of a link as long as the straight motions past them are no further than `off`
 * mm beside each, and the whole tool is clear there: a link of many points was looked at finely,
 * and need not be so many blocks.  Points at the pole stay. */
void link_straighten(const struct link_options *options, const struct run_point *from,
                     const struct run_point *to, double off, struct run *link);

enum { LINK_LEGS = 4 };

/* A way of the ball's centre from a point to the clearance plane, with the point's own axis; an
 * approach is the same reversed. */
struct retract {
    bool clear;                /* it leads there, and the whole tool touches nothing */
    bool rapid;                /* from at[0] on it is so far from everything that it may be rapid */
    size_t n;                  /* of at */
    struct vec3 at[LINK_LEGS]; /* at[0]: the approach distance off the point, or if it is rapid from
                                  there as far as the ball is off the part, by 0.3 R or most of that
                                  distance; corners; and last with the tip on the clearance plane */
};

/*
 * Along the tool axis, if that leads up; what the ball does along its own axis the shank above it
 * has done before, so that this is free wherever the tool fits at all.  Where it is not clear:
 * straight up in z, along the normal, between these; then bent ways, first to any side (out beside
 * the part if it is flat), from there up or along the axis.  The first that is clear at rapid; if
 * there is none, the first that is clear at feed; else not `clear`.  One that leads far aside, as
 * along a flat axis, goes on only until it is clear straight up, if that is shorter by a fifth.
 * Without a guard along the axis.
 */
struct retract link_retract(const struct link_options *options, const struct run_point *p);

/*
 * True if the axis leans further off z on the great circle from `from` to `to`, by a hundredth of a
 * radian or more, than at both its ends: one of them leans beyond the horizontal, and the tool
 * would dip into what is below.  Then *way is where it turns by way of instead: half-way round,
 * and half as far off z as the more upright one.  All unit.
 */
bool link_axis_dips(struct vec3 from, struct vec3 to, struct vec3 *way);

/*
 * The least z of the tip, no less than options.clearance, at which no part of the tool reaches down
 * to the guard's top while its axis has any angle from `least` to `most` (radians) off z.
 */
double link_height(const struct link_options *options, double least, double most);

#endif
