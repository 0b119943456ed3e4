/*
 * arc_link - a link between two cuts as few arcs.
 *
 * A link touches nothing, so that nothing binds it to the way it was planned on but that the whole
 * tool is clear, which who asks for it looks at.  What is wanted is few pieces, and that they begin
 * and end in the directions of the cuts beside them.
 */
#ifndef CLOUDMILL_ARC_LINK_H
#define CLOUDMILL_ARC_LINK_H

#include "arcfit/arc_piece.h"

struct arc_link_options {
    struct vec3 leave, arrive; /* directions of the cuts before and after it, unit; zero: the way's
                                  own */
    struct vec3 out[2];        /* of the part at the start and at the end, unit; zero: the axis */
    double off;                /* mm: no further off the way it was planned on, */
    double below;              /* and no further in than that, for what is beside the part that is
                                  known is not known, */
    double least;              /* no piece shorter, nor its radius, */
    int digits;                /* and the decimals that joints are rounded to */
    bool (*clear)(void *context, const struct pieces *pieces); /* the whole tool is, all along */
    void *context;
};

/*
 * Pieces from the first point of the reference to the last, in the place of what is in `pieces`:
 * the first that are clear of, in this order, a line or an arc whose ends turn the cuts' directions
 * by no more than ARC_LINK_KINK, a biarc, and chains of them through points of the reference, each
 * with the ends' directions as they are, and turned out of the part by so much.  At every joint the
 * direction is continuous.  False: none is; `pieces` is empty.
 */
bool arcfit_link(const struct reference *reference, const struct arc_link_options *options,
                 struct pieces *pieces);

#define ARC_LINK_KINK RADIANS(15)

#endif
