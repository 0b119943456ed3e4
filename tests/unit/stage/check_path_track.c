/*
 * path_track: tip, centre and contact of one path of points, there and back; what is refused.
 */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "stage/path_track.h"

/* One rapid without contact, three points on a plane that leans, ball 4. */
static struct path leaning(void)
{
    struct path path = {.name = "t"};
    double cutter[7] = {8, 4, 0, 4, 0, 0, 60};

    memcpy(path.head.cutter, cutter, sizeof cutter);
    path.head.cutter_n = 7;
    struct vec3 axis = vec(0, 0, 1), normal = vec(0, 0.6, 0.8);
    path_add_point(&path, (struct pose){vec(0, 0, 50), axis}, true);
    for (int k = 0; k < 3; k++) {
        struct vec3 contact = vec(k, 8 * k, -6 * k);
        struct vec3 centre = vec_along(contact, 4, normal);
        struct path_item *item =
            path_add_point(&path, (struct pose){vec_along(centre, -4, axis), axis}, false);
        path_set_contact(&path, item, (struct contact){contact, normal});
    }
    return path;
}

START_TEST(there_and_back)
{
    struct path path = leaning();
    struct error error;

    ck_assert_int_eq(path_set_track(&path, TRACK_CENTRE, &error), 0);
    ck_assert(path.head.track == TRACK_CENTRE);
    ck_assert_double_eq_tol(path.item.item[0].to.p.z, 54, 1e-12);
    ck_assert_double_eq_tol(path.item.item[2].to.p.y, 8 + 4 * 0.6, 1e-12);
    ck_assert_double_eq_tol(path.item.item[2].to.p.z, -6 + 4 * 0.8, 1e-12);
    ck_assert_int_eq(path_set_track(&path, TRACK_TIP, &error), 0);
    ck_assert_double_eq_tol(path.item.item[2].to.p.z, -6 + 4 * 0.8 - 4, 1e-12);
    ck_assert_int_eq(path_set_track(&path, TRACK_CONTACT, &error), 0);
    ck_assert_double_eq_tol(path.item.item[0].to.p.z, 50, 1e-12);
    ck_assert(path.item.item[3].to.p.y == 16 && path.item.item[3].to.p.z == -12);
    ck_assert_int_eq(path_set_track(&path, TRACK_TIP, &error), -1);
    ck_assert(strstr(error.text, "a path of contact points") != NULL);
    path_free(&path);
}
END_TEST

START_TEST(refused)
{
    struct path path = leaning();
    struct error error;

    path.head.cutter[1] = 1;
    ck_assert_int_eq(path_set_track(&path, TRACK_CENTRE, &error), -1);
    ck_assert(strstr(error.text, "no ball cutter") != NULL);
    path.head.cutter[1] = 4;
    for (size_t i = 0; i < path.item.n; i++)
        path.item.item[i].touches = false;
    ck_assert_int_eq(path_set_track(&path, TRACK_CONTACT, &error), -1);
    ck_assert(strstr(error.text, "no contact points") != NULL);
    path_add_arc(&path, (struct pose){vec(1, 0, 0), vec(0, 0, 1)}, (struct path_arc){.radius = 1});
    ck_assert_int_eq(path_set_track(&path, TRACK_CENTRE, &error), -1);
    ck_assert(strstr(error.text, "expected points alone") != NULL);
    path_free(&path);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("path_track");
    TCase *tests = tcase_create("path_track");

    tcase_add_test(tests, there_and_back);
    tcase_add_test(tests, refused);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
