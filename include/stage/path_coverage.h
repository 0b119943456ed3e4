/*
 * path_coverage - what a path leaves of the scan or mesh it was made for: measured on the whole
 * path, cut in rest passes, and told (toolpath/coverage.h, toolpath/rest_passes.h).
 */
#ifndef CLOUDMILL_PATH_COVERAGE_H
#define CLOUDMILL_PATH_COVERAGE_H

#include "mesh/mesh.h"
#include "stage/toolpath.h"
#include "toolpath/coverage.h"

struct path_coverage {
    struct coverage *coverage; /* NULL: nothing is measured */
    struct coverage *judged;   /* of noisy points where who judges has them, NULL: the same */
    struct coverage_options options;
    struct kdtree *vertex;
    struct gouge_check *bare; /* the points of the scan and none between them: what is in the way of
                                 a ball that could cut more (NULL: the guard is) */
    double scallop;           /* of the rows, mm; 0: none was asked for, nothing left is a fault */
    bool scan;                /* the points are a scan */
    struct vec3s facets; /* points on the facets of meshes that guard, so many as are measured */
    const struct mesh *part; /* points on a mesh are of a part of this; NULL: of all */
    double spacing;          /* of points on a mesh, mm */
    const struct toolpath_options *rule;
    double tolerance;      /* of the path, mm */
    double rows;           /* what rows may leave, with what the mesh is off the scan, mm ... */
    double allowed;        /* ... and what the path may */
    size_t rounds, strips; /* of rest passes */
    bool nothing;          /* the ball comes near no point */
};

/* Of the points of the scan that guards, or of the facets of meshes that do, of a box or polygons
 * those inside, or where none guards of points on `region`, the mesh or a part of it.  Mesh and
 * path must outlive it; when the rules of the path are known and path_options has the scan. */
struct path_coverage path_coverage_new(const struct mesh *mesh, const struct mesh *region,
                                       const struct toolpath *t);

/* Measures what has been cut, and has what is left cut in passes across those of planes of this
 * normal (zero: in none), in ROUNDS rounds at most, as long as they take something off. */
void path_coverage_rest(struct path_coverage *c, struct vec3 planes, struct toolpath *t);

/* Measures the path as it is in the end. */
void path_coverage_measure(struct path_coverage *c, const struct toolpath *t);

/* Tells what is out of reach, what the surface between points keeps the ball off, and what is left.
 * EXIT_UNMET where the last, and what of the others who judges by the points takes for it
 * (coverage_judge.h), are more than path_options.left_share of the points, or of a part of the mesh
 * any is more than the next stage may leave, and rows of a scallop should have cut them, or where
 * the ball comes near no point at all: they are head->unmet then.  What only a fitter's tolerance
 * makes up for is head->unfitted. */
int path_coverage_conclude(const struct path_coverage *c, struct path_head *head);

void path_coverage_free(struct path_coverage *c);

#endif
