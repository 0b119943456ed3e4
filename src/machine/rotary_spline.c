/* rotary_spline - see rotary_spline.h. */
#include "machine/rotary_spline.h"

#include <stdlib.h>

#include "base/array.h"

enum { WIDTH = BSPLINE_DEGREE_MAX + 1, MORE = 3 }; /* samples of a span: degree + MORE */

/* Normal equations of the inner poles: row i holds the diagonal and `degree` places right of it. */
struct normal {
    size_t n, width;
    double *band, *right[ROTARY_MAX];
};

static void add_sample(struct normal *normal, const struct bspline *b, size_t span,
                       const double *basis, const double q[], double *pole[], int axes)
{
    size_t p = (size_t)b->degree, last = b->poles - 1;
    double rest[ROTARY_MAX];
    for (int k = 0; k < axes; k++) {
        rest[k] = q[k];
        for (size_t i = 0; i <= p; i++)
            if (span - p + i == 0 || span - p + i == last)
                rest[k] -= basis[i] * pole[k][span - p + i];
    }
    for (size_t i = 0; i <= p; i++) {
        size_t row = span - p + i;
        if (row == 0 || row == last)
            continue;
        for (int k = 0; k < axes; k++)
            normal->right[k][row - 1] += basis[i] * rest[k];
        for (size_t j = i; j <= p && span - p + j < last; j++)
            normal->band[(row - 1) * normal->width + j - i] += basis[i] * basis[j];
    }
}

/* Banded Cholesky, in place; then both right sides. */
static void solve(struct normal *m, int axes)
{
    for (size_t j = 0; j < m->n; j++) {
        double *row = &m->band[j * m->width];
        double root = sqrt(fmax(row[0], 1e-30));
        for (size_t k = 0; k < m->width; k++)
            row[k] /= root;
        for (size_t i = 1; i < m->width && j + i < m->n; i++)
            for (size_t k = i; k < m->width && j + k < m->n; k++)
                m->band[(j + i) * m->width + k - i] -= row[i] * row[k];
    }
    for (int a = 0; a < axes; a++) {
        double *x = m->right[a];
        for (size_t j = 0; j < m->n; j++) {
            x[j] /= m->band[j * m->width];
            for (size_t k = 1; k < m->width && j + k < m->n; k++)
                x[j + k] -= m->band[j * m->width + k] * x[j];
        }
        for (size_t j = m->n; j-- > 0;) {
            for (size_t k = 1; k < m->width && j + k < m->n; k++)
                x[j] -= m->band[j * m->width + k] * x[j + k];
            x[j] /= m->band[j * m->width];
        }
    }
}

/* The angles at all samples, each from the one before: samples * axes; NULL: out of travel. */
static double *sample_angles(const struct kinematic_chain *chain, const struct motion *motion,
                             const double from[], size_t each, size_t *n, int *over)
{
    const struct bspline *b = motion->curve;
    double *angle = mem_alloc((b->poles * each + 1) * ROTARY_MAX, sizeof *angle);
    double q[ROTARY_MAX] = {from[0], from[1]};
    *n = 0;
    for (double s = 0; s < 1;) {
        double next = motion_next_knot(motion, s);
        for (size_t i = 1; i <= each; i++) {
            struct pose at = motion_at(motion, s + (next - s) * (double)i / (double)each);
            if (ik_choose(chain, at.a, q, true, -1, q, over) != 0)
                return free(angle), NULL;
            for (int k = 0; k < ROTARY_MAX; k++)
                angle[*n * ROTARY_MAX + (size_t)k] = q[k];
            ++*n;
        }
        s = next;
    }
    return angle;
}

int rotary_spline_fit(const struct kinematic_chain *chain, const struct motion *motion,
                      const double from[], double *pole[ROTARY_MAX], int *over)
{
    const struct bspline *b = motion->curve;
    size_t each = (size_t)b->degree + MORE, samples, width = (size_t)b->degree + 1;
    double *angle = sample_angles(chain, motion, from, each, &samples, over);
    if (!angle)
        return -1;
    struct normal normal = {.n = b->poles - 2, .width = width};
    normal.band = mem_alloc(b->poles * width, sizeof(double));
    for (int k = 0; k < ROTARY_MAX; k++)
        normal.right[k] = mem_alloc(b->poles, sizeof(double));
    for (int k = 0; k < chain->n; k++) {
        pole[k][0] = from[k];
        pole[k][b->poles - 1] = angle[(samples - 1) * ROTARY_MAX + (size_t)k];
    }
    size_t at = 0;
    for (size_t span = (size_t)b->degree; span < b->poles; span++) {
        double u = b->knot[span], h = b->knot[span + 1] - u, basis[WIDTH];
        for (size_t i = 1; h > 0 && i <= each; i++, at++) {
            bspline_basis(b->degree, b->knot, span, u + h * (double)i / (double)each, basis);
            add_sample(&normal, b, span, basis, &angle[at * ROTARY_MAX], pole, chain->n);
        }
    }
    solve(&normal, chain->n);
    for (int k = 0; k < ROTARY_MAX; k++) {
        for (size_t i = 0; k < chain->n && i < normal.n; i++)
            pole[k][i + 1] = normal.right[k][i];
        free(normal.right[k]);
    }
    free(normal.band);
    free(angle);
    return 0;
}
