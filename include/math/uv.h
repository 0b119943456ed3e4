/*
 * uv - places in the plane of a surface's two parameters.
 */
#ifndef CLOUDMILL_UV_H
#define CLOUDMILL_UV_H

#include <stddef.h>

/* A place in the plane of the two parameters. */
struct uv {
    double u, v;
};

struct uvs {
    size_t n, cap;
    struct uv *item;
};

#endif
