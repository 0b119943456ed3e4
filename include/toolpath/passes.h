/*
 * passes - from a mesh to the passes of a ball cutter.  This is the main header of the folder: it
 * tells the stages, and holds the one that makes passes of what a plane cuts.
 *
 * In comes a mesh with normals; out come strips of contact points with normals, pass by pass in the
 * order they are cut.  There are two ways to get them:
 *
 *   rows of the mesh (paper 1, 3.2.1 and 3.3):
 *     rows.h           the rows of a triangular grid as strips
 *   parallel planes (paper 2, 2.1 and 2.2):
 *     scallop.h        where the planes go: equal distances, or what a scallop height allows
 *     slice.h          where a plane crosses the mesh: chains of contact points
 *     passes.h         chains as strips across adjoining surfaces and gaps, in order ("guarantees
 *                      the continuity of the machining"), the ball rolled over sharp edges
 *     pass_extend.h    strips lengthened to the border of the scan, on border_surface.h
 *
 * What comes after: the ball is lifted clear and strips are linked (gouge/gouge.h); tilt.h sets the
 * tool axes of a finished run anew.
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
 * the least start along comes first: it begins with the chain to which those that join that one
 * lead back, and goes on with the chain whose start (or, turned round, end) is the nearest within
 * the gap, unless the way there is over a hole of the scan.  Where such a
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

/* The horizontal direction in planes of this normal that has the next plane on its left; x for
 * horizontal planes. */
struct vec3 passes_along(struct vec3 normal);

/* ---- a sharp edge: the ball rolled from the normal of its one side to that of the other */

/*
 * Appends to `to` contacts from `last` to `next`, without these, that turn the normal in so small
 * steps that straight lines between the ball's centres sink in by no more than `tolerance`.
 * `forward` is the way to `last` from the contact before it: in a valley, where the normal turns
 * backwards, there are none.
 */
void edge_roll(struct contacts *to, struct vec3 forward, struct contact last, struct contact next,
               double radius, double tolerance);

#endif
