/* retrace: loops of passes over hollows narrower than the ball go, and all else stays. */
#include "toolpath/retrace.h"

#include <check.h>
#include <stdlib.h>

#include "curve/motion.h"

static const double R = 5;

/* A trough along y: flanks of 45 degrees that a circle of radius 2 joins at the bottom. */
static struct contact trough(double u)
{
    const double turn = 2 * RADIANS(45), half = turn; /* of the circle, by its length */
    double low = 2 * sqrt(2);

    if (fabs(u) <= half) {
        double a = u / 2;
        return (struct contact){vec(2 * sin(a), 0, low - 2 * cos(a)), vec(-sin(a), 0, cos(a))};
    }
    double side = u > 0 ? 1 : -1, x = sqrt(2) + (fabs(u) - half) / sqrt(2);
    return (struct contact){vec(side * x, 0, x), vec_unit(vec(-side, 0, 1))};
}

static struct gouge_check *guard_of_trough(void)
{
    struct vec3s points = {0};

    for (double u = -12; u <= 12; u += 0.1)
        for (double y = -3; y <= 3; y += 0.1) {
            struct vec3 p = trough(u).p;
            p.y = y;
            *array_push(&points) = p;
        }
    return gouge_new(points, 1);
}

static struct lifted_strip pass_across(const struct gouge_check *guard)
{
    const struct gouge_lift_options rule = {.guard = guard,
                                            .offset = R,
                                            .limit = R,
                                            .between = true,
                                            .tolerance = 0.01,
                                            .step = 0.05,
                                            .axis = {.kind = AXIS_LEAN},
                                            .feed = {.along = {1, 0, 0}, .side = {0, 1, 0}}};
    struct run run = {.radius = R};
    struct lifted_strip lifted = {.run = {.radius = R}};

    for (int i = -40; i <= 40; i++)
        gouge_lift_contact(&run, &rule, trough(0.25 * i).p, trough(0.25 * i).n);
    gouge_lift_run(&run, &rule, &lifted);
    array_free(&run);
    return lifted;
}

static struct retrace_options options_of(const struct gouge_check *guard)
{
    return (struct retrace_options){
        .offset = R, .tolerance = 0.01, .gap = 0.2 * R, .longest = 10 * R, .guard = guard};
}

/* How far the ball goes back against x, in all. */
static double back_of(const struct run *run)
{
    double back = 0;

    for (size_t i = 1; i < run->n; i++)
        back += fmax(0, run->item[i - 1].ball.x - run->item[i].ball.x);
    return back;
}

/* Each flank's centres run on over the other's offset; the two meet where the ball touches both. */
START_TEST(a_trough_too_narrow_is_passed_once)
{
    struct gouge_check *guard = guard_of_trough();
    struct retrace_options options = options_of(guard);
    struct lifted_strip lifted = pass_across(guard);
    struct vec3 both = vec(0, 0, R * sqrt(2));
    double nearest = HUGE_VAL;

    ck_assert_uint_eq(lifted.end.n, 1);
    ck_assert_double_gt(back_of(&lifted.run), 1);
    size_t n = lifted.run.n, gone = retrace_remove(&lifted, &options);
    ck_assert_uint_gt(gone, 10);
    ck_assert_uint_eq(lifted.run.n, n - gone);
    ck_assert_uint_eq(lifted.end.item[0], lifted.run.n);
    ck_assert_double_lt(back_of(&lifted.run), 0.1);
    for (size_t i = 0; i < lifted.run.n; i++) {
        const struct run_point *p = &lifted.run.item[i];
        nearest = fmin(nearest, vec_distance(p->ball, both));
        if (i > 0)
            ck_assert(gouge_clear_along(guard, p[-1].ball, p->ball, R, 0.01));
    }
    ck_assert_double_lt(nearest, 0.1);
    lifted_strip_free(&lifted);
    gouge_free(guard);
}
END_TEST

static struct run_point lifted_point(double x, double y, double lift)
{
    struct vec3 up = vec(0, 0, 1), contact = vec(x, y, 0);

    return (struct run_point){
        .ball = vec_along(contact, R + lift, up), .contact = contact, .normal = up};
}

/* There and back by 3 mm, lifted by so much; the fifth point by `odd`. */
static struct lifted_strip there_and_back(double lift, double odd)
{
    struct lifted_strip strip = {.run = {.radius = R}};

    *array_push(&strip.run) = lifted_point(-1, 0, 0);
    for (int i = 0; i <= 20; i++)
        *array_push(&strip.run) =
            lifted_point(0.3 * (i < 10 ? i : 20 - i), 0.01 * i, i == 5 ? odd : lift);
    *array_push(&strip.run) = lifted_point(-1, 0.4, 0);
    *array_push(&strip.end) = strip.run.n;
    return strip;
}

static size_t removed(struct lifted_strip strip, const struct gouge_check *guard)
{
    struct retrace_options options = options_of(guard);
    size_t n = retrace_remove(&strip, &options);

    lifted_strip_free(&strip);
    return n;
}

START_TEST(only_loops_that_touch_elsewhere_go)
{
    struct vec3 below = vec(0, 0, -1), between = vec(-0.3, 0.1, 1 + R);
    struct gouge_check *clear = gouge_from_points(&below, 1);
    struct gouge_check *blocked = gouge_from_points(&between, 1);

    ck_assert_uint_ge(removed(there_and_back(1, 1), clear), 18);
    ck_assert_uint_le(removed(there_and_back(1, 0.005), clear), 11); /* behind it alone */
    ck_assert_uint_eq(removed(there_and_back(0, 0), clear), 0);
    ck_assert_uint_eq(removed(there_and_back(1, 1), blocked), 0);
    gouge_free(clear);
    gouge_free(blocked);
}
END_TEST

/* What ends between two parts is no loop. */
START_TEST(parts_stay_apart)
{
    struct vec3 below = vec(0, 0, -1);
    struct gouge_check *guard = gouge_from_points(&below, 1);
    struct retrace_options options = options_of(guard);
    struct lifted_strip strip = there_and_back(1, 1);
    size_t n = strip.run.n;

    strip.end.n = 0;
    *array_push(&strip.end) = 11;
    *array_push(&strip.end) = n;
    ck_assert_uint_eq(retrace_remove(&strip, &options), 0);
    ck_assert_uint_eq(strip.end.item[0], 11);
    ck_assert_uint_eq(strip.end.item[1], n);
    lifted_strip_free(&strip);
    gouge_free(guard);
}
END_TEST

/* Points each 0.5 mm along x, then one `aside` mm to the side of the last and back by `back`, and
 * on along y; all lifted by so much. */
static struct lifted_strip with_hook(double aside, double back, double lift)
{
    struct lifted_strip strip = {.run = {.radius = R}};

    for (int i = 0; i <= 4; i++)
        *array_push(&strip.run) = lifted_point(0.5 * i, 0, lift);
    *array_push(&strip.run) = lifted_point(2 - back, aside, lift);
    for (int i = 1; i <= 4; i++)
        *array_push(&strip.run) = lifted_point(2, aside + 0.5 * i, lift);
    *array_push(&strip.end) = strip.run.n;
    return strip;
}

static size_t hooks_of(struct lifted_strip strip, const struct gouge_check *guard)
{
    struct retrace_options options = options_of(guard);
    size_t n = strip.run.n, gone = retrace_hooks(&strip, &options);

    ck_assert_uint_eq(strip.run.n, n - gone);
    ck_assert_uint_eq(strip.end.item[0], n - gone);
    for (size_t i = 1; gone > 0 && i < strip.run.n; i++)
        ck_assert_double_gt(vec_distance(strip.run.item[i - 1].ball, strip.run.item[i].ball), 0.02);
    lifted_strip_free(&strip);
    return gone;
}

/* Points each 0.5 mm along x that touch nothing, the fourth and the sixth thrown up so far. */
static struct lifted_strip with_spikes(double up)
{
    struct lifted_strip strip = {.run = {.radius = R}};

    for (int i = 0; i <= 8; i++) {
        *array_push(&strip.run) = lifted_point(0.5 * i, 0, i == 4 || i == 6 ? up : 0.1);
        strip.run.item[i].normal = vec(0, 0, 0);
    }
    *array_push(&strip.end) = strip.run.n;
    return strip;
}

/* One contact under an overhang is lifted over all of it: the way goes past it, or ends there. */
START_TEST(spikes_go)
{
    struct vec3 below = vec(0, 0, -1), beside = vec(2, 0, 0.3 + R);
    struct gouge_check *clear = gouge_from_points(&below, 1);
    struct gouge_check *blocked = gouge_from_points(&beside, 1);
    struct retrace_options past = options_of(clear), ends = options_of(blocked);
    struct lifted_strip strip = with_spikes(2 * R), low = with_spikes(0.9 * R);

    ck_assert_uint_eq(retrace_spikes(&strip, &past), 2);
    ck_assert_uint_eq(strip.run.n, 7);
    ck_assert_uint_eq(strip.end.n, 1);
    ck_assert_uint_eq(strip.end.item[0], 7);
    lifted_strip_free(&strip);
    strip = with_spikes(2 * R);
    ck_assert_uint_eq(retrace_spikes(&strip, &ends), 2);
    ck_assert_uint_eq(strip.run.n, 7);
    ck_assert_uint_eq(strip.end.item[0], 4);
    ck_assert_uint_eq(strip.end.item[strip.end.n - 1], 7);
    for (size_t i = 0; i < strip.run.n; i++)
        ck_assert_double_lt(strip.run.item[i].ball.z, R + 1);
    ck_assert_uint_eq(retrace_spikes(&low, &past), 0);
    low.run.item[4].normal = vec(0, 0, 1); /* it cuts there */
    low.run.item[4].ball.z += 2 * R;
    ck_assert_uint_eq(retrace_spikes(&low, &past), 0);
    lifted_strip_free(&strip);
    lifted_strip_free(&low);
    gouge_free(clear);
    gouge_free(blocked);
}
END_TEST

START_TEST(hooks_go)
{
    struct vec3 below = vec(0, 0, -1), beside = vec(1.7, 0.2, 1 + R);
    struct gouge_check *clear = gouge_from_points(&below, 1);
    struct gouge_check *blocked = gouge_from_points(&beside, 1);

    ck_assert_uint_eq(hooks_of(with_hook(0.01, 0.01, 1), clear), 1);
    ck_assert_uint_eq(hooks_of(with_hook(0.01, 0.01, 1), blocked), 0);
    ck_assert_uint_eq(hooks_of(with_hook(0.03, 0.01, 1), clear), 0);   /* long enough */
    ck_assert_uint_eq(hooks_of(with_hook(0.008, 0.008, 0), clear), 1); /* hardly off the way */
    ck_assert_uint_eq(hooks_of(with_hook(0.001, 0.018, 0), clear), 0);
    ck_assert_uint_eq(hooks_of(with_hook(0.001, 0.018, 1), clear), 1);
    ck_assert_uint_eq(hooks_of(with_hook(0.1, 0, 1), clear), 0); /* a corner is none */
    gouge_free(clear);
    gouge_free(blocked);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("retrace");
    TCase *tests = tcase_create("retrace");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, a_trough_too_narrow_is_passed_once);
    tcase_add_test(tests, only_loops_that_touch_elsewhere_go);
    tcase_add_test(tests, parts_stay_apart);
    tcase_add_test(tests, hooks_go);
    tcase_add_test(tests, spikes_go);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
