#include "lift.h"

#include <stdlib.h>

static const struct vec3 UP = {0, 0, 1};

enum { HALVINGS = 20 }; /* of a jump of the lift, at most */

/* A point with what became of it. */
struct lifted {
    struct run_point p;   /* its normal as it was */
    struct vec3 touching; /* the centre before the lift */
    bool missed;
};

struct lifteds {
    size_t n, cap;
    struct lifted *item;
};

static void set_centre(struct run_point *p, struct vec3 centre, const struct lift_rule *rule,
                       double radius)
{
    p->ball = centre;
    p->axis = axis_at(&rule->axis, &rule->feed, centre, p->normal);
    p->tip = vec_along(centre, -radius, p->axis);
}

void lift_add(struct run *run, const struct lift_rule *rule, struct vec3 contact,
              struct vec3 normal)
{
    struct run_point p = {.contact = contact, .normal = normal, .given = true};

    set_centre(&p, vec_along(contact, rule->offset, normal), rule, run->radius);
    *array_push(run) = p;
}

/* Where the surface looks down, an axis that would come from below is level instead: the ball
 * touches the same, and what is behind it is beside the part. */
static void come_level(struct run_point *p, const struct lift_rule *rule, double radius)
{
    const double flattest = 0.17364817766693033; /* cos 80 degrees: the ball alone touches yet */
    struct vec3 level = vec_unit(vec(p->axis.x, p->axis.y, 0));

    if (rule->axis.kind != AXIS_LEAN || p->axis.z >= 0 || vec_dot(level, p->normal) < flattest)
        return;
    p->axis = level;
    p->tip = vec_along(p->ball, -radius, level);
}

/* The tool can come here, where it is clear, from above: straight down or along its axis. */
static bool open_above(const struct run_point *p, const struct lift_rule *rule)
{
    return guard_free_above(rule->guard, p->ball, rule->offset - rule->tolerance) ||
           (p->axis.z >= 0 && p->axis.z < 1 &&
            guard_open(rule->guard, p->ball, p->axis, rule->offset, rule->tolerance));
}

static struct lifted lift_point(const struct run_point *p, const struct lift_rule *rule,
                                double radius)
{
    struct lifted l = {.p = *p, .touching = vec_along(p->contact, rule->offset, p->normal)};
    double lift = 0;

    if (rule->guard)
        lift = guard_lift(rule->guard, l.touching, p->normal, rule->offset, rule->limit);
    set_centre(&l.p, vec_along(l.touching, lift, p->normal), rule, radius);
    if (rule->guard)
        come_level(&l.p, rule, radius);
    l.missed = rule->guard && (lift < 0 || !open_above(&l.p, rule));
    if (l.missed) {
        double rise = guard_rise(rule->guard, l.touching, UP, rule->offset);
        set_centre(&l.p, vec_along(l.touching, rise, UP), rule, radius);
    }
    return l;
}

/* What stands under a ball that touches elsewhere. */
static void look_under(const struct run_point *p, const struct lift_rule *rule,
                       struct lifted_run *to)
{
    double half = rule->offset / 2;
    double height = guard_distance(rule->guard, vec_along(p->ball, -half, p->normal)) - half;

    if (height > rule->stands)
        *array_push(&to->stand) = (struct stand){p->contact, height};
}

/* Appends a lifted point to the run, and to the report. */
static void put(struct lifted_run *to, const struct lifted *l, const struct lift_rule *rule)
{
    struct lift_report *report = &to->report;
    struct run_point p = l->p;
    double lift = vec_distance(p.ball, l->touching);

    report->points++;
    if (l->missed) {
        p.normal = vec(0, 0, 0);
        report->missed++;
        if (lift > report->miss) {
            report->miss = lift;
            report->miss_at = p.contact;
        }
    } else if (lift > 1e-6) {
        report->lifted++;
        if (lift > report->highest) {
            report->highest = lift;
            report->highest_at = p.contact;
        }
        if (lift > rule->stands)
            look_under(&p, rule, to);
    }
    *array_push(&to->run) = p;
}

/* Half way between two points, lifted itself. */
static struct lifted halfway(const struct lifted *a, const struct lifted *b,
                             const struct lift_rule *rule, double radius)
{
    struct run_point p = {.normal = vec_unit(vec_add(a->p.normal, b->p.normal))};

    if (vec_length(p.normal) == 0) /* there is no middle */
        p.normal = a->p.normal;
    p.contact = vec_along(vec_mix(a->touching, b->touching, 0.5), -rule->offset, p.normal);
    return lift_point(&p, rule, radius);
}

static double off_line(struct vec3 p, struct vec3 a, struct vec3 b)
{
    return vec_length(vec_reject(vec_sub(p, a), vec_unit(vec_sub(b, a))));
}

/* The ball goes no deeper than the tolerance between two points where it is clear. */
static bool clear_between(const struct run_point *a, const struct run_point *b,
                          const struct lift_rule *rule)
{
    const double slack = 1e-5; /* what clear may mean, and rounding */
    double within = rule->offset - rule->tolerance, clear = rule->offset - slack;
    struct vec3 way = vec_sub(b->ball, a->ball);

    /* What is in neither ball stands no deeper in one between than the sagitta of the way. */
    return !rule->guard || vec_dot(way, way) / 4 <= clear * clear - within * within ||
           guard_clear_along(rule->guard, a->ball, b->ball, rule->offset, rule->tolerance);
}

/* A jump of the lift: the centres are that much further apart than the points they belong to. */
static bool jumps(const struct lifted *a, const struct lifted *b, const struct lift_rule *rule)
{
    double apart = vec_distance(a->p.ball, b->p.ball);

    return apart > 4 * vec_distance(a->touching, b->touching) + 2 * rule->step;
}

/* From one side of a jump to the other, over what is between; false when that is in the way too,
 * as under an overhang. */
static bool bridge(const struct run_point *a, const struct run_point *b, int halvings,
                   const struct lift_rule *rule, struct run *dense)
{
    if (halvings < HALVINGS && clear_between(a, b, rule))
        return true;
    if (halvings == 0)
        return false;
    struct run_point p = {.axis = vec_slerp(a->axis, b->axis, 0.5)};
    p.ball = vec_mix(a->ball, b->ball, 0.5);
    p.ball.z += guard_rise(rule->guard, p.ball, UP, rule->offset);
    p.tip = vec_along(p.ball, -dense->radius, p.axis);
    if (!bridge(a, &p, halvings - 1, rule, dense))
        return false;
    *array_push(dense) = p;
    return bridge(&p, b, halvings - 1, rule, dense);
}

/* The same, or where there is no way the end of the piece. */
static void bridge_or_end(const struct lifted *a, const struct lifted *b,
                          const struct lift_rule *rule, struct lifted_run *to)
{
    size_t n = to->run.n;

    if (bridge(&a->p, &b->p, HALVINGS, rule, &to->run))
        return;
    to->run.n = n;
    *array_push(&to->end) = n;
}

/* Between nodes alone only what the ball can't reach is bridged, for nobody looked between. */
static bool needs_bridge(const struct lifted *a, const struct lifted *b,
                         const struct lift_rule *rule)
{
    if (!rule->guard)
        return false;
    if (rule->between && jumps(a, b, rule))
        return true;
    return (rule->between || a->missed || b->missed) &&
           !clear_between(&a->p, &b->p, rule);
}

/* Puts the points into the run, with what the tool needs to get over jumps between them. */
static void put_all(struct lifted_run *to, const struct lifteds *points,
                    const struct lift_rule *rule)
{
    for (size_t i = 0; i < points->n; i++) {
        const struct lifted *l = &points->item[i];
        if (i > 0 && needs_bridge(l - 1, l, rule))
            bridge_or_end(l - 1, l, rule, to);
        put(to, l, rule);
    }
    *array_push(&to->end) = to->run.n;
}

static bool too_near(const struct lifted *a, const struct lifted *b, const struct lift_rule *rule)
{
    /* Told by where they would touch, for the lift may jump. */
    return vec_distance(a->touching, b->touching) < 2 * rule->step;
}

/* Appends the points between a and b that straight lines need. */
static void split(const struct lifted *a, const struct lifted *b, const struct lift_rule *rule,
                  double radius, struct lifteds *to)
{
    if (too_near(a, b, rule))
        return;
    struct lifted l = halfway(a, b, rule, radius);
    if (off_line(l.p.ball, a->p.ball, b->p.ball) <= rule->tolerance &&
        off_line(l.p.tip, a->p.tip, b->p.tip) <= rule->tolerance &&
        clear_between(&a->p, &b->p, rule))
        return;
    split(a, &l, rule, radius, to);
    *array_push(to) = l;
    split(&l, b, rule, radius, to);
}

/* How far a cubic with these tangents leaves the straight line between its ends, at most. */
static double bulge(const struct lifted *a, struct vec3 ta, const struct lifted *b, struct vec3 tb)
{
    struct vec3 chord = vec_sub(b->p.ball, a->p.ball);
    double length = vec_length(chord);
    struct vec3 along = vec_unit(chord);

    return 4 / 27.0 * length *
           (vec_length(vec_reject(ta, along)) + vec_length(vec_reject(tb, along)));
}

/*
 * A smooth curve through the points, as a fitter sees it, swings where long intervals meet short
 * ones at a kink of the lift.  Appends all points of `from` to `to`, and one half way where it
 * would leave the straight line by more than the tolerance; true when there was one.
 */
static bool refine(const struct lifteds *from, const struct lift_rule *rule, double radius,
                   struct lifteds *to)
{
    struct run run = {.radius = radius};
    struct vec3 *tangent = mem_alloc(from->n, sizeof *tangent);

    for (size_t i = 0; i < from->n; i++)
        *array_push(&run) = from->item[i].p;
    run_tangents(&run, false, tangent);
    for (size_t i = 0; i < from->n; i++) {
        const struct lifted *l = &from->item[i];
        if (i > 0 && !too_near(l - 1, l, rule) &&
            bulge(l - 1, tangent[i - 1], l, tangent[i]) > rule->tolerance)
            *array_push(to) = halfway(l - 1, l, rule, radius);
        *array_push(to) = *l;
    }
    array_free(&run);
    free(tangent);
    return to->n > from->n;
}

static void lift_between(const struct run *run, const struct lift_rule *rule,
                         struct lifteds *points)
{
    struct run smooth = {.radius = run->radius};
    bool more = true;

    /* Half of the tolerance for the curve, the rest for the lift. */
    run_densify(run, rule->tolerance / 2, &smooth);
    for (size_t i = 0; i < smooth.n; i++) {
        struct lifted l = lift_point(&smooth.item[i], rule, run->radius);
        if (i > 0) {
            struct lifted before = points->item[points->n - 1];
            split(&before, &l, rule, run->radius, points);
        }
        *array_push(points) = l;
    }
    array_free(&smooth);
    while (more) {
        struct lifteds finer = {0};
        more = refine(points, rule, run->radius, &finer);
        array_free(points);
        *points = finer;
    }
}

void lift_run(const struct run *run, const struct lift_rule *rule, struct lifted_run *to)
{
    struct lifteds points = {0};

    if (rule->between)
        lift_between(run, rule, &points);
    for (size_t i = 0; !rule->between && i < run->n; i++)
        *array_push(&points) = lift_point(&run->item[i], rule, run->radius);
    put_all(to, &points, rule);
    array_free(&points);
}

void lifted_run_free(struct lifted_run *lifted)
{
    array_free(&lifted->run);
    array_free(&lifted->end);
    array_free(&lifted->stand);
}
