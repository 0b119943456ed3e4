/* feature_test - see feature_test.h. */
#include "feature_test.h"

#include "math/neighbourhood_along.h"
#include "math/ridge_direction.h"

enum { CLOSE = 24, STRIP = 48 };

/* How far the points nearest to the crease may be off the sheets in the mean, in mean spacings:
 * further where an edge is rounded. */
static const double ROUND = 0.05;

/* Two sheets in one frame. */
struct pair {
    const struct side_fit *sheet;
    struct vec3 up;
};

/* The mean of the points' distances from the nearer sheet, and their root mean square. */
static void off_sheets(const struct pair *p, const struct vec3 *near, size_t n, double *mean,
                       double *rms)
{
    double sum = 0, sum2 = 0;

    for (size_t i = 0; i < n; i++) {
        double above[2] = {side_fit_above(&p->sheet[0], near[i]),
                           side_fit_above(&p->sheet[1], near[i])};
        double off = fabs(above[0]) < fabs(above[1]) ? above[0] : above[1];
        sum += off;
        sum2 += off * off;
    }
    *mean = sum / (double)n;
    *rms = sqrt(sum2 / (double)n);
}

/* A quadric leaves much less of n points. */
static bool bends(const struct pair *p, const struct feature_cloud *cloud, const struct vec3 *near,
                  size_t n, double left)
{
    double mean, rms;

    off_sheets(p, near, n, &mean, &rms);
    return rms > 1.15 * left * sqrt((double)n / ((double)n - 6.0)) + 0.01 * cloud->spacing &&
           rms > 1.25 * cloud->noise;
}

/* The points nearest to the crease are all on one side of the sheets. */
static bool gapes(const struct pair *p, const struct feature_cloud *cloud, const struct vec3 *near,
                  size_t n)
{
    double mean, rms;

    off_sheets(p, near, n, &mean, &rms);
    return fabs(mean) > 2.5 * cloud->noise / sqrt((double)n) + ROUND * cloud->spacing;
}

/* The same of the points nearest along the crease, which tell of a narrow rib. */
static bool is_rib(const struct pair *p, const struct feature_cloud *cloud, const struct vec3 *near,
                   size_t n, size_t some, struct vec3 at, struct vec3 along)
{
    struct vec3 found[STRIP];
    struct ridge_direction rib;

    if (!ridge_direction_find(near, n, at, p->up, along, some, &rib))
        return false;
    size_t all =
        neighbourhood_along_take(near, n, at, rib.way, RIDGE_DIRECTION_LONGER, some, found);
    if (bends(p, cloud, found, all, rib.rms))
        return true;
    size_t third =
        neighbourhood_along_take(near, n, at, along, RIDGE_DIRECTION_LONGER, some / 3, found);
    return gapes(p, cloud, found, third);
}

bool feature_test_sharp(const struct feature_cloud *cloud, const struct side_fit sheet[2],
                        struct vec3 up, struct vec3 at, struct vec3 along)
{
    struct pair p = {sheet, up};
    size_t index[RIDGE_DIRECTION_LONGER * STRIP];
    struct vec3 near[RIDGE_DIRECTION_LONGER * STRIP];
    struct quadric one;
    size_t n = kdtree_nearest(cloud->tree, at, RIDGE_DIRECTION_LONGER * STRIP, index, NULL);

    if (n < CLOSE)
        return false;
    for (size_t i = 0; i < n; i++)
        near[i] = cloud->point[index[i]];
    if (quadric_fit(near, CLOSE, at, up, &one) == 0 &&
        bends(&p, cloud, near, CLOSE, quadric_rms(&one, near, CLOSE)))
        return false;
    return !gapes(&p, cloud, near, CLOSE / 2) && !is_rib(&p, cloud, near, n, CLOSE, at, along) &&
           !is_rib(&p, cloud, near, n, STRIP, at, along);
}
