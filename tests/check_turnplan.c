/* turnplan: turns back along spirals are as few as arithmetic allows, angles stay in the travel
 * and have the directions, and what cannot be is refused. */
#include <check.h>
#include <stdlib.h>

#include "array.h"
#include "turnplan.h"

enum { EACH = 72 }; /* places of one turn */

static struct chain table_ac(double a_min, double a_max, double c_min, double c_max)
{
    return (struct chain){
        .n = 2,
        .master = 1,
        .tool = {0, 0, 1},
        .rotary = {{{0, 0, 1}, {0, 0, 0}, true, RADIANS(c_min), RADIANS(c_max)},
                   {{1, 0, 0}, {0, 0, 0}, true, RADIANS(a_min), RADIANS(a_max)}}};
}

/* So many turns of a direction at this tilt. */
static struct turnplan_place *spiral(int turns, double tilt, size_t *n)
{
    *n = (size_t)(turns * EACH) + 1;
    struct turnplan_place *place = mem_alloc(*n, sizeof *place);
    for (size_t i = 0; i < *n; i++) {
        double w = 2 * PI * (double)i / EACH, s = sin(RADIANS(tilt));
        place[i].axis = vec(s * sin(w), -s * cos(w), cos(RADIANS(tilt))); /* C is w, A the tilt */
        place[i].may_turn = true;
    }
    return place;
}

static void check_places(const struct chain *chain, const struct turnplan_place *place, size_t n,
                         int turns)
{
    int counted = 0;
    for (size_t i = 0; i < n; i++) {
        for (int k = 0; k < 2; k++) {
            ck_assert_double_ge(place[i].q[k], chain->rotary[k].min - 1e-9);
            ck_assert_double_le(place[i].q[k], chain->rotary[k].max + 1e-9);
            if (i > 0 && !place[i - 1].turn)
                ck_assert_double_lt(fabs(place[i].q[k] - place[i - 1].q[k]), PI / 2);
        }
        ck_assert_double_lt(vec_angle(chain_axis(chain, place[i].q), place[i].axis), 1e-9);
        counted += place[i].turn;
    }
    ck_assert_int_eq(counted, turns);
}

static const struct {
    int turns;
    double tilt, a_min, a_max, c_min, c_max;
    int back;
} wound[] = {
    {5, 50, -30, 120, -360, 360, 2}, /* -360 to 360, twice back by 720, and half of it */
    {5, 50, -120, 120, -360, 360, 2},
    {3, 20, -30, 120, -360, 360, 1},
    {2, 20, -30, 120, -360, 360, 0}, /* just so */
    {5, 50, -60, 120, -900, 900, 0}, /* just so, with A -50 and C a half turn on */
    {5, 50, -30, 120, -900, 900, 1}, /* A 50 alone starts at C -720 */
    {5, 50, -30, 120, -99999, 99999, 0},
    {5, 50, -30, 120, -200, 210, 5}, /* 0 to 210, then 360 each time */
    {1, 50, -30, 120, -190, 190, 1},
    {4, 110, -120, 30, -720, 0, 2}, /* A -110 starts at C -540 */
};

START_TEST(fewest_turns)
{
    struct chain chain = table_ac(wound[_i].a_min, wound[_i].a_max, wound[_i].c_min,
                                  wound[_i].c_max);
    const double from[ROTARY_MAX] = {0};
    size_t n;
    struct turnplan_place *place = spiral(wound[_i].turns, wound[_i].tilt, &n);
    int turns = turnplan_make(&chain, place, n, from);
    ck_assert_int_eq(turns, wound[_i].back);
    check_places(&chain, place, n, turns);
    free(place);
}
END_TEST

START_TEST(no_way)
{
    struct chain chain = table_ac(-30, 40, -360, 360), narrow = table_ac(-60, 60, -80, 80);
    const double from[ROTARY_MAX] = {0};
    size_t n;
    struct turnplan_place *place = spiral(1, 50, &n);
    ck_assert_int_eq(turnplan_make(&chain, place, n, from), -1);
    ck_assert_int_eq(turnplan_make(&narrow, place, n, from), -1);
    free(place);
}
END_TEST

/* Straight over the pole: A goes on through zero where it may, else there is one turn back. */
START_TEST(over_the_pole)
{
    const double from[ROTARY_MAX] = {0};
    struct turnplan_place place[61];
    for (int i = 0; i < 61; i++) {
        double w = RADIANS(i - 30);
        place[i] = (struct turnplan_place){.axis = {0, sin(w), cos(w)}, .may_turn = true};
    }
    struct chain both = table_ac(-120, 120, -360, 360), one = table_ac(-5, 120, -360, 360);
    ck_assert_int_eq(turnplan_make(&both, place, 61, from), 0);
    check_places(&both, place, 61, 0);
    for (int i = 1; i < 61; i++)
        ck_assert_double_eq_tol(place[i].q[0], place[0].q[0], 1e-9);
    ck_assert_int_eq(turnplan_make(&one, place, 61, from), 1);
    check_places(&one, place, 61, 1);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("turnplan");
    TCase *tests = tcase_create("plans");

    tcase_add_loop_test(tests, fewest_turns, 0, (int)(sizeof wound / sizeof *wound));
    tcase_add_test(tests, no_way);
    tcase_add_test(tests, over_the_pole);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
