/*
 * verify_part - the part that a program is judged against, as points.
 */
#ifndef CLOUDMILL_VERIFY_PART_H
#define CLOUDMILL_VERIFY_PART_H

#include "base/error.h"
#include "math/vec.h"

/*
 * Appends the points of a file, times `unit`.  A mesh (a PLY with faces, STL, OFF by its name) or
 * the surfaces of a .igs, .iges or .nurbs file, trimmed and within 0.001 mm, give points on their
 * faces too, so dense that a ball of `radius` rolled over them sinks in between by less than
 * 0.0005 mm, as long as that are no more than some millions; *spacing is what was kept, 0 for a
 * cloud.
 */
int verify_part_read(const char *file, double unit, double radius, struct vec3s *points,
                     double *spacing, struct error *error);

#endif
