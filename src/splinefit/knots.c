/*
 * knots - uniform and average knot vectors.
 */
#include "splinefit/knots.h"

/* Eq 9.68: the place of inner knot j among the data, and eq 9.69 between its two neighbours. */
static double average_of_data(const double *u, size_t n, size_t inner, size_t j)
{
    double d = (double)n / (double)(inner + 1), place = (double)j * d;
    size_t i = (size_t)place;
    double alpha = place - (double)i;

    return (1 - alpha) * u[i - 1] + alpha * u[i];
}

/* Eq 9.8: the mean of `degree` parameters, for interpolation. */
static double average_of_parameters(const double *u, int degree, size_t j)
{
    double sum = 0;

    for (size_t i = j; i < j + (size_t)degree; i++)
        sum += u[i];
    return sum / degree;
}

static double inner_knot(enum knots_method method, const double *u, size_t n, int degree,
                         size_t poles, size_t j)
{
    size_t inner = poles - (size_t)degree - 1;

    if (method == KNOTS_UNIFORM)
        return (double)j / (double)(inner + 1);
    if (poles == n)
        return average_of_parameters(u, degree, j);
    return average_of_data(u, n, inner, j);
}

void knots_fill(enum knots_method method, const double *u, size_t n, int degree, size_t poles,
                double *knot)
{
    size_t p = (size_t)degree;

    for (size_t i = 0; i <= p; i++) {
        knot[i] = 0;
        knot[poles + i] = 1;
    }
    for (size_t j = 1; j + p < poles; j++)
        knot[p + j] = inner_knot(method, u, n, degree, poles, j);
}
