/*
 * trim_steps - what the files of trim_loops.h share: a curve that is followed on the surface, and
 * the places of a loop by one parameter.
 */
#ifndef CLOUDMILL_TRIM_STEPS_H
#define CLOUDMILL_TRIM_STEPS_H

#include "pullback.h"
#include "uv_polygon.h"

#define TRIM_ROUNDING 1e-6 /* by the width of the range */

/* A curve in the parameters or in space that is being followed on the surface. */
struct trim_follower {
    struct pullback on;
    const struct nurbs_curve *curve;
    double tolerance;
    bool space, directed;
    bool bent;         /* corners so that what the chords bound is what the curve bounds */
    double off;        /* the farthest that the curve was off the surface */
    struct uv slit_at; /* beside that pole */
    bool slit;         /* a loop that is not directed went to a pole and back the same way ... */
    bool slit_seen;    /* some loop did */
    double pole_way;   /* ... and goes so many turns about it there instead */
    int seeks;         /* searches of the whole surface that may still fail */
    struct uvs *to;
};

/*
 * A loop; one that is not directed and does not come back, or bounds more than there is, with one
 * of its parts turned round with which it does (trim_order.h).
 */
void trim_follow(const struct patch *patch, const struct patch_loop *loop, struct trim_follower *f,
                 struct uvs *to);

/* How often a loop goes round, by u or v, before it comes back to its start. */
int trim_rounds(const struct pullback *s, const struct uvs *loop, bool u);

/* Does a loop that comes back bound more than all of a surface that closes both ways? */
bool trim_too_large(const struct pullback *s, const struct uvs *loop);

/* Brings loops into the range of a surface that closes on itself (trim_loops.h). */
void trim_seam(const struct pullback *s, const struct uv_polygon *from, struct uv_polygon *to);

/* The width of a range; of a place one parameter, and the place moved along it; the range of that
 * parameter; a place on the straight line between two. */
static inline double trim_width(const struct nurbs_axis *a)
{
    return a->to - a->from;
}

static inline double trim_coordinate(struct uv at, bool u)
{
    return u ? at.u : at.v;
}

static inline struct uv trim_moved(struct uv at, bool u, double by)
{
    return u ? (struct uv){at.u + by, at.v} : (struct uv){at.u, at.v + by};
}

static inline const struct nurbs_axis *trim_axis(const struct pullback *s, bool u)
{
    return u ? &s->surface->u : &s->surface->v;
}

static inline struct uv trim_between(struct uv a, struct uv b, double t)
{
    return (struct uv){a.u + (b.u - a.u) * t, a.v + (b.v - a.v) * t};
}

#endif
