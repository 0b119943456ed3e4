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

static bool clear_along(const struct gouge_check *guard, struct vec3 a, struct vec3 b,
                        double radius, double depth, struct kdtree_touch *touch)
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
            kdtree_find_beside(guard->tree, from, to, within, touch))
            return false;
    }
    return true;
}

bool gouge_clear_along(const struct gouge_check *guard, struct vec3 a, struct vec3 b, double radius,
                       double depth)
{
    return clear_along(guard, a, b, radius, depth, NULL);
}

bool gouge_free_above(const struct gouge_check *guard, struct vec3 c, double radius)
{
    return height_pyramid_top(&guard->heights, c, c, radius) <= c.z ||
           !kdtree_any_above(guard->tree, c, radius);
}

static bool is_open(const struct gouge_check *guard, struct vec3 c, struct vec3 up, double radius,
                    double depth, struct kdtree_touch *touch)
{
    double end = fmax(gouge_extent(guard, c, up) + radius, 0);
    struct vec3 out = vec_along(c, end, up);

    if (touch && touch->n > 0 &&
        kdtree_nearest_among(touch->p, 1, c, out, radius - depth) < radius - depth)
        return false;
    return clear_along(guard, c, out, radius, depth, touch);
}

bool gouge_open(const struct gouge_check *guard, struct vec3 c, struct vec3 up, double radius,
                double depth)
{
    return is_open(guard, c, up, radius, depth, NULL);
}

/* Direction k of n, evenly over the sphere down to ten degrees above the level. */
static struct vec3 direction_of(int k, int n)
{
    return sphere_spiral(k, 1 - (1 - sin(PI / 18)) * (k + 0.5) / n);
}

bool gouge_open_anyhow(const struct gouge_check *guard, struct vec3 c, struct vec3 normal,
                       double radius, double depth, struct gouge_ways *ways)
{
    struct vec3 half = vec_unit(vec_add(normal, vec(0, 0, 1)));

    if (gouge_free_above(guard, c, radius - depth) ||
        (normal.z >= 0 && is_open(guard, c, normal, radius, depth, ways ? &ways->normal : NULL)) ||
        (half.z > 0 && is_open(guard, c, half, radius, depth, ways ? &ways->half : NULL)))
        return true;
    for (int k = 0; k < GOUGE_WAYS; k++) {
        struct vec3 way = direction_of(k, GOUGE_WAYS);
        if (vec_dot(way, normal) > 0 &&
            is_open(guard, c, way, radius, depth, ways ? &ways->touch[k] : NULL))
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
                        struct vec3 axis, double least, struct kdtree_touch *touch)
{
    struct holder_pose pose = {holder, c, axis};
    struct kdtree_field field = {from_holder, bound_from_holder, &pose};

    return holder->n == 0 || !kdtree_any_lower(guard->tree, &field, least, touch);
}

/* Shank and holder on their way, the axis as it is. */
struct holder_way {
    const struct holder *holder;
    struct vec3 from, along, axis; /* from one end to the other */
    double length;
};

/* The nearest that p is on a part of the way, or, where that is not lower than `below`, anything
 * that is not: no point of the holder moves farther than its centre. */
static double least_on_way(const struct holder_way *way, struct vec3 p, double first, double last,
                           double below)
{
    double middle = (first + last) / 2, half = way->length * (last - first) / 2;
    struct vec3 c = vec_along(way->from, middle, way->along);
    double least = holder_distance_below(way->holder, c, way->axis, p, below + half);

    if (least < below || least - half >= below || 2 * half <= GOUGE_STEP)
        return least;
    least = least_on_way(way, p, first, middle, below);
    return least < below ? least : least_on_way(way, p, middle, last, below);
}

static double from_way(const void *context, struct vec3 p, double below)
{
    return least_on_way(context, p, 0, 1, below);
}

/* The box is on its way past the holder as the holder on its way past the box. */
static double bound_from_way(const void *context, struct vec3 middle, struct vec3 half,
                             double below)
{
    const struct holder_way *way = context;
    struct vec3 d = vec_scale(0.5, way->along), c = vec_add(way->from, d);

    half = vec_add(half, vec(fabs(d.x), fabs(d.y), fabs(d.z)));
    return holder_bound_below(way->holder, c, way->axis, middle, half, below);
}

bool gouge_holder_clear_along(const struct gouge_check *guard, const struct holder *holder,
                              struct vec3 a, struct vec3 b, struct vec3 axis, double least,
                              struct kdtree_touch *touch)
{
    const double piece = 1; /* mm: what is about a short way is soon told */
    double pieces = fmax(1, ceil(vec_distance(a, b) / piece));

    for (double i = 0; i < pieces && holder->n > 0; i++) {
        struct vec3 from = vec_mix(a, b, i / pieces), to = vec_mix(a, b, (i + 1) / pieces);
        struct holder_way way = {holder, from, vec_sub(to, from), axis, vec_distance(from, to)};
        struct kdtree_field field = {from_way, bound_from_way, &way};
        if (kdtree_any_lower(guard->tree, &field, least, touch))
            return false;
    }
    return true;
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
