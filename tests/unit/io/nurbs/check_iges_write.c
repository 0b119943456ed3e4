/*
 * iges_write - surfaces out as IGES and back: loops within loops belong to the smallest one that
 * goes round them, numbers and weights are the same, and each line has its 80 columns.
 */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/nurbs/surfaces.h"
#include "io/nurbs/surfaces_write.h"
#include "scratch.h"

static struct patches given, back;
static struct error error;

/* The surfaces of a text, written as IGES and read again. */
static void there_and_back(const char *text, const char *remark)
{
    struct surfaces_unit unit;
    given = back = (struct patches){0};
    ck_assert_msg(surfaces_read(scratch_text(text), 0, &given, &unit, &error) == 0, "%s",
                  error.text);
    struct out *out = out_open(scratch_name());
    surfaces_write_iges(out, &given, remark);
    out_close(out);
    ck_assert_msg(surfaces_read(scratch_name(), 0, &back, &unit, &error) == 0, "%s", error.text);
}

static void teardown(void)
{
    patches_free(&given);
    patches_free(&back);
}

/* The area inside a loop of lines, positive where it runs counter-clockwise. */
static double area_of(const struct patch_loop *loop)
{
    double sum = 0;
    for (size_t k = 0; k < loop->n; k++) {
        const struct nurbs_curve *c = &loop->item[k];
        for (size_t i = 0; i + 1 < c->t.poles; i++) {
            struct nurbs_pole a = c->pole[i], b = c->pole[i + 1];
            sum += (a.wx * b.wy - a.wy * b.wx) / 2;
        }
    }
    return sum;
}

#define PLANE                                                                                    \
    "surface degree 1 1 poles 2 2 knots_u 0 0 1 1 knots_v 0 0 1 1 points 0 0 0 100 0 0 0 100 0 " \
    "100 100 0\n"

/* Two squares beside each other; in the first a hole, in that an island, in that a hole again. */
START_TEST(loops_within_loops)
{
    static const struct {
        size_t loops;
        double outer, inner; /* areas */
    } want[] = {{2, 0.36 * 0.36, 0.2 * 0.2}, {2, 0.1 * 0.1, 0.02 * 0.02}, {1, 0.2 * 0.2, 0}};
    there_and_back("nurbs 1\nunit mm\n" PLANE "loop 0.02 0.02 0.38 0.02 0.38 0.38 0.02 0.38\n"
                   "loop 0.1 0.1 0.1 0.3 0.3 0.3 0.3 0.1\n"
                   "loop 0.15 0.15 0.25 0.15 0.25 0.25 0.15 0.25\n"
                   "loop 0.2 0.2 0.2 0.22 0.22 0.22 0.22 0.2\n"
                   "loop 0.7 0.7 0.9 0.7 0.9 0.9 0.7 0.9\nend\n",
                   "loops\n");
    ck_assert_uint_eq(back.n, 3);
    for (size_t i = 0; i < 3; i++) {
        const struct patch_loops *loops = &back.item[i].loop;
        ck_assert_uint_eq(loops->n, want[i].loops);
        ck_assert_double_eq_tol(fabs(area_of(&loops->item[0])), want[i].outer, 1e-9);
        if (loops->n > 1)
            ck_assert_double_eq_tol(fabs(area_of(&loops->item[1])), want[i].inner, 1e-9);
    }
}
END_TEST

/* Numbers with their nine decimals, weights, degrees and ranges. */
START_TEST(a_rational_surface)
{
    there_and_back("nurbs 1\nunit mm\nsurface degree 2 1 poles 3 2 knots_u 0 0 0 1 1 1 "
                   "knots_v 0 0 3 3 points 5 0 0 5 5 0 0 5 0 5 0 3 5 5 3 0.123456789 5 3 "
                   "weights 1 0.70710678118654752 1 1 0.70710678118654752 1 range 0 0.5 1 2\nend\n",
                   "one\n");
    ck_assert_uint_eq(back.n, 1);
    const struct nurbs *a = &given.item[0].surface, *b = &back.item[0].surface;
    ck_assert_int_eq(b->u.degree, 2);
    ck_assert_int_eq(b->v.degree, 1);
    ck_assert_uint_eq(b->u.poles, 3);
    ck_assert_uint_eq(b->v.poles, 2);
    ck_assert(b->u.from == 0 && b->u.to == 0.5 && b->v.from == 1 && b->v.to == 2);
    for (size_t k = 0; k < 6; k++)
        ck_assert_double_eq(b->u.knot[k], a->u.knot[k]);
    for (size_t k = 0; k < 6; k++) {
        struct nurbs_pole p = a->pole[k], q = b->pole[k];
        ck_assert_double_eq_tol(q.w, p.w, 1e-9);
        ck_assert_double_eq_tol(q.wx / q.w, p.wx / p.w, 1e-9);
        ck_assert_double_eq_tol(q.wy / q.w, p.wy / p.w, 1e-9);
        ck_assert_double_eq_tol(q.wz / q.w, p.wz / p.w, 1e-9);
    }
    ck_assert_uint_eq(back.item[0].loop.n, 0);
}
END_TEST

/* Lines of the remark of every length about the 72 columns: all of each is there, and each line of
 * the file has 80 columns, its letter and its number in the last eight. */
START_TEST(lines_of_80_columns)
{
    for (int length = 0; length < 220; length++) {
        char remark[300], said[1000] = "";
        snprintf(remark, sizeof remark, "%.*s\nlast\n", length,
                 "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ-+"
                 "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ-+"
                 "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ-+"
                 "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ-+");
        there_and_back("nurbs 1\nunit mm\n" PLANE "end\n", remark);
        size_t n;
        char *text = scratch_read(&n), was = 'S';
        int number = 0;
        for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n")) {
            ck_assert_uint_eq(strlen(line), 80);
            number = line[72] == was ? number + 1 : 1;
            was = line[72];
            ck_assert_int_eq(atoi(line + 73), number);
            if (was != 'S')
                continue;
            size_t wide = 72;
            while (wide > 0 && line[wide - 1] == ' ')
                wide--;
            bool more = wide == 72 && line[71] == '\\';
            ck_assert(!more || length > 72);
            snprintf(said + strlen(said), sizeof said - strlen(said), "%.*s%s",
                     (int)(more ? 71 : wide), line, more ? "" : "\n");
        }
        ck_assert_str_eq(said, remark);
        ck_assert_int_eq(was, 'T');
        free(text);
        teardown();
    }
    given = back = (struct patches){0};
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("iges_write");
    TCase *tcase = tcase_create("iges_write");
    tcase_add_checked_fixture(tcase, NULL, teardown);
    tcase_add_test(tcase, loops_within_loops);
    tcase_add_test(tcase, a_rational_surface);
    tcase_add_test(tcase, lines_of_80_columns);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
