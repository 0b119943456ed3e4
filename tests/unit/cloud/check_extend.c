/* extend: a sphere's cap continued along the sphere, holes left alone, and the width asked for. */
#include <check.h>
#include <stdlib.h>

#include "cloud/extend.h"
#include "rough.h"

/* A square cap of a sphere of 60 mm, 40 mm wide, with a hole of this radius in its middle; spacing
 * about 0.5. */
static struct vec3s cap(double hole, double noise)
{
    struct vec3s p = {0};
    while (p.n < 6400) {
        double x = 40 * uniform() - 20, y = 40 * uniform() - 20;
        struct vec3 n = vec_unit(vec(x, y, sqrt(3600 - x * x - y * y)));
        if (hypot(x, y) >= hole)
            *array_push(&p) = vec_scale(60 + noise * normal(), n);
    }
    return p;
}

START_TEST(continues_a_sphere)
{
    for (int noisy = 0; noisy < 2; noisy++) {
        struct vec3s p = cap(0, 0.02 * noisy);
        struct error error;
        size_t n = p.n, over = 0;
        double reach = 0;
        ck_assert_int_eq(extend_cloud(&p, 0.5, 3, 2, 0.02 * noisy, 2, &error), 0);
        for (size_t i = n; i < p.n; i++) {
            double out = fmax(fabs(p.item[i].x), fabs(p.item[i].y)) - 20;
            ck_assert_double_le(fabs(vec_length(p.item[i]) - 60), noisy ? 0.1 : 0.03);
            reach = fmax(reach, out);
            over += out > 0;
        }
        ck_assert_double_ge(reach, 1.4);
        ck_assert_double_le(reach, 2);
        /* a strip of 2 mm around 160 mm, four to the square millimetre */
        ck_assert_uint_ge(over, 1000);
        ck_assert_uint_le(over, 1500);
        /* where the cap's edge is ragged: about 30, and six deviations of such a count more */
        ck_assert_double_le((double)(p.n - n - over), 30 + 6 * sqrt(30));
        array_free(&p);
    }
}
END_TEST

START_TEST(holes_stay)
{
    struct vec3s p = cap(5, 0);
    struct error error;
    size_t n = p.n;
    ck_assert_int_eq(extend_cloud(&p, 0.5, 3, 2, 0, 1, &error), 0);
    for (size_t i = n; i < p.n; i++)
        ck_assert_double_gt(hypot(p.item[i].x, p.item[i].y), 5.5);
    ck_assert_uint_gt(p.n, n + 900);
    array_free(&p);
}
END_TEST

/* On a flank of 75 degrees 3 mm seen from above are 11.6 along it: it ends after 6. */
START_TEST(a_flank_goes_on_as_far_in_space)
{
    const double steep = 3.732;
    struct vec3s p = {0};
    struct error error;
    double low = 0;
    for (int i = 0; i <= 40; i++)
        for (int k = 0; k <= 40; k++)
            *array_push(&p) = vec(0.5 * i, 0.5 * k, -0.5 * steep * i);
    size_t n = p.n;
    ck_assert_int_eq(extend_cloud(&p, 0.5, 3, 3, 0, 2, &error), 0);
    for (size_t i = n; i < p.n; i++)
        low = fmin(low, p.item[i].z);
    ck_assert_double_ge(low, -20 * steep - 6);
    ck_assert_double_le(low, -20 * steep - 3);
    array_free(&p);
}
END_TEST

START_TEST(too_wide)
{
    struct vec3s p = cap(0, 0);
    struct error error;
    size_t n = p.n;
    ck_assert_int_eq(extend_cloud(&p, 0.001, 0.01, 10, 0, 1, &error), -1);
    ck_assert_uint_eq(p.n, n);
    array_free(&p);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("extend");
    TCase *tests = tcase_create("extend");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, continues_a_sphere);
    tcase_add_test(tests, holes_stay);
    tcase_add_test(tests, a_flank_goes_on_as_far_in_space);
    tcase_add_test(tests, too_wide);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
