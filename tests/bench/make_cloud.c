/*
 * make_cloud - points of a cloud for the benchmarks, the same ones each time.
 *
 *     make_cloud random N    N points in random order on a smooth surface, ten for each mm2
 *     make_cloud stripes N   on laser lines four steps apart
 *     make_cloud lidar N     flown over terrain, houses with walls and trees; 5 % of noise upwards
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t state = 88172645463325252u;

static double uniform(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) * 0x1p-53;
}

static double smooth(double x, double y)
{
    return 15 + 8 * sin(x / 90) * cos(y / 70) + 2 * sin(x / 6) * cos(y / 7);
}

/* A house of 12 x 9 mm in every square of 30 mm, 6 mm high with a ridged roof; trees in a quarter
 * of the rest. */
static double terrain(double x, double y)
{
    double ground = 8 * sin(x / 90) * cos(y / 70) + 0.02 * sin(3 * x) * sin(2.7 * y);
    double u = fmod(x, 30) - 10, v = fmod(y, 30) - 10;
    if (u > 0 && u < 12 && v > 0 && v < 9)
        return 8 * sin((x - u) / 90) * cos((y - v) / 70) + 6 + 0.4 * fmin(v, 9 - v);
    if (fmod(x, 30) < 7 && fmod(y, 60) < 30)
        return ground + 5 * uniform();
    return ground + 0.02 * (uniform() - 0.5);
}

int main(int argc, char **argv)
{
    if (argc < 3)
        return 2;
    long n = atol(argv[2]);
    double side = sqrt((double)n / 10), step = side / sqrt((double)n);
    long across = (long)(side / (step / 2));
    for (long i = 0; i < n; i++) {
        double x = uniform() * side, y = uniform() * side;
        if (strcmp(argv[1], "random") == 0) {
            printf("%.4f %.4f %.4f\n", x, y, smooth(x, y));
            continue;
        }
        x = (double)(i % across) * step / 2;
        y = (double)(i / across) * step * 2;
        if (strcmp(argv[1], "stripes") == 0)
            printf("%.4f %.4f %.4f\n", x, y, smooth(x, y));
        else
            printf("%.4f %.4f %.4f\n", x + 0.3 * step * uniform(), y + 1.6 * step * uniform(),
                   terrain(x, y));
    }
    return 0;
}
