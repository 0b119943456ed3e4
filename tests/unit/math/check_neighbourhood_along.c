/* neighbourhood_along: which points are taken, against an exhaustive count. */
#include <check.h>
#include <stdlib.h>

#include "math/neighbourhood_along.h"
#include "rough.h"

enum { POINTS = 400, TAKEN = 40 };

/* As lengths count: along `way` a third of them. */
static double counted(struct vec3 p, struct vec3 at, struct vec3 way)
{
    struct vec3 off = vec_sub(p, at);
    double along = vec_dot(off, way);
    return hypot(vec_length(vec_along(off, -along, way)), along / 3);
}

START_TEST(taken)
{
    struct vec3 p[POINTS], found[TAKEN], at = vec(5, 5, 1), way = vec_unit(vec(2, -1, 0.5));
    double farthest = 0, last = 0;
    size_t nearer = 0;
    for (int i = 0; i < POINTS; i++)
        p[i] = vec(10 * uniform(), 10 * uniform(), 2 * uniform());
    ck_assert_uint_eq(neighbourhood_along_take(p, POINTS, at, way, 3, TAKEN, found), TAKEN);
    for (int i = 0; i < TAKEN; i++) {
        farthest = fmax(farthest, counted(found[i], at, way));
        last = fmax(last, vec_distance(found[i], at));
    }
    for (int i = 0; i < POINTS; i++)
        nearer += counted(p[i], at, way) <= farthest * (1 + 1e-12);
    ck_assert_uint_eq(nearer, TAKEN);
    ck_assert(vec_distance(found[TAKEN - 1], at) == last);
    ck_assert_uint_eq(neighbourhood_along_take(p, 7, at, way, 3, TAKEN, found), 7);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("longhood");
    TCase *tests = tcase_create("longhood");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, taken);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
