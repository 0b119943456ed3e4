/*
 * post_arc - an arc as the words of a block, checked as it will be read back.
 */
#ifndef CLOUDMILL_POST_ARC_H
#define CLOUDMILL_POST_ARC_H

#include "machine/interpolation.h"

/* What arcs a control can be given. */
enum nc_arcs {
    NC_ARCS_NONE,
    NC_ARCS_FLAT,   /* in G17, the tool axis still and no helix */
    NC_ARCS_CENTRE, /* in G17 G18 G19, centre by I J K from the start */
    NC_ARCS_RADIUS, /* in G17 G18 G19, radius by R: where I J K are taken for the tool vector */
    NC_ARCS_SPACE,  /* anywhere, by a point on the way: CIP */
    NC_ARCS_BOTH    /* by the centre where that is near enough, else by a point on the way */
};

struct nc_arc {
    int plane;          /* 17 XY, 18 ZX, 19 YZ; 0: in space */
    bool ccw;           /* seen from the plane's positive side: G3 */
    bool full;          /* a whole turn */
    struct vec3 centre; /* from the start, rounded */
    double radius;      /* rounded; negative: more than half a turn */
    struct vec3 middle; /* SPACE: the point on the way, rounded */
    struct vec3 axis;   /* turned about, by the right-hand rule */
};

/*
 * Words for the piece s0 to s1 of an arc motion, between two ends as printed, with `digits`
 * decimals.  *d: the deviation of the printed arc from the motion, *point the tracked point's part
 * of it.  False where the control cannot be given it: it is not in a principal plane; its points
 * are too near to a line or to each other to say where the centre is; or the printed radii at the
 * two ends differ by more than `radius_error` mm.
 */
bool nc_arc_words(struct nc_arc *arc, enum nc_arcs kind, int digits, double radius_error,
                  const struct interpolation *f, const struct block_pose *from,
                  const struct block_pose *to, const struct motion *motion, double s0, double s1,
                  struct pose_deviation *d, double *point);

/* The tracked point's motion by the words between two ends as printed (the tool axis is not used).
 */
struct motion nc_arc_motion(const struct nc_arc *arc, const struct block_pose *from,
                            const struct block_pose *to);

/* How long it is, mm; by the smaller radius, where printed ones differ: there the tip goes slowest
 * on the way in proportion to the rotary axes, and by its feed they turn the fastest. */
double nc_arc_length(const struct nc_arc *arc, const struct block_pose *from,
                     const struct block_pose *to);

/* The most that one block may turn, radians. */
double nc_arc_most(enum nc_arcs kind);

#endif
