/* toolpath_order - see toolpath_parts.h: parts of strips, slivers left out, one after the other. */
#include <stdlib.h>

#include "base/parallel.h"
#include "gouge/gouge.h"
#include "math/kdtree.h"
#include "toolpath_parts.h"

struct run toolpath_part_run(const struct toolpath *t, const struct toolpath_part *part)
{
    const struct run *all = &t->strip.item[part->strip].lifted.run;

    return (struct run){
        .n = part->to - part->from, .item = all->item + part->from, .radius = all->radius};
}

struct toolpath_parts toolpath_parts_of(const struct toolpath *t)
{
    struct toolpath_parts parts = {0};

    for (size_t k = 0; k < t->strip.n; k++) {
        const struct sizes *end = &t->strip.item[k].lifted.end;
        for (size_t i = 0, from = 0; i < end->n; from = end->item[i++])
            if (end->item[i] > from)
                *array_push(&parts) =
                    (struct toolpath_part){.strip = k, .from = from, .to = end->item[i]};
    }
    return parts;
}

/* ---- slivers */

/* As far as the ball goes, and as it cuts: in a groove hardly wider than itself it goes less. */
static double length_of(const struct run *run)
{
    const struct run_point *first = NULL; /* that touches */
    double length = 0, cut = 0;

    for (size_t i = 0; i < run->n; i++) {
        const struct run_point *p = &run->item[i];
        length += i > 0 ? vec_distance(p[-1].ball, p->ball) : 0;
        if (!run_point_touches(p))
            continue;
        first = first ? first : p;
        cut = fmax(cut, vec_distance(first->contact, p->contact));
    }
    return fmax(length, cut);
}

/* The ball's centre on all parts, close together, and whose it is. */
struct centres {
    struct vec3s at;
    struct sizes part;
};

static void add_centres(const struct run *run, size_t part, struct centres *centres)
{
    const double most = 0.5; /* mm apart */

    for (size_t i = 0; i < run->n; i++) {
        struct vec3 b = run->item[i].ball, a = i > 0 ? run->item[i - 1].ball : b;
        double n = fmax(1, ceil(vec_distance(a, b) / most));
        for (double k = 1; k <= n; k++) {
            *array_push(&centres->at) = vec_mix(a, b, k / n);
            *array_push(&centres->part) = part;
        }
    }
}

/* Another part that stays comes within `near` of the place. */
static bool is_cut_by_others(const struct toolpath_parts *parts, size_t part,
                             const struct centres *centres, const struct kdtree *tree,
                             struct vec3 place, double near, struct sizes *found)
{
    found->n = 0;
    kdtree_within(tree, place, near, found);
    for (size_t i = 0; i < found->n; i++) {
        size_t other = centres->part.item[found->item[i]];
        if (other != part && !parts->item[other].dropped)
            return true;
    }
    return false;
}

static bool is_sliver(const struct toolpath *t, const struct toolpath_parts *parts, size_t k,
                      const struct centres *centres, const struct kdtree *tree, struct sizes *found)
{
    const struct toolpath_part *part = &parts->item[k];
    struct run run = toolpath_part_run(t, part);
    double near = t->strip.item[part->strip].lift.offset + t->rule.scallop;

    if (length_of(&run) >= t->rule.radius)
        return false;
    for (size_t i = 0; i < run.n; i++)
        if (run_point_touches(&run.item[i]) &&
            !is_cut_by_others(parts, k, centres, tree, run.item[i].contact, near, found))
            return false;
    return true;
}

size_t toolpath_drop_slivers(const struct toolpath *t, struct toolpath_parts *parts)
{
    struct centres centres = {0};
    struct sizes found = {0};
    size_t dropped = 0;

    if (t->rule.scallop <= 0 || parts->n < 2)
        return 0;
    for (size_t k = 0; k < parts->n; k++) {
        struct run run = toolpath_part_run(t, &parts->item[k]);
        add_centres(&run, k, &centres);
    }
    struct kdtree *tree = kdtree_new_by(centres.at.item, centres.at.n, t->threads);
    for (size_t k = 0; k < parts->n; k++) {
        parts->item[k].dropped = is_sliver(t, parts, k, &centres, tree, &found);
        dropped += parts->item[k].dropped;
    }
    kdtree_free(tree);
    array_free(&centres.at);
    array_free(&centres.part);
    array_free(&found);
    return dropped;
}

/* ---- one after the other */

enum { PASSES_AWAY = 3 }; /* a neighbour's pass is no further from the last one's */

struct orderer {
    const struct toolpath *t;
    const struct toolpath_parts *parts;
    bool *done;
    size_t first; /* none before it is left */
};

static size_t pass_of(const struct orderer *o, size_t k)
{
    return o->t->strip.item[o->parts->item[k].strip].pass;
}

static double offset_of(const struct orderer *o, size_t k)
{
    return o->t->strip.item[o->parts->item[k].strip].lift.offset;
}

static bool is_rest(const struct orderer *o, size_t k)
{
    return o->t->strip.item[o->parts->item[k].strip].rest;
}

static const struct run_point *end_of(const struct orderer *o, size_t k, bool last)
{
    struct run run = toolpath_part_run(o->t, &o->parts->item[k]);

    return &run.item[last ? run.n - 1 : 0]; // cppcheck-suppress returnDanglingLifetime
}

static const double TURN = 2;   /* radii: what a radian that the axis turns counts as way */
static const double EASY = 0.5; /* radians: what a link turns on its way */

double toolpath_way(const struct toolpath *t, const struct run_point *a, const struct run_point *b)
{
    return vec_distance(a->ball, b->ball) + TURN * t->rule.radius * vec_angle(a->axis, b->axis);
}

/* How far it is from one place to another, mm, with the turn of the axis: along rows only beyond
 * what a link turns on its way; to a rest pass, which may be anywhere, all of it. */
static double way_to(const struct orderer *o, const struct run_point *a, const struct run_point *b,
                     bool rest)
{
    double angle = fmax(0, vec_angle(a->axis, b->axis) - EASY);

    return rest ? toolpath_way(o->t, a, b)
                : vec_distance(a->ball, b->ball) + TURN * o->t->rule.radius * angle;
}

/* Parts may be cut from either end. */
static bool may_turn(const struct orderer *o)
{
    return !o->t->rule.one_way && o->t->lift.axis.lead == 0;
}

/* The part, of this layer and a pass near by, that begins (or, turned round, ends) nearest to a
 * place within `reach`; parts->n if there is none.  After a rest pass it is the nearest of all
 * those, which have no order of their own. */
static size_t nearest_part(const struct orderer *o, size_t after, const struct run_point *place,
                           double reach, bool *turned)
{
    size_t best = o->parts->n, pass = pass_of(o, after);
    bool rest = is_rest(o, after);

    reach = rest ? HUGE_VAL : reach;

    for (size_t k = o->first; k < o->parts->n; k++) {
        size_t other = pass_of(o, k);
        if (other > pass + PASSES_AWAY && !rest)
            break;
        if (o->done[k] || (other + PASSES_AWAY < pass && !rest) || (rest && !is_rest(o, k)) ||
            offset_of(o, k) != offset_of(o, after))
            continue;
        for (int last = 0; last < (may_turn(o) ? 2 : 1); last++) {
            double away = way_to(o, place, end_of(o, k, last), rest);
            if (away >= reach)
                continue;
            reach = away;
            best = k;
            *turned = last;
        }
    }
    return best;
}

/* An end of one part is within `reach` of an end of the other. */
static bool are_near(const struct orderer *o, size_t a, size_t b, double reach)
{
    for (int i = 0; i < 4; i++)
        if (way_to(o, end_of(o, a, i & 1), end_of(o, b, i & 2), false) < reach)
            return true;
    return false;
}

/* No part is left near this one in the passes before it, or none in those after it. */
static bool is_end(const struct orderer *o, size_t k, double reach)
{
    bool before = false, after = false;
    size_t pass = pass_of(o, k), m = k;

    while (m > o->first && pass_of(o, m - 1) + PASSES_AWAY >= pass)
        m--;
    for (; m < o->parts->n && pass_of(o, m) <= pass + PASSES_AWAY && !(before && after); m++) {
        bool *side = pass_of(o, m) < pass ? &before : &after;
        if (!o->done[m] && !*side && pass_of(o, m) != pass && offset_of(o, k) == offset_of(o, m))
            *side = are_near(o, k, m, reach);
    }
    return !(before && after);
}

/* Where nothing goes on: the part that begins nearest to where the last one ended, of those at
 * which a region of passes begins or ends, so that none is begun in its middle. */
static size_t next_region(const struct orderer *o, const struct toolpath_part *last, double reach,
                          bool *turned)
{
    struct run run = toolpath_part_run(o->t, last);
    size_t best = o->first;
    double least = HUGE_VAL;

    for (size_t k = o->first; k < o->parts->n; k++) {
        if (o->done[k] || offset_of(o, k) != offset_of(o, o->first) ||
            is_rest(o, k) != is_rest(o, o->first))
            continue;
        for (int end = 0; end < (may_turn(o) ? 2 : 1); end++) {
            double away = way_to(o, &run.item[run.n - 1], end_of(o, k, end), true);
            if (away >= least || !is_end(o, k, reach))
                continue;
            least = away;
            best = k;
            *turned = end;
        }
    }
    return best;
}

void toolpath_part_turn(const struct toolpath *t, const struct toolpath_part *part)
{
    struct run run = toolpath_part_run(t, part);

    for (size_t i = 0, k = run.n; i + 1 < k; i++) {
        struct run_point p = run.item[i];
        run.item[i] = run.item[--k];
        run.item[k] = p;
    }
}

void toolpath_order(const struct toolpath *t, struct toolpath_parts *parts)
{
    struct orderer o = {.t = t, .parts = parts, .done = mem_alloc(parts->n + 1, sizeof(bool))};
    struct toolpath_parts ordered = {0};
    double reach = fmax(t->rule.longest, 2 * t->rule.radius);
    size_t next = parts->n;

    for (size_t k = 0; k < parts->n; k++)
        o.done[k] = parts->item[k].dropped;
    for (;;) {
        bool turned = false;
        while (o.first < parts->n && o.done[o.first])
            o.first++;
        if (o.first == parts->n)
            break;
        if (next < parts->n)
            next = nearest_part(&o, next, end_of(&o, next, true), reach, &turned);
        if (next == parts->n)
            next = ordered.n > 0 ? next_region(&o, &ordered.item[ordered.n - 1], reach, &turned)
                                 : o.first;
        if (turned)
            toolpath_part_turn(t, &parts->item[next]);
        *array_push(&ordered) = parts->item[next];
        o.done[next] = true;
    }
    bool turn = may_turn(&o);
    free(o.done);
    array_free(parts);
    *parts = ordered;
    if (turn)
        toolpath_shorten(t, parts);
}

/* ---- joined with the tool down */

/* The direction of the ball's path at the run's end, or at its start. */
static struct vec3 direction_at(const struct run *run, bool end)
{
    const double least = 0.05; /* mm */
    const struct run_point *p = &run->item[end ? run->n - 1 : 0];

    for (size_t i = 1; i < run->n; i++) {
        const struct run_point *q = &run->item[end ? run->n - 1 - i : i];
        if (vec_distance(p->ball, q->ball) > least)
            return vec_unit(vec_scale(end ? 1 : -1, vec_sub(p->ball, q->ball)));
    }
    return vec(0, 0, 0);
}

static void join_part(struct toolpath *t, const struct toolpath_part *before,
                      struct toolpath_part *part)
{
    struct run a = toolpath_part_run(t, before), b = toolpath_part_run(t, part);
    t->lift = t->strip.item[part->strip].lift;
    struct link_options options = toolpath_link_options(t);
    double longest = t->lift.guard ? options.longest : t->rule.longest;

    options.leave = direction_at(&a, true);
    options.arrive = direction_at(&b, false);
    part->link.radius = t->rule.radius;
    part->low = vec_distance(a.item[a.n - 1].ball, b.item[0].ball) <= longest &&
                link_low(&options, &a.item[a.n - 1], &b.item[0], &part->link);
}

struct joiner {
    const struct toolpath *t;
    struct toolpath_parts *parts;
};

static void join_parts(void *context, size_t from, size_t to)
{
    const struct joiner *j = context;
    struct toolpath t = *j->t;

    for (size_t k = from; k < to; k++)
        join_part(&t, &j->parts->item[k], &j->parts->item[k + 1]);
}

void toolpath_join(const struct toolpath *t, struct toolpath_parts *parts)
{
    struct joiner joiner = {t, parts};

    if (parts->n > 1)
        parallel_for(t->threads, parts->n - 1, join_parts, &joiner);
}

void toolpath_parts_free(struct toolpath_parts *parts)
{
    for (size_t k = 0; k < parts->n; k++)
        array_free(&parts->item[k].link);
    array_free(parts);
}
