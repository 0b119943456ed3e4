/* least_planes - see least_planes.h. */
#include "math/least_planes.h"

#include <string.h>

#include "math/elementary.h"
#include "math/side_fit.h"

/* The fewest points of a plane; rounds of a fit, to begin with and to its end; ways that the points
 * of a plane are divided. */
enum { FEWEST = 5, FIRST = 3, TURNS = 12, WAYS = 8 };

/* Of the standard deviation of all points along such a way: so far from their middle is the first
 * division. */
static const double BESIDE = 0.4;

double least_planes_at(const struct least_planes *fit, double u, double v)
{
    double height = HUGE_VAL;

    for (int k = 0; k < fit->n; k++)
        height = fmin(height, fit->plane[k][0] + fit->plane[k][1] * u + fit->plane[k][2] * v);
    return height;
}

/* A fit that is settled: each point's plane, and sums of the points of each. */
struct counts {
    const struct vec3 *local;
    const double *u, *v; /* of these */
    size_t n;
    int of[LEAST_PLANES_POINTS];
    struct side_sums sum[LEAST_PLANES];
};

/* Counts point i to another plane. */
static void move_point(struct counts *counts, size_t i, int to)
{
    side_sums_add(&counts->sum[counts->of[i]], -1, counts->local[i]);
    side_sums_add(&counts->sum[to], 1, counts->local[i]);
    counts->of[i] = to;
}

/* The planes through the points that are counted to them; false, and as they were: one would not be
 * known. */
static bool fit_each(const struct counts *counts, struct least_planes *fit)
{
    struct side_fit side[LEAST_PLANES];

    for (int k = 0; k < fit->n; k++)
        if (counts->sum[k].n < FEWEST || side_fit_plane_of(&counts->sum[k], &side[k]) < 0)
            return false;
    for (int k = 0; k < fit->n; k++)
        memcpy(fit->plane[k], side[k].q.c, sizeof fit->plane[k]);
    return true;
}

/* The height of the lowest plane over each place, and its number. */
static void find_lowest(const struct counts *counts, const struct least_planes *fit, double *height,
                        double *of)
{
    for (size_t i = 0; i < LEAST_PLANES_POINTS; i++) {
        height[i] = HUGE_VAL;
        of[i] = 0;
    }
    for (int k = 0; k < fit->n; k++) {
        double c0 = fit->plane[k][0], c1 = fit->plane[k][1], c2 = fit->plane[k][2], number = k;
        for (size_t i = 0; i < LEAST_PLANES_POINTS; i++) { /* all of them: by pairs */
            double h = c0 + c1 * counts->u[i] + c2 * counts->v[i];
            of[i] = h < height[i] ? number : of[i];
            height[i] = h < height[i] ? h : height[i];
        }
    }
}

/* Each point to the plane lowest over it; true if any was another's. */
static bool count_again(struct counts *counts, struct least_planes *fit)
{
    double sum2 = 0, terms = 3.0 * fit->n, count = (double)counts->n;
    double height[LEAST_PLANES_POINTS], of[LEAST_PLANES_POINTS];
    bool changed = false;

    find_lowest(counts, fit, height, of);
    for (size_t i = 0; i < counts->n; i++) {
        double off = counts->local[i].z - height[i];
        sum2 += off * off;
        if ((int)of[i] == counts->of[i])
            continue;
        move_point(counts, i, (int)of[i]);
        changed = true;
    }
    fit->rms = count > terms ? sqrt(sum2 / (count - terms)) : HUGE_VAL;
    return changed;
}

/* From the points as they are counted now, until none goes to another plane. */
static void settle(struct counts *counts, int turns, struct least_planes *fit)
{
    for (int k = 0; k < turns; k++)
        if (!fit_each(counts, fit) || !count_again(counts, fit))
            return;
}

/* One plane more, the last: points of a plane go to it that lie one way, beyond so many of their
 * standard deviations from their middle. */
static void divide(struct counts *counts, int plane, int way, double beside, int last)
{
    double cu = cos(2 * PI * way / WAYS), cv = sin(2 * PI * way / WAYS);
    const struct side_sums *sum = &counts->sum[plane];
    double middle = (cu * sum->u + cv * sum->v) / sum->n;
    double sum2 = cu * (cu * sum->uu + 2 * cv * sum->uv) + cv * cv * sum->vv;
    double least = middle + beside * sqrt(fmax(0, sum2 / sum->n - middle * middle));

    for (size_t i = 0; i < counts->n; i++)
        if (counts->of[i] == plane && cu * counts->local[i].x + cv * counts->local[i].y > least)
            move_point(counts, i, last);
}

/* The plane whose points are farthest off it, all in all. */
static int find_worst(const struct counts *counts, const struct least_planes *fit)
{
    double off2[LEAST_PLANES] = {0};
    int worst = 0;

    for (size_t i = 0; i < counts->n; i++) {
        struct vec3 at = counts->local[i];
        const double *c = fit->plane[counts->of[i]];
        double off = at.z - (c[0] + c[1] * at.x + c[2] * at.y);
        off2[counts->of[i]] += off * off;
    }
    for (int k = 1; k < fit->n; k++)
        worst = off2[k] > off2[worst] ? k : worst;
    return worst;
}

/* One plane more, by the best of the ways to divide the worst; false: none is better. */
static bool fit_more(struct counts *counts, struct least_planes *fit)
{
    const struct least_planes before = *fit;
    const struct counts from = *counts;
    int worst = find_worst(counts, fit);
    int ways = before.n > 1 ? WAYS / 2 : WAYS; /* in the middle: either part may be the last */

    for (int way = 0; way < ways; way++) {
        struct least_planes other = {.n = before.n + 1, .rms = HUGE_VAL};
        struct counts tried = from;
        divide(&tried, worst, way, before.n > 1 ? 0 : BESIDE, before.n);
        settle(&tried, FIRST, &other);
        if (!(other.rms < fit->rms))
            continue;
        *fit = other;
        *counts = tried;
    }
    if (fit->n == before.n)
        return false;
    settle(counts, TURNS, fit);
    return true;
}

int least_planes_fit(const struct vec3 *local, size_t n, double even, struct least_planes *fit)
{
    double u[LEAST_PLANES_POINTS] = {0}, v[LEAST_PLANES_POINTS] = {0};
    struct counts counts = {.local = local, .u = u, .v = v, .n = n};

    *fit = (struct least_planes){.n = 1, .rms = HUGE_VAL};
    if (n > LEAST_PLANES_POINTS)
        return -1;
    for (size_t i = 0; i < n; i++) {
        u[i] = local[i].x;
        v[i] = local[i].y;
        side_sums_add(&counts.sum[0], 1, local[i]);
    }
    while (fit->n < LEAST_PLANES && fit->rms > even && fit_more(&counts, fit))
        ;
    return fit->rms < HUGE_VAL ? 0 : -1;
}
