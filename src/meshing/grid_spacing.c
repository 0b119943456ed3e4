/* grid_spacing - see grid_spacing.h. */
#include "meshing/grid_spacing.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/num.h"
#include "base/parallel.h"
#include "math/kdtree.h"
#include "math/plane_fit.h"

enum { PLACES = 400, SOME = 120, FEWEST = 8 };

static const double LEAST = 2, ROWS = 30, USUAL = 0.8;
static const double OFF = 0.03;           /* mm */
static const double SAGITTA = 20.8 / 8.0; /* of facets, to the rms about a plane */

struct measuring {
    const struct vec3 *point;
    size_t n;
    const struct kdtree *tree;
    double t, noise;
    double *off; /* of the facets at each place, mm; negative: too few points */
};

/* Every so many of the points within t / sqrt(3) of a place. */
static size_t points_about(const struct measuring *m, struct vec3 place, struct sizes *found,
                           struct vec3 near[SOME])
{
    found->n = 0;
    kdtree_within(m->tree, place, m->t / sqrt(3), found);
    size_t step = found->n / SOME + 1, n = 0;
    for (size_t i = 0; i < found->n && n < SOME; i += step)
        near[n++] = m->point[found->item[i]];
    return n;
}

static void measure(void *context, size_t from, size_t to)
{
    const struct measuring *m = context;
    struct sizes found = {0};

    for (size_t i = from; i < to; i++) {
        struct vec3 near[SOME];
        struct plane_fit plane;
        size_t n = points_about(m, m->point[i * m->n / PLACES], &found, near);
        m->off[i] = -1;
        if (n < FEWEST || plane_fit(near, n, &plane) < 0)
            continue;
        double rms2 = plane.rms * plane.rms * (double)n / (double)(n - 3) - m->noise * m->noise;
        m->off[i] = SAGITTA * sqrt(fmax(rms2, 0));
    }
    array_free(&found);
}

/* What the facets are off at most, at the usual places. */
static double usual_off(const struct measuring *m)
{
    size_t n = 0;

    for (size_t i = 0; i < PLACES; i++)
        if (m->off[i] >= 0)
            m->off[n++] = m->off[i];
    if (n < PLACES / 10)
        return 0;
    doubles_sort(m->off, n);
    return m->off[(size_t)(USUAL * (double)(n - 1))];
}

/* To two digits, so that it can be said with -t. */
static double rounded(double t)
{
    double step = pow(10, floor(log10(t)) - 1), digits = fmax(-floor(log10(step)), 0);

    return num_round(round(t / step) * step, (int)fmin(digits, 9));
}

double grid_spacing_needed(const struct vec3 *point, size_t n, const struct grid_spacing_options *o)
{
    double within = fmax(OFF, 1.5 * o->noise), best = LEAST * o->mean;
    struct kdtree *tree = kdtree_new_by(point, n, o->threads);
    struct measuring m = {point, n, tree, best, o->noise, mem_alloc(PLACES, sizeof *m.off)};

    for (; m.t <= fmax(o->width / ROWS, best); m.t *= sqrt(2)) {
        parallel_for(o->threads, PLACES, measure, &m);
        if (usual_off(&m) > within)
            break;
        best = m.t;
    }
    free(m.off);
    kdtree_free(tree);
    return rounded(best);
}
