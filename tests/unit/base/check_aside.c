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
    tcase_add_test(tests, nothing_to_do);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
