/* gouge - see gouge.h. */
#include "gouge/gouge.h"

#include <stdlib.h>

#include "math/box.h"
#include "math/height_pyramid.h"
#include "math/kdtree.h"
#include "math/sphere_grid.h"

struct gouge_check {
    struct kdtree *tree;
    struct height_pyramid heights;
    struct box box; /* around the points */
};

struct gouge_check *gouge_new(struct vec3s point, int threads)
{
    struct gouge_check *guard = mem_alloc(1, sizeof *guard);

    guard->tree = kdtree_new_by(point.item, point.n, threads);
    guard->heights = height_pyramid_over(point.item, point.n);
    guard->box = box_around(point.item, point.n);
    array_free(&point);
    return guard;
}

struct gouge_check *gouge_from_points(const struct vec3 *point, size_t n)
{
    struct vec3s copy = {0};

    for (size_t i = 0; i < n; i++)
        *array_push(&copy) = point[i];
    return gouge_new(copy, 1);
}

void gouge_free(struct gouge_check *guard)
{
    if (!guard)
        return;
    kdtree_free(guard->tree);
    height_pyramid_free(&guard->heights);
    free(guard);
}

double gouge_top(const struct gouge_check *guard)
{
    return guard->box.high.z;
}

double gouge_extent(const struct gouge_check *guard, struct vec3 c, struct vec3 up)
{
    struct vec3 corner = vec(up.x > 0 ? guard->box.high.x : guard->box.low.x,
                             up.y > 0 ? guard->box.high.y : guard->box.low.y,
                             up.z > 0 ? guard->box.high.z : guard->box.low.z);

    return vec_dot(vec_sub(corner, c), up);
}

double gouge_distance(const struct gouge_check *guard, struct vec3 p, double within)
{
    size_t nearest;

    return kdtree_nearest_segment(guard->tree, p, p, within, &nearest);
}

double gouge_nearest(const struct gouge_check *guard, struct vec3 p, double within,
                     struct vec3 *nearest)
{
    return kdtree_nearest_place(guard->tree, p, within, nearest);
}

double gouge_depth(const struct gouge_check *guard, struct vec3 c, double radius)
{
    return radius - gouge_distance(guard, c, HUGE_VAL);
}

/* No guard point is nearer than `within` to the segment, because all of them are lower. */
static bool far_over(const struct gouge_check *guard, struct vec3 a, struct vec3 b, double within)
{
    return height_pyramid_top(&guard->heights, a, b, within) <= fmin(a.z, b.z) - within;
}

double gouge_depth_along(const struct gouge_check *guard, struct vec3 a, struct vec3 b,
                         double radius)
{
    /* In pieces, whose boxes are small; what one finds bounds the search of the next. */
    double pieces = fmax(1, ceil(vec_distance(a, b) / radius)), nearest = radius;
    size_t index;

    for (double i = 0; i < pieces; i++) {
        struct vec3 from = vec_mix(a, b, i / pieces), to = vec_mix(a, b, (i + 1) / pieces);
        if (!far_over(guard, from, to, nearest))
            nearest = kdtree_nearest_segment(guard->tree, from, to, nearest, &index);
    }
    return radius - nearest;
}

void gouge_points_beside(const struct gouge_check *guard, struct vec3 a, struct vec3 b,
                         double within, struct vec3s *points)
{
    kdtree_beside(guard->tree, a, b, within, points);
}

double gouge_least_lift(const struct gouge_check *guard, struct vec3 c, struct vec3 up,
                        double radius, double limit, struct kdtree_touch *touch)
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
    double within = radius - depth, top = height_pyramid_top(&guard->heights, a, b, within);

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
    return height_pyramid_top(&guard->heights, c, c, radius) <= c.z ||
           !kdtree_any_above(guard->tree, c, radius);
}

bool gouge_open(const struct gouge_check *guard, struct vec3 c, struct vec3 up, double radius,
                double depth)
{
    double end = fmax(gouge_extent(guard, c, up) + radius, 0);

    return gouge_clear_along(guard, c, vec_along(c, end, up), radius, depth);
}

/* Direction k of n, evenly over the sphere down to ten degrees above the level. */
static struct vec3 direction_of(int k, int n)
{
    return sphere_spiral(k, 1 - (1 - sin(PI / 18)) * (k + 0.5) / n);
}

bool gouge_open_anyhow(const struct gouge_check *guard, struct vec3 c, struct vec3 normal,
                       double radius, double depth)
{
    enum { DIRECTIONS = 32 };
    struct vec3 half = vec_unit(vec_add(normal, vec(0, 0, 1)));

    if (gouge_free_above(guard, c, radius - depth) ||
        (normal.z >= 0 && gouge_open(guard, c, normal, radius, depth)) ||
        (half.z > 0 && gouge_open(guard, c, half, radius, depth)))
        return true;
    for (int k = 0; k < DIRECTIONS; k++) {
        struct vec3 way = direction_of(k, DIRECTIONS);
        if (vec_dot(way, normal) > 0 && gouge_open(guard, c, way, radius, depth))
            return true;
    }
    return false;
}

/* Shank and holder in one pose. */
struct holder_pose {
    const struct holder *holder;
    struct vec3 centre, axis;
};

static double from_holder(const void *context, struct vec3 p, double below)
{
    const struct holder_pose *pose = context;

    return holder_distance_below(pose->holder, pose->centre, pose->axis, p, below);
}

static double bound_from_holder(const void *context, struct vec3 middle, struct vec3 half,
                                double below)
{
    const struct holder_pose *pose = context;

    return holder_bound_below(pose->holder, pose->centre, pose->axis, middle, half, below);
}

double gouge_holder(const struct gouge_check *guard, const struct holder *holder, struct vec3 c,
                    struct vec3 axis, double below)
{
    struct holder_pose pose = {holder, c, axis};
    struct kdtree_field field = {from_holder, bound_from_holder, &pose};

    return holder->n > 0 ? kdtree_lowest(guard->tree, &field, below, NULL) : below;
}

bool gouge_holder_clear(const struct gouge_check *guard, const struct holder *holder, struct vec3 c,
                        struct vec3 axis, double least)
{
    struct holder_pose pose = {holder, c, axis};
    struct kdtree_field field = {from_holder, bound_from_holder, &pose};

    return holder->n == 0 || !kdtree_any_lower(guard->tree, &field, least);
}

/* One point of each box that is small enough. */
struct thinning {
    double gap;
    int within; /* the depth of the box that a point is wanted of, or that has given one */
    bool wanted;
    bool *kept;
    size_t n;
    struct box *around;
};

static bool look_into(void *context, int depth, struct vec3 middle, struct vec3 half)
{
    struct thinning *t = context;

    (void)middle;
    if (t->within >= 0 && depth > t->within)
        return false;
    t->within = 2 * vec_length(half) <= t->gap ? depth : -1;
    t->wanted = true;
    return true;
}

static void take_point(void *context, int depth, struct vec3 p, size_t index)
{
    struct thinning *t = context;

    if (t->within >= 0 && depth > t->within)
        return;
    if (t->within < 0 || depth < t->within || t->wanted) {
        t->kept[index] = true;
        t->n++;
        box_add(t->around, p);
    }
    t->wanted = t->wanted && depth != t->within;
}

size_t gouge_thinned(const struct gouge_check *guard, double gap, bool *kept, struct box *around)
{
    struct thinning t = {gap, -1, false, kept, 0, around};
    struct kdtree_visitor visitor = {look_into, take_point, &t};

    *around = box_empty();
    gouge_visit(guard, guard->box.low, &visitor);
    return t.n;
}

size_t gouge_points(const struct gouge_check *guard)
{
    return kdtree_points(guard->tree);
}

void gouge_visit(const struct gouge_check *guard, struct vec3 from,
                 const struct kdtree_visitor *visitor)
{
    kdtree_visit(guard->tree, from, visitor);
}
