/*
 * side_fit - the surface on one side of an edge: a plane or, where that does not do, a quadric, as
 * heights over a plane that all sides of a neighbourhood share.
 */
#ifndef CLOUDMILL_SIDE_FIT_H
#define CLOUDMILL_SIDE_FIT_H

#include "math/quadric.h"
#include "math/vec.h"

struct side_fit {
    struct quadric q; /* a plane: c[3] to c[5] are 0 */
    double rms;       /* of the points' distances, for those that the fit leaves free, mm */
};

/* Heights along w (unit) over the plane through the origin.  -1 if the points determine no plane
 * there: fewer than 4, or nearly on a line. */
int side_fit_plane(const struct vec3 *point, size_t n, struct vec3 origin, struct vec3 w,
                   struct side_fit *fit);

/* The same of points that are in that frame already: those of quadric_local. */
int side_fit_plane_local(const struct vec3 *local, size_t n, struct vec3 origin, struct vec3 w,
                         struct side_fit *fit);

/* What a plane through points takes: their number, and sums of their coordinates in the frame and
 * of products of these. */
struct side_sums {
    double n, u, v, h, uu, uv, vv, uh, vh;
};

/* One point more, in the frame; with part = -1 one less. */
static inline void side_sums_add(struct side_sums *s, double part, struct vec3 local)
{
    double u = part * local.x, v = part * local.y, h = part * local.z;

    s->n += part;
    s->u += u;
    s->v += v;
    s->h += h;
    s->uu += u * local.x;
    s->uv += u * local.y;
    s->vv += v * local.y;
    s->uh += u * local.z;
    s->vh += v * local.z;
}

/* The plane of side_fit_plane through the points of these sums: sets the first three coefficients
 * of fit->q, nothing else; the others and the frame are set already.  The origin is near: about
 * it no digits are lost. */
int side_fit_plane_of(const struct side_sums *sum, struct side_fit *fit);

/* The plane through a place with this unit normal, which is not across w. */
struct side_fit side_fit_through(struct vec3 place, struct vec3 normal, struct vec3 origin,
                                 struct vec3 w);

/* The quadric through the same points in place of the plane, where it leaves less than BETTER of
 * what the plane leaves. */
void side_fit_bend(const struct vec3 *point, size_t n, struct side_fit *fit);

/* The same of points in the frame of the plane. */
void side_fit_bend_local(const struct vec3 *local, size_t n, struct side_fit *fit);

/* Height of the surface, along w, over (or under) the place of p; of a place in the frame. */
double side_fit_height(const struct side_fit *fit, struct vec3 p);
static inline double side_fit_height_local(const struct side_fit *fit, struct vec3 at)
{
    const double *c = fit->q.c;

    return c[0] + at.x * (c[1] + c[3] * at.x + c[4] * at.y) + at.y * (c[2] + c[5] * at.y);
}

/* Height of p above the surface, along w. */
double side_fit_above(const struct side_fit *fit, struct vec3 p);

/* p moved onto the surface, along w. */
struct vec3 side_fit_point(const struct side_fit *fit, struct vec3 p);

/* Unit normal at the place of p, on the side of w. */
struct vec3 side_fit_normal(const struct side_fit *fit, struct vec3 p);

#endif
