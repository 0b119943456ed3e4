/* uv_polygon - see uv_polygon.h. */
#include "nurbs/uv_polygon.h"

#include <stdlib.h>

#include "base/array.h"

/* Does the loop go round the place?  Crossings of the ray to the right. */
static bool goes_round(const struct uvs *loop, struct uv p)
{
    bool inside = false;
    for (size_t i = 0, k = loop->n - 1; i < loop->n; k = i++) {
        struct uv a = loop->item[k], b = loop->item[i];
        if ((a.v > p.v) != (b.v > p.v) && p.u < a.u + (p.v - a.v) / (b.v - a.v) * (b.u - a.u))
            inside = !inside;
    }
    return inside;
}

bool uv_polygon_inside(const struct uv_polygon *loops, bool open, struct uv at)
{
    bool inside = open;
    for (size_t i = 0; i < loops->n; i++)
        if (goes_round(&loops->item[i], at))
            inside = !inside;
    return inside;
}

static double loop_area(const struct uvs *loop)
{
    double area = 0;
    struct uv o = loop->item[0];
    for (size_t i = 0, k = loop->n - 1; i < loop->n; k = i++) {
        struct uv a = loop->item[k], b = loop->item[i];
        area += (a.u - o.u) * (b.v - o.v) - (b.u - o.u) * (a.v - o.v);
    }
    return area / 2;
}

bool uv_polygon_backwards(const struct uv_polygon *loops, size_t index, bool open)
{
    const struct uvs *loop = &loops->item[index];
    bool hole = open;
    for (size_t i = 0; i < loops->n; i++)
        if (i != index && goes_round(&loops->item[i], loop->item[0]))
            hole = !hole;
    return (loop_area(loop) > 0) == hole;
}

void uv_polygon_free(struct uv_polygon *loops)
{
    for (size_t i = 0; i < loops->n; i++)
        array_free(&loops->item[i]);
    array_free(loops);
    loops->off = 0;
    loops->lost = 0;
}
