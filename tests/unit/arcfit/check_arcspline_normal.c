/* Tests of arcspline_normal.h: the right side is the slope of the sum of powers by each unknown,
 * the matrix that of the slopes. */
#include "arcfit/arcspline_normal.h"

#include <check.h>
#include <stdlib.h>

#include "math/pnorm.h"
#include "trial.h"

enum { ARCS = 9 };

/* n arcs near the reference. */
static struct arcspline chain_on(const struct reference *t, size_t n)
{
    struct arcspline c = arcspline_new(n);
    for (size_t i = 0; i <= n; i++) {
        double place = (double)(i * (t->n - 1)) / (double)n;
        c.joint[i] = (struct joint){.p = reference_point(t, place), .place = place, .side = 0.0003};
        c.joint[i].p.y += i % 2 ? 0.004 : 0;
        arcspline_set_axis(&c, t, i);
    }
    c.joint[0].tangent = t->tangent[0];
    arcspline_set_tangents(&c, 0);
    return c;
}

static struct arcspline_fit fit_on(const struct reference *t, bool turns, bool held)
{
    return (struct arcspline_fit){.reference = t,
                                  .spline = chain_on(t, ARCS),
                                  .feet = arc_feet_of(t, 0, t->n - 1, 100),
                                  .tolerance = 0.01,
                                  .offset = turns ? t->offset : 0,
                                  .other = 0.02,
                                  .start_held = held,
                                  .end_held = held,
                                  .end = vec_unit(vec(1, 0.01, 0.02))};
}

/* The distances in tolerances and the end's tangent; 4 for each foot and 3 more. */
static void distances(struct arcspline_fit *m, double held, double *off)
{
    size_t n = m->feet.n;
    arcspline_set_tangents(&m->spline, 0);
    arcspline_residual(&m->spline, m->offset, &m->feet, off);
    for (size_t i = 0; i < 2 * n; i++) {
        off[i] /= m->tolerance;
        off[2 * n + i] = m->offset != 0 ? off[2 * n + i] / m->other : 0;
    }
    struct vec3 d = vec_sub(m->spline.joint[ARCS].tangent, m->end);
    off[4 * n] = held * d.x;
    off[4 * n + 1] = held * d.y;
    off[4 * n + 2] = held * d.z;
}

/* Moves unknown k as the header says. */
static void move(struct arcspline_fit *m, size_t k, double by)
{
    size_t inner = ARCS - 1;
    if (!m->start_held) {
        struct vec3 *t = &m->spline.joint[0].tangent, u = vec_perpendicular(*t);
        if (k < 2) {
            *t = vec_unit(vec_along(*t, by, k ? vec_cross(*t, u) : u));
            return;
        }
        k -= 2;
    }
    size_t i = 1 + (k < 3 * inner ? k / 3 : k - 3 * inner);
    struct joint *j = &m->spline.joint[i];
    *(k >= 3 * inner ? &j->side : k % 3 == 0 ? &j->p.x : k % 3 == 1 ? &j->p.y : &j->p.z) += by;
    if (m->offset != 0)
        arcspline_set_axis(&m->spline, m->reference, i);
}

/* The slopes by differences: a column of 4 feet + 3 numbers for each unknown. */
static double *slopes_of(struct arcspline_fit *m, double held)
{
    const double by = 1e-6;
    size_t n = arcspline_unknowns(m), rows = 4 * m->feet.n + 3;
    double *slope = mem_alloc((n + 1) * rows, sizeof *slope), *there = slope + n * rows;
    struct arcspline kept = arcspline_new(ARCS);

    arcspline_copy(&kept, &m->spline);
    for (size_t k = 0; k < n; k++) {
        double *column = slope + k * rows;
        move(m, k, by);
        distances(m, held, column);
        arcspline_copy(&m->spline, &kept);
        move(m, k, -by);
        distances(m, held, there);
        arcspline_copy(&m->spline, &kept);
        for (size_t i = 0; i < rows; i++)
            column[i] = (column[i] - there[i]) / (2 * by);
    }
    arcspline_free(&kept);
    return slope;
}

/* Sums of products of the weighed slopes, against those of the module. */
static void compare(struct arcspline_fit *m, int half, double scale, double held)
{
    size_t n = arcspline_unknowns(m), pairs = 2 * m->feet.n, rows = 2 * pairs + 3;
    struct arcspline_normal w = arcspline_normal_new(m);
    double *slope = slopes_of(m, held), *off = mem_alloc(rows, sizeof *off);

    distances(m, held, off);
    arcspline_normal_set(m, off, half, scale, held, &w);
    for (size_t i = 0; i < pairs; i++) {
        double *d = off + 2 * i;
        struct pnorm_vector v = pnorm_vector_of(d[0], d[1], half, scale);
        for (size_t k = 0; k < n; k++) {
            double *s = slope + k * rows + 2 * i, x = s[0], y = s[1];
            s[0] = v.xx * x + v.xy * y;
            s[1] = v.xy * x + v.yy * y;
        }
        d[0] = v.x;
        d[1] = v.y;
    }
    for (size_t k = 0; k < n; k++) {
        const double *a = slope + k * rows;
        double right = 0, size = 0, of_right = 0;
        for (size_t i = 0; i < rows; i++) {
            right -= a[i] * off[i];
            size += a[i] * a[i];
            of_right += off[i] * off[i];
        }
        ck_assert_double_eq_tol(w.right[k], right, 0.05 * sqrt(size * of_right) + 1e-12);
        for (size_t l = 0; l <= k; l++) {
            const double *b = slope + l * rows;
            double product = 0, other = 0;
            for (size_t i = 0; i < rows; i++) {
                product += a[i] * b[i];
                other += b[i] * b[i];
            }
            ck_assert_double_eq_tol(*band_at(&w.normal, k, l), product,
                                    0.05 * sqrt(size * other) + 1e-12);
        }
    }
    free(slope);
    free(off);
    arcspline_normal_free(&w);
}

START_TEST(sums_are_those_of_the_slopes)
{
    struct reference t = trial_wave(161, 0.25, 0.2, 0);
    for (int turns = 0; turns < 2; turns++) {
        for (int held = 0; held < 2; held++) {
            for (int half = 1; half < 4; half++) {
                struct arcspline_fit m = fit_on(&t, turns, held);
                compare(&m, half, 0.8, held ? 50 : 0);
                arcspline_free(&m.spline);
                arc_feet_free(&m.feet);
            }
        }
    }
    reference_free(&t);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("arcspline_normal");
    tcase_add_test(t, sums_are_those_of_the_slopes);
    Suite *s = suite_create("arcspline_normal");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
