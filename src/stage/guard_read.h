/*
 * guard_read - the scan that the ball is kept clear of: read, placed as the mesh is, and made into
 * a gouge check.
 */
#ifndef CLOUDMILL_GUARD_READ_H
#define CLOUDMILL_GUARD_READ_H

#include "base/cli.h"
#include "gouge/gouge.h"
#include "mesh/mesh.h"

/* What is made of the points: guard_points.h. */
struct guard_read_options {
    double radius;    /* of the ball, mm */
    double tolerance; /* of the path, mm: the ball sinks between points by a fifth of it at most */
    double
        noise; /* of the scan, mm; negative: as found where it is above a tenth of the tolerance */
    double effort; /* effort.h */
    int threads;
    struct vec3s certain, doubtful; /* what becomes of it: its points (guard_points.h) */
};

/*
 * The gouge check of the points of all files and of the mesh's sharp edges, in the mesh's mm:
 * placed as the mesh was, if its stream says that it was placed (turned, shifted, or from other
 * units), else as they are.  NULL if a file can't be read or has no points, or if the mesh is
 * clearly elsewhere: more than half of its vertices further than `near` mm from every point of the
 * scan.  rule->noise becomes what was taken out.
 */
struct gouge_check *guard_read(const struct cli_list *files, const struct mesh *mesh, double near,
                               struct guard_read_options *rule, struct error *error);

/* The same for the points of a path, with the scan as it is. */
struct gouge_check *guard_read_points(const struct cli_list *files, const struct vec3s *place,
                                      double near, struct guard_read_options *rule,
                                      struct error *error);

#endif
