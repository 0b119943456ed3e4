/* guard_points - see guard_points.h. */
#include "gouge/guard_points.h"

#include <stdlib.h>

#include "base/effort.h"
#include "base/parallel.h"
#include "cloud/scan_edges.h"
#include "cloud/scan_lines.h"
#include "cloud/settle.h"
#include "cloud/steep_facets.h"
#include "cloud/upsample.h"
#include "cloud/upsample_surface.h"
#include "math/surface_fit.h"

enum { GUESS = 16, SAMPLE = 1500, FEWEST = 56 };

/* Noises that a point may be off its surface: of ten thousand one is off five, and the noise itself
 * is known within a tenth. */
static const double FAR = 6;

/* Of its reach: so far about the middle of a neighbourhood its surface counts for other points, as
 * long as it is certain to this part of the noise. */
static const double MIDDLE = 0.4, CERTAIN = 0.35;

/* The same where these are facets. */
static const double FACETS = 0.25;

/* Of the noise: a surface less certain than this at its own place, as at a border, is doubtful; and
 * so is one whose slope may be off (two standard deviations) by what sinks the ball in so far. */
static const double DOUBTFUL = 0.3, SUNK = 0.3;

/* Of the noise: where the surface through few neighbours is further off the one through many, shape
 * may have been smoothed over, and it is kept clear of, too. */
static const double DIFFERENT = 1;

/* Noises that points are off a surface, one standard deviation: more is not noise. */
static const double NOISY = 2;

/* What becomes of a point. */
struct point_result {
    struct vec3 point;
    bool moved, doubtful;
    struct vec3s between;
    double vague; /* how far the points are off the surface of these, mm */
};

struct guard_work {
    const struct guard_points_options *rule;
    const struct point_grid *point_grid;
    struct surface_fit_options fit; /* sigma: noise to take out; 0: none */
    struct upsample fill;
    struct near_lists lists; /* where the scan is not on lines: there others are asked for */
    bool filled, facetted;   /* points are put between; surfaces may be facets */
    struct point_result *result;
};

/* A rough normal from the points about a place. */
static struct vec3 guess_normal(const struct point_grid *b, struct vec3 place)
{
    struct vec3 near[GUESS];
    size_t n = point_grid_near(b, place, GUESS, near);
    struct vec3 normal = plane_normal(near, n);
    return normal.z < 0 ? vec_scale(-1, normal) : normal;
}

/* A ball put on along a normal that is off by e sinks in by e^2 / (2 (1 / R - k)). */
static bool is_doubtful(const struct guard_work *work, const struct surface_fit *fit)
{
    double radius = work->rule->radius, sigma = work->fit.sigma;
    double fits = fmax(1 / radius - quadric_curvature(&fit->q), 0.05 / radius);

    return fit->q.variance > DOUBTFUL * DOUBTFUL ||
           2 * sigma * sigma * fit->q.tilt / fits > SUNK * sigma;
}

/* The surface about the middle of some points: of a fit, or the facets that explain more. */
struct guard_surface {
    struct surface_fit fit;
    struct upsample_surface on;
    double range; /* so far about the middle it counts, mm */
};

/* Brings a point to a surface; false when noise alone does not explain where it is. */
static bool move_to_surface(const struct guard_work *work, const struct guard_surface *surface,
                            size_t i)
{
    const struct upsample_surface *on = &surface->on;
    double sigma = work->fit.sigma;
    struct vec3 p = work->point_grid->point[i], at = quadric_local(&on->q, p);
    struct vec3 foot =
        on->facetted ? upsample_surface_at(on, at.x, at.y) : quadric_nearest(&on->q, p);
    struct point_result *result = &work->result[i];

    if (!(on->facetted || surface_fit_holds(&surface->fit, sigma)) ||
        vec_distance(p, foot) > FAR * sigma)
        return false;
    *result = (struct point_result){.point = foot,
                                    .moved = true,
                                    .doubtful = !on->facetted && is_doubtful(work, &surface->fit)};
    if (work->filled)
        upsample_on(&work->fill, i, foot, on, &result->between);
    return true;
}

/* How far from its middle a surface counts. */
static double valid_range(const struct surface_fit *fit)
{
    double spare = CERTAIN * CERTAIN - fit->q.variance;

    return spare > 0 ? fmin(MIDDLE * fit->reach, sqrt(spare / fit->q.tilt)) : 0;
}

/* The surface about point i; false: there is none. */
static bool find_surface(const struct guard_work *work, size_t i, struct surface_fit_hood *hood,
                         struct guard_surface *surface)
{
    struct vec3 place = work->point_grid->point[i];
    struct surface_fit *fit = &surface->fit;
    double reach;

    if (!surface_fit_at(&work->fit, place, guess_normal(work->point_grid, place), hood, fit))
        return false;
    surface->on = (struct upsample_surface){.q = fit->q, .spread = fit->spread};
    surface->range =
        work->facetted && upsample_facets_explain(&work->fill, place, &surface->on, &reach)
            ? FACETS * reach
            : valid_range(fit);
    return true;
}

/* The point of [from, to) nearest to the middle of those not done; `to` when all are. */
static size_t find_middle(const struct vec3 *point, const bool *done, size_t from, size_t to)
{
    struct vec3 sum = vec(0, 0, 0);
    double count = 0, nearest = HUGE_VAL;
    size_t middle = to;

    for (size_t i = from; i < to; i++) {
        if (!done[i - from]) {
            sum = vec_add(sum, point[i]);
            count++;
        }
    }
    for (size_t i = from; i < to; i++) {
        double distance = vec_distance(point[i], vec_scale(1 / count, sum));
        if (!done[i - from] && distance < nearest) {
            nearest = distance;
            middle = i;
        }
    }
    return middle;
}

/* Where no surface explains a point by noise alone. */
static void fill_about(const struct guard_work *work, size_t i)
{
    struct point_result *result = &work->result[i];
    double off = upsample_about(&work->fill, i, &result->between);

    result->vague = off > NOISY * work->fit.sigma ? off : 0;
}

/* The points of a cell: a surface about the middle one of those that are left serves those near to
 * it, until none is left. */
static void fit_cell(const struct guard_work *work, size_t from, size_t to,
                     struct surface_fit_hood *hood)
{
    const struct vec3 *point = work->point_grid->point;
    bool *done = mem_alloc(to - from + 1, sizeof *done);

    for (size_t i = from; i < to; i++)
        done[i - from] = false;
    for (;;) {
        struct guard_surface surface = {.range = 0};
        size_t middle = find_middle(point, done, from, to);
        if (middle == to)
            break;
        done[middle - from] = true;
        bool fitted = find_surface(work, middle, hood, &surface);
        if (!(fitted && move_to_surface(work, &surface, middle)) && work->filled)
            fill_about(work, middle);
        for (size_t i = from; i < to; i++)
            if (!done[i - from] && vec_distance(point[i], point[middle]) < surface.range &&
                move_to_surface(work, &surface, i))
                done[i - from] = true;
    }
    free(done);
}

static void fit_cells(void *context, size_t from, size_t to)
{
    const struct guard_work *work = context;
    struct surface_fit_hood *hood = surface_fit_hood_new();

    for (size_t cell = from; cell < to; cell++)
        fit_cell(work, work->point_grid->first[cell], work->point_grid->first[cell + 1], hood);
    surface_fit_hood_free(hood);
}

/* How many points to begin with, from a sample of them; there is a surface for each cell.  *near:
 * as in the header. */
static size_t neighbours_of(const struct guard_work *work, size_t *near)
{
    const struct point_grid *b = work->point_grid;
    size_t some = b->n < SAMPLE ? b->n : SAMPLE;
    struct vec3s place = {0}, guess = {0};

    for (size_t i = 0; i < some; i++) {
        *array_push(&place) = b->point[i * b->n / some];
        *array_push(&guess) = guess_normal(b, place.item[i]);
    }
    size_t neighbours =
        surface_fit_typical(&work->fit, place.item, guess.item, some, work->rule->threads);
    array_free(&place);
    array_free(&guess);
    size_t cells = b->columns * b->rows;
    double most = (double)effort_most(EFFORT_GUARD_NEAR, work->rule->effort) / (double)cells;
    double affordable = fmax(most, FEWEST);
    if ((double)neighbours <= affordable)
        return neighbours;
    *near = neighbours * cells;
    return (size_t)affordable;
}

static void fill_gaps(void *context, size_t from, size_t to)
{
    const struct guard_work *work = context;

    for (size_t i = from; i < to; i++)
        work->result[i].vague = upsample_about(&work->fill, i, &work->result[i].between);
}

/* Facets explain the noisy points better than one surface at nearly all places, nine of ten: tight
 * bends of smooth shapes are so at no more than four of ten. */
static bool are_facets(const struct guard_work *work)
{
    enum { PLACES = 300 };
    const double most = 0.8;
    size_t n = work->point_grid->n, some = n < PLACES ? n : PLACES, looked = 0, facetted = 0;
    double reach;

    for (size_t i = 0; i < some; i++) {
        struct upsample_hood near;
        struct upsample_surface on;
        upsample_hood_find(&work->fill, i * n / some, UPSAMPLE_NEAR, &near);
        upsample_surface_find(&near, &on);
        if (!(on.spread < HUGE_VAL))
            continue;
        looked++;
        facetted += upsample_facets_explain(&work->fill, near.point[0], &on, &reach);
    }
    return (double)facetted > most * (double)looked;
}

/* What there is to be done; false: nothing.  *sparse, *near: as in the header. */
static bool choose_work(struct guard_work *work, bool *sparse, size_t *near)
{
    const struct guard_points_options *rule = work->rule;
    const struct point_grid *b = work->point_grid;

    work->fit = (struct surface_fit_options){
        b, rule->noise, 0, effort_covers(EFFORT_ALONG, rule->effort, b->n), false};
    work->fill = (struct upsample){.point_grid = b,
                                   .radius = rule->radius,
                                   .sink = rule->sink,
                                   .noise = fmax(rule->noise, rule->apart),
                                   .lines = scan_lines_found(b),
                                   .near = &work->lists};
    if (!work->fill.lines)
        work->lists = near_lists_of(b, rule->threads);
    *sparse = upsample_needed(&work->fill);
    work->filled = *sparse && effort_covers(EFFORT_GUARD_BETWEEN, rule->effort, b->n);
    if (rule->noise > 0)
        work->fit.neighbours = neighbours_of(work, near);
    work->facetted = work->filled && rule->noise > 0 && (rule->edged || are_facets(work));
    return rule->noise > 0 || work->filled;
}

static void add_near_surface(void *context, size_t from, size_t to)
{
    const struct guard_work *work = context;

    for (size_t i = from; i < to; i++) {
        double sigma = work->fit.sigma;
        struct vec3 near = settle_point(work->point_grid, sigma, work->point_grid->point[i]);
        if (vec_distance(near, work->result[i].point) > DIFFERENT * sigma)
            *array_push(&work->result[i].between) = near;
    }
}

static struct guard_points gather(struct guard_work *work)
{
    const struct point_grid *b = work->point_grid;
    struct guard_points surface = {.moved = 0};

    for (size_t i = 0; i < b->n; i++) {
        struct point_result *result = &work->result[i];
        *array_push(&surface.point) = result->point;
        *array_push(result->doubtful ? &surface.doubtful : &surface.certain) = result->point;
        surface.moved += result->moved;
        surface.vague += result->vague > work->rule->vague;
        if (result->vague > surface.worst) {
            surface.worst = result->vague;
            surface.at = result->point;
        }
        surface.added += result->between.n;
        for (size_t k = 0; k < result->between.n; k++)
            *array_push(&surface.point) = result->between.item[k];
        array_free(&result->between);
    }
    return surface;
}

static void add_edges(const struct guard_work *work, struct guard_points *surface)
{
    const struct guard_points_options *rule = work->rule;
    const struct scan_edges_options options = {.scan = work->point_grid,
                                               .radius = rule->radius,
                                               .sink = rule->sink,
                                               .noise = rule->noise,
                                               .rough = rule->rough,
                                               .edged = rule->edged,
                                               .fill = work->filled,
                                               .threads = rule->threads,
                                               .near = &work->lists};
    struct scan_edges found = scan_edges_find(&options);

    vec3s_add(&surface->point, found.point.item, found.point.n);
    surface->edges = found.edges;
    surface->gaps = found.gaps;
    surface->added += found.point.n - found.edges;
    array_free(&found.point);
}

/* Steep flanks that the scan has few points on, between these where they are taken to be. */
static void add_steep(const struct guard_work *work, struct guard_points *surface)
{
    const struct guard_points_options *rule = work->rule;
    size_t n = work->point_grid->n, before = surface->point.n;
    struct vec3 *place = work->result ? mem_alloc(n + 1, sizeof *place) : NULL;
    const struct steep_facets_options steep = {.place = place,
                                               .radius = rule->radius,
                                               .sink = rule->sink,
                                               .noise = rule->noise,
                                               .threads = rule->threads};

    for (size_t i = 0; place && i < n; i++)
        place[i] = work->result[i].point;
    steep_facets(work->point_grid, &steep, &surface->point);
    surface->added += surface->point.n - before;
    free(place);
}

struct guard_points guard_points_of_scan(const struct point_grid *point_grid,
                                         const struct guard_points_options *rule)
{
    struct guard_work work = {.rule = rule, .point_grid = point_grid};
    struct guard_points surface = {.moved = 0};
    bool sparse;
    size_t near = 0;

    if (!choose_work(&work, &sparse, &near)) {
        add_edges(&work, &surface);
        add_steep(&work, &surface);
        near_lists_free(&work.lists);
        surface.sparse = sparse;
        array_reserve(&surface.point, point_grid->n);
        for (size_t i = 0; i < point_grid->n; i++)
            *array_push(&surface.point) = *array_push(&surface.certain) = point_grid->point[i];
        return surface;
    }
    work.result = mem_alloc(point_grid->n, sizeof *work.result);
    for (size_t i = 0; i < point_grid->n; i++)
        work.result[i] = (struct point_result){.point = point_grid->point[i]};
    if (work.fit.sigma > 0) {
        parallel_for(rule->threads, point_grid->columns * point_grid->rows, fit_cells, &work);
        parallel_for(rule->threads, point_grid->n, add_near_surface, &work);
    } else {
        parallel_for(rule->threads, point_grid->n, fill_gaps, &work);
    }
    surface = gather(&work);
    surface.gap = surface.vague > 0 ? upsample_gap(&work.fill) : 0;
    add_edges(&work, &surface);
    add_steep(&work, &surface);
    surface.sparse = sparse;
    surface.near = near;
    near_lists_free(&work.lists);
    free(work.result);
    return surface;
}
