/*
 * scallop - where parallel planes go: at equal distances, or as far apart as a scallop height
 * allows.
 */
#ifndef CLOUDMILL_SCALLOP_H
#define CLOUDMILL_SCALLOP_H

#include "base/array.h"
#include "mesh/mesh.h"

/*
 * Distance between two contact points of a ball of radius `radius` that leave a cusp of height h
 * between them, mm, for the surface's curvature across the passes (1/mm, convex positive).  Exact
 * on a circle; sqrt(8 h R / (1 + R k)) to the first order in h, and never more than that.  Where
 * the ball does not fit (1 + R k near 0 or below) it is that of 1 + R k = LEAST.  Cusps that the
 * surface leaves lower, as round a hollow, allow its diameter; those above the ball's centre are
 * taken as up to it.  Always above 0.
 */
double scallop_step(double h, double radius, double curvature);

/*
 * Heights of planes from `low` to just below `high`, at equal distances of at most `step`; the last
 * one is a little inside (INSIDE of the step).
 */
void scallop_equal(double low, double high, double step, struct doubles *height);

/* What came of it. */
struct scallop_report {
    double narrowest, widest; /* distance of planes, mm */
    size_t steep;             /* facets within STEEP of the planes: the height is not kept there */
    struct vec3 steep_at;     /* the middle of the first of them */
};

struct scallop_options {
    struct vec3 normal; /* of the planes, unit */
    double h, radius;   /* height of the cusps, and of the ball, mm */
    double steepest; /* sine: facets nearer to the planes than that count as so steep (0: STEEP) */
    double beyond;   /* part of the area between two planes where cusps may be higher, for what is
                      left is cut otherwise; 0: nowhere */
};

/*
 * Heights of planes from `low` to just below `high`, each as far from the one
 * before as the cusps between stay below h on every facet between the two, or all but a share of
 * their area.  The distance follows
 * from the curvature across the passes, which is that of the normals over a vertex's facets (S.
 * Rusinkiewicz, Estimating curvatures and their derivatives on triangle meshes, 2004), and from how
 * steep the facet is towards the planes; facets across a sharp edge do not count.  Facets nearer to
 * the planes than STEEP would need planes without end: they count as that steep.
 */
struct scallop_report scallop_heights(const struct mesh *mesh,
                                      const struct scallop_options *options, double low,
                                      double high, struct doubles *height);

#endif
