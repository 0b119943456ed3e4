/*
 * mesh_region - the part of a mesh that is to be cut: inside a box, of some of its surfaces, of
 * some steepness.  The rest stays what the tool is kept clear of.
 */
#ifndef CLOUDMILL_MESH_REGION_H
#define CLOUDMILL_MESH_REGION_H

#include "base/error.h"
#include "mesh/mesh.h"
#include "math/region.h"

struct mesh_region_options {
    const double *box;  /* X0,Y0,Z0,X1,Y1,Z1, mm; NULL: all of it */
    const char *faces;  /* numbers of surfaces as messages name them: 5,7-12; NULL: all */
    const char *steep;  /* angles between the normal and `up`, degrees: 0:45; NULL: all */
    const char *region; /* file of polygons seen along z, mm: a corner `x y` a line, an empty line
                           between two of them; NULL: all */
    struct region_polygons *polygons; /* what was read of it, or the outline of what was taken by
                                         faces or slopes; starts as all zero; NULL: not kept */
    struct vec3 up;                   /* unit */
    double border; /* mm: so near the border of a region of points its points are in none */
};

/* Is anything asked for? */
bool mesh_region_given(const struct mesh_region_options *options);

/* Before the mesh is read: -1 and why, where an option can't be read; the polygons are read. */
int mesh_region_check(const struct mesh_region_options *options, struct error *error);

/*
 * The part of a mesh with normals, as a mesh of its own; of its surfaces those that are left, where
 * they are whole ones.  It may be left without facets.  -1 and why: an option that can't be read, a
 * mesh that does not say which surface a facet is of.
 */
int mesh_region_take(const struct mesh_region_options *options, const struct mesh *mesh,
                     struct mesh *part, struct error *error);

/* The part as a region of points, whose polygons are those of the options; after mesh_region_take.
 * What was asked for by faces or slopes is known by its outline, unless much of it is steeper than
 * vertical, over another part of it or so narrow that all is at the border: then nothing is in
 * question. */
struct region mesh_region_of_points(const struct mesh_region_options *options);

#endif
