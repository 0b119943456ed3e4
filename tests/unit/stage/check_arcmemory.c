/* arcmemory: the very same points, each part once. */
#include "stage/arcmemory.h"

#include <check.h>
#include <stdlib.h>

static struct reference trace_from(double y)
{
    struct run run = {.radius = 3};
    for (int i = 0; i < 5; i++) {
        struct run_point p = {.tip = vec(i, y, 0), .axis = vec(0, 0, 1)};
        p.ball = vec(i, y, 3);
        *array_push(&run) = p;
    }
    struct reference reference = reference_of(&run, 0, run.n, false, false);
    array_free(&run);
    return reference;
}

static struct arcmemory_part mesh_for_rows_at(double y, double radius)
{
    struct arcmemory_part part = {.reference = trace_from(y), .worst.point = radius / 100};
    *array_push(&part.printed) = (struct printed){.arc.radius = radius};
    return part;
}

START_TEST(parts_are_known_by_their_points)
{
    struct arcmemory memory = {0};
    struct printeds found = {0};
    struct pieces pieces = {0};
    struct deviation worst = {0};
    *array_push(&memory) = mesh_for_rows_at(1, 10);
    *array_push(&memory) = mesh_for_rows_at(2, 20);
    struct reference second = trace_from(2), third = trace_from(2 + 1e-12);
    ck_assert_ptr_eq(arcmemory_like(&memory, &second), &memory.item[1]);
    ck_assert_ptr_null(arcmemory_like(&memory, &third));
    ck_assert(!arcmemory_take(&memory, &third, &pieces, &found, &worst));
    ck_assert(arcmemory_take(&memory, &second, &pieces, &found, &worst));
    ck_assert_uint_eq(found.n, 1);
    ck_assert_double_eq(found.item[0].arc.radius, 20);
    ck_assert_double_eq(worst.point, 0.2);
    ck_assert(!arcmemory_take(&memory, &second, &pieces, &found, &worst)); /* it was taken out */
    reference_free(&second);
    reference_free(&third);
    array_free(&found);
    array_free(&pieces);
    arcmemory_free(&memory);
    ck_assert_uint_eq(memory.n, 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("arcmemory");
    TCase *tests = tcase_create("arcmemory");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, parts_are_known_by_their_points);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
