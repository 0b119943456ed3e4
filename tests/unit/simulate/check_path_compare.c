/*
 * check_path_compare - a program against its path: the same is the same, approach and retract
 * apart; a place, an axis, a feed that is off is told with how much, and what is left out.
 */
#include <check.h>
#include <stdlib.h>

#include "base/array.h"
#include "simulate/path_compare.h"

static const struct path_compare_options options = {5, 0.01, 0.005, 1.5, 200, NULL, false};

/* Ten straight pieces of 2 mm along x, the axis leaning over more and more. */
static struct nc_motion row(double y, bool links)
{
    struct nc_motion motion = {.kinematics = {.tool = {0, 0, 1}}};
    struct vec3 a = {0, 0, 1}, up = vec(0, y, 30);
    if (links) {
        *array_push(&motion.piece) = (struct nc_piece){.rapid = true, .p = {up, up}, .q = {a, a}};
        *array_push(&motion.piece) =
            (struct nc_piece){.feed = 200, .p = {up, vec(0, y, 0)}, .q = {a, a}};
    }
    for (int i = 0; i < 10; i++) {
        struct vec3 b = vec_unit(vec(0.02 * (i + 1), 0, 1));
        *array_push(&motion.piece) = (struct nc_piece){
            .feed = 800, .p = {vec(2 * i, y, 0), vec(2 * i + 2, y, 0)}, .q = {a, b}};
        a = b;
    }
    return motion;
}

START_TEST(the_same_is_the_same)
{
    struct nc_motion path = row(0, false), program = row(0, true);
    struct path_compare found = path_compare_run(&program, &path, &options);
    ck_assert_uint_eq(found.off.count + found.turned.count + found.missed.count, 0);
    ck_assert_uint_eq(found.fast.count + found.slow.count, 0);
    nc_motion_free(&path);
    nc_motion_free(&program);
}
END_TEST

/* A part of a program, pieces 3 to 6 of ten: what comes before and after is another's; what it
 * leaves out amid them is missed. */
START_TEST(a_part_of_the_path)
{
    struct nc_motion path = row(0, false), program = row(0, false);
    struct path_compare_options part = options;
    part.part = _i > 0;
    program.piece.n = 6;
    for (size_t i = 2; i < 6; i++)
        program.piece.item[i - 2] = program.piece.item[i];
    program.piece.n = 4;
    for (size_t k = 0; _i == 2 && k < 2; k++) { /* a detour of the path that the program has not */
        struct nc_piece *p = &path.piece.item[3 + k];
        p->p[1 - k].y = 3;
    }
    struct path_compare found = path_compare_run(&program, &path, &part);
    ck_assert_int_eq(found.missed.count > 0, _i != 1);
    ck_assert_int_eq(found.beyond.count > 0, _i > 0);
    nc_motion_free(&path);
    nc_motion_free(&program);
}
END_TEST

/* Its inverse time is the path's: digits that make one piece twice as long make it twice as fast,
 * as far as the tolerance says that they may. */
START_TEST(inverse_time_is_as_good_as_digits)
{
    struct nc_motion path = row(0, false), program = row(0, false);
    struct path_compare_options coarse = options;

    for (size_t i = 0; i < 10; i++) {
        program.piece.item[i].inverse = true;
        program.piece.item[i].feed = 800 / 2.0 * (i == 4 ? 2 : 1); /* one in a minute */
    }
    struct path_compare found = path_compare_run(&program, &path, &coarse);
    ck_assert_double_eq_tol(found.fast.value, 2, 1e-9);
    ck_assert_uint_eq(found.fast.piece, 4);
    coarse.tolerance = 0.4;
    found = path_compare_run(&program, &path, &coarse);
    ck_assert_uint_eq(found.fast.count, 0);
    nc_motion_free(&path);
    nc_motion_free(&program);
}
END_TEST

START_TEST(what_is_off_is_told)
{
    struct nc_motion path = row(0, false), program = row(0, true);
    program.piece.item[6].p[1].z = program.piece.item[7].p[0].z = 0.02;
    struct path_compare found = path_compare_run(&program, &path, &options);
    ck_assert_double_eq_tol(found.off.value, 0.02, 1e-9);
    ck_assert_uint_eq(found.off.piece, 6);
    program.piece.item[6].p[1].z = program.piece.item[7].p[0].z = 0;
    struct vec3 turned = vec_unit(vec(0.1, 0.02, 1));
    program.piece.item[6].q[1] = program.piece.item[7].q[0] = turned;
    found = path_compare_run(&program, &path, &options);
    ck_assert_uint_eq(found.off.count, 0);
    ck_assert_double_eq_tol(found.turned.value, 0.02 / sqrt(1.01), 1e-4);
    program.piece.item[6].feed = 8000;
    found = path_compare_run(&program, &path, &options);
    ck_assert_double_eq_tol(found.fast.value, 10, 1e-9);
    ck_assert_uint_eq(found.fast.piece, 6);
    program.piece.item[6].feed = 0.8;
    found = path_compare_run(&program, &path, &options);
    ck_assert_double_eq_tol(found.slow.value, 1000, 1e-6);
    program.piece.n = 8; /* the last pieces are left out */
    found = path_compare_run(&program, &path, &options);
    ck_assert_double_eq_tol(found.missed.value, 8, 0.6);
    nc_motion_free(&path);
    nc_motion_free(&program);
}
END_TEST

/* One piece of 0.5 mm on which the axis leans over by a tenth of a radian, its tip moved along
 * itself. */
static struct nc_motion lean_over(double moved)
{
    struct nc_motion motion = {.kinematics = {.tool = {0, 0, 1}}};
    *array_push(&motion.piece) = (struct nc_piece){.feed = 800,
                                                   .interpolation = AXIS_GREAT_CIRCLE,
                                                   .p = {{moved, 0, 0}, {0.5 + moved, 0, 0}},
                                                   .q = {{0, 0, 1}, {sin(0.1), 0, cos(0.1)}}};
    return motion;
}

START_TEST(an_axis_that_the_path_has_within_the_tolerance_of_the_tip)
{
    struct nc_motion path = lean_over(0), near = lean_over(0.0085), off = lean_over(0.025);
    struct path_compare_options narrow = options;
    narrow.axis = 0.001;
    struct path_compare found = path_compare_run(&near, &path, &narrow);
    ck_assert_uint_eq(found.turned.count, 0);
    found = path_compare_run(&off, &path, &narrow); /* 0.015 mm too far: 0.003 radians */
    ck_assert_double_gt(found.turned.value, 0.0025);
    ck_assert_double_lt(found.turned.value, 0.0035);
    nc_motion_free(&path);
    nc_motion_free(&near);
    nc_motion_free(&off);
}
END_TEST

/* A straight tip that goes as s^2 while the axis turns evenly with s: in as many lines as there are
 * of `parts`, or as one polynomial. */
static struct nc_motion uneven(int parts)
{
    struct nc_motion motion = {.kinematics = {.tool = {0, 0, 1}}};
    struct vec3 p = {0, 0, 0}, q = {0, 0, 100};
    for (int i = 1; i <= parts; i++) {
        double s = (double)i / parts;
        struct vec3 to = {s * s, 0, 0}, head = {s * s + 7 * s, 0, 100};
        struct nc_piece piece = {.feed = 800,
                                 .interpolation = AXIS_BY_HEAD,
                                 .shape = parts > 1 ? SHAPE_LINE : SHAPE_POLYNOMIAL,
                                 .p = {p, to},
                                 .q = {q, head}};
        *array_push(&motion.piece) = piece;
        p = to;
        q = head;
    }
    *array_push(&motion.polynomial) = (struct nc_motion_polynomial){
        .p = {{0, 0, 0}, {1, 0, 0}}, .q = {{7, 0, 0}, {1, 0, 0}}, .turns = true};
    return motion;
}

START_TEST(an_axis_that_turns_unevenly_with_the_tip)
{
    struct nc_motion path = uneven(2000), program = uneven(1);
    struct path_compare_options narrow = options;
    narrow.tolerance = 0.001;
    narrow.axis = RADIANS(0.02);
    struct path_compare found = path_compare_run(&program, &path, &narrow);
    ck_assert_uint_eq(found.turned.count, 0);
    nc_motion_free(&path);
    nc_motion_free(&program);
}
END_TEST

/* Half a circle about z: 0.05 mm to the side, as a link between rows. */
static struct nc_motion turn_back(double feed)
{
    struct nc_motion motion = {.kinematics = {.tool = {0, 0, 1}}};
    *array_push(&motion.arc) = (struct nc_motion_arc){{0, 0, 0}, {0, 0, 1}, PI};
    *array_push(&motion.piece) = (struct nc_piece){.feed = feed,
                                                   .shape = SHAPE_ARC,
                                                   .p = {{0.025, 0, 0}, {-0.025, 0, 0}},
                                                   .q = {{0, 0, 1}, {0, 0, 1}}};
    return motion;
}

/* Where F counts the ways of all axes, it counts them along the curve, not from end to end. */
START_TEST(a_curve_without_tool_centre_point)
{
    struct axis_limits limits = {.combined = true};
    struct path_compare_options combined = options;
    struct nc_motion path = turn_back(800), program = turn_back(800), fast = turn_back(1400);

    for (int k = 0; k < NC_AXES; k++)
        limits.rapid[k] = 1e5;
    combined.limits = &limits;
    struct path_compare found = path_compare_run(&program, &path, &combined);
    ck_assert_uint_eq(found.fast.count + found.slow.count, 0);
    found = path_compare_run(&fast, &path, &combined);
    ck_assert_double_eq_tol(found.fast.value, 1.75, 0.01);
    nc_motion_free(&path);
    nc_motion_free(&program);
    nc_motion_free(&fast);
}
END_TEST

/* Where F counts the ways of all axes, digits make of a piece that is as short as the tolerance one
 * of another length, and say little of its feed; not of a longer one. */
START_TEST(a_piece_short_against_its_digits)
{
    const double length[] = {0.04, 0.2}, told[] = {0, 3};
    struct axis_limits limits = {.combined = true};
    struct path_compare_options combined = options;
    struct nc_motion path = row(0, false);

    for (int k = 0; k < NC_AXES; k++)
        limits.rapid[k] = 1e5;
    combined.limits = &limits;
    for (int k = 0; k < 2; k++) {
        struct nc_motion program = row(0, false);
        struct nc_piece *last = &program.piece.item[9], piece = *last;
        double s = length[k] / 2;

        last->p[1] = piece.p[0] = vec_mix(last->p[0], last->p[1], 1 - s);
        last->q[1] = piece.q[0] = vec_mix(last->q[0], last->q[1], 1 - s);
        piece.feed = 2400;
        *array_push(&program.piece) = piece;
        struct path_compare found = path_compare_run(&program, &path, &combined);
        ck_assert_double_eq_tol(found.fast.value, told[k], 0.01);
        nc_motion_free(&program);
    }
    nc_motion_free(&path);
}
END_TEST

/* The tip turns about the ball's centre, which stands: F counts degrees, in inches, too. */
START_TEST(a_turn_about_the_centre)
{
    struct nc_motion path = row(0, false), program = row(0, false);
    for (int i = 0; i < 2; i++) {
        struct nc_motion *m = i ? &program : &path;
        m->track = NC_MOTION_CENTRE;
        struct nc_piece *turn = &m->piece.item[5];
        turn->q[1] = m->piece.item[6].q[0] = vec_unit(vec(0.5, 0, 1));
        for (size_t k = 5; k < m->piece.n; k++)
            m->piece.item[k].p[0].x = k == 5 ? 10 : 2 * (double)k - 2,
            m->piece.item[k].p[1].x = k == 5 ? 10 : 2 * (double)k;
    }
    program.piece.item[5].feed *= 25.4;
    struct path_compare found = path_compare_run(&program, &path, &options);
    ck_assert_uint_eq(found.off.count + found.missed.count, 0);
    ck_assert_uint_eq(found.fast.count + found.slow.count, 0);
    program.piece.item[6].feed *= 25.4; /* which moves */
    found = path_compare_run(&program, &path, &options);
    ck_assert_double_eq_tol(found.fast.value, 25.4, 1e-9);
    nc_motion_free(&path);
    nc_motion_free(&program);
}
END_TEST

/* A row of polynomials in one F, along x and then along y; the X axis is slow. */
static struct nc_motion corner(double feed)
{
    struct nc_motion motion = {.kinematics = {.tool = {0, 0, 1}}};
    const struct vec3 at[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, up = {0, 0, 1};
    for (size_t i = 0; i < 2; i++) {
        struct nc_motion_polynomial line = {.p = {vec_sub(at[i + 1], at[i])}};
        *array_push(&motion.polynomial) = line;
        *array_push(&motion.piece) = (struct nc_piece){.feed = feed,
                                                       .index = i,
                                                       .shape = SHAPE_POLYNOMIAL,
                                                       .p = {at[i], at[i + 1]},
                                                       .q = {up, up}};
    }
    return motion;
}

/* The feed that the first needs is that of the next, which says none; but not of one that does. */
START_TEST(polynomials_of_one_feed)
{
    struct axis_limits limits = {.rapid = {5, 1e5, 1e5, 1e5, 1e5, 1e5}};
    struct path_compare_options slow = options;
    struct nc_motion path = corner(800), program = corner(2);

    slow.limits = &limits;
    struct path_compare found = path_compare_run(&program, &path, &slow);
    ck_assert_uint_eq(found.off.count + found.missed.count + found.slow.count, 0);
    program.piece.item[1].feed = 1;
    found = path_compare_run(&program, &path, &slow);
    ck_assert_uint_eq(found.slow.piece, 1);
    ck_assert_double_eq_tol(found.slow.value, 800, 1e-6);
    limits.rapid[0] = 1e5;
    program.piece.item[1].feed = 2;
    found = path_compare_run(&program, &path, &slow);
    ck_assert_double_eq_tol(found.slow.value, 400, 1e-6);
    nc_motion_free(&path);
    nc_motion_free(&program);
}
END_TEST

/* The program comes down beside where the path begins, goes along a row of its own and is on the
 * path from its fifth piece on; near to where the path begins it is again later, on a next row. */
START_TEST(what_is_left_out_is_told_where_it_was_left)
{
    struct nc_motion path = row(0, false), program = row(0, true), next = row(0.5, false);
    for (size_t i = 1; i < 6; i++) { /* down, and the first four of the row */
        program.piece.item[i].p[1].y = 2;
        program.piece.item[i + 1].p[0].y = 2;
    }
    for (size_t i = 0; i < next.piece.n; i++)
        *array_push(&program.piece) = next.piece.item[i];
    struct path_compare found = path_compare_run(&program, &path, &options);
    ck_assert_double_gt(found.missed.value, 0.49);
    ck_assert_uint_ge(found.missed.near, 1);
    ck_assert_double_lt(found.missed.at.x, 4);
    ck_assert_uint_le(found.missed.near, 3);
    nc_motion_free(&path);
    nc_motion_free(&program);
    nc_motion_free(&next);
}
END_TEST

/* Upright C stands where the piece before left it, at 90 degrees, and turns away from there with
 * the first of the next piece: slow as it is there, it is as fast as C allows. */
START_TEST(an_axis_upright_stands_where_it_was)
{
    const struct axis_limits limits = {.rapid = {1e5, 1e5, 1e5, 7200, 7200, 7200}};
    struct path_compare_options steep = options;
    const struct vec3 up = {0, 0, 1}, a = {sin(0.2), 0, cos(0.2)}, b = {0, -sin(0.004), cos(0.004)};
    struct nc_motion path = {.kinematics = verify_kinematics_trunnion('A', 1)}, program = path;
    steep.limits = &limits;
    steep.slow = 20;
    for (int i = 0; i < 2; i++) {
        struct nc_motion *m = i ? &program : &path;
        *array_push(&m->piece) =
            (struct nc_piece){.feed = 800, .p = {{-3, 0, 0}, {0, 0, 0}}, .q = {_i ? b : a, up}};
        *array_push(&m->piece) =
            (struct nc_piece){.feed = i ? 30 : 800, .p = {{0, 0, 0}, {0.1, 0, 0}}, .q = {up, b}};
    }
    struct path_compare found = path_compare_run(&program, &path, &steep);
    ck_assert_uint_eq(found.slow.count > 0, _i > 0); /* C was at zero before: it stands */
    nc_motion_free(&path);
    nc_motion_free(&program);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("path_compare");
    TCase *tcase = tcase_create("path_compare");
    tcase_add_loop_test(tcase, an_axis_upright_stands_where_it_was, 0, 2);
    tcase_add_test(tcase, the_same_is_the_same);
    tcase_add_loop_test(tcase, a_part_of_the_path, 0, 3);
    tcase_add_test(tcase, inverse_time_is_as_good_as_digits);
    tcase_add_test(tcase, what_is_left_out_is_told_where_it_was_left);
    tcase_add_test(tcase, a_curve_without_tool_centre_point);
    tcase_add_test(tcase, what_is_off_is_told);
    tcase_add_test(tcase, polynomials_of_one_feed);
    tcase_add_test(tcase, a_piece_short_against_its_digits);
    tcase_add_test(tcase, a_turn_about_the_centre);
    tcase_add_test(tcase, an_axis_that_the_path_has_within_the_tolerance_of_the_tip);
    tcase_add_test(tcase, an_axis_that_turns_unevenly_with_the_tip);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
