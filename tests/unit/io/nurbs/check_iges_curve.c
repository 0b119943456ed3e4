/* iges_curve: lines, arcs, polylines, splines and composites go through the points that their
 * definitions say (IGES 5.3, 4.2 to 4.32), under transformations that point to others. */
#include "iges_files.h"

#include "base/array.h"
#include "io/nurbs/iges_curve.h"
#include "math/elementary.h"

static struct patch_loop loop;

static void teardown(void)
{
    iges_file_end();
    patch_loop_free(&loop);
    loop = (struct patch_loop){0};
}

/* The curve of a directory entry, as the return of iges_curve. */
static int curve(int number)
{
    const struct iges_entity *unknown;
    iges_file_read();
    return iges_curve(&iges, iges_entity(&iges, number), &loop, &unknown, &error);
}

/* At a part, 0 to 1, of piece k. */
static struct vec3 at(size_t k, double part)
{
    ck_assert_uint_lt(k, loop.n);
    const struct nurbs_curve *c = &loop.item[k];
    return nurbs_curve_point(c, c->t.from + part * (c->t.to - c->t.from));
}

static void passes(size_t k, double part, double x, double y, double z)
{
    struct vec3 p = at(k, part);
    ck_assert_msg(vec_distance(p, vec(x, y, z)) < 1e-12, "%zu, %g: %.15g %.15g %.15g", k, part, p.x,
                  p.y, p.z);
}

START_TEST(line)
{
    int number = iges_file_add(110, 0, 0, false, "110,1.,2.,3.,5.,-6.,9.;");
    ck_assert_int_eq(curve(number), 0);
    ck_assert_uint_eq(loop.n, 1);
    passes(0, 0, 1, 2, 3);
    passes(0, 0.25, 2, 0, 4.5);
    passes(0, 1, 5, -6, 9);
}
END_TEST

/* Counter-clockwise from the start to the end about the centre, in pieces of up to a quarter; one
 * that ends where it starts is a circle. */
START_TEST(arcs)
{
    static const struct {
        double from, to;
        size_t pieces;
    } row[] = {{0, 90, 1}, {10, 100, 1},  {0, 91, 2},     {0, 180, 2},
               {90, 0, 3}, {200, 190, 4}, {-30, 60.5, 2}, {45, 45, 4}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        char text[200];
        double a = RADIANS(row[k].from), b = RADIANS(row[k].to);
        iges_file_begin();
        /* z, centre, start, end */
        snprintf(text, sizeof text, "100,7.,3.,-2.,%.15g,%.15g,%.15g,%.15g;", 3 + 5 * cos(a),
                 -2 + 5 * sin(a), 3 + 5 * cos(b), -2 + 5 * sin(b));
        ck_assert_int_eq(curve(iges_file_add(100, 0, 0, false, text)), 0);
        ck_assert_uint_eq(loop.n, row[k].pieces);
        double turn = row[k].to - row[k].from;
        turn = RADIANS(turn > 0 ? turn : turn + 360);
        struct vec3 last = vec(3 + 5 * cos(a), -2 + 5 * sin(a), 7);
        for (size_t i = 0; i < loop.n; i++) {
            ck_assert_double_lt(vec_distance(at(i, 0), last), 1e-12);
            last = at(i, 1);
            for (int n = 0; n <= 10; n++) {
                struct vec3 p = at(i, n / 10.0);
                ck_assert_double_eq_tol(hypot(p.x - 3, p.y + 2), 5, 1e-12);
                ck_assert_double_eq_tol(p.z, 7, 1e-12);
            }
            double middle = a + turn * ((double)i + 0.5) / (double)loop.n;
            struct vec3 p = at(i, 0.5); /* of a piece: halfway round, by its symmetry */
            ck_assert_double_lt(vec_distance(p, vec(3 + 5 * cos(middle), -2 + 5 * sin(middle), 7)),
                                1e-12);
        }
        ck_assert_double_lt(vec_distance(last, vec(3 + 5 * cos(b), -2 + 5 * sin(b), 7)), 1e-12);
        teardown();
        memset(&iges, 0, sizeof iges);
    }
}
END_TEST

/* Kind 1: one z, then x y; 2: x y z. */
START_TEST(polylines)
{
    static const char *const text[] = {"106,1,3,4.,0.,0.,2.,0.,2.,8.;",
                                       "106,2,3,0.,0.,4.,2.,0.,4.,2.,8.,5.;"};
    for (int kind = 1; kind <= 2; kind++) {
        iges_file_begin();
        ck_assert_int_eq(curve(iges_file_add(106, 10 + kind, 0, false, text[kind - 1])), 0);
        ck_assert_uint_eq(loop.n, 1);
        passes(0, 0, 0, 0, 4);
        passes(0, 0.25, 1, 0, 4); /* as many parameters for each side */
        passes(0, 0.5, 2, 0, 4);
        passes(0, 0.75, 2, 4, kind == 1 ? 4 : 4.5);
        passes(0, 1, 2, 8, kind == 1 ? 4 : 5);
        teardown();
        memset(&iges, 0, sizeof iges);
    }
    iges_file_begin();
    ck_assert_int_eq(curve(iges_file_add(106, 12, 0, false, "106,2,3,0.,0.,4.,2.,0.,4.,2.,8.;")),
                     -1);
    ck_assert_ptr_nonnull(strstr(error.text, "entity 106 with"));
}
END_TEST

/* A quarter of a circle by weights 1, cos 45 degrees, 1; and a part of it, as the file's range. */
START_TEST(splines)
{
    char text[400];
    for (int part = 0; part < 2; part++) {
        iges_file_begin();
        snprintf(text, sizeof text,
                 "126,2,2,1,0,0,0,0.,0.,0.,2.,2.,2.,1.,%.17g,1.,3.,0.,1.,3.,3.,1.,0.,3.,1.,%s,0.,"
                 "0.,1.;",
                 sqrt(0.5), part ? "1.,2." : "0.,2.");
        ck_assert_int_eq(curve(iges_file_add(126, 0, 0, false, text)), 0);
        ck_assert_uint_eq(loop.n, 1);
        passes(0, 0, part ? 3 * sqrt(0.5) : 3, part ? 3 * sqrt(0.5) : 0, 1);
        passes(0, 1, 0, 3, 1);
        for (int i = 0; i <= 8; i++)
            ck_assert_double_eq_tol(hypot(at(0, i / 8.0).x, at(0, i / 8.0).y), 3, 1e-12);
        if (!part)
            passes(0, 0.5, 3 * sqrt(0.5), 3 * sqrt(0.5), 1);
        teardown();
        memset(&iges, 0, sizeof iges);
    }
    iges_file_begin(); /* a weight of nothing, knots that fall */
    ck_assert_int_eq(curve(iges_file_add(126, 0, 0, false,
                                         "126,1,1,0,0,1,0,0.,0.,1.,1.,1.,0.,0.,0.,0.,1.,0.,0.,0.,"
                                         "1.;")),
                     -1);
    teardown();
    memset(&iges, 0, sizeof iges);
    iges_file_begin();
    ck_assert_int_eq(curve(iges_file_add(126, 0, 0, false,
                                         "126,1,1,0,0,1,0,0.,1.,0.,1.,1.,1.,0.,0.,0.,1.,0.,0.,0.,"
                                         "1.;")),
                     -1);
}
END_TEST

/* 104: each conic, turned by 30 degrees and moved, runs from its start to its end on its equation:
 * an ellipse counter-clockwise, the others the way there. */
START_TEST(conics)
{
    for (int kind = 0; kind < 6; kind++) { /* ellipse, hyperbola, parabola; there and back */
        double c = cos(RADIANS(30)), s = sin(RADIANS(30)), t[2] = {-0.4, 0.9}, end[2][2], k[6];
        /* in its own axes: x^2/9 +- y^2/4 = 1, y^2 = 4 x */
        double xx = kind / 2 == 2 ? 0 : 1 / 9.0, yy = kind / 2 == 2 ? 1 : 1 / 4.0, x1 = 0, one = -1;
        if (kind / 2 == 1)
            yy = -yy;
        if (kind / 2 == 2)
            x1 = -4, one = 0;
        for (int i = 0; i < 2; i++) {
            double at = t[kind % 2 ? 1 - i : i];
            double u = kind / 2 == 0 ? 3 * cos(at) : kind / 2 == 1 ? 3 * cosh(at) : at * at;
            double v = kind / 2 == 0 ? 2 * sin(at) : kind / 2 == 1 ? 2 * sinh(at) : 2 * at;
            end[i][0] = 5 + c * u - s * v;
            end[i][1] = -7 + s * u + c * v;
        }
        /* u = c (x - 5) + s (y + 7), v = c (y + 7) - s (x - 5), multiplied out */
        double u0 = -5 * c + 7 * s, v0 = 7 * c + 5 * s;
        k[0] = xx * c * c + yy * s * s;
        k[1] = 2 * c * s * (xx - yy);
        k[2] = xx * s * s + yy * c * c;
        k[3] = 2 * (xx * u0 * c - yy * v0 * s) + x1 * c;
        k[4] = 2 * (xx * u0 * s + yy * v0 * c) + x1 * s;
        k[5] = xx * u0 * u0 + yy * v0 * v0 + x1 * u0 + one;
        char text[600];
        snprintf(text, sizeof text,
                 "104,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,3.,%.17g,%.17g,%.17g,%.17g;", k[0], k[1],
                 k[2], k[3], k[4], k[5], end[0][0], end[0][1], end[1][0], end[1][1]);
        iges_file_begin();
        ck_assert_int_eq(curve(iges_file_add(104, 1 + kind / 2, 0, false, text)), 0);
        double turned = 0;
        struct vec3 before = {0, 0, 0};
        for (size_t i = 0; i < loop.n; i++)
            for (int n = 0; n <= 16; n++) {
                struct vec3 p = at(i, n / 16.0), about = vec_sub(p, vec(5, -7, 3));
                double off = k[0] * p.x * p.x + k[1] * p.x * p.y + k[2] * p.y * p.y + k[3] * p.x +
                             k[4] * p.y + k[5];
                ck_assert_double_eq_tol(off, 0, 1e-9);
                ck_assert_double_eq_tol(p.z, 3, 1e-12);
                if (i + (size_t)n > 0)
                    turned += atan2(before.x * about.y - before.y * about.x,
                                    before.x * about.x + before.y * about.y);
                before = about;
            }
        ck_assert_double_lt(vec_distance(at(0, 0), vec(end[0][0], end[0][1], 3)), 1e-9);
        ck_assert_double_lt(vec_distance(at(loop.n - 1, 1), vec(end[1][0], end[1][1], 3)), 1e-9);
        if (kind / 2 == 0) /* about its middle */
            ck_assert_double_gt(turned, 0);
        teardown();
        memset(&iges, 0, sizeof iges);
    }
}
END_TEST

/* First the entity's own transformation, then what that points to: a quarter turn about z with a
 * shift, then twice as large. */
START_TEST(transformations)
{
    int outer = iges_file_add(124, 0, 0, true, "124,2.,0.,0.,100.,0.,2.,0.,200.,0.,0.,2.,300.;");
    int inner = iges_file_add(124, 0, outer, true, "124,0.,-1.,0.,10.,1.,0.,0.,20.,0.,0.,1.,30.;");
    ck_assert_int_eq(curve(iges_file_add(110, 0, inner, false, "110,1.,2.,3.,5.,-6.,9.;")), 0);
    passes(0, 0, 2 * (10 - 2) + 100, 2 * (20 + 1) + 200, 2 * (30 + 3) + 300);
    passes(0, 1, 2 * (10 + 6) + 100, 2 * (20 + 5) + 200, 2 * (30 + 9) + 300);
    struct transform t;
    ck_assert_int_eq(iges_matrix(&iges, 0, 7, &t, &error), 0);
    ck_assert(transform_is_identity(&t));
    ck_assert_int_eq(iges_matrix(&iges, 5, 7, &t, &error), -1); /* the line is none */
    ck_assert_ptr_nonnull(strstr(error.text, "directory entry 5"));
}
END_TEST

/* Curves in one, placed by its transformation too, and those within one of them; the file's
 * parameters follow each other. */
START_TEST(composites)
{
    int a = iges_file_add(110, 0, 0, true, "110,0.,0.,0.,4.,0.,0.;");
    int b = iges_file_add(100, 0, 0, true, "100,0.,4.,2.,4.,0.,6.,2.;");
    int c = iges_file_add(110, 0, 0, true, "110,6.,2.,0.,6.,5.,0.;");
    int shift = iges_file_add(124, 0, 0, true, "124,1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,7.;");
    char text[100];
    snprintf(text, sizeof text, "102,2,%d,%d;", a, b);
    int both = iges_file_add(102, 0, 0, true, text);
    snprintf(text, sizeof text, "102,2,%d,%d;", both, c);
    int all = iges_file_add(102, 0, shift, false, text);
    struct iges_ranges ranges = {0};
    const struct iges_entity *unknown;
    iges_file_read();
    ck_assert_int_eq(
        iges_curve_ranges(&iges, iges_entity(&iges, all), &loop, &ranges, &unknown, &error), 0);
    ck_assert_uint_eq(loop.n, 3);
    ck_assert_uint_eq(ranges.n, 3);
    passes(0, 0, 0, 0, 7);
    passes(0, 1, 4, 0, 7);
    passes(1, 0.5, 4 + 2 * sqrt(0.5), 2 - 2 * sqrt(0.5), 7);
    passes(2, 0, 6, 2, 7);
    passes(2, 1, 6, 5, 7);
    /* a line has 0 to 1, an arc its angles from the start's, one after the other */
    ck_assert_double_eq_tol(ranges.item[0].to - ranges.item[0].from, 1, 1e-12);
    ck_assert_double_eq_tol(ranges.item[1].to - ranges.item[1].from, PI / 2, 1e-12);
    ck_assert_double_eq_tol(ranges.item[2].to - ranges.item[2].from, 1, 1e-12);
    ck_assert(ranges.item[1].angle && !ranges.item[0].angle && !ranges.item[2].angle);
    for (size_t i = 1; i < 3; i++)
        ck_assert_double_eq_tol(ranges.item[i].from, ranges.item[i - 1].to, 1e-12);
    array_free(&ranges);
}
END_TEST

/* One that holds itself ends in an error, and what is no curve is named. */
START_TEST(no_curves)
{
    int self = iges_file_add(102, 0, 0, false, "102,1,1;");
    ck_assert_int_eq(curve(self), -1);
    teardown();
    memset(&iges, 0, sizeof iges);
    iges_file_begin();
    int point = iges_file_add(116, 0, 0, true, "116,0.,0.,0.;");
    char text[40];
    snprintf(text, sizeof text, "102,1,%d;", point);
    int all = iges_file_add(102, 0, 0, false, text);
    const struct iges_entity *unknown = NULL;
    iges_file_read();
    ck_assert_int_eq(iges_curve(&iges, iges_entity(&iges, all), &loop, &unknown, &error), 1);
    ck_assert_ptr_eq(unknown, iges_entity(&iges, point));
}
END_TEST

/* 130: a line of 10 mm along x moved to the side of normal x tangent, +y: by a distance, by one
 * that goes from 1 to 3 by parameter or by length, and by a coordinate of a curve; part of it
 * alone. */
START_TEST(offsets)
{
    static const struct {
        const char *text; /* behind the base curve */
        double from, to;  /* parts of the line */
        double y[2];      /* at both ends */
    } row[] = {{"1,0,0,0,2.,0.,0.,0.,0.,0.,1.,0.,1.", 0, 1, {2, 2}},
               {"1,0,0,0,2.,0.,0.,0.,0.,0.,-1.,0.,1.", 0, 1, {-2, -2}},
               {"1,0,0,0,2.,0.,0.,0.,0.,0.,1.,0.25,0.75", 0.25, 0.75, {2, 2}},
               {"2,0,0,2,1.,0.,3.,1.,0.,0.,1.,0.,1.", 0, 1, {1, 3}},
               {"2,0,0,0,1.,0.,3.,1.,0.,0.,1.,0.,1.", 0, 1, {1, 3}},
               {"2,0,0,1,1.,0.,3.,10.,0.,0.,1.,0.,1.", 0, 1, {1, 3}},
               {"2,0,0,1,1.,0.,3.,10.,0.,0.,1.,0.5,1.", 0.5, 1, {2, 3}},
               {"2,0,0,2,1.,0.5,3.,0.5,0.,0.,1.,0.,1.", 0, 1, {1, 1}},
               {"3,3,2,2,0.,0.,0.,0.,0.,0.,1.,0.,1.", 0, 1, {4, 6}},
               {"3,3,1,2,0.,0.,0.,0.,0.,0.,1.,0.,0.5", 0, 0.5, {7, 7.5}}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        char text[200];
        iges_file_begin();
        iges_file_add(110, 0, 0, false, "110,0.,0.,5.,10.,0.,5.;");
        iges_file_add(110, 0, 0, false, "110,7.,4.,0.,8.,6.,0.;");
        snprintf(text, sizeof text, "130,1,%s;", row[k].text);
        ck_assert_int_eq(curve(iges_file_add(130, 0, 0, false, text)), 0);
        ck_assert_uint_eq(loop.n, 1);
        for (int end = 0; end < 2; end++) {
            struct vec3 p = at(0, end), wanted = vec(10 * (end ? row[k].to : row[k].from), 0, 5);
            wanted.y = row[k].y[end];
            ck_assert_msg(vec_distance(p, wanted) < 1e-5, "%zu: %.9g %.9g %.9g", k, p.x, p.y, p.z);
        }
        teardown();
        memset(&iges, 0, sizeof iges);
    }
    /* a flag, a measure and a coordinate that are none; too few numbers */
    static const char *const bad[] = {
        "4,0,0,0,2.,0.,0.,0.,0.,0.,1.,0.,1.", "0,0,0,0,2.,0.,0.,0.,0.,0.,1.,0.,1.",
        "2,0,0,3,1.,0.,3.,1.,0.,0.,1.,0.,1.", "3,3,4,2,0.,0.,0.,0.,0.,0.,1.,0.,1.",
        "1,0,0,0,2.,0.,0.,0.,0.,0."};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        char text[200];
        iges_file_begin();
        iges_file_add(110, 0, 0, false, "110,0.,0.,5.,10.,0.,5.;");
        iges_file_add(110, 0, 0, false, "110,7.,4.,0.,8.,6.,0.;");
        snprintf(text, sizeof text, "130,1,%s;", bad[k]);
        ck_assert_msg(curve(iges_file_add(130, 0, 0, false, text)) == -1, "%zu", k);
        teardown();
        memset(&iges, 0, sizeof iges);
    }
    iges_file_begin();
}
END_TEST

/* Over a quarter of a circle the length that counts is its own: halfway round 2 of 1 to 3. */
START_TEST(offset_of_an_arc)
{
    iges_file_begin();
    iges_file_add(100, 0, 0, false, "100,0.,0.,0.,10.,0.,0.,10.;");
    ck_assert_int_eq(curve(iges_file_add(130, 0, 0, false,
                                         "130,1,2,0,0,1,1.,0.,3.,15.707963267948966,0.,0.,1.,0.,"
                                         "1.5707963267948966;")),
                     0);
    ck_assert_uint_eq(loop.n, 1);
    for (int i = 0; i <= 8; i++) {
        struct vec3 p = at(0, i / 8.0);
        double turn = atan2(p.y, p.x), radius = 10 - 1 - 2 * turn / (PI / 2);
        ck_assert_double_eq_tol(hypot(p.x, p.y), radius, 1e-5);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("iges_curve");
    TCase *tests = tcase_create("iges_curve");
    tcase_add_checked_fixture(tests, iges_file_begin, teardown);
    tcase_add_test(tests, line);
    tcase_add_test(tests, arcs);
    tcase_add_test(tests, polylines);
    tcase_add_test(tests, splines);
    tcase_add_test(tests, offsets);
    tcase_add_test(tests, offset_of_an_arc);
    tcase_add_test(tests, conics);
    tcase_add_test(tests, transformations);
    tcase_add_test(tests, composites);
    tcase_add_test(tests, no_curves);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
