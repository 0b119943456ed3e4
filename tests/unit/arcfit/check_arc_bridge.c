/* Tests of arcfit_bridge and arcfit_cut: short pieces put into a chain that keeps the tolerance are
 * gone round. */
#include "arcfit/arcfit.h"

#include <check.h>
#include <stdlib.h>

#include "trial.h"

static const struct deviation WITHIN = {0.01, 0.01, 0.02};
static const double LEAST = 0.0205;

/* The pieces with piece `at` divided, `length` mm from its start or (`end`) its end, with a kink of
 * so many radians there. */
static struct pieces divided(const struct pieces *all, size_t at, double length, bool end,
                             double kink)
{
    struct pieces p = {0};
    for (size_t i = 0; i < all->n; i++) {
        const struct arc_piece *old = &all->item[i];
        double s = length / arc_length(&old->arc), place;
        s = end ? 1 - s : s;
        place = old->from + s * (old->to - old->from);
        if (i != at) {
            *array_push(&p) = *old;
            continue;
        }
        struct arc_piece a = *old, b = *old;
        struct vec3 joint = arc_at(&old->arc, s);
        struct vec3 side = vec_perpendicular(old->arc.tangent);
        struct vec3 ahead = vec_unit(vec_along(arc_tangent(&old->arc, s), kink, side));
        a.arc = arc_to(old->arc.from, old->arc.tangent, joint);
        b.arc = arc_to(joint, ahead, old->arc.to);
        a.to = b.from = place;
        a.axis_to = b.axis = vec_slerp(old->axis, old->axis_to, s);
        *array_push(&p) = a;
        *array_push(&p) = b;
    }
    return p;
}

static double shortest(const struct pieces *p)
{
    double least = HUGE_VAL;
    for (size_t i = 0; i < p->n; i++)
        least = fmin(least, vec_distance(p->item[i].arc.from, p->item[i].arc.to));
    return least;
}

static void assert_gone(double lean, double kink, size_t more)
{
    struct reference t = trial_wave(401, 0.25, lean, 0);
    struct pieces whole = {0};
    int smooth = 0;
    const struct deviation close = {0.0099, 0.0099, 0.0199};
    arcfit_beam(&t, &close, 6, ARCFIT_THOROUGH, &whole);
    ck_assert_uint_gt(whole.n, 5);
    for (size_t at = 0; at < whole.n; at++)
        for (int end = 0; end < 2; end++) {
            double length = at % 2 ? 0.013 : 0.0007;
            struct pieces p = divided(&whole, at, length, end, kink);
            bool was_smooth = arcfit_smooth(&p, 0, p.n); /* a short arc may count as straight */
            ck_assert_double_lt(shortest(&p), 0.014);
            ck_assert_uint_eq(arcfit_bridge(&t, &WITHIN, 6, LEAST, &p), 0);
            ck_assert_double_ge(shortest(&p), 0.02);
            ck_assert_uint_le(p.n, whole.n + more);
            smooth += was_smooth;
            if (was_smooth)
                trial_assert_chain(&t, &WITHIN, &p);
            array_free(&p);
        }
    ck_assert(kink > 0 || smooth > (int)whole.n);
    array_free(&whole);
    reference_free(&t);
}

START_TEST(a_fixed_axis)
{
    assert_gone(0, 0, 2);
}
END_TEST

START_TEST(a_turning_axis)
{
    assert_gone(0.3, 0, 2);
}
END_TEST

START_TEST(beside_a_kink)
{
    assert_gone(0, 0.002, 3);
}
END_TEST

/* Three in a row at the start of a chain, or at its end: none of them with its neighbour is
 * long. */
START_TEST(several_in_a_row)
{
    struct reference t = trial_wave(401, 0.25, 0, 0);
    for (int end = 0; end < 2; end++) {
        struct pieces p = {0};
        const struct deviation close = {0.0099, 0.0099, 0.0199};
        arcfit_beam(&t, &close, 6, ARCFIT_THOROUGH, &p);
        for (size_t i = 0; i < 3; i++) {
            struct pieces more =
                divided(&p, end ? p.n - 1 - i : i, 0.005 + 0.001 * (double)i, end, 0);
            array_free(&p);
            p = more;
        }
        size_t n = p.n;
        ck_assert_double_lt(shortest(&p), 0.0051);
        ck_assert_uint_eq(arcfit_bridge(&t, &WITHIN, 6, LEAST, &p), 0);
        ck_assert_double_ge(shortest(&p), 0.0205);
        ck_assert_uint_lt(p.n, n);
        trial_assert_chain(&t, &WITHIN, &p);
        array_free(&p);
    }
    reference_free(&t);
}
END_TEST

/* A piece that bends back is as short as its ends are apart. */
START_TEST(a_bent_one)
{
    struct reference t = {0};
    struct pieces p = {0};
    struct run run = {.radius = 1};
    for (int i = 0; i <= 80; i++) { /* a line, a quarter of a circle of 0.0132 mm, a line */
        double s = i - 40, a = RADIANS(45);
        struct vec3 at = s < 0 ? vec(0.02 * s, 0, 0) : vec(0.0132, 0.0132 + 0.02 * s, 0);
        if (i == 40)
            at = vec(0.0132 * sin(a), 0.0132 * (1 - cos(a)), 0);
        struct run_point point = {.ball = at, .axis = vec(0, 0, 1), .given = true};
        point.tip = vec_along(at, -1, point.axis);
        *array_push(&run) = point;
    }
    t = reference_of(&run, 0, run.n, true, false);
    struct vec3 x = vec(1, 0, 0), y = vec(0, 1, 0);
    struct vec3 a = vec(0, 0, 0), b = vec(0.0132, 0.0132, 0);
    *array_push(&p) = arc_piece_of(&t, arc_to(run.item[0].ball, x, a), 0, 39.5);
    *array_push(&p) = arc_piece_of(&t, arc_to(a, x, b), 39.5, 40.5);
    *array_push(&p) = arc_piece_of(&t, arc_to(b, y, run.item[80].ball), 40.5, 80);
    ck_assert_double_gt(arc_length(&p.item[1].arc), LEAST);
    ck_assert_double_lt(shortest(&p), 0.0188);
    ck_assert_uint_eq(arcfit_bridge(&t, &WITHIN, 6, LEAST, &p), 0);
    ck_assert_double_ge(shortest(&p), LEAST);
    array_free(&p);
    array_free(&run);
    reference_free(&t);
}
END_TEST

START_TEST(long_pieces_stay)
{
    struct reference t = trial_wave(201, 0.25, 0, 0);
    struct pieces p = {0};
    arcfit_beam(&t, &WITHIN, 6, ARCFIT_THOROUGH, &p);
    struct pieces before = divided(&p, p.n, 0, false, 0);
    ck_assert_uint_eq(arcfit_bridge(&t, &WITHIN, 6, LEAST, &p), 0);
    ck_assert_uint_eq(p.n, before.n);
    for (size_t i = 0; i < p.n; i++)
        ck_assert_double_eq(vec_distance(p.item[i].arc.to, before.item[i].arc.to), 0);
    array_free(&p);
    array_free(&before);
    reference_free(&t);
}
END_TEST

/* The way turns by 130 degrees 0.023 mm behind its start, or turned round before its end: no smooth
 * chain has room there, a line to the corner and an arc from there on does. */
START_TEST(cut_by_a_line)
{
    static const struct deviation within = {0.0093, 0.0093, 0.0199};
    for (int back = 0; back < 2; back++) {
        struct run run = {.radius = 3};
        struct pieces p = {0};
        const double corner = 0.0231, side = RADIANS(130), first = 0.0187;
        for (int i = 0; i <= 40; i++) {
            double s = i < 2 ? 0 : 0.01 * (i - 1), u = i < 1 ? 0 : corner;
            struct vec3 at = vec(u + s * cos(side), s * sin(side), 0);
            struct run_point point = {.ball = at, .axis = vec(0, 0, 1), .given = true};
            point.tip = vec_along(at, -3, point.axis);
            *array_push(&run) = point;
        }
        if (back)
            for (size_t i = 0; i < run.n / 2; i++) {
                struct run_point one = run.item[i];
                run.item[i] = run.item[run.n - 1 - i];
                run.item[run.n - 1 - i] = one;
            }
        struct reference t = reference_of(&run, 0, run.n, true, false);
        struct vec3 from = run.item[0].ball, to = run.item[run.n - 1].ball;
        struct vec3 joint = vec(first * cos(0.45), first * sin(0.45), 0);
        double at = back ? (double)t.n - 1.9 : 0.9;
        *array_push(&p) = arc_piece_of(&t, arc_line(from, joint), 0, at);
        *array_push(&p) = arc_piece_of(&t, arc_line(joint, to), at, (double)(t.n - 1));
        ck_assert_uint_eq(arcfit_bridge(&t, &within, 6, LEAST, &p), 1);
        ck_assert_uint_eq(arcfit_cut(&t, &within, 6, LEAST, &p), 0);
        ck_assert_double_ge(shortest(&p), LEAST);
        for (size_t i = 0; i < p.n; i++) {
            struct deviation off = arc_piece_deviation(&t, &p.item[i], 16, &within);
            ck_assert(deviation_within(&off, &within));
            if (i > 0)
                ck_assert_double_eq(vec_distance(p.item[i - 1].arc.to, p.item[i].arc.from), 0);
        }
        ck_assert_double_eq(vec_distance(p.item[0].arc.from, from), 0);
        ck_assert_double_eq(vec_distance(p.item[p.n - 1].arc.to, to), 0);
        array_free(&p);
        array_free(&run);
        reference_free(&t);
    }
}
END_TEST

/* Zigzags of 0.01 mm with no room beside them: they are told, and stay. */
START_TEST(no_room)
{
    struct reference t = trial_wave(5, 0.01, 0, 0);
    const struct deviation none = {1e-7, 1e-7, 1e-7};
    struct pieces p = {0};
    for (size_t i = 0; i + 1 < t.n; i++)
        *array_push(&p) =
            arc_piece_of(&t, arc_line(t.point[i], t.point[i + 1]), (double)i, (double)(i + 1));
    ck_assert_uint_eq(arcfit_bridge(&t, &none, 6, LEAST, &p), 4);
    ck_assert_uint_eq(p.n, 4);
    array_free(&p);
    reference_free(&t);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("arc_bridge");
    tcase_set_timeout(t, 20);
    tcase_add_test(t, a_fixed_axis);
    tcase_add_test(t, a_turning_axis);
    tcase_add_test(t, beside_a_kink);
    tcase_add_test(t, several_in_a_row);
    tcase_add_test(t, a_bent_one);
    tcase_add_test(t, long_pieces_stay);
    tcase_add_test(t, cut_by_a_line);
    tcase_add_test(t, no_room);
    Suite *s = suite_create("arc_bridge");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
