/* region - see region.h. */
#include "math/region.h"

#include <stdlib.h>

#include "math/elementary.h"

enum { ABOUT = 8 };

size_t region_polygons_end(const struct region_polygons *polygons, size_t k)
{
    return k + 1 < polygons->from.n ? (size_t)polygons->from.item[k + 1] : polygons->corner.n;
}

/* Whether a ray from the point in the direction of x crosses an odd number of sides. */
bool region_polygons_hold(const struct region_polygons *polygons, struct vec3 p)
{
    bool inside = false;
    for (size_t k = 0; k < polygons->from.n; k++) {
        size_t from = (size_t)polygons->from.item[k], end = region_polygons_end(polygons, k);
        for (size_t i = from; i < end; i++) {
            struct vec3 a = polygons->corner.item[i];
            struct vec3 b = polygons->corner.item[i + 1 < end ? i + 1 : from];
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
                inside = !inside;
        }
    }
    return inside;
}

struct region_polygons region_polygons_copy(const struct region_polygons *polygons)
{
    struct region_polygons copy = {0};

    for (size_t i = 0; i < polygons->corner.n; i++)
        *array_push(&copy.corner) = polygons->corner.item[i];
    for (size_t k = 0; k < polygons->from.n; k++)
        *array_push(&copy.from) = polygons->from.item[k];
    return copy;
}

void region_polygons_free(struct region_polygons *polygons)
{
    array_free(&polygons->corner);
    array_free(&polygons->from);
}

bool region_given(const struct region *region)
{
    return region->boxed || region->polygons.from.n > 0;
}

bool region_holds(const struct region *region, struct vec3 p)
{
    for (int k = 0; k < ABOUT; k++) {
        double turn = 2 * PI * k / ABOUT;
        struct vec3 q = vec_add(p, vec(region->border * cos(turn), region->border * sin(turn), 0));
        if ((region->boxed && box_distance2(&region->box, q) > 0) ||
            (region->polygons.from.n > 0 && !region_polygons_hold(&region->polygons, q)))
            return false;
    }
    return true;
}
