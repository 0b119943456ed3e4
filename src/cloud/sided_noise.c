/* sided_noise - see sided_noise.h. */
#include "sided_noise.h"

#include "base/parallel.h"
#include "math/quadric.h"

/* Points of a side, and twice as many; those that are looked at; sides. */
enum { FEWER = 16, TWICE = 32, NEAR = 96, SIDES = 8, TERMS = 6 };

/* Of noise alone, in its variance: what a twentieth, a tenth and a quarter of the places leave at
 * most, and a tenth over twice the points.  Grids, lines and points anywhere differ by 3 %. */
static const double TWENTIETH = 0.234, TENTH = 0.285, QUARTER = 0.38, TENTH_TWICE = 0.497;

/* So many times as much by chance, and by what of the shape is left: a quarter against a twentieth,
 * and twice the points against once.  Facets with noise have 1.4 at most, the roughness of terrain
 * and of models without noise 1.6 and more in either. */
static const double UNEVEN = 1.4, WIDER = 1.45;

/* So many times as much at some of the places tells for all.  In 90 scans of heads and models an
 * eighth came to 1.12 at most where all had noise, and ended 55 of the 73 that had none. */
static const double SURELY = 1.4;

/* Variance over twice the points of what of the shape is left: between that of an edge, 2, and of a
 * bend, 8. */
static const double GROWTH = 4;

struct sided {
    const struct point_grid *point_grid;
    const uint32_t *place;
    double *fewer, *twice;
};

static size_t find_near(const struct point_grid *b, struct vec3 place, struct vec3 near[NEAR])
{
    uint32_t index[NEAR];
    double distance2[NEAR];
    size_t n = point_grid_nearest(b, place, NEAR, index, distance2);

    for (size_t i = 0; i < n; i++)
        near[i] = b->point[index[i]];
    return n;
}

/* The nearest on a side, k at most; on the last all are. */
static size_t take_side(const struct vec3 near[NEAR], const struct vec3 local[NEAR], int side,
                        size_t k, struct vec3 *taken)
{
    const double rounding = 1e-9; /* mm */
    double c = cos(2 * PI * side / SIDES), s = sin(2 * PI * side / SIDES);
    size_t n = 0;

    for (size_t i = 0; i < NEAR && n < k; i++)
        if (side == SIDES || c * local[i].x + s * local[i].y >= -rounding)
            taken[n++] = near[i];
    return n;
}

/* What the best side of k points leaves these. */
static double least_left(const struct vec3 near[NEAR], const struct vec3 local[NEAR], size_t k,
                         struct vec3 normal)
{
    double least = -1;

    for (int side = 0; side <= SIDES; side++) {
        struct vec3 taken[TWICE];
        struct quadric q;
        if (take_side(near, local, side, k, taken) < k ||
            quadric_settle(taken, k, near[0], normal, &q) < 0)
            continue;
        double spread = quadric_spread(&q, taken, k, TERMS);
        least = least < 0 ? spread : fmin(least, spread);
    }
    return least < 0 ? least : least * least;
}

/* As noise.c, about the foot of the place. */
static void measure_sides(void *context, size_t from, size_t to)
{
    const struct sided *s = context;

    for (size_t i = from; i < to; i++) {
        struct vec3 near[NEAR], local[NEAR];
        struct quadric q;
        s->fewer[i] = s->twice[i] = -1;
        if (find_near(s->point_grid, s->point_grid->point[s->place[i]], near) < NEAR ||
            quadric_fit_free(near, FEWER, near[0], &q) < 0)
            continue;
        find_near(s->point_grid, quadric_foot(&q), near);
        quadric_local_all(&q, near, NEAR, local);
        s->fewer[i] = least_left(near, local, FEWER, quadric_normal(&q));
        s->twice[i] = least_left(near, local, TWICE, quadric_normal(&q));
    }
}

void sided_noise_measure(const struct point_grid *point_grid, const uint32_t *place, size_t places,
                         int threads, double *fewer, double *twice)
{
    struct sided sided = {point_grid, place, fewer, twice};

    parallel_for(threads, places, measure_sides, &sided);
}

/* Whether they differ by more than so many times what noise alone may come to. */
static bool exceeds(const double *fewer, size_t n, const double *twice, size_t m, double times)
{
    double least = fewer[n / 20] / TWENTIETH, tenth = fewer[n / 10] / TENTH;
    double quarter = fewer[n / 4] / QUARTER, wide = twice[m / 10] / TENTH_TWICE;

    return quarter > times * UNEVEN * least || wide > times * WIDER * tenth;
}

double sided_noise_variance(const double *fewer, size_t n, const double *twice, size_t m)
{
    if (n == 0 || m == 0 || exceeds(fewer, n, twice, m, 1))
        return 0;
    double tenth = fewer[n / 10] / TENTH, wide = twice[m / 10] / TENTH_TWICE;
    return fmax((GROWTH * tenth - wide) / (GROWTH - 1), 0);
}

bool sided_noise_surely_none(const double *fewer, size_t n, const double *twice, size_t m)
{
    return n > 0 && m > 0 && exceeds(fewer, n, twice, m, SURELY);
}
