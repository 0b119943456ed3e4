/* holder_avoid: a tool along the foot of a wall, its holder checked point by point. */
#include "gouge/holder_avoid.h"

#include <check.h>
#include <stdlib.h>

static const double BALL = 4;

/* Shank of radius 3 up to 30 mm, then a holder of radius 12. */
static const struct holder holder = {2, {{3, 3, 30}, {12, 12, 40}}};

static struct vec3s part;

/* A floor z = 0 and a wall at x = 6 up to z = `high`, from y = 20 to 60. */
static struct gouge_check *make_part(double high)
{
    part.n = 0;
    for (int k = 0; k <= 80; k++) {
        for (int i = -10; i <= 6; i++)
            *array_push(&part) = vec(i, k, 0);
        for (int j = 1; j <= (int)high && k >= 20 && k <= 60; j++)
            *array_push(&part) = vec(6, k, j);
    }
    return gouge_from_points(part.item, part.n);
}

/* Along y at the foot of the wall, the axis upright. */
static struct run make_run(void)
{
    struct run run = {.radius = BALL};
    for (int i = 0; i <= 160; i++) {
        struct run_point p = {.contact = {0, 0.5 * i, 0}, .normal = {0, 0, 1}, .axis = {0, 0, 1}};
        p.ball = vec(0, 0.5 * i, BALL);
        p.tip = p.contact;
        *array_push(&run) = p;
    }
    return run;
}

/* How deep any point of the part is in the holder along the way between two points of the run. */
static double deepest_between(const struct run_point *a, const struct run_point *b)
{
    double deepest = -HUGE_VAL;
    for (int k = 0; k <= 8; k++) {
        struct vec3 c = vec_mix(a->ball, b->ball, k / 8.0);
        struct vec3 axis = vec_slerp(a->axis, b->axis, k / 8.0);
        for (size_t i = 0; i < part.n; i++)
            deepest = fmax(deepest, -holder_distance(&holder, c, axis, part.item[i]));
    }
    return deepest;
}

START_TEST(the_axis_leans_off_the_wall)
{
    struct gouge_check *guard = make_part(50);
    struct run run = make_run();
    struct holder_avoid_options rule = {guard, &holder, RADIANS(40), 0.01};
    bool touches[161];
    ck_assert_double_gt(deepest_between(&run.item[80], &run.item[80]), 5);
    double lean = holder_avoid(&rule, &run, touches);
    /* The holder's lower edge at (12, 30) turned to x = 6 or less: by 9.2 degrees more than nothing
     * and, as its upper end comes nearer too, no more than 25. */
    ck_assert_double_ge(lean, RADIANS(9));
    ck_assert_double_le(lean, RADIANS(25));
    for (size_t i = 1; i < run.n; i++) {
        const struct run_point *p = &run.item[i];
        ck_assert(!touches[i]);
        ck_assert_double_le(deepest_between(p - 1, p), 0.01 + 1e-9);
        ck_assert_double_lt(vec_distance(p->tip, vec_along(p->ball, -BALL, p->axis)), 1e-12);
        ck_assert_double_le(vec_angle(p->axis, p[-1].axis), RADIANS(4));
        ck_assert_double_gt(vec_dot(p->axis, p->normal), 0.05);
    }
    ck_assert_double_lt(run.item[80].axis.x, -0.1); /* away from the wall */
    ck_assert_double_lt(vec_angle(run.item[0].axis, vec(0, 0, 1)),
                        1e-12); /* far from it, upright */
    array_free(&run);
    gouge_free(guard);
}
END_TEST

START_TEST(what_a_limit_does_not_clear_touches)
{
    struct gouge_check *guard = make_part(50);
    struct run run = make_run();
    struct holder_avoid_options rule = {guard, &holder, RADIANS(5), 0.01};
    bool touches[161];
    ck_assert_double_le(holder_avoid(&rule, &run, touches), RADIANS(5) + 1e-9);
    ck_assert(!touches[0] && !touches[10] && touches[80] && touches[60] && !touches[160]);
    /* What is not told to touch does not. */
    for (size_t i = 1; i < run.n; i++)
        if (!touches[i] && !touches[i - 1])
            ck_assert_double_le(deepest_between(&run.item[i - 1], &run.item[i]), 0.01 + 1e-9);
    array_free(&run);
    gouge_free(guard);
}
END_TEST

START_TEST(a_low_wall_needs_nothing)
{
    struct gouge_check *guard = make_part(25);
    struct run run = make_run();
    struct holder_avoid_options rule = {guard, &holder, RADIANS(40), 0.01};
    bool touches[161];
    ck_assert(holder_avoid(&rule, &run, touches) == 0);
    for (size_t i = 0; i < run.n; i++)
        ck_assert(!touches[i] && run.item[i].axis.z == 1);
    array_free(&run);
    gouge_free(guard);
}
END_TEST

/* The two ends are clear, but between them the holder goes through a post. */
START_TEST(a_post_between_is_seen)
{
    struct vec3 post[60];
    for (int j = 0; j < 60; j++)
        post[j] = vec(8, 0, j);
    struct gouge_check *guard = gouge_from_points(post, 60);
    struct holder_avoid_options rule = {guard, &holder, 0, 0.01};
    struct run_point a = {.ball = {0, -30, BALL}, .axis = {0, 0, 1}}, b = a, c = a;
    b.ball.y = 30;
    c.ball = vec(-10, 30, BALL);
    ck_assert(!holder_clear_between(&rule, &a, &b));
    a.ball.x = -10;
    ck_assert(holder_clear_between(&rule, &a, &c));
    gouge_free(guard);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("holder_avoid");
    TCase *tcase = tcase_create("holder_avoid");
    tcase_set_timeout(tcase, 60);
    tcase_add_test(tcase, the_axis_leans_off_the_wall);
    tcase_add_test(tcase, what_a_limit_does_not_clear_touches);
    tcase_add_test(tcase, a_low_wall_needs_nothing);
    tcase_add_test(tcase, a_post_between_is_seen);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
