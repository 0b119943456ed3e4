/* aside: all that is asked for is done, in its order, with a thread or without. */
#include <check.h>
#include <stdlib.h>

#include "base/aside.h"

enum { TIMES = 2000 };

struct piece {
    int value, *done, *n;
};

static void note_piece(void *context)
{
    struct piece *p = context;
    p->done[(*p->n)++] = p->value;
}

START_TEST(in_order)
{
    for (int threads = 0; threads < 4; threads++) {
        struct aside *aside = aside_begin(threads);
        static struct piece piece[TIMES];
        int done[TIMES] = {0}, n = 0;
        for (int i = 0; i < TIMES; i++) {
            piece[i] = (struct piece){i, done, &n};
            aside_do(aside, note_piece, &piece[i]);
            if (i % 100 == 99) {
                aside_wait(aside);
                ck_assert_int_eq(n, i + 1);
            }
        }
        aside_end(aside);
        ck_assert_int_eq(n, TIMES);
        for (int i = 0; i < TIMES; i++)
            ck_assert_int_eq(done[i], i);
    }
}
END_TEST

/* Ends when it is told to. */
struct gate {
    _Atomic bool open;
    int *done, *n;
};

static void wait_at_gate(void *context)
{
    struct gate *g = context;
    while (!g->open)
        ;
    g->done[(*g->n)++] = -1;
}

/* One piece may wait behind the one in hand, in its order, until it is forgotten. */
START_TEST(one_waits)
{
    for (int drop = 0; drop < 2; drop++) {
        struct aside *aside = aside_begin(2);
        int done[4] = {0}, n = 0;
        struct gate gate = {false, done, &n};
        struct piece next = {7, done, &n}, over = {8, done, &n};
        ck_assert(aside_add(aside, wait_at_gate, &gate));
        ck_assert(!aside_is_full(aside));
        ck_assert(aside_add(aside, note_piece, &next));
        ck_assert(aside_is_full(aside));
        ck_assert(!aside_add(aside, note_piece, &over));
        if (drop)
            aside_drop(aside);
        ck_assert(aside_is_full(aside) == !drop);
        gate.open = true;
        aside_end(aside);
        ck_assert_int_eq(n, drop ? 1 : 2);
        ck_assert_int_eq(done[0], -1);
        ck_assert_int_eq(done[1], drop ? 0 : 7);
    }
}
END_TEST

/* Without another thread it is done when it is asked for. */
START_TEST(at_once)
{
    struct aside *aside = aside_begin(1);
    int done[2] = {0}, n = 0;
    struct piece a = {1, done, &n}, b = {2, done, &n};
    ck_assert(aside_add(aside, note_piece, &a));
    ck_assert_int_eq(n, 1);
    ck_assert(aside_add(aside, note_piece, &b));
    ck_assert_int_eq(n, 2);
    ck_assert(!aside_is_full(aside));
    aside_end(aside);
}
END_TEST

START_TEST(nothing_to_do)
{
    for (int threads = 0; threads < 4; threads++) {
        struct aside *aside = aside_begin(threads);
        aside_wait(aside);
        aside_end(aside);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("aside");
    TCase *tests = tcase_create("aside");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, in_order);
    tcase_add_test(tests, one_waits);
    tcase_add_test(tests, at_once);
    tcase_add_test(tests, nothing_to_do);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
