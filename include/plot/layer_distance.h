/*
 * layer_distance - how far one layer of a scene is from another.
 */
#ifndef CLOUDMILL_LAYER_DISTANCE_H
#define CLOUDMILL_LAYER_DISTANCE_H

#include "plot/scene.h"

struct layer_distance {
    size_t n;          /* places measured; 0: nothing to measure */
    double worst, rms; /* mm */
    double most95;     /* mm: 95 in 100 places are no further */
    struct vec3 at;    /* where the worst is */
};

/*
 * From the places of `from` (points; vertices of a mesh; what is cut of a path or program, at its
 * nodes and between them no coarser than a thousandth of its extent) to the nearest place of `to`:
 * its points, facets, or straight pieces of what is cut.  On `threads` threads (parallel.h).
 */
struct layer_distance layer_distance_of(const struct layer *from, const struct layer *to,
                                        int threads);

#endif
