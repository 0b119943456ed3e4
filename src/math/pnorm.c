/* pnorm - see pnorm.h. */
#include "math/pnorm.h"

#include "math/elementary.h"

static double power(double x, int n)
{
    double y = 1;
    while (n > 0) {
        y *= n % 2 ? x : 1;
        x *= x;
        n /= 2;
    }
    return y;
}

double pnorm_cost(const double *off, size_t pairs, const double held[3], int half, double scale)
{
    double sum = held[0] * held[0] + held[1] * held[1] + held[2] * held[2];
    for (size_t i = 0; i < pairs; i++) {
        double d2 = off[2 * i] * off[2 * i] + off[2 * i + 1] * off[2 * i + 1];
        sum += power(d2 / (scale * scale), half);
    }
    return sum;
}

struct pnorm_vector pnorm_vector_of(double x, double y, int half, double scale)
{
    double d = sqrt(x * x + y * y), f = power(d / scale, half - 1) / scale;
    double ux = d > 0 ? x / d : 0, uy = d > 0 ? y / d : 0, more = half - 1;
    return (struct pnorm_vector){.x = f * x,
                                 .y = f * y,
                                 .xx = f * (1 + more * ux * ux),
                                 .xy = f * more * ux * uy,
                                 .yy = f * (1 + more * uy * uy)};
}
