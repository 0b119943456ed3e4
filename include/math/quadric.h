/*
 * quadric - a surface of the second degree through a neighbourhood of points.
 *
 * In a frame u, v, w at an origin, w along a first guess of the normal:
 *   w = c0 + c1 u + c2 v + c3 u^2 + c4 uv + c5 v^2
 * by least squares.  Lengths in mm.
 */
#ifndef CLOUDMILL_QUADRIC_H
#define CLOUDMILL_QUADRIC_H

#include <stddef.h>

#include "math/vec.h"

struct quadric {
    struct vec3 origin, u, v, w; /* w near the normal; unit vectors */
    double c[10]; /* from the sixth on of u^3, u^2 v, u v^2, v^3: cubic.h; of a quadric 0 */
    /* where each point's w has 1 mm^2: of c0; of c1 and c2 together, of c1, and of both with each
       other (covariance), 1/mm^2 */
    double variance, tilt, tilt_u, tilt_uv;
};

/* Without a surface yet: u and v across w (unit), all coefficients 0. */
struct quadric quadric_frame(struct vec3 origin, struct vec3 w);

/* p in the frame: x along u, y along v, z along w. */
static inline struct vec3 quadric_local(const struct quadric *q, struct vec3 p)
{
    struct vec3 d = vec_sub(p, q->origin);
    return vec(vec_dot(d, q->u), vec_dot(d, q->v), vec_dot(d, q->w));
}

/* The same of n points. */
void quadric_local_all(const struct quadric *q, const struct vec3 *point, size_t n,
                       struct vec3 *local);

/*
 * The quadric nearest to n points, its w axis along `guess` (unit).  -1 if the points do not
 * determine one: fewer than 6, spread over a strip narrower than NARROW of its length, or so (on
 * two lines) that a term is the sum of the others up to INDEPENDENT.
 */
int quadric_fit(const struct vec3 *point, size_t n, struct vec3 origin, struct vec3 guess,
                struct quadric *quadric);

/* The same of points that are in a frame already: those of quadric_local, that of quadric_frame.
 * Without the variances, which are 0: they cost a seventh of a fit. */
int quadric_fit_local(const struct vec3 *local, size_t n, const struct quadric *frame,
                      struct quadric *quadric);

/* quadric_fit with the w axis along the quadric's own normal at the origin, found by iteration
 * from a guess: on a slope the frame of the guess would fit heights above a skew plane. */
int quadric_settle(const struct vec3 *point, size_t n, struct vec3 origin, struct vec3 guess,
                   struct quadric *quadric);

/* A unit normal of the plane nearest to n points, on either side: along the axis that serves best
 * for heights (exact where they lie in a plane); (0, 0, 1) for points that span none. */
struct vec3 plane_normal(const struct vec3 *point, size_t n);

/* quadric_fit, each point with its weight (0: it does not count); the points that count must
 * determine the quadric. */
int quadric_fit_weighted(const struct vec3 *point, const double *weight, size_t n,
                         struct vec3 origin, struct vec3 guess, struct quadric *quadric);

/* quadric_settle if the guess is the normal of facets: where that is steep, from straight up too,
 * for slivers between scan lines and facets across a step have normals that mean nothing.  The
 * better fit is taken. */
int quadric_fit_steep(const struct vec3 *point, size_t n, struct vec3 origin, struct vec3 guess,
                      struct quadric *quadric);

/* quadric_settle if nothing is known of the normal: from that of the plane nearest to the points.
 */
int quadric_fit_free(const struct vec3 *point, size_t n, struct vec3 origin,
                     struct quadric *quadric);

/* Turns the surface over if it faces down. */
void quadric_face_up(struct quadric *quadric);

/* Distance of a point from the quadric, to first order: positive on the side of w. */
double quadric_off(const struct quadric *quadric, struct vec3 point);

/* The same of n points. */
void quadric_off_all(const struct quadric *quadric, const struct vec3 *point, size_t n,
                     double *off);

/* True only of a point that quadric_nearest finds no further off than `limit`, mm; false where that
 * takes a closer look.  Quick. */
bool quadric_surely_within(const struct quadric *quadric, struct vec3 point, double limit);

/* The foot of the origin on the quadric, to first order. */
struct vec3 quadric_foot(const struct quadric *quadric);

/* At the origin's foot on the quadric (u = v = 0): unit normal, on the side of w ... */
struct vec3 quadric_normal(const struct quadric *quadric);

/* ... the variance of its slope there one way, any vector but across it, 1/mm^2 as `tilt` ... */
double quadric_tilt_along(const struct quadric *quadric, struct vec3 way);

/* ... distance of the origin from the surface, to first order ... */
double quadric_distance(const struct quadric *quadric);

/* ... and the larger principal curvature, 1/mm, positive where the surface is hollow seen from the
 * side of the normal. */
double quadric_curvature(const struct quadric *quadric);

/* The point over u, v. */
struct vec3 quadric_at(const struct quadric *quadric, double u, double v);

/* The point of the surface nearest to a point that is near to it. */
struct vec3 quadric_nearest(const struct quadric *quadric, struct vec3 point);

/* Unit normal of the surface under or over a point along w, on the side of w. */
struct vec3 quadric_normal_at(const struct quadric *quadric, struct vec3 point);

/* The same of n points. */
void quadric_normal_all(const struct quadric *quadric, const struct vec3 *point, size_t n,
                        struct vec3 *normal);

/* Root mean square of the distances of n points from the surface, to first order. */
double quadric_rms(const struct quadric *quadric, const struct vec3 *point, size_t n);

/* The same of points in its frame: those of quadric_local. */
double quadric_rms_local(const struct quadric *quadric, const struct vec3 *local, size_t n);

/* quadric_rms for the freedom that the fit leaves to them, when it has so many terms. */
double quadric_spread(const struct quadric *quadric, const struct vec3 *point, size_t n,
                      double terms);

#endif
