/* lift_place - see lift_place.h. */
#include "lift_place.h"

#include "gouge/gouge.h"

void lift_place(struct run_point *p, struct vec3 centre, const struct gouge_lift_options *rule,
                double radius)
{
    p->ball = centre;
    p->axis = tool_axis_at(&rule->axis, &rule->feed, centre, p->normal);
    p->tip = vec_along(centre, -radius, p->axis);
}

static void turn_level(struct run_point *p, const struct gouge_lift_options *rule, double radius)
{
    const double flattest = 0.17364817766693033; /* cos 80 degrees: the ball alone touches yet */
    struct vec3 level = vec_unit(vec(p->axis.x, p->axis.y, 0));

    if (rule->axis.kind != AXIS_LEAN || p->axis.z >= 0 || vec_dot(level, p->normal) < flattest)
        return;
    p->axis = level;
    p->tip = vec_along(p->ball, -radius, level);
}

void lift_place_along(struct run_point *p, struct vec3 centre,
                      const struct gouge_lift_options *rule, double radius)
{
    lift_place(p, centre, rule, radius);
    if (rule->guard)
        turn_level(p, rule, radius);
}

bool lift_line_clear(const struct run_point *a, const struct run_point *b,
                     const struct gouge_lift_options *rule)
{
    const double slack = 1e-5; /* what clear may mean, and rounding */
    double may = GOUGE_SAFE * rule->tolerance, within = rule->offset - may;
    double clear = rule->offset - slack;
    struct vec3 way = vec_sub(b->ball, a->ball);

    /* What is in neither ball stands no deeper in one between than the sagitta of the way. */
    return !rule->guard || vec_dot(way, way) / 4 <= clear * clear - within * within ||
           gouge_clear_along(rule->guard, a->ball, b->ball, rule->offset, may);
}
