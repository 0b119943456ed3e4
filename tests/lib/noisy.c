/* noisy - see noisy.h. */
#include "noisy.h"

#include <stdint.h>
#include "seed.h"

static uint64_t state;

void noisy_seed(unsigned seed)
{
    state = seed;
}

double noisy_uniform(void)
{
    state = state * 6364136223846793005u + seed_step();
    return (double)(state >> 11) / 9007199254740992.0;
}

double noisy_normal(void)
{
    double r = sqrt(-2 * log(1 - noisy_uniform()));
    return r * cos(2 * PI * noisy_uniform());
}

struct vec3 noisy_up(double (*height)(double x, double y), double x, double y)
{
    const double h = 1e-4;
    return vec_unit(
        vec(height(x - h, y) - height(x + h, y), height(x, y - h) - height(x, y + h), 2 * h));
}

void noisy_scan(struct vec3s *scan, double (*height)(double x, double y), int n,
                enum noisy_pattern pattern, double sigma)
{
    double ratio = pattern == NOISY_LINES ? 4 : 1, step = sqrt(74 * 54 / ratio / n);
    for (double y = -27; y <= 27 + 1e-9; y += ratio * step)
        for (double x = -37; x <= 37 + 1e-9; x += step) {
            double right = noisy_uniform() - 0.5, up = noisy_uniform() - 0.5;
            struct vec3 p = vec(x, y, 0);
            if (pattern == NOISY_LINES)
                p = vec(x + 1.2 * step * right, y + 0.8 * step * up, 0);
            else if (pattern == NOISY_RANDOM)
                p = vec(74 * right, 54 * up, 0);
            p.z = height(p.x, p.y);
            *array_push(scan) = vec_along(p, sigma * noisy_normal(), noisy_up(height, p.x, p.y));
        }
}
