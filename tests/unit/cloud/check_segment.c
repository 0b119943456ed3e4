/* segment: a half-ball in parts that face their directions and hold all points; a cloud that one
 * projection serves stays whole. */
#include <check.h>
#include <stdlib.h>

#include "rough.h"
#include "cloud/segment.h"

static const struct segments_options plain = {.outside = {0, 0, 1}, .threads = 1};

START_TEST(half_ball)
{
    struct vec3s p = {0};
    for (int i = 0; i < 8000; i++) {
        double z = uniform(), a = 2 * PI * uniform(), r = sqrt(1 - z * z);
        *array_push(&p) = vec(4 * r * cos(a), 4 * r * sin(a), 4 * z);
    }
    const struct segments_options how = {0.3, 30, {0, 0, 1}, 2};
    struct segments parts = segments_find(p.item, p.n, &how);
    size_t own = 0;
    ck_assert_uint_ge(parts.n, 5);
    ck_assert_uint_le(parts.n, 9);
    ck_assert_uint_eq(parts.left_out, 0);
    ck_assert_double_eq_tol(parts.spacing, 4 * sqrt(2 * PI / 8000), 0.015);
    ck_assert_double_eq_tol(parts.item[0].along.y, 0.5, 1e-12);
    for (size_t k = 0; k < parts.n; k++) {
        const struct segment *part = &parts.item[k];
        struct vec3 q = vec(1, 2, 3);
        own += part->own;
        ck_assert_double_le(vec_distance(vec_cross(part->along, part->across), part->up), 1e-12);
        ck_assert_double_le(vec_distance(segment_out(part, segment_in(part, q)), q), 1e-12);
        ck_assert(k == 0 || fabs(part->along.z) < 1e-12);
        for (size_t i = 0; i < part->point.n; i++)
            ck_assert_double_le(vec_angle(part->point.item[i], part->up),
                                RADIANS(i < part->own ? 60 : 75));
    }
    ck_assert_uint_eq(own, p.n);
    segments_free(&parts);
    array_free(&p);
}
END_TEST

START_TEST(one_part)
{
    struct vec3s p = {0};
    for (int i = 0; i < 4000; i++) {
        double x = 30 * uniform(), y = 20 * uniform();
        *array_push(&p) = vec(x, y, 2 * sin(x / 4) + 0.02 * normal());
    }
    struct segments parts = segments_find(p.item, p.n, &plain);
    ck_assert_uint_eq(parts.n, 1);
    ck_assert_uint_eq(parts.item[0].own, p.n);
    for (size_t i = 0; i < p.n; i++)
        ck_assert(vec_distance(parts.item[0].point.item[i], p.item[i]) == 0);
    segments_free(&parts);
    parts = segments_find(p.item, 10, &plain);
    ck_assert_uint_eq(parts.n, 0);
    ck_assert_uint_eq(parts.left_out, 10);
    segments_free(&parts);
    array_free(&p);
}
END_TEST

/* Two walls that face each other the same way are two parts. */
START_TEST(what_hangs_together)
{
    struct vec3s p = {0};
    rectangle(&p, 2000, vec(0, 0, 0), vec(0, 20, 0), vec(0, 0, 10), 0);
    rectangle(&p, 2000, vec(-30, 0, 0), vec(0, 20, 0), vec(0, 0, 10), 0);
    struct segments parts = segments_find(p.item, p.n, &plain);
    ck_assert_uint_eq(parts.n, 2);
    ck_assert_uint_eq(parts.item[0].own, 2000);
    ck_assert_double_gt(fabs(parts.item[0].up.x), 0.99);
    segments_free(&parts);
    array_free(&p);
}
END_TEST

/* A wall has two sides: its outside is the one that is seen from where somebody said. */
START_TEST(the_side_that_is_said)
{
    struct vec3s p = {0};
    rectangle(&p, 2000, vec(0, 0, 0), vec(0, 20, 0), vec(0, 0, 10), 0);
    for (int side = -1; side <= 1; side += 2) {
        struct segments_options how = plain;
        how.outside = vec_unit(vec(side, 0.3, 0.4));
        struct segments parts = segments_find(p.item, p.n, &how);
        ck_assert_uint_eq(parts.n, 1);
        ck_assert_double_gt(side * parts.item[0].up.x, 0.99);
        segments_free(&parts);
    }
    array_free(&p);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("segment");
    TCase *tests = tcase_create("segment");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, half_ball);
    tcase_add_test(tests, one_part);
    tcase_add_test(tests, what_hangs_together);
    tcase_add_test(tests, the_side_that_is_said);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
