/*
 * trim_told: a circle drawn in the parameters of a sphere or torus, and loops that bound what is in
 * it, or all the rest: the answer is which of the two the loops have.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "known.h"
#include "nurbs/trim_told.h"

static struct patch patch;
static struct uv_polygon loops;

static void teardown(void)
{
    uv_polygon_free(&loops);
    loops = (struct uv_polygon){0};
    patch_free(&patch);
    patch = (struct patch){0};
}

/* A rectangle of the range, in parts of it. */
struct part {
    double u0, u1, v0, v1;
};

static struct uv corner_of(struct part p, int i)
{
    const struct nurbs *s = &patch.surface;
    double u = i == 1 || i == 2 ? p.u1 : p.u0, v = i >= 2 ? p.v1 : p.v0;
    return (struct uv){s->u.from + u * (s->u.to - s->u.from),
                       s->v.from + v * (s->v.to - s->v.from)};
}

/* The file draws the loop in the parameters, each curve with weights of its own, and has one in
 * space that is not looked at. */
static void tell(struct part p)
{
    struct patch_loop told = {0}, in_space = {.space = true};
    for (int i = 0; i < 4; i++) {
        struct nurbs_curve c = patch_line(corner_of(p, i), corner_of(p, (i + 1) % 4));
        for (size_t k = 0; k < c.t.poles; k++) {
            struct nurbs_pole *q = &c.pole[k];
            double w = 1 + i;
            *q = (struct nurbs_pole){q->wx * w, q->wy * w, 0, q->w * w};
        }
        *array_push(&told) = c;
    }
    *array_push(&patch.told) = told;
    *array_push(&patch.loop) = in_space;
}

static void bound(struct part p)
{
    struct uvs loop = {0};
    for (int i = 0; i < 4; i++)
        *array_push(&loop) = corner_of(p, i);
    *array_push(&loops) = loop;
}

static const struct part whole = {0, 1, 0, 1}, middle = {0.3, 0.7, 0.3, 0.7};

/* Either of them, on three surfaces that close, and of more than one loop. */
START_TEST(sides)
{
    for (int i = 0; i < 3; i++) {
        patch = i == 0 ? known_sphere(10) : i == 1 ? known_torus(20, 5) : known_cylinder(5, 9);
        tell(middle);
        bound(middle);
        ck_assert(!trim_told_outside(&patch, &loops));
        bound(whole); /* the whole range but the middle */
        ck_assert(trim_told_outside(&patch, &loops));
        /* and a hole more that both have */
        tell((struct part){0.05, 0.2, 0.05, 0.2});
        bound((struct part){0.05, 0.2, 0.05, 0.2});
        ck_assert(trim_told_outside(&patch, &loops));
        teardown();
    }
}
END_TEST

/* Borders that are a little off do not matter; where a quarter of the range answers otherwise,
 * nothing is said. */
START_TEST(rough_loops)
{
    patch = known_torus(20, 5);
    tell((struct part){0.32, 0.72, 0.29, 0.66});
    bound(middle);
    ck_assert(!trim_told_outside(&patch, &loops));
    bound(whole);
    ck_assert(trim_told_outside(&patch, &loops));
    teardown();
    patch = known_torus(20, 5);
    tell(middle);
    bound(whole);
    bound((struct part){0.05, 0.55, 0.05, 0.55}); /* neither this nor that */
    ck_assert(!trim_told_outside(&patch, &loops));
}
END_TEST

/* No loops, not all of them told, or a surface that its border bounds. */
START_TEST(nothing_told)
{
    patch = known_sphere(10);
    ck_assert(!trim_told_outside(&patch, &loops));
    tell(middle);
    ck_assert(!trim_told_outside(&patch, &loops));
    bound(whole);
    bound(middle);
    ck_assert(trim_told_outside(&patch, &loops));
    patch.open = true;
    ck_assert(!trim_told_outside(&patch, &loops));
    patch.open = false;
    struct patch_loop more = {.space = true};
    *array_push(&patch.loop) = more;
    ck_assert(!trim_told_outside(&patch, &loops));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("trim_told");
    TCase *tests = tcase_create("trim_told");
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, sides);
    tcase_add_test(tests, rough_loops);
    tcase_add_test(tests, nothing_told);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
