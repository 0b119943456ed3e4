/* made_moves: a ball that goes up between plates of points, through one of them or beside it. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scratch.h"
#include "stage/made_moves.h"

static const double RADIUS = 3;

/* A plate at z = 0, half a millimetre from point to point, and another over x > 0 at z = 25. */
static struct path path_over(bool roofed)
{
    static char text[400000];
    struct vec3s point = {0};
    struct path path = {.name = "path"};
    size_t n = 0;

    for (int i = -20; i <= 20; i++)
        for (int k = -20; k <= 20; k++) {
            *array_push(&point) = vec(i / 2.0, k / 2.0, 0);
            if (roofed && i > 0)
                *array_push(&point) = vec(i / 2.0, k / 2.0, 25);
        }
    for (size_t i = 0; i < point.n; i++)
        n += (size_t)sprintf(text + n, "%g %g %g\n", point.item[i].x, point.item[i].y,
                             point.item[i].z);
    scan_sources_add(&path.head.scan, scratch_text(text), point.item, point.n);
    path.head.cutter[0] = 2 * RADIUS;
    path.head.cutter[1] = RADIUS;
    path.head.cutter_n = 2;
    path.head.body_given = true;
    path.head.body.flute = 12;
    array_free(&point);
    return path;
}

/* The text of what is found of a move up from x: "": nothing. */
static const char *found(bool roofed, double x, double deep)
{
    static char text[300];
    struct path path = path_over(roofed);
    struct made_moves moves = {0};
    struct unmets unmet = {0};
    struct error error = {.text = ""};

    *array_push(&moves) = (struct made_move){{{x, 0, 0.1}, {0, 0, 1}}, {{x, 0, 40}, {0, 0, 1}}, 17};
    ck_assert_int_eq(
        made_moves_check(&moves, &path, made_moves_tool(&path), deep, 2, &unmet, &error), 0);
    snprintf(text, sizeof text, "%s", unmet.n > 0 ? unmet.item[0].text : "");
    unmets_free(&unmet);
    array_free(&moves);
    path_free(&path);
    return text;
}

START_TEST(up_through_a_plate)
{
    ck_assert_str_eq(found(false, 5, 0.01), "");
    ck_assert_str_eq(found(true, -3, 0.01), ""); /* past it, 0.5 mm */
    ck_assert_ptr_nonnull(
        strstr(found(true, -2, 0.01), "0.500 mm deep into the scan after line 17"));
    ck_assert_str_eq(found(true, -2, 0.6), "");
    ck_assert_ptr_nonnull(strstr(found(true, 5, 0.01), "3.000 mm deep"));
}
END_TEST

/* What can't be asked is no fault: no move, no scan, a scan that is gone. */
START_TEST(nothing_to_ask)
{
    struct path path = path_over(true);
    struct made_moves moves = {0};
    struct unmets unmet = {0};
    struct error error = {.text = ""};
    struct gouge_refit_options tool = made_moves_tool(&path);

    ck_assert_double_eq(tool.radius, RADIUS);
    ck_assert_int_eq(made_moves_check(&moves, &path, tool, 0.01, 1, &unmet, &error), 0);
    *array_push(&moves) = (struct made_move){{{5, 0, 0.1}, {0, 0, 1}}, {{5, 0, 40}, {0, 0, 1}}, 17};
    remove(path.head.scan.item[0].name);
    ck_assert_int_eq(made_moves_check(&moves, &path, tool, 0.01, 1, &unmet, &error), 0);
    scan_sources_free(&path.head.scan);
    path.head.scan = (struct scan_sources){0};
    ck_assert_int_eq(made_moves_check(&moves, &path, tool, 0.01, 1, &unmet, &error), 0);
    ck_assert_uint_eq(unmet.n, 0);
    array_free(&moves);
    path_free(&path);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("made_moves");
    TCase *tests = tcase_create("made_moves");
    tcase_add_test(tests, up_through_a_plate);
    tcase_add_test(tests, nothing_to_ask);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
