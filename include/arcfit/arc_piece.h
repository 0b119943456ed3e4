/*
 * arc_piece - a piece of a fitted motion: an arc or a line that follows a reference from one place
 * to another, and how far it is off.
 */
#ifndef CLOUDMILL_ARC_PIECE_H
#define CLOUDMILL_ARC_PIECE_H

#include "curve/arc.h"
#include "curve/reference.h"

/* The axis turns on the great circle, in proportion to the arc's angle. */
struct arc_piece {
    struct arc arc;
    double from, to;           /* places on the reference */
    struct vec3 axis, axis_to; /* at its ends, unit */
    bool biarc;                /* it and the next one are a biarc */
};

struct pieces {
    size_t n, cap;
    struct arc_piece *item;
};

/* With the axes that the reference has at these places. */
struct arc_piece arc_piece_of(const struct reference *reference, struct arc arc, double from,
                              double to);

/*
 * How far the piece is off its part of the reference: at the feet of the reference's points, at the
 * ends and at `fine` places between (more on long intervals); from the arc to the reference and
 * from the reference's points to the arc.  With `within` not NULL it stops as soon as one of its
 * figures is exceeded, and returns what it found up to there; and between points it looks only
 * where what it found at them does not yet say that all in between is within.
 */
struct deviation arc_piece_deviation(const struct reference *reference,
                                     const struct arc_piece *piece, int fine,
                                     const struct deviation *within);

/* The same to decide whether it is within, more quickly: each figure is above that of `within`
 * where the one above is, and else may be any that is not. */
struct deviation arc_piece_decision(const struct reference *reference,
                                    const struct arc_piece *piece, int fine,
                                    const struct deviation *within);

#endif
