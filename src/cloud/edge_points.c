/* edge_points - see edge_points.h. */
#include "cloud/edge_points.h"

#include <stdlib.h>

#include "base/parallel.h"
#include "cloud/scan_lines.h"
#include "cone_tip.h"
#include "edge_steps.h"
#include "math/cubic.h"

/* ---- tips of cones */

/* No point about stands higher, seen along `up`. */
static bool is_top_along(const struct edge_hood *near, struct vec3 up)
{
    for (size_t k = 1; k < EDGE_ABOUT; k++)
        if (vec_dot(up, vec_sub(near->point[k], near->point[0])) > 0)
            return false;
    return true;
}

/* Along the normal of the neighbourhood, which of a slender cone is none, or from above. */
static bool is_top(const struct edge_hood *near)
{
    struct vec3 up = plane_normal(near->point, near->n);

    return is_top_along(near, up.z < 0 ? vec_scale(-1, up) : up) ||
           is_top_along(near, vec(0, 0, 1));
}

static bool fit_cone(const struct edge_work *work, const struct vec3 *point, size_t n,
                     double spacing, struct cone_tip *tip)
{
    double least = edge_within(work, spacing) + EDGE_SIGMAS * EDGE_EVEN * spacing;

    return cone_tip_fit(point, n, edge_even(work, spacing), tip) == 0 && tip->worst <= least;
}

/* The cone about its tip.  Where a surface is known, and among noise, where one neighbourhood in a
 * thousand is too rough for one by chance, a cubic must do far worse: real cones leave a fifth of
 * what it does, smooth surfaces with noise three quarters at least. */
static bool find_cone(const struct edge_work *work, const struct edge_hood *near,
                      const struct edge_flank *flank, struct cone_tip *tip)
{
    bool noisy = work->options->noise > 0;
    const double better = noisy ? 0.5 : 0.75;
    struct quadric cubic;

    if (!fit_cone(work, near->point, near->n, near->spacing, tip))
        return false;
    if (flank->rough && !noisy)
        return true;
    struct vec3 up = flank->rough ? plane_normal(near->point, near->n) : quadric_normal(&flank->q);
    if (cubic_fit(near->point, NULL, near->n, near->point[0], up, &cubic) != 0)
        return flank->rough;
    return tip->rms < better * quadric_spread(&cubic, near->point, near->n, 10);
}

/* As far as it goes: no flank is known of a point near the tip of a cone. */
static void widen_cone(const struct edge_work *work, const struct edge_hood *near,
                       struct cone_tip *tip)
{
    static const size_t more[] = {CONE_POINTS, 224, 192, 160, 128, 112, 96, 80, 64, 52};
    const struct point_grid *b = work->options->point_grid;
    uint32_t index[CONE_POINTS];
    double distance2[CONE_POINTS];
    struct vec3 point[CONE_POINTS];
    size_t n = point_grid_nearest(b, near->point[0], CONE_POINTS, index, distance2);

    for (size_t k = 0; k < n; k++)
        point[k] = b->point[index[k]];
    for (size_t i = 0; i < sizeof more / sizeof *more; i++) {
        struct cone_tip wide;
        if (more[i] > n || !fit_cone(work, point, more[i], near->spacing, &wide) ||
            wide.reach < tip->reach)
            continue;
        *tip = wide;
        return;
    }
}

/* The tip of a cone about a point of it, and places round it as far as all neighbours know. */
static void add_cone(const struct edge_work *work, const struct edge_hood *near,
                     const struct edge_flank *flank, struct vec3s *edge, struct vec3s *between)
{
    const double dense = 0.65;
    double pitch = dense * work->options->along;
    struct cone_tip tip;

    if (!find_cone(work, near, flank, &tip))
        return;
    widen_cone(work, near, &tip);
    *array_push(edge) = cone_tip_at(&tip, 0, 0);
    double down = pitch / hypot(1, tip.c[1]);
    for (int ring = 1; ring * down < tip.reach; ring++) {
        double r = ring * down, parts = ceil(2 * PI * r / pitch);
        for (double k = 0; k < parts; k++)
            *array_push(between) = cone_tip_at(&tip, r, 2 * PI * k / parts);
    }
}

/* ---- all of them */

static void find_edges(void *context, size_t from, size_t to)
{
    const struct edge_work *work = context;
    struct edge_hood near;

    for (size_t i = from; i < to; i++) {
        if (!work->met) {
            work->gap[i] = edge_cliff_add(work, i, &work->found[i], &work->between[i]);
            edge_foot_add(work, i, &work->between[i]);
        }
        if (!work->flank[i].bent)
            continue;
        edge_hood_find(work, i, &near);
        if (is_top(&near))
            add_cone(work, &near, &work->flank[i], &work->found[i], &work->between[i]);
        if (work->flank[i].valid)
            edge_meet_add(work, &near, i, &work->found[i]);
    }
}

static void find_unknown(void *context, size_t from, size_t to)
{
    const struct edge_work *work = context;

    for (size_t i = from; i < to; i++)
        work->unknown[i] = edge_unknown_find(work, i);
}

static void add_unknown(void *context, size_t from, size_t to)
{
    const struct edge_work *work = context;

    for (size_t i = from; i < to; i++)
        edge_unknown_add(work, i, &work->between[i]);
}

static void fill_flanks(void *context, size_t from, size_t to)
{
    const struct edge_work *work = context;
    struct edge_hood near;

    for (size_t i = from; i < to; i++)
        if (work->flank[i].valid) {
            edge_hood_find(work, i, &near);
            edge_fill_add(work, &near, i, &work->between[i]);
        }
}

/* Appends what was found of each point, which is freed; returns how much. */
static size_t append_all(struct vec3s *found, size_t n, struct vec3s *to)
{
    size_t before = to->n;

    for (size_t i = 0; i < n; i++) {
        vec3s_add(to, found[i].item, found[i].n);
        array_free(&found[i]);
    }
    free(found);
    return to->n - before;
}

static struct edge_gaps sum_gaps(const struct edge_work *work)
{
    struct edge_gaps gaps = {.n = 0};

    for (size_t i = 0; i < work->options->point_grid->n; i++) {
        gaps.n += work->gap[i] > 0;
        gaps.certain += edge_flank_certain(work, &work->flank[i]);
        if (work->gap[i] > gaps.widest) {
            gaps.widest = work->gap[i];
            gaps.at = work->options->point_grid->point[i];
        }
        edge_unknown_sum(work, i, &gaps);
    }
    return gaps;
}

/* Points of which one in so many has a wall: these are what the scan is of. */
static const double WALLS = 7;

/* Of some points so many have walls hanging from their flanks. */
static bool has_walls(const struct edge_work *work)
{
    enum { SOME = 1000 };
    size_t n = work->options->point_grid->n, some = n < SOME ? n : SOME, walls = 0;

    for (size_t k = 0; k < some; k++) {
        struct vec3s edge = {0}, between = {0};
        walls += edge_cliff_add(work, k * n / some, &edge, &between) > 0;
        array_free(&edge);
        array_free(&between);
    }
    return WALLS * (double)walls > (double)some;
}

size_t edge_points(const struct edge_points_options *options, struct vec3s *to,
                   struct edge_gaps *gaps)
{
    size_t n = options->point_grid->n;
    struct edge_work work = {.options = options,
                             .lines = scan_lines_found(options->point_grid),
                             .flank = mem_alloc(n, sizeof *work.flank),
                             .chosen = mem_alloc(n, sizeof *work.chosen),
                             .found = mem_alloc(n, sizeof *work.found),
                             .between = mem_alloc(n, sizeof *work.between),
                             .gap = mem_alloc(n, sizeof *work.gap),
                             .unknown = mem_alloc(n, sizeof *work.unknown)};

    for (size_t i = 0; i < n; i++) {
        work.flank[i] = (struct edge_flank){.valid = false};
        work.found[i] = work.between[i] = (struct vec3s){0};
        work.gap[i] = 0;
        work.unknown[i] = (struct edge_unknown){.depth = 0};
    }
    edge_flanks_find(&work);
    work.met = options->met && !has_walls(&work);
    parallel_for(options->threads, n, find_edges, &work);
    if (options->fill && !work.met)
        edge_crests_add(&work);
    if (!work.met) {
        parallel_for(options->threads, n, find_unknown, &work);
        parallel_for(options->threads, n, add_unknown, &work);
    }
    work.wide = work.lines;
    if (options->fill)
        parallel_for(options->threads, n, fill_flanks, &work);
    append_all(work.between, n, to);
    *gaps = sum_gaps(&work);
    free(work.gap);
    free(work.unknown);
    free(work.flank);
    return append_all(work.found, n, to);
}
