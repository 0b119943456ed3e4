/*
 * coverage - what a ball on its whole way leaves of a scan: each point is cut, left or out of
 * reach.
 *
 * A point is cut where the ball on the straight lines between the centres of the path comes within
 * the radius and a limit of it.  Of the others those are left that a ball comes near to (`near`)
 * that is clear of the part, and on some axis the rest of its tool too; the rest is out of
 * reach.  A scan is points: a ball may be clear of them that is not clear of the surface between.
 * What that alone keeps the ball off is told apart.
 *
 * A ball that touches p has its centre at p + R d, d a unit vector, and is clear of a guard point q
 * where |p + R d - q| >= R, that is d . v <= v . v / 2R with v = q - p: half-spaces that all hold
 * d = 0.  From the normal of the points about p, d is put on the one that it breaks most, again and
 * again (Kaczmarz), and back to length 1.  Where no d serves, the ball that is the least in is
 * moved out along its d: so near it comes.
 */
#ifndef CLOUDMILL_COVERAGE_H
#define CLOUDMILL_COVERAGE_H

#include "gouge/gouge.h"

struct coverage;

struct coverage_options {
    const struct gouge_check *guard;   /* NULL: everything can be reached */
    const struct gouge_check *assumed; /* what the path keeps clear of: the same, and the surface
                                          assumed between; NULL: the same */
    const struct holder *holder;       /* what is above the ball; no parts: the ball alone comes */
    bool upright;                      /* only on this axis: */
    struct vec3 axis;                  /* unit */
    struct vec3s axes;                 /* only on these, unit, with a holder; none: on any */
    double radius;                     /* of the ball, mm */
    double limit;                      /* what may stay on a point that is cut, mm */
    double near;                       /* so near comes a ball that could cut a point, mm */
    double tolerance;                  /* how deep a ball that touches may be in, mm */
    const struct kdtree *vertex;       /* of a mesh of the points: ... */
    const struct vec3 *normal;         /* ... its normals, which tell the upper side */
    int threads;                       /* as of parallel_for */
};

/* KEPT: a ball that is clear of the guard touches it, but none that is clear of what is assumed. */
enum coverage_state { COVERAGE_CUT, COVERAGE_LEFT, COVERAGE_KEPT, COVERAGE_OUT };

struct coverage_point {
    struct vec3 p;
    enum coverage_state state;
    double height;      /* what stays on it, mm; of a point that is cut nothing is known */
    struct vec3 normal; /* LEFT: from it to the centre of the ball that comes nearest */
};

/* What stays on points of one state. */
struct coverage_share {
    size_t n;
    double area;    /* about, by the distance of the points, mm2 */
    double highest; /* mm */
    struct vec3 at;
};

/* What stays, over all points. */
struct coverage_report {
    size_t points;
    struct coverage_share left, kept, out;
};

/* Of n points, all left so far. */
struct coverage *coverage_new(const struct vec3 *point, size_t n, int threads);
void coverage_free(struct coverage *coverage);

/* Takes out what is cut by a path that has become longer since the last call: its centres, in
 * pieces that end where `end` (as in struct lifted_strip) says.  Tells of the rest what is out of
 * reach. */
void coverage_cut(struct coverage *coverage, const struct coverage_options *options,
                  const struct vec3s *centre, const struct sizes *end);

/* Forgets what has been cut, for another path over the same points; what can be reached is kept. */
void coverage_restart(struct coverage *coverage);

const struct coverage_point *coverage_points(const struct coverage *coverage, size_t *n);
struct coverage_report coverage_report(const struct coverage *coverage);

#endif
