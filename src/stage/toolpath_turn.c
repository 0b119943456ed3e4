/* toolpath_turn - the lean at which rotary axes turn least; see toolpath.h. */
#include <stdlib.h>

#include "base/cli.h"
#include "base/parallel.h"
#include "machine/rotary_cost.h"
#include "stage/toolpath.h"

struct trial {
    const struct toolpath *t;
    double least, most; /* off the normal, radians */
    double *way;        /* of the rotary axes, by lean, radians */
};

/* The way of the rotary axes over all contacts, with the axis by this rule. */
static double way_by(const struct toolpath *t, const struct tool_axis_options *rule)
{
    struct vec3 before = {0, 0, 0};
    double way = 0;

    for (size_t i = 0; i < t->strip.n; i++) {
        const struct toolpath_strip *strip = &t->strip.item[i];
        for (size_t k = 0; k < strip->contact.n; k++) {
            struct contact c = strip->contact.item[k];
            struct vec3 centre = vec_along(c.p, strip->lift.offset, c.n);
            struct vec3 axis = tool_axis_at(rule, &strip->lift.feed, centre, c.n);
            if (i > 0 || k > 0)
                way += rotary_travel(before, axis);
            before = axis;
        }
    }
    return way;
}

static void try_leans(void *context, size_t from, size_t to)
{
    const struct trial *trial = context;

    for (size_t i = from; i < to; i++) {
        struct tool_axis_options rule = rotary_lean(trial->least, trial->most, (int)i);
        trial->way[i] = way_by(trial->t, &rule);
    }
}

void toolpath_turn(struct toolpath *t)
{
    const struct tool_axis_options *asked = &t->lift.axis;
    double least = atan(hypot(tan(asked->lead), tan(asked->tilt)));
    struct trial trial = {t, least, fmax(least, t->rule.turn), NULL};
    size_t n = (size_t)rotary_leans(trial.least, trial.most), best = 0;

    trial.way = mem_alloc(n, sizeof *trial.way);
    parallel_for(t->threads, n, try_leans, &trial);
    for (size_t i = 1; i < n; i++) /* a larger lean has to be worth it */
        if (trial.way[i] < (1 - 1e-6) * trial.way[best])
            best = i;
    double before = way_by(t, asked), now = trial.way[best];
    free(trial.way);
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
