/* toolpath_shorten - see toolpath_parts.h: rest parts in an order with shorter ways between. */
#include <stdlib.h>

#include "toolpath_parts.h"

enum {
    SWEEPS = 12,  /* over all pairs, at most */
    AWAY = 400,   /* parts in the order: no further from each other are looked at */
    TOGETHER = 3, /* parts at most that go to another place */
};

static const double OVER = 2; /* longest links: what a way over the clearance plane counts more */

/* Where a part begins and ends. */
struct part_ends {
    struct toolpath_part part;
    struct run_point from, to;
    bool turned; /* it is cut from its end */
};

struct shortener {
    const struct toolpath *t;
    double longest;
    struct part_ends *part; /* n + 1: the first is cut before them and stays */
    size_t n;
};

static double way_between(const struct shortener *s, const struct run_point *a,
                          const struct run_point *b)
{
    double way = toolpath_way(s->t, a, b);

    return vec_distance(a->ball, b->ball) > s->longest ? way + OVER * s->longest : way;
}

/* From the end of part i, or from its start, to part k, or to its end. */
static double way(const struct shortener *s, size_t i, bool from_start, size_t k, bool to_end)
{
    if (i > s->n || k > s->n)
        return 0;
    return way_between(s, from_start ? &s->part[i].from : &s->part[i].to,
                       to_end ? &s->part[k].to : &s->part[k].from);
}

static void turn_part(struct part_ends *p)
{
    struct run_point from = p->from;

    p->from = p->to;
    p->to = from;
    p->turned = !p->turned;
}

/* The parts i to k in the opposite order, each from its other end. */
static void turn_parts(struct shortener *s, size_t i, size_t k)
{
    for (; i < k; i++, k--) {
        struct part_ends p = s->part[i];
        s->part[i] = s->part[k];
        s->part[k] = p;
        turn_part(&s->part[i]);
        turn_part(&s->part[k]);
    }
    if (i == k)
        turn_part(&s->part[i]);
}

/* The parts i to k turned round where that makes ways shorter. */
static bool try_turn(struct shortener *s, size_t i, size_t k)
{
    double now = way(s, i - 1, false, i, false) + way(s, k, false, k + 1, false);
    double then = way(s, i - 1, false, k, true) + way(s, i, true, k + 1, false);

    if (!(then < now - 1e-6))
        return false;
    turn_parts(s, i, k);
    return true;
}

/* The parts i to k put behind part j > k, as they are or turned round. */
static bool try_move(struct shortener *s, size_t i, size_t k, size_t j)
{
    double now = way(s, i - 1, false, i, false) + way(s, k, false, k + 1, false) +
                 way(s, j, false, j + 1, false);
    double closed = way(s, i - 1, false, k + 1, false);
    double same = closed + way(s, j, false, i, false) + way(s, k, false, j + 1, false);
    double turned = closed + way(s, j, false, k, true) + way(s, i, true, j + 1, false);

    if (!(fmin(same, turned) < now - 1e-6))
        return false;
    size_t n = k - i + 1;
    turn_parts(s, i, j); /* both halves turned, then turned back */
    turn_parts(s, i, j - n);
    if (same <= turned)
        turn_parts(s, j - n + 1, j);
    return true;
}

/* What begins with part i, turned round or put elsewhere. */
static bool improve_at(struct shortener *s, size_t i)
{
    size_t last = i + AWAY < s->n ? i + AWAY : s->n;
    bool better = false;

    for (size_t k = i; k <= last; k++)
        better = try_turn(s, i, k) || better;
    for (size_t k = i; k < last && k < i + TOGETHER; k++)
        for (size_t j = k + 1; j <= last; j++)
            better = try_move(s, i, k, j) || better;
    return better;
}

static struct part_ends ends_of(const struct toolpath *t, const struct toolpath_part *part)
{
    struct run run = toolpath_part_run(t, part);

    return (struct part_ends){*part, run.item[0], run.item[run.n - 1], false};
}

/* The parts [from, to), after the one before them. */
static void shorten_parts(const struct toolpath *t, struct toolpath_part *part, size_t from,
                          size_t to)
{
    struct shortener s = {.t = t,
                          .longest = toolpath_link_options(t).longest,
                          .part = mem_alloc(to - from + 1, sizeof *s.part),
                          .n = to - from};

    for (size_t i = 0; i <= s.n; i++)
        s.part[i] = ends_of(t, &part[from - 1 + i]);
    bool better = true;
    for (int sweep = 0; sweep < SWEEPS && better; sweep++) {
        better = false;
        for (size_t i = 1; i <= s.n; i++)
            better = improve_at(&s, i) || better;
    }
    for (size_t i = 1; i <= s.n; i++) {
        part[from - 1 + i] = s.part[i].part;
        if (s.part[i].turned)
            toolpath_part_turn(t, &part[from - 1 + i]);
    }
    free(s.part);
}

void toolpath_shorten(const struct toolpath *t, struct toolpath_parts *parts)
{
    for (size_t from = 1, to; from < parts->n; from = to) {
        const struct toolpath_strip *strip = &t->strip.item[parts->item[from].strip];
        for (to = from + 1; strip->rest && to < parts->n; to++) {
            const struct toolpath_strip *next = &t->strip.item[parts->item[to].strip];
            if (!next->rest || next->lift.offset != strip->lift.offset)
                break;
        }
        if (strip->rest && to > from + 1)
            shorten_parts(t, parts->item, from, to);
    }
}
