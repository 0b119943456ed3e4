/* edge_foot - see edge_steps.h.  As simulate/unseen_wall.h, by its own formulas, takes a wall for
 * one that a scan has no points on. */
#include "edge_steps.h"

/* Under noise a wall between two levels is higher, in spacings; by its height these are even. */
static const double LEVELS = 3, UNEVEN = 0.5;

/* Heights from the lowest up to `level`, and those from near[high] on, are of two levels. */
static bool is_step(const struct vec3s *near, size_t high, double level)
{
    double below = level - fmin(level, near->item[0].z), foot = near->item[high].z;

    return fmax(below, near->item[near->n - 1].z - foot) < UNEVEN * (foot - level);
}

/* In spacings about a foot, half of whose plane is empty: they are wider than those of the scan by
 * the root of two.  Noise spreads heights: there a wall must be higher, unless it is a step. */
static double least_wall(const struct edge_work *work, const struct vec3s *near, size_t high,
                         double level)
{
    if (!(work->options->noise > 0))
        return EDGE_FOOT / sqrt(2);
    return is_step(near, high, level) ? LEVELS : EDGE_FOOT;
}

void edge_wall_add(const struct edge_work *work, struct vec3 at, struct vec3 foot, struct vec3s *to)
{
    enum { MOST = 60 };
    double parts = fmin(ceil((at.z - foot.z) / work->options->along), MOST);

    for (double part = 1; part < parts; part++)
        *array_push(to) = vec(at.x, at.y, at.z + part / parts * (foot.z - at.z));
}

static int by_height(const void *pa, const void *pb)
{
    const struct vec3 *a = pa, *b = pb;

    return (a->z > b->z) - (a->z < b->z);
}

/* The points about point i that are no farther, seen from above, than a wall may be; lowest
 * first.  None where thousands are: what they stand over each other on was scanned. */
static struct vec3s places_about(const struct edge_work *work, size_t i, double reach)
{
    enum { CROWD = 2000 };
    struct edge_about about = edge_about(work, i);
    struct vec3 from = about.from;
    struct vec3s near = {0};

    for (size_t k; near.n < CROWD && edge_about_next(&about, &k);)
        if (edge_plan_distance(about.walk.grid->point[k], from) < reach)
            *array_push(&near) = about.walk.grid->point[k];
    near.n = near.n < CROWD ? near.n : 0;
    if (near.n > 0)
        qsort(near.item, near.n, sizeof *near.item, by_height);
    return near;
}

/* Of near[from] on, the nearest to p seen from above. */
static size_t nearest_of(const struct vec3s *near, size_t from, struct vec3 p)
{
    size_t nearest = from;

    for (size_t k = from + 1; k < near->n; k++)
        if (edge_plan_distance(near->item[k], p) < edge_plan_distance(near->item[nearest], p))
            nearest = k;
    return nearest;
}

/* The high points, from near[high] on, are on one side of p, and no low one is before these. */
static bool is_at_foot(const struct vec3s *near, size_t high, struct vec3 p, double reach)
{
    const double aside = 0.2, ahead = 0.9; /* of the reach; cosine of 25 degrees */
    double x = 0, y = 0;

    for (size_t k = high; k < near->n; k++) {
        x += (near->item[k].x - p.x) / (double)(near->n - high);
        y += (near->item[k].y - p.y) / (double)(near->n - high);
    }
    if (hypot(x, y) < aside * reach)
        return false;
    for (size_t k = 0; k < high; k++) {
        double u = near->item[k].x - p.x, v = near->item[k].y - p.y;
        if (x * u + y * v > ahead * hypot(x, y) * hypot(u, v))
            return false;
    }
    return true;
}

/* From the rim over a point straight down to it. */
static void hang_wall(const struct edge_work *work, const struct vec3s *near, size_t high,
                      struct vec3 foot, struct vec3s *to)
{
    const double nearly = 0.9;
    struct vec3 rim = near->item[nearest_of(near, high, foot)];
    struct vec3 at = vec_mix(rim, foot, nearly);

    edge_wall_add(work, vec(at.x, at.y, rim.z), foot, to);
}

/* Something steep is over the point. */
static bool may_be_foot(const struct edge_work *work, size_t i)
{
    struct edge_about about = edge_about(work, i);
    struct vec3 from = about.from;

    for (size_t k; edge_about_next(&about, &k);) {
        struct vec3 p = about.walk.grid->point[k];
        if (p.z - from.z > EDGE_STEEP * edge_plan_distance(p, from))
            return true;
    }
    return false;
}

/* Mean distance of the points next to it, mm. */
static double spacing_at(const struct edge_work *work, size_t i)
{
    enum { BESIDE = 6 };
    const struct edge_points_options *o = work->options;
    uint32_t index[BESIDE + 1];
    double distance2[BESIDE + 1];
    size_t n = near_lists_nearest(o->near, o->point_grid, i, BESIDE + 1, index, distance2);

    return n > 1 ? sqrt(PI * distance2[n - 1] / (double)(n - 1)) : 0;
}

void edge_foot_add(const struct edge_work *work, size_t i, struct vec3s *to)
{
    struct vec3 p = work->options->point_grid->point[i];

    if (!may_be_foot(work, i))
        return;
    double spacing = spacing_at(work, i), level = p.z;
    struct vec3s near = places_about(work, i, EDGE_REACH * spacing);

    for (size_t k = 0; k < near.n; k++) {
        double low = level, step = near.item[k].z - low;
        level = fmax(level, near.item[k].z);
        if (!(step > spacing))
            continue;
        struct vec3 rim = near.item[nearest_of(&near, k, p)];
        if (!(step > EDGE_STEEP * edge_plan_distance(rim, p) + spacing))
            continue;
        if (!(step > least_wall(work, &near, k, low) * spacing))
            break;
        if (is_at_foot(&near, k, p, EDGE_REACH * spacing) &&
            !edge_slope_goes_on(work->options->point_grid, p, rim))
            hang_wall(work, &near, k, p, to);
        break;
    }
    array_free(&near);
}
