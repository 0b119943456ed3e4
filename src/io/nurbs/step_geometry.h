/*
 * step_geometry - curves and surfaces of a STEP file (ISO 10303-42) as NURBS, in mm and placed.
 */
#ifndef CLOUDMILL_STEP_GEOMETRY_H
#define CLOUDMILL_STEP_GEOMETRY_H

#include "math/transform.h"
#include "nurbs/patch.h"
#include "step.h"

/* Where numbers of the file are brought to. */
struct step_place {
    const struct step *step;
    struct transform to; /* from the file's lengths to mm, and to the place of the part */
    double mm;           /* its scale */
    double angle;        /* radians in the file's unit of angles */
};

/* The instance that an attribute refers to; an error names the instance that refers. */
int step_follow(const struct step *step, const struct step_values *from,
                const struct step_value *reference, struct step_values *to, struct error *error);

/* The place of an AXIS2_PLACEMENT_3D in the file's own lengths. */
int step_axes(const struct step *step, const struct step_values *from,
              const struct step_value *reference, struct transform *axes, struct error *error);

/* The point of a VERTEX_POINT or a CARTESIAN_POINT. */
int step_vertex(const struct step_place *place, const struct step_values *from,
                const struct step_value *reference, struct vec3 *point, struct error *error);

/*
 * Appends a curve to the loop: from its point at ends[0] on, in its own direction, to ends[1] (once
 * round where they are the same), or the whole of it where ends is NULL.  0, 1 when it is of a kind
 * that is not read, or has no ends, or -1.
 */
int step_curve(const struct step_place *place, const struct step_values *from,
               const struct step_value *reference, const struct vec3 *ends, struct patch_loop *loop,
               struct error *error);

/*
 * The surface, with the normal that the standard gives it; one without ends reaches as far as these
 * points; `rough` as in struct patch.  0, 1 when it is of a kind that is not read (its name then
 * goes to `kind`), or -1.
 */
int step_surface(const struct step_place *place, const struct step_values *from,
                 const struct step_value *reference, const struct vec3s *points,
                 struct nurbs *surface, double *rough, char kind[40], struct error *error);

/* The four sides of a RECTANGULAR_TRIMMED_SURFACE as a loop in space: 0, 1 when the parameters of
 * its basis are not understood, or -1. */
int step_rectangle(const struct step_place *place, const struct step_values *v,
                   struct patch_loop *loop, struct error *error);

#endif
