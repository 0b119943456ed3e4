/* step: instances are found by their numbers and lines, values have the kinds, numbers and sizes
 * that the clear text says (ISO 10303-21), and what is no such text is refused with its line. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "io/nurbs/step.h"
#include "scratch.h"

static struct step step;
static struct step_values values;
static struct error error;

static void teardown(void)
{
    array_free(&values);
    step_free(&step);
}

static int read_text(const char *data)
{
    char text[2000];
    struct reader r;
    snprintf(text, sizeof text,
             "ISO-10303-21;\nHEADER;\nFILE_NAME('#1=X();','',(''),(''),'','','');\nENDSEC;\nDATA;\n"
             "%sENDSEC;\nEND-ISO-10303-21;\n",
             data);
    ck_assert_int_eq(reader_open(&r, scratch_text(text), &error), 0);
    int status = step_read(&r, &step, &error);
    reader_close(&r);
    return status;
}

static void values_of(long id)
{
    const struct step_instance *instance = step_find(&step, id);
    ck_assert_ptr_nonnull(instance);
    array_free(&values);
    ck_assert_msg(step_values(&step, instance, &values, &error) == 0, "%s", error.text);
}

/* In any order, over several lines, with comments between; others are not there. */
START_TEST(instances)
{
    ck_assert_int_eq(
        read_text("#30=C();\n#7 = A(1.,\n 2.) ; #8=B(#7);\n/* #9=D(); */\n#100=E();\n"), 0);
    static const long ids[] = {7, 8, 30, 100};
    static const size_t lines[] = {7, 8, 6, 10};
    ck_assert_uint_eq(step.instance.n, 4);
    for (size_t i = 0; i < 4; i++) {
        ck_assert_int_eq(step.instance.item[i].id, ids[i]);
        ck_assert_ptr_eq(step_find(&step, ids[i]), &step.instance.item[i]);
        ck_assert_uint_eq(step_find(&step, ids[i])->line, lines[i]);
    }
    ck_assert_ptr_null(step_find(&step, 1)); /* in a text of the head */
    ck_assert_ptr_null(step_find(&step, 9));
    ck_assert_ptr_null(step_find(&step, 0));
    ck_assert_ptr_null(step_find(&step, 101));
}
END_TEST

START_TEST(kinds)
{
    ck_assert_int_eq(
        read_text("#1=ALL(-1.5E-2,7,#42,'it''s; (so)',.TRUE.,$,*,(1.,(2.,3.),()),LENGTH(4.));\n"),
        0);
    values_of(1);
    const struct step_value *all = step_record(&values, "ALL");
    ck_assert_ptr_nonnull(all);
    ck_assert(step_is(all, "ALL") && !step_is(all, "AL") && !step_is(all, "ALLE"));
    ck_assert_ptr_null(step_record(&values, "LENGTH"));
    static const enum step_kind kind[] = {STEP_NUMBER, STEP_NUMBER, STEP_REFERENCE,
                                          STEP_TEXT,   STEP_ENUM,   STEP_UNSET,
                                          STEP_UNSET,  STEP_LIST,   STEP_RECORD};
    const struct step_value *at = step_item(all, 0);
    for (size_t i = 0; i < 9; i++, at = step_next(all, at)) {
        ck_assert_ptr_eq(step_item(all, i), at);
        ck_assert_int_eq(at->kind, kind[i]);
    }
    ck_assert_ptr_null(at);
    ck_assert_ptr_null(step_item(all, 9));
    ck_assert_double_eq(step_item(all, 0)->number, -0.015);
    ck_assert_double_eq(step_item(all, 1)->number, 7);
    ck_assert_double_eq(step_item(all, 2)->number, 42);
    ck_assert(step_is(step_item(all, 4), "TRUE"));
    const struct step_value *list = step_item(all, 7), *inner = step_item(list, 1);
    ck_assert_uint_eq(list->size, 1 + 1 + 3 + 1);
    ck_assert_uint_eq(inner->size, 3);
    ck_assert_double_eq(step_item(inner, 1)->number, 3);
    ck_assert_ptr_null(step_item(inner, 2));
    ck_assert_uint_eq(step_item(list, 2)->size, 1);
    ck_assert_ptr_null(step_next(list, step_item(list, 2)));
    ck_assert_double_eq(step_item(step_item(all, 8), 0)->number, 4);
    ck_assert_ptr_eq(step_own(&values, all, 1), step_item(all, 1));
}
END_TEST

/* Of several records in one the name is in a record of its own. */
START_TEST(complex_instances)
{
    ck_assert_int_eq(
        read_text("#1=(CURVE()SPLINE(3,.F.)REPRESENTATION_ITEM('name')KNOTS((2,2)));\n"), 0);
    values_of(1);
    ck_assert_uint_eq(values.item[0].size, values.n);
    const struct step_value *spline = step_record(&values, "SPLINE");
    ck_assert_ptr_nonnull(spline);
    ck_assert_ptr_nonnull(step_record(&values, "KNOTS"));
    ck_assert_ptr_nonnull(step_record(&values, "CURVE"));
    ck_assert_double_eq(step_own(&values, spline, 1)->number, 3); /* after the name */
    ck_assert_int_eq(step_own(&values, spline, 2)->kind, STEP_ENUM);
}
END_TEST

/* Each digit, sign and mark of an exponent; each blank, and a comment, between what stands there;
 * in texts and in comments a ; ends nothing, and a / alone is no comment. */
START_TEST(characters)
{
    static const char *const blank[] = {" ", "\t", "\r", "\n", "\f", "\v", "/* ;' */"};
    ck_assert_int_eq(read_text("#1=A(-9876543210.,+.5,1.25e+2,-4.E-1,0.0625);\n"), 0);
    values_of(1);
    static const double want[] = {-9876543210., 0.5, 125, -0.4, 0.0625};
    for (size_t i = 0; i < 5; i++)
        ck_assert_double_eq(step_item(step_record(&values, "A"), i)->number, want[i]);
    for (size_t i = 0; i < sizeof blank / sizeof *blank; i++) {
        char text[200];
        const char *b = blank[i];
        teardown();
        values = (struct step_values){0};
        snprintf(text, sizeof text,
                 "#1%s=%sA%s(%s3.%s,%s#2%s)%s;%s#2=B(\"a;/b\"/ 'c;''d');#3=C();\n", b, b, b, b, b,
                 b, b, b, b);
        ck_assert_msg(read_text(text) == 0, "%s", error.text);
        ck_assert_uint_eq(step.instance.n, 3);
        values_of(1);
        ck_assert_double_eq(step_item(step_record(&values, "A"), 0)->number, 3);
        ck_assert_double_eq(step_item(step_record(&values, "A"), 1)->number, 2);
    }
}
END_TEST

START_TEST(refused)
{
    static const char *const bad[] = {"#1=A((1.);\n", "#1=A(1.,);\n", "#1=A('open);\n",
                                      "#1=A(1.;\n", "#1=;\n"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        int status = read_text(bad[i]);
        if (status == 0) {
            const struct step_instance *instance = step_find(&step, 1);
            status = instance ? step_values(&step, instance, &values, &error) : -1;
        }
        ck_assert_msg(status == -1, "%s", bad[i]);
        teardown();
        values = (struct step_values){0};
        step = (struct step){0};
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("step");
    TCase *tests = tcase_create("step");
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, instances);
    tcase_add_test(tests, kinds);
    tcase_add_test(tests, complex_instances);
    tcase_add_test(tests, characters);
    tcase_add_test(tests, refused);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
