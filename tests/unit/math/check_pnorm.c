/* Tests of pnorm.h: the right side is the slope of the sum, the step leads to the least squares.
 */
#include "math/pnorm.h"

#include <check.h>
#include <math.h>
#include <stdlib.h>

enum { POINTS = 7, UNKNOWNS = 3 };

static double some(size_t i)
{
    return sin(12.9898 * (double)i + 0.5);
}

/* Pairs that depend on three unknowns x in a straight way; unknown k moves points from k on. */
static void set(struct pnorm *s, const double x[UNKNOWNS], double *off, double held[3])
{
    for (size_t i = 0; i < 2 * s->pairs; i++)
        off[i] = some(i);
    for (size_t c = 0; c < 3; c++)
        held[c] = some(100 + c);
    for (size_t k = 0; k < UNKNOWNS; k++) {
        struct pnorm_column *column = &s->column[k];
        column->from = k;
        column->to = POINTS;
        for (size_t i = 0; i < 2 * s->pairs; i++) {
            column->slope[i] = some(200 + 100 * k + i);
            off[i] += i / 2 % POINTS >= k ? column->slope[i] * x[k] : 0;
        }
        for (size_t c = 0; c < 3; c++) {
            column->held[c] = some(900 + 10 * k + c);
            held[c] += column->held[c] * x[k];
        }
    }
}

static double cost_at(struct pnorm *s, const double x[UNKNOWNS], int half)
{
    double off[4 * POINTS], held[3];

    set(s, x, off, held);
    return pnorm_cost(s, off, held, half, 0.8);
}

START_TEST(the_right_side_is_the_slope)
{
    for (int half = 1; half < 9; half += 3) {
        for (int twice = 0; twice < 2; twice++) {
            struct pnorm s = pnorm_new(POINTS, twice, UNKNOWNS);
            double x[UNKNOWNS] = {0.1, -0.2, 0.3}, slope[UNKNOWNS];
            for (int k = 0; k < UNKNOWNS; k++) {
                double here = x[k], step = 1e-6;
                x[k] = here + step;
                slope[k] = cost_at(&s, x, half);
                x[k] = here - step;
                slope[k] = (slope[k] - cost_at(&s, x, half)) / (2 * step);
                x[k] = here;
            }
            set(&s, x, s.off, s.held);
            pnorm_equations(&s, half, 0.8);
            for (int k = 0; k < UNKNOWNS; k++)
                ck_assert_double_eq_tol(-2 * s.right[k], slope[k], 1e-5 * (1 + fabs(slope[k])));
            pnorm_free(&s);
        }
    }
}
END_TEST

START_TEST(squares_are_least_after_one_step)
{
    struct pnorm s = pnorm_new(POINTS, true, UNKNOWNS);
    double x[UNKNOWNS] = {0.1, -0.2, 0.3};

    set(&s, x, s.off, s.held);
    pnorm_equations(&s, 1, 0.8);
    ck_assert(band_factor(&s.normal));
    band_solve(&s.normal, s.right, 1);
    for (int k = 0; k < UNKNOWNS; k++)
        x[k] += s.right[k];
    double least = cost_at(&s, x, 1);
    for (int k = 0; k < UNKNOWNS; k++) {
        for (int way = -1; way < 2; way += 2) {
            x[k] += 1e-3 * way;
            ck_assert_double_gt(cost_at(&s, x, 1), least);
            x[k] -= 1e-3 * way;
        }
    }
    pnorm_free(&s);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("pnorm");
    tcase_add_test(t, the_right_side_is_the_slope);
    tcase_add_test(t, squares_are_least_after_one_step);
    Suite *s = suite_create("pnorm");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
