/* step_repeats: of faces, told apart by their numbers, their shells and their places, what is shown
 * again is dropped, the rest stays in its order, and what came before `from` is not looked at. */
#include <check.h>
#include <stdlib.h>

#include "io/nurbs/step_repeats.h"

static struct patches patches;

/* A face of that number and shell, whose surface has one pole in each corner of a square at x. */
static void add(int entity, int body, double x)
{
    struct patch *patch = array_push(&patches);
    struct nurbs_pole *pole = mem_alloc(4, sizeof *pole);

    for (int i = 0; i < 4; i++)
        pole[i] = (struct nurbs_pole){x + i % 2, i / 2, 0, 1};
    *patch = (struct patch){.entity = entity, .body = body};
    patch->surface.u.poles = patch->surface.v.poles = 2;
    patch->surface.pole = pole;
}

static void teardown(void)
{
    patches_free(&patches);
    patches = (struct patches){0};
}

/* The numbers of the faces that are left, as digits. */
static long left(void)
{
    long digits = 0;
    for (size_t i = 0; i < patches.n; i++)
        digits = 10 * digits + patches.item[i].entity;
    return digits;
}

START_TEST(named_by_themselves)
{
    add(4, 0, 0); /* before */
    add(5, 1, 0);
    add(4, 1, 0);
    add(5, 0, 0); /* a face of the shell */
    add(6, 0, 0); /* of none */
    add(4, 2, 0);
    step_drop_named(&patches, 1);
    ck_assert_int_eq(left(), 45464);
    step_drop_named(&patches, 0);
    ck_assert_int_eq(left(), 5464);
}
END_TEST

START_TEST(in_the_same_place)
{
    add(3, 1, 0); /* before */
    add(3, 1, 0);
    add(7, 1, 0);
    add(3, 1, 5); /* elsewhere */
    add(3, 2, 0); /* again */
    add(7, 1, 0); /* again */
    add(8, 1, 0);
    step_drop_repeated(&patches, 1);
    ck_assert_int_eq(left(), 33738);
    step_drop_repeated(&patches, patches.n); /* nothing to look at */
    ck_assert_int_eq(left(), 33738);
}
END_TEST

START_TEST(without_a_place)
{
    struct sizes unplaced = {0};

    add(1, 1, 0);
    add(2, 1, 0);
    add(1, 1, 0);
    add(3, 1, 0); /* nowhere else: it stays */
    add(2, 1, 0);
    *array_push(&unplaced) = 2;
    *array_push(&unplaced) = 4;
    step_drop_unplaced(&patches, &unplaced, 0);
    ck_assert_int_eq(left(), 1232);
    array_free(&unplaced);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("step_repeats");
    TCase *tests = tcase_create("step_repeats");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, named_by_themselves);
    tcase_add_test(tests, in_the_same_place);
    tcase_add_test(tests, without_a_place);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
