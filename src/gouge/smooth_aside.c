/* smooth_aside - see smooth_aside.h. */
#include "smooth_aside.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/band.h"
#include "math/elementary.h"

enum { ROUNDS = 6 };

static const double SHORTEST = 1e-3; /* mm: points nearer than that count as so far */

/* The bend at the middle one of three points is a[0] p[-1] + a[1] p[0] + a[2] p[1], over a length
 * of `along`. */
struct bend {
    double a[3], along;
    struct vec3 curvature;
};

static struct bend bend_at(const struct vec3 *p)
{
    double before = fmax(vec_distance(p[-1], p[0]), SHORTEST);
    double after = fmax(vec_distance(p[0], p[1]), SHORTEST);
    struct bend b = {.along = (before + after) / 2};

    b.a[0] = 1 / (before * b.along);
    b.a[2] = 1 / (after * b.along);
    b.a[1] = -b.a[0] - b.a[2];
    b.curvature = vec_add(vec_scale(b.a[0], p[-1]),
                          vec_add(vec_scale(b.a[1], p[0]), vec_scale(b.a[2], p[1])));
    return b;
}

/* The equations with these weights of the moves; false: they have no solution. */
static bool solve(const struct bend *bend, const struct vec3 *side, const double *weight, size_t n,
                  double *move)
{
    struct band band = band_new(n, 2);

    for (size_t i = 0; i < n; i++) {
        *band_at(&band, i, i) = weight[i];
        move[i] = 0;
    }
    for (size_t k = 1; k + 1 < n; k++)
        for (size_t i = 0; i < 3; i++) {
            double by = bend[k].along * bend[k].a[i];
            move[k - 1 + i] -= by * vec_dot(bend[k].curvature, side[k - 1 + i]);
            for (size_t j = 0; j <= i; j++)
                *band_at(&band, k - 1 + i, k - 1 + j) +=
                    by * bend[k].a[j] * vec_dot(side[k - 1 + i], side[k - 1 + j]);
        }
    bool good = band_factor(&band);
    if (good)
        band_solve(&band, move, 1);
    band_free(&band);
    return good;
}

/* Moves that are too large weigh more; returns whether there were any. */
static bool weigh_more(const double *move, double most, size_t n, double *weight)
{
    bool any = false;

    for (size_t i = 0; i < n; i++) {
        double over = fabs(move[i]) / most;
        if (over > 1) {
            weight[i] *= 2 * over * over;
            any = true;
        }
    }
    return any;
}

void smooth_aside(const struct vec3 *point, const struct vec3 *side, double length, double most,
                  size_t n, double *move)
{
    for (size_t i = 0; i < n; i++)
        move[i] = 0;
    if (n < 4 || !(most > 0))
        return;
    struct bend *bend = mem_alloc(n, sizeof *bend);
    double *weight = mem_alloc(n, sizeof *weight), stiff = 1 / (length * length);

    for (size_t k = 1; k + 1 < n; k++) {
        bend[k] = bend_at(point + k);
        weight[k] = bend[k].along * stiff * stiff;
    }
    weight[0] = weight[n - 1] = 1e6 / (SHORTEST * SHORTEST * SHORTEST); /* they stay */
    bool good = true;
    for (int round = 0; round < ROUNDS && good; round++) {
        good = solve(bend, side, weight, n, move);
        if (good && !weigh_more(move, most, n, weight))
            break;
    }
    for (size_t i = 0; i < n; i++)
        move[i] = good && i > 0 && i + 1 < n ? fmax(-most, fmin(move[i], most)) : 0;
    free(bend);
    free(weight);
}
