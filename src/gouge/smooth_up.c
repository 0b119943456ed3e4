/* smooth_up - see smooth_up.h. */
#include "smooth_up.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/band.h"
#include "math/elementary.h"

enum { ROUNDS = 5, STEPS = 40 };

static const double RELAX = 1.6, FALL = 0.1; /* of the penalty, from round to round */
static const double SHORTEST = 1e-3;         /* mm: points nearer than that count as so far */

/* The sum of squares is x' M x / 2 + g' x, the diagonal of its curvature alone is `stiff`. */
struct problem {
    size_t n;
    struct band matrix;
    double *g, *stiff;
    const double *most;
};

/* The bend at point k is a[0] p[k - 1] + a[1] p[k] + a[2] p[k + 1]; returns over what length. */
static double bend_at(const struct vec3 *p, double a[3])
{
    double before = fmax(vec_distance(p[-1], p[0]), SHORTEST);
    double after = fmax(vec_distance(p[0], p[1]), SHORTEST), along = (before + after) / 2;

    a[0] = 1 / (before * along);
    a[2] = 1 / (after * along);
    a[1] = -a[0] - a[2];
    return along;
}

static void add_bend(const struct vec3 *point, const struct vec3 *up, size_t k, struct problem *p)
{
    double a[3], along = bend_at(point + k, a);
    struct vec3 bend = vec_add(vec_scale(a[0], point[k - 1]),
                               vec_add(vec_scale(a[1], point[k]), vec_scale(a[2], point[k + 1])));

    for (size_t i = 0; i < 3; i++) {
        size_t row = k - 1 + i;
        p->g[row] += along * a[i] * vec_dot(bend, up[row]);
        p->stiff[row] += along * a[i] * a[i];
        for (size_t j = 0; j <= i; j++)
            *band_at(&p->matrix, row, k - 1 + j) +=
                along * a[i] * a[j] * vec_dot(up[row], up[k - 1 + j]);
    }
}

/* Steps with one penalty: x, the same within its bounds, and what is between them so far. */
static void relax(const struct problem *p, double penalty, double *x, double *z, double *y)
{
    struct band m = band_new(p->n, 2);

    for (size_t i = 0; i < 3 * p->n; i++)
        m.item[i] = p->matrix.item[i];
    for (size_t i = 0; i < p->n; i++)
        *band_at(&m, i, i) += penalty * p->stiff[i];
    bool good = band_factor(&m);
    for (int step = 0; step < STEPS && good; step++) {
        for (size_t i = 0; i < p->n; i++)
            x[i] = penalty * p->stiff[i] * (z[i] - y[i]) - p->g[i];
        band_solve(&m, x, 1);
        for (size_t i = 0; i < p->n; i++) {
            double next = RELAX * x[i] + (1 - RELAX) * z[i];
            z[i] = i == 0 || i + 1 == p->n ? 0 : fmax(0, fmin(next + y[i], p->most[i]));
            y[i] += next - z[i];
        }
    }
    band_free(&m);
}

void smooth_up(const struct vec3 *point, const struct vec3 *up, const double *most, double length,
               size_t n, double *rise)
{
    const double weight = 1 / (length * length * length * length);

    for (size_t i = 0; i < n; i++)
        rise[i] = 0;
    if (n < 3)
        return;
    struct problem p = {.n = n,
                        .matrix = band_new(n, 2),
                        .g = mem_alloc(n, sizeof(double)),
                        .stiff = mem_alloc(n, sizeof(double)),
                        .most = most};
    double *x = mem_alloc(n, sizeof *x), *y = mem_alloc(n, sizeof *y), penalty = 1;
    for (size_t k = 1; k + 1 < n; k++)
        add_bend(point, up, k, &p);
    for (size_t i = 0; i < n; i++) {
        double before = i > 0 ? vec_distance(point[i - 1], point[i]) : 0;
        double after = i + 1 < n ? vec_distance(point[i], point[i + 1]) : 0;
        *band_at(&p.matrix, i, i) += weight * fmax((before + after) / 2, SHORTEST);
    }
    for (int round = 0; round < ROUNDS; round++, penalty *= FALL) {
        relax(&p, penalty, x, rise, y);
        for (size_t i = 0; i < n; i++)
            y[i] /= FALL;
    }
    band_free(&p.matrix);
    free(p.g);
    free(p.stiff);
    free(x);
    free(y);
}
