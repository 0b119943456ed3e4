/* lifted over points where the height of the ball is known. */
#include "gouge/gouge_point.h"

#include <check.h>
#include <stdlib.h>

static const double R = 5, TOLERANCE = 0.01;

static struct gouge_lift_options make_rule(const struct gouge_check *guard)
{
    return (struct gouge_lift_options){.guard = guard,
                                       .offset = R,
                                       .limit = R,
                                       .between = true,
                                       .tolerance = TOLERANCE,
                                       .step = 0.05,
                                       .axis = {.kind = AXIS_FIXED, .direction = {0, 0, 1}},
                                       .feed = {.along = {1, 0, 0}, .side = {0, 1, 0}}};
}

static double uniform(double from, double to)
{
    static unsigned long long state = 88172645463325252ULL;
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return from + (to - from) * (double)(state >> 11) / 9007199254740992.0;
}

static struct gouge_point lift_at(double x, const struct gouge_lift_options *rule)
{
    const struct kdtree_touch nothing = {.n = 0};
    struct run_point p = {.contact = {x, 0, 0}, .normal = {0, 0, 1}};
    return gouge_point_from(&p, &nothing, rule, R);
}

/* Where a ball that comes down on these ends. */
static double height_over(const struct vec3s *part, double x)
{
    double height = R;
    for (size_t i = 0; i < part->n; i++) {
        struct vec3 p = part->item[i];
        double across2 = (p.x - x) * (p.x - x) + p.y * p.y;
        if (across2 < R * R)
            height = fmax(height, p.z + sqrt(R * R - across2));
    }
    return height;
}

/* Pins of heights below 0.4 mm, so that nothing is out of reach, over 12 mm of a way. */
static struct vec3s make_pins(size_t n)
{
    struct vec3s pins = {0};
    while (pins.n < n)
        *array_push(&pins) = vec(uniform(-6, 6), uniform(-1, 1), uniform(0, 0.4));
    return pins;
}

START_TEST(points_stand_where_the_ball_comes_down)
{
    for (int round = 0; round < 20; round++) {
        struct vec3s pins = make_pins(30);
        struct gouge_check *guard = gouge_from_points(pins.item, pins.n);
        struct gouge_lift_options rule = make_rule(guard);
        for (double x = -6; x < 6; x += 0.37) {
            struct gouge_point l = lift_at(x, &rule);
            ck_assert(!l.missed);
            ck_assert_double_eq_tol(l.p.ball.z, height_over(&pins, x), 1e-5);
            ck_assert_double_eq_tol(l.p.ball.z - l.p.tip.z, R, 1e-12);
            if (l.touch.n > 0)
                ck_assert_double_eq_tol(vec_distance(l.touch.p[0], l.p.ball), R, 1e-9);
        }
        gouge_free(guard);
        array_free(&pins);
    }
}
END_TEST

/* The line never goes deeper than the tolerance.  Half way it stands no higher than that over where
 * the ball comes down; a kink beside the middle leaves about twice as much. */
static void look_at_line(const struct gouge_point *a, const struct gouge_point *b,
                         const struct gouge_check *guard, const struct vec3s *pins)
{
    ck_assert_double_le(gouge_depth_along(guard, a->p.ball, b->p.ball, R), TOLERANCE);
    for (double t = 0.05; t < 1; t += 0.05) {
        struct vec3 c = vec_mix(a->p.ball, b->p.ball, t);
        ck_assert_double_le(c.z - height_over(pins, c.x), 2.5 * TOLERANCE);
    }
}

START_TEST(lines_follow_the_ball_and_are_clear)
{
    size_t put = 0, pairs = 0;
    for (int round = 0; round < 40; round++) {
        struct vec3s pins = make_pins(round % 4 == 0 ? 1 : 25);
        struct gouge_check *guard = gouge_from_points(pins.item, pins.n);
        struct gouge_lift_options rule = make_rule(guard);
        struct gouge_point before = lift_at(-6, &rule);
        for (double x = -5.5; x < 6; x += 0.5, pairs++) {
            struct gouge_points points = {0};
            struct gouge_point next = lift_at(x, &rule);
            gouge_point_between(&before, &next, &rule, R, &points);
            put += points.n;
            *array_push(&points) = next;
            for (size_t i = 0; i < points.n; i++)
                look_at_line(i > 0 ? &points.item[i - 1] : &before, &points.item[i], guard, &pins);
            before = next;
            array_free(&points);
        }
        gouge_free(guard);
        array_free(&pins);
    }
    ck_assert_uint_gt(put, pairs / 10);
    ck_assert_uint_lt(put, 2 * pairs);
}
END_TEST

START_TEST(half_way_is_lifted_itself)
{
    struct vec3 pin = vec(0.2, 0, 0.3);
    struct gouge_check *guard = gouge_from_points(&pin, 1);
    struct gouge_lift_options rule = make_rule(guard);
    struct gouge_point a = lift_at(-4, &rule), b = lift_at(4, &rule);
    struct gouge_point m = gouge_point_halfway(&a, &b, &rule, R);
    ck_assert_double_eq_tol(m.p.ball.z, 0.3 + sqrt(R * R - 0.04), 1e-5);
    ck_assert_double_eq_tol(m.touching.z, R, 1e-12);
    ck_assert(!gouge_point_clear(&a.p, &b.p, &rule));
    ck_assert(gouge_point_clear(&m.p, &m.p, &rule));
    ck_assert(!gouge_point_near(&a, &b, &rule));
    ck_assert(gouge_point_near(&a, &a, &rule));
    gouge_free(guard);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("lifted");
    TCase *tcase = tcase_create("lifted");
    tcase_add_test(tcase, points_stand_where_the_ball_comes_down);
    tcase_add_test(tcase, lines_follow_the_ball_and_are_clear);
    tcase_add_test(tcase, half_way_is_lifted_itself);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
