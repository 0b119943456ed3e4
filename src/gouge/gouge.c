#include "gouge/gouge.h"

#include <stdlib.h>

#include "curve/edge_curve.h"
#include "math/height_pyramid.h"

/* A facet further than this off a vertex's normal spans a step, not a smooth surface. */
static const double SMOOTH = 0.8660254037844386; /* cos 30 degrees */

struct gouge_check {
    struct kdtree *tree;
    struct height_pyramid height_pyramid;
    struct vec3 low, high; /* corners of the box around the points */
};

struct gouge_check *gouge_take(struct vec3s point, int threads)
{
    struct gouge_check *guard = mem_alloc(1, sizeof *guard);

    guard->tree = kdtree_new_by(point.item, point.n, threads);
    guard->height_pyramid = height_pyramid_over(point.item, point.n);
    guard->low = vec(HUGE_VAL, HUGE_VAL, HUGE_VAL);
    guard->high = vec(-HUGE_VAL, -HUGE_VAL, -HUGE_VAL);
    for (size_t i = 0; i < point.n; i++) {
        struct vec3 p = point.item[i];
        guard->low = vec(fmin(guard->low.x, p.x), fmin(guard->low.y, p.y), fmin(guard->low.z, p.z));
        guard->high =
            vec(fmax(guard->high.x, p.x), fmax(guard->high.y, p.y), fmax(guard->high.z, p.z));
    }
    array_free(&point);
    return guard;
}

struct gouge_check *gouge_from_points(const struct vec3 *point, size_t n)
{
    struct vec3s copy = {0};

    for (size_t i = 0; i < n; i++)
        *array_push(&copy) = point[i];
    return gouge_take(copy, 1);
}

/* A curved triangle: control points of a cubic Bezier triangle, named after their corners. */
struct patch {
    struct vec3 corner[3];
    struct vec3 edge[3][2]; /* edge[i]: from corner i to the next, nearer to i first */
    struct vec3 middle;
};

static struct patch patch_of(const struct vec3 *p, const struct vec3 *normal, bool flat)
{
    struct patch patch;
    struct vec3 corners = vec(0, 0, 0), edges = vec(0, 0, 0);

    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        patch.corner[i] = p[i];
        patch.edge[i][0] = flat ? vec_mix(p[i], p[j], 1 / 3.0) : edge_handle(p[i], normal[i], p[j]);
        patch.edge[i][1] = flat ? vec_mix(p[j], p[i], 1 / 3.0) : edge_handle(p[j], normal[j], p[i]);
        corners = vec_add(corners, p[i]);
        edges = vec_add(edges, vec_add(patch.edge[i][0], patch.edge[i][1]));
    }
    /* E + (E - V) / 2: the patch holds a quadratic surface exactly. */
    patch.middle = vec_along(vec_scale(0.25, edges), -1 / 6.0, corners);
    return patch;
}

/* The point with barycentric coordinates b[0..2]. */
static struct vec3 patch_at(const struct patch *patch, const double b[3])
{
    struct vec3 sum = vec_scale(6 * b[0] * b[1] * b[2], patch->middle);

    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        sum = vec_along(sum, b[i] * b[i] * b[i], patch->corner[i]);
        sum = vec_along(sum, 3 * b[i] * b[i] * b[j], patch->edge[i][0]);
        sum = vec_along(sum, 3 * b[i] * b[j] * b[j], patch->edge[i][1]);
    }
    return sum;
}

/* All points of the patch but its corners, on a triangular raster no coarser than `spacing`. */
static void patch_sample(const struct patch *patch, double spacing, struct vec3s *points)
{
    double longest = 0;

    for (int i = 0; i < 3; i++)
        longest = fmax(longest, vec_distance(patch->corner[i], patch->corner[(i + 1) % 3]));
    int cells = (int)fmin(ceil(longest / spacing), 1000);
    for (int i = 0; i <= cells; i++) {
        for (int j = 0; j <= cells - i; j++) {
            int k = cells - i - j;
            if (i == cells || j == cells || k == cells)
                continue;
            double b[3] = {(double)i / cells, (double)j / cells, (double)k / cells};
            *array_push(points) = patch_at(patch, b);
        }
    }
}

struct gouge_check *gouge_from_mesh(const struct mesh *mesh, double spacing)
{
    struct vec3s points = {0};
    bool *used = mem_alloc(mesh->vertex.n, sizeof *used);

    for (size_t f = 0; f < mesh->face.n; f++) {
        struct vec3 across = vec_unit(mesh_face_cross(mesh, f));
        struct vec3 p[3], normal[3];
        bool flat = false;
        for (int i = 0; i < 3; i++) {
            int v = mesh->face.item[f].v[i];
            used[v] = true;
            p[i] = mesh->vertex.item[v];
            normal[i] = mesh->normal.item[v];
            flat = flat || vec_dot(normal[i], across) < SMOOTH;
        }
        struct patch patch = patch_of(p, normal, flat);
        patch_sample(&patch, spacing, &points);
    }
    for (size_t v = 0; v < mesh->vertex.n; v++) {
        if (used[v])
            *array_push(&points) = mesh->vertex.item[v];
    }
    free(used);
    return gouge_take(points, 1);
}

void gouge_free(struct gouge_check *guard)
{
    if (!guard)
        return;
    kdtree_free(guard->tree);
    height_pyramid_free(&guard->height_pyramid);
    free(guard);
}

double gouge_top(const struct gouge_check *guard)
{
    return guard->high.z;
}

double gouge_extent(const struct gouge_check *guard, struct vec3 c, struct vec3 up)
{
    struct vec3 corner =
        vec(up.x > 0 ? guard->high.x : guard->low.x, up.y > 0 ? guard->high.y : guard->low.y,
            up.z > 0 ? guard->high.z : guard->low.z);

    return vec_dot(vec_sub(corner, c), up);
}

double gouge_distance(const struct gouge_check *guard, struct vec3 p, double within)
{
    size_t nearest;

    return kdtree_nearest_segment(guard->tree, p, p, within, &nearest);
}

double gouge_depth(const struct gouge_check *guard, struct vec3 c, double radius)
{
    return radius - gouge_distance(guard, c, HUGE_VAL);
}

/* No guard point is nearer than `within` to a way, for all of them are lower. */
static bool far_over(const struct gouge_check *guard, struct vec3 a, struct vec3 b, double within)
{
    return height_pyramid_top(&guard->height_pyramid, a, b, within) <= fmin(a.z, b.z) - within;
}

double gouge_depth_along(const struct gouge_check *guard, struct vec3 a, struct vec3 b,
                         double radius)
{
    /* In pieces, so that their boxes stay small; what is found bounds the search in the next. */
    double pieces = fmax(1, ceil(vec_distance(a, b) / radius)), nearest = radius;
    size_t index;

    for (double i = 0; i < pieces; i++) {
        struct vec3 from = vec_mix(a, b, i / pieces), to = vec_mix(a, b, (i + 1) / pieces);
        if (!far_over(guard, from, to, nearest))
            nearest = kdtree_nearest_segment(guard->tree, from, to, nearest, &index);
    }
    return radius - nearest;
}

double gouge_lift(const struct gouge_check *guard, struct vec3 c, struct vec3 up, double radius,
                  double limit, struct kdtree_touch *touch)
{
    double lift = kdtree_leave(guard->tree, c, up, radius, limit, touch);

    return lift <= limit ? lift : -1;
}

double gouge_rise(const struct gouge_check *guard, struct vec3 c, struct vec3 up, double radius)
{
    return kdtree_rise(guard->tree, c, up, radius);
}

bool gouge_clear_along(const struct gouge_check *guard, struct vec3 a, struct vec3 b, double radius,
                       double depth)
{
    double within = radius - depth, top = height_pyramid_top(&guard->height_pyramid, a, b, within);

    if (b.z > a.z && top + within < b.z) { /* up to where it is over all points */
        if (top + within < a.z)
            return true;
        b = vec_mix(a, b, (top + within - a.z) / (b.z - a.z));
    }
    double pieces = fmax(1, ceil(vec_distance(a, b) / radius));
    for (double i = 0; i < pieces; i++) {
        struct vec3 from = vec_mix(a, b, i / pieces), to = vec_mix(a, b, (i + 1) / pieces);
        if ((pieces == 1 || !far_over(guard, from, to, within)) &&
            kdtree_any_beside(guard->tree, from, to, within))
            return false;
    }
    return true;
}

bool gouge_free_above(const struct gouge_check *guard, struct vec3 c, double radius)
{
    return height_pyramid_top(&guard->height_pyramid, c, c, radius) <= c.z ||
           !kdtree_any_above(guard->tree, c, radius);
}

bool gouge_open(const struct gouge_check *guard, struct vec3 c, struct vec3 up, double radius,
                double depth)
{
    double end = fmax(gouge_extent(guard, c, up) + radius, 0);

    return gouge_clear_along(guard, c, vec_along(c, end, up), radius, depth);
}

/* A holder where it is. */
struct held {
    const struct holder *holder;
    struct vec3 centre, axis;
};

static double from_holder(const void *context, struct vec3 p)
{
    const struct held *held = context;

    return holder_distance(held->holder, held->centre, held->axis, p);
}

double gouge_holder(const struct gouge_check *guard, const struct holder *holder, struct vec3 c,
                    struct vec3 axis, double below)
{
    struct held held = {holder, c, axis};
    size_t nearest;

    return holder->n > 0 ? kdtree_lowest(guard->tree, from_holder, &held, below, &nearest) : below;
}

bool gouge_holder_clear(const struct gouge_check *guard, const struct holder *holder, struct vec3 c,
                        struct vec3 axis, double least)
{
    struct held held = {holder, c, axis};

    return holder->n == 0 || !kdtree_any_lower(guard->tree, from_holder, &held, least);
}
