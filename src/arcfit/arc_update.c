/* arc_update - see arc_update.h. */
#include "arcfit/arc_update.h"

#include <stdlib.h>

#include "arcspline_refit.h"

enum {
    MORE = 3,  /* arcs that may come in */
    LEAST = 6, /* pieces that are looked at anew: few have no room between two held directions, */
    MOST = 14  /* and for many it is quicker to begin again */
};

/* What has changed: points [from, to) of the old trace, and [from, to + shift) of the new one. */
struct change {
    size_t from, to;
    double shift;
};

/* Pieces [from, to) to be put anew. */
struct gap {
    size_t from, to;
};

struct gaps {
    size_t n, cap;
    struct gap *item;
};

static bool same_point(const struct trace *a, size_t i, const struct trace *b, size_t k)
{
    return vec_distance(a->p[i], b->p[k]) <= 0 && vec_distance(a->other[i], b->other[k]) <= 0 &&
           vec_distance(a->axis[i], b->axis[k]) <= 0;
}

/* The first change from point `from` on; false when there is none.  Where points came or went it
 * goes on to the last one that is not as it was. */
static bool next_change(const struct trace *old, const struct trace *now, size_t from,
                        struct change *change)
{
    size_t least = old->n < now->n ? old->n : now->n, last = 0, end;

    while (from < least && same_point(old, from, now, from))
        from++;
    if (from == least && old->n == now->n)
        return false;
    for (end = from; old->n == now->n && end < least && !same_point(old, end, now, end);)
        end++;
    while (last < least - from && same_point(old, old->n - 1 - last, now, now->n - 1 - last))
        last++;
    if (old->n != now->n)
        end = old->n - last;
    *change = (struct change){from, end, (double)now->n - (double)old->n};
    return true;
}

/* Where a place of the old trace is on the new one. */
static double moved(const struct change *c, double place)
{
    double from = (double)c->from - 1, to = (double)c->to;

    if (place <= from)
        return place;
    if (place >= to)
        return place + c->shift;
    return place + c->shift * (place - from) / (to - from);
}

/* The pieces to be put anew for a change; with the last ones where there is nothing between. */
static void add_gap(const struct change *c, const struct pieces *all, struct gaps *gaps)
{
    size_t from = 0, to = all->n;

    while (from < to && all->item[from].to <= (double)c->from - 1)
        from++;
    while (to > from && all->item[to - 1].from >= (double)c->to)
        to--;
    while (to - from < LEAST && to - from < all->n) {
        from -= from > 0;
        to += to < all->n;
    }
    while (gaps->n > 0 && gaps->item[gaps->n - 1].to >= from) { /* one with the last */
        struct gap last = gaps->item[--gaps->n];
        from = last.from < from ? last.from : from;
        to = last.to > to ? last.to : to;
    }
    *array_push(gaps) = (struct gap){from, to};
}

/* Appends as many pieces as the gap had, or a few more. */
static bool fill(const struct gap *gap, const struct pieces *all, struct arcspline_refit part,
                 struct pieces *pieces)
{
    struct pieces some = {0};
    bool good = false;

    part.old = all->item + gap->from;
    part.n = gap->to - gap->from;
    part.start_held = gap->from > 0;
    part.end_held = gap->to < all->n;
    for (size_t more = 0; part.n <= MOST && more <= MORE && !good; more++)
        good = arcspline_refit_fit(&part, part.n + more, &some);
    for (size_t i = 0; i < some.n; i++)
        *array_push(pieces) = some.item[i];
    array_free(&some);
    return good;
}

/* All pieces as they are on the new trace, and which of them to put anew. */
static void look(const struct trace *old, const struct trace *now, const struct pieces *before,
                 struct pieces *all, struct gaps *gaps)
{
    struct change change = {.to = 0};

    for (size_t i = 0; i < before->n; i++)
        *array_push(all) = before->item[i];
    while (next_change(old, now, change.to, &change)) {
        add_gap(&change, before, gaps);
        for (size_t i = 0; i < all->n && change.shift != 0; i++) {
            all->item[i].from = moved(&change, all->item[i].from);
            all->item[i].to = moved(&change, all->item[i].to);
        }
        if (change.shift != 0)
            return;
    }
}

bool arc_update(const struct trace *old, const struct trace *now,
                const struct arc_deviation *within, int digits, const struct pieces *before,
                struct pieces *pieces)
{
    struct arcspline_refit part = {.trace = now, .within = within, .digits = digits};
    struct pieces all = {0};
    struct gaps gaps = {0};
    size_t at = 0;
    bool good =
        before->n > 0 && same_point(old, 0, now, 0) && same_point(old, old->n - 1, now, now->n - 1);

    pieces->n = 0;
    if (good)
        look(old, now, before, &all, &gaps);
    for (size_t k = 0; k < gaps.n && good; k++) {
        for (; at < gaps.item[k].from; at++)
            *array_push(pieces) = all.item[at];
        good = fill(&gaps.item[k], &all, part, pieces);
        at = gaps.item[k].to;
    }
    for (; at < all.n; at++)
        *array_push(pieces) = all.item[at];
    array_free(&all);
    array_free(&gaps);
    return good;
}
