/*
 * faces - triangles by the indices of their corners.
 */
#ifndef CLOUDMILL_FACES_H
#define CLOUDMILL_FACES_H

#include <stddef.h>

struct face {
    int v[3]; /* corners, counter-clockwise seen from outside */
};

struct faces {
    size_t n, cap;
    struct face *item;
};

#endif
