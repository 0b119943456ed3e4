/* smooth_normals - see smooth_normals.h. */
#include "smooth_normals.h"

#include <stdlib.h>

enum { TIMES = 2 };

static const double SQUARE = 0.05; /* cosine: a mean further off a normal is not taken */

/* Normals along a row, and their integrals up to each point. */
struct row {
    const struct run *run;
    double *along;
    struct vec3 *sum;
};

/* The integral of the normals up to a place, which is no further on than the point i + 1. */
static struct vec3 sum_at(const struct row *row, size_t i, double along)
{
    const struct run_point *p = row->run->item;
    double length = row->along[i + 1] - row->along[i], by = along - row->along[i];

    return vec_along(row->sum[i], by,
                     vec_mix(p[i].normal, p[i + 1].normal, length > 0 ? by / length / 2 : 0));
}

/* The mean over `half` mm to both sides of point i; `low` and `high` are pieces of the row at or
 * before those where that begins and ends, and go on to them. */
static struct vec3 mean_at(const struct row *row, size_t i, double half, size_t *low, size_t *high)
{
    double end = row->along[row->run->n - 1], at = row->along[i];
    double reach = fmin(half, fmin(at, end - at));

    while (*low + 2 < row->run->n && row->along[*low + 1] <= at - reach)
        ++*low;
    while (*high + 2 < row->run->n && row->along[*high + 1] <= at + reach)
        ++*high;
    return vec_unit(vec_sub(sum_at(row, *high, at + reach), sum_at(row, *low, at - reach)));
}

static void average_once(struct row *row, struct run *run, double half)
{
    struct vec3 *mean = mem_alloc(run->n, sizeof *mean);

    for (size_t i = 0; i + 1 < run->n; i++)
        row->sum[i + 1] = sum_at(row, i, row->along[i + 1]);
    for (size_t i = 0, low = 0, high = 0; i < run->n; i++)
        mean[i] = mean_at(row, i, half, &low, &high);
    for (size_t i = 0; i < run->n; i++)
        if (vec_dot(mean[i], run->item[i].normal) > SQUARE)
            run->item[i].normal = mean[i];
    free(mean);
}

void smooth_normals(struct run *run, double half)
{
    struct row row = {run, mem_alloc(run->n + 1, sizeof(double)),
                      mem_alloc(run->n + 1, sizeof(struct vec3))};

    for (size_t i = 1; i < run->n; i++)
        row.along[i] =
            row.along[i - 1] + vec_distance(run->item[i - 1].contact, run->item[i].contact);
    for (int k = 0; k < TIMES && run->n > 2; k++)
        average_once(&row, run, half);
    free(row.along);
    free(row.sum);
}
