/* feature_zone - see feature_zone.h. */
#include "meshing/feature_zone.h"

#include <stdlib.h>

static const double CLEAR = 0.3, NEAR = 1.5; /* distances, of `fine` */

struct feature_zone feature_zone_make(const struct vec3 *place, size_t n, double fine)
{
    struct feature_zone zone = {.fine = fine};

    for (size_t i = 0; i < n; i++)
        *array_push(&zone.place) = vec(place[i].x, place[i].y, 0);
    zone.tree = kdtree_new(zone.place.item, n);
    return zone;
}

void feature_zone_free(struct feature_zone *zone)
{
    kdtree_free(zone->tree);
    array_free(&zone->place);
}

static bool is_within(const struct feature_zone *zone, double x, double y, double reach)
{
    size_t nearest;
    double distance2;

    return kdtree_nearest(zone->tree, vec(x, y, 0), 1, &nearest, &distance2) == 1 &&
           distance2 < reach * reach;
}

bool feature_zone_clear(const struct feature_zone *zone, double x, double y)
{
    return is_within(zone, x, y, CLEAR * zone->fine);
}

bool feature_zone_near(const struct feature_zone *zone, double x, double y)
{
    return is_within(zone, x, y, NEAR * zone->fine);
}
