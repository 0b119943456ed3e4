/* feature_accept: of two features the one that brings the mesh closer to the points stays. */
#include <check.h>
#include <stdlib.h>

#include "feature/feature_steps.h"
#include "rough.h"

/* A strip of squares along x, its middle row of vertices at this height up to x = 20, at `other`
 * beyond. */
static struct mesh strip(double height, double other)
{
    struct mesh m = {0};
    for (int i = 0; i <= 40; i++)
        for (int j = -1; j <= 1; j++)
            *array_push(&m.vertex) = vec(i, j, j != 0 ? 0 : i <= 20 ? height : other);
    for (int i = 0; i < 40; i++) {
        for (int j = 0; j < 2; j++) {
            int a = 3 * i + j;
            *array_push(&m.face) = (struct face){{a, a + 3, a + 1}};
            *array_push(&m.face) = (struct face){{a + 1, a + 3, a + 4}};
        }
    }
    return m;
}

START_TEST(the_better_one_stays)
{
    for (int noisy = 0; noisy < 2; noisy++) {
        double noise = 0.02 * noisy;
        struct vec3s p = {0};
        /* a roof up to x = 20, flat beyond */
        rectangle(&p, 800, vec(0, 0, 0.5), vec(20, 0, 0), vec(0, 1, -0.5), noise);
        rectangle(&p, 800, vec(0, 0, 0.5), vec(20, 0, 0), vec(0, -1, -0.5), noise);
        rectangle(&p, 1600, vec(20, -1, 0), vec(20, 0, 0), vec(0, 2, 0), noise);
        struct mesh without = strip(0.2, 0), with = strip(0.5, 0.3);
        struct feature f[3] = {
            {.kind = FEATURE_CREASE, .place = {{8, 0, 0.5}, {8, 0, 0.5}}},
            {.kind = FEATURE_NONE},
            {.kind = FEATURE_CREASE, .place = {{32, 0, 0.3}, {32, 0, 0.3}}},
        };
        feature_accept(&without, &with, p.item, p.n, 1, noise, 2, f, 3);
        ck_assert_int_eq(f[0].kind, FEATURE_CREASE);
        ck_assert_int_eq(f[1].kind, FEATURE_NONE);
        ck_assert_int_eq(f[2].kind, FEATURE_NONE);
        mesh_free(&without);
        mesh_free(&with);
        array_free(&p);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("feature_accept");
    TCase *tests = tcase_create("feature_accept");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, the_better_one_stays);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
