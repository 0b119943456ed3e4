/* knots_init - see knots_init.h. */
#include "knots_init.h"

#include <stdlib.h>

#include "base/array.h"
#include "spline_lsq.h"

static const double FLOOR = 0.1; /* of the mean density, everywhere */

static void end_knots(const struct reference *places, int degree, size_t poles, double *knot)
{
    for (size_t i = 0; i <= (size_t)degree; i++) {
        knot[i] = 0;
        knot[poles + i] = places->length[places->n - 1];
    }
}

/* Place of inner knot j of equally spaced ones. */
static double uniform_knot(const struct reference *places, int degree, size_t poles, size_t j)
{
    size_t p = (size_t)degree;
    return places->length[places->n - 1] * (double)(j - p) / (double)(poles - p);
}

void knots_init_uniform(const struct reference *places, int degree, size_t poles, double *knot)
{
    end_knots(places, degree, poles, knot);
    for (size_t j = (size_t)degree + 1; j < poles; j++)
        knot[j] = uniform_knot(places, degree, poles, j);
}

void knots_init_mean(const struct reference *places, int degree, size_t poles, double *knot)
{
    for (size_t j = (size_t)degree + 1; j < poles; j++)
        knot[j] = (knot[j] + uniform_knot(places, degree, poles, j)) / 2;
}

/* The highest derivative in the span that begins with knot j. */
static struct vec3 highest_in(const struct bspline *b, size_t j)
{
    struct vec3 d[BSPLINE_DEGREE_MAX + 1];

    bspline_derivatives(b, b->pole, (b->knot[j] + b->knot[j + 1]) / 2, b->degree, d);
    return d[b->degree];
}

/* Its jump at an inner knot. */
static double jump_at(const struct bspline *b, size_t j)
{
    return vec_distance(highest_in(b, j - 1), highest_in(b, j));
}

/* How far the jump moves the curve, with the lengths of the spans at it. */
static double moved_by(const struct bspline *b, size_t j, double jump)
{
    double before = b->knot[j] - b->knot[j - 1], after = b->knot[j + 1] - b->knot[j];

    for (int k = 0; k < b->degree; k++)
        jump *= sqrt(before * after);
    return jump;
}

void knots_init_missed(const struct bspline *curve, double *missed)
{
    size_t first = (size_t)curve->degree + 1;
    struct vec3 before = highest_in(curve, first - 1);

    for (size_t j = first; j < curve->poles; j++) {
        struct vec3 after = highest_in(curve, j);
        missed[j - first] = moved_by(curve, j, vec_distance(before, after));
        before = after;
    }
}

static double density_at(const struct bspline *b, size_t j)
{
    return sqrt(sqrt(jump_at(b, j) * 2 / (b->knot[j + 1] - b->knot[j - 1])));
}

/* The density's integral from the start to the end of each span. */
static void sum_density(const struct bspline *fine, size_t spans, double *sum)
{
    size_t p = (size_t)fine->degree;
    double mean = 0;

    for (size_t i = 1; i < spans; i++)
        mean += density_at(fine, p + i) / (double)spans;
    for (size_t i = 0; i < spans; i++) {
        double a = density_at(fine, p + (i > 0 ? i : 1));
        double b = density_at(fine, p + (i + 1 < spans ? i + 1 : i));
        sum[i + 1] = sum[i] + (a + b) / 2 + FLOOR * mean + 1e-30;
    }
}

/* Knots with an equal share of the density in each span. */
static void spread_knots(const struct reference *places, const struct bspline *fine, size_t poles,
                         double *knot)
{
    size_t p = (size_t)fine->degree, spans = fine->poles - p, at = 0;
    double *sum = mem_alloc(spans + 1, sizeof *sum);

    sum_density(fine, spans, sum);
    end_knots(places, fine->degree, poles, knot);
    for (size_t j = p + 1; j < poles; j++) {
        double want = sum[spans] * (double)(j - p) / (double)(poles - p);
        while (at + 1 < spans && sum[at + 1] < want)
            at++;
        double part = (want - sum[at]) / (sum[at + 1] - sum[at]);
        knot[j] = fine->knot[p + at] + part * (fine->knot[p + at + 1] - fine->knot[p + at]);
    }
    free(sum);
}

bool knots_init_spread(const struct reference *places, int degree, size_t poles, double *knot)
{
    size_t more = 2 * poles + 8;

    if (more >= places->n)
        return false;
    struct bspline fine = bspline_new(degree, more, false);
    knots_init_uniform(places, degree, more, fine.knot);
    bool done = lsq_fit(&fine, places->length, places->point, NULL, places->n);
    if (done)
        spread_knots(places, &fine, poles, knot);
    bspline_free(&fine);
    return done;
}
