/*
 * gouge - keeping ball, shank and holder of a tool clear of a part.  This is the main header of the
 * folder; it says what the stages are, and holds the check that all of them ask.
 *
 * In come a part, as a scan or a mesh, and runs of contact points with their normals (run.h).  Out
 * come the same runs with ball and axis where the tool is clear, points put between where straight
 * lines would not be, and a report of what the ball can't reach.  The stages:
 *
 *   guard points   the part as points that are dense against the ball: guard_points.h of a scan,
 *                  guard_mesh.h of a mesh
 *   check          how deep is the ball, or the holder, in the guard points?  Here.
 *   raise          each centre lifted along its normal as far as it takes: gouge_lift.h
 *   smooth         axes turned as evenly as their limits allow: axis_smooth.h
 *   access         from which directions flute, shank and holder (holder.h) are clear: access.h
 *   plan           the axis of each point chosen over the run as a whole: axis_plan.h
 *   link           from strip to strip, low or over the clearance plane: link.h
 *   refit          motions fitted to the points checked again, and their points lifted more where
 *                  they go too deep: gouge_refit.h; what is next to the way is kept at hand
 *                  meanwhile: gouge_track.h
 *
 * The part is a set of guard points.  A ball with its centre at c is clear when no guard point is
 * nearer to c than the radius; the depth of a gouge is the radius less the distance of the nearest
 * guard point.  Between guard points that are a gap g apart the ball sinks by up to g^2 / (6 R) (a
 * triangle of points; g^2 / (8 R) between two) into what they stand for, less what a hollow curves
 * away.
 */
#ifndef CLOUDMILL_GOUGE_H
#define CLOUDMILL_GOUGE_H

#include <stdbool.h>

#include "gouge/holder.h"
#include "math/box.h"
#include "math/kdtree.h"
#include "math/vec.h"

struct gouge_check;

/* Of the tolerance: what a path of ours lets the ball go deep.  The rest is for the control's
 * straight pieces (--chord of ncpost, 0.002 mm), which lie on the part's side of a hump. */
#define GOUGE_SAFE 0.75

/* Of these guard points, which are freed as soon as they are in it; by several threads (as in
 * parallel.h). */
struct gouge_check *gouge_new(struct vec3s points, int threads);

/* Of a copy of n points. */
struct gouge_check *gouge_from_points(const struct vec3 *point, size_t n);

void gouge_free(struct gouge_check *guard);

/* The highest z among the guard points, mm. */
double gouge_top(const struct gouge_check *guard);

/* How far from c the box around the guard points reaches in a direction (a unit vector), mm. */
double gouge_extent(const struct gouge_check *guard, struct vec3 c, struct vec3 direction);

/* Distance from p to the nearest guard point, mm; `within` when none is nearer than that. */
double gouge_distance(const struct gouge_check *guard, struct vec3 p, double within);

/* The same, and that point in *nearest, which stays as it was where there is none. */
double gouge_nearest(const struct gouge_check *guard, struct vec3 p, double within,
                     struct vec3 *nearest);

/* How deep a ball of this radius, its centre at c, is in the part, mm; negative: clear by so
 * much. */
double gouge_depth(const struct gouge_check *guard, struct vec3 c, double radius);

/* The same for a ball whose centre moves straight from a to b: the largest depth on the segment, 0
 * if it is clear everywhere. */
double gouge_depth_along(const struct gouge_check *guard, struct vec3 a, struct vec3 b,
                         double radius);

/* Appends all guard points no farther than `within` from that segment. */
void gouge_points_beside(const struct gouge_check *guard, struct vec3 a, struct vec3 b,
                         double within, struct vec3s *points);

/* True if the ball goes no deeper than `depth` on that segment.  Quicker than to ask how deep. */
bool gouge_clear_along(const struct gouge_check *guard, struct vec3 a, struct vec3 b, double radius,
                       double depth);

/*
 * The smallest lift h in [0, limit] that brings the ball with its centre at c + h * up (a unit
 * vector) clear of the part (up to 1e-6 mm), or -1 when no lift within the limit does.  `touch` as
 * of kdtree_leave.
 */
double gouge_least_lift(const struct gouge_check *guard, struct vec3 c, struct vec3 up,
                        double radius, double limit, struct kdtree_touch *touch);

/*
 * The smallest lift h >= 0 from which on the ball stays clear all the way along `up`, out of reach
 * of every guard point: where a tool that comes from there ends.  A scan is a shell, and
 * gouge_least_lift may find room under it; this does not.
 */
double gouge_rise(const struct gouge_check *guard, struct vec3 c, struct vec3 up, double radius);

/* True if a ball that is clear at c stays clear when it moves straight up. */
bool gouge_free_above(const struct gouge_check *guard, struct vec3 c, double radius);

/* True if the ball can come to c from outside, against `up`, and goes no deeper than `depth` into
 * the part on the way. */
bool gouge_open(const struct gouge_check *guard, struct vec3 c, struct vec3 up, double radius,
                double depth);

/* Of each way of gouge_open_anyhow a guard point that was in it, for it is likely in that of the
 * next place, too. */
enum { GOUGE_WAYS = 32 };
struct gouge_ways {
    struct kdtree_touch normal, half, touch[GOUGE_WAYS];
};

/* The same along any of some ways: up, `normal` (where the ball touches) and the middle of both,
 * and GOUGE_WAYS more, over the upper half of the sphere, on the normal's side.  `ways`: of the
 * same guard, all 0 for the first place (NULL: not kept). */
bool gouge_open_anyhow(const struct gouge_check *guard, struct vec3 c, struct vec3 normal,
                       double radius, double depth, struct gouge_ways *ways);

/* How far shank and holder above a ball at c are from the nearest guard point, mm: negative by how
 * deep it is in them; `below` where none is as near. */
double gouge_holder(const struct gouge_check *guard, const struct holder *holder, struct vec3 c,
                    struct vec3 axis, double below);

/* True if they are no nearer than `least`.  Quicker than to ask how near.  `touch` as of
 * kdtree_any_lower. */
bool gouge_holder_clear(const struct gouge_check *guard, const struct holder *holder, struct vec3 c,
                        struct vec3 axis, double least, struct kdtree_touch *touch);

/* The same on the way of the ball's centre straight from a to b while the axis stays as it is;
 * between places GOUGE_STEP mm apart a point may go by. */
#define GOUGE_STEP 0.02
bool gouge_holder_clear_along(const struct gouge_check *guard, const struct holder *holder,
                              struct vec3 a, struct vec3 b, struct vec3 axis, double least,
                              struct kdtree_touch *touch);

/* Marks in kept[], by their numbers of which there are gouge_points, so many of the guard points
 * that each of the others has one of them within `gap` mm; returns how many, and the box around
 * them. */
size_t gouge_thinned(const struct gouge_check *guard, double gap, bool *kept, struct box *around);
size_t gouge_points(const struct gouge_check *guard);

/* Shows the guard points as kdtree_visit does. */
void gouge_visit(const struct gouge_check *guard, struct vec3 from,
                 const struct kdtree_visitor *visitor);

#endif
