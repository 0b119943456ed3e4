/* axis_calm - rows cut to and fro, each with axes of its own: where one ends and the next begins
 * they become alike, as near to their rule as they may be, and the flute stays clear of a wall. */
#include "gouge/axis_calm.h"

#include <check.h>
#include <stdlib.h>

#include "machine/machine.h"
#include "machine/rotary_cost.h"

enum { RADIUS = 5, FLUTE = 30, ROWS = 6, POINTS = 61 };

static const double PLAY = RADIANS(15), TOLERANCE = 0.01, SLACK = 1e-6;
static const struct holder flute = {1, {{RADIUS, RADIUS, FLUTE}}};

/* A floor and, beside the rows, a wall at y = -6 from x = 10 to 20 up to this height. */
static struct gouge_check *floor_and_wall(double height, struct vec3s *copy)
{
    struct vec3s points = {0};

    for (int i = 0; i <= 120; i++)
        for (int k = -10; k <= 30; k++)
            *array_push(&points) = vec(i * 0.25, k * 0.5, 0);
    for (int i = 0; i <= 40; i++)
        for (int k = 1; k <= height * 4; k++)
            *array_push(&points) = vec(10 + i * 0.25, -6, k * 0.25);
    for (size_t i = 0; i < points.n; i++)
        *array_push(copy) = points.item[i];
    return gouge_new(points, 1);
}

struct rows {
    struct run_point point[ROWS * POINTS];
    struct vec3 rule[ROWS * POINTS];
    struct axis_calm_run run[ROWS];
};

/* Rows along X 1 mm apart, zig-zag; the rule leans 20 degrees to y, the axes to either side of it
 * by turns. */
static void make_rows(struct rows *r)
{
    for (int k = 0; k < ROWS; k++) {
        r->run[k] = (struct axis_calm_run){r->point + k * POINTS, r->rule + k * POINTS, POINTS,
                                           PLAY, false};
        for (int i = 0; i < POINTS; i++) {
            int at = k * POINTS + i;
            double x = 0.5 * (k % 2 ? POINTS - 1 - i : i), off = k % 2 ? 0.2 : -0.2;
            struct run_point p = {.contact = vec(x, k, 0), .normal = vec(0, 0, 1)};
            p.ball = vec(x, k, RADIUS);
            p.axis = vec_unit(vec(off, tan(RADIANS(20)), 1));
            p.tip = vec_along(p.ball, -RADIUS, p.axis);
            r->point[at] = p;
            r->rule[at] = vec_unit(vec(0, tan(RADIANS(20)), 1));
        }
    }
}

static struct axis_calm_options options_of(const struct gouge_check *guard)
{
    struct machine machine = machine_default();
    struct error error;

    ck_assert_int_eq(machine_finish(&machine, &error), 0);
    return (struct axis_calm_options){guard, &flute, machine.chain, RADIUS, TOLERANCE, 0, 1};
}

/* How far the axis turns from each row's end to the next one's start, all together. */
static double turn_of_links(const struct rows *r)
{
    double sum = 0;

    for (int k = 1; k < ROWS; k++)
        sum += vec_angle(r->point[k * POINTS - 1].axis, r->point[k * POINTS].axis);
    return sum;
}

static double travel_of(const struct rows *r)
{
    double sum = 0;

    for (int i = 1; i < ROWS * POINTS; i++)
        sum += rotary_travel(r->point[i - 1].axis, r->point[i].axis);
    return sum;
}

/* How deep a point of the scan is in the flute, at most. */
static double deepest(const struct vec3s *scan, const struct run_point *p)
{
    double most = -HUGE_VAL;

    for (size_t i = 0; i < scan->n; i++) {
        struct vec3 off = vec_sub(scan->item[i], p->ball);
        double up = vec_dot(off, p->axis);
        if (up >= 0 && up <= FLUTE)
            most = fmax(most, RADIUS - vec_length(vec_along(off, -up, p->axis)));
    }
    return most;
}

START_TEST(alike)
{
    struct vec3s scan = {0};
    struct gouge_check *guard = floor_and_wall(0, &scan);
    struct axis_calm_options options = options_of(guard);
    struct rows r, was;

    make_rows(&r);
    was = r;
    axis_calm_chain(&options, r.run, ROWS);
    ck_assert_double_gt(turn_of_links(&was), RADIANS(100));
    ck_assert_double_le(turn_of_links(&r), 0.1 * turn_of_links(&was));
    ck_assert_double_le(travel_of(&r), 0.3 * travel_of(&was));
    for (int i = 0; i < ROWS * POINTS; i++) {
        ck_assert_double_le(vec_angle(r.point[i].axis, r.rule[i]), PLAY + SLACK);
        ck_assert_double_eq_tol(vec_length(r.point[i].axis), 1, 1e-9);
        ck_assert_double_le(vec_distance(r.point[i].ball, was.point[i].ball), 0);
        ck_assert_double_le(
            vec_distance(r.point[i].tip, vec_along(r.point[i].ball, -RADIUS, r.point[i].axis)),
            1e-9);
    }
    gouge_free(guard);
    array_free(&scan);
}
END_TEST

/* Each run has a play of its own: where the rules of neighbouring rows lean 20 degrees to either
 * side, their axes come together with more than that, and not with a quarter of it. */
START_TEST(own_play)
{
    struct vec3s scan = {0};
    struct gouge_check *guard = floor_and_wall(0, &scan);
    struct axis_calm_options options = options_of(guard);
    double most[2] = {0, 0};

    for (int wide = 0; wide < 2; wide++) {
        struct rows r;
        make_rows(&r);
        for (int i = 0; i < ROWS * POINTS; i++) {
            double x = tan(RADIANS(20)) * (i / POINTS % 2 ? 1 : -1);
            r.rule[i] = r.point[i].axis = vec_unit(vec(x, tan(RADIANS(20)), 1));
        }
        for (int k = 0; k < ROWS; k++)
            r.run[k].play = RADIANS(wide ? 25 : 5);
        axis_calm_chain(&options, r.run, ROWS);
        most[wide] = travel_of(&r);
    }
    ck_assert_double_le(most[1], 0.5 * most[0]);
    gouge_free(guard);
    array_free(&scan);
}
END_TEST

/* Beside the wall the first rows' axes may not lean to where calm ones would. */
START_TEST(clear_of_wall)
{
    struct vec3s scan = {0};
    struct gouge_check *guard = floor_and_wall(25, &scan);
    struct axis_calm_options options = options_of(guard);
    struct rows r;
    int in_wall = 0;

    make_rows(&r);
    for (int k = 0; k < ROWS; k++) /* all but the first lean to the wall as far as may be */
        for (int i = 0; i < POINTS && k > 0; i++) {
            struct run_point *p = &r.point[k * POINTS + i];
            r.rule[k * POINTS + i] = vec_unit(vec(0, -tan(RADIANS(k > 3 ? 6 : 0)), 1));
            p->axis = k > 3 ? r.rule[k * POINTS + i] : vec_unit(vec(0, 0.02, 1));
            p->tip = vec_along(p->ball, -RADIUS, p->axis);
        }
    for (int i = 0; i < ROWS * POINTS; i++)
        in_wall += deepest(&scan, &r.point[i]) > TOLERANCE / 2 + SLACK;
    ck_assert_int_eq(in_wall, 0); /* as they were */
    axis_calm_chain(&options, r.run, ROWS);
    for (int i = 0; i < ROWS * POINTS; i++)
        ck_assert_double_le(deepest(&scan, &r.point[i]), TOLERANCE / 2 + SLACK);
    gouge_free(guard);
    array_free(&scan);
}
END_TEST

/* The sum of the squares of what the axis's turn changes from one half millimetre to the next. */
static double roughness(const struct rows *r)
{
    double sum = 0;

    for (int k = 0; k < ROWS; k++)
        for (int i = k * POINTS + 1; i + 1 < (k + 1) * POINTS; i++) {
            struct vec3 a = r->point[i - 1].axis, b = r->point[i].axis, c = r->point[i + 1].axis;
            struct vec3 change = vec_add(vec_sub(a, b), vec_sub(c, b));
            sum += vec_dot(change, change);
        }
    return sum;
}

/* The rule leans to the wall: beside it axes have to stand up, and jump there.  They come to that
 * slowly, and are as clear. */
START_TEST(slowly_past_a_wall)
{
    struct vec3s scan = {0};
    struct gouge_check *guard = floor_and_wall(25, &scan);
    struct axis_calm_options options = options_of(guard);
    struct rows r;

    make_rows(&r);
    for (int i = 0; i < ROWS * POINTS; i++) {
        struct run_point *p = &r.point[i];
        bool beside = p->ball.x > 4 && p->ball.x < 26;
        r.rule[i] = vec_unit(vec(0, -tan(RADIANS(15)), 1));
        p->axis = beside ? vec_unit(vec(0, -tan(RADIANS(1)), 1)) : r.rule[i];
        p->tip = vec_along(p->ball, -RADIUS, p->axis);
        ck_assert_double_le(deepest(&scan, p), TOLERANCE / 2 + SLACK);
    }
    double before = roughness(&r);
    axis_calm_chain(&options, r.run, ROWS);
    ck_assert_double_lt(roughness(&r), 0.001 * before);
    for (int i = 0; i < ROWS * POINTS; i++)
        ck_assert_double_le(deepest(&scan, &r.point[i]), TOLERANCE / 2 + SLACK);
    gouge_free(guard);
    array_free(&scan);
}
END_TEST

/* A link in the air leads from row to row, its axis 50 degrees off what theirs is by rule: the rows
 * themselves stay within play, for nothing is in their way. */
START_TEST(a_link_in_the_air_loosens_no_row)
{
    static struct rows r;
    struct vec3s copy = {0};
    struct gouge_check *guard = floor_and_wall(0, &copy);
    struct axis_calm_options options = options_of(guard);
    struct run_point link[5];
    struct axis_calm_run run[3];

    make_rows(&r);
    for (int i = 0; i < 5; i++) {
        struct run_point p = r.point[POINTS - 1];
        p.ball = vec_along(p.ball, 1 + 2 * i, vec(0, 0.1, 1));
        p.normal = vec(0, 0, 0);
        p.axis = vec_unit(vec(-1.5, tan(RADIANS(20)), 1));
        p.tip = vec_along(p.ball, -RADIUS, p.axis);
        link[i] = p;
    }
    run[0] = r.run[0];
    run[1] = (struct axis_calm_run){link, NULL, 5, 0, true};
    run[2] = r.run[1];
    run[2].joined = true;
    axis_calm_chain(&options, run, 3);
    for (int i = 0; i < 2 * POINTS; i++)
        ck_assert_double_le(vec_angle(r.point[i].axis, r.rule[i]), PLAY + RADIANS(1.5));
    gouge_free(guard);
    array_free(&copy);
}
END_TEST

/* A row leans over to the other side, through the upright axis in its middle, at 45 degrees from X
 * before it and at 65 behind: there C has no direction of its own, and passes at one between. */
START_TEST(over_the_pole)
{
    static struct rows r;
    struct vec3s copy = {0};
    struct gouge_check *guard = floor_and_wall(0, &copy);
    struct axis_calm_options options = options_of(guard);
    enum { MIDDLE = POINTS / 2 };

    make_rows(&r);
    for (int i = 0; i < POINTS; i++) {
        struct run_point *p = &r.point[i];
        double lean = RADIANS(10.0 * (i - MIDDLE) / MIDDLE), turn = RADIANS(i < MIDDLE ? 45 : 65);
        p->axis = vec(sin(lean) * cos(turn), sin(lean) * sin(turn), cos(lean));
        p->tip = vec_along(p->ball, -RADIUS, p->axis);
        r.rule[i] = p->axis;
    }
    axis_calm_chain(&options, r.run, 1);
    ck_assert_double_lt(hypot(r.point[MIDDLE].axis.x, r.point[MIDDLE].axis.y), 1e-9);
    struct vec3 before = r.point[MIDDLE - 1].axis, behind = r.point[MIDDLE + 1].axis;
    double from = atan2(-before.y, -before.x), to = atan2(behind.y, behind.x);
    ck_assert_double_lt(fabs(from - to), RADIANS(1));
    ck_assert_double_gt(from, RADIANS(45));
    ck_assert_double_lt(to, RADIANS(65));
    for (int i = 0; i < POINTS; i++)
        ck_assert_double_le(vec_angle(r.point[i].axis, r.rule[i]), PLAY + SLACK);
    gouge_free(guard);
    array_free(&copy);
}
END_TEST

/* A needle of points in the air, midway between two stations 12 mm apart: upright, the flute would
 * be clear of it at both and meet it on the way.  Axes that lean away there must go on to do so. */
/* An axis that is upright at one point of a row that leans leans with it, by itself; one that the
 * row goes over to its other side by stays. */
START_TEST(back_from_the_pole)
{
    for (int over = 0; over < 2; over++) {
        struct vec3s scan = {0};
        struct gouge_check *guard = floor_and_wall(0, &scan);
        struct axis_calm_options options = options_of(guard);
        const int at = POINTS / 2;
        struct rows r;
        make_rows(&r);
        for (int i = 0; i < POINTS; i++) {
            double lean = i == at ? 0 : tan(RADIANS(over && i > at ? -3 : 3));
            r.point[i].axis = vec_unit(vec(0, lean, 1));
            r.point[i].tip = vec_along(r.point[i].ball, -RADIUS, r.point[i].axis);
            r.rule[i] = vec_unit(vec(0, over && i > at ? -tan(RADIANS(3)) : tan(RADIANS(3)), 1));
        }
        axis_calm_chain(&options, r.run, 1);
        double leans = vec_angle(r.point[at].axis, vec(0, 0, 1));
        ck_assert(over ? leans <= 0 : leans > RADIANS(2));
        for (int i = 1; i < POINTS && !over; i++)
            ck_assert_double_lt(vec_angle(r.point[i - 1].axis, r.point[i].axis), RADIANS(0.5));
        gouge_free(guard);
        array_free(&scan);
    }
}
END_TEST

START_TEST(clear_on_the_way)
{
    enum { N = 8, BEFORE = 3 };
    struct vec3s needle = {0}, scan = {0};
    struct run_point point[N];
    struct vec3 rule[N];
    struct axis_calm_run run = {point, rule, N, RADIANS(40), false};
    double deep = -HUGE_VAL;

    for (int k = 0; k <= 40; k++) {
        *array_push(&needle) = vec(0, 2, 15 + k * 0.25);
        *array_push(&scan) = vec(0, 2, 15 + k * 0.25);
    }
    struct gouge_check *guard = gouge_new(needle, 1);
    struct axis_calm_options options = options_of(guard);
    for (int i = 0; i < N; i++) {
        bool away = i == BEFORE || i == BEFORE + 1;
        struct run_point p = {.contact = vec(12 * (i - BEFORE) - 6, 0, 0), .normal = vec(0, 0, 1)};
        p.ball = vec_along(p.contact, RADIUS, p.normal);
        p.axis = vec_unit(vec(0, -tan(RADIANS(away ? 30 : 1)), 1));
        p.tip = vec_along(p.ball, -RADIUS, p.axis);
        point[i] = p;
        rule[i] = vec_unit(vec(0, -tan(RADIANS(1)), 1));
        ck_assert_double_lt(deepest(&scan, &p), 0);
    }
    struct run_point upright = point[BEFORE];
    upright.axis = vec(0, 0, 1);
    ck_assert_double_lt(deepest(&scan, &upright), 0);
    axis_calm_chain(&options, &run, 1);
    for (int i = 0; i + 1 < N; i++)
        for (int k = 0; k <= 100; k++) {
            struct run_point p = {.ball = vec_mix(point[i].ball, point[i + 1].ball, k / 100.0)};
            p.axis = vec_unit(vec_mix(point[i].axis, point[i + 1].axis, k / 100.0));
            deep = fmax(deep, deepest(&scan, &p));
        }
    ck_assert_double_le(deep, TOLERANCE / 2 + SLACK);
    gouge_free(guard);
    array_free(&scan);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("axis_calm");
    TCase *tests = tcase_create("rows");

    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, alike);
    tcase_add_test(tests, own_play);
    tcase_add_test(tests, clear_of_wall);
    tcase_add_test(tests, slowly_past_a_wall);
    tcase_add_test(tests, a_link_in_the_air_loosens_no_row);
    tcase_add_test(tests, over_the_pole);
    tcase_add_test(tests, back_from_the_pole);
    tcase_add_test(tests, clear_on_the_way);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
