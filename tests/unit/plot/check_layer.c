/* layer, sheet: streams as what is drawn of them: where strokes lie, against circle and line by
 * hand, how many there are of which kind, and the figures and legend that tell it. */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/out.h"
#include "plot/plot.h"
#include "scratch.h"

static struct layer layer;
static struct layer_options options;
static struct error error;

static void setup(void)
{
    options = (struct layer_options){.unit = 1};
}

static void teardown(void)
{
    layer_free(&layer);
}

static void read_text(const char *text)
{
    layer_free(&layer);
    ck_assert_msg(layer_read(scratch_text(text), &options, &layer, &error) == 0, "%s", error.text);
}

/* The nodes of stroke i. */
static size_t nodes(size_t i, const struct vec3 **node)
{
    ck_assert_uint_lt(i, layer.stroke.n);
    *node = &layer.node.item[layer.stroke.item[i].from];
    return layer.stroke.item[i].to - layer.stroke.item[i].from;
}

static void stroke_is(size_t i, enum stroke_kind kind, size_t pass, size_t number)
{
    ck_assert_int_eq(layer.stroke.item[i].kind, kind);
    ck_assert_uint_eq(layer.stroke.item[i].pass, pass);
    ck_assert_uint_eq(layer.stroke.item[i].number, number);
}

static void ends(size_t i, struct vec3 from, struct vec3 to)
{
    const struct vec3 *p;
    size_t n = nodes(i, &p);
    ck_assert_double_lt(vec_distance(p[0], from), 1e-6);
    ck_assert_double_lt(vec_distance(p[n - 1], to), 1e-6);
}

/* All nodes on the circle, and between them no farther off it than the chord. */
static void on_circle(size_t i, struct vec3 centre, double radius, double chord, double length)
{
    const struct vec3 *p;
    size_t n = nodes(i, &p);
    double sum = 0;
    for (size_t k = 0; k < n; k++) {
        ck_assert_double_eq_tol(vec_distance(p[k], centre), radius, 1e-5);
        if (k == 0)
            continue;
        double middle = vec_distance(vec_mix(p[k - 1], p[k], 0.5), centre);
        ck_assert_double_ge(middle, radius - chord - 1e-9);
        sum += vec_distance(p[k - 1], p[k]);
    }
    ck_assert_double_eq_tol(sum, length, 2 * chord * (double)n);
    /* and not in a hundred times as many pieces as needed */
    ck_assert_double_le((double)(n - 1), 2 + 2 * length / (2 * sqrt(2 * radius * chord)));
}

static const char path[] =
    "UNITS/MM\nMULTAX/ON\nCUTTER/10\nFEDRAT/MMPM,800\n$$-> PASS/1\nRAPID\nGOTO/0,0,40,0,0,1\n"
    "RAPID\nGOTO/0,0,10,0,0,1\n$$-> CONTCT/0,0,-1,0,0,1\nGOTO/0,0,0,0,0,1\nGOTO/30,0,0,0,0,1\n"
    "CIRCLE/30,20,0,0,0,1,20\nGOTO/50,20,0,0,0,1\nCIRCLE/40,20,0,0,0,1,10\nGOTO/40,30,0,0,0,1\n"
    "$$-> PASS/2\nGOTO/0,30,0,0,0.6,0.8\nFINI\n";

START_TEST(of_a_path)
{
    options.chord = 0.004;
    options.normals = options.axes = true;
    read_text(path);
    ck_assert_uint_eq(layer.stroke.n, 5);
    stroke_is(0, STROKE_RAPID, 1, 0);
    ends(0, vec(0, 0, 40), vec(0, 0, 10));
    stroke_is(1, STROKE_LINE, 1, 0);
    ends(1, vec(0, 0, 10), vec(30, 0, 0)); /* the two lines go on */
    ck_assert_uint_eq(layer.stroke.item[1].to - layer.stroke.item[1].from, 3);
    stroke_is(2, STROKE_ARC, 1, 0);
    ends(2, vec(30, 0, 0), vec(50, 20, 0));
    on_circle(2, vec(30, 20, 0), 20, 0.004, PI * 10);
    stroke_is(3, STROKE_ARC, 1, 1);
    on_circle(3, vec(40, 20, 0), 10, 0.004, PI * 5);
    stroke_is(4, STROKE_LINE, 2, 1); /* of another pass */
    ends(4, vec(40, 30, 0), vec(0, 30, 0));
    ck_assert_uint_eq(layer.passes, 2);
    ck_assert_uint_eq(layer.motions[STROKE_LINE], 3);
    ck_assert_uint_eq(layer.motions[STROKE_ARC], 2);
    ck_assert_uint_eq(layer.motions[STROKE_RAPID], 1);
    ck_assert_double_eq_tol(layer.cut, 10 + 30 + PI * 15 + 40, 1e-6);
    ck_assert_double_eq_tol(layer.rapid, 30, 1e-9);
    ck_assert_uint_eq(layer.joint.n, 5);
    ck_assert_uint_eq(layer.axis.n, 5);
    ck_assert_double_lt(vec_distance(layer.axis.item[4].direction, vec(0, 0.6, 0.8)), 1e-9);
    ck_assert_uint_eq(layer.normal.n, 1);
    ck_assert_double_lt(vec_distance(layer.normal.item[0].from, vec(0, 0, -1)), 1e-9);
    ck_assert_str_eq(layer.figures, "2 passes, 3 lines, 2 arcs, 127.1 mm of cut");
    /* without rapid moves; a chord that cannot be seen: a part in 5,000 of what is there */
    options = (struct layer_options){.unit = 1, .cut = true};
    read_text(path);
    ck_assert_uint_eq(layer.stroke.n, 4);
    on_circle(1, vec(30, 20, 0), 20, sqrt(2500 + 900 + 1600) / 5000, PI * 10);
    ck_assert_double_eq(layer.rapid, 0);
    ck_assert_uint_eq(layer.axis.n + layer.normal.n, 0);
}
END_TEST

static const char curve[] = "UNITS/MM\nCUTTER/10\nFEDRAT/MMPM,800\nGOTO/0,0,0\nMOVNRB/M3AXIS\n"
                            "MOVNRB/ON,4,8,0,4,1\nMOVNRB/1,0,0,0,0,1,1,1,1\n"
                            "MOVNRB/2,0,0,0,0,8,0,8,8,0,8,0,0\nMOVNRB/NEXT\nGOTO/8,0,0\n"
                            "MOVNRB/OFF\nFINI\n";

/* A Bezier curve of degree 3: (8 s^2 (3 - 2 s), 24 s (1 - s)). */
START_TEST(of_a_curve)
{
    const struct vec3 *p;
    options.poles = true;
    read_text(curve);
    ck_assert_uint_eq(layer.stroke.n, 2);
    stroke_is(0, STROKE_SPLINE, 0, 0);
    size_t n = nodes(0, &p);
    for (size_t i = 0; i < n; i++) {
        double s = 0; /* by halves, for x rises with it */
        for (double step = 0.5; step > 1e-15; step /= 2)
            s += 8 * (s + step) * (s + step) * (3 - 2 * (s + step)) <= p[i].x ? step : 0;
        ck_assert_double_eq_tol(p[i].y, 24 * s * (1 - s), 1e-5);
    }
    stroke_is(1, STROKE_POLES, 0, 0);
    ck_assert_uint_eq(nodes(1, &p), 4);
    ck_assert_double_lt(vec_distance(p[2], vec(8, 8, 0)), 1e-12);
    ck_assert_str_eq(layer.figures, "1 B-spline of 4 control points, 16.0 mm of cut");
    ck_assert_double_eq_tol(layer.cut, 16, 1e-3); /* its speed is 24 (1 - 2 s (1 - s)) */
}
END_TEST

static const char program[] =
    "%\nO0001\nG90 G17 G21 G94\nG53 G0 Z0.\nT1 M6\nS900 M3\nG0 A0. C0.\nG43.4 H1\n"
    "G0 X0. Y0. Z50.\nG1 F500.\nG1 Z0.\nG1 X30.\nG3 X50. Y20. I0. J20.\nG0 Z50.\nG0 X0.\n"
    "G1 Z40. F500.\nG49\nG53 G0 Z0.\nM5\nM30\n%\n";

/* Two cuts between rapid moves; those from a place that is not known are points. */
START_TEST(of_a_program)
{
    read_text(program);
    size_t cuts = 0, arc = SIZE_MAX;
    for (size_t i = 0; i < layer.stroke.n; i++) {
        if (layer.stroke.item[i].kind == STROKE_ARC)
            arc = i;
        cuts += layer.stroke.item[i].kind == STROKE_LINE;
    }
    ck_assert_uint_eq(cuts, 2);
    ck_assert_uint_ne(arc, SIZE_MAX);
    stroke_is(arc, STROKE_ARC, 1, 0);
    ends(arc, vec(30, 0, 0), vec(50, 20, 0));
    on_circle(arc, vec(30, 20, 0), 20, sqrt(2500 + 2500 + 400) / 5000, PI * 10);
    stroke_is(arc - 1, STROKE_LINE, 1, 0);
    ends(arc - 1, vec(0, 0, 50), vec(30, 0, 0));
    ck_assert_uint_eq(layer.cuts, 2);
    ck_assert_double_eq_tol(layer.cut, 50 + 30 + PI * 10 + 10, 0.05);
    ck_assert_double_eq_tol(layer.rapid, 50 + 50, 1e-9);
    ck_assert_uint_eq(layer.joint.n, 4);
    ck_assert_str_eq(layer.figures, "2 cuts, 3 lines, 1 arc, 121.4 mm of cut");
    ck_assert_str_eq(layer.told, "");
    options.cut = true;
    read_text(program);
    ck_assert_double_eq(layer.rapid, 0);
    ck_assert_uint_eq(layer.stroke.n, 3);
    ck_assert_uint_eq(layer.cuts, 2);
}
END_TEST

START_TEST(of_points_and_facets)
{
    options.unit = 25.4;
    read_text("0 0 0\n1 0 0\n1 2 0.5\n");
    ck_assert_uint_eq(layer.point.n, 3);
    ck_assert_double_lt(vec_distance(layer.point.item[2], vec(25.4, 50.8, 12.7)), 1e-12);
    ck_assert_str_eq(layer.figures, "3 points, 25.4 \u00d7 50.8 \u00d7 12.7 mm");
    options.normals = true;
    read_text("OFF\n4 2 0\n0 0 0\n4 0 0\n4 3 0\n0 3 0\n3 0 1 2\n3 0 2 3\n");
    ck_assert_str_eq(layer.figures, "4 vertices, 2 facets, 4.0 \u00d7 3.0 \u00d7 0.0 mm");
    ck_assert_uint_eq(layer.normal.n, 4);
    ck_assert_double_lt(vec_distance(layer.normal.item[3].direction, vec(0, 0, 1)), 1e-12);
    layer_free(&layer);
    ck_assert_int_eq(layer_read("/no/such/file", &options, &layer, &error), -1);
}
END_TEST

static void sheet(const char *const *has, const struct sheet_options *how)
{
    struct scene scene = {0};
    *array_push(&scene) = layer;
    struct out *out = out_open(scratch_name());
    sheet_write(out, &scene, how);
    out_close(out);
    char *text = scratch_read(&(size_t){0});
    for (; *has; has++)
        ck_assert_msg((strstr(text, *has + (**has == '!')) != NULL) == (**has != '!'), "%s\n%s",
                      *has, text);
    free(text);
    array_free(&scene);
}

START_TEST(on_a_sheet)
{
    options.axes = true;
    read_text(path);
    sheet((const char *const[]){"<svg", ">A part</text>", ">plan (x right, y up)</text>",
                                ">isometric</text>", "!front (x", ">lines</text>",
                                ">arcs, by turns</text>", ">rapid</text>", ">tool axes</text>",
                                "!>normals", "!B-splines", "!control points", "2 passes, 3 lines",
                                "!ends of motions", "</svg>", NULL},
          &(struct sheet_options){.title = "A part", .width = 1000});
    sheet((const char *const[]){"!isometric", "!plan (x", ">front (x right, z up)</text>",
                                "!side (y", "passes, in six colours by turns", "!>lines",
                                "ends of motions", NULL},
          &(struct sheet_options){.title = "A part",
                                  .width = 600,
                                  .views = SHEET_FRONT,
                                  .by_pass = true,
                                  .joints = true});
    sheet((const char *const[]){">isometric<", ">plan (x", ">front (x", ">side (y", NULL},
          &(struct sheet_options){.title = "A part", .width = 800, .views = SHEET_ALL});
    ck_assert_str_eq(sheet_name("-"), "standard input");
    ck_assert_str_eq(sheet_name("a/b.xyz"), "b.xyz");
    ck_assert_str_eq(sheet_name("b.xyz"), "b.xyz");
    ck_assert_str_eq(sheet_name("a/"), "a/");
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("layer");
    TCase *tests = tcase_create("layer");
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, of_a_path);
    tcase_add_test(tests, of_a_curve);
    tcase_add_test(tests, of_a_program);
    tcase_add_test(tests, of_points_and_facets);
    tcase_add_test(tests, on_a_sheet);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
