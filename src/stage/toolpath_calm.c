/* toolpath_calm - see toolpath_parts.h. */
#include <stdlib.h>

#include "base/parallel.h"
#include "gouge/axis_calm.h"
#include "toolpath_parts.h"

/* The axes by the rule at a part's points that touch. */
static struct vec3 *rules_of(const struct toolpath *t, const struct toolpath_part *part)
{
    const struct toolpath_strip *strip = &t->strip.item[part->strip];
    struct run run = toolpath_part_run(t, part);
    struct vec3 *rule = mem_alloc(run.n, sizeof *rule);

    for (size_t i = 0; i < run.n; i++)
        if (run_point_touches(&run.item[i]))
            rule[i] = tool_axis_at(&strip->lift.axis, &strip->lift.feed, run.item[i].ball,
                                   run.item[i].normal);
    return rule;
}

struct calmer {
    const struct toolpath *t;
    const struct toolpath_parts *parts;
    const struct sizes *end; /* of each chain of parts */
    int threads;             /* for each */
};

static void calm_chain(const struct calmer *c, size_t from, size_t to)
{
    const struct axis_calm_options options = {.guard = c->t->lift.guard,
                                              .holder = &c->t->rule.holder,
                                              .chain = c->t->rule.chain,
                                              .radius = c->t->rule.radius,
                                              .tolerance = c->t->lift.tolerance,
                                              .inward = toolpath_inward(c->t),
                                              .threads = c->threads};
    struct axis_calm_run *run = mem_alloc(2 * (to - from), sizeof *run);
    size_t n = 0;
    struct vec3 **rule = mem_alloc(to - from, sizeof *rule);

    for (size_t k = from; k < to; k++) {
        const struct toolpath_part *part = &c->parts->item[k];
        struct run points = toolpath_part_run(c->t, part);
        bool low = k > from && part->low;
        if (low && part->link.n > 0)
            run[n++] = (struct axis_calm_run){part->link.item, NULL, part->link.n, 0, true};
        rule[k - from] = rules_of(c->t, part);
        run[n++] =
            (struct axis_calm_run){points.item, rule[k - from], points.n,
                                   toolpath_play(c->t, c->t->strip.item[part->strip].rest), low};
    }
    axis_calm_chain(&options, run, n);
    for (size_t k = 0; k < to - from; k++)
        free(rule[k]);
    free(rule);
    free(run);
}

static void calm_chains(void *context, size_t from, size_t to)
{
    const struct calmer *c = context;

    for (size_t k = from; k < to; k++)
        calm_chain(c, k > 0 ? c->end->item[k - 1] : 0, c->end->item[k]);
}

void toolpath_calm(const struct toolpath *t, const struct toolpath_parts *parts, double longest)
{
    struct sizes end = {0};
    struct calmer calmer = {t, parts, &end, 1};

    if (!t->lift.guard || !(t->rule.play > 0) || t->rule.rate > 0 || t->rule.chain.n != 2 ||
        t->lift.axis.kind == AXIS_FIXED)
        return;
    for (size_t k = 0; k < parts->n; k++) {
        struct run a = toolpath_part_run(t, &parts->item[k]), b = a;
        if (k + 1 < parts->n)
            b = toolpath_part_run(t, &parts->item[k + 1]);
        bool joined =
            k + 1 < parts->n && vec_distance(a.item[a.n - 1].ball, b.item[0].ball) <= longest;
        if (!joined)
            *array_push(&end) = k + 1;
    }
    /* Few chains: the threads share each of them, else each takes some. */
    bool few = end.n < 8;
    calmer.threads = few ? t->threads : 1;
    parallel_for(few ? 1 : t->threads, end.n, calm_chains, &calmer);
    array_free(&end);
}
