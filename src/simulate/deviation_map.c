/* deviation_map - see deviation_map.h. */
#include "simulate/deviation_map.h"

#include <limits.h>
#include <stdint.h>
#include <stdlib.h>

#include "segment_tree.h"
#include "math/kdtree.h"
#include "base/parallel.h"

enum { GROUP = 32 };

#define CLOSE 0.04 /* of the radius */
#define HUG 4      /* tolerances that the ball may be off the part and still be on it */
#define HOLE                                                                             \
    1.5 /* spacings of the points that a hole between them is wide, seen from its middle \
         */

enum { SAMPLES = 200, BESIDE = 5 };

struct job {
    struct centre_path *path;
    const struct segment_tree *tree;
    const struct kdtree *part;
    const struct vec3 *point;
    const struct deviation_map_options *setup;
    double near; /* the ball's centre to the nearest point when it is on the part */
    struct deviation_map *result;
};

/* How far points are apart: a sample's mean distance to the fourth beside it. */
static double spacing(const struct kdtree *part, const struct vec3 *point, size_t n)
{
    size_t index[BESIDE], step = n / SAMPLES + 1, samples = 0;
    double distance2[BESIDE], sum = 0;
    for (size_t i = 0; n >= BESIDE && i < n; i += step, samples++) {
        kdtree_nearest(part, point[i], BESIDE, index, distance2);
        sum += sqrt(distance2[BESIDE - 1]);
    }
    return samples > 0 ? sum / (double)samples : 0;
}

/* A ball on the surface hangs into the hole between points, so far from all of them. */
static double near_part(const struct job *job, size_t n)
{
    const struct deviation_map_options *setup = job->setup;
    double hole = HOLE * spacing(job->part, job->point, n);
    double off = fmax(HUG * setup->tolerance, hole * hole / (2 * setup->radius));
    return setup->radius + fmin(setup->band, off);
}

static bool touches(const struct job *job, struct vec3 ball)
{
    size_t index;
    double distance2;
    kdtree_nearest(job->part, ball, 1, &index, &distance2);
    return distance2 <= job->near * job->near;
}

/*
 * Which segments are on the part?  Ways down to it and up from it are not.  In groups that are the
 * same however many threads there are, in which those close behind one that was looked at follow
 * it.
 */
static void touch(void *context, size_t from, size_t to)
{
    const struct job *job = context;
    struct vec3 looked = {0, 0, 0};
    for (size_t i = from * GROUP; i < to * GROUP && i < job->path->n; i++) {
        struct centre_segment *segment = &job->path->item[i];
        struct vec3 middle = vec_mix(segment->a, segment->b, 0.5);
        bool close = i % GROUP > 0 && vec_distance(middle, looked) < CLOSE * job->setup->radius;
        segment->on = close ? segment[-1].on : touches(job, middle);
        looked = close ? looked : middle;
    }
}

static void roll_points(void *context, size_t from, size_t to)
{
    const struct job *job = context;
    const struct deviation_map_options *setup = job->setup;
    size_t nearest = SIZE_MAX;
    for (size_t i = from; i < to; i++) {
        struct vec3 p = job->point[i];
        double within = setup->radius + setup->band;
        double distance = segment_tree_nearest(job->tree, p, within, &nearest);
        bool reached = distance < within;
        double deviation = distance - setup->radius;
        job->result->deviation[i] = deviation;
        job->result->segment[i] = reached ? (unsigned)nearest : UINT_MAX;
        if (reached && deviation > setup->tolerance) {
            struct vec3 centre = centre_segment_nearest(&job->path->item[nearest], p);
            struct vec3 n = vec_unit(vec_sub(centre, p));
            reached = segment_tree_surrounds(job->tree, p, n, within);
        }
        job->result->region[i] = reached;
    }
}

static void percentiles(const double *sorted, size_t n, struct deviation_map *r)
{
    static const double share[DEVIATION_MAP_PERCENTILES] = {0.50, 0.95, 0.99};
    for (int i = 0; n > 0 && i < DEVIATION_MAP_PERCENTILES; i++) {
        size_t rank = (size_t)(share[i] * (double)(n - 1) + 0.5);
        r->over_part[i] = fmax(0, sorted[rank]);
        r->gouge_part[i] = fmax(0, -sorted[n - 1 - rank]);
    }
}

static void sum_up(const struct deviation_map_options *setup, struct deviation_map *r)
{
    double *sorted = mem_alloc(r->points, sizeof *sorted);
    for (size_t i = 0; i < r->points; i++) {
        double deviation = r->deviation[i];
        if (!r->region[i])
            continue;
        sorted[r->cut++] = deviation;
        r->gouged += deviation < -setup->tolerance;
        r->left += deviation > setup->tolerance;
        if (-deviation > r->gouge) {
            r->gouge = -deviation;
            r->gouge_at = i;
        }
        if (deviation > r->over) {
            r->over = deviation;
            r->over_at = i;
        }
    }
    doubles_sort(sorted, r->cut);
    percentiles(sorted, r->cut, r);
    free(sorted);
}

void deviation_map_run(struct centre_path *path, const struct vec3 *point, size_t n,
                       const struct deviation_map_options *setup, struct deviation_map *result)
{
    struct segment_tree *tree = segment_tree_new(path);
    *result = (struct deviation_map){.points = n};
    result->deviation = mem_alloc(n, sizeof *result->deviation);
    result->segment = mem_alloc(n, sizeof *result->segment);
    result->region = mem_alloc(n, sizeof *result->region);
    struct job job = {path, tree, NULL, point, setup, 0, result};
    if (setup->band > setup->tolerance && n > 0) {
        struct kdtree *part = kdtree_new(point, n);
        job.part = part;
        job.near = near_part(&job, n);
        parallel_for(setup->threads, (path->n + GROUP - 1) / GROUP, touch, &job);
        kdtree_free(part);
    }
    parallel_for(setup->threads, n, roll_points, &job);
    segment_tree_free(tree);
    sum_up(setup, result);
}

void deviation_map_free(struct deviation_map *result)
{
    free(result->deviation);
    free(result->segment);
    free(result->region);
    *result = (struct deviation_map){0};
}
