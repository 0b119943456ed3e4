/*
 * passes - the chains of one plane as strips in the order they are cut, across adjoining surfaces
 * and gaps (paper 2, 2.2: "guarantees the continuity of the machining").
 */
#ifndef CLOUDMILL_PASSES_H
#define CLOUDMILL_PASSES_H

#include "gouge/gouge.h"
#include "toolpath/slice.h"

struct pass_options {
    struct vec3 normal; /* of the planes, unit, towards the next one */
    struct vec3 along;  /* horizontal unit vector in the planes: the way that odd passes go */
    double gap;         /* chains whose ends are no further apart are one strip, mm, but where */
    const struct gouge_check *guard; /* (NULL: nowhere) this scan has no points between them ... */
    double bare;                     /* ... within so much, mm: a hole */
    struct vec3 facing;              /* unit; what faces away from it is left out ... */
    bool faced;                      /* ... if this is set */
    double radius;                   /* of the ball, and ... */
    double tolerance; /* ... what it may sink in where it rolls over a sharp edge, mm */
};

/*
 * Appends the strips of a plane's chains.  An open chain goes the way of `along` from end to end; a
 * closed one starts at its end against `along`, and goes over its upper side first.  The strip with
 * the least start along comes first, and goes on with the chain whose start (or, turned round, end)
 * is the nearest within the gap, unless the way there is over a hole of the scan.  Where such a
 * joint is a ridge, points between turn the normal from one side to the other, so that straight
 * lines between the ball's centres sink in by no more than the tolerance.  Returns how many points
 * face away and were left out.
 */
size_t passes_make(const struct slice_chains *chains, const struct pass_options *rule,
                   struct slice_chains *strips);

/* Turns all strips and their order round: the way back. */
void passes_reverse(struct slice_chains *strips);

/*
 * The normal of the planes (rule.normal or its opposite) with which a strip goes forward as its
 * cross product with the surface's normal.
 */
struct vec3 passes_forward(const struct slice_chains *strips, size_t strip, struct vec3 normal);

/* Length of all chains, mm. */
double chains_length(const struct slice_chains *chains);

/* The horizontal direction in planes of this normal that has the next plane on its left; x for
 * horizontal planes. */
struct vec3 passes_along(struct vec3 normal);

#endif
