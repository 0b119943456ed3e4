/*
 * edge_cliff - a flank that ends above a wall of which the scan has no points: which points about
 * one of it are on the flank and which are down the wall (edge_cliff_find.c), the places between
 * that the flank and the wall may take (edge_cliff.c), and corners of the flank that stand out
 * between points below (edge_cliff_corner.c).
 *
 * The flank of a point is the surface of its own side, as far as one is known (struct edge_flank).
 * Lengths in mm; a place (u, v) is so far from the point, seen from above.  Lists may be empty; no
 * function fails.  No paper: the rules were found on scans of parts that are known exactly.  The
 * two doors, edge_cliff_add and edge_cliff_corner, are in edge_steps.h.
 */
#ifndef CLOUDMILL_EDGE_CLIFF_H
#define CLOUDMILL_EDGE_CLIFF_H

#include <stdbool.h>

#include "edge_steps.h"

/* Places on a flank stand on triangles (math/triangles.h), so far apart against those of the ball's
 * path, in no more rings about the point. */
#define EDGE_CLIFF_PITCH 0.65
enum { EDGE_CLIFF_RINGS = 3 * EDGE_RINGS };

#define EDGE_CLIFF_LEVEL 0.35 /* least z of the normal of a flank that has corners */

/* What is about a point of a flank, seen from above. */
struct edge_cliff {
    const struct edge_work *work;
    size_t i; /* the point, whose flank it is */
    const struct edge_flank *flank;
    struct vec3 from;    /* where it is */
    double reach;        /* so far the flank may go on */
    double corner;       /* between points below that are farther apart a corner may stand out */
    struct vec3s on;     /* points of the flank */
    struct vec3s under;  /* points below the flank */
    struct vec3s below;  /* those of them that are so steeply below that a wall is between */
    size_t feet;         /* of these, the first: the wall may stand on them */
    struct sizes beyond; /* points whose flanks meet this one in a known edge */
};

/* ---- edge_cliff_find: the points about one. */

/* Sorts them; all lists are empty where all are on the flank.  The caller frees them with
 * edge_cliff_free. */
struct edge_cliff edge_cliff_find(const struct edge_work *work, size_t i);
void edge_cliff_free(struct edge_cliff *cliff);

/* Counts as feet, and puts first, the points below on which a wall may stand: not those at which
 * the scan goes on as steeply as down to them.  Where the flank is not `certain`, or has few
 * points, nor those to which the scan goes down without a wall. */
void edge_cliff_keep_feet(struct edge_cliff *cliff, bool certain);

/* The flank is near enough to its points for a wall to hang from it, though not for a rim. */
bool edge_cliff_is_fair(const struct edge_flank *flank);

/* Where most about point i are certain: its flank is off its points by no more than a part of what
 * a place may be. */
bool edge_cliff_is_even(const struct edge_work *work, size_t i);

/* How far a point p is above a flank of the point `own`: no bend of it goes on far. */
double edge_cliff_above(const struct edge_flank *flank, struct vec3 own, struct vec3 p);

/* Point k of the scan is below the flank by more than its points are off it. */
bool edge_cliff_is_under(const struct edge_cliff *cliff, size_t k);

/* The place of the flank over (x, y): on a plane where by its bends it would be beyond reach. */
struct vec3 edge_cliff_place(const struct edge_cliff *cliff, double x, double y);

/* A place is as near to the point as a flank that is nearly upright may go on. */
bool edge_cliff_reaches(const struct edge_cliff *cliff, struct vec3 at);

/* The point below that is nearest to a place, seen from above; below.n must not be 0. */
struct vec3 edge_cliff_nearest_below(const struct edge_cliff *cliff, struct vec3 at);

/* ---- edge_cliff: the flank and the wall between. */

/* The wall may be beyond the place (u, v), and no other point of the flank is nearer to it. */
bool edge_cliff_is_before(const struct edge_cliff *cliff, double u, double v);

/* ---- edge_cliff_corner: corners of the flank. */

/* Appends tips of square corners that stand out between points below, with the walls under them:
 * all places where one may be. */
void edge_cliff_add_tips(const struct edge_cliff *cliff, struct vec3s *to);

#endif
