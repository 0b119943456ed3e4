/*
 * view - where a picture is taken from: parallel projections of space.
 *
 * A projected point has x to the right and y up, in mm of the picture's plane, and z towards the
 * eye: of two points at one place of the picture the one with more z hides the other.
 */
#ifndef CLOUDMILL_VIEW_H
#define CLOUDMILL_VIEW_H

#include "math/vec.h"

enum view_name {
    VIEW_PLAN,  /* from above: x to the right, y up */
    VIEW_ISO,   /* isometric, from +x -y +z: all three axes are shortened alike, by sqrt(2/3) */
    VIEW_FRONT, /* from -y: x to the right, z up */
    VIEW_SIDE,  /* from +x: y to the right, z up */
    VIEW_NAMES
};

struct view {
    struct vec3 right, up, toward; /* unit, at right angles, right-handed */
};

struct view view_from(enum view_name name);

struct vec3 view_point(const struct view *view, struct vec3 p);

#endif
