/*
 * pass_extend - rows of contact points that run out to the border of the scan.
 *
 * The outermost vertices of a mesh are points some way inside the border of the scan that they were
 * chosen from: by up to its spacing, and what planes cut of the mesh ends there.  Here rows go on
 * over the points of the scan itself, as far as it has some on all sides (border_surface.h).
 */
#ifndef CLOUDMILL_PASS_EXTEND_H
#define CLOUDMILL_PASS_EXTEND_H

#include "toolpath/border_surface.h"
#include "toolpath/slice.h"

/* Leaves out of the strips what lies beyond the border of the scan, as where the mesh has vertices
 * on surfaces continued over it.  Returns how many points. */
size_t pass_extend_within(const struct border_surface *border_surface, struct slice_chains *strips);

/* Lengthens the strips of a plane, which run along, at both ends; closed ones stay as they are, and
 * so do ends from which the scan goes on beyond what is beside the mesh: there the mesh is meant to
 * end.  Strips that meet become one.  Returns the length that was added, mm. */
double pass_extend_ends(const struct border_surface *border_surface,
                        const struct border_surface_plane *plane, struct slice_chains *strips);

/* What is cut beside a plane: the strips that it goes on from, and where those on its other side
 * (NULL: none) leave it nothing to do. */
struct pass_extend_neighbours {
    const struct slice_chains *from, *beyond;
};

/*
 * Adds to the strips of a plane what a neighbouring one has beside them that they have not, in
 * pieces of at least `shortest` mm.  All of them then stand in the order in which they begin along
 * the plane.  Returns the length that was added, mm.
 */
double pass_extend_beside(const struct border_surface *border_surface,
                          const struct border_surface_plane *plane,
                          const struct pass_extend_neighbours *beside, double shortest,
                          struct slice_chains *strips);

#endif
