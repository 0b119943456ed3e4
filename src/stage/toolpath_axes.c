/*
 * toolpath_axes - see toolpath_parts.h.  The lean of all strips; a strip lifted, its axes shaped,
 * and left out of it what the holder keeps the tool from.
 */
#include <stdlib.h>

#include "base/cli.h"
#include "base/parallel.h"
#include "gouge/axis_smooth.h"
#include "gouge/axis_plan.h"
#include "gouge/holder_sweep.h"
#include "machine/rotary_cost.h"
#include "toolpath/retrace.h"
#include "toolpath_parts.h"

/* ---- the lean at which rotary axes turn least */

struct lean_trial {
    const struct toolpath *t;
    double least, most; /* off the normal, radians */
    double *travel;     /* of the rotary axes, by lean, radians */
};

/* How far the rotary axes turn over all contacts, with the axis by this rule. */
static double travel_by(const struct toolpath *t, const struct tool_axis_options *rule)
{
    struct vec3 before = {0, 0, 0};
    double travel = 0;

    for (size_t i = 0; i < t->strip.n; i++) {
        const struct toolpath_strip *strip = &t->strip.item[i];
        for (size_t k = 0; k < strip->contact.n; k++) {
            struct contact c = strip->contact.item[k];
            struct vec3 centre = vec_along(c.p, strip->lift.offset, c.n);
            struct vec3 axis = tool_axis_at(rule, &strip->lift.feed, centre, c.n);
            if (i > 0 || k > 0)
                travel += rotary_travel(before, axis);
            before = axis;
        }
    }
    return travel;
}

static void try_leans(void *context, size_t from, size_t to)
{
    const struct lean_trial *trial = context;

    for (size_t i = from; i < to; i++) {
        struct tool_axis_options rule = rotary_lean(trial->least, trial->most, (int)i);
        rule.circle = trial->t->lift.axis.circle;
        trial->travel[i] = travel_by(trial->t, &rule);
    }
}

void toolpath_choose_lean(struct toolpath *t)
{
    const struct tool_axis_options *asked = &t->lift.axis;
    double least = atan(hypot(tan(asked->lead), tan(asked->tilt)));
    struct lean_trial trial = {t, least, fmax(least, t->rule.turn), NULL};
    size_t n = (size_t)rotary_leans(trial.least, trial.most), best = 0;

    trial.travel = mem_alloc(n, sizeof *trial.travel);
    parallel_for(t->threads, n, try_leans, &trial);
    for (size_t i = 1; i < n; i++) /* a larger lean has to be worth it */
        if (trial.travel[i] < (1 - 1e-6) * trial.travel[best])
            best = i;
    double before = travel_by(t, asked), now = trial.travel[best];
    free(trial.travel);
    if (now < before) {
        struct tool_axis_options rule = rotary_lean(trial.least, trial.most, (int)best);
        rule.circle = asked->circle;
        t->lift.axis = rule;
        for (size_t i = 0; i < t->strip.n; i++)
            t->strip.item[i].lift.axis = rule;
    }
    say("lead %.1f, tilt %.1f: rotary axes turn %.0f degrees over the rows (as asked: %.0f)",
        DEGREES(t->lift.axis.lead), DEGREES(t->lift.axis.tilt), DEGREES(fmin(now, before)),
        DEGREES(before));
}

/* ---- a strip lifted, its axes planned */

static const double ROUNDED = 0.999; /* of the rate: the rest goes to the printed digits */

/* Averages the axes of a run until none turns faster than may be; a point where the tool is not
 * clear any more is skipped. */
static void limit_rate(const struct toolpath *t, struct run *run, int *state)
{
    const struct gouge_check *guard = t->lift.guard;
    const double slack = t->lift.tolerance / 2;
    const struct holder_sweep sweep = {guard, &t->rule.holder, slack};

    if (!(t->rule.rate > 0) || axis_smooth_rate(run, ROUNDED * t->rule.rate) == 0 || !guard)
        return;
    for (size_t i = 0; i < run->n; i++) {
        const struct run_point *p = &run->item[i];
        if (!gouge_holder_clear(guard, &t->rule.holder, p->ball, p->axis, -slack, NULL))
            state[i] = AXIS_PLAN_SKIP;
        else if (i > 0 && state[i] == AXIS_PLAN_CUT && !holder_sweep_clear(&sweep, p - 1, p))
            state[i] = AXIS_PLAN_BREAK;
    }
}

/* The same over the parts of a plan that are cut in one go. */
static void limit_rates(const struct toolpath *t, struct axis_plan *plan)
{
    for (size_t from = 0, to; from < plan->run.n; from = to) {
        for (to = from + 1; to < plan->run.n && plan->state.item[to] == AXIS_PLAN_CUT &&
                            plan->state.item[to - 1] != AXIS_PLAN_SKIP;
             to++)
            ;
        struct run part = {
            .n = to - from, .item = plan->run.item + from, .radius = plan->run.radius};
        if (plan->state.item[from] != AXIS_PLAN_SKIP)
            limit_rate(t, &part, plan->state.item + from);
    }
}

/* Appends what is cut of a plan to the strip, in as many parts as it is. */
static void take_plan(struct toolpath_strip *strip, const struct axis_plan *plan,
                      struct lifted_strip *to)
{
    for (size_t i = 0; i < plan->run.n; i++) {
        const struct run_point *p = &plan->run.item[i];
        int state = plan->state.item[i];
        size_t begin = to->end.n > 0 ? to->end.item[to->end.n - 1] : 0;
        if (state != AXIS_PLAN_CUT && to->run.n > begin)
            *array_push(&to->end) = to->run.n;
        if (state != AXIS_PLAN_SKIP) {
            *array_push(&to->run) = *p;
            continue;
        }
        if (i > 0)
            strip->skipped_length += vec_distance(p->ball, plan->run.item[i - 1].ball);
        if (strip->skipped++ == 0)
            strip->skipped_at = run_point_touches(p) ? p->contact : p->ball;
    }
    if (to->run.n > (to->end.n > 0 ? to->end.item[to->end.n - 1] : 0))
        *array_push(&to->end) = to->run.n;
    strip->leaned = fmax(strip->leaned, plan->leaned);
}

/* The axes of all parts of the strip. */
static void plan_axes(const struct toolpath *t, struct toolpath_strip *strip)
{
    struct lifted_strip *lifted = &strip->lifted, planned = {.run.radius = lifted->run.radius};

    for (size_t k = 0, from = 0; k < lifted->end.n; from = lifted->end.item[k++]) {
        struct run part = {.n = lifted->end.item[k] - from,
                           .item = lifted->run.item + from,
                           .radius = lifted->run.radius};
        struct axis_plan plan = {.leaned = 0};
        axis_plan_run(t->planner, &part, &plan);
        limit_rates(t, &plan);
        take_plan(strip, &plan, &planned);
        axis_plan_free(&plan);
    }
    array_free(&lifted->run);
    array_free(&lifted->end);
    lifted->run = planned.run;
    lifted->end = planned.end;
}

/* The largest distance between straight lines and the smooth curve, over the parts of [from, to)
 * that touch: what a fitter would take out. */
static double chord_of(const struct run *run, size_t from, size_t to)
{
    double chord = 0;

    for (size_t i = from; i < to; i++) {
        size_t begin = i;
        while (i < to && vec_length(run->item[i].normal) > 0)
            i++;
        struct run touching = {.n = i - begin, .item = run->item + begin, .radius = run->radius};
        struct run smooth = {.radius = run->radius};
        chord = fmax(chord, run_densify(&touching, run->radius, &smooth));
        array_free(&smooth);
    }
    return chord;
}

double toolpath_play(const struct toolpath *t, bool rest)
{
    const double more = 2;

    return rest ? more * t->rule.play : t->rule.play;
}

double toolpath_inward(const struct toolpath *t)
{
    const double most = RADIANS(10);

    return t->lift.axis.lead != 0 ? 0 : most;
}

struct axis_planner *toolpath_new_planner(const struct toolpath *t)
{
    const struct axis_planner_options options = {.guard = t->lift.guard,
                                                 .radius = t->rule.radius,
                                                 .holder = t->rule.holder,
                                                 .chain = t->rule.chain,
                                                 .tolerance = t->lift.tolerance,
                                                 .between = t->lift.between,
                                                 .fixed = t->lift.axis.kind == AXIS_FIXED,
                                                 .play = t->rule.play,
                                                 .limit = t->rule.lean,
                                                 .inward = toolpath_inward(t),
                                                 .threads = t->threads};

    bool bare = t->rule.holder.n == 0 && t->rule.play == 0 && t->rule.rate == 0;
    if (!t->lift.guard || (bare && !options.fixed))
        return NULL;
    return axis_planner_new(&options);
}

/* Cuts off the loops of a strip where the ball does not fit, and single places thrown up. */
static void remove_loops(const struct toolpath *t, struct toolpath_strip *strip)
{
    const double gap = 0.1, longest = 10; /* radii */
    const struct gouge_lift_options *lift = &strip->lift;
    const struct retrace_options options = {.offset = lift->offset,
                                            .tolerance = lift->tolerance,
                                            .gap = gap * t->rule.radius,
                                            .longest = longest * t->rule.radius,
                                            .guard = lift->guard};

    if (lift->between && lift->guard) {
        retrace_remove(&strip->lifted, &options);
        retrace_hooks(&strip->lifted, &options);
        retrace_spikes(&strip->lifted, &options);
    }
}

void toolpath_lift_strip(const struct toolpath *t, struct toolpath_strip *strip)
{
    struct lifted_strip *lifted = &strip->lifted;
    struct run nodes = {.radius = t->rule.radius};

    for (size_t i = 0; i < strip->contact.n; i++)
        gouge_lift_contact(&nodes, &strip->lift, strip->contact.item[i].p,
                           strip->contact.item[i].n);
    lifted->run.radius = nodes.radius;
    gouge_lift_run(&nodes, &strip->lift, lifted);
    array_free(&nodes);
    remove_loops(t, strip);
}

void toolpath_plan_strip(const struct toolpath *t, struct toolpath_strip *strip)
{
    struct lifted_strip *lifted = &strip->lifted;
    size_t from = 0;

    if (t->planner)
        plan_axes(t, strip);
    /* Points put between them lie on the smooth path. */
    for (size_t k = 0; !strip->lift.between && k < lifted->end.n; k++) {
        strip->chord = fmax(strip->chord, chord_of(&lifted->run, from, lifted->end.item[k]));
        from = lifted->end.item[k];
    }
}
