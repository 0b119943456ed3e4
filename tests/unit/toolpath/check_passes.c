/* passes: chains put in order, joined, turned round, rolled over edges. */
#include <check.h>
#include <stdlib.h>

#include "toolpath/passes.h"
#include "shapes.h"

static struct pass_options rule_of(double gap)
{
    return (struct pass_options){.normal = vec(0, 1, 0),
                                 .along = vec(1, 0, 0),
                                 .gap = gap,
                                 .facing = vec(0, 0, 1),
                                 .radius = 5,
                                 .tolerance = 0.002};
}

/* A straight chain of points a tenth apart, level at height z, the normal up. */
static void add(struct slice_chains *chains, double from, double to, double z)
{
    size_t begin = chains->point.n;
    int n = (int)lround(fabs(to - from) * 10);

    for (int i = 0; i <= n; i++)
        *array_push(&chains->point) =
            (struct contact){vec(from + (to - from) * i / n, 0, z), vec(0, 0, 1)};
    *array_push(&chains->chain) = (struct slice_chain){begin, chains->point.n, false};
}

static const struct contact *first(const struct slice_chains *c, size_t k)
{
    return &c->point.item[c->chain.item[k].from];
}

static const struct contact *last(const struct slice_chains *c, size_t k)
{
    return &c->point.item[c->chain.item[k].to - 1];
}

START_TEST(chains_follow_each_other_and_join)
{
    struct slice_chains chains = {0}, strips = {0};
    struct pass_options rule = rule_of(0.3);

    add(&chains, 5, 8, 0);
    add(&chains, 12, 9, 0); /* the other way round, a gap of 1 */
    add(&chains, 0, 5, 0);  /* adjoins the first */
    add(&chains, 14, 12.2, 0);
    ck_assert_uint_eq(passes_make(&chains, &rule, &strips), 0);
    ck_assert_uint_eq(strips.chain.n, 2);
    ck_assert_double_eq(first(&strips, 0)->p.x, 0);
    ck_assert_double_eq(last(&strips, 0)->p.x, 8);
    ck_assert_double_eq(first(&strips, 1)->p.x, 9);
    ck_assert_double_eq(last(&strips, 1)->p.x, 14);
    /* The point that adjoining chains share is there once. */
    ck_assert_uint_eq(strips.chain.item[0].to, 81);
    for (size_t i = 0; i + 1 < strips.point.n; i++)
        ck_assert_double_gt(strips.point.item[i + 1].p.x, strips.point.item[i].p.x);
    passes_reverse(&strips);
    ck_assert_double_eq(first(&strips, 0)->p.x, 14);
    ck_assert_double_eq(last(&strips, 0)->p.x, 9);
    ck_assert_double_eq(first(&strips, 1)->p.x, 8);
    ck_assert_double_eq(last(&strips, 1)->p.x, 0);
    slice_chains_free(&chains);
    slice_chains_free(&strips);
}
END_TEST

/* A gap of 3 mm over a scan that goes on there, and over a hole of it. */
START_TEST(no_join_over_a_hole_of_the_scan)
{
    for (int hole = 0; hole < 2; hole++) {
        struct vec3s scan = {0};
        for (int i = 0; i <= 100; i++)
            for (int k = -10; k <= 10; k++)
                if (!hole || i < 40 || i > 70)
                    *array_push(&scan) = vec(0.1 * i, 0.1 * k, 0);
        struct gouge_check *guard = gouge_from_points(scan.item, scan.n);
        struct slice_chains chains = {0}, strips = {0};
        struct pass_options rule = rule_of(4);
        rule.guard = guard;
        rule.bare = 1.2;
        add(&chains, 0, 4, 0);
        add(&chains, 7, 10, 0);
        passes_make(&chains, &rule, &strips);
        ck_assert_uint_eq(strips.chain.n, hole ? 2 : 1);
        slice_chains_free(&chains);
        slice_chains_free(&strips);
        gouge_free(guard);
        array_free(&scan);
    }
}
END_TEST

START_TEST(the_nearest_goes_on_not_the_next)
{
    struct slice_chains chains = {0}, strips = {0};
    struct pass_options rule = rule_of(0.3);

    /* Two levels, as of two surfaces over each other, both in two parts. */
    add(&chains, 0, 5, 0);
    add(&chains, 0.5, 4.9, 7);
    add(&chains, 5.05, 9, 7);
    add(&chains, 5.1, 9, 0);
    passes_make(&chains, &rule, &strips);
    ck_assert_uint_eq(strips.chain.n, 2);
    for (size_t k = 0; k < 2; k++)
        ck_assert_double_eq(first(&strips, k)->p.z, last(&strips, k)->p.z);
    slice_chains_free(&chains);
    slice_chains_free(&strips);
}
END_TEST

/* A chain of 11 points from a to b. */
static void add_straight(struct slice_chains *chains, struct vec3 a, struct vec3 b, struct vec3 n)
{
    size_t begin = chains->point.n;

    for (int i = 0; i <= 10; i++)
        *array_push(&chains->point) = (struct contact){vec_mix(a, b, i / 10.0), n};
    *array_push(&chains->chain) = (struct slice_chain){begin, chains->point.n, false};
}

/* Two walls of a box and what is between them, of surfaces of their own: in whatever order and
 * whichever way round they come, they are cut in one, along.  The walls begin where the top
 * does. */
START_TEST(walls_and_top_are_one_strip)
{
    static const int order[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                    {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    const struct vec3 corner[4] = {{0, 0, 0}, {0, 0, 5}, {10, 0, 5}, {10, 0, 0}};
    const struct vec3 normal[3] = {{-1, 0, 0}, {0, 0, 1}, {1, 0, 0}};
    struct pass_options rule = rule_of(0.3);

    for (int turn = 0; turn < 48; turn++) {
        struct slice_chains chains = {0}, strips = {0};
        for (int k = 0; k < 3; k++) {
            int side = order[turn / 8][k], back = turn >> side & 1;
            add_straight(&chains, corner[side + back], corner[side + 1 - back], normal[side]);
        }
        passes_make(&chains, &rule, &strips);
        ck_assert_uint_eq(strips.chain.n, 1);
        ck_assert_double_eq(first(&strips, 0)->p.x, 0);
        ck_assert_double_eq(first(&strips, 0)->p.z, 0);
        ck_assert_double_eq(last(&strips, 0)->p.x, 10);
        ck_assert_double_eq(last(&strips, 0)->p.z, 0);
        slice_chains_free(&chains);
        slice_chains_free(&strips);
    }
}
END_TEST

/* Four sides that lead round to each other: one strip from where they lie least along. */
START_TEST(sides_of_a_ring_are_one_strip)
{
    const struct vec3 corner[5] = {{0, 0, 3}, {4, 0, 5}, {9, 0, 3}, {4, 0, 1}, {0, 0, 3}};

    for (int back = 0; back < 16; back++) {
        struct slice_chains chains = {0}, strips = {0};
        struct pass_options rule = rule_of(0.3);
        for (int k = 0; k < 4; k++) {
            int turned = back >> k & 1;
            add_straight(&chains, corner[k + turned], corner[k + 1 - turned], vec(0, 0, 1));
        }
        passes_make(&chains, &rule, &strips);
        ck_assert_uint_eq(strips.chain.n, 1);
        ck_assert_double_eq(first(&strips, 0)->p.x, 0);
        ck_assert_double_eq(last(&strips, 0)->p.x, 0);
        slice_chains_free(&chains);
        slice_chains_free(&strips);
    }
}
END_TEST

/* A roof: 60 degrees up, then down.  Straight lines between centres sink into the ridge. */
START_TEST(a_ridge_is_rolled_over)
{
    struct slice_chains chains = {0}, strips = {0};
    struct pass_options rule = rule_of(0.3);
    double slope = RADIANS(60), deepest = 0;

    for (int side = -1; side <= 1; side += 2) {
        size_t begin = chains.point.n;
        struct vec3 n = vec(side * sin(slope), 0, cos(slope));
        for (int i = 0; i <= 10; i++) {
            double x = side < 0 ? i - 10 : i;
            *array_push(&chains.point) = (struct contact){vec(x, 0, -fabs(x) * tan(slope)), n};
        }
        *array_push(&chains.chain) = (struct slice_chain){begin, chains.point.n, false};
    }
    passes_make(&chains, &rule, &strips);
    ck_assert_uint_eq(strips.chain.n, 1);
    for (size_t i = 0; i + 1 < strips.point.n; i++) {
        const struct contact *c = &strips.point.item[i];
        struct vec3 a = vec_along(c[0].p, 5, c[0].n), b = vec_along(c[1].p, 5, c[1].n);
        for (double s = 0; s <= 1; s += 0.1)
            deepest = fmax(deepest, 5 - vec_length(vec_mix(a, b, s)));
    }
    ck_assert_double_lt(deepest, 0.0021);
    ck_assert_double_gt(deepest, 0.0005);
    /* A valley has no points between. */
    strips.point.n = strips.chain.n = 0;
    for (size_t i = 0; i < chains.point.n; i++) {
        chains.point.item[i].p.z *= -1;
        chains.point.item[i].n.x *= -1;
    }
    passes_make(&chains, &rule, &strips);
    ck_assert_uint_eq(strips.chain.n, 1);
    ck_assert_uint_eq(strips.point.n, 22);
    slice_chains_free(&chains);
    slice_chains_free(&strips);
}
END_TEST

/* Rings of a ball in upright and level planes. */
static struct slice_chains ring(struct vec3 normal, double height)
{
    struct mesh mesh = shape_ball(50, 40, 60);
    struct slice_chains chains = {0};
    struct slice *cut = slice_new(&mesh, normal, true, 1);

    slice_at(cut, height, &chains);
    slice_free(cut);
    mesh_free(&mesh);
    return chains;
}

START_TEST(a_ring_starts_at_its_end_and_goes_over_the_top)
{
    struct pass_options rule = rule_of(0.1);

    for (int turned = 0; turned < 2; turned++) {
        struct slice_chains chains, strips = {0};
        rule.normal = vec(0, turned ? -1 : 1, 0);
        chains = ring(rule.normal, turned ? -7.3 : 7.3);
        passes_make(&chains, &rule, &strips);
        ck_assert_uint_eq(strips.chain.n, 1);
        ck_assert(strips.chain.item[0].closed);
        ck_assert_double_lt(first(&strips, 0)->p.x, -49);
        ck_assert_double_eq(vec_distance(first(&strips, 0)->p, last(&strips, 0)->p), 0);
        ck_assert_double_gt(strips.point.item[10].p.z, 1);
        struct vec3 plane = passes_forward(&strips, 0, rule.normal);
        ck_assert_double_gt(vec_cross(plane, vec(0, 0, 1)).x, 0.99);
        slice_chains_free(&chains);
        slice_chains_free(&strips);
    }
}
END_TEST

START_TEST(what_faces_away_is_left_out)
{
    struct pass_options rule = rule_of(0.1);
    struct slice_chains chains = ring(vec(0, 1, 0), 7.3), strips = {0};

    rule.faced = true;
    rule.normal = vec(0, 1, 0);
    size_t left_out = passes_make(&chains, &rule, &strips);
    ck_assert_uint_eq(strips.chain.n, 1);
    ck_assert(!strips.chain.item[0].closed);
    ck_assert_uint_eq(left_out + strips.point.n + 1, chains.point.n);
    ck_assert_uint_gt(left_out, 30);
    for (size_t i = 0; i < strips.point.n; i++)
        ck_assert_double_ge(strips.point.item[i].p.z, -1e-4);
    for (size_t i = 0; i + 1 < strips.point.n; i++)
        ck_assert_double_gt(strips.point.item[i + 1].p.x, strips.point.item[i].p.x - 1e-9);
    slice_chains_free(&chains);
    slice_chains_free(&strips);
}
END_TEST

START_TEST(the_direction_of_passes)
{
    ck_assert_double_lt(vec_distance(passes_along(vec(0, 1, 0)), vec(1, 0, 0)), 1e-12);
    ck_assert_double_lt(vec_distance(passes_along(vec(0, 0, -1)), vec(1, 0, 0)), 1e-12);
    struct vec3 slanted = vec_unit(vec(1, 2, 3));
    ck_assert_double_eq_tol(vec_dot(passes_along(slanted), slanted), 0, 1e-12);
    ck_assert_double_eq_tol(passes_along(slanted).z, 0, 1e-12);
    ck_assert_double_gt(vec_dot(vec_cross(vec(0, 0, 1), passes_along(slanted)), slanted), 0);
}
END_TEST

/* ---- a sharp edge */

START_TEST(chords_sink_as_told)
{
    for (double angle = 5; angle <= 120; angle += 5) {
        const double radius = 4, tolerance = 0.01;
        struct contacts to = {0};
        struct contact last = {{0, 0, 0}, {0, 0, 1}}, next = last;
        next.n = vec(sin(RADIANS(angle)), 0, cos(RADIANS(angle)));
        *array_push(&to) = last;
        edge_roll(&to, vec(1, 0, 0), last, next, radius, tolerance);
        *array_push(&to) = next;
        for (size_t i = 1; i < to.n; i++) {
            double turn = vec_angle(to.item[i - 1].n, to.item[i].n);
            ck_assert_double_le(radius * (1 - cos(turn / 2)), tolerance + 1e-9);
        }
        ck_assert_double_lt((double)to.n - 2, RADIANS(angle) / (2 * acos(1 - tolerance / radius)));
        array_free(&to);
    }
}
END_TEST

START_TEST(none_in_a_valley)
{
    struct contacts to = {0};
    struct contact last = {{0, 0, 0}, {0.6, 0, 0.8}}, next = {{0, 0, 0}, {-0.6, 0, 0.8}};
    edge_roll(&to, vec(1, 0, 0), last, next, 4, 0.01);
    ck_assert_uint_eq(to.n, 0);
    edge_roll(&to, vec(-1, 0, 0), last, next, 4, 0.01);
    ck_assert_uint_gt(to.n, 5);
    array_free(&to);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("passes");
    TCase *tests = tcase_create("passes");
    tcase_add_test(tests, chains_follow_each_other_and_join);
    tcase_add_test(tests, no_join_over_a_hole_of_the_scan);
    tcase_add_test(tests, the_nearest_goes_on_not_the_next);
    tcase_add_test(tests, walls_and_top_are_one_strip);
    tcase_add_test(tests, sides_of_a_ring_are_one_strip);
    tcase_add_test(tests, a_ridge_is_rolled_over);
    tcase_add_test(tests, a_ring_starts_at_its_end_and_goes_over_the_top);
    tcase_add_test(tests, what_faces_away_is_left_out);
    tcase_add_test(tests, the_direction_of_passes);
    tcase_add_test(tests, chords_sink_as_told);
    tcase_add_test(tests, none_in_a_valley);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
