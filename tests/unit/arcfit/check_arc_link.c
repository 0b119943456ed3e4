/* Tests of arcfit_link: few pieces, in the directions of the cuts, where they are said to be clear.
 */
#include "arcfit/arc_link.h"

#include <check.h>
#include <stdlib.h>

static const double RADIUS = 5, LEAST = 0.02;

/* A way over a plane from the origin, which leads ahead in x and to the side in y; the tool stands
 * on it. */
static struct reference way(double ahead, double side, size_t n)
{
    struct run run = {.radius = RADIUS};

    for (size_t i = 0; i < n; i++) {
        double s = (double)i / (double)(n - 1);
        struct run_point p = {.axis = {0, 0, 1}, .given = true};
        p.tip = vec(ahead * s + sin(PI * s), side * (1 - cos(PI * s)) / 2, 0);
        p.ball = vec(p.tip.x, p.tip.y, RADIUS);
        *array_push(&run) = p;
    }
    struct reference r = reference_of(&run, 0, run.n, false, false);
    array_free(&run);
    return r;
}

/* The highest place of the pieces, and where the tool is clear: above `wall` where x is above
 * `from`. */
struct ground {
    double wall, from;
    size_t asked;
};

static bool is_clear(void *context, const struct pieces *pieces)
{
    struct ground *g = context;

    g->asked++;
    for (size_t i = 0; i < pieces->n; i++)
        for (int k = 0; k <= 20; k++) {
            struct vec3 p = arc_at(&pieces->item[i].arc, k / 20.0);
            if (p.x > g->from && p.z < g->wall)
                return false;
        }
    return true;
}

static struct arc_link_options options_of(struct ground *ground, struct vec3 leave,
                                          struct vec3 arrive)
{
    return (struct arc_link_options){.leave = leave,
                                     .arrive = arrive,
                                     .off = RADIUS / 2,
                                     .below = 0.01,
                                     .least = LEAST,
                                     .digits = 6,
                                     .clear = is_clear,
                                     .context = ground};
}

/* From end to end without a step; at joints without a kink, at both ends with one no larger than
 * `kink`. */
static void assert_led(const struct reference *r, const struct pieces *p, struct vec3 leave,
                       struct vec3 arrive, double kink)
{
    const struct arc *last = &p->item[p->n - 1].arc;

    ck_assert_double_lt(vec_distance(p->item[0].arc.from, r->point[0]), 1e-9);
    ck_assert_double_lt(vec_distance(last->to, r->point[r->n - 1]), 1e-9);
    ck_assert_double_le(vec_angle(p->item[0].arc.tangent, leave), kink);
    ck_assert_double_le(vec_angle(arc_tangent(last, 1), arrive), kink);
    for (size_t i = 0; i < p->n; i++) {
        ck_assert_double_ge(arc_length(&p->item[i].arc), LEAST);
        if (i == 0)
            continue;
        const struct arc *a = &p->item[i - 1].arc, *b = &p->item[i].arc;
        ck_assert_double_lt(vec_distance(a->to, b->from), 1e-9);
        ck_assert_double_lt(vec_angle(arc_tangent(a, 1), b->tangent), RADIANS(0.01));
    }
}

/* Round from one row into the next, which begin beside each other: half a circle. */
START_TEST(one_arc_from_row_to_row)
{
    struct reference r = way(0, 2, 65);
    struct ground flat = {-1, 0, 0};
    struct arc_link_options o = options_of(&flat, vec(1, 0, 0), vec(-1, 0, 0));
    struct pieces p = {0};

    ck_assert(arcfit_link(&r, &o, &p));
    ck_assert_uint_eq(p.n, 1);
    assert_led(&r, &p, o.leave, o.arrive, 1e-6);
    ck_assert_double_lt(fabs(p.item[0].arc.radius - 1), 1e-9);
    array_free(&p);
    reference_free(&r);
}
END_TEST

/* Rows that do not end beside each other take two, and no kink. */
START_TEST(two_where_the_rows_are_of_other_lengths)
{
    struct reference r = way(1.5, 2, 65);
    struct ground flat = {-1, 0, 0};
    struct arc_link_options o = options_of(&flat, vec(1, 0, 0), vec(-1, 0, 0));
    struct pieces p = {0};

    ck_assert(arcfit_link(&r, &o, &p));
    ck_assert_uint_eq(p.n, 2);
    assert_led(&r, &p, o.leave, o.arrive, 1e-6);
    array_free(&p);
    reference_free(&r);
}
END_TEST

/* Something low is in the way: over it, by directions that are turned up a little. */
START_TEST(over_what_is_in_the_way)
{
    struct reference r = way(0, 2, 65);
    struct ground step = {0.05, 0.6, 0};
    struct arc_link_options o = options_of(&step, vec(1, 0, 0), vec(-1, 0, 0));
    struct pieces p = {0};

    ck_assert(arcfit_link(&r, &o, &p));
    ck_assert_uint_gt(p.n, 0);
    assert_led(&r, &p, o.leave, o.arrive, ARC_LINK_KINK + 1e-9);
    ck_assert(is_clear(&step, &p));
    array_free(&p);
    reference_free(&r);
}
END_TEST

/* It goes no further off its way than it may, and gives up where nothing is clear. */
START_TEST(nothing_where_nothing_is_clear)
{
    struct reference r = way(0, 2, 65);
    struct ground high = {1, 0.5, 0};
    struct arc_link_options o = options_of(&high, vec(1, 0, 0), vec(-1, 0, 0));
    struct pieces p = {0};

    ck_assert(!arcfit_link(&r, &o, &p));
    ck_assert_uint_eq(p.n, 0);
    ck_assert_uint_gt(high.asked, 0);
    o.off = 1e-4;
    high = (struct ground){-1, 0, 0};
    if (arcfit_link(&r, &o, &p))
        for (size_t i = 0; i < p.n; i++) {
            struct deviation d = arc_piece_deviation(&r, &p.item[i], 8, NULL);
            ck_assert_double_le(d.point, o.off + 1e-9);
        }
    array_free(&p);
    reference_free(&r);
}
END_TEST

/* The same half circle with a tool that leans by 25 degrees to one side, behind and to the other:
 * an arc would bring it there over the upright, though no further off than a link may be. */
START_TEST(axes_go_as_they_were_planned)
{
    struct run run = {.radius = RADIUS};
    const double lean = RADIANS(25);

    for (int i = 0; i <= 64; i++) {
        double s = PI * i / 64, turn = PI / 2 + s;
        struct run_point p = {.given = true, .tip = vec(sin(s), 1 - cos(s), 0)};
        p.axis = vec(sin(lean) * cos(turn), sin(lean) * sin(turn), cos(lean));
        p.ball = vec_along(p.tip, RADIUS, p.axis);
        *array_push(&run) = p;
    }
    struct reference r = reference_of(&run, 0, run.n, false, false);
    struct ground flat = {-1, 0, 0};
    struct arc_link_options o = options_of(&flat, vec(1, 0, 0), vec(-1, 0, 0));
    struct pieces p = {0};
    ck_assert(arcfit_link(&r, &o, &p));
    for (size_t i = 0; i < p.n; i++)
        for (int k = 0; k <= 8; k++) {
            struct vec3 axis = vec_slerp(p.item[i].axis, p.item[i].axis_to, k / 8.0);
            struct vec3 at = arc_at(&p.item[i].arc, k / 8.0);
            size_t place = (size_t)(reference_place(&r, at, p.item[i].from) + 0.5);
            ck_assert_double_lt(vec_angle(axis, r.axis[place]), RADIANS(4));
        }
    array_free(&p);
    array_free(&run);
    reference_free(&r);
}
END_TEST

int main(void)
{
    TCase *t = tcase_create("arc_link");
    tcase_add_test(t, one_arc_from_row_to_row);
    tcase_add_test(t, two_where_the_rows_are_of_other_lengths);
    tcase_add_test(t, over_what_is_in_the_way);
    tcase_add_test(t, nothing_where_nothing_is_clear);
    tcase_add_test(t, axes_go_as_they_were_planned);
    Suite *s = suite_create("arc_link");
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed > 0;
}
