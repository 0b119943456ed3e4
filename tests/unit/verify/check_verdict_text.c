/*
 * check_verdict_text - a verdict whose figures are known, written as a table and as points: each
 * figure stands in its line.
 */
#include <check.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "over_plane.h"
#include "scratch.h"

static struct vec3s part;
static struct nc_motion motion;
static char *text;

/* Rows 0.2 mm deep in the plane, the last of them without a number. */
static void setup(void)
{
    part = plane();
    motion = rows(-0.2, 5);
    motion.piece.item[motion.piece.n - 2].block = -1;
}

static void teardown(void)
{
    free(text);
    text = NULL;
    nc_motion_free(&motion);
    array_free(&part);
}

static void write_text(const struct verdict *v)
{
    size_t n;
    free(text);
    verdict_text(v, scratch_name());
    text = scratch_read(&n);
}

static int lines_with(const char *what)
{
    int n = 0;
    for (const char *at = text; (at = strstr(at, what)); at += strlen(what))
        n++;
    return n;
}

#define ASSERT_HAS(what) \
    ck_assert_msg(strstr(text, what) != NULL, "no `%s` in\n%.1500s", what, text)

/* The line as the numbers say it. */
__attribute__((format(printf, 1, 2))) static void assert_line(const char *format, ...)
{
    char line[300];
    va_list args;
    va_start(args, format);
    vsnprintf(line, sizeof line, format, args);
    va_end(args);
    ASSERT_HAS(line);
}

START_TEST(way_and_time_are_those_of_the_pieces)
{
    double length[2] = {0, 0};
    for (size_t i = 0; i < motion.piece.n; i++)
        length[motion.piece.item[i].rapid] +=
            vec_distance(motion.piece.item[i].p[0], motion.piece.item[i].p[1]);
    motion.blocks = 12;
    motion.lines = 7;
    motion.arcs = 3;
    motion.curves = 2;
    motion.dwell = 0.25;
    struct verdict v = judge(&motion, &part, NULL);
    write_text(&v);
    assert_line("program      rows: by hand, 12 lines; 7 straight, 3 arcs, 2 curves\n");
    assert_line("machine      none\n");
    assert_line("way          %.1f mm in 89 cuts from rapid to rapid, %.1f mm rapid\n", length[0],
                length[1]);
    /* at 1,000 mm/min, and rapid as fast as the axes can */
    assert_line("time         %.2f min at feed, %.2f min rapid, 0.25 min dwell\n", length[0] / 1000,
                v.axes.rapid_time);
    assert_line("travel X     -16.000 to 16.000\n");
    assert_line("travel Y     -11.000 to 11.000\n");
    assert_line("travel Z     -0.200 to 20.000\n");
    ck_assert_ptr_null(strstr(text, "travel A"));
    ck_assert_ptr_null(strstr(text, "least time"));
    ck_assert_ptr_null(strstr(text, "stock "));
    verdict_free(&v);
    motion.dwell = 0;
    v = judge(&motion, &part, NULL);
    write_text(&v);
    ck_assert_ptr_null(strstr(text, "dwell"));
    verdict_free(&v);
}
END_TEST

START_TEST(least_time_and_turns)
{
    struct verdict v = judge(&motion, &part, NULL);
    v.time.least = 3;
    v.time.programmed = 2;
    v.time.slow = 0.125;
    v.time.rapid = 0.75;
    v.time.turn[4] = 123;
    v.time.worst[0] = 1;
    v.time.lost[0] = 1.5;
    v.time.worst[1] = motion.piece.n - 2;
    v.time.lost[1] = 1.25;
    v.axes.jump = (struct axis_peak){12.5, 3, 2};
    v.axes.turn_rate = (struct axis_peak){2.25, 5, 5};
    write_text(&v);
    ASSERT_HAS("least time   3.00 min at feed, 1.50 times length by feed (2.00 min); 12.5 % of the "
               "way below half the feed; 0.75 min rapid\n");
    ASSERT_HAS("turned       B 123 degrees in all\n");
    ck_assert_int_eq(lines_with("turned "), 1);
    ASSERT_HAS("slow         1.50 s lost in N20 (line 2)\n");
    assert_line("slow         1.25 s lost in line %zu\n", motion.piece.n - 1);
    ck_assert_int_eq(lines_with("slow "), 2);
    ASSERT_HAS("turn         axis A by at most 12.500 degrees in a block, N30 (line 3)\n");
    ASSERT_HAS("swing        axis C by at most 2.250 degrees a mm, N60 (line 6)\n");
    verdict_free(&v);
}
END_TEST

/* Too deep by 0.2 mm everywhere, so that all points are gouged and nothing is left. */
START_TEST(gouges_and_what_is_left)
{
    struct verdict v = judge(&motion, &part, NULL);
    write_text(&v);
    assert_line("part         %zu points\n", part.n);
    assert_line("coverage     cut %zu points, %.1f mm2 (within 0.051 mm)\n", part.n,
                v.coverage.sum[COVERAGE_CUT].area);
    ASSERT_HAS("coverage     left 0 points, 0.0 mm2\n");
    ASSERT_HAS("coverage     out of reach 0 points, 0.0 mm2\n");
    ASSERT_HAS("coverage     kept off 0 points, 0.0 mm2\n");
    assert_line("gouge        worst %.4f mm at ", v.map.gouge);
    assert_line("; %zu points deeper than the tolerance\n", part.n);
    ck_assert_double_eq_tol(v.map.gouge, 0.2, 0.0021);
    ck_assert_int_eq(lines_with("gouge        0.20"), 5); /* the five worst blocks */
    ASSERT_HAS("left         worst 0.0000 mm at ");
    ASSERT_HAS("; 0 points above the tolerance");
    ck_assert_int_eq(lines_with("fault  "), 1);
    ASSERT_HAS("verdict      refused\n");
    verdict_free(&v);

    nc_motion_free(&motion);
    motion = rows(0.06, 5);
    v = judge(&motion, &part, NULL);
    write_text(&v);
    ASSERT_HAS("coverage     cut 0 points");
    assert_line("coverage     left %zu points, ", part.n);
    assert_line(" mm2, most %.4f mm at ", v.map.over);
    assert_line("; %zu points above the tolerance", part.n);
    ck_assert_int_eq(lines_with("left         0.06"), 5);
    verdict_free(&v);
}
END_TEST

START_TEST(a_scan_has_noise_and_outliers)
{
    struct vec3 high = {0, 0, 1};
    struct verify_surface scan = {.noise = 0.004, .outliers = {.n = 1, .item = &high}};
    struct verify_program program = {.file = "rows",
                                     .control = "by hand",
                                     .machine = "none",
                                     .motion = &motion,
                                     .part = &part,
                                     .surface = &scan,
                                     .post = -1,
                                     .axis = -1,
                                     .made_for = ""};
    struct verify_options options = {.radius = RADIUS,
                                     .tolerance = 0.01,
                                     .left = 0.05,
                                     .partial = true,
                                     .band = 1,
                                     .limits = wide,
                                     .threads = 1};
    struct verdict v = verify_run(&program, &options);
    write_text(&v);
    assert_line("part         %zu points, %zu of them in the region cut, noise 0.0040 mm, 1 "
                "outliers\n",
                part.n, part.n);
    /* the point 1 mm up is 1.2 mm in the ball */
    ck_assert_uint_eq(v.outliers.gouged, 1);
    ck_assert_double_eq_tol(v.outliers.depth, 1.2, 0.003);
    ck_assert_double_eq(v.outliers.at.z, 1);
    ck_assert_double_eq(v.noise, 0.006);
    ck_assert_ptr_null(strstr(text, "coverage "));
    verdict_free(&v);
}
END_TEST

/* 1.2 mm off a block of 20 x 20 mm: what is over the part, 400 mm2. */
START_TEST(stock_cut_by_cut)
{
    struct stock_options stock = {
        .kind = STOCK_BETWEEN, .low = {-10, -10, -3}, .high = {10, 10, 1}};
    struct verdict v = judge(&motion, &part, &stock);
    write_text(&v);
    assert_line("stock        1600.0 mm3, %.1f left; columns 0.250 mm apart\n", v.stock.after);
    ck_assert_double_eq_tol(v.stock.after, 1120, 3);
    ck_assert_int_eq(lines_with("stock        cut "), 89);
    ASSERT_HAS("stock        cut 1, N20 (line 2) to N30 (line 3): ");
    ASSERT_HAS(" in N30 (line 3), air in ");
    assert_line("stock        cut 89, N%zu (line %zu) to line %zu: ", 10 * (motion.piece.n - 2),
                motion.piece.n - 2, motion.piece.n - 1);
    double off = 0, one, way = 0, of;
    size_t air = 0, blocks = 0, n, all;
    for (const char *at = text; (at = strstr(at, "stock        cut ")); at++) {
        const char *end = strchr(at, '\n'), *volume = strstr(at, ": "),
                   *idle = strstr(at, "air in ");
        ck_assert(volume && volume < end && idle && idle < end);
        ck_assert_int_eq(sscanf(volume, ": %lf mm3 off", &one), 1);
        off += one;
        ck_assert_int_eq(
            sscanf(idle, "air in %zu of %zu blocks (%lf of %lf mm)", &n, &all, &one, &of), 4);
        air += n;
        blocks += all;
        way += of;
    }
    ck_assert_double_eq_tol(off, v.stock.before - v.stock.after, 89 * 0.05);
    assert_line("stock        air in %zu of %zu blocks (", air, blocks);
    ck_assert_uint_eq(blocks, 2 * 89);
    ck_assert_double_eq_tol(way, 89 * (5.2 + 32), 89 * 0.05);
    ck_assert_ptr_nonnull(
        strstr(strstr(text, "stock        air in "), "stock        left 0.0000 mm"));
    verdict_free(&v);
}
END_TEST

/* As points: the place, a colour by the deviation, the block. */
START_TEST(points_with_colours)
{
    struct verdict v = judge(&motion, &part, NULL);
    v.map.region[1] = 0;
    v.map.deviation[2] = 0;
    v.map.deviation[3] = 0.025; /* half of what may be left */
    v.map.deviation[4] = HUGE_VAL;
    v.map.segment[4] = UINT32_MAX;
    size_t n, vertices, count = 0;
    verdict_map(&v, scratch_name());
    text = scratch_read(&n);
    char *at = strstr(text, "element vertex "), *body = strstr(text, "end_header\n");
    ck_assert(at && body && sscanf(at, "element vertex %zu", &vertices) == 1);
    ck_assert_uint_eq(vertices, part.n);
    body = strchr(body, '\n') + 1;
    for (; *body; body = strchr(body, '\n') + 1, count++) {
        double x, y, z, deviation;
        int red, green, blue, block, class;
        ck_assert_int_eq(sscanf(body, "%lf %lf %lf %d %d %d %lf %d %*f %*f %d", &x, &y, &z, &red,
                                &green, &blue, &deviation, &block, &class),
                         9);
        struct vec3 p = part.item[count];
        ck_assert(fabs(x - p.x) < 1e-6 && fabs(y - p.y) < 1e-6 && fabs(z - p.z) < 1e-6);
        static const int grey[3] = {130, 130, 130}, cut[3] = {70, 170, 90}, deep[3] = {220, 30, 30},
                         half[3] = {55, 130, 155};
        const int *want = count == 1 || count == 4 ? grey
                          : count == 2             ? cut
                          : count == 3             ? half
                                                   : deep;
        ck_assert_msg(red == want[0] && green == want[1] && blue == want[2], "%zu: %d %d %d", count,
                      red, green, blue);
        ck_assert_int_eq(block == -1, count == 4);
        ck_assert_double_eq_tol(deviation,
                                count == 2   ? 0
                                : count == 3 ? 0.025
                                : count == 4 ? 1e6
                                             : -0.2,
                                0.003);
    }
    ck_assert_uint_eq(count, part.n);
    verdict_free(&v);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("verdict_text");
    TCase *tcase = tcase_create("verdict_text");
    tcase_add_checked_fixture(tcase, setup, teardown);
    tcase_add_test(tcase, way_and_time_are_those_of_the_pieces);
    tcase_add_test(tcase, least_time_and_turns);
    tcase_add_test(tcase, gouges_and_what_is_left);
    tcase_add_test(tcase, a_scan_has_noise_and_outliers);
    tcase_add_test(tcase, stock_cut_by_cut);
    tcase_add_test(tcase, points_with_colours);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
