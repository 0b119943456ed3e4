/* arc_carry: places of pieces among the points of a run of which some moved, by hand; what is to be
 * fitted anew is what touches them, and no more. */
#include <check.h>
#include <stdlib.h>

#include "stage/arc_carry.h"

/* Given points at 0, 10, 20, 30, 40 along X, and between them as many others as said. */
static struct run run_of(const size_t between[4])
{
    struct run run = {.radius = 3};
    for (size_t g = 0; g < 5; g++)
        for (size_t k = 0; k <= (g < 4 ? between[g] : 0); k++) {
            double x = 10 * (double)g + 10 * (double)k / (double)(g < 4 ? between[g] + 1 : 1);
            *array_push(&run) = (struct run_point){.tip = vec(x, 0, 0),
                                                   .ball = vec(x, 0, 3),
                                                   .axis = vec(0, 0, 1),
                                                   .contact = vec(x, 0, 0),
                                                   .normal = vec(0, 0, 1),
                                                   .given = k == 0};
        }
    return run;
}

START_TEST(any_difference)
{
    struct run_point a = {.axis = vec(0, 0, 1), .normal = vec(0, 0, 1)};
    ck_assert(arc_carry_same(&a, &a));
    for (size_t k = 0; k < 15; k++) {
        struct run_point b = a;
        struct vec3 *v[] = {&b.tip, &b.ball, &b.axis, &b.contact, &b.normal};
        double *x = k % 3 == 0 ? &v[k / 3]->x : k % 3 == 1 ? &v[k / 3]->y : &v[k / 3]->z;
        *x += 1e-9;
        ck_assert(!arc_carry_same(&a, &b));
    }
    struct run_point b = a;
    b.given = true;
    ck_assert(!arc_carry_same(&a, &b));
}
END_TEST

START_TEST(alike)
{
    struct run a = run_of((const size_t[]){4, 4, 4, 4}), b = run_of((const size_t[]){4, 9, 0, 4});
    ck_assert(arc_carry_alike(&a, &b)); /* as many between them as one likes */
    b.item[5].given = false;
    ck_assert(!arc_carry_alike(&a, &b));
    b.item[5].given = true;
    b.item[0].ball.z += 0.09; /* a corner that was lifted */
    ck_assert(arc_carry_alike(&a, &b));
    b.item[0].ball.z += 0.02;
    ck_assert(!arc_carry_alike(&a, &b));
    b.item[0].ball.z = a.item[0].ball.z;
    ck_assert(arc_carry_alike(&a, &b));
    b.item[b.n - 1].ball.z += 0.11;
    ck_assert(!arc_carry_alike(&a, &b));
    struct run one = {.n = 1, .item = a.item};
    ck_assert(!arc_carry_alike(&one, &one));
    array_free(&a);
    array_free(&b);
}
END_TEST

/* The pieces that begin at these places; the last one ends with the run. */
static struct pieces pieces_of(size_t n, const double *from)
{
    struct pieces pieces = {0};
    for (size_t i = 0; i < n; i++)
        *array_push(&pieces) =
            (struct arc_piece){.from = from[i], .to = i + 1 < n ? from[i + 1] : 20};
    return pieces;
}

struct carried {
    struct run before, after;
    struct pieces old, now;
    struct arc_moves windows;
};

static void carry(struct carried *c, size_t beside)
{
    c->now.n = 0;
    arc_carry(&c->before, &c->after, &c->old, beside, &c->now, &c->windows);
}

static void carried_free(struct carried *c)
{
    array_free(&c->before);
    array_free(&c->after);
    array_free(&c->old);
    array_free(&c->now);
    array_free(&c->windows);
}

/* Intervals of 5 become 10, 5, 5, 1 long: places keep their part of the interval. */
START_TEST(places)
{
    static const double from[] = {0, 2.5, 5, 7, 12, 15, 17.5},
                        want[] = {0, 5, 10, 12, 17, 20, 20.5, 21};
    struct carried c = {.before = run_of((const size_t[]){4, 4, 4, 4}),
                        .after = run_of((const size_t[]){9, 4, 4, 0}),
                        .old = pieces_of(7, from)};
    carry(&c, 0);
    ck_assert_uint_eq(c.now.n, 7);
    for (size_t i = 0; i < 7; i++) {
        ck_assert_double_eq_tol(c.now.item[i].from, want[i], 1e-12);
        ck_assert_double_eq_tol(c.now.item[i].to, want[i + 1], 1e-12);
    }
    /* the first two are in the interval that changed, the third begins at its end, the last in the
     * last one; the piece from 12 to 15 ends where it begins */
    ck_assert_uint_eq(c.windows.n, 2);
    ck_assert_uint_eq(c.windows.item[0].from, 0);
    ck_assert_uint_eq(c.windows.item[0].to, 2);
    ck_assert_uint_eq(c.windows.item[1].from, 4);
    ck_assert_uint_eq(c.windows.item[1].to, 7);
    carried_free(&c);
}
END_TEST

/* One point between given ones moves: the pieces of that interval, and `beside` more. */
START_TEST(what_touches_it)
{
    static const double from[] = {0, 2, 4, 6, 8, 12, 14, 16, 18};
    static const struct {
        size_t point, beside, from, to;
    } k[] = {{7, 0, 2, 5}, {7, 1, 1, 6}, {7, 3, 0, 8}, {2, 0, 0, 3}, {18, 0, 6, 9}, {18, 2, 4, 9}};
    for (size_t i = 0; i < sizeof k / sizeof *k; i++) {
        struct carried c = {.before = run_of((const size_t[]){4, 4, 4, 4}),
                            .after = run_of((const size_t[]){4, 4, 4, 4}),
                            .old = pieces_of(9, from)};
        carry(&c, k[i].beside);
        ck_assert_uint_eq(c.windows.n, 0);
        c.after.item[k[i].point].ball.z += 1e-9;
        carry(&c, k[i].beside);
        ck_assert_uint_eq(c.windows.n, 1);
        ck_assert_uint_eq(c.windows.item[0].from, k[i].from);
        ck_assert_uint_eq(c.windows.item[0].to, k[i].to);
        for (size_t j = 0; j < 9; j++)
            ck_assert_double_eq(c.now.item[j].from, from[j]);
        carried_free(&c);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("arc_carry");
    TCase *tests = tcase_create("arc_carry");
    tcase_add_test(tests, any_difference);
    tcase_add_test(tests, alike);
    tcase_add_test(tests, places);
    tcase_add_test(tests, what_touches_it);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
