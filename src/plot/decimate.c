/* decimate - see decimate.h. */
#include "decimate.h"

#include <stdbool.h>

#include "base/array.h"

/* The directions from an anchor that pass all points since within the tolerance. */
struct sector {
    struct vec3 anchor;
    bool open;               /* nothing has bounded it yet */
    struct vec3 right, left; /* its bounds, counter-clockwise from right to left */
    double reach;            /* the farthest point since the anchor, mm */
};

static double cross(struct vec3 a, struct vec3 b)
{
    return a.x * b.y - a.y * b.x;
}

/* d turned by the angle whose sine is s. */
static struct vec3 turned_direction(struct vec3 d, double s)
{
    double c = sqrt(1 - s * s);
    return vec(c * d.x - s * d.y, s * d.x + c * d.y, 0);
}

/* True when a line from the anchor to p serves all points since; the sector then takes p in. */
static bool sector_take(struct sector *sector, struct vec3 p, double tolerance)
{
    struct vec3 d = vec(p.x - sector->anchor.x, p.y - sector->anchor.y, 0);
    double distance = hypot(d.x, d.y);
    if (distance <= tolerance)
        return sector->reach <= tolerance;
    if (distance < sector->reach - tolerance)
        return false;
    struct vec3 right = turned_direction(d, -tolerance / distance),
                left = turned_direction(d, tolerance / distance);
    if (!sector->open) {
        if (vec_dot(d, sector->right) <= 0 || cross(sector->right, d) < 0 ||
            cross(d, sector->left) < 0)
            return false;
        if (cross(sector->right, right) < 0)
            right = sector->right;
        if (cross(left, sector->left) < 0)
            left = sector->left;
    }
    sector->right = right;
    sector->left = left;
    sector->open = false;
    sector->reach = fmax(sector->reach, distance);
    return true;
}

void decimate_chain(const struct vec3 *point, size_t n, double tolerance, struct vec3s *out)
{
    if (n == 0)
        return;
    *array_push(out) = point[0];
    struct sector sector = {.anchor = point[0], .open = true};
    for (size_t i = 1; i < n; i++) {
        if (sector_take(&sector, point[i], tolerance))
            continue;
        *array_push(out) = point[i - 1];
        sector = (struct sector){.anchor = point[i - 1], .open = true};
        sector_take(&sector, point[i], tolerance);
    }
    if (n > 1)
        *array_push(out) = point[n - 1];
}
