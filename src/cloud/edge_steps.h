/*
 * edge_steps - how the edges of a scan are found (cloud/edge_points.h), step by step: neighbours of
 * a point, the surface of its own side, where two of these meet, where one ends above a wall, and
 * places on them.  Lengths in mm; steps for point i touch nothing of other points but what earlier
 * steps have found.
 */
#ifndef CLOUDMILL_EDGE_STEPS_H
#define CLOUDMILL_EDGE_STEPS_H

#include <stdbool.h>
#include <stdlib.h>

#include "base/array.h"
#include "cloud/edge_points.h"
#include "math/point_grid.h"
#include "math/quadric.h"

/* Neighbours; those that a smooth surface goes through; those whose flanks may meet the point's;
 * the fewest that make a flank; points that bear out a place; rings of places about a point. */
enum {
    EDGE_NEAR = 40,
    EDGE_SMOOTH = 24,
    EDGE_MEETING = 16,
    EDGE_FEWEST = 6,
    EDGE_ABOUT = 8,
    EDGE_RINGS = 8
};

#define EDGE_REACH 2.8  /* spacings: so far beyond the points an edge may be */
#define EDGE_EVEN 0.012 /* spacings: a surface off its points by less is smooth */
#define EDGE_UNEVEN 1.4 /* noises: points about a surface are off it by less on average */
#define EDGE_SIGMAS 3.0
#define EDGE_UPRIGHT 0.004 /* least z of the normal of a flank */
#define EDGE_STEEP 2.5     /* 68 degrees: a wall hangs from a flank as from one so steep */
#define EDGE_FOOT 8        /* spacings: so high a wall stands on a fair flank, or any */
#define EDGE_SHARP 0.94    /* cosine of two flanks' normals: 20 degrees */

/* The surface of a point's own side. */
struct edge_flank {
    bool bent, rough; /* the neighbourhood is no one quadric; nor a cubic */
    bool valid;       /* it has a flank */
    bool confirmed;   /* by those of its neighbours */
    bool along;       /* it is of neighbours along a rib or wall */
    bool continued;   /* it is a neighbour's, that goes on to the point */
    double spacing, rms;
    double wide;      /* points that it goes through, by its terms; 0: it was not widened */
    struct quadric q; /* if valid, or of the neighbourhood; faces up */
};

/* What may be in front of a point that the scan does not tell of.  A spur is a point above a wall
 * that has only points steeply below wide about it, over three quarters of a turn: no rim that
 * points anywhere make. */
struct edge_unknown {
    double depth;      /* so far the part may go on, mm; 0: it does not, and nothing else is told */
    struct vec3 ahead; /* that way, unit; above a wall, which it leaves along the flank, one mm long
                          seen from above */
    bool spur;
    bool large; /* the points do not tell the shape of what it is on; above a wall, which is guarded
                   up to the points below, never */
};

struct edge_work {
    const struct edge_points_options *options;
    bool lines; /* the scan is on lines, far apart against the points on them */
    bool wide;  /* neighbours on many of them are looked at, or those on few */
    bool met;   /* as the options have it, unless walls are what the scan is of */
    struct edge_flank *flank, *chosen;
    struct vec3s *found;          /* places of edges, of each point */
    struct vec3s *between;        /* and of its flank */
    double *gap;                  /* so far its flank goes on to points below; 0: it does not */
    struct edge_unknown *unknown; /* in front of it */
};

/* ---- edge_hood: the neighbours of a point, itself the first; n < EDGE_NEAR: too few. */

struct edge_hood {
    size_t n;
    double spacing; /* of the points about, mm */
    uint32_t index[EDGE_NEAR];
    double distance2[EDGE_NEAR];
    struct vec3 point[EDGE_NEAR];
};

void edge_hood_find(const struct edge_work *work, size_t i, struct edge_hood *near);

/* How far the point is above the middle of the n nearest, mm. */
double edge_hood_out(const struct edge_hood *near, size_t n);

double edge_plan_distance(struct vec3 a, struct vec3 b);

/* The points about a place as seen from above, one after the other. */
struct edge_about {
    struct point_grid_walk walk;
    struct vec3 from;
    size_t i; /* is left out */
    double reach;
};

/* Those nearer than `reach` (mm, at most the width of a cell) to a place; all others within
 * EDGE_REACH of point i. */
struct edge_about edge_about_place(const struct point_grid *scan, struct vec3 from, double reach);
struct edge_about edge_about(const struct edge_work *work, size_t i);

/* Puts the next one into *k; false: there is none. */
bool edge_about_next(struct edge_about *about, size_t *k);

/* ---- edge_flank: the surfaces of all points' own sides. */

/* Fills work->flank of all points, by those chosen of their neighbours' (work->chosen becomes
 * it). */
void edge_flanks_find(struct edge_work *work);

/* work->chosen are the flanks, and what these were the room for the next choice. */
void edge_flanks_take_chosen(struct edge_work *work);

/* The normal of a flank below or above a place, and how far that is above the flank. */
double edge_flank_above(const struct edge_flank *flank, struct vec3 p, struct vec3 *normal);

/* A surface of its own is known of the point: a flank, or one of all its neighbours. */
bool edge_flank_known(const struct edge_flank *flank);

/* Its points are no further off it than a ball may sink, or noise is: continued as far as it goes
 * it is where they tell. */
bool edge_flank_certain(const struct edge_work *work, const struct edge_flank *flank);

/* Points of a surface may be off it by this; on average by this. */
double edge_within(const struct edge_work *work, double spacing);
double edge_even(const struct edge_work *work, double spacing);

/* ---- edge_wide: under noise the flanks that are certain through as many points about as a plane,
 * a quadric or a cubic explains: continued as far as an edge one through a dozen is off by more
 * than the noise. */

void edge_flanks_widen(struct edge_work *work);

/* ---- edge_along: the surface of a point i that no neighbourhood as wide as long tells: the top of
 * a narrow wall, level across where its points do not tell, or a quadric through neighbours along a
 * rib.  Its flank stays as it is where there is neither. */

void edge_along_find(const struct edge_work *work, size_t i);

/* ---- edge_meet: appends the places of edges between point i and neighbours after it, or the
 * points `across`, whose surfaces are known. */

void edge_meet_add(const struct edge_work *work, const struct edge_hood *near, size_t i,
                   struct vec3s *to);
void edge_meet_across(const struct edge_work *work, size_t i, const struct sizes *across,
                      struct vec3s *to);

/* ---- edge_cliff: a flank that ends above a wall without points (its steps: edge_cliff.h). */

/* Appends places on the flank of point i, continued to the points so steeply below that a wall must
 * be between, and on that wall; returns how far these points are, mm seen from above; 0: there are
 * none.  To `edge`: places of edges with surfaces that begin farther down than the nearest points
 * of its own neighbourhood. */
double edge_cliff_add(const struct edge_work *work, size_t i, struct vec3s *edge, struct vec3s *to);

/* How far the flank may go on before point i, above such a wall, mm seen from above, where that is
 * a sharp corner: a tip of it passes between points below; 0: it is none.  *ahead: that way, along
 * the flank, one mm long seen from above. */
double edge_cliff_corner(const struct edge_work *work, size_t i, struct vec3 *ahead);

/* ---- edge_slope: the points close about a foot, seen from above, were scanned at all heights from
 * it up to `top`, no two of them 0.3 spacings apart.  Or, where less is known, those farther about,
 * no two of them a whole spacing apart; and where they are, others of them, as low, lie before it,
 * or those above it do not lie aside: no unseen wall stands on the foot. */

bool edge_slope_climbs(const struct point_grid *scan, struct vec3 foot, double top);
bool edge_slope_seen(const struct point_grid *scan, struct vec3 foot, double top);

/* Away from the rim the scan goes down from the foot as steeply as it does to it: both are of one
 * slope, and no wall hangs from the rim. */
bool edge_slope_goes_on(const struct point_grid *scan, struct vec3 foot, struct vec3 rim);

/* ---- edge_foot: appends places on the wall that may stand over point i: a gap of heights over it,
 * steeper than any slope that was scanned, whatever is known of the surfaces of its rim and
 * foot. */

void edge_foot_add(const struct edge_work *work, size_t i, struct vec3s *to);

/* Appends places from one straight down as far as a point below. */
void edge_wall_add(const struct edge_work *work, struct vec3 at, struct vec3 foot,
                   struct vec3s *to);

/* ---- edge_crest: appends the places of crests (crest_fit.h) about points whose own sides are not
 * certain to work->found, and of both their sides to work->between, as dense as those of edges are:
 * each about the nearest point that has one. */

void edge_crests_add(const struct edge_work *work);

/* ---- edge_unknown: edges that the scan does not resolve. */

/* How far the part may go on in front of point i, where it is on a sharp edge or tip and no guard
 * was found there, or stands out on something that the points do not resolve, though no surface is
 * known of it, but of most about it, or is a corner or spur above a wall.  By all flanks, and the
 * gap of point i. */
struct edge_unknown edge_unknown_find(const struct edge_work *work, size_t i);

/* Both of these are by work->unknown of all points.  A point counts where there is one more such
 * point near, for a single one may be astray, or where it is above a wall.
 *
 * Appends places from so far in front of point i down to its neighbours, and to those of which the
 * same is told the ways between both, if it counts. */
void edge_unknown_add(const struct edge_work *work, size_t i, struct vec3s *to);

/* Adds point i, if it counts, to what *gaps says of such points; to the features where none near it
 * goes on farther. */
void edge_unknown_sum(const struct edge_work *work, size_t i, struct edge_gaps *gaps);

/* The surface of a third of the points about is known: the scan is even, but for an edge. */
bool edge_on_known(const struct edge_work *work, size_t i);

/* ---- edge_fill: appends places on the flank of point i, up to its edges (work->found) and into
 * sharp hollows, as dense as those of edges are on these. */

void edge_fill_add(const struct edge_work *work, const struct edge_hood *near, size_t i,
                   struct vec3s *to);

#endif
