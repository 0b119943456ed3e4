/*
 * lsq - normal equations of the inner poles, a band of width `degree`, by Cholesky.
 */
#include "lsq.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/band.h"

/* Adds a point to its three columns of the right-hand side; what the end poles give is known. */
static void add_point(const struct bspline *curve, size_t first, const double *value,
                      const struct vec3 *pole, struct vec3 point, double *right, size_t columns)
{
    size_t last = curve->poles - 1;
    struct vec3 rest = point;

    for (size_t i = 0; i <= (size_t)curve->degree; i++)
        if (first + i == 0 || first + i == last)
            rest = vec_along(rest, -value[i], pole[first + i]);
    for (size_t i = 0; i <= (size_t)curve->degree; i++) {
        if (first + i == 0 || first + i == last)
            continue;
        double *row = &right[(first + i - 1) * columns];
        row[0] += value[i] * rest.x;
        row[1] += value[i] * rest.y;
        row[2] += value[i] * rest.z;
    }
}

/* Adds its products to the matrix. */
static void add_products(const struct bspline *curve, size_t first, const double *value,
                         struct band *matrix)
{
    size_t last = curve->poles - 1;

    for (size_t i = 0; i <= (size_t)curve->degree; i++) {
        if (first + i == 0 || first + i == last)
            continue;
        for (size_t j = 0; j <= i; j++)
            if (first + j != 0)
                *band_at(matrix, first + i - 1, first + j - 1) += value[i] * value[j];
    }
}

static void take_poles(const double *x, size_t columns, size_t inner, struct vec3 *pole)
{
    for (size_t i = 0; i < inner; i++)
        pole[i + 1] = vec(x[i * columns], x[i * columns + 1], x[i * columns + 2]);
}

bool lsq_fit(struct bspline *curve, const double *u, const struct vec3 *point,
             const struct vec3 *head, size_t n)
{
    size_t inner = curve->poles - 2, degree = (size_t)curve->degree;
    size_t columns = curve->head != NULL ? 6 : 3;
    double value[BSPLINE_DEGREE_MAX + 1];

    if (curve->poles > n)
        return false;
    curve->pole[0] = point[0];
    curve->pole[inner + 1] = point[n - 1];
    if (curve->head != NULL) {
        curve->head[0] = head[0];
        curve->head[inner + 1] = head[n - 1];
    }
    struct band matrix = band_new(inner, degree);
    double *right = mem_alloc(columns * inner, sizeof *right);

    for (size_t k = 1; k + 1 < n; k++) {
        size_t span = bspline_span(curve->degree, curve->poles, curve->knot, u[k]);
        bspline_basis(curve->degree, curve->knot, span, u[k], value);
        add_products(curve, span - degree, value, &matrix);
        add_point(curve, span - degree, value, curve->pole, point[k], right, columns);
        if (curve->head != NULL)
            add_point(curve, span - degree, value, curve->head, head[k], right + 3, columns);
    }
    bool determined = band_factor(&matrix);
    if (determined) {
        band_solve(&matrix, right, columns);
        take_poles(right, columns, inner, curve->pole);
        if (curve->head != NULL)
            take_poles(right + 3, columns, inner, curve->head);
    }
    band_free(&matrix);
    free(right);
    return determined;
}
