/* ridge_direction - see ridge_direction.h. */
#include "math/ridge_direction.h"

#include "math/neighbourhood_along.h"

enum { TRIES = 4 };

static const double STEP = PI / 36;

bool ridge_direction_find(const struct vec3 *point, size_t n, struct vec3 at, struct vec3 up,
                          struct vec3 way, size_t some, struct ridge_direction *rib)
{
    struct vec3 found[RIDGE_DIRECTION_MOST], side = vec_cross(up, way);

    rib->rms = INFINITY;
    for (int i = -TRIES; i <= TRIES; i++) {
        struct quadric q;
        struct vec3 turned = vec_along(vec_scale(cos(i * STEP), way), sin(i * STEP), side);
        size_t k =
            neighbourhood_along_take(point, n, at, turned, RIDGE_DIRECTION_LONGER, some, found);
        if (quadric_fit(found, k, at, up, &q) < 0)
            continue;
        double rms = quadric_rms(&q, found, k);
        if (rms < rib->rms)
            *rib = (struct ridge_direction){q, turned, rms};
    }
    return rib->rms < INFINITY;
}
