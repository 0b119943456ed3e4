/*
 * height_fit - see height_fit.h.  The normal equations are a band, with the shorter side of the
 * net as its rows.
 */
#include "nurbs/height_fit.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "curve/bspline.h"
#include "math/band.h"

enum { DEGREE = 3, ORDER = DEGREE + 1 };

static struct nurbs_axis make_axis(const double range[2], const double *inner, size_t n)
{
    struct nurbs_axis axis = {DEGREE, n + ORDER, mem_alloc(n + 2 * ORDER, sizeof *axis.knot),
                              range[0], range[1]};

    for (size_t k = 0; k < ORDER; k++) {
        axis.knot[k] = range[0];
        axis.knot[axis.poles + k] = range[1];
    }
    memcpy(axis.knot + ORDER, inner, n * sizeof *inner);
    return axis;
}

struct height_fit height_fit_new(const double range_x[2], const double *knot_x, size_t knots_x,
                                 const double range_y[2], const double *knot_y, size_t knots_y)
{
    struct height_fit fit = {make_axis(range_x, knot_x, knots_x),
                             make_axis(range_y, knot_y, knots_y), NULL};

    fit.z = mem_alloc(fit.x.poles * fit.y.poles, sizeof *fit.z);
    return fit;
}

void height_fit_free(struct height_fit *fit)
{
    free(fit->x.knot);
    free(fit->y.knot);
    free(fit->z);
    *fit = (struct height_fit){.z = NULL};
}

/* ---- the system */

struct system {
    const struct height_fit *fit;
    size_t across_x, across_y; /* from a pole to the next one along x and y, in the unknowns */
    struct band band;
    double *right;
};

/* The functions that are not zero at a place, along one axis, with two derivatives. */
struct local {
    size_t first; /* pole */
    double value[3 * ORDER];
};

static struct local functions_at(const struct nurbs_axis *axis, double t, int order)
{
    struct local l;
    double at = fmin(fmax(t, axis->from), axis->to);
    size_t span = bspline_span(DEGREE, axis->poles, axis->knot, at);

    l.first = span - DEGREE;
    if (order == 0)
        bspline_basis(DEGREE, axis->knot, span, at, l.value);
    else
        bspline_basis_derivatives(DEGREE, axis->knot, span, at, order, l.value);
    return l;
}

static struct system system_new(const struct height_fit *fit)
{
    size_t nx = fit->x.poles, ny = fit->y.poles;
    bool by_x = nx <= ny;

    return (struct system){fit, by_x ? 1 : ny, by_x ? nx : 1,
                           band_new(nx * ny, DEGREE * (by_x ? nx : ny) + DEGREE),
                           mem_alloc(nx * ny, sizeof(double))};
}

static void system_free(struct system *s)
{
    band_free(&s->band);
    free(s->right);
}

/* Adds `weight` times the square of (row . unknowns - value). */
static void add_row(struct system *s, size_t first_x, size_t first_y, const double row[],
                    double weight, double value)
{
    size_t at[ORDER * ORDER];

    for (size_t k = 0; k < ORDER * ORDER; k++)
        at[k] = (first_x + k % ORDER) * s->across_x + (first_y + k / ORDER) * s->across_y;
    for (size_t k = 0; k < ORDER * ORDER; k++) {
        s->right[at[k]] += weight * row[k] * value;
        for (size_t l = 0; l < ORDER * ORDER; l++)
            if (at[l] <= at[k])
                *band_at(&s->band, at[k], at[l]) += weight * row[k] * row[l];
    }
}

static void product(const double *x, const double *y, double row[])
{
    for (size_t k = 0; k < ORDER * ORDER; k++)
        row[k] = x[k % ORDER] * y[k / ORDER];
}

static void add_points(struct system *s, const struct vec3 *point, size_t n)
{
    double row[ORDER * ORDER];

    for (size_t i = 0; i < n; i++) {
        struct local x = functions_at(&s->fit->x, point[i].x, 0);
        struct local y = functions_at(&s->fit->y, point[i].y, 0);
        product(x.value, y.value, row);
        add_row(s, x.first, y.first, row, 1, point[i].z);
    }
}

/* Gauss's places and weights on -1 to 1, exact up to degree 7. */
static const double GAUSS[4] = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                0.8611363115940526};
static const double WEIGHT[4] = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                 0.3478548451374538};

static void add_energy_at(struct system *s, double x, double y, double weight)
{
    struct local fx = functions_at(&s->fit->x, x, 2), fy = functions_at(&s->fit->y, y, 2);
    double row[ORDER * ORDER];

    for (int order = 0; order <= 2; order++) { /* of y; the rest is of x */
        product(fx.value + (2 - order) * ORDER, fy.value + order * ORDER, row);
        add_row(s, fx.first, fy.first, row, order == 1 ? 2 * weight : weight, 0);
    }
}

static void add_energy(struct system *s, double weight)
{
    const struct nurbs_axis *x = &s->fit->x, *y = &s->fit->y;

    for (size_t i = DEGREE; i < x->poles; i++)
        for (size_t j = DEGREE; j < y->poles; j++) {
            double wide = (x->knot[i + 1] - x->knot[i]) / 2,
                   high = (y->knot[j + 1] - y->knot[j]) / 2;
            for (int k = 0; k < 16 && wide > 0 && high > 0; k++)
                add_energy_at(s, x->knot[i] + wide * (1 + GAUSS[k % 4]),
                              y->knot[j] + high * (1 + GAUSS[k / 4]),
                              weight * wide * high * WEIGHT[k % 4] * WEIGHT[k / 4]);
        }
}

bool height_fit_solve(struct height_fit *fit, const struct vec3 *point, size_t n, double smooth)
{
    struct system s = system_new(fit);
    double wide = fit->x.to - fit->x.from, high = fit->y.to - fit->y.from;
    double cell = wide * high / (double)((fit->x.poles - DEGREE) * (fit->y.poles - DEGREE));

    add_points(&s, point, n);
    add_energy(&s, smooth * (double)n / (wide * high) * cell * cell);
    bool solved = n >= 3 && band_factor(&s.band);
    if (solved)
        band_solve(&s.band, s.right, 1);
    for (size_t j = 0; j < fit->y.poles && solved; j++)
        for (size_t i = 0; i < fit->x.poles; i++)
            fit->z[j * fit->x.poles + i] = s.right[i * s.across_x + j * s.across_y];
    system_free(&s);
    return solved;
}

/* ---- the surface */

double height_fit_at(const struct height_fit *fit, double x, double y, double slope[2])
{
    struct local fx = functions_at(&fit->x, x, 1), fy = functions_at(&fit->y, y, 1);
    double z = 0;

    slope[0] = slope[1] = 0;
    for (size_t j = 0; j < ORDER; j++) {
        const double *row = fit->z + (fy.first + j) * fit->x.poles + fx.first;
        double height = 0, along = 0;
        for (size_t i = 0; i < ORDER; i++) {
            height += row[i] * fx.value[i];
            along += row[i] * fx.value[ORDER + i];
        }
        z += height * fy.value[j];
        slope[0] += along * fy.value[j];
        slope[1] += height * fy.value[ORDER + j];
    }
    return z;
}

double height_fit_off(const struct height_fit *fit, struct vec3 p)
{
    double slope[2], z = height_fit_at(fit, p.x, p.y, slope);

    return (p.z - z) / sqrt(1 + slope[0] * slope[0] + slope[1] * slope[1]);
}

/* The Greville abscissa of a pole: where the sum of poles times functions is the place itself. */
static double greville(const struct nurbs_axis *axis, size_t i)
{
    return (axis->knot[i + 1] + axis->knot[i + 2] + axis->knot[i + 3]) / DEGREE;
}

static struct nurbs_axis copy_axis(const struct nurbs_axis *axis)
{
    return make_axis((double[2]){axis->from, axis->to}, axis->knot + ORDER, axis->poles - ORDER);
}

struct nurbs height_fit_surface(const struct height_fit *fit)
{
    struct nurbs s = {copy_axis(&fit->x), copy_axis(&fit->y),
                      mem_alloc(fit->x.poles * fit->y.poles, sizeof *s.pole)};

    for (size_t j = 0; j < fit->y.poles; j++)
        for (size_t i = 0; i < fit->x.poles; i++) {
            size_t k = j * fit->x.poles + i;
            s.pole[k] =
                (struct nurbs_pole){greville(&fit->x, i), greville(&fit->y, j), fit->z[k], 1};
        }
    return s;
}
