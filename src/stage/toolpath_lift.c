/* toolpath_lift - a strip lifted, its axes made calm and leaned away from the part; see toolpath.h.
 */
#include <stdlib.h>

#include "gouge/axis_smooth.h"
#include "gouge/holder_avoid.h"
#include "stage/toolpath.h"

static const double SLACK = 0.01;    /* mm: guard points may be in the holder by so much */
static const double ROUNDED = 0.999; /* of the rate: the rest goes to the printed digits */

/* Axes of the points [from, to): touches[] of those that the holder keeps the tool from. */
static void shape(const struct toolpath *t, struct toolpath_strip *strip, size_t from, size_t to,
                  bool *touches)
{
    const struct run *all = &strip->lifted.run;
    struct run run = {.n = to - from, .item = all->item + from, .radius = all->radius};
    struct holder_avoid_options rule = {strip->lift.guard, &t->rule.holder, t->rule.lean, SLACK};
    bool holds = rule.guard && rule.holder->n > 0;

    if (t->rule.play > 0)
        axis_smooth_play(&run, t->rule.play);
    if (holds)
        strip->leaned = fmax(strip->leaned, holder_avoid(&rule, &run, touches + from));
    if (t->rule.rate > 0 && axis_smooth_rate(&run, ROUNDED * t->rule.rate) > 0 && holds) {
        rule.limit = 0; /* looks again, leans no more */
        holder_avoid(&rule, &run, touches + from);
    }
}

/* The pieces of the strip without the points that touch; a piece ends before them. */
static void leave_out(struct toolpath_strip *strip, const bool *touches)
{
    struct gouge_strip *lifted = &strip->lifted;
    struct sizes end = {0};
    size_t kept = 0, piece = 0;

    for (size_t i = 0; i < lifted->run.n; i++) {
        if (i == lifted->end.item[piece]) {
            *array_push(&end) = kept;
            piece++;
        }
        if (touches[i]) {
            if (strip->held++ == 0)
                strip->held_at = lifted->run.item[i].contact;
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
static void fill(struct gouge_strip *lifted)
{
    const double most = 0.5; /* mm */
    struct run fine = {.radius = lifted->run.radius};
    size_t piece = 0;

    for (size_t i = 0; i < lifted->run.n; i++) {
        const struct run_point *b = &lifted->run.item[i], *a = b - 1;
        bool begins = i == 0 || i == lifted->end.item[piece];
        for (; i > 0 && i == lifted->end.item[piece]; piece++)
            lifted->end.item[piece] = fine.n;
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
    for (; piece < lifted->end.n; piece++)
        lifted->end.item[piece] = fine.n;
    array_free(&lifted->run);
    lifted->run = fine;
}

static void shape_all(const struct toolpath *t, struct toolpath_strip *strip)
{
    const struct sizes *end = &strip->lifted.end;
    bool any = false;

    if (t->rule.holder.n > 0)
        fill(&strip->lifted);
    size_t n = strip->lifted.run.n;
    bool *touches = mem_alloc(n + 1, sizeof *touches);

    for (size_t i = 0; i < n; i++)
        touches[i] = false;
    for (size_t k = 0, from = 0; k < end->n; from = end->item[k++])
        shape(t, strip, from, end->item[k], touches);
    for (size_t i = 0; i < n; i++)
        any = any || touches[i];
    if (any)
        leave_out(strip, touches);
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
        struct run part = {.n = i - begin, .item = run->item + begin, .radius = run->radius};
        struct run smooth = {.radius = run->radius};
        chord = fmax(chord, run_densify(&part, run->radius, &smooth));
        array_free(&smooth);
    }
    return chord;
}

void toolpath_lift(const struct toolpath *t, struct toolpath_strip *strip)
{
    struct gouge_strip *lifted = &strip->lifted;
    struct run nodes = {.radius = t->rule.radius};
    size_t from = 0;

    for (size_t i = 0; i < strip->contact.n; i++)
        gouge_strip_add(&nodes, &strip->lift, strip->contact.item[i].p, strip->contact.item[i].n);
    lifted->run.radius = nodes.radius;
    gouge_strip_lift(&nodes, &strip->lift, lifted);
    array_free(&nodes);
    shape_all(t, strip);
    /* Points put between them lie on the smooth path. */
    for (size_t k = 0; !strip->lift.between && k < lifted->end.n; k++) {
        strip->chord = fmax(strip->chord, chord_of(&lifted->run, from, lifted->end.item[k]));
        from = lifted->end.item[k];
    }
}
