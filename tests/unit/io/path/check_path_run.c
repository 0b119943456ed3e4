/*
 * path_run: the tip, the centre and the axis, whichever of them the path tracks.
 */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "io/path/path_run.h"

static struct path two_points(enum path_track track)
{
    struct path path = {.name = "test"};
    const double cutter[7] = {16, 8, 0, 8, 0, 0, 60};
    struct vec3 axis = vec(0, 0.6, 0.8);

    memcpy(path.head.cutter, cutter, sizeof cutter);
    path.head.cutter_n = 7;
    path.head.track = track;
    path_add_point(&path, (struct pose){{1, 2, 3}, axis}, false);
    struct path_item *item = path_add_point(&path, (struct pose){{4, 5, 6}, axis}, false);
    path_set_contact(&path, item, (struct contact){{7, 8, 9}, {1, 0, 0}});
    return path;
}

START_TEST(tip_and_centre)
{
    const enum path_track track[] = {TRACK_TIP, TRACK_CENTRE, TRACK_CONTACT};

    for (int i = 0; i < 3; i++) {
        struct path path = two_points(track[i]);
        struct run run = path_run_read(&path, 0, 2);
        struct vec3 up = vec(0, 4.8, 6.4);

        ck_assert_uint_eq(run.n, 2);
        ck_assert(run.radius == (track[i] == TRACK_CONTACT ? 0 : 8));
        struct run_point p = run.item[0];
        ck_assert(p.given && p.axis.y == 0.6 && vec_length(p.normal) == 0);
        struct vec3 tip = track[i] == TRACK_CENTRE ? vec_sub(vec(1, 2, 3), up) : vec(1, 2, 3);
        struct vec3 ball = track[i] == TRACK_TIP ? vec_add(vec(1, 2, 3), up) : vec(1, 2, 3);
        ck_assert_double_lt(vec_distance(p.tip, tip), 1e-14);
        ck_assert_double_lt(vec_distance(p.ball, ball), 1e-14);
        ck_assert(run.item[1].normal.x == 1 && run.item[1].contact.z == 9);
        array_free(&run);
        path_free(&path);
    }
}
END_TEST

START_TEST(without_a_ball)
{
    struct path path = two_points(TRACK_TIP);

    path.head.cutter_n = 0;
    struct run run = path_run_read(&path, 0, 2);
    ck_assert(run.radius == 0);
    ck_assert(vec_distance(run.item[0].tip, run.item[0].ball) == 0);
    array_free(&run);
    path_free(&path);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("path_run");
    TCase *tests = tcase_create("path_run");

    tcase_add_test(tests, tip_and_centre);
    tcase_add_test(tests, without_a_ball);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
