/* edgezone - see edgezone.h. */
#include "meshing/edgezone.h"

#include <stdlib.h>

static const double CLEAR = 0.3, NEAR = 1.5;

struct edgezone edgezone_make(const struct vec3 *place, size_t n, double fine)
{
    struct edgezone zone = {.fine = fine};

    for (size_t i = 0; i < n; i++)
        *array_push(&zone.place) = vec(place[i].x, place[i].y, 0);
    zone.tree = kdtree_new(zone.place.item, n);
    return zone;
}

void edgezone_free(struct edgezone *zone)
{
    kdtree_free(zone->tree);
    array_free(&zone->place);
}

static bool within(const struct edgezone *zone, double x, double y, double reach)
{
    size_t nearest;
    double distance2;

    return kdtree_nearest(zone->tree, vec(x, y, 0), 1, &nearest, &distance2) == 1 &&
           distance2 < reach * reach;
}

bool edgezone_clear(const struct edgezone *zone, double x, double y)
{
    return within(zone, x, y, CLEAR * zone->fine);
}

bool edgezone_near(const struct edgezone *zone, double x, double y)
{
    return within(zone, x, y, NEAR * zone->fine);
}
