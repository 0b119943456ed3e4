/* net_corners - see net_corners.h. */
#include "net_corners.h"

#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/array.h"
#include "base/parallel.h"
#include "math/cubic.h"

enum { NEAR = 30, NEAR_NOISY = 80, FEWER = 20, MOST = 160 };

static const double NOISY = 0.004; /* of the spacing */
static const double BESIDE = 2;    /* spacings: farther from all points nothing is known */
static const double CERTAIN = 1;   /* of the variance of a point */

struct net_corners net_corners_new(const struct vec3 *point, size_t n, double mean, double noise)
{
    struct vec3 *flat = mem_alloc(n, sizeof *flat);

    for (size_t i = 0; i < n; i++)
        flat[i] = vec(point[i].x, point[i].y, 0);
    struct net_corners corners = {point, kdtree_new(flat, n), mean,
                                  noise > NOISY * mean ? NEAR_NOISY : NEAR};
    free(flat);
    return corners;
}

void net_corners_free(struct net_corners *corners)
{
    kdtree_free(corners->tree);
}

/* The surface through the n nearest points, of the third degree where these tell the height at the
 * place about as well as one of them would, else of the second. */
static bool fit_near(const struct vec3 *near, size_t n, struct vec3 at, bool third,
                     struct quadric *q)
{
    struct vec3 up = vec(0, 0, 1);

    if (third && cubic_fit(near, NULL, n, at, up, q) == 0 && q->variance < CERTAIN)
        return true;
    return !third && quadric_fit(near, n, at, up, q) == 0;
}

/* One node, by the points about it.  False: there are none. */
static bool find_corner(const struct net_corners *c, struct net_patches *net, size_t k)
{
    size_t index[MOST];
    double distance2[MOST];
    struct vec3 near[MOST];
    size_t column = k % net->columns, row = k / net->columns;
    struct vec3 at = vec(net->x + net->dx * (double)column, net->y + net->dy * (double)row, 0);
    struct quadric q;
    size_t n = kdtree_nearest(c->tree, at, MOST, index, distance2);

    if (n == 0 || distance2[0] > BESIDE * BESIDE * c->mean * c->mean)
        return false;
    for (size_t i = 0; i < n; i++)
        near[i] = c->point[index[i]];
    at.z = near[0].z;
    bool found = false;
    for (size_t some = c->neighbours; some <= n && !found; some *= 2)
        found = fit_near(near, some, at, true, &q);
    if (!found && !fit_near(near, n < FEWER ? n : FEWER, at, false, &q) &&
        !fit_near(near, n, at, false, &q))
        return false;
    net->z[k] = at.z + q.c[0];
    net->zx[k] = q.c[1] * q.u.x + q.c[2] * q.v.x;
    net->zy[k] = q.c[1] * q.u.y + q.c[2] * q.v.y;
    return true;
}

struct finding {
    const struct net_corners *corners;
    struct net_patches *net;
    unsigned char *known;
};

static void find_some(void *context, size_t from, size_t to)
{
    struct finding *f = context;

    for (size_t k = from; k < to; k++)
        f->known[k] = find_corner(f->corners, f->net, k);
}

/* A node that nothing is known of: the mean of the planes through the known ones beside it. */
static bool go_on(struct net_patches *net, const unsigned char *known, size_t k)
{
    size_t column = k % net->columns, row = k / net->columns, count = 0;
    double z = 0, zx = 0, zy = 0;

    for (int j = -1; j <= 1; j++)
        for (int i = -1; i <= 1; i++) {
            if ((i < 0 && column == 0) || (i > 0 && column + 1 == net->columns) ||
                (j < 0 && row == 0) || (j > 0 && row + 1 == net->rows))
                continue;
            size_t m = k + (size_t)i + (size_t)j * net->columns;
            if (!known[m])
                continue;
            z += net->z[m] - i * net->dx * net->zx[m] - j * net->dy * net->zy[m];
            zx += net->zx[m];
            zy += net->zy[m];
            count++;
        }
    if (count == 0)
        return false;
    net->z[k] = z / (double)count;
    net->zx[k] = zx / (double)count;
    net->zy[k] = zy / (double)count;
    return true;
}

void net_corners_find(const struct net_corners *corners, struct net_patches *net, int threads)
{
    size_t n = net->columns * net->rows;
    struct finding f = {corners, net, mem_alloc(n, 1)};
    unsigned char *next = mem_alloc(n, 1);
    bool more = true;

    parallel_for(threads, n, find_some, &f);
    while (more) { /* a ring of nodes each time */
        more = false;
        memcpy(next, f.known, n);
        for (size_t k = 0; k < n; k++)
            if (!f.known[k] && go_on(net, f.known, k)) {
                next[k] = 1;
                more = true;
            }
        memcpy(f.known, next, n);
    }
    free(next);
    free(f.known);
}
