/*
 * trim_order: which sides of a square run backwards, in space and in the parameters; parts of a
 * loop that fit it either way, as the rims of a pipe joined by its seam.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "known.h"
#include "nurbs/trim_order.h"

static struct nurbs_curve line(struct vec3 a, struct vec3 b)
{
    struct nurbs_curve c = patch_curve(1, 2);
    c.pole[0] = (struct nurbs_pole){a.x, a.y, a.z, 1};
    c.pole[1] = (struct nurbs_pole){b.x, b.y, b.z, 1};
    return c;
}

static const struct vec3 corner[] = {{0, 0, 0}, {8, 0, 0}, {8, 1, 0}, {0, 1, 0}};

/* The sides of a rectangle, those of the bits of `turned` the other way; in the parameters of a
 * surface whose v is ten times as wide, so that its short sides are the longer ones there. */
static struct patch_loop sides(unsigned turned, bool space)
{
    struct patch_loop loop = {.space = space};
    for (int i = 0; i < 4; i++) {
        struct vec3 a = corner[i], b = corner[(i + 1) % 4];
        *array_push(&loop) = turned >> i & 1 ? line(b, a) : line(a, b);
    }
    return loop;
}

START_TEST(backwards)
{
    struct patch patch = known_flat(vec(0, 0, 0), vec(10, 0, 0), vec(0, 10, 0), vec(10, 10, 0));
    for (unsigned turned = 0; turned < 16; turned++)
        for (int space = 0; space < 2; space++) {
            struct patch_loop loop = sides(turned, space);
            struct vec3 at = corner[0];
            for (size_t k = 0; k < 4; k++) {
                bool back = trim_order_backwards(&patch, &loop, k, at);
                ck_assert(back == (turned >> k & 1));
                at = trim_order_end(&loop.item[k], !back);
                ck_assert_double_lt(vec_distance(at, corner[(k + 1) % 4]), 1e-12);
            }
            loop.directed = true;
            for (size_t k = 0; k < 4; k++)
                ck_assert(!trim_order_backwards(&patch, &loop, k, corner[0]));
            patch_loop_free(&loop);
        }
    patch_free(&patch);
}
END_TEST

START_TEST(distances)
{
    struct patch patch = known_flat(vec(0, 0, 0), vec(10, 0, 0), vec(0, 10, 0), vec(10, 10, 0));
    ck_assert_double_eq_tol(
        trim_order_square((struct uv){0.1, 0.5}, (struct uv){0.4, 0.9}, &patch.surface), 0.25,
        1e-12);
    patch_free(&patch);
    patch = known_sphere(3); /* 4 by 2 */
    ck_assert_double_eq_tol(
        trim_order_square((struct uv){0, 0}, (struct uv){2, 0.5}, &patch.surface), 0.3125, 1e-12);
    patch_free(&patch);
}
END_TEST

/* Two triangles, at z = 0 and z = 5, joined by a seam that is there twice: a part of three curves,
 * the seam, another part, the seam back. */
static struct patch_loop pipe(void)
{
    static const struct vec3 p[] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    struct patch_loop loop = {.space = true, .rough = 0.25};
    for (int z = 0; z < 2; z++) {
        for (int i = 0; i < 3; i++) {
            struct vec3 a = p[i], b = p[(i + 1) % 3];
            a.z = b.z = 5 * z;
            *array_push(&loop) = line(a, b);
        }
        *array_push(&loop) = line(vec(0, 0, 5 * z), vec(0, 0, 5 - 5 * z));
    }
    return loop;
}

static struct vec3 begin(const struct patch_loop *loop, size_t k)
{
    return trim_order_end(&loop->item[k], false);
}

START_TEST(parts_turned)
{
    struct patch patch = known_flat(vec(0, 0, 0), vec(10, 0, 0), vec(0, 10, 0), vec(10, 10, 0));
    struct patch_loop loop = pipe(), turned;
    /* the first rim, what lies between the seams with them or without, and so on: each ends where
     * it begins */
    size_t parts = 0, first_rims = 0, second_rims = 0;
    for (; trim_order_turned(&patch, &loop, parts, &turned); parts++) {
        ck_assert_uint_eq(turned.n, loop.n);
        ck_assert(turned.space && !turned.directed);
        ck_assert_double_eq(turned.rough, 0.25);
        struct vec3 at = begin(&turned, 0);
        for (size_t k = 0; k < turned.n; k++) { /* it still hangs together, and runs forwards */
            ck_assert_double_lt(vec_distance(at, begin(&turned, k)), 1e-12);
            at = trim_order_end(&turned.item[k], true);
        }
        ck_assert_double_lt(vec_distance(at, begin(&turned, 0)), 1e-12);
        bool first = begin(&turned, 1).y > 3, second = begin(&turned, 5).y > 3;
        first_rims += first && !second;
        second_rims += second && !first;
        patch_loop_free(&turned);
    }
    ck_assert_uint_ge(parts, 2);
    ck_assert_uint_ge(first_rims, 1);
    ck_assert_uint_ge(second_rims, 1);
    loop.directed = true;
    ck_assert(!trim_order_turned(&patch, &loop, 0, &turned));
    loop.directed = loop.space = false;
    ck_assert(!trim_order_turned(&patch, &loop, 0, &turned));
    patch_loop_free(&loop);
    loop = sides(0, true); /* no part but the whole ends where it begins */
    ck_assert(!trim_order_turned(&patch, &loop, 0, &turned));
    patch_loop_free(&loop);
    patch_free(&patch);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("trim_order");
    TCase *tests = tcase_create("trim_order");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, backwards);
    tcase_add_test(tests, distances);
    tcase_add_test(tests, parts_turned);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
