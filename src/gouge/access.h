/*
 * access - from which directions a tool can come to a place: where flute, shank and holder above
 * its ball are clear of the guard points.
 *
 * A guard point at distance d from the ball's centre is in the tool whenever the axis is nearer
 * than an angle A(d) to the direction of the point: a cylinder of radius r blocks a cap of
 * sin A = r / d.  So the open directions are the sphere without such caps, and a box of points is
 * passed by once no direction still open lies in the cap of any point that it may hold.  A stack
 * that gets thinner upward, or ends, counts as if it did not, as seen from the centre.  What is
 * lower than the centre is the ball's and blocks nothing.
 */
#ifndef CLOUDMILL_ACCESS_H
#define CLOUDMILL_ACCESS_H

#include <stdbool.h>

#include "gouge/gouge.h"
#include "math/sphere_grid.h"

struct access_options {
    const struct gouge_check *guard; /* NULL: everything is open */
    const struct holder *holder;
    const struct sphere_grid *grid;
    double gap;           /* guard points within this of others need not be looked at, mm */
    double margin, slope; /* kept free of the stack, mm, and more for each mm of height, mm/mm */
    double slack;         /* how deep points may be in it without them, mm */
    int threads;          /* 0: as many as there are processors */
};

/* Largest angle of the axis from the normal, radians, for the ball to touch with its lower half. */
#define ACCESS_STEEPEST RADIANS(80)

enum access_state { ACCESS_BLOCKED, ACCESS_TIGHT, ACCESS_OPEN };

/* What is computed once for a tool. */
struct access;
struct access *access_new(const struct access_options *options);
void access_free(struct access *access);

/*
 * state[grid->n]: of the directions no further than `within` radians from `rule` and
 * ACCESS_STEEPEST from `normal` (no length: from any) those that are clear; with the margin and
 * slope if any is, else with neither.  Returns how many.
 */
int access_find(const struct access *access, struct vec3 centre, struct vec3 normal,
                struct vec3 rule, double within, unsigned char *state);

/* True if this axis is clear there with margin and slope; not a matter of the grid. */
bool access_is_open(const struct access *access, struct vec3 centre, struct vec3 axis);

/* The same without either. */
bool access_is_clear(const struct access *access, struct vec3 centre, struct vec3 axis);

#endif
