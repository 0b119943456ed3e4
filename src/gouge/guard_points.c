/* gouge_points - see guard_points.h. */
#include "gouge/guard_points.h"

#include <stdlib.h>

#include "base/effort.h"
#include "base/parallel.h"
#include "cloud/upsample.h"
#include "math/surface_fit.h"

enum { GUESS = 16, SAMPLE = 1500, FEWEST = 56 };

/* Noises that a point may be off its surface: of ten thousand one is off five, and the noise itself
 * is known within a tenth. */
static const double FAR = 6;

/* Of its reach: so far about the middle of a neighbourhood its surface counts for other points, as
 * long as it is certain to this part of the noise. */
static const double MIDDLE = 0.4, CERTAIN = 0.35;

/* Of the noise: a surface less certain than this at its own place, as at a border, is doubtful; and
 * so is one whose slope may be off (two standard deviations) by what sinks the ball in so far. */
static const double DOUBTFUL = 0.3, SUNK = 0.3;

/* What becomes of a point. */
struct place {
    struct vec3 point;
    bool moved, doubtful;
    struct vec3s between;
    double vague; /* how far the points are off the surface of these, mm */
};

struct job {
    const struct guard_points_options *rule;
    const struct point_grid *point_grid;
    struct surface_fit_options fit; /* sigma: noise to take out; 0: none */
    struct upsample fill;
    bool filled;
    struct place *place;
};

/* A rough normal from the points about a place. */
static struct vec3 guess_at(const struct point_grid *b, struct vec3 place)
{
    uint32_t index[GUESS];
    double distance2[GUESS];
    struct vec3 near[GUESS];
    size_t n = point_grid_nearest(b, place, GUESS, index, distance2);

    for (size_t i = 0; i < n; i++)
        near[i] = b->point[index[i]];
    struct vec3 normal = plane_normal(near, n);
    return normal.z < 0 ? vec_scale(-1, normal) : normal;
}

/* A ball put on along a normal that is off by e sinks in by e^2 / (2 (1 / R - k)). */
static bool is_doubtful(const struct job *job, const struct surface_fit *fit)
{
    double radius = job->rule->radius, sigma = job->fit.sigma;
    double fits = fmax(1 / radius - quadric_curvature(&fit->q), 0.05 / radius);

    return fit->q.variance > DOUBTFUL * DOUBTFUL ||
           2 * sigma * sigma * fit->q.tilt / fits > SUNK * sigma;
}

/* Brings a point to a surface; false when noise alone does not explain where it is. */
static bool bring(const struct job *job, const struct surface_fit *fit, size_t i)
{
    struct vec3 p = job->point_grid->point[i], foot = quadric_nearest(&fit->q, p);
    struct place *place = &job->place[i];

    if (!surface_fit_holds(fit, job->fit.sigma) || vec_distance(p, foot) > FAR * job->fit.sigma)
        return false;
    *place = (struct place){.point = foot, .moved = true, .doubtful = is_doubtful(job, fit)};
    if (job->filled)
        upsample_on(&job->fill, i, foot, &fit->q, fit->spread, &place->between);
    return true;
}

/* How far from its middle a surface counts. */
static double range_of(const struct surface_fit *fit)
{
    double spare = CERTAIN * CERTAIN - fit->q.variance;

    return spare > 0 ? fmin(MIDDLE * fit->reach, sqrt(spare / fit->q.tilt)) : 0;
}

/* The point of [from, to) nearest to the middle of those not done; `to` when all are. */
static size_t middle_of(const struct vec3 *point, const bool *done, size_t from, size_t to)
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

/* The points of a cell: a surface about the middle one of those that are left serves those near to
 * it, until none is left. */
static void settle_cell(const struct job *job, size_t from, size_t to,
                        struct surface_fit_hood *hood)
{
    const struct vec3 *point = job->point_grid->point;
    bool *done = mem_alloc(to - from + 1, sizeof *done);

    for (size_t i = from; i < to; i++)
        done[i - from] = false;
    for (;;) {
        struct surface_fit fit;
        size_t middle = middle_of(point, done, from, to);
        if (middle == to)
            break;
        done[middle - from] = true;
        bool fitted = surface_fit_at(&job->fit, point[middle],
                                     guess_at(job->point_grid, point[middle]), hood, &fit);
        if (!(fitted && bring(job, &fit, middle)) && job->filled)
            upsample_about(&job->fill, middle, &job->place[middle].between);
        double range = fitted ? range_of(&fit) : 0;
        for (size_t i = from; i < to; i++)
            if (!done[i - from] && vec_distance(point[i], point[middle]) < range &&
                bring(job, &fit, i))
                done[i - from] = true;
    }
    free(done);
}

static void settle_cells(void *context, size_t from, size_t to)
{
    const struct job *job = context;
    struct surface_fit_hood *hood = surface_fit_hood_new();

    for (size_t cell = from; cell < to; cell++)
        settle_cell(job, job->point_grid->first[cell], job->point_grid->first[cell + 1], hood);
    surface_fit_hood_free(hood);
}

/* How many points to begin with, from a sample of them; there is a surface for each cell.  *near:
 * as in the header. */
static size_t neighbours_of(const struct job *job, size_t *near)
{
    const struct point_grid *b = job->point_grid;
    size_t some = b->n < SAMPLE ? b->n : SAMPLE;
    struct vec3s place = {0}, guess = {0};

    for (size_t i = 0; i < some; i++) {
        *array_push(&place) = b->point[i * b->n / some];
        *array_push(&guess) = guess_at(b, place.item[i]);
    }
    size_t neighbours =
        surface_fit_typical(&job->fit, place.item, guess.item, some, job->rule->threads);
    array_free(&place);
    array_free(&guess);
    size_t cells = b->columns * b->rows;
    double most = (double)effort_most(EFFORT_GUARD_NEAR, job->rule->effort) / (double)cells;
    double affordable = fmax(most, FEWEST);
    if ((double)neighbours <= affordable)
        return neighbours;
    *near = neighbours * cells;
    return (size_t)affordable;
}

static void fill_places(void *context, size_t from, size_t to)
{
    const struct job *job = context;

    for (size_t i = from; i < to; i++)
        job->place[i].vague = upsample_about(&job->fill, i, &job->place[i].between);
}

/* What there is to be done: -1 when it is nothing.  *sparse, *near: as in the header. */
static int plan(struct job *job, bool *sparse, size_t *near)
{
    const struct guard_points_options *rule = job->rule;
    const struct point_grid *b = job->point_grid;

    job->fit = (struct surface_fit_options){b, rule->noise, 0,
                                            effort_covers(EFFORT_ALONG, rule->effort, b->n)};
    job->fill = (struct upsample){b, rule->radius, rule->sink, rule->noise};
    *sparse = upsample_needed(&job->fill);
    job->filled = *sparse && effort_covers(EFFORT_GUARD_BETWEEN, rule->effort, b->n);
    if (rule->noise > 0)
        job->fit.neighbours = neighbours_of(job, near);
    return rule->noise > 0 || job->filled ? 0 : -1;
}

static struct guard_points gather(struct job *job)
{
    const struct point_grid *b = job->point_grid;
    struct guard_points surface = {.moved = 0};

    for (size_t i = 0; i < b->n; i++) {
        struct place *place = &job->place[i];
        *array_push(&surface.point) = place->point;
        *array_push(place->doubtful ? &surface.doubtful : &surface.certain) = place->point;
        surface.moved += place->moved;
        surface.vague += place->vague > job->rule->vague;
        if (place->vague > surface.worst) {
            surface.worst = place->vague;
            surface.at = place->point;
        }
        surface.added += place->between.n;
        for (size_t k = 0; k < place->between.n; k++)
            *array_push(&surface.point) = place->between.item[k];
        array_free(&place->between);
    }
    return surface;
}

struct guard_points guard_points_make(const struct point_grid *point_grid,
                                      const struct guard_points_options *rule)
{
    struct job job = {.rule = rule, .point_grid = point_grid};
    struct guard_points surface = {.moved = 0};
    bool sparse;
    size_t near = 0;

    if (plan(&job, &sparse, &near) < 0) {
        surface.sparse = sparse;
        array_reserve(&surface.point, point_grid->n);
        for (size_t i = 0; i < point_grid->n; i++)
            *array_push(&surface.point) = *array_push(&surface.certain) = point_grid->point[i];
        return surface;
    }
    job.place = mem_alloc(point_grid->n, sizeof *job.place);
    for (size_t i = 0; i < point_grid->n; i++)
        job.place[i] = (struct place){.point = point_grid->point[i]};
    if (job.fit.sigma > 0)
        parallel_for(rule->threads, point_grid->columns * point_grid->rows, settle_cells, &job);
    else
        parallel_for(rule->threads, point_grid->n, fill_places, &job);
    surface = gather(&job);
    surface.sparse = sparse;
    surface.near = near;
    free(job.place);
    return surface;
}
