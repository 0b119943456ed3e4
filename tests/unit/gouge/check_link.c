/* link: a low arch over a floor, over a low wall, and not over a high one. */
#include "gouge/link_retract.h"

#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "chains.h"
#include "seed.h"

static const double R = 5;

/* A floor of points 0.5 mm apart with a wall of this height along x at y = 2. */
static struct gouge_check *floor_with_wall(double height)
{
    struct vec3s points = {0};
    for (int i = -20; i <= 20; i++) {
        for (int k = -20; k <= 20; k++)
            *array_push(&points) = vec(0.5 * i, 0.5 * k, 0);
        for (double z = 0; z <= height; z += 0.25)
            *array_push(&points) = vec(0.5 * i, 2, z);
    }
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    array_free(&points);
    return guard;
}

static struct run_point point_at(double y, double z)
{
    struct run_point p = {.ball = vec(0, y, z), .axis = vec(0, 0, 1), .normal = vec(0, 0, 1)};
    p.contact = vec(0, y, z - R);
    p.tip = p.contact;
    return p;
}

/* The low link from y = -4 to y = 8 where the ball stands on the floor or against the wall. */
static bool find_link(double wall, double limit, struct run *link)
{
    struct gouge_check *guard = floor_with_wall(wall);
    struct gouge_lift_options rule = {.guard = guard, .offset = R, .tolerance = 0.01};
    struct run_point from = point_at(-4, R), to = point_at(8, R);
    const struct holder none = {0};
    struct link_options options = {.lift = &rule, .holder = &none, .radius = R, .limit = limit};
    bool found = link_low(&options, &from, &to, link);
    struct vec3 before = from.ball;
    for (size_t i = 0; found && i <= link->n; i++) {
        struct vec3 ball = i < link->n ? link->item[i].ball : to.ball;
        ck_assert_double_le(gouge_depth_along(guard, before, ball, R), 0.01);
        before = ball;
    }
    gouge_free(guard);
    return found;
}

START_TEST(over_a_floor_it_is_an_arch)
{
    struct run link = {.radius = R};
    double highest = 0;
    ck_assert(find_link(0, R, &link));
    for (size_t i = 0; i < link.n; i++) {
        highest = fmax(highest, link.item[i].ball.z);
        ck_assert_double_eq(vec_length(link.item[i].normal), 0);
    }
    ck_assert_double_eq_tol(highest, R + 1.2, 1e-9);
    array_free(&link);
}
END_TEST

START_TEST(over_a_low_wall_it_is_lifted)
{
    struct run link = {.radius = R};
    double highest = 0;
    ck_assert(find_link(3, R, &link));
    for (size_t i = 0; i < link.n; i++)
        highest = fmax(highest, link.item[i].ball.z);
    ck_assert_double_eq_tol(highest, R + 3, 0.05);
    array_free(&link);
}
END_TEST

START_TEST(no_low_link_over_a_high_wall)
{
    struct run link = {.radius = R};
    ck_assert(!find_link(9, R, &link));
    ck_assert_uint_eq(link.n, 0);
    ck_assert(!find_link(6, 0.5, &link));
    array_free(&link);
}
END_TEST

/* Beside a post that the ball touches less deep than it may half way: it goes past, and does not
 * climb over it to touch nothing. */
START_TEST(past_what_it_hardly_touches)
{
    struct vec3s post = {0};
    for (double z = 0; z <= R + 1; z += 0.1)
        *array_push(&post) = vec(R - 0.0005, 0, z);
    struct gouge_check *guard = gouge_from_points(post.item, post.n);
    struct gouge_lift_options rule = {.guard = guard, .offset = R, .tolerance = 0.01};
    struct run_point from = point_at(-0.3, R), to = point_at(0.3, R);
    struct run link = {.radius = R};
    const struct holder none = {0};
    struct link_options options = {.lift = &rule, .holder = &none, .radius = R, .limit = 2 * R};

    ck_assert(link_low(&options, &from, &to, &link));
    for (size_t i = 0; i < link.n; i++)
        ck_assert_double_lt(link.item[i].ball.z, R + 0.1); /* over it: R + 3 */
    array_free(&link);
    array_free(&post);
    gouge_free(guard);
}
END_TEST

/* From a row that ends along X to one that begins back along it, 2 mm beside: half round with about
 * the radius that the rows have room for, and no corner at the ends. */
START_TEST(from_row_to_row_it_turns_with_a_radius)
{
    struct gouge_check *guard = floor_with_wall(0);
    struct gouge_lift_options rule = {.guard = guard, .offset = R, .tolerance = 0.01};
    struct run_point from = point_at(-6, R), to = point_at(-4, R);
    struct run link = {.radius = R};
    const struct holder none = {0};
    struct link_options options = {.lift = &rule,
                                   .holder = &none,
                                   .radius = R,
                                   .limit = R,
                                   .leave = vec(1, 0, 0),
                                   .arrive = vec(-1, 0, 0)};
    struct vec3 before = from.ball, ahead = options.leave;
    double far = 0;

    ck_assert(link_low(&options, &from, &to, &link));
    *array_push(&link) = to;
    for (size_t i = 0; i < link.n; i++) {
        struct vec3 way = vec_sub(link.item[i].ball, before);
        ck_assert_double_lt(vec_angle(way, ahead), RADIANS(45));
        far = fmax(far, link.item[i].ball.x - from.ball.x);
        ahead = way;
        before = link.item[i].ball;
    }
    ck_assert_double_lt(vec_angle(ahead, options.arrive), RADIANS(45));
    ck_assert_double_gt(far, 0.8);
    ck_assert_double_lt(far, 1.6);
    array_free(&link);
    gouge_free(guard);
}
END_TEST

START_TEST(without_a_guard_it_is_straight)
{
    struct gouge_lift_options rule = {.offset = R};
    struct run_point from = point_at(-4, R), to = point_at(8, R);
    struct run link = {.radius = R};
    const struct holder none = {0};
    struct link_options options = {.lift = &rule, .holder = &none, .radius = R, .limit = R};
    ck_assert(link_low(&options, &from, &to, &link));
    ck_assert_uint_eq(link.n, 0);
}
END_TEST

/* On a machine that turns about z, from one side of it to the other but for 20 degrees: through the
 * pole, and not half about it. */
START_TEST(a_low_link_turns_as_rotary_axes_do)
{
    struct gouge_check *guard = floor_with_wall(0);
    struct gouge_lift_options rule = {.guard = guard, .offset = R, .tolerance = 0.01};
    const struct kinematic_chain chain = {.tool = {0, 0, 1}};
    struct rotary_frame frame = rotary_frame_of(&chain);
    struct run_point from = point_at(-4, R), to = point_at(8, R);
    struct run link = {.radius = R};
    const struct holder none = {0};
    struct link_options options = {
        .lift = &rule, .holder = &none, .radius = R, .limit = R, .frame = &frame};
    struct rotary_angles first = {-0.05, 0.3}, last = {0.6, 0.3 + RADIANS(20)}, at = first;
    double turned = 0;
    bool pole = false;

    from.axis = rotary_axis(&frame, first);
    to.axis = rotary_axis(&frame, last);
    ck_assert(link_low(&options, &from, &to, &link));
    *array_push(&link) = to;
    for (size_t i = 0; i < link.n; i++) {
        struct rotary_angles now = rotary_angles_near(&frame, link.item[i].axis, at);
        turned += fabs(now.turn - at.turn);
        pole = pole || link.item[i].axis.z == 1;
        at = now;
    }
    ck_assert(pole);
    ck_assert_double_eq_tol(turned, RADIANS(20), 1e-9);
    ck_assert_double_eq_tol(at.lean, 0.6, 1e-9);
    array_free(&link);
    gouge_free(guard);
}
END_TEST

START_TEST(a_retract_goes_up_the_axis)
{
    struct gouge_check *guard = floor_with_wall(9);
    struct gouge_lift_options rule = {.guard = guard, .offset = R, .tolerance = 0.01};
    const struct holder none = {0};
    struct link_options options = {
        .lift = &rule, .holder = &none, .radius = R, .clearance = 20, .approach = 2};
    struct run_point p = point_at(-6, R);
    p.axis = vec(0, -0.6, 0.8);
    struct retract r = link_retract(&options, &p);
    ck_assert(r.clear && r.rapid);
    ck_assert_uint_eq(r.n, 2);
    ck_assert_double_eq_tol(vec_distance(r.at[0], p.ball), 2, 1e-12);
    ck_assert_double_eq_tol(vec_angle(vec_sub(r.at[1], p.ball), p.axis), 0, 1e-9);
    ck_assert_double_eq_tol(r.at[1].z - R * p.axis.z, 20, 1e-9);
    gouge_free(guard);
}
END_TEST

/* A tool that lies beside a wall goes along its axis only until it is clear of it, and then
 * straight up: not as far as its axis takes to be over the part. */
START_TEST(a_flat_axis_leads_out_and_then_up)
{
    struct gouge_check *guard = floor_with_wall(40);
    struct gouge_lift_options rule = {.guard = guard, .offset = R, .tolerance = 0.01};
    const struct holder none = {0};
    struct link_options options = {
        .lift = &rule, .holder = &none, .radius = R, .clearance = 50, .approach = 2};
    struct run_point p = point_at(2 - R, 10);
    p.axis = vec(0, -0.96, 0.28);
    struct retract r = link_retract(&options, &p);
    struct vec3 last = p.ball;
    double length = 0;
    ck_assert(r.clear && r.rapid);
    for (size_t k = 0; k < r.n; last = r.at[k++]) {
        ck_assert_double_le(gouge_depth_along(guard, last, r.at[k], R), 0.01);
        length += vec_distance(last, r.at[k]);
    }
    ck_assert_double_eq_tol(last.z - R * p.axis.z, 50, 1e-9);
    ck_assert_double_lt(length, 60); /* 148 along its axis */
    gouge_free(guard);
}
END_TEST

/* A tool that cuts a plate from below leaves it where it is out beside it, and no lower than it may
 * be: by its own axis it would be 25 mm below. */
START_TEST(no_way_leads_far_below_the_part)
{
    const double floors[] = {-1000, -10, 5};
    struct vec3s points = {0};
    for (int i = -40; i <= 40; i++)
        for (int k = -40; k <= 40; k++)
            *array_push(&points) = vec(0.5 * i, 0.5 * k, 10);
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    struct gouge_lift_options rule = {.guard = guard, .offset = R, .tolerance = 0.01};
    const struct holder none = {0};
    struct run_point p = {.ball = vec(10, 0, 10 - R), .axis = vec_unit(vec(0.5, 0, -0.8))};
    p.normal = vec(0, 0, -1);
    for (int i = 0; i < 3; i++) {
        struct link_options options = {.lift = &rule,
                                       .holder = &none,
                                       .radius = R,
                                       .clearance = 30,
                                       .floor = floors[i],
                                       .approach = 2};
        struct retract r = link_retract(&options, &p);
        double lowest = p.ball.z;
        for (size_t k = 0; k < r.n; k++)
            lowest = fmin(lowest, r.at[k].z);
        ck_assert(r.clear == (i < 2));
        ck_assert(i == 0 ? lowest < -10 : i == 2 || lowest >= floors[i]);
    }
    array_free(&points);
    gouge_free(guard);
}
END_TEST

/* Up along a flank 0.25 mm beside the ball the way is clear, and no rapid ends beside the flank. */
START_TEST(a_rapid_ends_off_the_flank_that_it_leads_along)
{
    const double top = 15, approaches[] = {2, 1};
    struct gouge_check *guard = floor_with_wall(top);
    struct gouge_lift_options rule = {.guard = guard, .offset = R, .tolerance = 0.01};
    const struct holder none = {0};
    for (int i = 0; i < 2; i++) {
        double off = fmin(0.3 * R, 0.9 * approaches[i]);
        struct link_options options = {.lift = &rule,
                                       .holder = &none,
                                       .radius = R,
                                       .clearance = 40,
                                       .approach = approaches[i]};
        struct run_point p = point_at(2 - R - 0.25, R);
        struct retract r = link_retract(&options, &p);
        ck_assert(r.clear && r.rapid);
        for (size_t k = 0; k < r.n; k++)
            ck_assert_double_ge(gouge_distance(guard, r.at[k], 100), R + off - 1e-9);
        /* and not further up than it takes */
        ck_assert_double_lt(gouge_distance(guard, r.at[0], 100), R + off + 0.05);
    }
    gouge_free(guard);
}
END_TEST

/* Places beside the wall and leaned axes: whatever way is found, all its legs are clear as they are
 * driven, and where it is rapid they end off the part. */
START_TEST(all_legs_of_a_way_are_clear)
{
    struct gouge_check *guard = floor_with_wall(8);
    struct gouge_lift_options rule = {.guard = guard, .offset = R, .tolerance = 0.01};
    const struct holder none = {0};
    struct link_options options = {
        .lift = &rule, .holder = &none, .radius = R, .clearance = 25, .approach = 2};
    size_t ways = 0;
    for (int i = 0; i < 400; i++) {
        struct run_point p = point_at(2 - R - 0.4 * (i % 5), R + 0.25 * (i / 5 % 4));
        double lean = RADIANS(4.5 * (i / 20)), side = i % 7;
        p.axis = vec(sin(lean) * cos(side), sin(lean) * sin(side), cos(lean));
        p.normal = vec_unit(vec(0, -(i % 3), 1));
        struct retract r = link_retract(&options, &p);
        struct vec3 last = p.ball;
        for (size_t k = 0; r.clear && k < r.n; k++) {
            ck_assert_double_le(gouge_depth_along(guard, last, r.at[k], R), 0.01);
            if (r.rapid)
                ck_assert_double_ge(gouge_distance(guard, r.at[k], 100), R + 1.5 - 1e-9);
            last = r.at[k];
        }
        ways += r.clear;
    }
    ck_assert_uint_gt(ways, 300);
    gouge_free(guard);
}
END_TEST

/* A flank with points that stand out of it by chance, up which the tool goes back along its own
 * axis, leaning nearly as the flank does: the flute, too, goes no deeper than the tolerance,
 * between the steps at which it was looked at. */
START_TEST(no_flute_goes_deeper_between_steps)
{
    const double tolerance = 0.01, fine = 0.003;
    const struct holder flute = {1, {{R, R, 25}}};
    struct vec3s points = {0};
    uint32_t state = 7;
    size_t ways = 0;

    for (int i = -30; i <= 30; i++)
        for (int k = 0; k < 90; k++) {
            state = state * 1664525u + seed_step_32();
            double out = 0.06 * (double)(state >> 8) / (1 << 24);
            *array_push(&points) = vec(0.4 * i, 2 + 0.1 * k - out, 0.4 * k);
        }
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    struct gouge_lift_options rule = {.guard = guard, .offset = R, .tolerance = tolerance};
    struct link_options options = {
        .lift = &rule, .holder = &flute, .radius = R, .clearance = 45, .approach = 6};
    for (int i = 0; i < 64; i++) {
        double lean = atan(0.25) + 0.0004 * (i % 8 - 3);
        struct run_point p = {.axis = vec(0, sin(lean), cos(lean)), .normal = vec(0, -1, 0)};
        p.ball = vec(0.05 * (i / 8), -6, 4 + 0.1 * (i % 13));
        p.ball.y += gouge_distance(guard, p.ball, 100) - R; /* nearly touches it */
        p.ball.y -= gouge_depth_along(guard, p.ball, p.ball, R);
        if (gouge_holder(guard, &flute, p.ball, p.axis, 1) < -0.9 * tolerance)
            continue;
        struct retract r = link_retract(&options, &p);
        struct vec3 last = p.ball;
        for (size_t k = 0; r.clear && k < (r.rapid ? 1 : r.n); k++) {
            double length = vec_distance(last, r.at[k]);
            for (double s = 0; s < fmin(length, 8); s += fine)
                ck_assert_double_ge(
                    gouge_holder(guard, &flute, vec_mix(last, r.at[k], s / length), p.axis, 0.02),
                    -1.01 * tolerance);
            last = r.at[k];
        }
        ways += r.clear;
    }
    ck_assert_uint_gt(ways, 20);
    array_free(&points);
    gouge_free(guard);
}
END_TEST

START_TEST(a_retract_goes_straight_up_where_the_axis_leads_into_the_part)
{
    struct gouge_check *guard = floor_with_wall(30);
    struct gouge_lift_options rule = {.guard = guard, .offset = R, .tolerance = 0.01};
    const struct holder none = {0};
    struct link_options options = {
        .lift = &rule, .holder = &none, .radius = R, .clearance = 40, .approach = 2};
    struct run_point p = point_at(-4, R);
    p.axis = vec(0, 0.6, 0.8);
    struct retract r = link_retract(&options, &p);
    ck_assert(r.clear);
    ck_assert_double_eq_tol(vec_angle(vec_sub(r.at[r.n - 1], p.ball), vec(0, 0, 1)), 0, 1e-9);
    gouge_free(guard);
    /* in a shaft that is too narrow nothing is clear */
    struct vec3s slit = {0};
    for (double z = -6; z < 36; z += 0.5)
        for (double x = -8; x <= 8; x += 0.5) {
            *array_push(&slit) = vec(x, 1, z);
            *array_push(&slit) = vec(x, -9, z);
            *array_push(&slit) = vec(-8, (x + 8) * 10 / 16 - 9, z);
            *array_push(&slit) = vec(8, (x + 8) * 10 / 16 - 9, z);
        }
    guard = gouge_from_points(slit.item, slit.n);
    rule.guard = guard;
    p.ball = vec(0, -4, 0);
    p.axis = vec(0, 0.6, 0.8);
    rule.offset = R + 0.5;
    r = link_retract(&options, &p);
    ck_assert(!r.clear);
    array_free(&slit);
    gouge_free(guard);
}
END_TEST

/* Where nothing guards the way out leads along the axis till the tip is on the clearance plane, off
 * by the approach first; along one that leads down there is none, and it goes straight up from
 * there. */
START_TEST(a_retract_without_a_guard)
{
    struct gouge_lift_options rule = {.offset = R, .tolerance = 0.01};
    const struct holder none = {0};
    struct link_options options = {
        .lift = &rule, .holder = &none, .radius = R, .clearance = 40, .approach = 2};
    struct run_point p = point_at(-4, 7);
    p.axis = vec(0, 0.6, 0.8);
    struct retract r = link_retract(&options, &p);
    ck_assert(r.clear && r.rapid);
    ck_assert_uint_eq(r.n, 2);
    ck_assert_double_lt(vec_distance(r.at[0], vec_along(p.ball, 2, p.axis)), 1e-12);
    double length = (40 + 0.8 * R - p.ball.z) / 0.8; /* the centre is R from the tip */
    ck_assert_double_lt(vec_distance(r.at[1], vec_along(p.ball, length, p.axis)), 1e-9);
    p.axis = vec(0, 0.6, -0.8);
    r = link_retract(&options, &p);
    ck_assert_uint_eq(r.n, 3);
    ck_assert_double_lt(vec_distance(r.at[1], vec_along(p.ball, 2, p.axis)), 1e-12);
    ck_assert_double_lt(vec_distance(r.at[2], vec(r.at[1].x, r.at[1].y, 40 - 0.8 * R)), 1e-12);
}
END_TEST

/* The place of the tool that reaches lowest, below its tip, at this tilt. */
static double reach_below(const struct holder *holder, double tilt)
{
    double lowest = R * (cos(tilt) - 1), up = R;
    for (int i = 0; i < holder->n; i++) {
        lowest = fmin(lowest, up * cos(tilt) - holder->part[i].low * sin(tilt));
        up += holder->part[i].length;
        lowest = fmin(lowest, up * cos(tilt) - holder->part[i].high * sin(tilt));
    }
    return lowest;
}

static double lean_of(struct vec3 a)
{
    return vec_angle(a, vec(0, 0, 1));
}

/* The furthest off z on the great circle, in small steps. */
static double most_lean(struct vec3 from, struct vec3 to)
{
    double most = 0;
    for (int i = 0; i <= 400; i++)
        most = fmax(most, lean_of(vec_slerp(from, to, i / 400.0)));
    return most;
}

/* Any two axes: a turn that leans further than both its ends is found, and only such; by the way it
 * goes instead no half leans further than its end. */
START_TEST(a_turn_that_dips_goes_by_way)
{
    int dips = 0;
    seed = 77;
    for (int i = 0; i < 3000; i++) {
        struct vec3 a = random_unit(), b = random_unit(), way;
        double ends = fmax(lean_of(a), lean_of(b)), most = most_lean(a, b);
        if (fabs(most - ends - 0.01) < 1e-3 || vec_dot(a, b) < -0.999)
            continue;
        bool dip = link_axis_dips(a, b, &way);
        ck_assert_int_eq(dip, most > ends + 0.01);
        if (!dip)
            continue;
        dips++;
        ck_assert_double_eq_tol(vec_length(way), 1, 1e-12);
        ck_assert_double_le(most_lean(a, way), fmax(lean_of(a), lean_of(way)) + 1e-6);
        ck_assert_double_le(most_lean(way, b), fmax(lean_of(b), lean_of(way)) + 1e-6);
        ck_assert_double_le(lean_of(way), fmin(lean_of(a), lean_of(b)) / 2 + 1e-12);
    }
    ck_assert_int_gt(dips, 500);
    struct vec3 a = vec(0.6, 0, -0.8), way;
    ck_assert(link_axis_dips(a, vec_scale(-1, a), &way) && way.z > 0.8);
    ck_assert(!link_axis_dips(a, a, &way));
}
END_TEST

START_TEST(the_tool_turns_above_the_guard)
{
    struct gouge_check *guard = floor_with_wall(9);
    struct gouge_lift_options rule = {.guard = guard, .offset = R, .tolerance = 0.01};
    const struct holder holder = {2, {{R, R, 20}, {25, 30, 40}}};
    struct link_options options = {
        .lift = &rule, .holder = &holder, .radius = R, .clearance = 12, .approach = 2};
    for (int most = 0; most <= 130; most += 10) {
        double z = link_height(&options, 0, RADIANS(most)), lowest = HUGE_VAL;
        for (double tilt = 0; tilt <= most; tilt += 0.25)
            lowest = fmin(lowest, z + reach_below(&holder, RADIANS(tilt)));
        ck_assert_double_ge(lowest, 9.99); /* the top of the wall, and 1 mm */
        ck_assert_double_ge(z, 12);
        ck_assert(z == 12 || lowest < 10.01); /* no higher than it must */
    }
    gouge_free(guard);
}
END_TEST

/* Under a roof at z = 12 that covers x < 3: up, along the axis and along the normal the shaft is in
 * it. */
START_TEST(a_way_out_is_bent_where_a_roof_is_over_the_point)
{
    struct vec3s points = {0};
    for (double x = -30; x <= 30; x += 0.5)
        for (double y = -30; y <= 30; y += 0.5) {
            *array_push(&points) = vec(x, y, 0);
            if (x <= 3)
                *array_push(&points) = vec(x, y, 12);
        }
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    struct gouge_lift_options rule = {.guard = guard, .offset = 2, .tolerance = 0.01};
    const struct holder shaft = {1, {{2, 2, 40}}};
    struct link_options options = {
        .lift = &rule, .holder = &shaft, .radius = 2, .clearance = 30, .approach = 3};
    /* the axis leads out past the edge of the roof, but the way along it is not the only one */
    struct run_point p = {
        .ball = vec(-3, 0, 2), .axis = vec_unit(vec(1.4, 0, 1)), .normal = vec(0, 0, 1)};
    struct retract r = link_retract(&options, &p);
    ck_assert(r.clear);
    struct vec3 last = p.ball;
    for (size_t i = 0; i < r.n; i++) {
        for (int k = 0; k <= 400; k++) { /* pose by pose */
            struct vec3 c = vec_mix(last, r.at[i], k / 400.0);
            ck_assert_double_le(gouge_depth(guard, c, 2), 0.01);
            ck_assert_double_ge(gouge_holder(guard, &shaft, c, p.axis, 1), -0.01);
        }
        last = r.at[i];
    }
    ck_assert_double_ge(last.z - 2 * p.axis.z, 30 - 1e-9);
    /* upright under the roof the shaft is in it already: no way */
    p.axis = vec(0, 0, 1);
    ck_assert(!link_retract(&options, &p).clear);
    array_free(&points);
    gouge_free(guard);
}
END_TEST

/* The shaft stands beside a wall; the low link to its other side would drive it through. */
START_TEST(a_low_link_keeps_the_shaft_clear)
{
    struct vec3s points = {0};
    for (double x = -20; x <= 20; x += 0.5) {
        for (double y = -20; y <= 20; y += 0.5)
            *array_push(&points) = vec(x, y, 0);
        for (double z = 8; z <= 30; z += 0.5)
            *array_push(&points) = vec(x, 0, z); /* a curtain over the floor, above the ball */
    }
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    struct gouge_lift_options rule = {.guard = guard, .offset = 2, .tolerance = 0.01};
    const struct holder shaft = {1, {{2, 2, 20}}};
    struct link_options options = {
        .lift = &rule, .holder = &shaft, .radius = 2, .limit = 4, .longest = 40};
    struct run_point from = {.ball = vec(0, -6, 2), .axis = vec(0, 0, 1), .normal = vec(0, 0, 1)};
    struct run_point to = from;
    struct run link = {.radius = 2};
    to.ball.y = 6;
    ck_assert(!link_low(&options, &from, &to, &link));
    to.ball = vec(10, -6, 2); /* along the curtain, 4 mm off it */
    ck_assert(link_low(&options, &from, &to, &link));
    for (size_t i = 0; i < link.n; i++)
        ck_assert_double_ge(gouge_holder(guard, &shaft, link.item[i].ball, link.item[i].axis, 1),
                            0);
    array_free(&link);
    array_free(&points);
    gouge_free(guard);
}
END_TEST

/* Blocks of a hundredth of a millimetre over a floor and round the top of a wall become longer
 * ones, but no longer than keeps them clear: chords of the circle that the centre goes on. */
START_TEST(thinned)
{
    struct gouge_check *guard = floor_with_wall(2);
    struct gouge_lift_options rule = {.guard = guard, .offset = R, .tolerance = 0.01};
    const struct holder none = {0};
    struct link_options options = {.lift = &rule, .holder = &none, .radius = R, .limit = R};
    struct run_point from = point_at(-4, R), to = point_at(8, R);
    for (double least = 0.1; least < 3; least *= 10) {
        struct run link = {.radius = R};
        for (double y = -3.99; y < 7.995; y += 0.01) {
            double off = fabs(y - 2);
            *array_push(&link) = point_at(y, off < 4 ? 2 + sqrt(R * R - off * off) : R);
        }
        size_t before = link.n;
        link_thin(&options, &from, &to, least, HUGE_VAL, &link);
        ck_assert_uint_lt(link.n, before / 8);
        struct run_point last = from;
        double longest = 0;
        for (size_t i = 0; i <= link.n; i++) {
            struct run_point p = i < link.n ? link.item[i] : to;
            ck_assert_double_le(gouge_depth_along(guard, last.ball, p.ball, R), 0.01);
            ck_assert(i == link.n || vec_distance(last.tip, p.tip) > fmin(0.09, least / 2));
            longest = fmax(longest, vec_distance(last.tip, p.tip));
            last = p;
        }
        ck_assert_double_ge(longest, least * 0.9);
        if (least > 0.5) /* chords of 2 sqrt(2 R 0.01) on 2 R asin(4 / 5) */
            ck_assert_uint_ge(link.n, 14);
        array_free(&link);
    }
    gouge_free(guard);
}
END_TEST

/* Points 0.4 mm apart, and beside one of them another, 0.01 mm off: one of the two is left out,
 * which it is where both are on a straight line, the rounder one at a corner, and never the one at
 * the pole. */
START_TEST(one_of_two_in_a_place)
{
    struct gouge_check *guard = floor_with_wall(2);
    struct gouge_lift_options rule = {.guard = guard, .offset = R, .tolerance = 0.01};
    const struct holder none = {0};
    const struct rotary_frame frame = {.pole = {0, 0, 1}, .x = {1, 0, 0}, .y = {0, 1, 0}};
    struct link_options options = {
        .lift = &rule, .holder = &none, .radius = R, .limit = R, .frame = &frame};
    struct run_point from = point_at(-20, 2 * R), to = point_at(-16, 2 * R);
    for (int k = 0; k < 4; k++) {
        struct run link = {.radius = R};
        struct vec3 lean = vec(0.02, 0, sqrt(1 - 0.02 * 0.02));
        for (int i = 1; i < 10; i++) { /* up at 45 degrees from the fifth on */
            double up = k > 0 && i > 5 ? 0.4 * (i - 5) : 0;
            *array_push(&link) = point_at(-20 + 0.4 * i, 2 * R + up);
            if (i == 5) /* before the corner if k is 1, behind it if 2 */
                *array_push(&link) =
                    point_at(-18 + (k == 1 ? -0.01 : 0.007), 2 * R + (k == 1   ? 0
                                                                      : k >= 2 ? 0.007
                                                                               : 0));
        }
        if (k == 1) { /* in order */
            struct run_point p = link.item[4];
            link.item[4] = link.item[5];
            link.item[5] = p;
        }
        for (size_t i = 0; i < link.n; i++)
            link.item[i].axis = lean;
        if (k == 3)
            link.item[5].axis = vec(0, 0, 1);
        for (size_t i = 0; i < link.n; i++)
            link.item[i].tip = vec_along(link.item[i].ball, -R, link.item[i].axis);
        to.ball.z = 2 * R + (k > 0 ? 2 : 0);
        to.tip = vec_along(to.ball, -R, to.axis);
        struct vec3 corner = point_at(-18, 2 * R).ball;
        ck_assert_uint_eq(link.n, 10);
        link_thin(&options, &from, &to, 0.021, k == 3 ? 1 : 0.002, &link);
        ck_assert_uint_eq(link.n, k == 3 ? 10 : 9);
        bool stays = false;
        for (size_t i = 0; i < link.n; i++)
            stays = stays || vec_distance(link.item[i].ball, corner) < 1e-9;
        ck_assert(stays || k == 0);
        array_free(&link);
    }
    gouge_free(guard);
}
END_TEST

/* A sharp turn, and beside it a point that can't be left out: it goes on along the path until it
 * is far enough off, with its axis where that is at the pole; the last one of all goes back. */
START_TEST(one_too_near_goes_on)
{
    enum { INNER, AT_POLE, LAST, NO_ROOM, CASES };
    static const double LEAST = 0.021;
    struct gouge_check *guard = floor_with_wall(2);
    struct gouge_lift_options rule = {.guard = guard, .offset = R, .tolerance = 0.01};
    const struct holder none = {0};
    const struct rotary_frame frame = {.pole = {0, 0, 1}, .x = {1, 0, 0}, .y = {0, 1, 0}};
    struct link_options options = {
        .lift = &rule, .holder = &none, .radius = R, .limit = R, .frame = &frame};
    for (int k = 0; k < CASES; k++) { /* along -x, at -18 a bit back, then up at 45 degrees */
        const struct vec3 lean = vec(0.02, 0, sqrt(1 - 0.02 * 0.02));
        struct run_point p[4] = {point_at(-18.4, 2 * R), point_at(-18, 2 * R),
                                 point_at(-18.01, 2 * R + 0.003), point_at(-17, 2 * R + 1)};
        if (k == NO_ROOM)
            p[3] = point_at(-18.001, 2 * R + 0.01);
        for (int i = 0; i < 4; i++) {
            p[i].axis = k == AT_POLE && (i == 1 || i == 2) ? vec(0, 0, 1) : lean;
            p[i].tip = vec_along(p[i].ball, -R, p[i].axis);
        }
        if (k == LAST) { /* turned round: the near one is before the end */
            struct run_point first = p[0], second = p[1];
            p[0] = p[3], p[1] = p[2], p[2] = second, p[3] = first;
        }
        size_t near = k == LAST ? 1 : 2;
        struct run_point was = p[near];
        struct run link = {.radius = R};
        *array_push(&link) = p[near];
        const struct run_point *from = &p[near - 1], *to = &p[near + 1];
        link_thin(&options, from, to, LEAST, 0, &link);
        ck_assert_uint_eq(link.n, 1);
        const struct run_point *q = link.item, *fixed = k == LAST ? to : from;
        if (k == NO_ROOM)
            ck_assert_double_eq(vec_distance(q->tip, was.tip), 0);
        else
            ck_assert_double_eq_tol(vec_distance(q->tip, fixed->tip), LEAST, 1e-9);
        ck_assert_double_eq_tol(vec_distance(q->tip, q->ball), R, 1e-9);
        ck_assert_double_le(vec_segment_distance(was.tip, k == LAST ? from->tip : to->tip, q->tip),
                            1e-9);
        if (k == AT_POLE)
            ck_assert_double_eq(vec_length(vec_cross(q->axis, frame.pole)), 0);
        array_free(&link);
    }
    gouge_free(guard);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("link");
    TCase *tests = tcase_create("link");
    tcase_add_test(tests, over_a_floor_it_is_an_arch);
    tcase_add_test(tests, thinned);
    tcase_add_test(tests, one_of_two_in_a_place);
    tcase_add_test(tests, one_too_near_goes_on);
    tcase_add_test(tests, over_a_low_wall_it_is_lifted);
    tcase_add_test(tests, past_what_it_hardly_touches);
    tcase_add_test(tests, no_low_link_over_a_high_wall);
    tcase_add_test(tests, from_row_to_row_it_turns_with_a_radius);
    tcase_add_test(tests, without_a_guard_it_is_straight);
    tcase_add_test(tests, a_low_link_turns_as_rotary_axes_do);
    tcase_add_test(tests, a_retract_goes_up_the_axis);
    tcase_add_test(tests, a_flat_axis_leads_out_and_then_up);
    tcase_add_test(tests, a_rapid_ends_off_the_flank_that_it_leads_along);
    tcase_add_test(tests, all_legs_of_a_way_are_clear);
    tcase_add_test(tests, no_flute_goes_deeper_between_steps);
    tcase_add_test(tests, a_retract_goes_straight_up_where_the_axis_leads_into_the_part);
    tcase_add_test(tests, a_turn_that_dips_goes_by_way);
    tcase_add_test(tests, the_tool_turns_above_the_guard);
    tcase_add_test(tests, a_way_out_is_bent_where_a_roof_is_over_the_point);
    tcase_add_test(tests, a_retract_without_a_guard);
    tcase_add_test(tests, a_low_link_keeps_the_shaft_clear);
    tcase_add_test(tests, no_way_leads_far_below_the_part);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
