#include "gouge/gouge_point.h"

static const struct vec3 UP = {0, 0, 1};

void gouge_point_place(struct run_point *p, struct vec3 centre,
                       const struct gouge_lift_options *rule, double radius)
{
    p->ball = centre;
    p->axis = tool_axis_at(&rule->axis, &rule->feed, centre, p->normal);
    p->tip = vec_along(centre, -radius, p->axis);
}

/* Where the surface looks down, an axis that would come from below is level instead: the ball
 * touches the same, and what is behind it is beside the part. */
static void come_level(struct run_point *p, const struct gouge_lift_options *rule, double radius)
{
    const double flattest = 0.17364817766693033; /* cos 80 degrees: the ball alone touches yet */
    struct vec3 level = vec_unit(vec(p->axis.x, p->axis.y, 0));

    if (rule->axis.kind != AXIS_LEAN || p->axis.z >= 0 || vec_dot(level, p->normal) < flattest)
        return;
    p->axis = level;
    p->tip = vec_along(p->ball, -radius, level);
}

static void place_lifted(struct run_point *p, struct vec3 touching, double lift,
                         const struct gouge_lift_options *rule, double radius)
{
    gouge_point_place(p, vec_along(touching, lift, p->normal), rule, radius);
    if (rule->guard)
        come_level(p, rule, radius);
}

/* The tool can come here, where it is clear, from above: straight down or along its axis. */
static bool open_above(const struct run_point *p, const struct gouge_lift_options *rule)
{
    return gouge_free_above(rule->guard, p->ball, rule->offset - rule->tolerance) ||
           (p->axis.z >= 0 && p->axis.z < 1 &&
            gouge_open(rule->guard, p->ball, p->axis, rule->offset, rule->tolerance));
}

struct gouge_point gouge_point_from(const struct run_point *p, const struct kdtree_touch *touch,
                                    const struct gouge_lift_options *rule, double radius)
{
    struct gouge_point l = {
        .p = *p, .touching = vec_along(p->contact, rule->offset, p->normal), .touch = *touch};
    double lift = 0;

    if (rule->guard)
        lift = gouge_lift(rule->guard, l.touching, p->normal, rule->offset, rule->limit, &l.touch);
    place_lifted(&l.p, l.touching, lift, rule, radius);
    l.missed = rule->guard && (lift < 0 || !open_above(&l.p, rule));
    if (l.missed) {
        double rise = gouge_rise(rule->guard, l.touching, UP, rule->offset);
        gouge_point_place(&l.p, vec_along(l.touching, rise, UP), rule, radius);
    }
    return l;
}

/* Half way between two points, not lifted. */
static struct run_point halfway(const struct gouge_point *a, const struct gouge_point *b,
                                const struct gouge_lift_options *rule)
{
    struct run_point p = {.normal = vec_unit(vec_add(a->p.normal, b->p.normal))};

    if (vec_length(p.normal) == 0) /* there is no middle */
        p.normal = a->p.normal;
    p.contact = vec_along(vec_mix(a->touching, b->touching, 0.5), -rule->offset, p.normal);
    return p;
}

/* What is likely to stop a ball between two. */
static struct kdtree_touch touch_of(const struct gouge_point *a, const struct gouge_point *b)
{
    struct kdtree_touch both = a->touch;

    if (b->touch.n > 0)
        both.p[both.n++] = b->touch.p[0];
    return both;
}

struct gouge_point gouge_point_halfway(const struct gouge_point *a, const struct gouge_point *b,
                                       const struct gouge_lift_options *rule, double radius)
{
    struct run_point p = halfway(a, b, rule);
    struct kdtree_touch touch = touch_of(a, b);

    return gouge_point_from(&p, &touch, rule, radius);
}

bool gouge_point_clear(const struct run_point *a, const struct run_point *b,
                       const struct gouge_lift_options *rule)
{
    const double slack = 1e-5; /* what clear may mean, and rounding */
    double within = rule->offset - rule->tolerance, clear = rule->offset - slack;
    struct vec3 way = vec_sub(b->ball, a->ball);

    /* What is in neither ball stands no deeper in one between than the sagitta of the way. */
    return !rule->guard || vec_dot(way, way) / 4 <= clear * clear - within * within ||
           gouge_clear_along(rule->guard, a->ball, b->ball, rule->offset, rule->tolerance);
}

bool gouge_point_near(const struct gouge_point *a, const struct gouge_point *b,
                      const struct gouge_lift_options *rule)
{
    /* Told by where they would touch, for the lift may jump. */
    return vec_distance(a->touching, b->touching) < 2 * rule->step;
}

static bool on_line(const struct run_point *p, const struct gouge_point *a,
                    const struct gouge_point *b, const struct gouge_lift_options *rule)
{
    return vec_line_distance(a->p.ball, b->p.ball, p->ball) <= rule->tolerance &&
           vec_line_distance(a->p.tip, b->p.tip, p->tip) <= rule->tolerance;
}

/* Where what stops the ball at both ends holds it on the line, and the line is clear, more of the
 * part would only lift it. */
void gouge_point_between(const struct gouge_point *a, const struct gouge_point *b,
                         const struct gouge_lift_options *rule, double radius,
                         struct gouge_points *to)
{
    if (gouge_point_near(a, b, rule))
        return;
    struct run_point between = halfway(a, b, rule), least = between;
    struct kdtree_touch touch = touch_of(a, b);
    struct vec3 touching = vec_along(between.contact, rule->offset, between.normal);
    double lift = kdtree_leave_these(&touch, touching, between.normal, rule->offset);
    place_lifted(&least, touching, lift, rule, radius);
    bool clear = gouge_point_clear(&a->p, &b->p, rule);
    if (clear && !a->missed && !b->missed && on_line(&least, a, b, rule))
        return;
    struct gouge_point l = gouge_point_from(&between, &touch, rule, radius);
    if (clear && on_line(&l.p, a, b, rule))
        return;
    gouge_point_between(a, &l, rule, radius, to);
    *array_push(to) = l;
    gouge_point_between(&l, b, rule, radius, to);
}
