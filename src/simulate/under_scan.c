/* under_scan - see under_scan.h. */
#include "simulate/under_scan.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/parallel.h"
#include "math/height_pyramid.h"
#include "math/kdtree.h"

enum {
    PARTS = 4,     /* of a piece, for its length */
    HALVINGS = 24, /* for how far a line is from the tool's middle */
    GROUP = 128    /* pieces that one thread looks at, at a time */
};

#define ALONG 0.25 /* of the radius: places along the motion are so far apart */
#define UP 0.25    /* of the radius: those up the tool */

struct search {
    const struct under_scan_options *options;
    struct kdtree *tree; /* of the roof */
    struct height_pyramid heights;
    double reach, widest;     /* of the tool */
    struct under_scan *found; /* of each group of pieces */
};

/* The ball's centre and the axis at s of a piece. */
static struct nc_motion_pose pose_at(const struct search *s, size_t piece, double t)
{
    return nc_motion_ball(s->options->motion, piece, t, s->options->radius);
}

/* How far the nearest upright line from a roof point down to the bottom is from a place, where that
 * is nearer than `within`; else HUGE_VAL. */
static double line_distance(const struct search *s, struct vec3 place, double within)
{
    double below = fmax(0, s->options->bottom - place.z);
    double near = 0, far = sqrt(fmax(0, within * within - below * below));

    if (below >= within || !kdtree_any_above(s->tree, place, far))
        return HUGE_VAL;
    for (int i = 0; i < HALVINGS; i++) {
        double middle = (near + far) / 2;
        if (kdtree_any_above(s->tree, place, middle))
            far = middle;
        else
            near = middle;
    }
    return hypot(far, below);
}

/* The tool where it stands; true if any of it is deeper than is allowed. */
static bool look_at_pose(const struct search *s, struct nc_motion_pose pose, size_t piece,
                         struct under_scan *found)
{
    const struct under_scan_options *o = s->options;
    struct vec3 end = vec_along(pose.p, s->reach, pose.a);
    bool deep = false;

    if (height_pyramid_top(&s->heights, pose.p, end, s->widest) <= fmin(pose.p.z, end.z))
        return false;
    for (double h = 0; h <= s->reach; h += h > 0 ? UP * o->radius : o->radius) {
        struct vec3 at = vec_along(pose.p, h, pose.a);
        /* of the sphere about `at` that is in the tool */
        double width = h > 0 ? -tool_shape_distance(o->tool, pose.p, pose.a, at) : o->radius;
        double within = width - o->allowed;
        if (within <= 0 || height_pyramid_top(&s->heights, at, at, within) <= at.z)
            continue;
        double depth = width - line_distance(s, at, within);
        if (depth <= o->allowed)
            continue;
        deep = true;
        if (depth > found->depth) {
            width = h > 0 ? tool_shape_radius(o->tool, h) : o->radius;
            *found = (struct under_scan){depth, piece, at, h, width, found->pieces};
        }
    }
    return deep;
}

static void look_at_piece(const struct search *s, size_t piece, struct under_scan *found)
{
    struct nc_motion_pose last = pose_at(s, piece, 0);
    double length = 0;
    bool deep = false;

    for (int i = 1; i <= PARTS; i++) {
        struct nc_motion_pose next = pose_at(s, piece, (double)i / PARTS);
        length += vec_distance(last.p, next.p) + s->reach * vec_angle(last.a, next.a);
        last = next;
    }
    double places = ceil(length / (ALONG * s->options->radius));
    for (double i = 1; i <= fmax(places, 1); i++)
        deep = look_at_pose(s, pose_at(s, piece, i / fmax(places, 1)), piece, found) || deep;
    found->pieces += deep;
}

static void look_at_groups(void *context, size_t from, size_t to)
{
    const struct search *s = context;
    size_t n = s->options->motion->piece.n;

    for (size_t g = from; g < to; g++)
        for (size_t i = g * GROUP; i < (g + 1) * GROUP && i < n; i++)
            look_at_piece(s, i, &s->found[g]);
}

struct under_scan under_scan_find(const struct under_scan_options *options, const struct vec3 *roof,
                                  size_t n)
{
    size_t groups = (options->motion->piece.n + GROUP - 1) / GROUP, pieces = 0;
    struct search s = {.options = options,
                       .reach = options->tool->n > 0 ? tool_shape_reach(options->tool) : 0,
                       .widest = fmax(options->radius, tool_shape_widest(options->tool))};
    struct under_scan deepest = {0};

    if (n == 0 || groups == 0)
        return deepest;
    s.tree = kdtree_new_by(roof, n, options->threads);
    s.heights = height_pyramid_over(roof, n);
    s.found = mem_alloc(groups, sizeof *s.found);
    parallel_for(options->threads, groups, look_at_groups, &s);
    for (size_t g = 0; g < groups; g++) {
        pieces += s.found[g].pieces;
        if (s.found[g].depth > deepest.depth)
            deepest = s.found[g];
    }
    deepest.pieces = pieces;
    free(s.found);
    kdtree_free(s.tree);
    height_pyramid_free(&s.heights);
    return deepest;
}
