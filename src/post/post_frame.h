/*
 * post_frame - the frame that a program is written in: inches, or tilted planes (3+2).
 *
 * Path, machine and options are brought into that frame before anything is planned, so that what is
 * checked on printed digits is checked on those that are printed.
 */
#ifndef CLOUDMILL_POST_FRAME_H
#define CLOUDMILL_POST_FRAME_H

#include "post_plan.h"

/* How a control is told of a tilted plane. */
enum nc_plane_angles {
    NC_PLANE_AXES,    /* about X and the turned Y (CYCLE800, axis by axis) */
    NC_PLANE_EULER,   /* about Z, the turned X and the turned Z (G68.2) */
    NC_PLANE_SPATIAL, /* about X, then about Y as it was before (PLANE SPATIAL, sequence A-B-C) */
    NC_PLANE_ANGLES
};

/* Part of a path along which the tool axis stays as it is. */
struct nc_plane {
    size_t from;      /* its first motion among the path's items */
    struct vec3 axis; /* in the frame of the work */
    double a, b;      /* degrees as printed, about X and the turned Y, that bring Z onto it */
    double i, j, k;   /* Euler's for the same: about Z, the turned X and the turned Z */
    double spa, spb;  /* spatial angles, about X and about Y as it was; their X lies elsewhere */
};

struct nc_planes {
    size_t n, cap;
    struct nc_plane *item;
};

/* The path has holes of drilling cycles, and each has all that a control needs: of a tap its pitch,
 * or the speed of the spindle. */
bool post_frame_holes(const struct path *path);

/*
 * The planes of a path whose tool axis changes only where the tool is off the part: on a rapid, to
 * a hole, with another tool.  False, and no planes: it turns elsewhere too.
 */
bool post_frame_planes(const struct path *path, struct nc_planes *planes);

/* One plane, and its axis is the machine's Z. */
bool post_frame_upright(const struct nc_planes *planes);

/* All lengths in inches. */
void post_frame_inch(struct path *path, struct machine *machine, struct nc_plan_options *options);

/*
 * Brings each part of the path into the frame whose Z is its plane's axis: the work's frame turned
 * by the angles as they are printed with so many digits (those of `angles`), about the same
 * zero point.  A PATH_PLANE comes before each part but the first.  The machine becomes one of three
 * axes; the control turns the others.  -1: the machine cannot turn there.
 */
int post_frame_tilt(struct path *path, struct machine *machine, struct nc_planes *planes,
                    enum nc_plane_angles angles, int digits, struct error *error);

/* A point of a tilted plane in the frame of the work; angles, digits: as for post_frame_tilt. */
struct vec3 post_frame_work(struct nc_plane plane, enum nc_plane_angles angles, int digits,
                            struct vec3 p);

#endif
