/*
 * check_path_spline - MOVNRB statements: a line as a B-spline is that line; sizes, knots, poles and
 * lengths at the edge of what is taken, and one step beyond.
 */
#include <check.h>
#include <stdio.h>
#include <string.h>

#include "io/path/path.h"
#include "scratch.h"

static struct path path;
static struct error error = {.text = ""};

static void teardown(void)
{
    path_free(&path);
}

/* Statements between GOTO/0,0,0 and FINI. */
static int take(const char *statements)
{
    char text[4000];
    snprintf(text, sizeof text, "UNITS/MM\nMULTAX\nGOTO/0,0,0,0,0,1\n%sFINI\n", statements);
    path_free(&path);
    path = (struct path){0};
    return path_read(scratch_text(text), &path, &error);
}

static void taken(const char *statements)
{
    ck_assert_msg(take(statements) == 0, "%s\n%s", error.text, statements);
}

static void refused(const char *statements, const char *says)
{
    ck_assert_msg(take(statements) < 0, "taken: %s", statements);
    ck_assert_msg(strstr(error.text, says) != NULL, "%s\n lacks: %s", error.text, says);
}

#define THREE "MOVNRB/M3AXIS\n"
#define FIVE "MOVNRB/5AXIS,LENGTH,100\n"
#define CUBIC "MOVNRB/ON,4,8,0,4,3\nMOVNRB/1,0,0,0,0,3,3,3,3\n"
#define ALONG "MOVNRB/2,0,0,0,1,0,0,2,0,0,3,0,0\n"
#define END "MOVNRB/NEXT\nGOTO/3,0,0\nMOVNRB/OFF\n"

START_TEST(poles_on_a_line_are_that_line)
{
    taken(THREE CUBIC ALONG END);
    ck_assert_uint_eq(path.spline.n, 1);
    const struct bspline *c = &path.spline.item[0].curve;
    ck_assert_int_eq(c->degree, 3);
    ck_assert_uint_eq(c->poles, 4);
    for (int i = 0; i < 4; i++)
        ck_assert_double_eq(vec_distance(c->pole[i], vec(i, 0, 0)), 0);
    ck_assert_uint_eq(path.spline.item[0].fallback.n, 1);
    const struct path_item *last = &path.item.item[path.item.n - 1];
    ck_assert_double_eq(vec_distance(last->to.p, vec(3, 0, 0)), 0);
    ck_assert_double_eq(vec_distance(last->to.a, vec(0, 0, 1)), 0);
}
END_TEST

/* With five axes the head is where the axis points to, in the unit of the stream. */
START_TEST(heads_give_the_axis)
{
    taken(FIVE CUBIC ALONG "MOVNRB/3,0,0,100,1,0,100,2,0,100,63,0,80\n" END);
    const struct path_item *last = &path.item.item[path.item.n - 1];
    ck_assert_double_lt(vec_distance(last->to.a, vec(0.6, 0, 0.8)), 1e-12);
    ck_assert_double_eq(path.spline.item[0].curve.length, 100);
    ck_assert_int_eq(
        take("UNITS/INCHES\n" FIVE CUBIC ALONG "MOVNRB/3,0,0,100,1,0,100,2,0,100,63,0,80\n" END),
        0);
    ck_assert_double_eq_tol(path.spline.item[0].curve.length, 2540, 1e-9);
    ck_assert_double_eq_tol(path.spline.item[0].curve.pole[3].x, 76.2, 1e-9);
}
END_TEST

/* Lengths that are wrong by no more than printing rounds are taken: 0.01. */
START_TEST(ends_may_be_off_by_a_hundredth)
{
    taken(THREE CUBIC "MOVNRB/2,0.0099,0,0,1,0,0,2,0,0,3,0,0\n" END);
    refused(THREE CUBIC "MOVNRB/2,0.0101,0,0,1,0,0,2,0,0,3,0,0\n" END, "from where the tool is");
    taken(FIVE CUBIC ALONG "MOVNRB/3,0,0,99.991,1,0,50,2,0,50,3,0,100.009\n" END);
    refused(FIVE CUBIC ALONG "MOVNRB/3,0,0,99.989,1,0,100,2,0,100,3,0,100\n" END,
            "LENGTH 100.0000");
    refused(FIVE CUBIC ALONG "MOVNRB/3,0,0,100,1,0,100,2,0,100,3,0,100.011\n" END,
            "LENGTH 100.0000");
    refused("MOVNRB/5AXIS,LENGTH,0\n", "above 0");
    refused("MOVNRB/5AXIS,LENGTH,-1\n", "above 0");
    refused("MOVNRB/5AXIS,100\n", "LENGTH");
}
END_TEST

static const struct {
    const char *sizes;
    bool good;
} sizes[] = {
    {"2,4,0,2,1", true},      {"1,3,0,2,1", false},         {"10,20,0,10,1", true},
    {"11,22,0,11,1", false},  {"4,7,0,3,1", false},         {"4,8,0,4,1", true},
    {"4,9,0,4,1", false},     {"4,7,0,4,1", false},         {"4.5,8.5,0,4,1", false},
    {"4,8.5,0,4.5,1", false}, {"4,10000004,0,1e7,1", true}, {"4,10000005,0,10000001,1", false},
    {"4,8,1,4,1", false}};

START_TEST(orders_and_counts)
{
    char text[100];
    snprintf(text, sizeof text, THREE "MOVNRB/ON,%s\n", sizes[_i].sizes);
    refused(text, sizes[_i].good ? "found FINI" : "found MOVNRB ");
}
END_TEST

static const struct {
    const char *knots, *says; /* NULL: good */
} knots[] = {
    {"0,0,0,0,1,3,3,3,3", NULL},
    {"0,0,0,0,0,3,3,3,3", "knot 5 more than 3 times"}, /* the first pole would count for nothing */
    {"-3,-3,-3,-3,1,3,3,3,3", NULL},
    {"0,0,0,0,3,3,3,3,3", "knot 8 more than 3 times"},
    {"0,0,0,0,1,3,3,3", "8 knots"},
    {"0,0,0,0,1,3,3,3,3,3", "10 knots"},
    {"0,0,0,1,1,3,3,3,3", "repeated 4"},
    {"0,0,0,0,1,2,3,3,3", "repeated 4"},
    {"0,0,0,0,0,0,0,0,0", "times"},
    {"0,0,0,0,-1,3,3,3,3", "knot 5 below"},
    {"0,0,0,0,1,3,3,3,2", "knot 9 below"},
    {"0,0,0,0,x,3,3,3,3", "finite number"},
};

START_TEST(knots_rise_and_the_ends_repeat)
{
    char text[400];
    snprintf(text, sizeof text,
             THREE "MOVNRB/ON,4,9,0,5,3\nMOVNRB/1,%s\n"
                   "MOVNRB/2,0,0,0,1,0,0,2,0,0,2.5,0,0,3,0,0\n" END,
             knots[_i].knots);
    if (knots[_i].says)
        refused(text, knots[_i].says);
    else
        taken(text);
}
END_TEST

/* As often as the degree is a corner; once more a gap. */
START_TEST(a_corner_is_no_gap)
{
    static const char *const seven = "MOVNRB/2,0,0,0,1,0,0,2,0,0,3,0,0,3,1,0,3,2,0,3,3,0%s\n"
                                     "MOVNRB/NEXT\nGOTO/3,0,0\nGOTO/3,3,0\nMOVNRB/OFF\n";
    char text[600], poles[400];
    snprintf(poles, sizeof poles, seven, "");
    snprintf(text, sizeof text, THREE "MOVNRB/ON,4,11,0,7,3\nMOVNRB/1,0,0,0,0,1,1,1,3,3,3,3\n%s",
             poles);
    taken(text);
    ck_assert_uint_eq(path.spline.item[0].fallback.n, 2);
    snprintf(poles, sizeof poles, seven, ",3,4,0");
    snprintf(text, sizeof text, THREE "MOVNRB/ON,4,12,0,8,3\nMOVNRB/1,0,0,0,0,1,1,1,1,3,3,3,3\n%s",
             poles);
    refused(text, "knot 8 more than 3 times");
}
END_TEST

START_TEST(counts_of_numbers)
{
    refused(THREE CUBIC "MOVNRB/2,0,0,0,1,0,0,2,0,0,3,0\n", "found 11 numbers in MOVNRB/2");
    refused(THREE CUBIC "MOVNRB/2,0,0,0,1,0,0,2,0,0,3,0,0,4\n", "found 13 numbers in MOVNRB/2");
    refused(FIVE CUBIC ALONG "MOVNRB/3,0,0,100\n", "found 3 numbers in MOVNRB/3");
    refused(THREE CUBIC END, "8 knots, 0 poles");
}
END_TEST

static const char *const unordered[] = {
    "MOVNRB/ON,4,8,0,4,3\n",
    "MOVNRB/OFF\n",
    "MOVNRB/NEXT\n",
    "MOVNRB/1,0,1\n",
    THREE "MOVNRB/OFF\n",
    THREE THREE,
    THREE CUBIC CUBIC,
    THREE CUBIC "MOVNRB/1,0,0,0,0,3,3,3,3\n",
    THREE CUBIC ALONG ALONG,
    THREE CUBIC ALONG "MOVNRB/3,0,0,100,1,0,100,2,0,100,3,0,100\n",
    THREE CUBIC ALONG "MOVNRB/OFF\n",
    THREE CUBIC ALONG "MOVNRB/NEXT\nMOVNRB/NEXT\n",
    THREE CUBIC ALONG END "MOVNRB/OFF\n",
    FIVE CUBIC ALONG "MOVNRB/NEXT\n",
    THREE "MOVNRB/FROB\n",
};

START_TEST(out_of_order)
{
    refused(unordered[_i], "MOVNRB");
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("path_spline");
    TCase *tests = tcase_create("path_spline");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, poles_on_a_line_are_that_line);
    tcase_add_test(tests, heads_give_the_axis);
    tcase_add_test(tests, ends_may_be_off_by_a_hundredth);
    tcase_add_loop_test(tests, orders_and_counts, 0, sizeof sizes / sizeof *sizes);
    tcase_add_loop_test(tests, knots_rise_and_the_ends_repeat, 0, sizeof knots / sizeof *knots);
    tcase_add_test(tests, a_corner_is_no_gap);
    tcase_add_test(tests, counts_of_numbers);
    tcase_add_loop_test(tests, out_of_order, 0, sizeof unordered / sizeof *unordered);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
