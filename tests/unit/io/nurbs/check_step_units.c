/* step_units: millimetres and radians of the units that ISO 10303-41 has, of their prefixes, and of
 * units by conversion, as inch (25.4 mm) and degree; a unit that there is not is refused. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "io/nurbs/step_units.h"
#include "scratch.h"

static double mm, angle;
static struct error error;

/* The units in a context, as its list says, by what `data` has. */
static int units(const char *list, const char *data, double given)
{
    char text[2000];
    struct step step = {0};
    struct step_values from = {0};
    struct reader r;

    snprintf(text, sizeof text,
             "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=SHAPE('',#2);\n"
             "#2=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((%s))"
             "REPRESENTATION_CONTEXT('',''));\n%sENDSEC;\nEND-ISO-10303-21;\n",
             list, data);
    ck_assert_int_eq(reader_open(&r, scratch_text(text), &error), 0);
    ck_assert_msg(step_read(&r, &step, &error) == 0, "%s", error.text);
    reader_close(&r);
    ck_assert_int_eq(step_values(&step, step_find(&step, 1), &from, &error), 0);
    int status = step_units(&step, given, &from, step_item(step_record(&from, "SHAPE"), 1), &mm,
                            &angle, &error);
    array_free(&from);
    step_free(&step);
    return status;
}

START_TEST(lengths_by_prefix)
{
    static const struct {
        const char *prefix;
        double mm;
    } of[] = {{"$", 1000},    {".KILO.", 1e6},   {".DECI.", 100},  {".CENTI.", 10},
              {".MILLI.", 1}, {".MICRO.", 1e-3}, {".NANO.", 1e-6}, {".HECTO.", 1e5}};

    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        char data[200];
        snprintf(data, sizeof data, "#3=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(%s,.METRE.));\n",
                 of[i].prefix);
        ck_assert_int_eq(units("#3", data, 0), 0);
        ck_assert_double_eq_tol(mm / of[i].mm, 1, 1e-12);
        ck_assert_double_eq(angle, 1);
    }
}
END_TEST

START_TEST(units_by_conversion)
{
    const char *data =
        "#3=(CONVERSION_BASED_UNIT('INCH',#4)LENGTH_UNIT()NAMED_UNIT(#9));\n"
        "#4=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(2.54),#5);\n"
        "#5=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.CENTI.,.METRE.));\n"
        "#6=(CONVERSION_BASED_UNIT('DEGREE',#7)NAMED_UNIT(#9)PLANE_ANGLE_UNIT());\n"
        "#7=PLANE_ANGLE_MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(0.017453292519943295),#8);\n"
        "#8=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n"
        "#9=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n";

    ck_assert_msg(units("#3,#6", data, 0) == 0, "%s", error.text);
    ck_assert_double_eq_tol(mm, 25.4, 1e-12);
    ck_assert_double_eq_tol(angle, 0.017453292519943295, 1e-15);
    ck_assert_int_eq(units("#6", data, 0), 0);
    ck_assert_double_eq(mm, 1); /* none is stated */
    ck_assert_int_eq(units("#3", data, 10), 0);
    ck_assert_double_eq(mm, 10); /* lengths are in what is given */
    ck_assert_double_eq(angle, 1);
}
END_TEST

START_TEST(units_that_there_are_not)
{
    static const char *const si[] = {".KILLO.,.METRE.", ".MILLI.,.METER.", "$,.RADIAN.", "$,$"};

    for (size_t i = 0; i < sizeof si / sizeof *si; i++) {
        char data[200];
        snprintf(data, sizeof data, "#3=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(%s));\n", si[i]);
        ck_assert_int_eq(units("#3", data, 0), -1);
        ck_assert_ptr_nonnull(strstr(error.text, ":7: #3"));
    }
    ck_assert_int_eq(units("#3", "", 0), -1); /* nor its instance */
}
END_TEST

/* A unit that is some of itself ends. */
START_TEST(a_unit_of_itself)
{
    ck_assert_int_eq(units("#3",
                           "#3=(CONVERSION_BASED_UNIT('X',#4)LENGTH_UNIT()NAMED_UNIT(*));\n"
                           "#4=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(2.),#3);\n",
                           0),
                     0);
    ck_assert_double_gt(mm, 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("step_units");
    TCase *tests = tcase_create("step_units");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, lengths_by_prefix);
    tcase_add_test(tests, units_by_conversion);
    tcase_add_test(tests, units_that_there_are_not);
    tcase_add_test(tests, a_unit_of_itself);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
