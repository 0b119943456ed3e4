/*
 * coincident: flat patches of known corners, twice in one place or nearly, of other parameters,
 * trimmed to one area or to two, in a box and between two boxes.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "nurbs/coincident.h"

static struct patches patches;
static struct sheet sheet[20];
static int *twin;

/* A flat patch from `at` along two sides, of this degree. */
static struct patch *add(struct vec3 at, struct vec3 u, struct vec3 v, int degree)
{
    struct patch p = {0};
    struct nurbs *s = &p.surface;
    size_t n = (size_t)degree + 1;

    s->u = s->v = (struct nurbs_axis){.degree = degree, .poles = n, .from = 0, .to = 1};
    s->u.knot = mem_alloc(2 * n, sizeof *s->u.knot);
    s->v.knot = mem_alloc(2 * n, sizeof *s->v.knot);
    s->pole = mem_alloc(n * n, sizeof *s->pole);
    for (size_t i = n; i < 2 * n; i++)
        s->u.knot[i] = s->v.knot[i] = 1;
    for (size_t i = 0; i < n * n; i++) {
        double a = (double)(i % n) / degree, b = (double)(i / n) / degree;
        struct vec3 q = vec_along(vec_along(at, a, u), b, v);
        s->pole[i] = (struct nurbs_pole){q.x, q.y, q.z, 1};
    }
    *array_push(&patches) = p;
    return &patches.item[patches.n - 1];
}

/* Trims it to the half before or behind one diagonal. */
static void halve(struct patch *p, bool far)
{
    struct uv corner[3] = {{1, 0}, {far, far}, {0, 1}};
    struct patch_loop loop = {0};

    for (int i = 0; i < 3; i++)
        *array_push(&loop) = patch_line(corner[i], corner[(i + 1) % 3]);
    *array_push(&p->loop) = loop;
}

static void box(double x)
{
    struct vec3 a = vec(x, 0, 0), b = vec(x + 10, 10, 10);
    struct vec3 i = vec(10, 0, 0), j = vec(0, 10, 0), k = vec(0, 0, 10);

    add(a, i, j, 1);
    add(a, j, k, 1);
    add(a, k, i, 1);
    add(b, vec_scale(-1, i), vec_scale(-1, j), 1);
    add(b, vec_scale(-1, j), vec_scale(-1, k), 1);
    add(b, vec_scale(-1, k), vec_scale(-1, i), 1);
}

static void begin(void)
{
    patches = (struct patches){0};
}

static void find(double same)
{
    for (size_t i = 0; i < patches.n; i++)
        tessellate(
            &patches.item[i],
            (struct tessellate_options){.n = 1 + (int)i % 3, .tolerance = 1e-3, .threads = 1},
            &sheet[i]);
    twin = coincident_find(&patches, sheet, same, 0.01);
}

static void end(void)
{
    for (size_t i = 0; i < patches.n; i++)
        sheet_free(&sheet[i]);
    patches_free(&patches);
    free(twin);
}

static const struct vec3 zero = {0, 0, 0}, i = {10, 0, 0}, j = {0, 8, 3};

START_TEST(one_place)
{
    static const struct {
        struct vec3 at, u, v;
        int degree, twin;
    } cases[] = {
        {{0, 0, 0}, {10, 0, 0}, {0, 8, 3}, 1, 0},      {{0, 0, 0}, {0, 8, 3}, {10, 0, 0}, 3, 0},
        {{10, 8, 3}, {-10, 0, 0}, {0, -8, -3}, 2, 0},  {{0, 0, 2e-5}, {10, 0, 0}, {0, 8, 3}, 1, -1},
        {{0, 0, 0}, {10, 0, 0}, {0, 8, 3.001}, 1, -1}, {{0, 0, 0}, {9, 0, 0}, {0, 8, 3}, 1, -1},
        {{0, 0, 3}, {10, 0, 0}, {0, 8, -3}, 1, -1},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        begin();
        add(zero, i, j, 1);
        add(cases[k].at, cases[k].u, cases[k].v, cases[k].degree);
        find(1e-5);
        ck_assert_int_eq(twin[0], -1);
        ck_assert_msg(twin[1] == cases[k].twin, "%zu: %d", k, twin[1]);
        end();
    }
}
END_TEST

/* Of one box and one area, and on one plane, but not in one place. */
START_TEST(trimmed)
{
    for (int same = 0; same < 2; same++) {
        begin();
        halve(add(zero, i, j, 1), false);
        halve(add(zero, i, j, 1), !same);
        find(1e-5);
        ck_assert_int_eq(twin[1], same ? 0 : -1);
        end();
    }
}
END_TEST

START_TEST(of_bodies)
{
    begin();
    add(zero, i, j, 1)->body = 1;
    add(zero, i, j, 1)->body = 2;
    add(zero, i, j, 1)->body = 2;
    add(zero, i, j, 1)->body = 2;
    find(1e-5);
    ck_assert_int_eq(twin[1], -1);
    ck_assert_int_eq(twin[2], 1);
    ck_assert_int_eq(twin[3], 1);
    end();
}
END_TEST

START_TEST(of_boxes)
{
    begin(); /* a face twice */
    box(0);
    add(vec(10, 0, 0), vec(0, 0, 10), vec(0, 10, 0), 2);
    find(1e-5);
    for (size_t k = 0; k < 6; k++)
        ck_assert_int_eq(twin[k], -1);
    ck_assert_int_eq(twin[6], 4);
    end();
    begin(); /* walls between two that touch */
    box(0);
    box(10);
    find(1e-5);
    for (size_t k = 0; k < patches.n; k++)
        ck_assert_int_eq(twin[k], -1);
    end();
    begin(); /* all of it twice */
    box(0);
    box(0);
    find(1e-5);
    for (size_t k = 0; k < 12; k++)
        ck_assert_int_eq(twin[k], k < 6 ? -1 : (int)k - 6);
    end();
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("coincident");
    TCase *tests = tcase_create("coincident");
    tcase_add_test(tests, one_place);
    tcase_add_test(tests, trimmed);
    tcase_add_test(tests, of_bodies);
    tcase_add_test(tests, of_boxes);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
