/* strip_triangulate - see adaptive_rows_steps.h. */
#include "adaptive_rows_steps.h"

#include <stdlib.h>

#include "math/quadric.h"

struct strip_search {
    const struct point_grid *point_grid;
    const struct plan_extent *plan_extent;
    double error;
    const struct vec3 *a, *b; /* lower, upper row */
    size_t na, nb;
    double *cost;         /* of the best way up to the edge from a[i] to b[j] */
    unsigned char *along; /* came from: 1 a[i - 1], 2 b[j - 1] */
};

/* How far the cloud is from a place, by a quadric through the nearest points or, where they carry
 * none, their plane. */
static double off_cloud(const struct point_grid *b, struct vec3 at)
{
    enum { NEAR = 16 };
    uint32_t index[NEAR];
    double distance2[NEAR];
    struct vec3 near[NEAR], mean = vec(0, 0, 0);
    struct quadric q;
    size_t n = point_grid_nearest(b, at, NEAR, index, distance2);
    for (size_t k = 0; k < n; k++) {
        near[k] = b->point[index[k]];
        mean = vec_along(mean, 1 / (double)n, near[k]);
    }
    if (quadric_fit(near, n, at, vec(0, 0, 1), &q) == 0)
        return quadric_distance(&q);
    return fabs(vec_dot(plane_normal(near, n), vec_sub(mean, at)));
}

/* An edge costs what the cloud is off its middle; its slant counts a little, so that on a plane the
 * shortest edges are taken. */
static double cost_of(const struct strip_search *z, size_t i, size_t j)
{
    const double aslant =
        0.1; /* of the error, for each time that it is as long as the rows are apart */
    const struct plan_extent *f = z->plan_extent;
    struct vec3 p = z->a[i], q = z->b[j], middle = vec_mix(p, q, 0.5);
    double off = off_cloud(z->point_grid, vec(f->cosine * middle.x - f->sine * middle.y,
                                              f->sine * middle.x + f->cosine * middle.y, middle.z));
    double slant = aslant * z->error * vec_distance(p, q) / fmax(fabs(q.y - p.y), 1e-300);
    return off * off + slant * slant;
}

/* Edges that are so far aslant are not looked at while others can be had. */
static double cost_within(const struct strip_search *z, size_t i, size_t j)
{
    const double aslant = 3, cells = 4;
    double across = fabs(z->b[j].y - z->a[i].y), along = fabs(z->b[j].x - z->a[i].x);
    if (along > fmax(aslant * across, cells * z->point_grid->cell))
        return 1e6 * along * along;
    return cost_of(z, i, j);
}

static void find_costs(struct strip_search *z)
{
    for (size_t i = 0; i < z->na; i++)
        for (size_t j = 0; j < z->nb; j++) {
            size_t at = i * z->nb + j;
            double from_a = i > 0 ? z->cost[at - z->nb] : INFINITY;
            double from_b = j > 0 ? z->cost[at - 1] : INFINITY;
            z->along[at] = from_a <= from_b ? 1 : 2;
            z->cost[at] = (at == 0 ? 0 : fmin(from_a, from_b)) + cost_within(z, i, j);
        }
}

void strip_triangulate(const struct point_grid *point_grid, const struct plan_extent *plan_extent,
                       double error, const struct row_simplify *lower,
                       const struct row_simplify *upper, struct faces *faces)
{
    struct strip_search z = {
        point_grid,    plan_extent, error, lower->node.item, upper->node.item, lower->node.n,
        upper->node.n, NULL,        NULL};
    struct faces down = {0};
    if (z.na == 0 || z.nb == 0)
        return;
    z.cost = mem_alloc(z.na * z.nb, sizeof *z.cost);
    z.along = mem_alloc(z.na * z.nb, 1);
    find_costs(&z);
    size_t first = faces->n;
    for (size_t i = z.na - 1, j = z.nb - 1; i + j > 0;) {
        int a = (int)i, b = (int)(z.na + j);
        if (z.along[i * z.nb + j] == 1) {
            *array_push(faces) = (struct face){{a - 1, a, b}};
            i--;
        } else {
            *array_push(&down) = (struct face){{a, b, b - 1}};
            j--;
        }
    }
    for (size_t i = first, j = faces->n; i + 1 < j; i++) { /* found from right to left */
        struct face f = faces->item[i];
        faces->item[i] = faces->item[--j];
        faces->item[j] = f;
    }
    while (down.n > 0) {
        struct face f = down.item[--down.n];
        *array_push(faces) = f;
    }
    array_free(&down);
    free(z.cost);
    free(z.along);
}
