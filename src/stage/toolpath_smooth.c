/* toolpath_smooth - see toolpath_parts.h: centres raised where there is room. */
#include <stdlib.h>

#include "base/cli.h"
#include "base/parallel.h"
#include "gouge/lift_smooth.h"
#include "math/kdtree.h"
#include "toolpath/coverage.h"
#include "toolpath_parts.h"

/* Of the radius: how far along its row a centre asks what room there is, and where no point that is
 * to be cut tells, how far it goes on asking. */
static const double NEAR = 0.1, FAR = 0.5;

/* Scallops: on a point under one row the next leaves four. */
static const double BESIDE = 5;

/* The centres of rows that were lifted together, those of each strip from first[] on. */
struct rows {
    struct toolpath *t;
    size_t strip; /* the first */
    struct sizes first;
    struct vec3s centre;
    double *room; /* of each centre, mm; infinite: nothing is known */
};

static struct toolpath_strip *strip_of(const struct rows *r, size_t i)
{
    return &r->t->strip.item[r->strip + i];
}

static void spread_strips(void *context, size_t from, size_t to)
{
    const struct rows *r = context;

    for (size_t i = from; i < to; i++)
        lift_smooth_spread(&strip_of(r, i)->lifted, &strip_of(r, i)->lift);
}

/* Rows of an upper layer leave on the part what they are to leave: their centres tell nothing. */
static void collect_centres(struct rows *r)
{
    size_t n = r->t->strip.n - r->strip;

    for (size_t i = 0; i < n; i++) {
        const struct run *run = &strip_of(r, i)->lifted.run;
        *array_push(&r->first) = r->centre.n;
        for (size_t k = 0; k < run->n; k++)
            *array_push(&r->centre) = run->item[k].ball;
    }
    *array_push(&r->first) = r->centre.n;
    r->room = mem_alloc(r->centre.n + 1, sizeof *r->room);
    for (size_t k = 0; k < r->centre.n; k++)
        r->room[k] = HUGE_VAL;
}

/* Rows side by side are in different ones of so many groups. */
enum { GROUPS = 3 };

/* The centres of every third pass. */
struct row_group {
    struct vec3s centre;
    struct sizes index; /* among all */
    struct kdtree *tree;
};

static void group_rows(const struct rows *r, struct row_group group[GROUPS])
{
    for (size_t i = 0; i + 1 < r->first.n; i++) {
        struct row_group *g = &group[strip_of(r, i)->pass % GROUPS];
        for (size_t k = r->first.item[i]; k < r->first.item[i + 1]; k++) {
            *array_push(&g->centre) = r->centre.item[k];
            *array_push(&g->index) = k;
        }
    }
    for (int i = 0; i < GROUPS; i++)
        group[i].tree = kdtree_new_by(group[i].centre.item, group[i].centre.n, r->t->threads);
}

static void free_groups(struct row_group group[GROUPS])
{
    for (int i = 0; i < GROUPS; i++) {
        array_free(&group[i].centre);
        array_free(&group[i].index);
        kdtree_free(group[i].tree);
    }
}

/* The points that are to be cut; what stays on each, and under which centre. */
struct cut_points {
    const struct rows *rows;
    const struct row_group *group;
    const struct coverage_point *point;
    size_t *centre; /* SIZE_MAX: none comes near it */
    double *left, *crest;
};

/* What stays where two rows meet that leave so much on a point between them: each grows with the
 * square of the way from its row, whatever the surface's curvature. */
static double crest_between(double left, double other)
{
    double sum = sqrt(fmax(left, 0)) + sqrt(fmax(other, 0));

    return fmax(left, sum * sum / 4);
}

/* How far a point is from the nearest centre and from the nearest of another row, mm; `within`:
 * none is as near. */
struct nearest_rows {
    double near, other;
    size_t centre;
};

static struct nearest_rows rows_near(const struct row_group *group, struct vec3 p, double within)
{
    struct nearest_rows n = {within, within, SIZE_MAX};

    for (int k = 0; k < GROUPS; k++) {
        size_t at = SIZE_MAX;
        double far = kdtree_nearest_segment(group[k].tree, p, p, n.other, &at);
        if (far < n.near)
            n = (struct nearest_rows){far, n.near, group[k].index.item[at]};
        else
            n.other = far;
    }
    return n;
}

static void measure_points(void *context, size_t from, size_t to)
{
    const struct cut_points *c = context;
    const struct toolpath_options *rule = &c->rows->t->rule;
    const double within = rule->radius + BESIDE * rule->scallop;

    for (size_t i = from; i < to; i++) {
        struct nearest_rows n = rows_near(c->group, c->point[i].p, within);
        double left = n.near - rule->radius, other = n.other - rule->radius;
        c->centre[i] = n.centre;
        c->left[i] = left;
        c->crest[i] = n.other < within ? crest_between(left, other) : left;
    }
}

/* What a point leaves room for under the centre that comes nearest to it, where it is and where
 * that row and the next meet: there may be no point.  More than twice the scallop stays on it: a
 * ball does not get there. */
static void find_room(struct rows *r)
{
    const struct toolpath *t = r->t;
    struct row_group group[GROUPS] = {0};
    size_t n;
    struct cut_points c = {r, group, coverage_points(t->coverage, &n), NULL, NULL, NULL};

    group_rows(r, group);
    c.centre = mem_alloc(n + 1, sizeof *c.centre);
    c.left = mem_alloc(n + 1, sizeof *c.left);
    c.crest = mem_alloc(n + 1, sizeof *c.crest);
    parallel_for(t->threads, n, measure_points, &c);
    for (size_t i = 0; i < n; i++)
        if (c.centre[i] != SIZE_MAX && c.left[i] < 2 * t->rule.scallop)
            r->room[c.centre[i]] = fmin(r->room[c.centre[i]], t->rule.scallop - c.crest[i]);
    free(c.centre);
    free(c.left);
    free(c.crest);
    free_groups(group);
}

/* The least room of centres no further than `reach` along the row. */
static double room_within(const struct rows *r, size_t k, size_t from, size_t to, double reach)
{
    const struct vec3 *c = r->centre.item;
    double room = r->room[k], way = 0;

    for (size_t i = k; i > from && (way += vec_distance(c[i], c[i - 1])) <= reach; i--)
        room = fmin(room, r->room[i - 1]);
    way = 0;
    for (size_t i = k; i + 1 < to && (way += vec_distance(c[i], c[i + 1])) <= reach; i++)
        room = fmin(room, r->room[i + 1]);
    return room;
}

static double room_at(const struct rows *r, size_t k, size_t from, size_t to)
{
    const struct toolpath_options *rule = &r->t->rule;
    double room = room_within(r, k, from, to, NEAR * rule->radius);

    if (isinf(room))
        room = room_within(r, k, from, to, FAR * rule->radius);
    if (isinf(room))
        return rule->smooth;
    return room < -rule->full ? 0 : fmax(rule->smooth, fmin(room, rule->raise));
}

static void raise_strips(void *context, size_t from, size_t to)
{
    const struct rows *r = context;

    for (size_t i = from; i < to; i++) {
        struct toolpath_strip *strip = strip_of(r, i);
        size_t begin = r->first.item[i], end = r->first.item[i + 1];
        double *room = mem_alloc(end - begin + 1, sizeof *room);
        bool known = r->t->rule.raise > 0 && strip->lift.offset == r->t->rule.radius;
        for (size_t k = begin; k < end; k++)
            room[k - begin] = known ? room_at(r, k, begin, end) : r->t->rule.smooth;
        lift_smooth_raise(&strip->lifted, &strip->lift, room);
        free(room);
    }
}

void toolpath_smooth(struct toolpath *t, size_t first)
{
    struct rows r = {.t = t, .strip = first};

    if (t->rest || first == t->strip.n || !t->lift.guard || !t->lift.between ||
        !(t->rule.smooth > 0))
        return;
    size_t n = t->strip.n - first;
    parallel_for(t->threads, n, spread_strips, &r);
    collect_centres(&r);
    if (t->rule.raise > 0 && t->coverage)
        find_room(&r);
    parallel_for(t->threads, n, raise_strips, &r);
    free(r.room);
    array_free(&r.centre);
    array_free(&r.first);
}
