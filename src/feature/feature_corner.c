/* feature_corner - see feature_steps.h. */
#include "feature_steps.h"

static const double TURN = 0.14; /* sine of the angle between two planes */
static const double ROOM = 0.01; /* from the sides of the triangle, of its heights */

static bool is_within(const struct vec3 t[3], struct vec3 p)
{
    double all = vec_orient_xy(t[0], t[1], t[2]);
    bool inside = all > 0;

    for (int i = 0; i < 3; i++)
        inside = inside && vec_orient_xy(t[i], t[(i + 1) % 3], p) > ROOM * all;
    return inside;
}

struct feature_corner_plane feature_corner_mean(struct feature_corner_plane a,
                                                struct feature_corner_plane b)
{
    return (struct feature_corner_plane){vec_mix(a.place, b.place, 0.5),
                                         vec_unit(vec_add(a.normal, b.normal))};
}

bool feature_corner_of(const struct feature_corner_plane plane[3], struct vec3 from,
                       struct vec3 *corner)
{
    struct vec3 sum = {0, 0, 0};
    double volume = vec_dot(plane[0].normal, vec_cross(plane[1].normal, plane[2].normal));

    for (int i = 0; i < 3; i++) {
        const struct feature_corner_plane *p = &plane[i];
        struct vec3 line = vec_cross(plane[(i + 1) % 3].normal, plane[(i + 2) % 3].normal);
        if (!(vec_length(line) > TURN))
            return false;
        sum = vec_along(sum, vec_dot(p->normal, vec_sub(p->place, from)), line);
    }
    if (!(fabs(volume) > TURN * TURN))
        return false;
    *corner = vec_along(from, 1 / volume, sum);
    return true;
}

bool feature_corner(const struct feature_corner_plane plane[3], const struct vec3 triangle[3],
                    struct vec3 *corner)
{
    return feature_corner_of(plane, triangle[0], corner) && is_within(triangle, *corner);
}
