/*
 * band - symmetric positive definite systems of equations whose matrix is a band about the
 * diagonal: Cholesky's factors in time O(n width^2).
 */
#ifndef CLOUDMILL_BAND_H
#define CLOUDMILL_BAND_H

#include <stdbool.h>
#include <stddef.h>

/* The lower half: element (i, j), i - width <= j <= i, is item[i * (width + 1) + i - j]. */
struct band {
    size_t n, width;
    double *item;
};

/* All zero. */
struct band band_new(size_t n, size_t width);
void band_free(struct band *band);

/* Element (i, j) with i - width <= j <= i. */
static inline double *band_at(const struct band *band, size_t i, size_t j)
{
    return &band->item[i * (band->width + 1) + i - j];
}

/*
 * Replaces the matrix by its Cholesky factor.  False if it is not positive definite, or so nearly
 * singular that a pivot has lost 12 digits against its diagonal element; the matrix is then lost.
 */
bool band_factor(struct band *band);

/* Solves for `columns` right-hand sides at once, in place: x[row * columns + column]. */
void band_solve(const struct band *factor, double *x, size_t columns);

#endif
