/*
 * arc_output: a chain of arcs and lines whose lengths, curvatures and turns are known in closed
 * form comes out as items of a path, each with the contact of its place; and the report has what a
 * control sees of it.
 */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "stage/arc_output.h"

enum { PIECES = 5, STEPS = 8, POINTS = PIECES * STEPS + 1 };

#define LEAN 0.2 /* radians that the axis turns along the second piece */

/* To the left about 20 mm, to the left about 10, to the right about 10, straight on, and straight
 * on after a corner of 0.3. */
static const struct {
    double bend;   /* 1/mm, to the left */
    double length; /* mm */
    double corner; /* radians, before it */
} chain[PIECES] = {
    {1.0 / 20, 5 * PI, 0}, {1.0 / 10, 2.5 * PI, 0}, {-1.0 / 10, 3 * PI, 0}, {0, 4, 0}, {0, 6, 0.3}};

struct course {
    struct run run;
    struct arc arc[PIECES];
    struct vec3 axis[PIECES + 1];
    struct reference reference;
    struct printeds printed;
};

/* At s of a piece that begins at p in the direction `heading`, in the plane z = 1. */
static struct vec3 place_on(int k, struct vec3 p, double heading, double s)
{
    double way = s * chain[k].length, bend = chain[k].bend, to = heading + bend * way;
    if (bend == 0)
        return vec_along(p, way, vec(cos(heading), sin(heading), 0));
    return vec(p.x + (sin(to) - sin(heading)) / bend, p.y - (cos(to) - cos(heading)) / bend, p.z);
}

static struct vec3 lean(double angle)
{
    return vec(0, sin(angle), cos(angle));
}

/* A contact lies 2 mm below the tip and has a normal that turns about Y from point to point. */
static struct run_point point_at(struct vec3 p, struct vec3 axis, size_t i)
{
    double turn = 0.01 * (double)i;
    return (struct run_point){.tip = p,
                              .ball = vec_along(p, 3, axis),
                              .axis = axis,
                              .contact = vec(p.x, p.y, p.z - 2),
                              .normal = vec(sin(turn), 0, cos(turn)),
                              .given = true};
}

static struct course course_new(void)
{
    struct course c = {.run = {.radius = 3}};
    struct vec3 p = vec(0, 0, 1);
    double heading = 0;
    *array_push(&c.run) = point_at(p, lean(0), 0);
    for (int k = 0; k < PIECES; k++) {
        heading += chain[k].corner;
        for (int i = 1; i <= STEPS; i++) {
            double s = (double)i / STEPS;
            struct vec3 axis = lean(k == 1 ? s * LEAN : k > 1 ? LEAN : 0);
            size_t at = c.run.n;
            *array_push(&c.run) = point_at(place_on(k, p, heading, s), axis, at);
        }
        struct vec3 to = place_on(k, p, heading, 1);
        c.arc[k] = arc_to(p, vec(cos(heading), sin(heading), 0), to);
        p = to;
        heading += chain[k].bend * chain[k].length;
    }
    c.reference = reference_of(&c.run, 0, c.run.n, false, false);
    struct vec3 from = c.reference.point[0];
    for (int k = 0; k < PIECES; k++) {
        struct arc_piece piece = arc_piece_of(&c.reference, c.arc[k], STEPS * k, STEPS * (k + 1));
        piece.biarc = k == 1;
        *array_push(&c.printed) = arcprint_piece(&piece, from);
        from = c.printed.item[k].piece.arc.to;
    }
    return c;
}

static void course_free(struct course *c)
{
    array_free(&c->run);
    array_free(&c->printed);
    reference_free(&c->reference);
}

static void put_out(const struct course *c, const struct arcrun_options *options, struct path *path,
                    struct arcrun_report *report)
{
    const struct arc_output output = {options, c->run.item, &c->reference};
    ck_assert_uint_eq(c->run.n, POINTS);
    arc_output_add(&output, &c->printed, path, report);
}

/* As of a place of the run, 2.5: halfway from point 2 to point 3. */
static void check_contact(const struct path *path, const struct path_item *item, double place)
{
    ck_assert(item->touches);
    struct contact got = path->contact.item[item->contact];
    double turn = 0.01 * place;
    ck_assert_double_le(vec_distance(got.n, vec(sin(turn), 0, cos(turn))), 1e-9);
    ck_assert_double_eq_tol(got.p.z, -1, 1e-12);
}

START_TEST(items_with_their_contacts)
{
    struct course c = course_new();
    const struct arcrun_options options = {.tolerance = 0.01, .least = 7};
    struct path path = {.name = "arcs"};
    struct arcrun_report report = {0};
    put_out(&c, &options, &path, &report);
    ck_assert_uint_eq(path.item.n, PIECES);
    ck_assert_uint_eq(path.arc.n, 3);
    for (int k = 0; k < PIECES; k++) {
        const struct path_item *item = &path.item.item[k];
        const struct run_point *end = &c.run.item[STEPS * (k + 1)];
        ck_assert_int_eq(item->kind, chain[k].bend == 0 ? PATH_POINT : PATH_ARC);
        ck_assert(!path_is_rapid(item));
        ck_assert_double_le(vec_distance(item->to.p, end->tip), 1e-6);
        ck_assert_double_le(vec_distance(item->to.a, end->axis), 1e-9);
        check_contact(&path, item, STEPS * (k + 1));
        ck_assert_double_le(vec_distance(path.contact.item[item->contact].p, end->contact), 1e-12);
        if (chain[k].bend == 0)
            continue;
        struct path_arc arc = path.arc.item[item->index];
        ck_assert_double_eq_tol(arc.radius, fabs(1 / chain[k].bend), 1e-5);
        ck_assert_double_le(fabs(vec_distance(arc.centre, item->to.p) - arc.radius), 1e-5);
        ck_assert_double_eq_tol(arc.axis.z, chain[k].bend > 0 ? 1 : -1, 1e-8);
    }
    path_free(&path);
    course_free(&c);
}
END_TEST

START_TEST(what_a_control_sees)
{
    struct course c = course_new();
    struct arcrun_options options = {.tolerance = 0.01, .least = 7};
    struct path path = {.name = "arcs"};
    struct arcrun_report report = {0};
    put_out(&c, &options, &path, &report);
    ck_assert_uint_eq(report.arcs, 3);
    ck_assert_uint_eq(report.lines, 2);
    ck_assert_uint_eq(report.c, 1);
    ck_assert_uint_eq(report.s, 1);
    ck_assert_uint_eq(report.kinks, 1);
    ck_assert_uint_eq(report.shorter, 2); /* the two lines */
    ck_assert_double_eq_tol(report.shortest, 4, 1e-5);
    ck_assert_double_eq_tol(report.length, 10.5 * PI + 10, 1e-4);
    ck_assert_double_eq_tol(report.bend, 0.2, 1e-5); /* from 1/10 on one side to the other */
    ck_assert_double_eq_tol(report.turn, LEAN / (2.5 * PI), 1e-5);
    /* the paper's pairs are those within one biarc: the second and the third */
    options.paper = true;
    report = (struct arcrun_report){0};
    put_out(&c, &options, &path, &report);
    ck_assert_uint_eq(report.c, 0);
    ck_assert_uint_eq(report.s, 1);
    /* one report of several parts */
    put_out(&c, &options, &path, &report);
    ck_assert_uint_eq(report.arcs, 6);
    ck_assert_double_eq_tol(report.shortest, 4, 1e-5);
    ck_assert_double_eq_tol(report.length, 2 * (10.5 * PI + 10), 1e-4);
    path_free(&path);
    course_free(&c);
}
END_TEST

/* Each arc is a comment and as many straight chords as keep the quarter of the tolerance, at the
 * tip and at the ball's centre, whose ends are on the arc. */
START_TEST(chords_for_arcs)
{
    struct course c = course_new();
    const struct arcrun_options options = {.tolerance = 0.04, .chords = true};
    struct path path = {.name = "chords"};
    struct arcrun_report report = {0};
    put_out(&c, &options, &path, &report);
    ck_assert_uint_eq(path.arc.n, 0);
    size_t i = 0;
    for (int k = 0; k < PIECES; k++) {
        int chords = 0;
        if (chain[k].bend != 0) {
            const struct path_item *text = &path.item.item[i++];
            ck_assert_int_eq(text->kind, PATH_TEXT);
            ck_assert_ptr_nonnull(strstr(path.text.item[text->index], "$$ CIRCLE/"));
        }
        size_t first = i;
        while (i < path.item.n && path.item.item[i].kind == PATH_POINT &&
               !(chain[k].bend == 0 && i > first))
            i++, chords++;
        double radius = chain[k].bend == 0 ? 0 : fabs(1 / chain[k].bend);
        if (k == 2)
            chords -= 2, i -= 2; /* the two lines that follow */
        if (k < 3) {
            double sagitta = radius * (1 - cos(chain[k].length / radius / chords / 2));
            ck_assert_double_le(sagitta, 0.01);
            ck_assert_int_gt(chords, 1);
        } else {
            ck_assert_int_eq(chords, 1);
        }
        for (int j = 1; j <= chords; j++) {
            const struct path_item *item = &path.item.item[first + (size_t)j - 1];
            double s = (double)j / chords;
            ck_assert_double_le(vec_distance(item->to.p, arc_at(&c.arc[k], s)), 1e-5);
            ck_assert_double_le(vec_distance(item->to.a, lean(k == 1  ? s * LEAN
                                                              : k > 1 ? LEAN
                                                                      : 0)),
                                1e-8);
            check_contact(&path, item, STEPS * (k + s));
        }
    }
    ck_assert_uint_eq(i, path.item.n);
    ck_assert_uint_eq(report.arcs, 3);
    path_free(&path);
    course_free(&c);
}
END_TEST

/* Without a normal nothing is known of the contact, beside it neither. */
START_TEST(contacts_that_are_not_known)
{
    struct course c = course_new();
    const struct arcrun_options options = {.tolerance = 0.01};
    struct path path = {.name = "bare"};
    struct arcrun_report report = {0};
    c.run.item[STEPS].normal = vec(0, 0, 0);
    c.printed.item[1].piece.to = 2 * STEPS - 0.5;
    c.run.item[2 * STEPS].normal = vec(0, 0, 0);
    put_out(&c, &options, &path, &report);
    ck_assert(!path.item.item[0].touches);
    ck_assert(!path.item.item[1].touches);
    check_contact(&path, &path.item.item[2], 3 * STEPS);
    path_free(&path);
    course_free(&c);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("arc_output");
    TCase *tests = tcase_create("arc_output");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, items_with_their_contacts);
    tcase_add_test(tests, what_a_control_sees);
    tcase_add_test(tests, chords_for_arcs);
    tcase_add_test(tests, contacts_that_are_not_known);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
