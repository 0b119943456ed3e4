/* edge_cliff_find - see edge_cliff.h. */
#include "edge_cliff.h"

/* A point so far below a flank, by its distance, is down a wall; where the other side is known,
 * too, and lies as far below: down a step. */
static const double WALL = 0.9, STEP = 0.1;
static const double THROWN = 8;   /* noises: a point of many is off by less */
static const double CORNER = 1.5; /* spacings */
static const double FAIR = 0.1;   /* spacings: so far off its points a flank tells of a wall yet */
static const double STEEP_STEP = 0.35; /* of the way: so high over it no surface is the same */
static const double EVEN_SINKS =
    2.5;                           /* sinkings of the ball: a flank that is even is off by less */
static const double MANY_OFF = 25; /* times as high as a flank is off its points: a step */
static const double SURELY_OFF = 100; /* and one where little about is known, too */
static const double FARTHER = 4;      /* spacings: farther than that a flank is a plane */

/* ---- the flank, continued */

/* On the plane through `from` with that normal, over (x, y). */
static struct vec3 plane_above(struct vec3 from, struct vec3 n, double x, double y)
{
    return vec(x, y, from.z - (n.x * (x - from.x) + n.y * (y - from.y)) / n.z);
}

/* A normal, or one no steeper than EDGE_STEEP. */
static struct vec3 roof_normal(struct vec3 n)
{
    n.z = fmax(n.z, hypot(n.x, n.y) / EDGE_STEEP);
    return vec_unit(n);
}

struct vec3 edge_cliff_place(const struct edge_cliff *cliff, double x, double y)
{
    const struct quadric *q = &cliff->flank->q;
    struct vec3 n = quadric_normal_at(q, cliff->from);
    struct vec3 p = quadric_nearest(q, plane_above(cliff->from, n, x, y));

    return edge_plan_distance(p, cliff->from) <= cliff->reach
               ? p
               : plane_above(cliff->from, roof_normal(n), x, y);
}

bool edge_cliff_reaches(const struct edge_cliff *cliff, struct vec3 at)
{
    const double far = 3; /* times the reach */

    return vec_distance(at, cliff->from) <= far * cliff->reach;
}

double edge_cliff_above(const struct edge_flank *flank, struct vec3 own, struct vec3 p)
{
    struct vec3 normal;

    if (vec_distance(p, own) <= FARTHER * flank->spacing)
        return edge_flank_above(flank, p, &normal);
    return vec_dot(quadric_normal_at(&flank->q, own), vec_sub(p, own));
}

/* How far a point is above the flank as one that walls hang from: far off it is no steeper than
 * EDGE_STEEP. */
static double above_roof(const struct edge_cliff *cliff, struct vec3 p)
{
    struct vec3 n = quadric_normal_at(&cliff->flank->q, cliff->from);

    if (vec_distance(p, cliff->from) <= FARTHER * cliff->flank->spacing)
        return edge_cliff_above(cliff->flank, cliff->from, p);
    return vec_dot(roof_normal(n), vec_sub(p, cliff->from));
}

/* So far off the flank of point i a point k is on it. */
static double least_off(const struct edge_work *work, size_t i, size_t k)
{
    return edge_within(work, fmax(work->flank[i].spacing, work->flank[k].spacing));
}

bool edge_cliff_is_under(const struct edge_cliff *cliff, size_t k)
{
    return above_roof(cliff, cliff->work->options->point_grid->point[k]) <
           -least_off(cliff->work, cliff->i, k);
}

/* ---- what a flank is off its points tells of a wall */

bool edge_cliff_is_fair(const struct edge_flank *flank)
{
    return edge_flank_known(flank) && flank->rms <= FAIR * flank->spacing;
}

bool edge_cliff_is_even(const struct edge_work *work, size_t i)
{
    const struct edge_flank *flank = &work->flank[i];

    return edge_flank_known(flank) && flank->rms <= EVEN_SINKS * work->options->sink &&
           flank->rms <= EDGE_EVEN * flank->spacing && edge_on_known(work, i);
}

/* A step so high is none that the surface of a flank, however far off its points, may take. */
static bool is_high(const struct edge_work *work, size_t k, double step)
{
    const struct edge_flank *flank = &work->flank[k];

    return edge_cliff_is_fair(flank) && step > MANY_OFF * flank->rms &&
           (step > SURELY_OFF * flank->rms || edge_on_known(work, k));
}

/* A wall stands on the flank of point k, so far from the rim, which is so high over it and it over
 * the rim's: one that is only fair may, nearer, be the same surface, unless it is even, or is off
 * its points by a small part of the step, and the step so steep that it is none. */
static bool is_sure(const struct edge_work *work, size_t k, double far, double step)
{
    const struct edge_flank *flank = &work->flank[k];

    return edge_flank_certain(work, flank) ||
           (far > EDGE_FOOT * flank->spacing && edge_cliff_is_fair(flank)) ||
           (step > STEEP_STEP * far && (edge_cliff_is_even(work, k) || is_high(work, k, step)));
}

/* ---- the points about, sorted */

/* Points below the flank whose own surface the point is not above are beyond an edge. */
static void sort_by_height(struct edge_cliff *cliff, size_t k)
{
    const struct edge_work *work = cliff->work;
    const struct edge_flank *other = &work->flank[k];
    const struct vec3 p = work->options->point_grid->point[k];
    double off = above_roof(cliff, p), least = least_off(work, cliff->i, k);

    if (fabs(off) <= least) {
        *array_push(&cliff->on) = p;
        return;
    }
    if (!(off < 0))
        return;
    *array_push(&cliff->under) = p;
    double far = vec_distance(p, cliff->from);
    double down = edge_flank_known(other) ? edge_cliff_above(other, p, cliff->from) : 0;
    if (edge_flank_known(other) && down <= least)
        *array_push(&cliff->beyond) = k;
    else if (off < -WALL * far ||
             (off < -STEP * far && down > STEP * far && is_sure(work, k, far, fmin(-off, down))))
        *array_push(&cliff->below) = p;
}

/* A point about is not surely on the flank of point i. */
static bool may_be_off(const struct edge_work *work, size_t i)
{
    const struct vec3 *point = work->options->point_grid->point;
    struct edge_about about = edge_about(work, i);

    for (size_t k; edge_about_next(&about, &k);)
        if (!quadric_surely_within(&work->flank[i].q, point[k], least_off(work, i, k)))
            return true;
    return false;
}

/* One point alone is down a wall, and no further than noise throws one of many. */
static bool is_stray(const struct edge_cliff *cliff)
{
    return cliff->below.n == 1 &&
           -above_roof(cliff, cliff->below.item[0]) < THROWN * cliff->work->options->noise;
}

/* How far the points under the flank are below it, and away from the point. */
struct drops {
    double high, low, near, far;
};

static struct drops measure_drops(const struct edge_cliff *cliff)
{
    struct drops drops = {.low = HUGE_VAL, .near = HUGE_VAL};

    for (size_t k = 0; k < cliff->under.n; k++) {
        double drop = -above_roof(cliff, cliff->under.item[k]);
        double way = vec_distance(cliff->under.item[k], cliff->from);
        drops.high = fmax(drops.high, drop);
        drops.low = fmin(drops.low, drop);
        drops.near = fmin(drops.near, way);
        drops.far = fmax(drops.far, way);
    }
    return drops;
}

/* What is under the flank is as far below it wherever it is, as no slope is: its points, though too
 * few to tell of a surface, are those of a floor, and a step is before these. */
static void find_floor(struct edge_cliff *cliff)
{
    enum { FEWEST = 3 };
    const double level = 0.25;              /* of what a slope's heights differ by */
    size_t sure = cliff->below.n, next = 0; /* of those under it, in their order */
    struct drops d = measure_drops(cliff);

    if (cliff->under.n < FEWEST || (d.high - d.low) * d.far > level * d.high * (d.far - d.near))
        return;
    for (size_t k = 0; k < cliff->under.n; k++) {
        struct vec3 p = cliff->under.item[k];
        if (next < sure && vec_distance(p, cliff->below.item[next]) <= 0)
            next++;
        else if (d.low > STEEP_STEP * vec_distance(p, cliff->from))
            *array_push(&cliff->below) = p;
    }
}

struct edge_cliff edge_cliff_find(const struct edge_work *work, size_t i)
{
    struct edge_about about = edge_about(work, i);
    struct edge_cliff cliff = {.work = work,
                               .i = i,
                               .flank = &work->flank[i],
                               .from = about.from,
                               .reach = about.reach,
                               .corner = CORNER * point_grid_spacing(work->options->point_grid)};

    if (may_be_off(work, i))
        for (size_t k; edge_about_next(&about, &k);)
            sort_by_height(&cliff, k);
    if (cliff.beyond.n == 0)
        find_floor(&cliff);
    if (is_stray(&cliff))
        cliff.below.n = 0;
    cliff.feet = cliff.below.n;
    return cliff;
}

void edge_cliff_free(struct edge_cliff *cliff)
{
    array_free(&cliff->on);
    array_free(&cliff->below);
    array_free(&cliff->under);
    array_free(&cliff->beyond);
}

void edge_cliff_keep_feet(struct edge_cliff *cliff, bool certain)
{
    const struct point_grid *scan = cliff->work->options->point_grid;
    bool doubtful = !certain || cliff->on.n < EDGE_FEWEST;
    struct vec3 *below = cliff->below.item;

    cliff->feet = 0;
    for (size_t k = 0; k < cliff->below.n; k++) {
        struct vec3 foot = below[k];
        double top = edge_cliff_place(cliff, foot.x, foot.y).z;
        if (doubtful && (certain ? edge_slope_climbs : edge_slope_seen)(scan, foot, top))
            continue;
        if (edge_slope_goes_on(scan, foot, vec(cliff->from.x, cliff->from.y, top)))
            continue;
        below[k] = below[cliff->feet];
        below[cliff->feet++] = foot;
    }
}

struct vec3 edge_cliff_nearest_below(const struct edge_cliff *cliff, struct vec3 at)
{
    struct vec3 foot = cliff->below.item[0];

    for (size_t k = 1; k < cliff->below.n; k++)
        if (edge_plan_distance(cliff->below.item[k], at) < edge_plan_distance(foot, at))
            foot = cliff->below.item[k];
    return foot;
}
