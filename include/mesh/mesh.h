/*
 * mesh - a triangulated surface with normals and, when it came from a triangular grid, its rows.
 *
 * Lengths in mm.  Normals are unit vectors out of the material.  Beside it:
 *
 *   mesh_edges.h      edges, and the facets beside them
 *   mesh_outline.h    its border seen along z, as polygons
 *   mesh_weld.h       vertices at one place become one
 *   mesh_repair.h     a mesh from elsewhere made fit to be cut: cleaned, oriented, with normals
 *   mesh_distance.h   how far points are from it, and which are above or below it
 *   mesh_clip.h       the part of it inside a box, of some surfaces, of some steepness
 *   facet_split.h     facets split at points, with edges turned (Lawson 1977)
 */
#ifndef CLOUDMILL_MESH_H
#define CLOUDMILL_MESH_H

#include <stdbool.h>

#include "base/array.h"
#include "base/error.h"
#include "base/unmet.h"
#include "math/faces.h"
#include "math/transform.h"
#include "math/vec.h"
#include "mesh/scan_source.h"

/* One of the surfaces that a mesh was made from: where it is most tightly hollow. */
struct mesh_surface {
    char *name;     /* its file and its number there */
    double radius;  /* mm, 0: nothing of it is hollow */
    struct vec3 at; /* where */
};

struct mesh_surfaces {
    size_t n, cap;
    struct mesh_surface *item;
};

/* A part with a projection of its own: its rows, and those up to the next part. */
struct mesh_part {
    int row;           /* its first one */
    struct vec3 along; /* unit, the way the columns rise */
    struct vec3 up;    /* unit, perpendicular: out of the plane that its grid lies in */
};

struct mesh_parts {
    size_t n, cap;
    struct mesh_part *item;
};

/* What the mesh stream says of itself in its comments; zero or NAN where it says nothing. */
struct mesh_origin {
    bool own;                     /* a stream of this suite, in mm */
    char *unit;                   /* what a mesh of another program calls its unit; NULL: nothing */
    char *source;                 /* the files it was made from */
    double spacing;               /* t of the triangular grid, mm */
    double direction;             /* of the rows, degrees about z from x */
    double ledger;                /* tolerance spent by the maker, mm; NAN: not said */
    double extended;              /* how far it goes beyond the scan, mm; 0: with it */
    double noise;                 /* of the scan, one standard deviation, mm */
    char *maker;                  /* the tool that spent it, NULL: not said */
    struct mesh_surfaces surface; /* that it was made from; none: not said */
    struct mesh_parts part;       /* by rising row; none: it is one, seen from above */
    bool placed;                  /* `place` is more than the identity */
    struct transform place;       /* from the scan's own numbers (its units) to this mesh's mm */
    struct scan_sources scan;     /* the files it was made from; placed as `place` says */
    struct scan_sources itself;   /* its own file and vertices, as they were read; none: not kept */
    struct unmets unmet;          /* what the stages so far could not keep */
};

struct mesh {
    struct vec3s vertex;
    struct vec3s normal;  /* as many as vertices, or none */
    struct ints row, col; /* of the triangular grid, from 0: as many as vertices, or none */
    struct doubles kmax;  /* largest concave curvature, 1/mm: as many as vertices, or none */
    struct faces face;    /* row by row, in each row the triangles that point up first */
    struct ints surface;  /* of each face: which of origin.surface; as many as faces, or none */
    struct mesh_origin origin;
    bool normals_made; /* not those of the surface: means of the facets, which are the part */
};

void mesh_free(struct mesh *mesh);

/* Normal of a face by the right-hand rule, its length twice the face's area. */
struct vec3 mesh_face_cross(const struct mesh *mesh, size_t face);

/* Of all facets, mm2. */
double mesh_area(const struct mesh *mesh);

/* Unit normal of a triangle by the same rule; false when it has no area to speak of. */
bool mesh_triangle_normal(const struct vec3 p[3], struct vec3 *normal);

/* The unit vector along a sum of normals; straight up where they cancel or there are none. */
struct vec3 mesh_mean_direction(struct vec3 sum);

/* What part of the area of the facets is steeper than 70 degrees against `up` (unit), 0 to 1. */
double mesh_steep_part(const struct mesh *mesh, struct vec3 up);

/* The mean of the facets' normals by their area: of length 1 where all face one way, and of none
 * where they face all around. */
struct vec3 mesh_facing(const struct mesh *mesh);

/*
 * Paper 1, eq 8: at each vertex the mean of the unit normals of its facets, made a unit vector;
 * facets without area do not count, a vertex without a facet, or whose normals cancel, gets
 * (0, 0, 1).  Fills mesh->normal.
 */
void mesh_normals_facet(struct mesh *mesh);

/* On a mesh seen from above no normal points down: those that do are replaced by the mean of the
 * facets' (eq 8), or (0, 0, 1) where that does too.  Returns how many. */
size_t mesh_normals_seen(struct mesh *mesh);

/* Normals on the other side of their facets are turned or, where they are no more than crosswise,
 * give way to the facets' mean.  Returns how many. */
size_t mesh_normals_turn(struct mesh *mesh);

/* Paper 1, eq 7 (Gouraud): the mean of the normals of the vertices that share an edge with it,
 * made a unit vector.  Replaces the normals of the mesh; a vertex without
 * neighbours, or where they cancel, keeps its own. */
void mesh_normals_gouraud(struct mesh *mesh);

/*
 * Central differences along the row and the column of a mesh with rows: the cross product of the
 * differences between the two neighbours in each direction, one-sided at a border; where a vertex
 * has none in its column, those in the other oblique direction (row + 1, column - 1) stand in.  -1
 * when the mesh has no rows or a vertex has no neighbour in one of the directions.
 */
int mesh_normals_central(struct mesh *mesh, struct error *error);

#endif
