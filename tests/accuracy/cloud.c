/*
 * cloud - scans of surfaces that are known exactly, to measure what the tools make of them:
 *
 *	cloud SHAPE grid|lines|random N SIGMA SEED     N points about, noise along the normal
 *	cloud SHAPE truth STEP MARGIN                  the surface itself, finely, so far inside
 *
 * panel: 74 x 54 x 15 mm, smallest hollow radius 8.8; dome: a cap of radius 60, 60 x 60; saddle:
 * (x^2 - y^2) / 40, 50 x 50; bowl: (x^2 + y^2) / 20, 24 x 24; wave: 4 sin sin over 40 x 40, hollow
 * radius 2.5; rib, groove: 28 x 28, for what a mesh cuts off.  A laser's lines are four steps
 *apart; a point strays by 0.6 of a step along its line and 0.4 across.
 */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "panel.h"

typedef double height(double x, double y);

static double dome(double x, double y)
{
    return sqrt(3600 - x * x - y * y) - sqrt(1800);
}

static double saddle(double x, double y)
{
    return (x * x - y * y) / 40;
}

static double bowl(double x, double y)
{
    return (x * x + y * y) / 20;
}

static double wave(double x, double y)
{
    return 4 * sin(2 * PI * x / 20) * cos(2 * PI * y / 30) + 4;
}

/* A rib 0.8 mm high, a groove 0.6 mm deep, both about 1 mm wide, along a line 25 degrees off y. */
static double off_line(double x, double y)
{
    return x * cos(25 * PI / 180) + y * sin(25 * PI / 180) - 1;
}

static double rib(double x, double y)
{
    double d = off_line(x, y) / 0.6;
    return 5 - 0.005 * (x * x + y * y) + 0.8 * exp(-d * d);
}

static double groove(double x, double y)
{
    double d = off_line(x, y);
    return 5 - 0.6 * exp(-2 * d * d);
}

static const struct shape {
    const char *name;
    height *z;
    double wide, high; /* mm in x and y */
} shapes[] = {{"panel", panel_height, 74, 54}, {"dome", dome, 60, 60}, {"saddle", saddle, 50, 50},
              {"bowl", bowl, 24, 24},          {"wave", wave, 40, 40}, {"rib", rib, 28, 28},
              {"groove", groove, 28, 28}};

/* A uniform number, -1 to 1: splitmix64. */
static double uniform(uint64_t *seed)
{
    uint64_t z = *seed += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return (double)((z ^ z >> 31) >> 11) / 4503599627370496.0 - 1;
}

/* A normal one: twelve uniform ones. */
static double gaussian(uint64_t *seed)
{
    double sum = 0;
    for (int i = 0; i < 12; i++)
        sum += uniform(seed) / 2;
    return sum;
}

static void print_point(const struct shape *shape, double x, double y, double off)
{
    const double h = 1e-5;
    double u = (shape->z(x + h, y) - shape->z(x - h, y)) / (2 * h);
    double v = (shape->z(x, y + h) - shape->z(x, y - h)) / (2 * h);
    double s = off / sqrt(1 + u * u + v * v);
    printf("%.4f %.4f %.4f\n", x - s * u, y - s * v, shape->z(x, y) + s);
}

static double inside(double x, double most)
{
    return fmin(fmax(x, -most), most);
}

static void scan(const struct shape *shape, const char *pattern, double n, double sigma,
                 uint64_t seed)
{
    double wide = shape->wide, high = shape->high, apart = strcmp(pattern, "lines") == 0 ? 4 : 1;
    bool anywhere = strcmp(pattern, "random") == 0;
    int columns = (int)round(sqrt(n * apart * wide / high)), rows = (int)ceil(n / columns);
    double step = wide / (columns - 1), along = apart > 1 ? 0.6 : 0, across = apart > 1 ? 0.4 : 0;
    for (int j = 0; j < rows; j++)
        for (int i = 0; i < columns; i++) {
            double x = i * step - wide / 2 + along * step * uniform(&seed);
            double y = j * high / (rows - 1) - high / 2 + across * step * uniform(&seed);
            if (anywhere) {
                x = wide / 2 * uniform(&seed);
                y = high / 2 * uniform(&seed);
            }
            x = inside(x, wide / 2);
            y = inside(y, high / 2);
            print_point(shape, x, y, sigma > 0 ? sigma * gaussian(&seed) : 0);
        }
}

static void truth(const struct shape *shape, double step, double margin)
{
    double wide = shape->wide / 2 - margin, high = shape->high / 2 - margin;
    for (double y = -high; y <= high + 1e-9; y += step)
        for (double x = -wide; x <= wide + 1e-9; x += step)
            print_point(shape, x, y, 0);
}

int main(int argc, char *argv[])
{
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++) {
        if (argc < 2 || strcmp(argv[1], shapes[i].name) != 0)
            continue;
        if (argc == 5 && strcmp(argv[2], "truth") == 0)
            truth(&shapes[i], atof(argv[3]), atof(argv[4]));
        else if (argc == 6)
            scan(&shapes[i], argv[2], atof(argv[3]), atof(argv[4]), strtoull(argv[5], NULL, 10));
        else
            break;
        return 0;
    }
    fprintf(stderr, "usage: cloud SHAPE grid|lines|random N SIGMA SEED\n"
                    "       cloud SHAPE truth STEP MARGIN\n");
    return 2;
}
