/*
 * toolpath_axes - see toolpath_parts.h.  The lean of all strips; a strip lifted, its axes shaped,
 * and left out of it what the holder keeps the tool from.
 */
#include <stdlib.h>

#include "base/cli.h"
#include "base/parallel.h"
#include "gouge/axis_smooth.h"
#include "gouge/holder_avoid.h"
#include "machine/rotary_cost.h"
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
        t->lift.axis = rule;
        for (size_t i = 0; i < t->strip.n; i++)
            t->strip.item[i].lift.axis = rule;
    }
    say("lead %.1f, tilt %.1f: rotary axes turn %.0f degrees over the rows (as asked: %.0f)",
        DEGREES(t->lift.axis.lead), DEGREES(t->lift.axis.tilt), DEGREES(fmin(now, before)),
        DEGREES(before));
}

/* ---- a strip lifted, its axes smoothed and leaned away from the part */

static const double SLACK = 0.01;    /* mm: guard points may be in the holder by so much */
static const double ROUNDED = 0.999; /* of the rate: the rest goes to the printed digits */

/* Axes of the points [from, to), smoothed and leaned; touches[] becomes true where the holder keeps
 * the tool out. */
static void shape_axes(const struct toolpath *t, struct toolpath_strip *strip, size_t from,
                       size_t to, bool *touches)
{
    const struct run *all = &strip->lifted.run;
    struct run run = {.n = to - from, .item = all->item + from, .radius = all->radius};
    struct holder_avoid_options rule = {strip->lift.guard, &t->rule.holder, t->rule.lean, SLACK};
    bool has_holder = rule.guard && rule.holder->n > 0;

    if (t->rule.play > 0)
        axis_smooth_play(&run, t->rule.play);
    if (has_holder)
        strip->leaned = fmax(strip->leaned, holder_avoid(&rule, &run, touches + from));
    if (t->rule.rate > 0 && axis_smooth_rate(&run, ROUNDED * t->rule.rate) > 0 && has_holder) {
        rule.limit = 0; /* looks again, leans no more */
        holder_avoid(&rule, &run, touches + from);
    }
}

/* The parts of the strip without the points that touch; a part ends before them. */
static void skip_points(struct toolpath_strip *strip, const bool *touches)
{
    struct lifted_strip *lifted = &strip->lifted;
    struct sizes end = {0};
    size_t kept = 0, part = 0;

    for (size_t i = 0; i < lifted->run.n; i++) {
        if (i == lifted->end.item[part]) {
            *array_push(&end) = kept;
            part++;
        }
        if (touches[i]) {
            if (strip->skipped++ == 0)
                strip->skipped_at = lifted->run.item[i].contact;
            *array_push(&end) = kept;
            continue;
        }
        lifted->run.item[kept++] = lifted->run.item[i];
    }
    *array_push(&end) = kept;
    lifted->run.n = kept;
    array_free(&lifted->end);
    lifted->end = end;
}

/* Puts points on the straight lines between those further apart than this, for the axes to lean. */
static void refine_for_lean(struct lifted_strip *lifted)
{
    const double most = 0.5; /* mm */
    struct run fine = {.radius = lifted->run.radius};
    size_t part = 0;

    for (size_t i = 0; i < lifted->run.n; i++) {
        const struct run_point *b = &lifted->run.item[i], *a = b - 1;
        bool begins = i == 0 || i == lifted->end.item[part];
        for (; i > 0 && i == lifted->end.item[part]; part++)
            lifted->end.item[part] = fine.n;
        double parts = begins ? 1 : ceil(vec_distance(a->ball, b->ball) / most);
        for (double k = 1; k < parts; k++) {
            struct run_point p = {.ball = vec_mix(a->ball, b->ball, k / parts),
                                  .axis = vec_slerp(a->axis, b->axis, k / parts)};
            if (vec_length(a->normal) > 0 && vec_length(b->normal) > 0) {
                p.normal = vec_slerp(a->normal, b->normal, k / parts);
                p.contact = vec_mix(a->contact, b->contact, k / parts);
            }
            p.tip = vec_along(p.ball, -fine.radius, p.axis);
            *array_push(&fine) = p;
        }
        *array_push(&fine) = *b;
    }
    for (; part < lifted->end.n; part++)
        lifted->end.item[part] = fine.n;
    array_free(&lifted->run);
    lifted->run = fine;
}

static void shape_strip(const struct toolpath *t, struct toolpath_strip *strip)
{
    const struct sizes *end = &strip->lifted.end;
    bool any = false;

    if (t->rule.holder.n > 0)
        refine_for_lean(&strip->lifted);
    size_t n = strip->lifted.run.n;
    bool *touches = mem_alloc(n + 1, sizeof *touches);

    for (size_t i = 0; i < n; i++)
        touches[i] = false;
    for (size_t k = 0, from = 0; k < end->n; from = end->item[k++])
        shape_axes(t, strip, from, end->item[k], touches);
    for (size_t i = 0; i < n; i++)
        any = any || touches[i];
    if (any)
        skip_points(strip, touches);
    free(touches);
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

void toolpath_lift_strip(const struct toolpath *t, struct toolpath_strip *strip)
{
    struct lifted_strip *lifted = &strip->lifted;
    struct run nodes = {.radius = t->rule.radius};
    size_t from = 0;

    for (size_t i = 0; i < strip->contact.n; i++)
        gouge_lift_contact(&nodes, &strip->lift, strip->contact.item[i].p,
                           strip->contact.item[i].n);
    lifted->run.radius = nodes.radius;
    gouge_lift_run(&nodes, &strip->lift, lifted);
    array_free(&nodes);
    shape_strip(t, strip);
    /* Points put between them lie on the smooth path. */
    for (size_t k = 0; !strip->lift.between && k < lifted->end.n; k++) {
        strip->chord = fmax(strip->chord, chord_of(&lifted->run, from, lifted->end.item[k]));
        from = lifted->end.item[k];
    }
}
