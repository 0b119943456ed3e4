/*
 * roof - the parts of a scan that face up with nothing of it below, and what hangs below their
 * rims.
 *
 * A scan is a shell: beside its border, or in a hole that is narrower than the tool, there is room
 * under it that no point stands for, and all of that is material.  A point of the roof is one of
 * several near to it, seen from above, none of which is much higher or lower: there the scan is one
 * sheet that is not steep.  An overhang whose lower side was scanned too is no roof, nor is that
 * side, nor a place beside a wall.  A sheet that faces down with nothing above it looks the same as
 * one that faces up, and is taken for one.
 *
 * The rim of the roof is where it ends to some side.  A curtain of points that hang down from there
 * keeps a ball out that comes from outside, and who asks whether a tool can get to a place under
 * the roof finds no way.  Inside of the rim points hang down where roof beside a point is far below
 * it, as far as the lowest of that: a point that stands alone is no more to a ball beside it than a
 * point.  At the bottom is a floor: a tool that passes below the rim would come up within, with its
 * end in the material.  All stand in material, so they take no place from a tool that is above.
 */
#ifndef CLOUDMILL_ROOF_H
#define CLOUDMILL_ROOF_H

#include "math/point_grid.h"

/* Usual reaches of roof_find, in spacings: for who keeps a tool off, and for who judges another's
 * path, to whom some of that is roof, and nothing else: the same points make a sheet for both. */
#define ROOF_GUARD 1.5
#define ROOF_JUDGE 2.5

/* Marks (1) the points of the roof, by several threads (as of parallel_for): of all points nearer,
 * seen from above, than `reach` (at most 3) mean spacings none is steeply above or below, and three
 * that are not are nearer than ROOF_JUDGE.  Returns how many. */
size_t roof_find(const struct point_grid *point_grid, double reach, int threads,
                 unsigned char *roof);

/* Appends points below the rim of what is marked, down to `bottom`, about `gap` mm apart, and below
 * others of it, down to the lowest of it about them, where that is lower by more than `gap`; and at
 * the bottom, wherever roof is above it, no nearer than `gap` and two spacings to one another. */
void roof_curtain(const struct point_grid *point_grid, const unsigned char *roof, double gap,
                  double bottom, int threads, struct vec3s *to);

/* The same down to the lowest point, for who asks what a tool could reach: below the roof as those
 * find it who keep a tool off, two spacings apart and more. */
void roof_curtain_asked(const struct point_grid *point_grid, int threads, struct vec3s *to);

#endif
