/*
 * panel - see panel.h.  The nearest point by damped Newton on the squared distance, from straight
 * below and, where the point is not close to the surface, from the best of a grid around it.
 */
#include "panel.h"

#include <stdbool.h>

/* They bring the heights over 74 x 54 mm, on a raster of 0.1 mm, to 0 .. 15. */
#define PANEL_ZERO (-14.28904030944473)
#define PANEL_SCALE 1.0358020758819393

/* A height with its derivatives. */
struct jet {
    double z, x, y, xx, xy, yy;
};

/* Adds k exp(-g) with g and its derivatives in `g`. */
static void add_bump(struct jet *j, double k, struct jet g)
{
    double e = k * exp(-g.z);
    j->z += e;
    j->x -= e * g.x;
    j->y -= e * g.y;
    j->xx += e * (g.x * g.x - g.xx);
    j->xy += e * (g.x * g.y - g.xy);
    j->yy += e * (g.y * g.y - g.yy);
}

static struct jet surface(double x, double y)
{
    const double a = 37 * 37, b = 27 * 27;
    struct jet j = {
        .z = -6.5 * x * x / a - 5.0 * y * y / b - 1.6 * x * x * y * y / (a * b) - 1.2 * y / 27,
        .x = -13.0 * x / a - 3.2 * x * y * y / (a * b),
        .y = -10.0 * y / b - 3.2 * x * x * y / (a * b) - 1.2 / 27,
        .xx = -13.0 / a - 3.2 * y * y / (a * b),
        .xy = -6.4 * x * y / (a * b),
        .yy = -10.0 / b - 3.2 * x * x / (a * b),
    };
    for (int side = -1; side <= 1; side += 2) {
        const double a2 = 12.5 * 12.5, b2 = 11.0 * 11.0;
        double u = x - 20 * side, v = y - 7;
        add_bump(&j, 1.9,
                 (struct jet){.z = u * u / a2 + v * v / b2,
                              .x = 2 * u / a2,
                              .y = 2 * v / b2,
                              .xx = 2 / a2,
                              .yy = 2 / b2});
    }
    const double a4 = 20.0 * 20 * 20 * 20, b2 = 6.0 * 6.0;
    double v = y + 9;
    add_bump(&j, -2.2,
             (struct jet){.z = x * x * x * x / a4 + v * v / b2,
                          .x = 4 * x * x * x / a4,
                          .y = 2 * v / b2,
                          .xx = 12 * x * x / a4,
                          .yy = 2 / b2});
    const double k = PANEL_SCALE;
    return (struct jet){k * (j.z - PANEL_ZERO), k * j.x, k * j.y, k * j.xx, k * j.xy, k * j.yy};
}

double panel_height(double x, double y)
{
    return surface(x, y).z;
}

static double distance2(struct vec3 p, double x, double y, double z)
{
    return (x - p.x) * (x - p.x) + (y - p.y) * (y - p.y) + (z - p.z) * (z - p.z);
}

/* The least distance that Newton's steps reach from (x, y). */
static double newton(struct vec3 p, double x, double y)
{
    struct jet j = surface(x, y);
    double f = distance2(p, x, y, j.z);
    for (int turn = 0; turn < 40; turn++) {
        double e = j.z - p.z;
        double gx = x - p.x + e * j.x, gy = y - p.y + e * j.y;
        double a = 1 + j.x * j.x + e * j.xx, b = j.x * j.y + e * j.xy, c = 1 + j.y * j.y + e * j.yy;
        if (a * c - b * b <= 1e-9 || a <= 0) { /* not convex here: Gauss-Newton */
            a = 1 + j.x * j.x;
            b = j.x * j.y;
            c = 1 + j.y * j.y;
        }
        double d = a * c - b * b, sx = -(c * gx - b * gy) / d, sy = -(a * gy - b * gx) / d;
        if (sx * sx + sy * sy < 1e-18)
            break;
        bool better = false;
        for (int halving = 0; halving < 12 && !better; halving++, sx /= 2, sy /= 2) {
            struct jet next = surface(x + sx, y + sy);
            double fn = distance2(p, x + sx, y + sy, next.z);
            if (fn < f) {
                better = true;
                x += sx;
                y += sy;
                j = next;
                f = fn;
            }
        }
        if (!better)
            break;
    }
    return sqrt(f);
}

double panel_distance(struct vec3 p)
{
    double above = p.z - panel_height(p.x, p.y);
    double best = newton(p, p.x, p.y);
    if (fabs(above) > 0.02) {
        /* the nearest point lies within this reach; the best places of a raster there */
        double reach = fmin(fabs(above), best * 1.0001);
        for (int i = -3; i <= 3; i++)
            for (int k = -3; k <= 3; k++) {
                double x = p.x + reach * i / 3, y = p.y + reach * k / 3;
                if (distance2(p, x, y, panel_height(x, y)) < 1.7 * best * best)
                    best = fmin(best, newton(p, x, y));
            }
    }
    return above >= 0 ? best : -best;
}
