/* check_holder - distances from a stack of cones against the nearest of many places on it. */
#include <check.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "gouge/holder.h"
#include "gouge/holder_text.h"
#include "seed.h"

static const struct holder stack = {3, {{3, 3, 40}, {10, 25, 20}, {25, 25, 60}}};

static double random_in(unsigned *state, double low, double high)
{
    *state = *state * 1664525u + seed_step_32();
    return low + (high - low) * (*state >> 8) / 16777216.0;
}

START_TEST(distances_known_by_hand)
{
    struct vec3 c = vec(1, 2, 3), up = vec(0, 0, 1);
    static const struct {
        double r, h, distance;
    } at[] = {
        {0, -2, 2},    {2, -1, 1},   {5, 20, 2},  {1, 20, -2},     {0, 0.5, -0.5},
        {3, 39, 0},    {6, 39, 1},   {30, 90, 5}, {0, 125, 5},     {28, 124, 5},
        {10, 70, -15}, {0, 119, -1}, {6, 40, 0},  {16.8, 47.4, 1},
    };
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
        struct vec3 p = vec_add(c, vec(0.6 * at[i].r, -0.8 * at[i].r, at[i].h));
        double d = holder_distance(&stack, c, up, p);
        ck_assert_msg(fabs(d - at[i].distance) < 1e-9, "%zu: %.12f", i, d);
    }
    ck_assert_double_eq_tol(holder_reach(&stack), hypot(25, 120), 1e-12);
    ck_assert_double_eq(holder_distance(&(struct holder){0}, c, up, c), HUGE_VAL);
}
END_TEST

/* Is the place r off the axis and h up it inside, by the words of the header? */
static bool holds(double r, double h)
{
    double from = 0;
    for (int i = 0; i < stack.n; i++) {
        const struct holder_part *part = &stack.part[i];
        double s = (h - from) / part->length;
        if (s >= 0 && s <= 1 && r < part->low + s * (part->high - part->low))
            return true;
        from += part->length;
    }
    return false;
}

/* A ball of the distance about p is all inside or all outside, and one little larger is not. */
START_TEST(distance_is_the_largest_ball)
{
    unsigned state = 5;
    struct vec3 axis = vec_unit(vec(0.3, -0.5, 0.8)), c = vec(-4, 7, 1);
    struct vec3 u = vec_perpendicular(axis), v = vec_cross(axis, u);
    for (int trial = 0; trial < 300; trial++) {
        double r = random_in(&state, 0, 40), h = random_in(&state, -20, 140);
        double turn = random_in(&state, 0, 6.28);
        struct vec3 out = vec_add(vec_scale(cos(turn), u), vec_scale(sin(turn), v));
        struct vec3 p = vec_along(vec_along(c, h, axis), r, out);
        double d = holder_distance(&stack, c, axis, p);
        bool inside = holds(r, h), left = false;
        ck_assert_int_eq(d < 0, inside);
        for (int i = 0; i < 3600; i++) {
            double way = i * (2 * PI / 3600), x = cos(way), y = sin(way);
            double near = fabs(d) - 1e-9, far = fabs(d) * 1.004 + 1e-3;
            ck_assert_int_eq(holds(fabs(r + near * x), h + near * y), inside);
            left = left || holds(fabs(r + far * x), h + far * y) != inside;
        }
        ck_assert(left);
    }
}
END_TEST

/* A bound holds for all places of its box; a flat box across the axis in a wide part is met. */
START_TEST(bound_of_a_box)
{
    unsigned state = 9;
    struct vec3 c = vec(2, -3, 5);
    for (int trial = 0; trial < 600; trial++) {
        struct vec3 axis = vec_unit(vec(random_in(&state, -1, 1), random_in(&state, -1, 1), 1));
        struct vec3 middle = vec(random_in(&state, -30, 30), random_in(&state, -30, 30),
                                 random_in(&state, -10, 130));
        struct vec3 half = vec(random_in(&state, 0, 9), random_in(&state, 0, 9),
                               random_in(&state, 0, trial % 2 ? 9 : 0.1));
        double bound = holder_bound(&stack, c, axis, middle, half), least = HUGE_VAL;
        for (int i = 0; i < 300; i++) {
            struct vec3 p = vec_add(middle, vec(half.x * random_in(&state, -1, 1),
                                                half.y * random_in(&state, -1, 1),
                                                half.z * random_in(&state, -1, 1)));
            double d = holder_distance(&stack, c, axis, p), below = random_in(&state, -6, 30);
            double told = holder_distance_below(&stack, c, axis, p, below);
            ck_assert(d < below ? told == d : told >= below);
            least = fmin(least, d);
        }
        ck_assert_msg(bound <= least, "%d: %.9f, found %.9f", trial, bound, least);
        ck_assert_double_ge(bound, least - 2 * vec_length(half));
        double some = random_in(&state, -6, 30);
        double quick = holder_bound_below(&stack, c, axis, middle, half, some);
        ck_assert(quick <= bound && (quick == bound || quick > some - 1e-8));
    }
    struct vec3 flat = vec(4, 4, 0), up = vec(0, 0, 1);
    ck_assert_double_eq_tol(holder_bound(&stack, c, up, vec_along(c, 113, up), flat), -7, 1e-12);
}
END_TEST

/* A wall that a stack all but touches, or is a little in, is told by its box as a whole, though its
 * middle is far off: also by a tool that leans along it. */
START_TEST(bound_beside_a_wall)
{
    const struct holder tool = {2, {{5, 5, 20}, {5, 5, 10}}};
    struct vec3 c = vec(2, -3, 5);
    for (int i = 0; i < 9; i++) {
        double lean = RADIANS(10 * (i - 4)), off = 5 - 0.003 * (i % 3 - 1);
        struct vec3 axis = vec(sin(lean), 0, cos(lean));
        struct vec3 middle = vec(c.x + 25, c.y + off, c.z + 15), wall = vec(40, 0, 30);
        ck_assert_double_eq_tol(holder_bound(&tool, c, axis, middle, wall), off - 5, 1e-8);
    }
}
END_TEST

/* The same for a cylinder; the distance itself where it is below what is asked for. */
START_TEST(bound_beside_a_cylinder)
{
    unsigned state = 9;
    const struct holder cylinder = {1, {{5, 5, 40}}};
    struct vec3 c = vec(2, -3, 5);
    for (int trial = 0; trial < 600; trial++) {
        struct vec3 axis = vec_unit(vec(random_in(&state, -1, 1), random_in(&state, -1, 1), 1));
        struct vec3 middle =
            vec(random_in(&state, -20, 20), random_in(&state, -20, 20), random_in(&state, -10, 60));
        struct vec3 half = vec(random_in(&state, 0, 9), random_in(&state, 0, 9),
                               random_in(&state, 0, trial % 2 ? 9 : 0.1));
        double bound = holder_bound(&cylinder, c, axis, middle, half), least = HUGE_VAL;
        for (int i = 0; i < 300; i++) {
            struct vec3 p = vec_add(middle, vec(half.x * random_in(&state, -1, 1),
                                                half.y * random_in(&state, -1, 1),
                                                half.z * random_in(&state, -1, 1)));
            double d = holder_distance(&cylinder, c, axis, p), below = random_in(&state, -6, 30);
            double told = holder_distance_below(&cylinder, c, axis, p, below);
            ck_assert(d < below ? told == d : told >= below);
            least = fmin(least, d);
        }
        ck_assert_msg(bound <= least, "%d: %.9f, found %.9f", trial, bound, least);
        ck_assert_double_ge(bound, least - 3 * vec_length(half));
        double some = random_in(&state, -6, 30);
        double quick = holder_bound_below(&cylinder, c, axis, middle, half, some);
        ck_assert(quick <= bound && (quick == bound || quick > some - 1e-8));
    }
    struct vec3 beside = vec_add(c, vec(9, 0, 20)), flat = vec(1, 8, 8), up = vec(0, 0, 1);
    ck_assert_double_eq_tol(holder_bound(&cylinder, c, up, beside, flat), 3, 1e-6);
}
END_TEST

/* The radius of a stack at a height, the larger one where two parts meet; 0 beyond its ends. */
static double radius_at(const struct holder *stack_of, double h)
{
    double from = 0, most = 0;
    for (int i = 0; i < stack_of->n; i++) {
        const struct holder_part *part = &stack_of->part[i];
        double s = (h - from) / part->length;
        if (s >= 0 && s <= 1)
            most = fmax(most, part->low + s * (part->high - part->low));
        from += part->length;
    }
    return most;
}

/* At each height the profile is the larger of both, whatever the shapes. */
START_TEST(profile_is_the_union)
{
    unsigned state = 9;
    for (int trial = 0; trial < 500; trial++) {
        struct tool_body body = {.flute = random_in(&state, 0, 60)};
        double radius = random_in(&state, 1, 12);
        body.above.n = (int)random_in(&state, 0, HOLDER_PARTS + 0.99);
        for (int i = 0; i < body.above.n; i++)
            body.above.part[i] = (struct holder_part){
                random_in(&state, 0, 20), random_in(&state, 0, 20), random_in(&state, 0.1, 15)};
        struct holder both = tool_body_profile(&body, radius);
        ck_assert_int_le(both.n, HOLDER_MOST);
        for (int k = 0; k < 200; k++) {
            double h = random_in(&state, 0, 200);
            double expected = fmax(radius_at(&body.above, h), h <= body.flute ? radius : 0);
            ck_assert_double_eq_tol(radius_at(&both, h), expected, 1e-6);
        }
    }
    ck_assert_int_eq(tool_body_profile(&(struct tool_body){.ball_only = true, .flute = 5}, 3).n, 0);
    struct tool_body plain = tool_body_usual(5);
    ck_assert_int_eq(tool_body_profile(&plain, 5).n, 1);
    ck_assert_double_eq(tool_body_profile(&plain, 5).part[0].length, 20);
}
END_TEST

START_TEST(widened_with_the_height)
{
    struct holder wide = holder_widened(&stack, 0.5, 0.01);
    for (double h = 0.25; h < 120; h += 0.5)
        ck_assert_double_eq_tol(radius_at(&wide, h), radius_at(&stack, h) + 0.5 + 0.01 * h, 1e-9);
    ck_assert_double_eq_tol(radius_at(&wide, 120.4), 26.7, 1e-9);
}
END_TEST

/* The least distance of places on a line, so far apart. */
static double line_distance(const struct holder *h, struct vec3 p, struct vec3 along, double gap)
{
    double least = HUGE_VAL;
    for (double s = -2; s <= 2; s += gap)
        least = fmin(least, holder_distance(h, vec(0, 0, 0), vec(0, 0, 1), vec_along(p, s, along)));
    return least;
}

/* Points a quarter of a millimetre apart on lines across its corners: what these let by is 0.1 mm
 * deep in the stack as it is, and found in what is kept clear. */
START_TEST(cornered)
{
    const double gap = 0.25, corner[][2] = {{3, 40}, {10, 40}, {25, 120}};
    const struct holder flute = {1, {{3, 3, 40}}};
    unsigned state = 11;
    size_t missed = 0, deep = 0;
    for (int trial = 0; trial < 3000; trial++) {
        int k = trial % 3;
        const struct holder *h = k == 0 ? &flute : &stack;
        struct holder kept = holder_cornered(h, gap);
        struct vec3 along = vec_unit(
            vec(random_in(&state, -1, 1), random_in(&state, -1, 1), random_in(&state, -1, 1)));
        struct vec3 p = vec(corner[k][0] - random_in(&state, 0, 0.1), 0,
                            corner[k][1] + (k == 1 ? 1 : -1) * random_in(&state, 0, 0.1));
        struct vec3 q = vec_along(p, random_in(&state, 0, gap), along);
        if (line_distance(h, p, along, 0.004) > -0.02)
            continue;
        deep++;
        missed += line_distance(h, q, along, gap) >= 0;
        ck_assert_double_lt(line_distance(&kept, q, along, gap), 0);
    }
    ck_assert_uint_gt(deep, 500);
    ck_assert_uint_gt(missed, 50);
    ck_assert_int_eq(holder_cornered(&(struct holder){0}, gap).n, 0);
}
END_TEST

START_TEST(texts_are_written)
{
    struct holder h;
    struct error error;
    char text[HOLDER_TEXT];
    holder_text_write(&stack, text);
    ck_assert_str_eq(text, "3:40+10:25:20+25:60");
    ck_assert_int_eq(holder_text_read("0.125:9999.5:0.25", &h, &error), 0);
    holder_text_write(&h, text);
    ck_assert_str_eq(text, "0.125:9999.5:0.25");
    h.n = 0;
    holder_text_write(&h, text);
    ck_assert_str_eq(text, "");
}
END_TEST

START_TEST(texts_are_read)
{
    struct holder h;
    struct error error;
    ck_assert_int_eq(holder_text_read("3:40+10:25:20+25:60", &h, &error), 0);
    ck_assert_int_eq(h.n, 3);
    for (int i = 0; i < 3; i++) {
        ck_assert_double_eq(h.part[i].low, stack.part[i].low);
        ck_assert_double_eq(h.part[i].high, stack.part[i].high);
        ck_assert_double_eq(h.part[i].length, stack.part[i].length);
    }
    ck_assert_int_eq(holder_text_read("0:4:2.5", &h, &error), 0);
    ck_assert_double_eq(h.part[0].low, 0);
}
END_TEST

static const char *const wrong[] = {"",         "3",       "3:",        "3:0",    "-3:4", "3:40+",
                                    "3:40,5:6", "1:2:3:4", "0:0:5",     "3:40 ",  "x",    "3:inf",
                                    "3:20000",  "+3:40+",  "3:40++3:4", "3:nan:4"};

START_TEST(other_texts_are_not)
{
    struct holder h;
    struct error error = {.text = ""};
    ck_assert_msg(holder_text_read(wrong[_i], &h, &error) < 0, "%s", wrong[_i]);
    ck_assert_ptr_nonnull(strstr(error.text, "found"));
}
END_TEST

START_TEST(no_more_parts_than_there_is_room_for)
{
    struct holder h;
    struct error error;
    char text[HOLDER_PARTS * 4 + 8] = "1:1";
    for (int i = 1; i < HOLDER_PARTS; i++)
        strcat(text, "+1:1");
    ck_assert_int_eq(holder_text_read(text, &h, &error), 0);
    strcat(text, "+1:1");
    ck_assert_int_lt(holder_text_read(text, &h, &error), 0);
}
END_TEST

int main(void)
{
    Suite *s = suite_create("holder");
    TCase *t = tcase_create("holder");
    tcase_set_timeout(t, 60);
    tcase_add_test(t, distances_known_by_hand);
    tcase_add_test(t, distance_is_the_largest_ball);
    tcase_add_test(t, bound_of_a_box);
    tcase_add_test(t, bound_beside_a_wall);
    tcase_add_test(t, bound_beside_a_cylinder);
    tcase_add_test(t, profile_is_the_union);
    tcase_add_test(t, widened_with_the_height);
    tcase_add_test(t, cornered);
    tcase_add_test(t, texts_are_written);
    tcase_add_test(t, texts_are_read);
    tcase_add_loop_test(t, other_texts_are_not, 0, (int)(sizeof wrong / sizeof *wrong));
    tcase_add_test(t, no_more_parts_than_there_is_room_for);
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed ? 1 : 0;
}
