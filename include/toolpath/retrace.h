/*
 * retrace - where a lifted pass goes back on itself.
 *
 * In a hollow narrower than the ball each contact lifts the ball along its own normal until it
 * touches the other side: the centres of one flank run on over the offset of the other one, beyond
 * the place where the two offsets meet, and come back over the first.  That is the loop of an
 * offset curve that crosses itself; what it touches is touched once more where the pass comes there
 * by its own contacts, and the tool turns back on its way at the ends of the loop.  So it is cut
 * off where the offsets meet.
 */
#ifndef CLOUDMILL_RETRACE_H
#define CLOUDMILL_RETRACE_H

#include "gouge/gouge_lift.h"

/* mm: no piece of a program should be shorter; with digits to spare. */
#define RETRACE_NEAR 0.0205

struct retrace_options {
    double offset;                   /* of the centre from the part, mm */
    double tolerance;                /* centres lifted by no more are where they belong, mm */
    double gap;                      /* the ends of a loop are no further apart, mm */
    double longest;                  /* no loop is longer, mm */
    const struct gouge_check *guard; /* the ball has to be clear of, from one end to the other */
};

/*
 * Takes out of each part of the strip the points between two whose centres are within `gap`, where
 * the way between them is more than twice as long, all of its points are lifted, and the ball
 * goes straight from the one to the other no deeper than the tolerance.  Returns how many.
 */
size_t retrace_remove(struct lifted_strip *strip, const struct retrace_options *options);

/*
 * Takes out the points, lifted or no farther than the tolerance off the straight way past them, at
 * which the way turns by more than 30 degrees within RETRACE_NEAR of a neighbour, where the ball
 * goes straight from the one before to the one after no deeper than the tolerance: what is left of
 * a loop where its ends do not meet in one point, a hook that no piece of usual length follows.
 * The first and the last point of each part stay.  Returns how many.
 */
size_t retrace_hooks(struct lifted_strip *strip, const struct retrace_options *options);

/*
 * Takes out the points at which nothing is touched and that are thrown up between two others: by
 * more than the offset from both, and back at a sharp angle, as where one contact under an overhang
 * is lifted over all of it.  Where the ball does not go straight past such a point no deeper than
 * the tolerance, a part ends before it.  Returns how many.
 */
size_t retrace_spikes(struct lifted_strip *strip, const struct retrace_options *options);

#endif
