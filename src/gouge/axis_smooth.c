/* axis_smooth - see axis_smooth.h. */
#include "gouge/axis_smooth.h"

#include <stdlib.h>

enum { SWEEPS = 40, COARSEST = 256 };

static const double OVER = 1.7;   /* over-relaxation */
static const double STILL = 1e-9; /* mm: points no further apart are in one place */

static void set_axis(struct run *run, size_t i, struct vec3 axis)
{
    run->item[i].axis = axis;
    run->item[i].tip = vec_along(run->item[i].ball, -run->radius, axis);
}

/* The axis nearest to a, within the cone about `middle`. */
static struct vec3 into_cone(struct vec3 a, struct vec3 middle, double play)
{
    double off = vec_angle(a, middle);

    return off > play ? vec_slerp(middle, a, play / off) : a;
}

/* One axis towards the mean of its neighbours, the nearer one counting more. */
static void relax_axis(struct run *run, const struct vec3 *middle, double play, size_t before,
                       size_t i, size_t after)
{
    const struct run_point *p = run->item;
    double d0 = fmax(vec_distance(p[before].ball, p[i].ball), STILL);
    double d1 = fmax(vec_distance(p[i].ball, p[after].ball), STILL);
    struct vec3 mean;

    if (before == i)
        mean = p[after].axis;
    else if (after == i)
        mean = p[before].axis;
    else
        mean = vec_mix(p[before].axis, p[after].axis, d0 / (d0 + d1));
    struct vec3 to = vec_unit(vec_mix(p[i].axis, mean, OVER));
    if (vec_length(to) > 0)
        set_axis(run, i, into_cone(to, middle[i], play));
}

/* The index of the next point at this stride; the last one always is one. */
static size_t next_point(size_t i, size_t stride, size_t n)
{
    return i + stride < n ? i + stride : n - 1;
}

static void relax_all(struct run *run, const struct vec3 *middle, double play, size_t stride)
{
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
        for (size_t i = 0, before = 0;; before = i, i = next_point(i, stride, run->n)) {
            relax_axis(run, middle, play, before, i, next_point(i, stride, run->n));
            if (i + 1 == run->n)
                break;
        }
    }
}

/* The axes between the points of a stride, evenly. */
static void interpolate_axes(struct run *run, const struct vec3 *middle, double play, size_t stride)
{
    for (size_t from = 0; from + 1 < run->n; from = next_point(from, stride, run->n)) {
        size_t to = next_point(from, stride, run->n);
        for (size_t i = from + 1; i < to; i++) {
            double s = (double)(i - from) / (double)(to - from);
            struct vec3 a = vec_slerp(run->item[from].axis, run->item[to].axis, s);
            set_axis(run, i, into_cone(a, middle[i], play));
        }
    }
}

void axis_smooth_play(struct run *run, double play)
{
    struct vec3 *middle = mem_alloc(run->n + 1, sizeof *middle);

    for (size_t i = 0; i < run->n; i++)
        middle[i] = run->item[i].axis;
    for (size_t stride = COARSEST; run->n > 2 && stride >= 1; stride /= 2) {
        if (stride >= run->n)
            continue;
        relax_all(run, middle, play, stride);
        interpolate_axes(run, middle, play, stride);
    }
    free(middle);
}

double axis_smooth_fastest(const struct run *run)
{
    double fastest = 0;

    for (size_t i = 1; i < run->n; i++) {
        const struct run_point *a = &run->item[i - 1], *b = &run->item[i];
        double turn = vec_angle(a->axis, b->axis);
        double way = fmin(vec_distance(a->ball, b->ball), vec_distance(a->tip, b->tip));
        if (turn > 1e-9)
            fastest = fmax(fastest, way > STILL ? turn / way : HUGE_VAL);
    }
    return fastest;
}

/* Each axis becomes the mean of those within `half` mm along the path, by the length that each
 * stands for and less the further it is. */
static void average_axes(struct run *run, const struct vec3 *axis, const double *along, double half)
{
    size_t low = 0, high = 0;

    for (size_t i = 0; i < run->n; i++) {
        while (along[i] - along[low] > half)
            low++;
        while (high + 1 < run->n && along[high + 1] - along[i] <= half)
            high++;
        struct vec3 sum = vec_scale(1e-9, axis[i]);
        for (size_t k = low; k < high; k++) {
            double length = along[k + 1] - along[k];
            double near = 1 - fabs((along[k] + along[k + 1]) / 2 - along[i]) / half;
            sum = vec_along(sum, length * fmax(near, 0), vec_add(axis[k], axis[k + 1]));
        }
        struct vec3 mean = vec_unit(sum);
        if (vec_length(mean) > 0)
            set_axis(run, i, mean);
    }
}

/* Where nothing less helps: the mean axis for all. */
static void use_mean_axis(struct run *run, const struct vec3 *axis)
{
    struct vec3 sum = vec(0, 0, 0);

    for (size_t i = 0; i < run->n; i++)
        sum = vec_add(sum, axis[i]);
    struct vec3 mean = vec_length(sum) > 0 ? vec_unit(sum) : axis[0];
    for (size_t i = 0; i < run->n; i++)
        set_axis(run, i, mean);
}

double axis_smooth_rate(struct run *run, double rate)
{
    struct vec3 *axis = mem_alloc(run->n + 1, sizeof *axis);
    double *along = mem_alloc(run->n + 1, sizeof *along), turned = 0;

    for (size_t i = 0; i < run->n; i++) {
        axis[i] = run->item[i].axis;
        along[i] =
            i > 0 ? along[i - 1] + vec_distance(run->item[i].ball, run->item[i - 1].ball) : 0;
    }
    for (double half = 0.5; run->n > 1 && axis_smooth_fastest(run) > rate; half *= 2) {
        if (half > along[run->n - 1]) {
            use_mean_axis(run, axis);
            break;
        }
        average_axes(run, axis, along, half);
    }
    for (size_t i = 0; i < run->n; i++)
        turned = fmax(turned, vec_angle(axis[i], run->item[i].axis));
    free(axis);
    free(along);
    return turned;
}

/* ---- rules */

/* Directions along a path, and their integrals up to each of them. */
struct averaged {
    const struct run_point *point;
    size_t n;
    double *along;
    struct vec3 *rule, *sum;
};

static struct vec3 rule_of(const struct averaged *a, size_t i)
{
    return run_point_touches(&a->point[i]) ? a->rule[i] : vec(0, 0, 0);
}

/* The integral up to a place between the points i and i + 1. */
static struct vec3 sum_at(const struct averaged *a, size_t i, double along)
{
    size_t next = i + 1 < a->n ? i + 1 : i;
    double length = a->along[next] - a->along[i], by = along - a->along[i];
    double s = length > 0 ? by / length : 0;
    struct vec3 from = rule_of(a, i), to = rule_of(a, next);

    return vec_along(a->sum[i], by, vec_mix(from, to, s / 2));
}

/* The last point, from `at` on, that is no further along than this. */
static size_t point_before(const struct averaged *a, size_t at, double along)
{
    while (at + 1 < a->n && a->along[at + 1] <= along)
        at++;
    return at;
}

/* Each direction becomes the mean over `most` mm to both sides, less where an end is nearer, but no
 * less than `least`. */
static void average_once(struct averaged *a, double most, double least)
{
    struct vec3 *mean = mem_alloc(a->n, sizeof *mean);
    double end = a->along[a->n - 1];

    for (size_t i = 0; i + 1 < a->n; i++)
        a->sum[i + 1] = sum_at(a, i, a->along[i + 1]);
    for (size_t i = 0, low = 0, high = 0; i < a->n; i++) {
        double half = fmin(most, fmax(least, fmin(a->along[i], end - a->along[i])));
        double from = fmax(a->along[i] - half, 0), to = fmin(a->along[i] + half, end);
        low = point_before(a, low, from);
        high = point_before(a, high, to);
        mean[i] = vec_unit(vec_sub(sum_at(a, high, to), sum_at(a, low, from)));
    }
    for (size_t i = 0; i < a->n; i++)
        if (run_point_touches(&a->point[i]) && vec_length(mean[i]) > 0)
            a->rule[i] = mean[i];
    free(mean);
}

/* The directions, averaged twice so, in `mean`. */
static void average(struct averaged *a, double most, double least, const struct vec3 *rule,
                    struct vec3 *mean)
{
    for (size_t i = 0; i < a->n; i++)
        mean[i] = rule[i];
    a->rule = mean;
    for (int k = 0; k < 2 && a->n > 1; k++)
        average_once(a, most, least);
}

void axis_smooth_rules(const struct run_point *point, size_t n, double radius, double inward,
                       struct vec3 *rule)
{
    const double most = AXIS_SMOOTH_RULE * radius, least = AXIS_SMOOTH_RULE_LEAST * radius;
    struct averaged a = {point, n, mem_alloc(n + 1, sizeof(double)), NULL,
                         mem_alloc(n + 1, sizeof(struct vec3))};
    struct vec3 *even = mem_alloc(n + 1, sizeof *even), *all = mem_alloc(n + 1, sizeof *all);

    for (size_t i = 1; i < n; i++)
        a.along[i] = a.along[i - 1] + vec_distance(point[i - 1].ball, point[i].ball);
    average(&a, most, least, rule, even);
    average(&a, most, most, rule, all);
    for (size_t i = 0; i < n; i++) {
        double off = vec_angle(even[i], all[i]);
        rule[i] = off > inward ? vec_slerp(even[i], all[i], inward / off) : all[i];
    }
    free(even);
    free(all);
    free(a.along);
    free(a.sum);
}
