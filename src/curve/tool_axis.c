/* tool_axis - see tool_axis.h. */
#include "curve/tool_axis.h"

/* Feed direction perpendicular to the normal; where the surface faces the feed, straight up it. */
static struct vec3 tangent(const struct tool_axis_feed *feed, struct vec3 normal)
{
    struct vec3 t = vec_cross(feed->plane, normal);

    if (vec_length(t) < 1e-9)
        t = vec_reject(feed->along, normal);
    if (vec_length(t) < 1e-9)
        t = vec_reject(vec(0, 0, 1), normal);
    return vec_unit(t);
}

/* The direction that has the next row on its side whatever the surface does there. */
static double side_of(const struct tool_axis_feed *feed)
{
    struct vec3 up = vec_length(feed->up) > 0 ? feed->up : vec(0, 0, 1);
    struct vec3 left = vec_cross(up, feed->along);

    if (vec_length(feed->plane) > 0)
        left = feed->plane;
    return vec_dot(left, feed->side) < 0 ? -1 : 1;
}

static struct vec3 lean(const struct tool_axis_options *rule, const struct tool_axis_feed *feed,
                        struct vec3 normal)
{
    struct vec3 t = tangent(feed, normal);
    struct vec3 b = vec_scale(side_of(feed), vec_cross(normal, t));

    return vec_along(vec_along(normal, tan(rule->lead), t), tan(rule->tilt), b);
}

static struct vec3 nearest_on_circle(const struct tool_axis_options *rule, struct vec3 p)
{
    struct vec3 out = vec_unit(vec_reject(vec_sub(p, rule->point), rule->direction));

    if (vec_length(out) == 0)
        out = vec_perpendicular(rule->direction);
    return vec_along(rule->point, rule->radius, out);
}

struct vec3 axis_circle_nearest(const struct axis_circle *circle, struct vec3 axis)
{
    const double along = 1e-9; /* so near the pole there is no nearest one */
    struct vec3 pole = circle->pole, zero = circle->zero, flat = vec_reject(axis, pole);

    if (vec_length(pole) == 0)
        return axis;
    if (vec_length(flat) < along)
        flat = zero;
    double q = atan2(vec_dot(pole, vec_cross(zero, flat)), vec_dot(zero, flat));
    double middle = (circle->min + circle->max) / 2;
    q += 2 * PI * round((middle - q) / (2 * PI));
    if (q >= circle->min && q <= circle->max)
        return vec_unit(flat);
    return vec_turn(zero, pole, q < circle->min ? circle->min : circle->max);
}

struct vec3 tool_axis_at(const struct tool_axis_options *rule, const struct tool_axis_feed *feed,
                         struct vec3 centre, struct vec3 normal)
{
    struct vec3 a;

    switch (rule->kind) {
    case AXIS_LEAN:
        a = lean(rule, feed, normal);
        break;
    case AXIS_TO_POINT:
        a = vec_sub(rule->point, centre);
        break;
    case AXIS_FROM_POINT:
        a = vec_sub(centre, rule->point);
        break;
    case AXIS_CIRCLE:
        a = vec_sub(nearest_on_circle(rule, centre), centre);
        break;
    case AXIS_FIXED:
        a = rule->direction;
        break;
    }
    return axis_circle_nearest(&rule->circle, vec_length(a) > 0 ? vec_unit(a) : normal);
}
