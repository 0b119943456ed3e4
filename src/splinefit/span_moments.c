/*
 * span_moments - sums and products, with the widths known to the compiler.
 */
#include "span_moments.h"

static inline int size_of(int width)
{
    return width * (width + 1) / 2;
}

size_t span_moments_size(int degree, int width)
{
    return (size_t)((2 * degree + 1) * size_of(width) + (degree + 1) * width);
}

const double *span_moments_right(const double *moments, int degree, int width)
{
    return moments + (2 * degree + 1) * size_of(width);
}

static inline void add(double *restrict moments, int degree, int width, double s,
                       const struct residual *restrict pull)
{
    int size = size_of(width);
    double power = 1, *g = moments + (2 * degree + 1) * size;

    for (int k = 0; k <= 2 * degree; k++) {
        for (int e = 0; e < size; e++)
            moments[k * size + e] += power * pull->w[e];
        for (int i = 0; k <= degree && i < width; i++)
            g[k * width + i] += power * pull->g[i];
        power *= s;
    }
}

void span_moments_add(double *moments, int degree, int width, double s, const struct residual *pull)
{
    if (width == 3)
        add(moments, degree, 3, s, pull);
    else
        add(moments, degree, 6, s, pull);
}

static inline void times(const double *moments, int degree, int width, const double *c,
                         double *restrict y)
{
    int size = size_of(width);

    for (int k = 0; k <= degree; k++)
        for (int i = 0; i < width; i++) {
            double sum = 0;
            for (int l = 0; l <= degree; l++)
                for (int j = 0; j < width; j++)
                    sum += moments[(k + l) * size + residual_at(i, j)] * c[l * width + j];
            y[k * width + i] = sum;
        }
}

void span_moments_times(const double *moments, int degree, int width, const double *c, double *y)
{
    if (width == 3)
        times(moments, degree, 3, c, y);
    else
        times(moments, degree, 6, c, y);
}

static inline void of_basis(const double *moments, int degree, int width, const double *b,
                            double *t)
{
    int size = size_of(width);

    for (int l = 0; l <= degree; l++) {
        double sum[RESIDUAL_SIZE] = {0};
        for (int k = 0; k <= degree; k++)
            for (int e = 0; e < size; e++)
                sum[e] += b[k] * moments[(k + l) * size + e];
        for (int i = 0; i < width; i++)
            for (int j = 0; j < width; j++)
                t[(l * width + i) * width + j] = sum[residual_at(i, j)];
    }
}

void span_moments_of_basis(const double *moments, int degree, int width, const double *b, double *t)
{
    if (width == 3)
        of_basis(moments, degree, 3, b, t);
    else
        of_basis(moments, degree, 6, b, t);
}
