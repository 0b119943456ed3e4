/* net_patches - see net_patches.h. */
#include "nurbs/net_patches.h"

#include <stdlib.h>

#include "base/array.h"

struct net_patches net_patches_new(size_t columns, size_t rows)
{
    size_t n = columns * rows;

    return (struct net_patches){.columns = columns,
                                .rows = rows,
                                .z = mem_alloc(n, sizeof(double)),
                                .zx = mem_alloc(n, sizeof(double)),
                                .zy = mem_alloc(n, sizeof(double)),
                                .zxy = mem_alloc(n, sizeof(double))};
}

void net_patches_free(struct net_patches *net)
{
    free(net->z);
    free(net->zx);
    free(net->zy);
    free(net->zxy);
}

void net_patches_ferguson(struct net_patches *net)
{
    for (size_t i = 0; i < net->columns * net->rows; i++)
        net->zxy[i] = 0;
}

/*
 * The slopes of the cubic spline through n heights `step` apart in memory and `h` mm in the plan:
 * second derivatives go on at the nodes; at the ends the slope of the parabola through three.
 */
static void spline_slopes(const double *z, size_t n, size_t step, double h, double *slope)
{
    double *above = mem_alloc(n, sizeof *above), *value = mem_alloc(n, sizeof *value);

    if (n == 2) {
        slope[0] = slope[step] = (z[step] - z[0]) / h;
    } else {
        size_t e = (n - 1) * step;
        value[0] = (-3 * z[0] + 4 * z[step] - z[2 * step]) / (2 * h);
        value[n - 1] = (3 * z[e] - 4 * z[e - step] + z[e - 2 * step]) / (2 * h);
        for (size_t k = 1; k + 1 < n;
             k++) { /* m[k-1] + 4 m[k] + m[k+1] = 3 (z[k+1] - z[k-1]) / h */
            double at = 4 - (k > 1 ? above[k - 1] : 0);
            value[k] = (3 * (z[(k + 1) * step] - z[(k - 1) * step]) / h - value[k - 1]) / at;
            above[k] = 1 / at;
        }
        for (size_t k = n - 1; k-- > 1;)
            value[k] -= above[k] * value[k + 1];
        for (size_t k = 0; k < n; k++)
            slope[k * step] = value[k];
    }
    free(above);
    free(value);
}

/* Adini's twist of a node between others; that of the nearest such node at the border. */
static double twist_of(const struct net_patches *net, size_t i, size_t j)
{
    size_t w = net->columns, k = j * w + i;
    const double *z = net->z + k;
    double along = (net->zy[k + 1] - net->zy[k - 1]) / (2 * net->dx);
    double across = (net->zx[k + w] - net->zx[k - w]) / (2 * net->dy);
    double corners = (z[w + 1] - z[w - 1] - *(z - w + 1) + *(z - w - 1)) / (4 * net->dx * net->dy);

    return along + across - corners;
}

static size_t inner(size_t i, size_t n)
{
    return i == 0 ? 1 : i == n - 1 ? n - 2 : i;
}

void net_patches_bezier(struct net_patches *net)
{
    size_t w = net->columns, h = net->rows;

    for (size_t j = 0; j < h; j++)
        spline_slopes(net->z + j * w, w, 1, net->dx, net->zx + j * w);
    for (size_t i = 0; i < w; i++)
        spline_slopes(net->z + i, h, w, net->dy, net->zy + i);
    for (size_t j = 0; j < h; j++)
        for (size_t i = 0; i < w; i++)
            net->zxy[j * w + i] = w > 2 && h > 2 ? twist_of(net, inner(i, w), inner(j, h)) : 0;
}

static struct nurbs_axis make_axis(size_t nodes, double from, double step)
{
    struct nurbs_axis axis = {3, 2 * nodes, mem_alloc(2 * nodes + 4, sizeof *axis.knot), from,
                              from + step * (double)(nodes - 1)};

    for (size_t k = 0; k < 2 * nodes + 4; k++) {
        size_t node = k < 2 ? 0 : (k - 2) / 2;
        axis.knot[k] = from + step * (double)(node < nodes ? node : nodes - 1);
    }
    return axis;
}

/* Which node pole k belongs to, and how far beside it its place is: a third of a patch, or none at
 * the ends. */
static double beside(size_t k, size_t nodes, double step, size_t *node)
{
    *node = k / 2;
    if (k == 0 || k == 2 * nodes - 1)
        return 0;
    return k % 2 == 0 ? -step / 3 : step / 3;
}

struct nurbs net_patches_surface(const struct net_patches *net)
{
    struct nurbs s = {make_axis(net->columns, net->x, net->dx),
                      make_axis(net->rows, net->y, net->dy),
                      mem_alloc(4 * net->columns * net->rows, sizeof *s.pole)};

    for (size_t b = 0; b < s.v.poles; b++)
        for (size_t a = 0; a < s.u.poles; a++) {
            size_t i, j;
            double u = beside(a, net->columns, net->dx, &i), v = beside(b, net->rows, net->dy, &j);
            size_t k = j * net->columns + i;
            s.pole[b * s.u.poles + a] = (struct nurbs_pole){
                net->x + net->dx * (double)i + u, net->y + net->dy * (double)j + v,
                net->z[k] + u * net->zx[k] + v * net->zy[k] + u * v * net->zxy[k], 1};
        }
    return s;
}
