/* extend - see extend.h. */
#include "cloud/extend.h"

#include <stdbool.h>
#include <stdlib.h>

#include "math/elementary.h"
#include "math/side_fit.h"
#include "math/kdtree.h"
#include "base/parallel.h"

enum { FEWEST = 40, FEWEST_NOISY = 150, MOST = 1600 };

static const double MOST_CELLS = 2e7;
static const double STEEPEST = 2; /* way along a surface for that seen from above: 60 degrees */

/* Squares about the cloud, and the points seen from above. */
struct plan {
    double x, y, cell;
    size_t columns, rows;
    struct vec3 *flat; /* the points with z = 0 */
    size_t n;
    struct kdtree *tree; /* of these */
    double *off;         /* of the middle of each square from the nearest point, mm */
};

struct continuation {
    const struct plan *plan;
    const struct vec3 *point;
    size_t near; /* points that a place is continued from */
    struct vec3 *place;
};

static struct vec3 middle_of(const struct plan *p, size_t cell)
{
    size_t row = cell / p->columns, column = cell % p->columns;
    return vec(p->x + ((double)column + 0.5) * p->cell, p->y + ((double)row + 0.5) * p->cell, 0);
}

static void measure_clearance(void *context, size_t from, size_t to)
{
    struct plan *p = context;

    for (size_t i = from; i < to; i++) {
        size_t nearest;
        double distance2 = 0;
        kdtree_nearest(p->tree, middle_of(p, i), 1, &nearest, &distance2);
        p->off[i] = sqrt(distance2);
    }
}

static int make_plan(const struct vec3s *points, double spacing, double margin, int threads,
                     struct plan *p, struct error *error)
{
    double xmax = -HUGE_VAL, ymax = -HUGE_VAL;

    *p = (struct plan){.x = HUGE_VAL, .y = HUGE_VAL, .cell = spacing, .n = points->n};
    for (size_t i = 0; i < points->n; i++) {
        p->x = fmin(p->x, points->item[i].x);
        p->y = fmin(p->y, points->item[i].y);
        xmax = fmax(xmax, points->item[i].x);
        ymax = fmax(ymax, points->item[i].y);
    }
    p->x -= margin;
    p->y -= margin;
    double columns = ceil((xmax + margin - p->x) / spacing);
    double rows = ceil((ymax + margin - p->y) / spacing);
    if (!(columns * rows < MOST_CELLS))
        return error_set(error,
                         "a strip of %g mm about the cloud takes %.0f squares of %g mm, "
                         "expected fewer than %.0f",
                         margin, columns * rows, spacing, MOST_CELLS);
    p->columns = (size_t)columns;
    p->rows = (size_t)rows;
    p->flat = mem_alloc(points->n, sizeof *p->flat);
    for (size_t i = 0; i < points->n; i++)
        p->flat[i] = vec(points->item[i].x, points->item[i].y, 0);
    p->tree = kdtree_new(p->flat, p->n);
    p->off = mem_alloc(p->columns * p->rows, sizeof *p->off);
    parallel_for(threads, p->columns * p->rows, measure_clearance, p);
    return 0;
}

static void free_plan(struct plan *p)
{
    kdtree_free(p->tree);
    free(p->flat);
    free(p->off);
}

static void reach_cell(const struct plan *p, size_t cell, double clear, bool *seen,
                       struct sizes *next)
{
    if (seen[cell] || p->off[cell] <= clear)
        return;
    seen[cell] = true;
    *array_push(next) = cell;
}

/* The squares that a disc comes to from the outside without touching a point. */
static struct sizes find_outside(const struct plan *p, double clear)
{
    bool *seen = mem_alloc(p->columns * p->rows, sizeof *seen);
    struct sizes next = {0};

    reach_cell(p, 0, 0, seen, &next);
    for (size_t i = 0; i < next.n; i++) {
        size_t cell = next.item[i], column = cell % p->columns, row = cell / p->columns;
        if (column > 0)
            reach_cell(p, cell - 1, clear, seen, &next);
        if (column + 1 < p->columns)
            reach_cell(p, cell + 1, clear, seen, &next);
        if (row > 0)
            reach_cell(p, cell - p->columns, clear, seen, &next);
        if (row + 1 < p->rows)
            reach_cell(p, cell + p->columns, clear, seen, &next);
    }
    free(seen);
    return next;
}

/* The places of the strip, on z = 0: what such discs reach, and is no further off than `length`. */
static struct vec3s find_places(const struct plan *p, const struct sizes *out, double clear,
                                double length)
{
    struct vec3s places = {0};
    struct vec3 *middle = mem_alloc(out->n, sizeof *middle);

    for (size_t i = 0; i < out->n; i++)
        middle[i] = middle_of(p, out->item[i]);
    struct kdtree *tree = kdtree_new(middle, out->n);
    for (size_t cell = 0; cell < p->columns * p->rows; cell++) {
        size_t nearest;
        double distance2 = HUGE_VAL, off = p->off[cell];
        if (off > length || off < 0.75 * p->cell)
            continue;
        kdtree_nearest(tree, middle_of(p, cell), 1, &nearest, &distance2);
        if (sqrt(distance2) < (off > clear ? p->cell / 2 : clear - off + p->cell))
            *array_push(&places) = middle_of(p, cell);
    }
    kdtree_free(tree);
    free(middle);
    return places;
}

static void continue_surface(void *context, size_t from, size_t to)
{
    const struct continuation *c = context;
    size_t index[MOST];
    struct vec3 near[MOST] = {{0}};

    for (size_t i = from; i < to; i++) {
        struct vec3 *place = &c->place[i];
        struct side_fit f;
        size_t n = kdtree_nearest(c->plan->tree, *place, c->near, index, NULL);
        for (size_t k = 0; k < n; k++)
            near[k] = c->point[index[k]];
        struct vec3 origin = vec(place->x, place->y, near[0].z);
        if (side_fit_plane(near, n, origin, vec(0, 0, 1), &f) < 0)
            place->z = near[0].z;
        else {
            side_fit_bend(near, n, &f);
            *place = side_fit_point(&f, origin);
        }
    }
}

/* How many points a place is continued from: the half disc that is as wide as the strip, twice as
 * wide where there is noise. */
static size_t points_needed(double spacing, double length, double noise)
{
    double wide = fmax(length / spacing, 3) * (1 + fmin(30 * noise / spacing, 1));

    return (size_t)fmin(fmax(PI / 2 * wide * wide, noise > 0 ? FEWEST_NOISY : FEWEST), MOST);
}

/* From one corner to the other seen from above. */
static double width_of(const struct vec3s *points)
{
    double x0 = HUGE_VAL, y0 = HUGE_VAL, x1 = -HUGE_VAL, y1 = -HUGE_VAL;

    for (size_t i = 0; i < points->n; i++) {
        struct vec3 p = points->item[i];
        x0 = fmin(x0, p.x);
        y0 = fmin(y0, p.y);
        x1 = fmax(x1, p.x);
        y1 = fmax(y1, p.y);
    }
    return hypot(x1 - x0, y1 - y0);
}

/* Appends the places that are near enough in space: along a wall a short way seen from above is a
 * long one. */
static void add_near(struct vec3s *points, const struct vec3s *places, double most, int threads)
{
    struct kdtree *tree = kdtree_new_by(points->item, points->n, threads);

    for (size_t i = 0; i < places->n; i++) {
        size_t nearest;
        double distance2;
        if (kdtree_nearest(tree, places->item[i], 1, &nearest, &distance2) == 1 &&
            distance2 <= most * most)
            *array_push(points) = places->item[i];
    }
    kdtree_free(tree);
}

int extend_cloud(struct vec3s *points, double spacing, double gap, double length, double noise,
                 int threads, struct error *error)
{
    struct plan plan;
    double clear = gap / 2, width = width_of(points);

    if (length > width)
        return error_set(error,
                         "to be extended by %g mm, expected at most its own width of %.4g mm, "
                         "beyond which nothing is known of its surface",
                         length, width);
    if (make_plan(points, spacing, length + gap, threads, &plan, error) < 0)
        return -1;
    struct sizes out = find_outside(&plan, clear);
    struct vec3s places = find_places(&plan, &out, clear, length);
    struct continuation c = {&plan, points->item, points_needed(spacing, length, noise),
                             places.item};
    parallel_for(threads, places.n, continue_surface, &c);
    add_near(points, &places, STEEPEST * length, threads);
    array_free(&places);
    array_free(&out);
    free_plan(&plan);
    return 0;
}
