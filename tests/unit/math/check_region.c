/* check_region - what is in a box and in polygons, with a border and without. */
#include <check.h>
#include <stdlib.h>

#include "math/elementary.h"
#include "math/region.h"

/* A square of 10 with a square of 4 cut out of its middle. */
static struct region frame(void)
{
    static const double corner[8][2] = {{0, 0}, {10, 0}, {10, 10}, {0, 10},
                                        {3, 3}, {7, 3},  {7, 7},   {3, 7}};
    struct region r = {.border = 0};
    for (int i = 0; i < 8; i++) {
        if (i % 4 == 0)
            *array_push(&r.polygons.from) = i;
        *array_push(&r.polygons.corner) = vec(corner[i][0], corner[i][1], 0);
    }
    return r;
}

START_TEST(a_box)
{
    struct region none = {.border = 1};
    struct region box = {.boxed = true, .box = {{0, 0, 0}, {4, 4, 4}}, .border = 0};
    ck_assert(!region_given(&none) && region_given(&box));
    ck_assert(region_holds(&none, vec(1e9, -1e9, 3)));
    ck_assert(region_holds(&box, vec(4, 0, 2)) && !region_holds(&box, vec(2, 2, 4.001)));
    box.border = 1; /* across z alone */
    ck_assert(region_holds(&box, vec(1.001, 2, 4)) && !region_holds(&box, vec(0.999, 2, 2)));
}
END_TEST

START_TEST(polygons)
{
    struct region r = frame();
    ck_assert_uint_eq(region_polygons_end(&r.polygons, 0), 4);
    ck_assert_uint_eq(region_polygons_end(&r.polygons, 1), 8);
    for (int i = -4; i < 49; i++)
        for (int k = -4; k < 49; k++) { /* never on a side */
            double x = i / 4.0 + 0.125, y = k / 4.0 + 0.125;
            bool in = x > 0 && x < 10 && y > 0 && y < 10;
            bool hole = x > 3 && x < 7 && y > 3 && y < 7;
            ck_assert(region_holds(&r, vec(x, y, -50)) == (in && !hole));
        }
    r.border = 1;
    ck_assert(region_holds(&r, vec(1.5, 5, 0)) && !region_holds(&r, vec(0.9, 5, 0)));
    ck_assert(!region_holds(&r, vec(2.1, 5, 0)));
    r.boxed = true; /* both */
    r.box = (struct box){{0, 0, 0}, {5, 10, 1}};
    ck_assert(region_holds(&r, vec(1.5, 5, 0.5)) && !region_holds(&r, vec(8.5, 5, 0.5)));
    region_polygons_free(&r.polygons);
}
END_TEST

START_TEST(a_copy_is_its_own)
{
    struct region r = frame();
    struct region copy = r;
    copy.polygons = region_polygons_copy(&r.polygons);
    region_polygons_free(&r.polygons);
    ck_assert(!region_given(&r));
    ck_assert(region_holds(&copy, vec(1, 1, 0)) && !region_holds(&copy, vec(5, 5, 0)));
    region_polygons_free(&copy.polygons);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("region");
    TCase *tests = tcase_create("region");
    tcase_add_test(tests, a_box);
    tcase_add_test(tests, polygons);
    tcase_add_test(tests, a_copy_is_its_own);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
