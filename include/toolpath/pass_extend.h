/*
 * pass_extend - strips of contact points lengthened to the border of the scan.
 *
 * The outermost vertices of a mesh lie up to its spacing inside the border of the scan that they
 * were chosen from, and what planes cut of the mesh ends there.  Here strips go on over the points
 * of the scan itself, as far as it has some on all sides (border_surface.h).
 */
#ifndef CLOUDMILL_PASS_EXTEND_H
#define CLOUDMILL_PASS_EXTEND_H

#include "toolpath/border_surface.h"
#include "toolpath/slice.h"

/* Leaves out of the strips what lies beyond the border of the scan, as where the mesh has vertices
 * on surfaces extended over it.  Returns how many points. */
size_t pass_extend_within(const struct border_surface *border_surface, struct slice_chains *strips);

/* Lengthens the strips of a plane, which run along it, at both ends.  Closed ones stay as they are,
 * and so do ends from which the scan goes on far beyond the mesh: there the mesh is meant to end.
 * Strips that meet become one.  Returns the length that was added, mm. */
double pass_extend_ends(const struct border_surface *border_surface,
                        const struct border_surface_plane *plane, struct slice_chains *strips);

/* What is cut beside a plane: the strips that it continues, and those on its other side (NULL:
 * none), where they leave it nothing to do. */
struct pass_extend_neighbours {
    const struct slice_chains *from, *beyond;
};

/*
 * Adds to the strips of a plane what a neighbouring one has beside them that they have not, in
 * strips of at least `shortest` mm.  All of them are then in the order in which they begin along
 * the plane.  Returns the length that was added, mm.
 */
double pass_extend_beside(const struct border_surface *border_surface,
                          const struct border_surface_plane *plane,
                          const struct pass_extend_neighbours *beside, double shortest,
                          struct slice_chains *strips);

#endif
