/* deviation_map - see deviation_map.h. */
#include "simulate/deviation_map.h"

#include <limits.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/parallel.h"
#include "math/box_tree.h"
#include "math/kdtree.h"
#include "math/plane_fit.h"

enum {
    GROUP = 32,    /* segments of which those close to one another share a look at the part */
    SAMPLES = 200, /* points by which the spacing of a cloud is estimated ... */
    BESIDE = 5,    /* ... each by its neighbours, itself the first */
    ABOUT = 12,    /* points that tell the normal at one of them */
    SECTORS = 16,  /* of a turn, around a point */
    GAP = 6        /* sectors in a row without a cut: the point is beside the region */
};

#define CLOSE 0.04 /* of the radius: segments that close share a look */
#define HUG 4      /* tolerances that the ball may be off the part and still be on it */
#define HOLE 1.5   /* diameter of a hole between points, in spacings */

struct rolling {
    struct centre_path *path;
    const struct box_tree *tree; /* of the path */
    const struct kdtree *part;
    const struct vec3 *point;
    const struct deviation_map_options *options;
    double near; /* the ball's centre to the nearest point when it is on the part */
    struct deviation_map *map;
    unsigned char *inside; /* of each point: the region without what is left at its border */
};

/* ---- which segments of the path touch the part */

/* How far points are apart: a sample's mean distance to the fourth neighbour. */
static double point_spacing(const struct kdtree *part, const struct vec3 *point, size_t n)
{
    size_t index[BESIDE], step = n / SAMPLES + 1, samples = 0;
    double distance2[BESIDE], sum = 0;
    for (size_t i = 0; n >= BESIDE && i < n; i += step, samples++) {
        kdtree_nearest(part, point[i], BESIDE, index, distance2);
        sum += sqrt(distance2[BESIDE - 1]);
    }
    return samples > 0 ? sum / (double)samples : 0;
}

/* A ball on the surface sinks into the hole between points: so far it may be off all of them. */
static double touching_distance(const struct rolling *r, size_t n)
{
    const struct deviation_map_options *options = r->options;
    double hole = HOLE * point_spacing(r->part, r->point, n);
    double off = fmax(HUG * options->tolerance, hole * hole / (2 * options->radius));
    return options->radius + fmin(options->band, off);
}

static bool ball_touches(const struct rolling *r, struct vec3 centre)
{
    size_t index;
    double distance2;
    kdtree_nearest(r->part, centre, 1, &index, &distance2);
    return distance2 <= r->near * r->near;
}

/* Moves down to the part and up from it are not on it.  The groups are the same however many
 * threads there are; in a group, segments close after one that was looked at are taken as it is. */
static void mark_touching(void *context, size_t from, size_t to)
{
    const struct rolling *r = context;
    struct vec3 looked = {0, 0, 0};
    for (size_t i = from * GROUP; i < to * GROUP && i < r->path->n; i++) {
        struct centre_segment *segment = &r->path->item[i];
        struct vec3 middle = vec_mix(segment->a, segment->b, 0.5);
        bool close = i % GROUP > 0 && vec_distance(middle, looked) < CLOSE * r->options->radius;
        segment->on = close ? segment[-1].on : ball_touches(r, middle);
        looked = close ? looked : middle;
    }
}

/* ---- the nearest segment of each point */

static struct box_tree *tree_of(const struct centre_path *path)
{
    struct box *box = mem_alloc(path->n, sizeof *box);
    for (size_t i = 0; i < path->n; i++) {
        box[i] = box_empty();
        box_add(&box[i], path->item[i].a);
        box_add(&box[i], path->item[i].b);
    }
    struct box_tree *tree = box_tree_new(box, path->n);
    free(box);
    return tree;
}

static struct vec3 nearest_centre(const struct centre_segment *segment, struct vec3 p)
{
    return vec_segment_nearest(segment->a, segment->b, p);
}

static double segment_distance2(const void *items, size_t item, struct vec3 p)
{
    const struct centre_segment *segment = items;
    struct vec3 d = vec_sub(p, nearest_centre(&segment[item], p));
    return vec_dot(d, d);
}

/* ---- is a point among places where the ball touches the part, or beside them? */

struct surroundings {
    const struct centre_segment *segment;
    struct vec3 p, u, v; /* the point; two directions at right angles to the view on it */
    double reach;
    unsigned marks; /* a bit for each sector with a cut in it */
};

/* Which sixteenth of a turn, from 0, the direction (x, y) lies in. */
static int sector_of(double x, double y)
{
    const double eighth = 0.41421356237309503; /* tangent of 22.5 degrees */
    double across = fabs(x), up = fabs(y);
    int k = (up >= eighth * across) + (up >= across) + (eighth * up >= across);
    if (x < 0)
        k = SECTORS / 2 - 1 - k;
    return y < 0 ? SECTORS - 1 - k : k;
}

/* Marks the sectors of the nearest place of a segment and of its ends, within reach. */
static void mark_sectors(struct surroundings *s, const struct centre_segment *segment)
{
    struct vec3 near = nearest_centre(segment, s->p);
    double far2 = s->reach * s->reach - vec_dot(vec_sub(near, s->p), vec_sub(near, s->p));
    if (far2 < 0)
        return;
    double length = vec_distance(segment->a, segment->b), far = sqrt(far2);
    struct vec3 along = vec_unit(vec_sub(segment->b, segment->a));
    double at = vec_dot(vec_sub(near, segment->a), along);
    const struct vec3 place[3] = {vec_along(near, -fmin(far, at), along), near,
                                  vec_along(near, fmin(far, length - at), along)};
    for (int i = 0; i < 3; i++) {
        struct vec3 d = vec_sub(place[i], s->p);
        double x = vec_dot(d, s->u), y = vec_dot(d, s->v);
        if (x * x + y * y >= 1e-12)
            s->marks |= 1u << sector_of(x, y);
    }
}

/* True if no GAP sectors in a row are free; beside a straight border half a turn is. */
static bool all_around(unsigned marks)
{
    unsigned twice = marks | marks << SECTORS;
    const unsigned gap = (1u << GAP) - 1;
    for (int i = 0; i < SECTORS; i++)
        if (!(twice >> i & gap))
            return false;
    return true;
}

static bool visit_segment(void *context, size_t item)
{
    struct surroundings *s = context;
    if (!s->segment[item].on)
        return false;
    mark_sectors(s, &s->segment[item]);
    return all_around(s->marks);
}

/* More than that is left on a point that is not cut. */
static double most_left(const struct deviation_map_options *options)
{
    return fmin(options->tolerance, options->limit);
}

/* The normal of the part at its i-th point, to either side; with points along a line the direction
 * from there to the ball.  Who looked from the ball at a point beside a region, from which that is
 * to one side, would see cuts above and below. */
static struct vec3 view_on(const struct rolling *r, size_t i, struct vec3 centre)
{
    size_t index[ABOUT], n = kdtree_nearest(r->part, r->point[i], ABOUT, index, NULL);
    struct vec3 near[ABOUT];
    struct plane_fit plane;
    for (size_t k = 0; k < n; k++)
        near[k] = r->point[index[k]];
    return plane_fit(near, n, &plane) == 0 ? plane.normal : vec_unit(vec_sub(centre, r->point[i]));
}

/* Seen along the unit vector n: do cuts within `reach` lie around p? */
static bool is_surrounded(const struct rolling *r, struct vec3 p, struct vec3 n, double reach)
{
    struct vec3 u = vec_unit(vec_reject(fabs(n.x) < 0.6 ? vec(1, 0, 0) : vec(0, 1, 0), n));
    struct surroundings s = {r->path->item, p, u, vec_cross(n, u), reach, 0};
    return box_tree_each(r->tree, p, reach, visit_segment, &s);
}

/* ---- the map */

static void roll_points(void *context, size_t from, size_t to)
{
    const struct rolling *r = context;
    const struct deviation_map_options *options = r->options;
    size_t nearest = SIZE_MAX;
    for (size_t i = from; i < to; i++) {
        struct vec3 p = r->point[i];
        double within = options->radius + options->band;
        double most = options->gouges ? options->radius - options->tolerance : HUGE_VAL;
        double distance =
            box_tree_nearest(r->tree, r->path->item, segment_distance2, p, most, &nearest);
        double deviation = distance - options->radius;
        bool found = distance < most, reached = found && distance < within;
        r->map->deviation[i] = found ? deviation : HUGE_VAL;
        r->map->segment[i] = found ? (unsigned)nearest : UINT_MAX;
        if (reached && deviation > most_left(options)) {
            struct vec3 centre = nearest_centre(&r->path->item[nearest], p);
            reached = is_surrounded(r, p, view_on(r, i, centre), within);
        }
        r->map->region[i] = reached;
    }
}

/* Of the points that more is left on than may be, those with one about them that is none of the
 * region are at its border: how far a program was to go there nobody knows. */
static void leave_border(void *context, size_t from, size_t to)
{
    const struct rolling *r = context;
    double most = most_left(r->options);

    for (size_t i = from; i < to; i++) {
        size_t index[ABOUT];
        r->inside[i] = r->map->region[i];
        if (!r->map->region[i] || r->map->deviation[i] <= most)
            continue;
        size_t n = kdtree_nearest(r->part, r->point[i], ABOUT, index, NULL);
        for (size_t k = 0; k < n; k++)
            r->inside[i] = r->inside[i] && r->map->region[index[k]];
    }
}

static void set_percentiles(const double *sorted, size_t n, struct deviation_map *map)
{
    static const double share[DEVIATION_MAP_PERCENTILES] = {0.50, 0.95, 0.99};
    for (int i = 0; n > 0 && i < DEVIATION_MAP_PERCENTILES; i++) {
        size_t rank = (size_t)(share[i] * (double)(n - 1) + 0.5);
        map->over_part[i] = fmax(0, sorted[rank]);
        map->gouge_part[i] = fmax(0, -sorted[n - 1 - rank]);
    }
}

void deviation_map_sum(const struct deviation_map_options *options, struct deviation_map *map)
{
    double *sorted = mem_alloc(map->points, sizeof *sorted);
    map->cut = map->gouged = map->left = map->gouge_at = map->over_at = 0;
    map->gouge = map->over = 0;
    for (size_t i = 0; i < map->points; i++) {
        double deviation = map->deviation[i];
        if (!map->region[i])
            continue;
        sorted[map->cut++] = deviation;
        map->gouged += deviation < -options->tolerance;
        map->left += deviation > options->tolerance;
        if (-deviation > map->gouge) {
            map->gouge = -deviation;
            map->gouge_at = i;
        }
        if (deviation > map->over) {
            map->over = deviation;
            map->over_at = i;
        }
    }
    doubles_sort(sorted, map->cut);
    set_percentiles(sorted, map->cut, map);
    free(sorted);
}

void deviation_map_run(struct centre_path *path, const struct vec3 *point, size_t n,
                       const struct deviation_map_options *options, struct deviation_map *map)
{
    struct box_tree *tree = tree_of(path);
    struct kdtree *part = NULL;
    *map = (struct deviation_map){.points = n};
    map->deviation = mem_alloc(n, sizeof *map->deviation);
    map->segment = mem_alloc(n, sizeof *map->segment);
    map->region = mem_alloc(n, sizeof *map->region);
    struct rolling r = {path, tree, NULL, point, options, 0, map, NULL};
    if (!options->gouges && n > 0) {
        r.part = part = kdtree_new(point, n);
        r.near = touching_distance(&r, n);
        map->touch = r.near - options->radius;
        parallel_for(options->threads, (path->n + GROUP - 1) / GROUP, mark_touching, &r);
    }
    parallel_for(options->threads, n, roll_points, &r);
    if (part) {
        r.inside = mem_alloc(n, sizeof *r.inside);
        parallel_for(options->threads, n, leave_border, &r);
        free(map->region);
        map->region = r.inside;
    }
    kdtree_free(part);
    box_tree_free(tree);
    deviation_map_sum(options, map);
}

void deviation_map_free(struct deviation_map *map)
{
    free(map->deviation);
    free(map->segment);
    free(map->region);
    *map = (struct deviation_map){0};
}
