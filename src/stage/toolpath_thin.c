/* toolpath_thin - see toolpath_parts.h: no two points in one place. */
#include "toolpath_parts.h"

static const double LINK_OFF = 0.01; /* of the radius: straight lines of a link off its way */
static const double LEAST = 0.021;   /* mm: the next block is read before a shorter one is over */

/* Leaves out of a part's points one of two that would be such blocks, where the path past it is
 * within the tolerance: what goes to and fro over so little is no shape of the surface. */
static void thin_part(const struct toolpath *t, const struct link_options *options,
                      struct toolpath_part *part)
{
    struct run run = toolpath_part_run(t, part);

    if (run.n < 3)
        return;
    struct run inner = {.n = run.n - 2, .item = run.item + 1, .radius = run.radius};
    link_thin(options, &run.item[0], &run.item[run.n - 1], LEAST, options->lift->tolerance, &inner);
    run.item[inner.n + 1] = run.item[run.n - 1];
    part->to = part->from + inner.n + 2;
}

/* Where a part begins so near to the end of the one before that the way there would be such a
 * block, it begins with its second point, or that one ends with its last but one. */
static void thin_joint(const struct link_options *options, const struct run *a, const struct run *b,
                       struct toolpath_part *part)
{
    const struct run_point *last = &a->item[a->n - 1];
    struct run first = {.n = 1, .item = b->item, .radius = b->radius};
    struct run end = {.n = 1, .item = a->item + a->n - 1, .radius = a->radius};

    if (b->n < 3 || a->n < 3 || part->link.n > 0 ||
        vec_distance(last->tip, b->item[0].tip) >= LEAST)
        return;
    link_thin(options, last, &b->item[1], LEAST, HUGE_VAL, &first);
    part->from += first.n == 0;
    if (first.n == 0)
        return;
    link_thin(options, &a->item[a->n - 2], &b->item[0], LEAST, HUGE_VAL, &end);
    part[-1].to -= end.n == 0;
}

/* A part that is no longer than such a block is its last point alone. */
static void thin_touch(const struct link_options *options, const struct run *a, const struct run *b,
                       struct toolpath_part *part)
{
    const struct run *way = part->link.n > 0 ? &part->link : a;
    struct run first = {.n = 1, .item = b->item, .radius = b->radius};

    if (b->n != 2 || vec_distance(b->item[0].tip, b->item[1].tip) >= LEAST)
        return;
    link_thin(options, &way->item[way->n - 1], &b->item[1], LEAST, HUGE_VAL, &first);
    part->from += first.n == 0;
}

/* A part that ends so near to its last point but one ends there, or goes on a little on its way to
 * the next. */
static void thin_end(const struct link_options *options, const struct run *a, const struct run *b,
                     struct toolpath_part *part)
{
    const struct run_point *next = part->link.n > 0 ? part->link.item : b->item;
    struct run end = {.n = 1, .item = a->item + a->n - 1, .radius = a->radius};

    if (a->n < 2 || vec_distance(end.item->tip, end.item[-1].tip) >= LEAST)
        return;
    link_thin(options, end.item - 1, next, LEAST, options->lift->tolerance, &end);
    part[-1].to -= end.n == 0;
}

void toolpath_thin(const struct toolpath *t, struct toolpath_parts *parts)
{
    struct link_options options = toolpath_link_options(t);

    for (size_t k = 0; k < parts->n && t->lift.guard; k++) {
        struct toolpath_part *part = &parts->item[k];
        options.lift = &t->strip.item[part->strip].lift;
        if (t->lift.between)
            thin_part(t, &options, part);
        struct run a = toolpath_part_run(t, k > 0 ? part - 1 : part),
                   b = toolpath_part_run(t, part);
        if (k > 0 && part->low && part->link.n > 0) {
            link_straighten(&options, &a.item[a.n - 1], &b.item[0], LINK_OFF * t->rule.radius,
                            &part->link);
            link_thin(&options, &a.item[a.n - 1], &b.item[0], LEAST, HUGE_VAL, &part->link);
        }
        if (k > 0 && part->low && t->lift.between) {
            thin_end(&options, &a, &b, part);
            a = toolpath_part_run(t, part - 1);
            thin_joint(&options, &a, &b, part);
            thin_touch(&options, &a, &b, part);
        }
    }
}
