/* iges_construct: every kind of surface goes through the points that its definition says (IGES 5.3,
 * 4.20 to 4.30, 4.63 to 4.67), placed with its normal on the side that it says. */
#include "iges_files.h"

#include "base/array.h"
#include "io/nurbs/iges_construct.h"
#include "io/nurbs/iges_curve.h"
#include "math/elementary.h"
#include "nurbs/construct.h"

static struct transform place; /* twice as large, turned and shifted */

static void setup(void)
{
    iges_file_begin();
    struct transform turn = construct_place(vec(5, -3, 8), vec(1, 2, 2), vec(2, 1, -2));
    place = transform_product(turn, transform_scale(2));
}

static void again(void)
{
    iges_file_end();
    setup();
}

static int construct(int number)
{
    iges_file_read();
    return iges_construct(&iges, iges_entity(&iges, number), &place, &patch, &error);
}

/* A number as IGES writes it. */
static int add(int type, int form, const char *format, double a, double b, double c)
{
    /* cppcheck-suppress wrongPrintfScanfArgNum ; formats use as many as they need */
    return iges_file_format(type, form, 0, true, format, a, b, c);
}

/* The point of the surface, in the file's place and lengths, at parts of the range. */
static struct vec3 local(double part_u, double part_v)
{
    const struct nurbs *s = &patch.surface;
    struct uv at = {s->u.from + part_u * (s->u.to - s->u.from),
                    s->v.from + part_v * (s->v.to - s->v.from)};
    struct vec3 p = nurbs_point(s, at), d = vec_sub(p, vec(5, -3, 8));
    struct vec3 column[3];
    for (int k = 0; k < 3; k++)
        column[k] = vec(place.m[0][k], place.m[1][k], place.m[2][k]);
    return vec(vec_dot(d, column[0]) / 4, vec_dot(d, column[1]) / 4, vec_dot(d, column[2]) / 4);
}

static void near_point(struct vec3 p, struct vec3 q)
{
    ck_assert_msg(vec_distance(p, q) < 1e-9, "%.15g %.15g %.15g, not %.15g %.15g %.15g", p.x, p.y,
                  p.z, q.x, q.y, q.z);
}

/* A loop in space, which ends what has no end: a square of side 2 h about a point. */
static void bound(struct vec3 at, double h)
{
    static const double corner[5][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
    struct patch_loop loop = {.space = true};
    for (int i = 0; i < 4; i++) {
        struct vec3 p = vec_add(at, vec(h * corner[i][0], h * corner[i][1], h * corner[i][0]));
        struct vec3 q =
            vec_add(at, vec(h * corner[i + 1][0], h * corner[i + 1][1], h * corner[i + 1][0]));
        *array_push(&loop) = construct_line(transform_point(&place, p), transform_point(&place, q));
    }
    *array_push(&patch.loop) = loop;
}

/* x + 2 y + 2 z = 9, as far as its loop; without one it has no end. */
START_TEST(plane)
{
    int number = add(108, 0, "108,%g,%g,%g,9.,0;", 1, 2, 2);
    bound(vec(1, 2, 2), 3);
    ck_assert_int_eq(construct(number), 0);
    for (int i = 0; i <= 4; i++)
        for (int k = 0; k <= 4; k++) {
            struct vec3 p = local(i / 4.0, k / 4.0);
            ck_assert_double_eq_tol(p.x + 2 * p.y + 2 * p.z, 9, 1e-9);
        }
    struct uv middle = {(patch.surface.u.from + patch.surface.u.to) / 2,
                        (patch.surface.v.from + patch.surface.v.to) / 2};
    struct vec3 n = nurbs_place(&patch.surface, middle).normal, zero = {0, 0, 0};
    struct vec3 along =
        vec_sub(transform_point(&place, vec(1, 2, 2)), transform_point(&place, zero));
    ck_assert_double_eq_tol(vec_dot(n, vec_unit(along)), 1, 1e-12);
    again();
    ck_assert_int_eq(construct(add(108, 0, "108,%g,%g,%g,9.,0;", 1, 2, 2)), 1);
    again();
    bound(vec(1, 2, 2), 3);
    ck_assert_int_eq(construct(add(108, 0, "108,%g,%g,%g,9.,0;", 0, 0, 0)), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "a normal of no length"));
}
END_TEST

/* Two patches in u, one in v: x = u, y = v, z = a cubic of both. */
START_TEST(spline)
{
    char text[4000];
    size_t n = (size_t)sprintf(text, "114,3,1,2,1,0.,1.,3.,0.,2.");
    for (int patch_u = 0; patch_u < 3; patch_u++)     /* one more than there are ... */
        for (int patch_v = 0; patch_v < 2; patch_v++) /* ... which is not used */
            for (int axis = 0; axis < 3; axis++)
                for (int k = 0; k < 16; k++) {
                    double start = patch_u == 0 ? 0 : 1, c = 0;
                    if (axis == 0)
                        c = k == 0 ? start : k == 1;
                    if (axis == 1)
                        c = k == 4;
                    if (axis == 2) /* z = u^3 / 4 + v u, about the patch's own start */
                        c = k == 0   ? start / 4
                            : k == 1 ? 3 * start / 4
                            : k == 2 ? 3 * start / 4
                            : k == 3 ? 0.25
                            : k == 4 ? start
                                     : k == 5;
                    if (patch_u == 2 || patch_v == 1)
                        c = 99;
                    n += (size_t)sprintf(text + n, ",%g", c);
                }
    sprintf(text + n, ";");
    ck_assert_int_eq(construct(iges_file_add(114, 0, 0, false, text)), 0);
    for (int i = 0; i <= 6; i++)
        for (int k = 0; k <= 4; k++) {
            double u = i / 2.0, v = k / 2.0;
            near_point(local(u / 3, v / 2), vec(u, v, u * u * u / 4 + u * v));
        }
    again();
    ck_assert_int_eq(construct(iges_file_add(114, 0, 0, false, "114,3,1,1,1,0.,1.,0.,1.,5.;")), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "fewer coefficients"));
}
END_TEST

/* A line of radius 4 turned from 30 to 150 degrees about z, and a whole turn. */
START_TEST(revolution)
{
    for (int whole = 0; whole < 2; whole++) {
        again();
        int axis = iges_file_add(110, 0, 0, true, "110,0.,0.,-1.,0.,0.,1.;");
        int line = iges_file_add(110, 0, 0, true, "110,4.,0.,2.,4.,0.,7.;");
        double from = whole ? 0 : RADIANS(30), to = whole ? 2 * PI : RADIANS(150);
        char text[200];
        snprintf(text, sizeof text, "120,%d,%d,%.17g,%.17g;", axis, line, from, to);
        ck_assert_int_eq(construct(iges_file_add(120, 0, 0, false, text)), 0);
        near_point(local(0, 0), vec(4 * cos(from), 4 * sin(from), 2));
        near_point(local(1, 1), vec(4 * cos(to), 4 * sin(to), 7));
        double middle = (from + to) / 2;
        near_point(local(0.5, 0.4), vec(4 * cos(middle), 4 * sin(middle), 4));
        for (int i = 0; i <= 20; i++) {
            struct vec3 p = local(i / 20.0, i / 20.0);
            ck_assert_double_eq_tol(hypot(p.x, p.y), 4, 1e-9);
            ck_assert(whole || atan2(p.y, p.x) > from - 1e-9);
            ck_assert(whole || atan2(p.y, p.x) < to + 1e-9);
        }
    }
    again();
    int axis = iges_file_add(110, 0, 0, true, "110,0.,0.,-1.,0.,0.,-1.;");
    int line = iges_file_add(110, 0, 0, true, "110,4.,0.,2.,4.,0.,7.;");
    char text[100];
    snprintf(text, sizeof text, "120,%d,%d,0.,1.;", axis, line);
    ck_assert_int_eq(construct(iges_file_add(120, 0, 0, false, text)), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "an axis without length"));
    again();
    axis = iges_file_add(110, 0, 0, true, "110,0.,0.,-1.,0.,0.,1.;");
    line = iges_file_add(110, 0, 0, true, "110,4.,0.,2.,4.,0.,7.;");
    snprintf(text, sizeof text, "120,%d,%d,2.,1.;", axis, line);
    ck_assert_int_eq(construct(iges_file_add(120, 0, 0, false, text)), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "angles that do not rise"));
}
END_TEST

/* A quarter of a circle along a line whose END the entity names, not its direction. */
START_TEST(tabulated)
{
    int arc = iges_file_add(100, 0, 0, true, "100,1.,0.,0.,3.,0.,0.,3.;");
    char text[100];
    snprintf(text, sizeof text, "122,%d,3.,4.,6.;", arc);
    ck_assert_int_eq(construct(iges_file_add(122, 0, 0, false, text)), 0);
    near_point(local(0, 0), vec(3, 0, 1));
    near_point(local(1, 0), vec(0, 3, 1));
    near_point(local(0, 1), vec(3, 4, 6));
    near_point(local(1, 1), vec(0, 7, 6));
    near_point(local(0.5, 0.5), vec(3 * sqrt(0.5), 3 * sqrt(0.5) + 2, 3.5));
}
END_TEST

/* Between lines; that nothing is approximated. */
START_TEST(ruled)
{
    int a = iges_file_add(110, 0, 0, true, "110,0.,0.,0.,4.,0.,0.;");
    int b = iges_file_add(110, 0, 0, true, "110,0.,6.,2.,8.,6.,2.;");
    char text[100];
    snprintf(text, sizeof text, "118,%d,%d,0,0;", a, b);
    ck_assert_int_eq(construct(iges_file_add(118, 0, 0, false, text)), 0);
    near_point(local(0.25, 0.5), vec((1 + 2) / 2.0, 3, 1));
    near_point(local(1, 1), vec(8, 6, 2));
    ck_assert_double_lt(patch.rough, 1e-9);
}
END_TEST

/* How far a local point is off the surface of a solid about the y axis through 1, 2, 3. */
static double off_solid(int type, struct vec3 p)
{
    double x = p.x - 1, y = p.y - 2, z = p.z - 3, r = hypot(x, z);
    return type == 190   ? y
           : type == 192 ? r - 4
           : type == 194 ? r - (4 + y * tan(RADIANS(20)))
           : type == 196 ? hypot(r, y) - 4
                         : hypot(r - 4, y) - 1.5;
}

/* Form 1 has a direction of angle 0 beside the axis: in both the surface is where it is. */
START_TEST(solids)
{
    static const char *const numbers[] = {"", ",4.", ",4.,20.", ",4.", ",4.,1.5"};
    for (int type = 190; type <= 198; type += 2)
        for (int form = 0; form <= 1; form++) {
            again();
            int at = iges_file_add(116, 0, 0, true, "116,1.,2.,3.;");
            int axis = iges_file_add(123, 0, 0, true, "123,0.,7.,0.;");
            int zero = iges_file_add(123, 0, 0, true, "123,0.,0.,1.;");
            char text[200], direction[40] = "", own[40] = "";
            if (type != 196)
                snprintf(own, sizeof own, ",%d", axis);
            if (form == 1 && type == 196)
                snprintf(direction, sizeof direction, ",%d,%d", axis, zero);
            else if (form == 1)
                snprintf(direction, sizeof direction, ",%d", zero);
            snprintf(text, sizeof text, "%d,%d%s%s%s;", type, at, own, numbers[(type - 190) / 2],
                     direction);
            bound(vec(1, 3, 3), 2);
            ck_assert_msg(construct(iges_file_add(type, form, 0, false, text)) == 0, "%d, %d: %s",
                          type, form, error.text);
            for (int i = 0; i <= 12; i++)
                for (int k = 0; k <= 6; k++) {
                    double off = off_solid(type, local(i / 12.0, k / 6.0));
                    ck_assert_msg(fabs(off) < 1e-9, "%d, form %d: %g off", type, form, off);
                }
            if (form == 1 && type != 190) { /* u is the angle about y, from z on */
                struct vec3 p = local(0, 0.5);
                ck_assert_double_eq_tol(p.x, 1, 1e-9);
                ck_assert_double_gt(p.z, 3);
            }
        }
    again();
    int line = iges_file_add(110, 0, 0, true, "110,0.,0.,-1.,0.,0.,1.;");
    ck_assert_int_eq(construct(add(196, 0, "196,%g,4.;", line, 0, 0)), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "a place that is no entity 116"));
    again();
    int at = iges_file_add(116, 0, 0, true, "116,1.,2.,3.;");
    ck_assert_int_eq(construct(add(192, 0, "192,%g,%g,4.;", at, at, 0)), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "a direction that is no entity 123"));
    again(); /* another kind */
    ck_assert_int_eq(construct(iges_file_add(110, 0, 0, false, "110,0.,0.,-1.,0.,0.,1.;")), 1);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("iges_construct");
    TCase *tests = tcase_create("iges_construct");
    tcase_add_checked_fixture(tests, setup, iges_file_end);
    tcase_add_test(tests, plane);
    tcase_add_test(tests, spline);
    tcase_add_test(tests, revolution);
    tcase_add_test(tests, tabulated);
    tcase_add_test(tests, ruled);
    tcase_add_test(tests, solids);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
