#include "gouge/link.h"

/* The way that is out of the material, as far as the point knows. */
static struct vec3 outwards(const struct run_point *p)
{
    return vec_length(p->normal) > 0 ? p->normal : p->axis;
}

/* The way in `parts` equal parts; false when it is not clear. */
static bool try_way(const struct run_point *from, const struct run_point *to, size_t parts,
                    const struct gouge_lift_options *rule, double limit, struct run *way)
{
    double length = vec_distance(from->ball, to->ball);
    struct run_point before = *from;

    for (size_t i = 1; i <= parts; i++) {
        double s = (double)i / (double)parts, arch = 0.4 * s * (1 - s) * length;
        struct vec3 up = vec_slerp(outwards(from), outwards(to), s);
        struct run_point p = {.axis = vec_slerp(from->axis, to->axis, s)};
        p.ball = vec_along(vec_mix(from->ball, to->ball, s), arch, up);
        double lift = gouge_lift(rule->guard, p.ball, up, rule->offset, limit, NULL);
        p.ball = vec_along(p.ball, lift, up);
        p.tip = vec_along(p.ball, -way->radius, p.axis);
        if (lift < 0 ||
            gouge_depth_along(rule->guard, before.ball, p.ball, rule->offset) > rule->tolerance)
            return false;
        before = p;
        if (i < parts)
            *array_push(way) = p;
    }
    return true;
}

bool link_low(const struct run_point *from, const struct run_point *to,
              const struct gouge_lift_options *rule, double limit, struct run *way)
{
    size_t n = way->n;

    if (!rule->guard)
        return true;
    for (size_t parts = 4; parts <= 64; parts *= 2) {
        way->n = n;
        if (try_way(from, to, parts, rule, limit, way))
            return true;
    }
    way->n = n;
    return false;
}
