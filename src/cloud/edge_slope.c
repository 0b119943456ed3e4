/* edge_slope - see edge_steps.h. */
#include "edge_steps.h"

#include <math.h>
#include <stdlib.h>

static const double CLOSE = 1.4; /* spacings: so near points tell of a foot where there are steps */
static const double STEP = 1;    /* spacings: a wall is higher; ... */
static const double FINE = 0.3;  /* ... where steps are known to be there */
static const double ASIDE = 0.2; /* of the reach: what is above a wall is farther off on average */
static const double AHEAD = 0.9; /* cosine: a point that low is before the wall */
static const double PART = 0.25; /* of a step: points lower by more tell how steep it is below */
static const double BULGED = 1.6; /* a slope goes on as steeply, or so many times more or less */

static int by_height(const void *pa, const void *pb)
{
    const struct vec3 *a = pa, *b = pb;

    return a->z != b->z ? (a->z > b->z) - (a->z < b->z) : vec_compare(a, b);
}

/* Points of the scan above the foot and near to it as seen from above, lowest first. */
static struct vec3s find_above(const struct point_grid *scan, struct vec3 foot, double reach)
{
    struct edge_about about = edge_about_place(scan, foot, reach);
    struct vec3s above = {0};

    for (size_t k; edge_about_next(&about, &k);)
        if (scan->point[k].z > foot.z)
            *array_push(&above) = scan->point[k];
    if (above.n > 0)
        qsort(above.item, above.n, sizeof *above.item, by_height);
    return above;
}

/* The first `low` of the points are below the wall, the others above. */
static bool is_foot(struct vec3 foot, const struct vec3s *point, size_t low, double aside)
{
    double x = 0, y = 0, n = (double)(point->n - low);

    for (size_t k = low; k < point->n; k++) {
        x += (point->item[k].x - foot.x) / n;
        y += (point->item[k].y - foot.y) / n;
    }
    if (!(hypot(x, y) > aside))
        return false;
    for (size_t k = 0; k < low; k++) {
        double u = point->item[k].x - foot.x, v = point->item[k].y - foot.y;
        if (u * x + v * y > AHEAD * hypot(u, v) * hypot(x, y))
            return false;
    }
    return true;
}

/* How many of the points go up from the foot with no such step; *top: the height where they end. */
static size_t climb(const struct vec3s *above, double step, double *top)
{
    size_t low = 0;

    for (; low < above->n && above->item[low].z - *top < step; low++)
        *top = above->item[low].z;
    return low;
}

bool edge_slope_climbs(const struct point_grid *scan, struct vec3 foot, double top)
{
    double spacing = point_grid_spacing(scan), step = FINE * spacing, z = foot.z;
    struct vec3s above = find_above(scan, foot, CLOSE * spacing);

    climb(&above, step, &z);
    array_free(&above);
    return top - z < step;
}

bool edge_slope_seen(const struct point_grid *scan, struct vec3 foot, double top)
{
    double spacing = point_grid_spacing(scan), step = STEP * spacing, z = foot.z;
    double reach = EDGE_REACH * spacing;
    struct vec3s above = find_above(scan, foot, reach);
    size_t low = climb(&above, step, &z);
    bool seen = top - z < step || !is_foot(foot, &above, low, ASIDE * reach);

    array_free(&above);
    return seen;
}

/* A point so far ahead of the foot and below it is on the slope of that step. */
static bool is_on_slope(double ahead, double below, double way, double step)
{
    return ahead * step * BULGED > below * way && ahead * step < BULGED * below * way;
}

bool edge_slope_goes_on(const struct point_grid *scan, struct vec3 foot, struct vec3 rim)
{
    enum { FEWEST = 4, OTHERS = 4 };
    double spacing = point_grid_spacing(scan), step = rim.z - foot.z;
    double x = foot.x - rim.x, y = foot.y - rim.y, way = hypot(x, y);
    struct edge_about about = edge_about_place(scan, foot, EDGE_REACH * spacing);
    size_t same = 0, other = 0;

    if (!(way > FINE * spacing))
        return false;
    for (size_t k; edge_about_next(&about, &k);) {
        struct vec3 to = vec_sub(scan->point[k], foot);
        if (!(-to.z > PART * step) || -to.z > step)
            continue;
        if (is_on_slope((to.x * x + to.y * y) / way, -to.z, way, step))
            same++;
        else
            other++;
    }
    return same >= FEWEST && OTHERS * other <= same;
}
