/* coverage_judge: what a judge takes for left of points that are said to be out of reach; the
 * directions of a machine. */
#include "stage/coverage_judge.h"

#include <check.h>
#include <stdlib.h>

static const double R = 4;

static struct vec3s scan;
static double *height;

/* A floor, points 0.5 apart, and with `slot` two walls 3 mm apart, 6 high. */
static void make(bool slot)
{
    for (int i = -24; i <= 24; i++)
        for (int k = -24; k <= 24; k++)
            *array_push(&scan) = vec(0.5 * i, 0.5 * k, 0);
    for (int k = -24; slot && k <= 24; k++)
        for (int h = 1; h <= 12; h++) {
            *array_push(&scan) = vec(-1.5, 0.5 * k, 0.5 * h);
            *array_push(&scan) = vec(1.5, 0.5 * k, 0.5 * h);
        }
    height = mem_alloc(scan.n, sizeof *height);
    for (size_t i = 0; i < scan.n; i++)
        height[i] = 0;
}

static void teardown(void)
{
    array_free(&scan);
    free(height);
    height = NULL;
}

static struct kinematic_chain table_ac(double most)
{
    return (struct kinematic_chain){
        .n = 2,
        .rotary = {{.axis = {0, 0, 1}, .table = true, .min = -1e4, .max = 1e4},
                   {.axis = {1, 0, 0}, .table = true, .min = -most, .max = most}},
        .tool = {0, 0, 1}};
}

static size_t judged(double limit, double near)
{
    const struct kinematic_chain chain = table_ac(RADIANS(120));
    const struct holder flute = {.n = 1, .part = {{R, R, 4 * R}}};
    const struct coverage_judge_options options = {.radius = R,
                                                   .limit = limit,
                                                   .near = near,
                                                   .holder = &flute,
                                                   .chain = &chain,
                                                   .scan = true,
                                                   .threads = 1};
    struct vec3s place = {0};
    for (size_t i = scan.n; i-- > 0;) /* in any order */
        *array_push(&place) = scan.item[i];
    size_t left = coverage_judge_left(scan.item, height, scan.n, &place, &options);
    array_free(&place);
    return left;
}

/* The floor is open: all that is asked of is left; nothing else is looked at. */
START_TEST(open_floor)
{
    make(false);
    size_t asked = 0, kept = 0;
    ck_assert_uint_eq(judged(0.05, 0.025), 0);
    for (size_t i = 0; i < scan.n; i++)
        if (fabs(scan.item[i].x) < 3 && fabs(scan.item[i].y) < 3) {
            height[i] = 0.06;
            asked++;
        }
    ck_assert_uint_eq(judged(0.05, 0.025), asked);
    for (size_t i = 0; i < scan.n; i++)
        kept += height[i] > 0;
    ck_assert_uint_eq(kept, asked);
}
END_TEST

/* No ball of 4 comes between the walls; one comes to the floor 5.5 from them and further. */
START_TEST(slot_is_out_of_reach)
{
    make(true);
    size_t open = 0, kept = 0;
    for (size_t i = 0; i < scan.n; i++)
        if (scan.item[i].z == 0 && fabs(scan.item[i].y) < 6) {
            height[i] = 1;
            open += fabs(scan.item[i].x) > 1.5 + R;
        }
    size_t left = judged(0.05, 0.025);
    ck_assert_uint_ge(left, open);
    ck_assert_double_le((double)left, 1.2 * (double)open);
    for (size_t i = 0; i < scan.n; i++) { /* the others are asked for no more */
        kept += height[i] > 0;
        if (height[i] > 0)
            ck_assert_double_ge(fabs(scan.item[i].x), R);
    }
    ck_assert_uint_eq(kept, left);
}
END_TEST

/* A hollow that fits the ball but for 0.03 is out of reach of a ball that has to come within 0.025,
 * and within reach of one that has to come within 0.04, whatever may be left. */
START_TEST(by_how_near)
{
    make(false);
    size_t middle = scan.n / 2;
    ck_assert_double_eq(vec_length(scan.item[middle]), 0);
    double sagitta = R - sqrt(R * R - 0.25); /* of the ball over its neighbours, 0.5 off */
    scan.item[middle].z = -sagitta - 0.03;
    for (double limit = 0.05; limit < 0.1; limit += 0.03) {
        height[middle] = 0.1; /* was set to 0 */
        ck_assert_uint_eq(judged(limit, 0.025), 0);
        height[middle] = 0.1;
        ck_assert_uint_eq(judged(limit, 0.04), 1);
        ck_assert_double_eq(height[middle], 0.1);
    }
}
END_TEST

START_TEST(axes_of_a_machine)
{
    struct kinematic_chain chain = table_ac(RADIANS(120));
    struct vec3s axes = coverage_judge_axes(&chain);
    ck_assert_uint_eq(axes.n, 251); /* the upper half of 500, and its own at zero */
    ck_assert_double_eq(axes.item[0].z, 1);
    array_free(&axes);
    chain = table_ac(RADIANS(30));
    axes = coverage_judge_axes(&chain);
    /* a cap of 30 degrees is 0.134 of the half sphere */
    ck_assert_uint_ge(axes.n, 30);
    ck_assert_uint_le(axes.n, 38);
    for (size_t i = 0; i < axes.n; i++)
        ck_assert_double_ge(axes.item[i].z, cos(RADIANS(30)) - 1e-9);
    array_free(&axes);
    chain = (struct kinematic_chain){
        .n = 1, .rotary = {{.axis = {0, 1, 0}, .min = -1, .max = 1}}, .tool = {0, 0, 1}};
    axes = coverage_judge_axes(&chain);
    ck_assert_uint_eq(axes.n, 24); /* every five degrees of 114.6, and its own */
    array_free(&axes);
    chain = (struct kinematic_chain){.n = 0, .tool = {0, 0, 1}};
    axes = coverage_judge_axes(&chain);
    ck_assert_uint_eq(axes.n, 1);
    array_free(&axes);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("coverage_judge");
    TCase *tests = tcase_create("coverage_judge");
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, open_floor);
    tcase_add_test(tests, slot_is_out_of_reach);
    tcase_add_test(tests, by_how_near);
    tcase_add_test(tests, axes_of_a_machine);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
