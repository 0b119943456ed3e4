/*
 * step_source - what the readers of a STEP file's curves and surfaces share.
 */
#ifndef CLOUDMILL_STEP_SOURCE_H
#define CLOUDMILL_STEP_SOURCE_H

#include "nurbs/approximate.h"
#include "nurbs/primitive.h"
#include "step_geometry.h"

enum { STEP_DEPTH_MAX = 20 }; /* curves of curves */

/* mm: points so near are one. */
#define STEP_NEAR 1e-6

/* What a reader of one kind of curve or surface works on. */
struct step_source {
    const struct step_place *place;
    const struct step_values *v;
    const struct step_value *record; /* of the kind: step_own() has its attributes */
    const struct vec3 *ends;
    const struct vec3s *points;
    struct patch_loop *loop;
    struct nurbs *surface;
    double *rough; /* of the surface, as in struct patch */
    int depth;
};

/* The attributes of a spline, whether it is one record or several. */
struct step_spline {
    const struct step_value *poles, *weights;
    const struct step_value *degree[2], *multiplicity[2], *knots[2];
    bool uniform, bezier;
};

/* An error that names the instance. */
int step_refuse(const struct step *step, const struct step_values *v, const char *what,
                struct error *error);

/* A number, which may be wrapped: LENGTH_MEASURE(5.); not above `most`. */
int step_number(const struct step *step, const struct step_values *v,
                const struct step_value *value, double most, double *number, struct error *error);

/* .T. or .F. */
int step_flag(const struct step *step, const struct step_values *v, const struct step_value *value,
              bool *flag, struct error *error);

struct vec3 step_axis(const struct transform *t, int k);

/* A placement in mm and placed: axes are perpendicular unit vectors. */
int step_placed_axes(const struct step_source *s, const struct step_value *reference,
                     struct transform *axes, struct error *error);

/* A CARTESIAN_POINT in mm and placed. */
int step_point(const struct step_source *s, const struct step_value *reference, struct vec3 *point,
               struct error *error);

/* The unit direction of a VECTOR, placed, and its length in mm (or NULL). */
int step_direction(const struct step_source *s, const struct step_value *reference, struct vec3 *to,
                   double *length, struct error *error);

/* The unit vector of a DIRECTION, placed. */
int step_axis_direction(const struct step_source *s, const struct step_value *reference,
                        struct vec3 *to, struct error *error);

/* A function of the parameter of a curve, which has kinks where that curve has them, as a spline;
 * `rough` is raised to how far that is off. */
struct nurbs_curve step_approximate(const struct nurbs_axis *axis, approximate_curve_fn *f,
                                    const void *context, double tolerance, double *rough);

/* Appends the part of a curve between its ends: one piece, or two where it goes on over its seam;
 * takes the curve. */
void step_push_part(const struct step_source *s, struct nurbs_curve c);

/* A PCURVE, to s->loop: 0, 1 when it is not read, or -1. */
int step_pcurve(const struct step_source *s, struct error *error);

/* False when it is no spline; `surface`: two degrees, two lists of knots. */
bool step_find_spline(const struct step_values *v, bool surface, struct step_spline *s);

int step_spline_curve(const struct step_source *s, const struct step_spline *sp,
                      struct nurbs_curve *c, struct error *error);

/* To s->surface. */
int step_spline_surface(const struct step_source *s, const struct step_spline *sp,
                        struct error *error);

/* A curve, as step_curve, within other curves. */
int step_curve_of(const struct step_place *place, const struct step_values *from,
                  const struct step_value *reference, const struct vec3 *ends, int depth,
                  struct patch_loop *loop, struct error *error);

/* PLANE and the surfaces about an axis: 0, 1 when it is none of them, or -1. */
int step_primitive(const struct step_source *s, struct primitive *p, struct error *error);

/* A surface by the parameters that the standard gives it. */
struct step_parametric {
    bool is_primitive;
    struct primitive primitive;
    struct nurbs spline;
    double u, v;  /* from the file's parameters to radians and mm */
    double rough; /* as in struct patch */
};

/* 0, 1 when its parameters are not understood, or -1.  The caller frees ->spline. */
int step_parametric(const struct step_place *place, const struct step_values *from,
                    const struct step_value *reference, struct step_parametric *to,
                    struct error *error);

struct vec3 step_parametric_point(const struct step_parametric *s, double u, double v);

#endif
