/*
 * band - Cholesky's method for banded matrices.
 */
#include "math/band.h"

#include <stdlib.h>

#include "math/elementary.h"
#include "base/array.h"
#include "math/pair.h"

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

/* The sum of a[k] b[k], in four at a time: each of them waits for itself alone. */
static double dot(const double *a, const double *b, size_t n)
{
    double s = 0, t = 0, u = 0, v = 0;
    size_t k = 0;

    for (; k + 4 <= n; k += 4) {
        s += a[k] * b[k];
        t += a[k + 1] * b[k + 1];
        u += a[k + 2] * b[k + 2];
        v += a[k + 3] * b[k + 3];
    }
    for (; k < n; k++)
        s += a[k] * b[k];
    return (s + t) + (u + v);
}

enum { ROWS = 4 }; /* that are set up at once: none of them has to wait for another */

/* The same of ROWS rows with one. */
static inline void dots(const double *const a[ROWS], const double *b, size_t n, double sum[ROWS])
{
    pair first[ROWS] = {{0}}, second[ROWS] = {{0}};
    size_t k = 0;

    for (; k + 4 <= n; k += 4) {
        pair left = pair_at(b + k), right = pair_at(b + k + 2);
        for (int r = 0; r < ROWS; r++) {
            first[r] += pair_at(a[r] + k) * left;
            second[r] += pair_at(a[r] + k + 2) * right;
        }
    }
    for (int r = 0; r < ROWS; r++) {
        double s = first[r][0];
        for (size_t i = k; i < n; i++)
            s += a[r][i] * b[i];
        sum[r] = (s + first[r][1]) + (second[r][0] + second[r][1]);
    }
}

/* Elements of row i from column `from` on, and its pivot, which has those before; false: none. */
static bool finish_row(const struct band *band, size_t i, size_t from, double pivot)
{
    double diagonal = *band_at(band, i, i);

    for (size_t j = from; j < i; j++) {
        size_t both = first_column(band, i); /* columns j - 1 down to it: they lie upwards */
        double sum = *band_at(band, i, j);
        if (j > both)
            sum -= dot(band_at(band, i, j - 1), band_at(band, j, j - 1), j - both);
        sum /= *band_at(band, j, j);
        *band_at(band, i, j) = sum;
        pivot -= sum * sum;
    }
    if (!(pivot > 1e-12 * diagonal))
        return false;
    *band_at(band, i, i) = sqrt(pivot);
    return true;
}

/* ROWS rows from i on, which begin with the first column all, as far as row i. */
static void set_rows(const struct band *band, size_t i, double pivot[ROWS])
{
    double sum[ROWS];

    for (int r = 0; r < ROWS; r++)
        pivot[r] = *band_at(band, i + (size_t)r, i + (size_t)r);
    for (size_t j = 0; j < i; j++) {
        const double *row[ROWS];
        for (int r = 0; r < ROWS; r++)
            row[r] = band_at(band, i + (size_t)r, j) + 1;
        dots(row, band_at(band, j, j) + 1, j, sum);
        for (int r = 0; r < ROWS; r++) {
            double *at = band_at(band, i + (size_t)r, j);
            *at = (*at - sum[r]) / *band_at(band, j, j);
            pivot[r] -= *at * *at;
        }
    }
}

bool band_factor(struct band *band)
{
    double pivot[ROWS] = {0};
    size_t begun = 0, end = 0; /* rows that are set up to row `begun` */

    for (size_t i = 0; i < band->n; i++) {
        if (i == end && i + ROWS <= band->n && i + ROWS <= band->width + 1) {
            set_rows(band, i, pivot);
            begun = i;
            end = i + ROWS;
        }
        bool set = i < end;
        if (!finish_row(band, i, set ? begun : first_column(band, i),
                        set ? pivot[i - begun] : *band_at(band, i, i)))
            return false;
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

/* One right-hand side. */
static void solve_one(const struct band *factor, double *x)
{
    for (size_t i = 0; i < factor->n; i++) {
        size_t from = first_column(factor, i);
        const double *row = band_at(factor, i, i);
        double sum = x[i];
        for (size_t j = from; j < i; j++)
            sum -= row[i - j] * x[j];
        x[i] = sum / row[0];
    }
    for (size_t i = factor->n; i-- > 0;) {
        size_t from = first_column(factor, i);
        const double *row = band_at(factor, i, i);
        x[i] /= row[0];
        for (size_t j = from; j < i; j++)
            x[j] -= row[i - j] * x[i];
    }
}

void band_solve(const struct band *factor, double *x, size_t columns)
{
    if (columns == 1) {
        solve_one(factor, x);
        return;
    }
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
