/*
 * feature_zone - where creases and walls run, seen from above: known from a first mesh, for a
 * second one to keep its vertices off them.
 */
#ifndef CLOUDMILL_FEATURE_ZONE_H
#define CLOUDMILL_FEATURE_ZONE_H

#include <stdbool.h>

#include "math/kdtree.h"
#include "math/vec.h"

struct feature_zone {
    struct kdtree *tree;
    struct vec3s place; /* z is 0 */
    double fine;        /* edges of the mesh that cross a crease or wall are no longer, mm */
    struct zone_cells { /* squares over the places, from (x, y) on */
        double x, y, side;
        size_t columns, rows;
        unsigned char *beside; /* is there a place in the square or one beside it? */
    } cells;
};

/* Of n places on creases and walls, no farther apart along them than about `fine` mm. */
struct feature_zone feature_zone_make(const struct vec3 *place, size_t n, double fine);
void feature_zone_free(struct feature_zone *zone);

/* Is (x, y) so near to a crease or wall that no vertex is to be there: CLEAR of `fine`? */
bool feature_zone_clear(const struct feature_zone *zone, double x, double y);

/* Is it so near that the mesh there is not what it will be: NEAR of `fine`? */
bool feature_zone_near(const struct feature_zone *zone, double x, double y);

#endif
