/* check_post_plan - where a move ends: by its vector, or by the chain's axis at its angles. */
#include <check.h>

#include "base/array.h"
#include "math/elementary.h"
#include "post/post_plan.h"

/* A and C in the table: a = (sin C sin A, -cos C sin A, cos A), kinematics.h. */
static const struct kinematic_chain table_ac = {
    .n = 2,
    .rotary = {{.axis = {0, 0, 1}, .table = true}, {.axis = {1, 0, 0}, .table = true}},
    .tool = {0, 0, 1}};

static void near(struct vec3 got, struct vec3 truth)
{
    ck_assert_msg(vec_distance(got, truth) < 1e-12, "%.9f %.9f %.9f, not %.9f %.9f %.9f", got.x,
                  got.y, got.z, truth.x, truth.y, truth.z);
}

START_TEST(by_the_angles)
{
    struct nc_plan plan = {.ability.mode = INTERPOLATE_JOINT};
    for (int i = -6; i <= 6; i++) {
        double c = 0.5 * i, a = 0.3 * i + 0.1;
        struct nc_move move = {.kind = NC_LINE, .p = {1, 2, i}, .q = {c, a}, .vector = 3};
        struct block_pose at = nc_plan_pose(&plan, &table_ac, &move);
        near(at.p, move.p);
        near(at.a, vec(sin(c) * sin(a), -cos(c) * sin(a), cos(a)));
        ck_assert(at.q[0] == c && at.q[1] == a);
    }
}
END_TEST

START_TEST(by_its_vector)
{
    struct nc_plan plan = {.ability.mode = INTERPOLATE_VECTOR};
    *array_push(&plan.vector) = vec(0, 0, 1);
    *array_push(&plan.vector) = vec(0.6, 0, 0.8);
    struct nc_move move = {.kind = NC_LINE, .vector = 1, .q = {1, 1}};
    near(nc_plan_pose(&plan, &table_ac, &move).a, vec(0.6, 0, 0.8));
    move.vector = 0;
    near(nc_plan_pose(&plan, &table_ac, &move).a, vec(0, 0, 1));
    nc_plan_free(&plan);
    ck_assert_uint_eq(plan.vector.n, 0);
}
END_TEST

START_TEST(what_takes_the_tool_elsewhere)
{
    static const enum nc_kind moving[] = {NC_RAPID, NC_LINE, NC_ARC, NC_SPLINE, NC_HOLE};
    static const enum nc_kind still[] = {NC_PASS, NC_TEXT, NC_TOOL, NC_PLANE};
    for (size_t i = 0; i < sizeof moving / sizeof *moving; i++)
        ck_assert(nc_moves(&(struct nc_move){.kind = moving[i]}));
    for (size_t i = 0; i < sizeof still / sizeof *still; i++)
        ck_assert(!nc_moves(&(struct nc_move){.kind = still[i]}));
    ck_assert_uint_le(sizeof(struct nc_move), 64); /* there may be millions */
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_plan");
    TCase *tests = tcase_create("post_plan");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, by_the_angles);
    tcase_add_test(tests, by_its_vector);
    tcase_add_test(tests, what_takes_the_tool_elsewhere);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
