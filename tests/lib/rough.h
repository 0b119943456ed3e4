/* rough - repeatable random numbers and clouds of planes for tests of edges and walls. */
#ifndef CLOUDMILL_TEST_ROUGH_H
#define CLOUDMILL_TEST_ROUGH_H

#include <stdint.h>

#include "base/array.h"
#include "math/vec.h"
#include "seed.h"

static uint64_t rough_state = 11;

/* In [0, 1). */
static inline double uniform(void)
{
    rough_state = rough_state * 6364136223846793005u + seed_step();
    return (double)(rough_state >> 11) / 9007199254740992.0;
}

/* Of standard deviation 1, near enough: the sum of twelve. */
static inline double normal(void)
{
    double sum = -6;
    for (int i = 0; i < 12; i++)
        sum += uniform();
    return sum;
}

/* n points on the rectangle corner + [0, 1] u + [0, 1] v, noisy along its normal. */
static inline void rectangle(struct vec3s *points, size_t n, struct vec3 corner, struct vec3 u,
                             struct vec3 v, double noise)
{
    struct vec3 w = vec_unit(vec_cross(u, v));
    for (size_t i = 0; i < n; i++) {
        double t = uniform(), s = uniform(); /* in this order everywhere */
        struct vec3 p = vec_along(vec_along(corner, s, u), t, v);
        *array_push(points) = vec_along(p, noise * normal(), w);
    }
}

#endif
