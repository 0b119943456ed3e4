/* row_simplify - see adaptive_rows_steps.h. */
#include "adaptive_rows_steps.h"

#include <stdlib.h>

#include "math/elementary.h"
#include "math/quadric.h"

/* The points along a line, in the grid's axes. */
struct candidates {
    struct vec3s point;
    struct ints col;
    bool *taken, *near; /* near: a crease or wall is */
};

/* From the grid's axes back to the scan's. */
static struct vec3 turn_back(const struct plan_extent *f, double x, double y)
{
    return vec(f->cosine * x - f->sine * y, f->sine * x + f->cosine * y, 0);
}

/* Puts a place at the height of the point nearest to it seen from above, the upper one of two;
 * false when that is farther than `reach`. */
static bool nearest_height(const struct point_grid *b, struct vec3 *at, double reach)
{
    double least = reach * reach;
    bool found = false;
    size_t c0 = point_grid_column(b, at->x - reach), c1 = point_grid_column(b, at->x + reach);
    size_t r0 = point_grid_row(b, at->y - reach), r1 = point_grid_row(b, at->y + reach);
    for (size_t r = r0; r <= r1; r++)
        for (uint32_t i = b->first[r * b->columns + c0]; i < b->first[r * b->columns + c1 + 1];
             i++) {
            struct vec3 d = vec_sub(b->point[i], *at);
            double d2 = d.x * d.x + d.y * d.y;
            if (d2 < least || (found && d2 <= least && d.z > 0)) {
                least = d2;
                at->z = b->point[i].z;
                found = true;
            }
        }
    return found;
}

/* The surface over (x, y) of the grid's axes, from a quadric through the nearest points, few of
 * them where it bends; where that is off them (an edge), the point nearest there.  False where
 * there are none within `reach`. */
static bool surface_at(const struct point_grid *b, const struct plan_extent *f, double x, double y,
                       double reach, double tolerance, struct vec3 *found)
{
    static const size_t count[] = {20, 40, 80, 10};
    enum { COUNTS = 4, MOST = 80 };
    const double good = 0.25, fair = 0.5, beside = 0.8;
    uint32_t index[MOST];
    double distance2[MOST];
    struct vec3 near[MOST], at = turn_back(f, x, y);
    struct quadric q;
    if (!nearest_height(b, &at, reach))
        return false;
    for (int c = 0; c < COUNTS; c++) {
        size_t n = point_grid_nearest(b, at, count[c], index, distance2);
        for (size_t i = 0; i < n; i++)
            near[i] = b->point[index[i]];
        if (quadric_fit(near, n, at, vec(0, 0, 1), &q) < 0)
            continue;
        if (quadric_rms(&q, near, n) <= (c < COUNTS - 1 ? good : fair) * tolerance) {
            *found = vec(x, y, at.z + q.c[0]);
            return true;
        }
        if (c < COUNTS - 1)
            c = COUNTS - 2; /* it bends: the fewest are the last to be tried */
    }
    *found = plan_extent_turn(f, b->point[index[0]]);
    return fabs(found->x - x) <= beside * reach && fabs(found->y - y) <= beside * reach;
}

/* Leaves out the places on creases and walls between others, where these run across. */
static void drop_in_zone(const struct plan_extent *f, const struct feature_zone *zone,
                         struct candidates *c)
{
    const double across = 2; /* so far at most, in lengths of the zone's edges */
    size_t kept = 0;

    for (size_t i = 0, to; i < c->point.n; i = to) {
        struct vec3 at = turn_back(f, c->point.item[i].x, c->point.item[i].y);
        bool clear = feature_zone_clear(zone, at.x, at.y);
        for (to = i + 1; clear && to < c->point.n; to++) {
            at = turn_back(f, c->point.item[to].x, c->point.item[to].y);
            if (!feature_zone_clear(zone, at.x, at.y))
                break;
        }
        double length = to < c->point.n ? c->point.item[to].x - c->point.item[i].x : HUGE_VAL;
        if (clear && i > 0 && length < across * zone->fine)
            continue;
        for (size_t k = i; k < to; k++, kept++) {
            c->point.item[kept] = c->point.item[k];
            c->col.item[kept] = c->col.item[k];
        }
    }
    c->point.n = c->col.n = kept;
}

static void mark_near(const struct plan_extent *f, const struct feature_zone *zone,
                      struct candidates *c)
{
    for (size_t i = 0; i < c->point.n; i++) {
        struct vec3 at = turn_back(f, c->point.item[i].x, c->point.item[i].y);
        c->near[i] = feature_zone_near(zone, at.x, at.y);
    }
}

static struct candidates find_candidates(const struct point_grid *b, const struct plan_extent *f,
                                         double v, const struct row_simplify_options *options)
{
    struct candidates c = {0};
    int cells = (int)fmax(ceil((f->xmax - f->xmin) / options->width - 1e-9), 1);
    for (int i = 0; i <= cells; i++) {
        struct vec3 p;
        double x = f->xmin + (f->xmax - f->xmin) * i / cells;
        if (!surface_at(b, f, x, v, options->reach, options->tolerance, &p))
            continue;
        *array_push(&c.point) = p;
        *array_push(&c.col) = i;
    }
    if (options->zone)
        drop_in_zone(f, options->zone, &c);
    c.taken = mem_alloc(c.point.n + 1, sizeof *c.taken);
    c.near = mem_alloc(c.point.n + 1, sizeof *c.near);
    if (options->zone)
        mark_near(f, options->zone, &c);
    return c;
}

/* How long a piece may be: no longer than the zone's edges where it is near them. */
static double longest_between(const struct candidates *c,
                              const struct row_simplify_options *options, size_t from, size_t to,
                              double longest)
{
    for (size_t i = from; options->zone && i <= to; i++)
        if (c->near[i])
            return fmin(longest, options->zone->fine);
    return longest;
}

/* Takes what it needs between two that are taken; where they are farther apart than `longest`, the
 * one in the middle at least. */
static void choose_between(struct candidates *c, const struct row_simplify_options *options,
                           size_t from, size_t to, double longest)
{
    const struct vec3 *p = c->point.item;
    double worst = options->tolerance;
    size_t at = from;
    if (to - from > 1 && p[to].x - p[from].x > longest_between(c, options, from, to, longest))
        at = from + (to - from) / 2;
    for (size_t i = from + 1; i < to; i++) {
        double off = vec_segment_distance(p[from], p[to], p[i]);
        if (off > worst) {
            worst = off;
            at = i;
        }
    }
    if (at == from)
        return;
    c->taken[at] = true;
    choose_between(c, options, from, at, longest);
    choose_between(c, options, at, to, longest);
}

struct row_simplify row_simplify_make(const struct point_grid *point_grid,
                                      const struct plan_extent *plan_extent, double v,
                                      const struct row_simplify_options *options, double longest)
{
    struct row_simplify row = {.v = v, .longest = longest};
    struct candidates c = find_candidates(point_grid, plan_extent, v, options);
    for (size_t from = 0, to; from < c.point.n; from = to + 1) {
        to = from;
        while (to + 1 < c.point.n && c.point.item[to + 1].x - c.point.item[to].x <= options->gap)
            to++;
        c.taken[from] = c.taken[to] = true;
        choose_between(&c, options, from, to, longest);
    }
    for (size_t i = 0; i < c.point.n; i++)
        if (c.taken[i]) {
            *array_push(&row.node) = c.point.item[i];
            *array_push(&row.col) = c.col.item[i];
        }
    array_free(&c.point);
    array_free(&c.col);
    free(c.taken);
    free(c.near);
    return row;
}

void row_simplify_free(struct row_simplify *row)
{
    array_free(&row->node);
    array_free(&row->col);
}
