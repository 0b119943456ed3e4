/* sheet: the scale bar is the longest of 1, 2 and 5 times a power of ten that its room holds, and
 * as long in the picture as it says; the legend names what there is in the scene and no more. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/out.h"
#include "math/elementary.h"
#include "plot/plot.h"
#include "scratch.h"

static char *text;

static void teardown(void)
{
    free(text);
    text = NULL;
}

static void draw(struct layer layer, const struct sheet_options *options)
{
    struct scene scene = {0};
    size_t n;
    *array_push(&scene) = layer;
    struct out *out = out_open(scratch_text(""));
    sheet_write(out, &scene, options);
    out_close(out);
    scene_free(&scene);
    free(text);
    text = scratch_read(&n);
}

static bool says(const char *words)
{
    return strstr(text, words) != NULL;
}

static void add_stroke(struct layer *layer, enum stroke_kind kind, double x)
{
    size_t from = layer->node.n;
    *array_push(&layer->node) = vec(0, 0, 0);
    *array_push(&layer->node) = vec(x, x, 1);
    *array_push(&layer->stroke) = (struct stroke){.kind = kind, .from = from, .to = from + 2};
    layer->motions[kind]++;
}

/* Clouds 0.03 to 30,000 mm wide, seen from above: the picture is as wide as they are but for its
 * margins, and the bar has 180 px or less. */
START_TEST(scale_bar)
{
    const struct sheet_options options = {.title = "t", .views = SHEET_PLAN, .width = 600};
    for (double size = 0.03; size < 4e4; size *= 1.7) {
        struct layer layer = {.name = "a.xyz"};
        for (int i = 0; i < 9; i++)
            *array_push(&layer.point) = vec(size * (i % 3) / 2, size * (i / 3) / 4, 0);
        draw(layer, &options);
        /* the one text that is a number and mm: <text ...>20 mm</text> */
        double bar = 0;
        for (char *p = text; (p = strstr(p, " mm<")) != NULL; p++) {
            char *begin = p, *end;
            while (begin > text && begin[-1] != '>')
                begin--;
            double number = strtod(begin, &end);
            bar = end == p ? number : bar;
        }
        ck_assert_double_gt(bar, 0);
        double power = pow(10, floor(log10(bar) + 1e-9));
        double first = bar / power;
        ck_assert_msg(fabs(first - 1) < 1e-6 || fabs(first - 2) < 1e-6 || fabs(first - 5) < 1e-6,
                      "%g mm", bar);
        /* 180 px of at most 600 hold it, and 2.5 times as much would be the next longer one */
        ck_assert_double_le(bar, size * 180 / 400);
        ck_assert_double_gt(2.5 * bar, size * 180 / 600);
    }
}
END_TEST

START_TEST(legend)
{
    static const char *const name[] = {
        "rapid",          ">lines<",   "arcs, by turns", "B-splines, by turns",
        "control points", ">normals<", "tool axes",      "ends of motions"};
    const struct sheet_options options = {
        .title = "t", .views = SHEET_BOTH, .width = 800, .joints = true};
    for (int what = 0; what < 8; what++) {
        struct layer layer = {.name = "a.cl"};
        *array_push(&layer.point) = vec(0, 0, 0);
        *array_push(&layer.point) = vec(9, 9, 1);
        if (what < 5)
            add_stroke(&layer,
                       (const enum stroke_kind[]){STROKE_RAPID, STROKE_LINE, STROKE_ARC,
                                                  STROKE_SPLINE, STROKE_POLES}[what],
                       9);
        if (what == 5)
            *array_push(&layer.normal) = (struct tick){vec(1, 2, 1), vec(0, 0, 1)};
        if (what == 6)
            *array_push(&layer.axis) = (struct tick){vec(1, 2, 1), vec(0, 0, 1)};
        if (what == 7)
            *array_push(&layer.joint) = vec(1, 2, 1);
        draw(layer, &options);
        for (int k = 0; k < 8; k++)
            ck_assert_msg(says(name[k]) == (k == what), "%s with %s", name[k], name[what]);
    }
}
END_TEST

/* Two views side by side begin at the margin of 24 px; one is in the middle. */
START_TEST(side_by_side)
{
    for (int views = SHEET_BOTH; views <= SHEET_PLAN; views++) {
        const struct sheet_options options = {
            .title = "t", .views = (enum sheet_views)views, .width = 800};
        struct layer layer = {.name = "a.xyz"};
        for (int i = 0; i < 9; i++)
            *array_push(&layer.point) = vec(20 * (i % 3), 60 * (i / 3), 0);
        draw(layer, &options);
        const char *first = strstr(text, "scale(.1)"), *width = strstr(text, " width=\"");
        ck_assert(first && width);
        first = strstr(first, " d=\"M");
        ck_assert(first);
        double x = strtod(first + 5, NULL) / 10, all = strtod(width + 8, NULL);
        if (views == SHEET_BOTH)
            ck_assert_double_eq_tol(x, 24, 0.051);
        else
            ck_assert_double_gt(x, 24 + 0.1 * all);
    }
}
END_TEST

START_TEST(names)
{
    ck_assert_str_eq(sheet_name("-"), "standard input");
    ck_assert_str_eq(sheet_name("a/b.cl"), "b.cl");
    ck_assert_str_eq(sheet_name("b.cl"), "b.cl");
    ck_assert_str_eq(sheet_name("a/"), "a/");
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("sheet");
    TCase *tests = tcase_create("sheet");
    SRunner *runner = srunner_create(suite);
    tcase_set_timeout(tests, 60);
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, scale_bar);
    tcase_add_test(tests, legend);
    tcase_add_test(tests, side_by_side);
    tcase_add_test(tests, names);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
