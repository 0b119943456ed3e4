/* settle - see settle.h. */
#include "cloud/settle.h"

#include "math/quadric.h"

enum { MOST = 48, FEWEST = 12, TERMS = 6 };

#define ALIKE 1.35 /* times the noise that points may be spread about their quadric */
#define MOVES 6    /* times the noise that a point may move, at most */

struct vec3 settle_point(const struct point_grid *grid, double sigma, struct vec3 p)
{
    struct vec3 near[MOST];
    size_t most = point_grid_near(grid, p, MOST, near);
    for (size_t n = most; n >= FEWEST; n /= 2) {
        struct quadric q;
        if (quadric_fit_free(near, n, p, &q) < 0 ||
            quadric_spread(&q, near, n, TERMS) > ALIKE * sigma)
            continue;
        struct vec3 foot = quadric_nearest(&q, p);
        return vec_distance(foot, p) <= MOVES * sigma ? foot : p;
    }
    return p;
}
