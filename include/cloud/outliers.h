/*
 * outliers - points of a scan that are not on its surface: points twice, outliers, points under a
 * roof.
 *
 * Each function marks points of `point_grid` in out[] (as many bytes as points) with OUTLIERS_OUT,
 * beside what is marked already, and returns how many it marked; point_grid_remove takes them out.
 */
#ifndef CLOUDMILL_OUTLIERS_H
#define CLOUDMILL_OUTLIERS_H

#include "math/point_grid.h"

/* Marks: nothing bears the point out; or so, but it lies no higher than what is about it, so that a
 * tool that touches it goes deeper than what else is there: no mesh goes through it, but who guards
 * a scan or judges by it believes it, which costs nothing where no tool comes. */
enum { OUTLIERS_OUT = 1, OUTLIERS_BENEATH };

/* Neighbours that a quadric goes through; points of the largest clump that may be an outlier;
 * points of the smallest feature that is none; points in a row that are none. */
enum { OUTLIERS_NEAR = 24, OUTLIERS_CLUMP = 8, OUTLIERS_FEATURE = 2, OUTLIERS_ROW = 4 };

/* So many times as far from its neighbours as these are from theirs, a point is isolated; so many
 * mean spacings from them it is, too, as no facet reaches so far. */
#define OUTLIERS_ISOLATED 3.0
#define OUTLIERS_FAR 12.0

/* A point is an outlier off a surface by more than so many sigma, so many times what the neighbours
 * are off it, and such a part of their spacing: below it, and over it, where a real one that is
 * left out would be cut, and one that is none only keeps the ball off by as little. */
#define OUTLIERS_SIGMAS 6.0
#define OUTLIERS_SPREADS 8.0
#define OUTLIERS_BELOW 0.1
#define OUTLIERS_OVER 0.5

/* So near to a point, in spacings, another one over the surface tells that it is no outlier. */
#define OUTLIERS_BESIDE 1.5

/* A roof is so many times as high above a point as it is away, at least. */
#define OUTLIERS_ROOF 4.0

/* Points equal in x, y and z to one that is kept. */
size_t outliers_twice(const struct point_grid *point_grid, unsigned char *out);

/*
 * Outliers, `sigma` being the noise of the scan (mm, noise.h), each marked OUTLIERS_BENEATH where
 * it is under the quadric, or where, seen from above, two points and more within two and a half
 * spacings are higher, and more than three times as many as are lower; else OUTLIERS_OUT: points
 * that
 *   - are isolated: the nearest neighbour number OUTLIERS_CLUMP is more than OUTLIERS_ISOLATED
 *     times as far as that of the points next to them (after the local outlier factor: Breunig,
 *     Kriegel, Ng, Sander 2000), except a sparse surface beside a dense one, as a wall's: more than
 *     OUTLIERS_CLUMP of the OUTLIERS_NEAR are as far; or more than OUTLIERS_FAR spacings away, or
 *   - are off a quadric through their OUTLIERS_NEAR nearest neighbours, fitted by Tukey's biweight,
 *     by more than OUTLIERS_SIGMAS, OUTLIERS_SPREADS, and OUTLIERS_BELOW or OUTLIERS_OVER allow;
 *     over the surface, only where none beside them is over it by a quarter as much, half of what
 *     these allow (the top of a spike or a cone).
 * But no outlier is a point that lies on a surface that others make (edge_flank_holds: one side of
 * a thin edge; or one quadric takes in all its neighbours and the point, as of a wall that was seen
 * at a few places), nor one of OUTLIERS_FEATURE that follow each other, each within one and a half
 * spacings of the next, from less than two and a half over the surface on (a needle, a thin plate),
 * nor one of OUTLIERS_ROW and more in a straight row, 1.2 to 3 spacings apart, to 0.4 of that (a
 * rib that each scan line saw once), nor one of as many that stand as high over what is about them,
 * to a fifth, within six spacings and not all within three (a rib whose points are anywhere), nor
 * one of a step or a cliff: two points and more within two and a half spacings, seen from above,
 * are over it, two and more under it, and these go up a cliff or are about as little on one smooth
 * surface as it is; nor one below a rim: two points and more within that are over it, and in three
 * eighths of the turn there are none, so that the surface ends and its wall, undercut by up to half
 * a spacing, was seen at a few places only.  So a clump of up to OUTLIERS_CLUMP points floating
 * farther off is found, an edge or a wall is none.
 * Only points that are off a quadric over a block of two by two cells and off a robust one over
 * their cell and the eight around it, or have no other point of their cell near them, are tested.
 */
size_t outliers_isolated(const struct point_grid *point_grid, double sigma, int threads,
                         unsigned char *out);

/* Of these only the first kind, isolated: where the points of a rough part, or one with much
 * detail, are off any quadric, nothing is told by that. */
size_t outliers_floating(const struct point_grid *point_grid, double sigma, int threads,
                         unsigned char *out);

/* Points that a tool from above cannot reach: within the cells about them, in every eighth of the
 * turn, there are points above them, OUTLIERS_ROOF times as high as they are away. */
size_t outliers_under_roof(const struct point_grid *point_grid, int threads, unsigned char *out);

#endif
