/*
 * feature_steps - how creases, walls and ribs get into a mesh, step by step: what lies between two
 * neighbouring vertices, from there on along it, room for its facets, the mesh cut open, which of
 * it to keep; then ribs and grooves.
 */
#ifndef CLOUDMILL_FEATURE_STEPS_H
#define CLOUDMILL_FEATURE_STEPS_H

#include <stdbool.h>

#include "math/kdtree.h"
#include "math/point_grid.h"
#include "math/side_fit.h"
#include "math/vec.h"
#include "mesh/mesh.h"
#include "mesh/mesh_edges.h"

/* ---- feature: what lies between two neighbouring vertices of a mesh: a crease, a wall, or
 * nothing.
 *
 * The points of the cloud between them are divided into those of the surface that the one
 * vertex is on and those of the other's; where two such sheets fit the points better than one
 * surface does, they meet in a crease, or stand one above the other at a wall. */

/* The cloud, as wall_points_part put it in order. */
struct feature_cloud {
    const struct point_grid *scan; /* the points that lie on no wall */
    const struct kdtree *walls;    /* of those that do, NULL: there are none */
    const struct vec3 *wall;
    double spacing; /* mean spacing of the points, mm */
    double noise;   /* standard deviation of it, mm */
};

enum feature_kind { FEATURE_NONE, FEATURE_CREASE, FEATURE_WALL };

/* Vertex a has end 0, vertex b end 1. */
struct feature {
    enum feature_kind kind;
    struct vec3 place[2];  /* on the sheet of each end; on a crease the same place */
    struct vec3 normal[2]; /* of the sheets there, unit */
    struct vec3 wall;      /* the wall's unit normal out of the material; a crease: zero */
    struct vec3 end[2];    /* unit normals of the sheets at the vertices */
    struct vec3 foot[2];   /* the vertices brought onto the sheets, as far as these are known ... */
    double known;          /* ... as far from the places, mm */
    struct vec3 along;     /* direction of the edge or wall, unit */
};

enum { FEATURE_MOST = 400 };

/* How many points about a place it takes to see a crease in the noise, 72 to FEATURE_MOST. */
size_t feature_reach(const struct feature_cloud *cloud);

/* The k points (at most FEATURE_MOST) nearest to a place, nearest first; returns how many. */
size_t feature_near(const struct feature_cloud *cloud, struct vec3 at, size_t k, struct vec3 *near);

/* Has the cloud a point near a place, three spacings or less from it?  Where it ends or has a gap
 * what goes on beside that would put the place far off it. */
bool feature_has_points(const struct feature_cloud *cloud, struct vec3 at);

/* May there be a wall: is the way from a to b steep, with a point of a wall over or under it? */
bool feature_steep(const struct feature_cloud *cloud, struct vec3 a, struct vec3 b);

/* A crease: `na` and `nb` are unit normals at the vertices.  Sheets that turn by less than 8
 * degrees are no crease. */
struct feature feature_crease(const struct feature_cloud *cloud, struct vec3 a, struct vec3 b,
                              struct vec3 na, struct vec3 nb);

/* A wall, along z or no more than 15 degrees from it, on which there are points. */
struct feature feature_wall(const struct feature_cloud *cloud, struct vec3 a, struct vec3 b);

/* ---- feature_test: is a crease sharp, or a rounded edge or a narrow rib that was taken for one?
 */

/*
 * Two sheets, as heights along `up`, meet at a place, in a crease that runs `along` (unit vectors).
 * A rounded edge leaves that line: the points nearest to the place, or those of a neighbourhood
 * that is long the way it runs (ridge_direction.h), are all on one side of the sheets, or a quadric
 * leaves much less of them, and the sheets more than noise does.  False also where there are too
 * few points.
 */
bool feature_test_sharp(const struct feature_cloud *cloud, const struct side_fit sheet[2],
                        struct vec3 up, struct vec3 at, struct vec3 along);

/* ---- feature_link: gaps in the lines that creases and walls make over a mesh. */

/*
 * A crease or wall ends where it comes into a facet over one of its edges and crosses none of the
 * other two.  From there it is followed, straight on over the sheets that it has, from facet to
 * facet; where that leads within six of them to another crease or wall, or to the border of the
 * mesh (or through a corner beside that), the edges on the way get its continuation, in place of
 * FEATURE_NONE.  A crease goes on only over edges whose ends are on its sheets.  Nothing else
 * changes.
 */
void feature_link_close(const struct mesh *mesh, const struct mesh_edges *edges,
                        struct feature *feature);

/* The most edges in one chain: from facet to facet, over edges that something crosses. */
size_t feature_link_longest(const struct mesh_edges *edges, const struct feature *feature);

/* ---- feature_relocate: the vertices beside creases and walls, put where these leave room for
 * facets. */

struct feature_relocate {
    struct mesh *mesh;
    const struct mesh_edges *edges;
    const struct feature *feature; /* of each edge */
    double spacing, noise;         /* of the cloud, mm */
};

/* Vertices nearer to a feature than a quarter of its edge, of the facets beside it, move away from
 * it along the sheet of their side, and onto that when they are far off it, as points on a wall
 * are. Where a corner of two features juts out of its facet they move on to make room for it.
 * beside[] gets which vertices have a feature near to them. */
void feature_relocate_places(const struct feature_relocate *s, unsigned char *beside);

/* Vertices with a feature on one of their edges get the normal of their side. */
void feature_relocate_normals(const struct feature_relocate *s);

/* Where there is noise the sheets of a feature tell best where the vertices beside it are: these go
 * to the mean of what their features say. */
void feature_relocate_feet(const struct feature_relocate *s);

/* Vertices that have no feature near to them, or have come farther than its sheets are known, are
 * as they were `before`, normals too. */
void feature_relocate_back(const struct feature_relocate *s, const struct mesh *before);

/* ---- feature_corner: where creases or walls meet within a facet.
 *
 * A facet that two walls cross, or creases between three sheets, holds the corner that they make:
 * the place where their planes meet. */

struct feature_corner_plane {
    struct vec3 place, normal; /* unit */
};

/* Where three planes meet, reckoned from a place near to it.  False: two of them are turned by less
 * than about 8 degrees, or all are along one line. */
bool feature_corner_of(const struct feature_corner_plane plane[3], struct vec3 from,
                       struct vec3 *corner);

/* The same; false too where that is not within the triangle, seen from above. */
bool feature_corner(const struct feature_corner_plane plane[3], const struct vec3 triangle[3],
                    struct vec3 *corner);

/* The plane half way between two. */
struct feature_corner_plane feature_corner_mean(struct feature_corner_plane a,
                                                struct feature_corner_plane b);

/* ---- feature_cut: a mesh cut open along creases and walls (paper 1, 7, figs 45 and 46). */

/*
 * Puts the vertices of each edge's feature into the mesh, and facets in place of those that it
 * crosses.  At a crease there are two vertices at one place, each with the normal of its side; at a
 * wall four, two at its top and two at its foot, of which the inner two have the normal of the
 * wall, and vertical facets between them.  They come in the order from the edge's first vertex to
 * its second; those of an edge along a row get its row and the column of its first vertex, the
 * others row and column -1.  Where two walls, or the creases between three sheets, meet within a
 * facet, that corner gets vertices too (feature_corner), after those of all edges.
 *
 * feature[edges->n]: FEATURE_NONE leaves the edge as it is.  The mesh must have normals.
 */
void feature_cut(struct mesh *mesh, const struct mesh_edges *edges, const struct feature *feature);

/* ---- feature_accept: which features bring a mesh closer to its scan. */

/*
 * Sets to FEATURE_NONE those of the n features about which the scan is further from the mesh `with`
 * them than from that `without`: the sum of the squared distances of the points within `reach` mm
 * of its place, and of those of other features within four times that, must be less, or no more by
 * a tenth of what `noise` (one standard deviation, mm) makes of it.
 */
void feature_accept(const struct mesh *without, const struct mesh *with, const struct vec3 *point,
                    size_t points, double reach, double noise, int threads, struct feature *feature,
                    size_t n);

/* ---- crest: what the surface does over one edge of a mesh: the ridge or the groove that it
 * crosses.
 *
 * A rounded rib is no crease, but where it is narrow against the edges of a mesh these cut off its
 * top.  The surface over the edge is followed in steps of half the spacing of the points; its
 * highest or lowest place against the normal of the neighbourhood is the crest, and it is looked at
 * again with a neighbourhood that is long the way the rib runs (math/ridge_direction.h). */

enum { CREST_MOST = 7 };

/* Points of the surface over an edge, from its first end to its second. */
struct crest {
    int n;                   /* 0: straight, or nothing that bends one way only */
    int top;                 /* which of them is on the crest, -1: none is */
    double part[CREST_MOST]; /* of the way, seen from above */
    struct vec3 place[CREST_MOST], normal[CREST_MOST];
    double kmax[CREST_MOST]; /* the larger principal curvature, as in quadric.h */
};

/* The surface bends over the edge from a to b by more than 4 % of its length, at a crest; beside it
 * or without one by more than 8 %, or 0.4 mean spacings.  Where it bends nearly as much along as
 * across, or has a radius of more than twice the edge, it is no rib.  `up`: the normal of the
 * neighbourhood (unit), roughly. */
struct crest crest_find(const struct feature_cloud *cloud, struct vec3 a, struct vec3 b,
                        struct vec3 up);

/* ---- crest_insert: crests put into a mesh; crest_mesh.c looks for them, as feature.h says. */

/* Edges of a mesh and what was found over them. */
struct crest_edges {
    struct faces face;              /* some facets of the mesh ... */
    struct sizes facet;             /* ... and which they are of it, rising */
    const struct mesh_edges *edges; /* of these facets alone */
    struct sizes edge;              /* those of the edges that were looked at */
    struct crest *crest;            /* [edge.n]: over each of them */
    int *of;                        /* [edges->n]: which of them each edge is; -1: none */
};

/*
 * Puts the points of each crest into the mesh as vertices, in the order from its edge's first
 * vertex to its second, and cuts up the facets beside it: from crest to crest, or from the only
 * crest to the corner opposite, and what is left by ears (math/earclip.h).  Vertices on an edge
 * along a row get its row and the column of its first vertex, the others row and column -1.
 * Returns how many edges got points; the mesh must have normals.
 */
size_t crest_insert(struct mesh *mesh, const struct crest_edges *at);

#endif
