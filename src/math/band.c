/*
 * band - Cholesky's method for banded matrices.
 */
#include "math/band.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"

struct band band_new(size_t n, size_t width)
{
    return (struct band){n, width, mem_alloc(n * (width + 1), sizeof(double))};
}

void band_free(struct band *band)
{
    free(band->item);
    *band = (struct band){0};
}

static size_t first_column(const struct band *band, size_t i)
{
    return i > band->width ? i - band->width : 0;
}

bool band_factor(struct band *band)
{
    for (size_t i = 0; i < band->n; i++) {
        size_t from = first_column(band, i);
        double diagonal = *band_at(band, i, i), pivot = diagonal;

        for (size_t j = from; j < i; j++) {
            double sum = *band_at(band, i, j);
            size_t both = first_column(band, j) > from ? first_column(band, j) : from;
            for (size_t k = both; k < j; k++)
                sum -= *band_at(band, i, k) * *band_at(band, j, k);
            sum /= *band_at(band, j, j);
            *band_at(band, i, j) = sum;
            pivot -= sum * sum;
        }
        if (!(pivot > 1e-12 * diagonal))
            return false;
        *band_at(band, i, i) = sqrt(pivot);
    }
    return true;
}

/* x[i] -= factor * x[j], for all columns */
static void take_row(double *x, size_t columns, size_t i, double factor, size_t j)
{
    for (size_t c = 0; c < columns; c++)
        x[i * columns + c] -= factor * x[j * columns + c];
}

static void divide_row(double *x, size_t columns, size_t i, double by)
{
    for (size_t c = 0; c < columns; c++)
        x[i * columns + c] /= by;
}

void band_solve(const struct band *factor, double *x, size_t columns)
{
    for (size_t i = 0; i < factor->n; i++) {
        for (size_t j = first_column(factor, i); j < i; j++)
            take_row(x, columns, i, *band_at(factor, i, j), j);
        divide_row(x, columns, i, *band_at(factor, i, i));
    }
    for (size_t i = factor->n; i-- > 0;) {
        divide_row(x, columns, i, *band_at(factor, i, i));
        for (size_t j = first_column(factor, i); j < i; j++)
            take_row(x, columns, j, *band_at(factor, i, j), i);
    }
}
