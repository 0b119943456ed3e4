/* coverage_judge - see coverage_judge.h. */
#include "coverage_judge.h"

#include <stdlib.h>

#include "cloud/judged_scan.h"
#include "cloud/plan_extent.h"
#include "math/kdtree.h"
#include "math/point_grid.h"
#include "math/sphere_grid.h"
#include "simulate/part_coverage.h"

enum { AXES = 500 }; /* over the whole sphere */

static const double TURN = 5;     /* degrees between directions of a single rotary axis */
static const double SLACK = 1e-9; /* radians, of a travel */

/* ---- the directions of the machine */

static bool reaches(const struct kinematic_chain *chain, struct vec3 axis)
{
    struct chain_solutions s = chain_angles(chain, axis);
    bool any = false;

    for (int k = 0; k < s.n; k++) {
        bool within = true;
        for (int i = 0; i < chain->n; i++) {
            double middle = (chain->rotary[i].min + chain->rotary[i].max) / 2;
            double q = angle_nearest(s.q[k][i], middle);
            bool any_angle = s.free && i == 0;
            within = within && (any_angle || (q >= chain->rotary[i].min - SLACK &&
                                              q <= chain->rotary[i].max + SLACK));
        }
        any = any || within;
    }
    return any;
}

struct vec3s coverage_judge_axes(const struct kinematic_chain *chain)
{
    struct vec3s axes = {0};

    *array_push(&axes) = chain->tool;
    for (double turn = -180; chain->n == 1 && turn < 180; turn += TURN) {
        const double q[ROTARY_MAX] = {RADIANS(turn)};
        struct vec3 axis = chain_axis(chain, q);
        if (q[0] >= chain->rotary[0].min && q[0] <= chain->rotary[0].max && axis.z >= 0)
            *array_push(&axes) = axis;
    }
    for (int k = 0; chain->n == 2 && k < AXES / 2; k++) {
        struct vec3 axis = sphere_spiral(k, 1 - (2 * k + 1.0) / AXES);
        if (reaches(chain, axis))
            *array_push(&axes) = axis;
    }
    return axes;
}

/* ---- the question */

/* Moves the places of a scan to where they are without noise.  What a ball may not be in besides
 * them, and which of them lie under a roof. */
static void find_solid(struct vec3s *place, double radius, double noise, bool unseen, int threads,
                       struct vec3s *curtain, unsigned char *under)
{
    struct plan_extent extent = plan_extent_of(place->item, place->n, 0);
    double spacing = plan_extent_spacing(&extent, place->item, place->n);
    struct point_grid grid;
    struct error error;

    if (point_grid_make(place->item, place->n, spacing > 0 ? spacing : 1, threads, &grid, &error) <
        0)
        return;
    if (unseen)
        judged_scan_unseen(&grid, radius, noise, threads, curtain);
    judged_scan_settle(&grid, radius, noise, threads, under, curtain);
    point_grid_free(&grid);
}

void coverage_judge_settle(struct vec3s *scan, double radius, double noise, int threads)
{
    struct vec3s curtain = {0};
    unsigned char *under = mem_alloc(scan->n, 1);

    find_solid(scan, radius, noise, false, threads, &curtain, under);
    array_free(&curtain);
    free(under);
}

/* The tool as a judge has it. */
static struct tool_shape shape_of(const struct holder *holder)
{
    struct tool_shape shape = {.n = 0};
    double height = 0;

    for (int i = 0; i < holder->n; i++) {
        const struct holder_part *part = &holder->part[i];
        tool_shape_add(&shape,
                       (struct tool_span){height, height + part->length, part->low, part->high});
        height += part->length;
    }
    return shape;
}

/* Of each place what is asked of it: of those that are, more than the limit is left. */
static double *left_of(const struct vec3 *point, const double *height, size_t n,
                       const struct vec3s *place, const struct coverage_judge_options *options,
                       size_t *of)
{
    double *left = mem_alloc(place->n, sizeof *left);
    struct kdtree *tree = kdtree_new_by(place->item, place->n, options->threads);

    for (size_t i = 0; i < place->n; i++)
        left[i] = 0;
    for (size_t i = 0; i < n; i++) {
        size_t at;
        if (!(height[i] > 0) || kdtree_nearest(tree, point[i], 1, &at, NULL) == 0)
            continue;
        left[at] = options->limit + height[i];
        of[at] = i;
    }
    kdtree_free(tree);
    return left;
}

/* Of those that were asked for; what is on the others is set to 0. */
static size_t count_left(double *height, size_t n, const size_t *of, const double *left,
                         const struct part_coverage *judged, size_t places)
{
    size_t found = 0;
    bool *is_left = mem_alloc(n + 1, sizeof *is_left);

    for (size_t i = 0; i < n; i++)
        is_left[i] = false;
    for (size_t i = 0; i < places; i++)
        if (left[i] > 0 && judged->of[i] == COVERAGE_LEFT)
            is_left[of[i]] = true;
    for (size_t i = 0; i < n; i++) {
        height[i] = is_left[i] ? height[i] : 0;
        found += is_left[i];
    }
    free(is_left);
    return found;
}

static size_t ask(const struct vec3 *point, double *height, size_t n, struct vec3s *place,
                  const struct coverage_judge_options *options)
{
    size_t *of = mem_alloc(place->n, sizeof *of);
    struct vec3s curtain = {0}, axes = coverage_judge_axes(options->chain);
    unsigned char *under = mem_alloc(place->n, 1);

    for (size_t i = 0; i < place->n; i++)
        under[i] = 0;
    if (options->scan)
        find_solid(place, options->radius, options->noise, options->unseen, options->threads,
                   &curtain, under);
    double *left = left_of(point, height, n, place, options, of);
    struct tool_shape tool = shape_of(options->holder);
    const struct part_coverage_options how = {.radius = options->radius,
                                              .limit = options->limit,
                                              .near = options->near,
                                              .tool = &tool,
                                              .axis = &axes,
                                              .curtain = &curtain,
                                              .whole = !options->scan,
                                              .left_only = true,
                                              .threads = options->threads};
    struct part_coverage judged;
    part_coverage_run(place->item, left, under, place->n, &how, &judged);
    size_t found = count_left(height, n, of, left, &judged, place->n);
    part_coverage_free(&judged);
    array_free(&curtain);
    array_free(&axes);
    free(under);
    free(of);
    free(left);
    return found;
}

size_t coverage_judge_left(const struct vec3 *point, double *height, size_t n, struct vec3s *place,
                           const struct coverage_judge_options *options)
{
    bool asked = false;

    for (size_t i = 0; i < n; i++)
        asked = asked || height[i] > 0;
    return asked ? ask(point, height, n, place, options) : 0;
}
