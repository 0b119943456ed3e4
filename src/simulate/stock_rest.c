/* stock_rest - see stock_rest.h. */
#include "simulate/stock_rest.h"

#include <stdbool.h>
#include <stdlib.h>

enum {
    STEPS = 4, /* along the slope, to the nearest place */
    UNDER = 4  /* columns that a point may be under the highest of its column */
};

/* The surface that one comes to from z upward in a column; above all material the top of it. */
static double surface_of(const struct stock *s, int i, int j, double z)
{
    const struct stock_column *c = stock_at(s, i, j);
    struct stock_interval at = {c->low, c->high, c->more};
    for (;;) {
        if (at.low >= at.high || (at.low > z && at.more == STOCK_NONE))
            return s->bottom;
        if (at.low <= z || at.more == STOCK_NONE)
            return at.high;
        at = s->more.item[at.more];
    }
}

/* Height and slopes of the surface at (x, y). */
struct spot {
    double height, slope_x, slope_y;
};

static struct spot spot_at(const struct stock *s, double x, double y, double z)
{
    double u = fmin(fmax((x - s->x) / s->dx, 0), s->nx - 1);
    double v = fmin(fmax((y - s->y) / s->dy, 0), s->ny - 1);
    int i = (int)fmin(u, s->nx - 2), j = (int)fmin(v, s->ny - 2);
    double a = surface_of(s, i, j, z), b = surface_of(s, i + 1, j, z);
    double c = surface_of(s, i, j + 1, z), d = surface_of(s, i + 1, j + 1, z);
    u -= i;
    v -= j;
    double low = a + u * (b - a), high = c + u * (d - c);
    return (struct spot){low + v * (high - low), (b - a + v * (d - c - b + a)) / s->dx,
                         (high - low) / s->dy};
}

double stock_rest_at(const struct stock *s, struct vec3 p)
{
    double x = p.x, y = p.y, best = HUGE_VAL;
    for (int k = 0; k < STEPS; k++) {
        struct spot at = spot_at(s, x, y, p.z);
        if (k == 0 && at.height <= p.z)
            return 0;
        best = fmin(best, vec_distance(p, vec(x, y, at.height)));
        /* the foot of p on the plane that touches there */
        double rise = at.height - p.z + at.slope_x * (p.x - x) + at.slope_y * (p.y - y);
        double n2 = at.slope_x * at.slope_x + at.slope_y * at.slope_y + 1;
        x = p.x - at.slope_x * rise / n2;
        y = p.y - at.slope_y * rise / n2;
    }
    return best;
}

static size_t tile_of(const struct stock *s, struct vec3 p)
{
    size_t i, j;
    stock_nearest(s, p, &i, &j);
    return j / STOCK_TILE * (size_t)s->tiles_x + i / STOCK_TILE;
}

/* Which points are measured: not those far under the highest of their column. */
static bool *points_in_sight(const struct vec3 *point, size_t n, const struct stock *s)
{
    size_t *column = mem_alloc(n, sizeof *column);
    double *highest = stock_highest(s, point, n, column);
    bool *asked = mem_alloc(n, sizeof *asked);
    for (size_t i = 0; i < n; i++)
        asked[i] = point[i].z >= highest[column[i]] - UNDER * fmax(s->dx, s->dy);
    free(highest);
    free(column);
    return asked;
}

static size_t bin_of(const struct stock_rest *rest, double thick)
{
    return (size_t)fmin(thick / rest->bin, STOCK_REST_BINS - 1);
}

struct stock_rest stock_rest_new(const struct vec3 *point, size_t n, const struct stock *s)
{
    struct stock_rest rest = {.point = point};
    size_t tiles = (size_t)s->tiles_x * (size_t)s->tiles_y;
    double top = s->bottom;
    bool *asked = points_in_sight(point, n, s);
    rest.order = mem_alloc(n, sizeof *rest.order);
    rest.thick = mem_alloc(n, sizeof *rest.thick);
    rest.first = mem_alloc(tiles + 2, sizeof *rest.first);
    rest.count = mem_alloc(STOCK_REST_BINS, sizeof *rest.count);
    for (size_t i = 0; i < n; i++)
        rest.first[tile_of(s, point[i]) + 2] += asked[i];
    for (size_t k = 2; k < tiles + 2; k++)
        rest.first[k] += rest.first[k - 1];
    for (size_t i = 0; i < n; i++)
        if (asked[i])
            rest.order[rest.first[tile_of(s, point[i]) + 1]++] = i;
    free(asked);
    rest.points = rest.first[tiles];
    for (int k = 0; k < s->nx * s->ny; k++)
        top = fmax(top, s->column[k].high);
    rest.bin = fmax(top - s->bottom, 1e-9) / STOCK_REST_BINS;
    for (size_t i = 0; i < rest.points; i++) {
        rest.thick[i] = (float)stock_rest_at(s, point[rest.order[i]]);
        rest.count[bin_of(&rest, (double)rest.thick[i])]++;
    }
    return rest;
}

void stock_rest_free(struct stock_rest *rest)
{
    free(rest->order);
    free(rest->first);
    free(rest->thick);
    free(rest->count);
}

static bool cut_near(const struct stock *s, int i, int j)
{
    for (int v = j - 1; v <= j + 1; v++)
        for (int u = i - 1; u <= i + 1; u++)
            if (u >= 0 && v >= 0 && u < s->tiles_x && v < s->tiles_y &&
                (s->changed[v * s->tiles_x + u] & STOCK_FOR_LEFT))
                return true;
    return false;
}

static void measure_tile(struct stock_rest *rest, const struct stock *s, size_t tile)
{
    for (size_t i = rest->first[tile]; i < rest->first[tile + 1]; i++) {
        rest->count[bin_of(rest, (double)rest->thick[i])]--;
        rest->thick[i] = (float)stock_rest_at(s, rest->point[rest->order[i]]);
        rest->count[bin_of(rest, (double)rest->thick[i])]++;
    }
}

static struct stock_rest_sum sum_up(const struct stock_rest *rest)
{
    static const double share[STOCK_REST_PERCENTILES] = {0.50, 0.95, 0.99};
    struct stock_rest_sum sum = {0};
    size_t below = 0;
    int k = 0;
    for (size_t i = 0; i < rest->points; i++)
        if (i == 0 || (double)rest->thick[i] > sum.worst) {
            sum.worst = (double)rest->thick[i];
            sum.at = rest->point[rest->order[i]];
        }
    for (size_t b = 0; rest->points > 0 && b < STOCK_REST_BINS; b++) {
        below += rest->count[b];
        while (k < STOCK_REST_PERCENTILES &&
               (double)below > share[k] * (double)(rest->points - 1) + 0.5)
            sum.part[k++] = fmin(((double)b + (b > 0 ? 0.5 : 0)) * rest->bin, sum.worst);
    }
    return sum;
}

struct stock_rest_sum stock_rest_update(struct stock_rest *rest, struct stock *s)
{
    for (int j = 0; j < s->tiles_y; j++)
        for (int i = 0; i < s->tiles_x; i++)
            if (cut_near(s, i, j))
                measure_tile(rest, s, (size_t)j * (size_t)s->tiles_x + (size_t)i);
    for (int k = 0; k < s->tiles_x * s->tiles_y; k++)
        s->changed[k] &= (unsigned char)~STOCK_FOR_LEFT;
    return sum_up(rest);
}
