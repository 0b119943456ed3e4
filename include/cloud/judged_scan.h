/*
 * judged_scan - what a scan is to who judges a program by its points: where these would be without
 * their noise, which of them lie under a roof, and what is in a tool's way beside them.  Who makes
 * a path and who reads a program back take it from here, so that they judge by the same.
 */
#ifndef CLOUDMILL_JUDGED_SCAN_H
#define CLOUDMILL_JUDGED_SCAN_H

#include "base/array.h"
#include "math/point_grid.h"

/*
 * Moves the points of a scan without outliers to where they would be without noise (settle.h; mm,
 * one standard deviation, 0: they stay).  under[i], of as many: 1 of each under a roof, out of
 * reach from above (outliers.h).  To *curtain is added what hangs under its rims, goes on beyond
 * them, and its steep flanks (roof.h, rim_points.h, steep_facets.h).  `radius`: of the ball, mm.
 */
void judged_scan_settle(struct point_grid *scan, double radius, double noise, int threads,
                        unsigned char *under, struct vec3s *curtain);

/* So many times as many points may be left, with those that only such places keep a ball off, as
 * without. */
#define JUDGED_SCAN_UNSEEN 2

/*
 * Appends places where the part may go on, unseen, between the points of a scan (scan_edges.h), as
 * who makes a path for a ball of that radius is kept off them.  `scan`: as it was scanned, without
 * outliers; noise as above.
 */
void judged_scan_unseen(const struct point_grid *scan, double radius, double noise, int threads,
                        struct vec3s *place);

#endif
