/* gouge_options: which scan guards a path, how closely it is looked at, and where the ball is: a
 * path over a floor, with the tip tracked or the centre, and one elsewhere. */
#include "stage/gouge_options.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "said.h"
#include "scratch.h"

static const double R = 4;
static struct error error;
static char name[300];
static struct vec3s points;

/* A floor at z = 2, a point each mm, as a file. */
static void setup(void)
{
    char *text = malloc(17 * 17 * 30);
    size_t at = 0;
    for (int i = -8; i <= 8; i++)
        for (int k = -8; k <= 8; k++) {
            at += (size_t)sprintf(text + at, "%d %d 2\n", i, k);
            *array_push(&points) = vec(i, k, 2);
        }
    snprintf(name, sizeof name, "%s", scratch_bytes(text, at));
    free(text);
}

static void teardown(void)
{
    array_free(&points);
}

/* Eight points along x, the ball's centre at this height. */
static struct path path_at(double z, enum path_track track)
{
    struct path path = {.name = "path"};
    path.head.cutter[0] = 2 * R;
    path.head.cutter[1] = R;
    path.head.cutter_n = 2;
    path.head.track = track;
    path.head.clearance = path.head.chord = NAN;
    double tip = track == TRACK_TIP ? z - R : z;
    for (int i = 0; i < 8; i++) {
        struct vec3 p = vec(i - 4, 0, tip);
        struct path_item *item = path_add_point(&path, (struct pose){p, {0, 0, 1}}, false);
        path_set_contact(&path, item, (struct contact){{p.x, p.y, z - R}, {0, 0, 1}});
    }
    return path;
}

static int read_options(const struct gouge_options *options, struct path *path, bool paper,
                        double tolerance, struct gouge_refit_options *refit)
{
    said_begin();
    int status = gouge_options_read(options, path, paper, tolerance, 1, refit, &error);
    said_end();
    return status;
}

/* The head names the scan; with `paper` only -g counts, and with --no-guard none. */
START_TEST(which_scan)
{
    for (int k = 0; k < 5; k++) {
        static const bool guards[] = {true, false, true, true, false};
        struct gouge_options options = {.noise = 0, .effort = 1};
        struct gouge_refit_options refit;
        struct path path = path_at(2 + R, TRACK_TIP);
        bool paper = k == 1 || k == 2;
        if (k != 3)
            scan_sources_add(&path.head.scan, name, points.item, points.n);
        if (k == 2 || k == 3)
            *array_push(&options.scan.files) = name;
        options.scan.none = k == 4;
        ck_assert_int_eq(read_options(&options, &path, paper, 0.02, &refit), 0);
        ck_assert_int_eq(refit.guard != NULL, guards[k]);
        ck_assert_double_eq(refit.radius, R);
        ck_assert_double_eq(refit.tolerance, 0.02);
        ck_assert(!refit.centre);
        ck_assert_uint_eq(path.head.scan.n, guards[k] ? 1 : 0);
        if (guards[k]) {
            ck_assert_uint_eq(path.head.scan.item[0].points, points.n);
            ck_assert_double_eq_tol(gouge_depth(refit.guard, vec(0.1, 0.2, 2 + R - 0.5), R), 0.5,
                                    0.02);
        }
        gouge_refit_free(&refit);
        array_free(&options.scan.files);
        path_free(&path);
    }
}
END_TEST

/* The tip is tracked, or the centre: both may be 3 R from the floor, and no more; below it or over
 * it alike. */
START_TEST(where_the_ball_is)
{
    static const struct {
        double z;
        enum path_track track;
        bool near;
    } row[] = {{2 + 2.9 * 4, TRACK_TIP, true},    {2 + 3.1 * 4, TRACK_TIP, false},
               {2 + 2.9 * 4, TRACK_CENTRE, true}, {2 + 3.1 * 4, TRACK_CENTRE, false},
               {2 - 2.9 * 4, TRACK_TIP, true},    {2 - 3.1 * 4, TRACK_TIP, false},
               {2 - 2.9 * 4, TRACK_CENTRE, true}, {2 - 3.1 * 4, TRACK_CENTRE, false}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        struct gouge_options options = {.noise = 0, .effort = 1};
        struct gouge_refit_options refit;
        struct path path = path_at(row[k].z, row[k].track);
        scan_sources_add(&path.head.scan, name, points.item, points.n);
        int status = read_options(&options, &path, false, 0.02, &refit);
        ck_assert_int_eq(status, row[k].near ? 0 : -1);
        ck_assert_int_eq(refit.centre, row[k].track == TRACK_CENTRE);
        if (status != 0)
            ck_assert_msg(
                strstr(error.text, "found 8 of 8 points of the path further than 12 mm") != NULL,
                "%s", error.text);
        gouge_refit_free(&refit);
        path_free(&path);
    }
}
END_TEST

/* How deep a ball gets between the points of the floor, for a path of which the last stage spent so
 * much (0: none did), mm. */
static double sunk(double spent)
{
    struct gouge_options options = {.noise = 0, .effort = 1};
    struct gouge_refit_options refit;
    struct path path = path_at(2 + R, TRACK_TIP);
    double most = 0;
    scan_sources_add(&path.head.scan, name, points.item, points.n);
    if (spent > 0) {
        path_spend(&path, "first", 3);
        path_spend(&path, "last", spent);
    }
    ck_assert_int_eq(read_options(&options, &path, false, 0.02, &refit), 0);
    for (int i = 0; i <= 40; i++)
        for (int j = 0; j <= 40; j++)
            most = fmax(most, -gouge_depth(refit.guard, vec(0.05 * i, 0.05 * j, 2 + R), R));
    gouge_refit_free(&refit);
    path_free(&path);
    return most;
}

/* Points are put between those of the scan as by the path's last stage, but no closer than for
 * a hundredth of the fitter's tolerance, 0.02, and no wider than for four times it. */
START_TEST(how_closely)
{
    const double fine = sunk(0.001), usual = sunk(0.02), wide = sunk(0.08);
    ck_assert(0 < fine && fine < 0.001 && fine < 0.8 * sunk(0.002));
    ck_assert(2 * fine < usual && usual < 0.02);
    ck_assert(2 * usual < wide && wide < 0.08);
    ck_assert_double_eq(sunk(0), usual);
    ck_assert_double_eq(sunk(0.00001), sunk(0.0002));
    ck_assert_double_eq(sunk(0.5), wide);
    /* in the middle of four points 1 mm apart, without points between */
    ck_assert_double_lt(wide, R - sqrt(R * R - 0.5));
}
END_TEST

/* Without a ball nothing is guarded, and a scan that is asked for is refused. */
START_TEST(no_ball)
{
    for (int k = 0; k < 4; k++) {
        struct gouge_options options = {.noise = 0, .effort = 1};
        struct gouge_refit_options refit;
        struct path path = path_at(2 + R, k % 2 ? TRACK_CONTACT : TRACK_TIP);
        if (k % 2 == 0)
            path.head.cutter[1] = R / 2;
        scan_sources_add(&path.head.scan, name, points.item, points.n);
        if (k >= 2)
            *array_push(&options.scan.files) = name;
        int status = read_options(&options, &path, false, 0.02, &refit);
        ck_assert_int_eq(status, k >= 2 ? -1 : 0);
        ck_assert_ptr_null(refit.guard);
        if (k >= 2)
            ck_assert_ptr_nonnull(strstr(error.text, "path: found no path of a ball cutter"));
        array_free(&options.scan.files);
        path_free(&path);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("gouge_options");
    TCase *tests = tcase_create("gouge_options");
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, which_scan);
    tcase_add_test(tests, where_the_ball_is);
    tcase_add_test(tests, how_closely);
    tcase_add_test(tests, no_ball);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
