/* axis_plan - see axis_plan.h. */
#include "gouge/axis_plan.h"

#include <stdint.h>
#include <stdlib.h>

#include "axis_plan_steps.h"
#include "gouge/axis_smooth.h"
#include "gouge/holder_sweep.h"

enum { ROUNDS = 4 };

static const double MARGIN = 0.05;  /* mm: kept free of the tool, ... */
static const double SLOPE = 0.0087; /* ... and so much more for each mm of height: 0.5 degrees */

struct axis_planner *axis_planner_new(const struct axis_planner_options *options)
{
    struct axis_planner *p = mem_alloc(1, sizeof *p);

    p->options = *options;
    p->frame = rotary_frame_of(&options->chain);
    p->grid = sphere_grid_new(p->frame.pole);
    if (options->chain.n == 1) /* no other direction is reached */
        sphere_grid_level(&p->grid);
    struct access_options access = {
        options->guard, &p->options.holder,     &p->grid,        options->radius / 12, MARGIN,
        SLOPE,          options->tolerance / 2, options->threads};
    p->access = access_new(&access);
    p->reached = mem_alloc((size_t)p->grid.n, sizeof *p->reached);
    p->beside = mem_alloc((size_t)p->grid.n, sizeof *p->beside);
    axis_choose_leanings(p);
    for (int i = 0; i < p->grid.n; i++) {
        p->reached[i] = options->chain.n > 0 && rotary_reaches(&options->chain, p->grid.at[i]);
        axis_choose_neighbours(p, i);
    }
    return p;
}

void axis_planner_free(struct axis_planner *p)
{
    if (!p)
        return;
    access_free(p->access);
    sphere_grid_free(&p->grid);
    free(p->leaning);
    free(p->reached);
    free(p->beside);
    free(p);
}

void axis_planner_play(struct axis_planner *p, double play)
{
    p->options.play = play;
}

void axis_plan_free(struct axis_plan *plan)
{
    array_free(&plan->run);
    array_free(&plan->state);
}

static void plan_nodes(const struct work *w)
{
    const struct nodes *nodes = &w->nodes;

    for (size_t from = 0, to; from < nodes->n; from = to) {
        for (to = from; to < nodes->n && axis_nodes_has_axis(&nodes->item[to]); to++)
            ;
        if (to == from) {
            to++;
            continue;
        }
        axis_choose(w, from, to);
        for (size_t first = from, last; first < to; first = last) {
            for (last = first + 1; last < to && !nodes->item[last].begins; last++)
                ;
            axis_settle(w, first, last);
        }
    }
}

/* Of the points of the round before, of which *at is looked at next, the same pose; SIZE_MAX: none
 * was. */
static size_t same_pose(const struct axis_checks *before, size_t *at, double along,
                        const struct run_point *p)
{
    while (*at < before->n && before->item[*at].along < along)
        ++*at;
    if (*at == before->n || before->item[*at].along > along ||
        vec_distance(before->item[*at].ball, p->ball) > 0 ||
        vec_distance(before->item[*at].axis, p->axis) > 0)
        return SIZE_MAX;
    return *at;
}

/* The tool is clear on the way to the point, which has been found before if both ends were the
 * same. */
static bool is_way_clear(const struct holder_sweep *sweep, const struct run_point *p, double before,
                         double now, struct axis_checked *checked)
{
    if (!sweep->guard)
        return true;
    if (checked->way == WAY_UNKNOWN)
        checked->way =
            holder_sweep_clear_between(sweep, p - 1, before, p, now) ? WAY_CLEAR : WAY_BLOCKED;
    return checked->way == WAY_CLEAR;
}

/* The point as it was in the round before, or its clearance measured. */
static struct axis_checked check_pose(const struct work *w, const struct holder_sweep *sweep,
                                      size_t *at, size_t *last, double along,
                                      const struct run_point *p)
{
    const double far = 1; /* mm: clearances beyond are all the same */
    struct axis_checked checked = {.along = along, .ball = p->ball, .axis = p->axis};
    size_t same = same_pose(&w->checked, at, along, p);
    bool on = same != SIZE_MAX && *last != SIZE_MAX && same == *last + 1;

    *last = same;
    if (same == SIZE_MAX)
        checked.clear = sweep->guard ? holder_sweep_clearance(sweep, p, far) : far;
    else
        checked.clear = w->checked.item[same].clear;
    checked.way = on ? w->checked.item[same].way : WAY_UNKNOWN;
    return checked;
}

/* What becomes of the points; places where the tool is not clear get nodes, and then it returns
 * true, unless this is the last round. */
static bool check_points(struct work *w, const struct run *run, const struct doubles *along,
                         bool last, int *state)
{
    const struct axis_planner *p = w->planner;
    const double slack = p->options.tolerance / 2;
    const struct holder_sweep sweep = {p->options.guard, &p->options.holder, slack};
    double before = -1, now = 0;
    size_t after = 0, at = 0, nodes = w->nodes.n, same = 0, same_before = SIZE_MAX;
    struct axis_checks checks = {0};
    bool any = false;

    for (size_t i = 0; i < run->n; i++, before = now) {
        const struct run_point *b = &run->item[i];
        struct axis_checked *checked = array_push(&checks);
        *checked = check_pose(w, &sweep, &same, &same_before, along->item[i], b);
        now = checked->clear;
        while (at + 1 < nodes && w->nodes.item[at + 1].along <= along->item[i])
            at++;
        if (axis_points_without(w, nodes, at)) {
            state[i] = AXIS_PLAN_SKIP;
            now = -1;
            continue;
        }
        if ((p->options.fixed || p->options.chain.n == 1) && vec_dot(b->axis, b->normal) < -1e-6)
            now = -1; /* below the ball's equator, where a node beside it was not */
        if (!rotary_allows(&p->options.chain, b->axis))
            now = -1; /* out of the travel, which the axes of both nodes beside it are not */
        state[i] = now >= -slack ? AXIS_PLAN_CUT : AXIS_PLAN_SKIP;
        if (i > 0 && fmin(before, now) >= -slack &&
            (!rotary_reaches_between(&p->options.chain, b[-1].axis, b->axis) ||
             !is_way_clear(&sweep, b, before, now, checked)))
            state[i] = AXIS_PLAN_BREAK;
        if (state[i] == AXIS_PLAN_CUT || last)
            continue;
        while (after + 1 < w->run->n && w->along[after] < along->item[i])
            after++;
        axis_nodes_add_strict(w, after, along->item[i]);
        if (state[i] == AXIS_PLAN_BREAK)
            axis_nodes_add_strict(w, after, (along->item[i] + along->item[i - 1]) / 2);
        any = true;
    }
    array_free(&w->checked);
    w->checked = checks;
    return any;
}

static void measure(struct work *w)
{
    w->along = mem_alloc(w->run->n, sizeof *w->along);
    for (size_t i = 1; i < w->run->n; i++)
        w->along[i] =
            w->along[i - 1] + vec_distance(w->run->item[i - 1].ball, w->run->item[i].ball);
}

/* The run with the rule's axes averaged. */
static void average_rule(const struct work *w, struct run *averaged)
{
    const struct run *run = w->run;
    struct vec3 *rule = mem_alloc(run->n, sizeof *rule);

    for (size_t i = 0; i < run->n; i++)
        rule[i] = run->item[i].axis;
    axis_smooth_rules(run->item, run->n, w->planner->options.radius, w->planner->options.inward,
                      rule);
    averaged->radius = run->radius;
    for (size_t i = 0; i < run->n; i++) {
        struct run_point p = run->item[i];
        p.axis = rule[i];
        *array_push(averaged) = p;
    }
    free(rule);
}

static void append(struct axis_plan *plan, const struct run *from, const int *state,
                   const struct work *w)
{
    for (size_t i = 0; i < from->n; i++) {
        *array_push(&plan->run) = from->item[i];
        *array_push(&plan->state) = state[i];
    }
    for (size_t i = 0; i < w->nodes.n; i++)
        if (axis_nodes_has_axis(&w->nodes.item[i]) && !w->nodes.item[i].by_rule &&
            !w->nodes.item[i].pole)
            plan->leaned =
                fmax(plan->leaned, vec_angle(w->nodes.item[i].axis, w->nodes.item[i].rule));
}

void axis_plan_run(const struct axis_planner *planner, const struct run *run,
                   struct axis_plan *plan)
{
    struct work w = {.planner = planner, .run = run};
    struct run points = {.radius = run->radius}, averaged = {0};
    struct doubles along = {0};
    struct ints state = {0};
    bool again = run->n > 0;

    plan->run.radius = run->radius;
    if (run->n == 0)
        return;
    measure(&w);
    if (planner->options.play > 0) {
        average_rule(&w, &averaged);
        w.run = &averaged;
    }
    axis_nodes_first(&w);
    for (int round = 1; again; round++) {
        axis_nodes_sort(&w.nodes);
        for (size_t i = 0; i < w.nodes.n; i++)
            axis_nodes_find_open(planner, &w.nodes.item[i]);
        plan_nodes(&w);
        if (planner->options.between)
            axis_nodes_add_poles(&w);
        points.n = along.n = 0;
        axis_points_put(&w, &points, &along);
        array_reserve(&state, points.n);
        again = check_points(&w, &points, &along, round == ROUNDS, state.item);
    }
    append(plan, &points, state.item, &w);
    for (size_t i = 0; i < w.nodes.n; i++)
        free(w.nodes.item[i].state);
    array_free(&w.nodes);
    array_free(&points);
    array_free(&averaged);
    array_free(&along);
    array_free(&state);
    array_free(&w.checked);
    free(w.along);
}
