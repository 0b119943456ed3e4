/* strip_triangulate - see adaptive_rows_steps.h. */
#include "adaptive_rows_steps.h"

#include <stdlib.h>

struct strip_search {
    const struct cell_surfaces *cells;
    const struct plan_extent *plan_extent;
    double error;
    const struct vec3 *a, *b; /* lower, upper row */
    size_t na, nb;
    double *cost;         /* of the best way up to the edge from a[i] to b[j] */
    unsigned char *along; /* came from: 1 a[i - 1], 2 b[j - 1] */
};

/* An edge costs what the cloud is off its middle; its slant counts a little, so that on a plane the
 * shortest edges are taken. */
static double cost_of(const struct strip_search *z, size_t i, size_t j)
{
    const double aslant =
        0.1; /* of the error, for each time that it is as long as the rows are apart */
    const struct plan_extent *f = z->plan_extent;
    struct vec3 p = z->a[i], q = z->b[j], middle = vec_mix(p, q, 0.5);
    double off =
        cell_surfaces_off(z->cells, vec(f->cosine * middle.x - f->sine * middle.y,
                                        f->sine * middle.x + f->cosine * middle.y, middle.z));
    double slant = aslant * z->error * vec_distance(p, q) / fmax(fabs(q.y - p.y), 1e-300);
    return off * off + slant * slant;
}

/* Edges that are so far aslant are not looked at while others can be had. */
static double cost_within(const struct strip_search *z, size_t i, size_t j)
{
    const double aslant = 3, cells = 2;
    double across = fabs(z->b[j].y - z->a[i].y), along = fabs(z->b[j].x - z->a[i].x);
    if (along > fmax(aslant * across, cells * z->cells->scan->cell))
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
            /* of rows as good as one all ways cost without end */
            z->along[at] = i > 0 && (j == 0 || from_a <= from_b) ? 1 : 2;
            z->cost[at] = (at == 0 ? 0 : fmin(from_a, from_b)) + cost_within(z, i, j);
        }
}

void strip_triangulate(const struct cell_surfaces *cells, const struct plan_extent *plan_extent,
                       double error, const struct row_simplify *lower,
                       const struct row_simplify *upper, struct faces *faces)
{
    struct strip_search z = {
        cells,         plan_extent, error, lower->node.item, upper->node.item, lower->node.n,
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
