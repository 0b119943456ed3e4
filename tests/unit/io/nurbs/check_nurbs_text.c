/*
 * check_nurbs_text - a quarter of a cylinder in inches, as text, is round to the last digits; its
 * ranges, loops and numbers are read; cut off anywhere, or with a word wrong, it is refused.
 */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/nurbs/surfaces.h"
#include "math/elementary.h"
#include "scratch.h"

#define INCH 25.4

static const char quarter[] =
    "# a comment\nnurbs 1\nunit inch\n"
    "surface degree 2 1 poles 3 2\r\nknots_u 0 0 0 1 1 1 knots_v 0 0 3 3\n"
    "points 5 0 0  5 5 0  0 5 0\n\n  5 0 3  5 5 3 # the corner\n  0 5 3\n"
    "weights 1 0.70710678118654752 1 1 0.70710678118654752 1\n"
    "range 0 0.5 1 2\nloop 0 1 0.5 1 0.25 2\nsurface degree 1 1 poles 2 2\n"
    "knots_u 0 0 1 1 knots_v 0 0 1 1 points 0 0 0 1 0 0 0 1 0 1 1 0 end\n";

static int read_text(const char *text, double mm, struct patches *patches, struct error *error)
{
    struct surfaces_unit unit;
    *patches = (struct patches){0};
    return surfaces_read(scratch_text(text), mm, patches, &unit, error);
}

/* On the cylinder of radius 5, as high as v says. */
static void is_round(const struct nurbs *s, double unit)
{
    for (double u = 0; u <= 0.5; u += 0.0625)
        for (double v = 1; v <= 2; v += 0.25) {
            struct vec3 p = nurbs_point(s, (struct uv){u, v});
            ck_assert_double_eq_tol(hypot(p.x, p.y), 5 * unit, 1e-12 * 5 * unit);
            ck_assert_double_eq_tol(p.z, v * unit, 1e-12 * 5 * unit);
        }
}

START_TEST(a_rational_surface_in_inches)
{
    struct patches patches;
    struct error error;
    ck_assert_int_eq(read_text(quarter, 0, &patches, &error), 0);
    ck_assert_uint_eq(patches.n, 2);
    const struct patch *p = &patches.item[0];
    is_round(&p->surface, INCH);
    ck_assert_int_eq(p->entity, 1);
    ck_assert_int_eq(p[1].entity, 2);
    ck_assert(p->surface.u.from == 0 && p->surface.u.to == 0.5);
    ck_assert(p->surface.v.from == 1 && p->surface.v.to == 2);
    ck_assert(p[1].surface.u.from == 0 && p[1].surface.u.to == 1);
    ck_assert_uint_eq(p->loop.n, 1);
    ck_assert_uint_eq(p[1].loop.n, 0);
    ck_assert_uint_eq(p->loop.item[0].n, 3); /* the last joins the first */
    ck_assert(!p->loop.item[0].space && !p->loop.item[0].directed);
    patches_free(&patches);
}
END_TEST

START_TEST(a_unit_that_is_asked_for)
{
    struct patches patches;
    struct error error;
    ck_assert_int_eq(read_text(quarter, 10, &patches, &error), 0);
    is_round(&patches.item[0].surface, 10);
    patches_free(&patches);
}
END_TEST

START_TEST(cut_off_anywhere)
{
    char text[sizeof quarter];
    struct patches patches;
    struct error error;
    for (size_t n = 0; n < sizeof quarter - 2; n++) { /* without `end` */
        memcpy(text, quarter, n);
        text[n] = '\0';
        ck_assert_msg(read_text(text, 0, &patches, &error) == -1, "%zu bytes", n);
        patches_free(&patches);
    }
}
END_TEST

/* `from` is another text: the message has `says`. */
static void refused(const char *from, const char *to, const char *says)
{
    char text[2 * sizeof quarter];
    struct patches patches;
    struct error error;
    const char *at = strstr(quarter, from);
    snprintf(text, sizeof text, "%.*s%s%s", (int)(at - quarter), quarter, to, at + strlen(from));
    ck_assert_msg(read_text(text, 0, &patches, &error) == -1, "%s", to);
    ck_assert_msg(strstr(error.text, says) != NULL, "%s: %s", to, error.text);
    patches_free(&patches);
}

START_TEST(words_that_are_wrong)
{
    refused("nurbs 1", "nurbs 2", ":2: ");
    refused("unit inch", "unit furlong", ":3: ");
    refused("degree 2 1", "degree 0 1", "two degrees, 1 to 25");
    refused("degree 2 1", "degree 26 1", "two degrees, 1 to 25");
    refused("degree 2 1", "degree 1.5 1", "two degrees");
    refused("poles 3 2", "poles 1 2", "2 to 1000000");
    refused("poles 3 2", "poles 3 2 poles 3 2", "poles once");
    refused("poles 3 2", "", "before the knots");
    refused("knots_u 0 0 0 1 1 1", "knots_u 0 0 0 1 1 nan", "a knot, a finite number");
    refused("knots_u 0 0 0 1 1 1", "knots_u 0 0 0 1 1 -1", "u");
    refused("knots_v 0 0 3 3", "", "without knots_v");
    refused("0.70710678118654752 1\n", "0.7 0\n", "weight 0 of pole 6");
    refused("5 5 0", "5 1e400 0", "a coordinate, a finite number");
    refused("0 1 0.5 1 0.25 2", "0 1 0.5 1", "three at least");
    refused("0 1 0.5 1 0.25 2", "0 1 0.5 1 0.25", "three at least");
    refused("1 1 0 end", "1 1 0 finish", "surface");
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("nurbs_text");
    TCase *tcase = tcase_create("nurbs_text");
    tcase_add_test(tcase, a_rational_surface_in_inches);
    tcase_add_test(tcase, a_unit_that_is_asked_for);
    tcase_add_test(tcase, cut_off_anywhere);
    tcase_add_test(tcase, words_that_are_wrong);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
