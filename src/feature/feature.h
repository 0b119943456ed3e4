/*
 * feature - what lies between two neighbouring vertices of a mesh: a crease, a wall, or nothing.
 *
 * The points of the cloud between them are taken apart into those of the surface that the one
 * vertex is on and those of the other's; where two such sheets fit the points better than one
 * surface does, they meet in a crease, or stand one above the other at a wall.
 */
#ifndef CLOUDMILL_FEATURE_H
#define CLOUDMILL_FEATURE_H

#include <stdbool.h>

#include "math/kdtree.h"
#include "math/vec.h"

/* The cloud, as wall_points_part put it in order. */
struct feature_cloud {
    const struct kdtree *tree;  /* of the points that lie on no wall ... */
    const struct vec3 *point;   /* ... which are these */
    const struct kdtree *walls; /* of those that do, NULL: there are none */
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

/* May there be a wall: is the way from a to b steep, with a point of a wall over or under it? */
bool feature_steep(const struct feature_cloud *cloud, struct vec3 a, struct vec3 b);

/* A crease: `na` and `nb` are unit normals at the vertices.  Sheets that turn by less than 8
 * degrees are no crease. */
struct feature feature_crease(const struct feature_cloud *cloud, struct vec3 a, struct vec3 b,
                              struct vec3 na, struct vec3 nb);

/* A wall, along z or no more than 15 degrees from it, on which there are points. */
struct feature feature_wall(const struct feature_cloud *cloud, struct vec3 a, struct vec3 b);

#endif
