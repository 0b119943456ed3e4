#include "gouge/gouge_strip.h"

#include <stdlib.h>

static const struct vec3 UP = {0, 0, 1};

enum { HALVINGS = 20 }; /* of a jump of the lift, at most */

void gouge_strip_add(struct run *run, const struct gouge_lift_options *rule, struct vec3 contact,
                     struct vec3 normal)
{
    struct run_point p = {.contact = contact, .normal = normal, .given = true};

    gouge_point_place(&p, vec_along(contact, rule->offset, normal), rule, run->radius);
    *array_push(run) = p;
}

/* What stands under a ball that touches elsewhere. */
static void look_under(const struct gouge_point *l, const struct gouge_lift_options *rule,
                       struct gouge_strip *to)
{
    double half = rule->offset / 2;
    struct vec3 lower = vec_along(l->p.ball, -half, l->p.normal);
    double height = gouge_distance(rule->guard, lower, vec_distance(lower, l->touch.p[0])) - half;

    if (height > rule->stands)
        *array_push(&to->stand) = (struct uncut){l->p.contact, height};
}

/* Appends a lifted point to the run, and to the report. */
static void put(struct gouge_strip *to, const struct gouge_point *l,
                const struct gouge_lift_options *rule)
{
    struct gouge_strip_report *report = &to->report;
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
            look_under(l, rule, to);
    }
    *array_push(&to->run) = p;
}

/* A jump of the lift: the centres are that much further apart than the points they belong to. */
static bool jumps(const struct gouge_point *a, const struct gouge_point *b,
                  const struct gouge_lift_options *rule)
{
    double apart = vec_distance(a->p.ball, b->p.ball);

    return apart > 4 * vec_distance(a->touching, b->touching) + 2 * rule->step;
}

/* From one side of a jump to the other, over what is between; false when that is in the way too,
 * as under an overhang. */
static bool bridge(const struct run_point *a, const struct run_point *b, int halvings,
                   const struct gouge_lift_options *rule, struct run *dense)
{
    if (halvings < HALVINGS && gouge_point_clear(a, b, rule))
        return true;
    if (halvings == 0)
        return false;
    struct run_point p = {.axis = vec_slerp(a->axis, b->axis, 0.5)};
    p.ball = vec_mix(a->ball, b->ball, 0.5);
    p.ball.z += gouge_rise(rule->guard, p.ball, UP, rule->offset);
    p.tip = vec_along(p.ball, -dense->radius, p.axis);
    if (!bridge(a, &p, halvings - 1, rule, dense))
        return false;
    *array_push(dense) = p;
    return bridge(&p, b, halvings - 1, rule, dense);
}

/* The same, or where there is no way the end of the piece. */
static void bridge_or_end(const struct gouge_point *a, const struct gouge_point *b,
                          const struct gouge_lift_options *rule, struct gouge_strip *to)
{
    size_t n = to->run.n;

    if (bridge(&a->p, &b->p, HALVINGS, rule, &to->run))
        return;
    to->run.n = n;
    *array_push(&to->end) = n;
}

/* Between nodes alone only what the ball can't reach is bridged, for nobody looked between. */
static bool needs_bridge(const struct gouge_point *a, const struct gouge_point *b,
                         const struct gouge_lift_options *rule)
{
    if (!rule->guard)
        return false;
    if (rule->between && jumps(a, b, rule))
        return true;
    return (rule->between || a->missed || b->missed) && !gouge_point_clear(&a->p, &b->p, rule);
}

/* Puts the points into the run, with what the tool needs to get over jumps between them. */
static void put_all(struct gouge_strip *to, const struct gouge_points *points,
                    const struct gouge_lift_options *rule)
{
    for (size_t i = 0; i < points->n; i++) {
        const struct gouge_point *l = &points->item[i];
        if (i > 0 && needs_bridge(l - 1, l, rule))
            bridge_or_end(l - 1, l, rule, to);
        put(to, l, rule);
    }
    *array_push(&to->end) = to->run.n;
}

/* How far a cubic with these tangents leaves the straight line between its ends, at most. */
static double bulge(const struct gouge_point *a, struct vec3 ta, const struct gouge_point *b,
                    struct vec3 tb)
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
static bool refine(const struct gouge_points *from, const struct gouge_lift_options *rule,
                   double radius, struct gouge_points *to)
{
    struct run run = {.radius = radius};
    struct vec3 *tangent = mem_alloc(from->n, sizeof *tangent);

    for (size_t i = 0; i < from->n; i++)
        *array_push(&run) = from->item[i].p;
    run_tangents(&run, false, tangent);
    for (size_t i = 0; i < from->n; i++) {
        const struct gouge_point *l = &from->item[i];
        if (i > 0 && !gouge_point_near(l - 1, l, rule) &&
            bulge(l - 1, tangent[i - 1], l, tangent[i]) > rule->tolerance)
            *array_push(to) = gouge_point_halfway(l - 1, l, rule, radius);
        *array_push(to) = *l;
    }
    array_free(&run);
    free(tangent);
    return to->n > from->n;
}

static void lift_smooth(const struct run *run, const struct gouge_lift_options *rule,
                        struct gouge_points *points)
{
    struct run smooth = {.radius = run->radius};
    struct gouge_point before = {.missed = false};
    bool more = true;

    /* Half of the tolerance for the curve, the rest for the lift. */
    run_densify(run, rule->tolerance / 2, &smooth);
    for (size_t i = 0; i < smooth.n; i++) {
        struct gouge_point l = gouge_point_from(&smooth.item[i], &before.touch, rule, run->radius);
        if (i > 0)
            gouge_point_between(&before, &l, rule, run->radius, points);
        *array_push(points) = before = l;
    }
    array_free(&smooth);
    while (more) {
        struct gouge_points finer = {0};
        more = refine(points, rule, run->radius, &finer);
        array_free(points);
        *points = finer;
    }
}

void gouge_strip_lift(const struct run *run, const struct gouge_lift_options *rule,
                      struct gouge_strip *to)
{
    const struct kdtree_touch nothing = {.n = 0};
    struct gouge_points points = {0};

    if (rule->between)
        lift_smooth(run, rule, &points);
    for (size_t i = 0; !rule->between && i < run->n; i++)
        *array_push(&points) = gouge_point_from(&run->item[i], &nothing, rule, run->radius);
    put_all(to, &points, rule);
    array_free(&points);
}

void gouge_strip_free(struct gouge_strip *lifted)
{
    array_free(&lifted->run);
    array_free(&lifted->end);
    array_free(&lifted->stand);
}
