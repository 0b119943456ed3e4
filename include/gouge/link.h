/*
 * link - from the end of one cut to the start of the next with the tool down over the surface; over
 * the clearance plane it is link_retract.h.  The whole tool is clear on all of it: the ball, and
 * what is above it (holder.h).
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
    /* The axis of a low link turns as rotary axes do, through their pole or wide of it (NULL:
     * straight), and stays in the travel of these (NULL: in any). */
    const struct rotary_frame *frame;
    const struct kinematic_chain *chain;
    struct vec3 leave, arrive; /* of a low link: directions of the ball's path before and after it,
                                  unit; zero: not known */
    double clearance;          /* least z of the tip on the clearance plane, mm */
    double floor;              /* least z of the ball's centre on a way to it, mm */
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

#endif
