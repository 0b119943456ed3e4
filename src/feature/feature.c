/* feature - see feature.h; feature_crease.c and feature_wall.c are the rest of it. */
#include "feature.h"

enum { FEWEST = 72 };

/* How wide a neighbourhood is against the noise. */
static const double WIDE = 40;

/* Rise of an edge by its length, of a wall. */
static const double SLOPE = 0.5;

bool feature_steep(const struct feature_cloud *cloud, struct vec3 a, struct vec3 b)
{
    double length = hypot(a.x - b.x, a.y - b.y), distance2;
    size_t nearest;

    return fabs(a.z - b.z) > SLOPE * length && cloud->walls &&
           kdtree_nearest(cloud->walls, vec_mix(a, b, 0.5), 1, &nearest, &distance2) == 1 &&
           4 * distance2 < vec_dot(vec_sub(a, b), vec_sub(a, b));
}

size_t feature_reach(const struct feature_cloud *cloud)
{
    double reach = WIDE * cloud->noise / cloud->spacing;

    return (size_t)fmin(fmax(PI * reach * reach, FEWEST), FEATURE_MOST);
}
