/* iges_trim: loops of a triangle, by each entity that trims (IGES 5.3, 4.31, 4.32, 4.70 to 4.72):
 * in the parameters or in space as the file prefers, edges turned round as the loop uses them. */
#include "iges_files.h"

#include "base/array.h"
#include "io/nurbs/iges_trim.h"

static struct iges_trimming trimming;
static int flat[3], space[3]; /* the sides of a triangle, as lines */

static void setup(void)
{
    static const char *const lines[2][3] = {
        {"110,0.,0.,0.,1.,0.,0.;", "110,1.,0.,0.,0.,1.,0.;", "110,0.,1.,0.,0.,0.,0.;"},
        {"110,0.,0.,5.,4.,0.,5.;", "110,4.,0.,5.,0.,4.,6.;", "110,0.,4.,6.,0.,0.,5.;"}};
    iges_file_begin();
    for (int i = 0; i < 3; i++) {
        flat[i] = iges_file_add(110, 0, 0, true, lines[0][i]);
        space[i] = iges_file_add(110, 0, 0, true, lines[1][i]);
    }
    trimming = (struct iges_trimming){.iges = &iges, .mm = 25.4, .outer = transform_identity()};
    trimming.outer.m[2][3] = 10;
}

static void again(void)
{
    iges_file_end();
    setup();
}

static int trim(int number)
{
    iges_file_read();
    return iges_trim(&trimming, &patch, iges_entity(&iges, number), &error);
}

static int composite(const int side[3])
{
    return iges_file_format(102, 0, 0, true, "102,3,%d,%d,%d;", side[0], side[1], side[2]);
}

/* The loop is the triangle, in its parameters or in mm, each side beginning where the last ends. */
static void is_triangle(const struct patch_loop *loop, bool in_space)
{
    static const double z[3] = {5, 5, 6};
    ck_assert_int_eq(loop->space, in_space);
    ck_assert_uint_eq(loop->n, 3);
    for (size_t i = 0; i < 3; i++)
        for (size_t end = 0; end < 2; end++) {
            const struct nurbs_curve *c = &loop->item[i];
            struct vec3 p = nurbs_curve_point(c, end ? c->t.to : c->t.from);
            size_t k = (i + end) % 3;
            struct vec3 q = vec(k == 1, k == 2, 0);
            if (in_space)
                q = vec(25.4 * 4 * q.x, 25.4 * 4 * q.y, 25.4 * (z[k] + 10));
            ck_assert_msg(vec_distance(p, q) < 1e-9, "side %zu: %g %g %g", i, p.x, p.y, p.z);
        }
}

static int curve_on_surface(int of_flat, int of_space, int prefers)
{
    return iges_file_format(142, 0, 0, true, "142,0,0,%d,%d,%d;", of_flat, of_space, prefers);
}

/* Preference 1 (or none): the parameters; 2: space, and what is told beside it. */
START_TEST(curves_on_a_surface)
{
    for (int prefers = 0; prefers <= 3; prefers++) {
        again();
        ck_assert_int_eq(trim(curve_on_surface(composite(flat), composite(space), prefers)), 0);
        ck_assert_uint_eq(patch.loop.n, 1);
        is_triangle(&patch.loop.item[0], prefers == 2);
        ck_assert_uint_eq(patch.told.n, prefers == 2);
        if (prefers == 2)
            is_triangle(&patch.told.item[0], false);
        ck_assert_int_eq(patch.ignored, 0);
    }
    again(); /* the reader wants space */
    trimming.space = true;
    ck_assert_int_eq(trim(curve_on_surface(composite(flat), composite(space), 1)), 0);
    is_triangle(&patch.loop.item[0], true);
}
END_TEST

/* The one that there is, whatever is preferred. */
START_TEST(one_curve_alone)
{
    ck_assert_int_eq(trim(curve_on_surface(0, composite(space), 1)), 0);
    is_triangle(&patch.loop.item[0], true);
    ck_assert_uint_eq(patch.told.n, 0);
    again();
    ck_assert_int_eq(trim(curve_on_surface(composite(flat), 0, 2)), 0);
    is_triangle(&patch.loop.item[0], false);
    again(); /* one of a kind that is not read counts as none */
    int point = iges_file_add(116, 0, 0, true, "116,0.,0.,0.;");
    ck_assert_int_eq(trim(curve_on_surface(point, composite(space), 1)), 0);
    is_triangle(&patch.loop.item[0], true);
    again(); /* neither: counted, and named */
    point = iges_file_add(116, 0, 0, true, "116,0.,0.,0.;");
    int number = curve_on_surface(point, 0, 1);
    ck_assert_int_eq(trim(number), 0);
    ck_assert_uint_eq(patch.loop.n, 0);
    ck_assert_int_eq(patch.ignored, 1);
    ck_assert_int_eq(patch.ignored_entity, number);
    ck_assert_int_eq(patch.ignored_type, 116);
    again();
    ck_assert_int_eq(trim(curve_on_surface(99, 0, 1)), -1);
}
END_TEST

/* 141: of each curve in space those in the parameters; all in space where one has none. */
START_TEST(boundaries)
{
    for (int kind = 0; kind < 3; kind++) { /* all have one, one has none, the reader wants space */
        again();
        char text[200], own[20];
        snprintf(own, sizeof own, kind == 1 ? "0" : "1,%d", flat[1]);
        snprintf(text, sizeof text, "141,0,1,1,3,%d,1,1,%d,%d,1,%s,%d,1,1,%d;", space[0], flat[0],
                 space[1], own, space[2], flat[2]);
        trimming.space = kind == 2;
        ck_assert_int_eq(trim(iges_file_add(141, 0, 0, true, text)), 0);
        ck_assert_uint_eq(patch.loop.n, 1);
        is_triangle(&patch.loop.item[0], kind > 0);
    }
    again();
    ck_assert_int_eq(trim(iges_file_add(141, 0, 0, true, "141,0,1,1,0;")), -1);
}
END_TEST

/* 508: edges by number in a list (504); the second runs against its curve, and one is a vertex. */
START_TEST(loops_of_edges)
{
    char text[300];
    int back = iges_file_add(110, 0, 0, true, "110,0.,4.,6.,4.,0.,5.;");
    snprintf(text, sizeof text, "504,3,%d,0,0,0,0,%d,0,0,0,0,%d,0,0,0,0;", space[0], back,
             space[2]);
    int list = iges_file_add(504, 1, 0, true, text);
    snprintf(text, sizeof text, "508,4,0,%d,1,1,0,0,%d,2,0,1,1,%d,1,%d,1,1,0,0,%d,3,1,0;", list,
             list, flat[0], list, list);
    ck_assert_int_eq(trim(iges_file_add(508, 1, 0, true, text)), 0);
    ck_assert_uint_eq(patch.loop.n, 1);
    ck_assert(patch.loop.item[0].directed);
    is_triangle(&patch.loop.item[0], true);
    /* an edge of several curves runs backwards as a whole */
    again();
    int ways[3] = {0, 0, 0};
    ways[0] = iges_file_add(110, 0, 0, true, "110,0.,0.,5.,0.,4.,6.;");
    ways[1] = iges_file_add(110, 0, 0, true, "110,0.,4.,6.,4.,0.,5.;");
    ways[2] = iges_file_add(110, 0, 0, true, "110,4.,0.,5.,0.,0.,5.;");
    snprintf(text, sizeof text, "504,1,%d,0,0,0,0;", composite(ways));
    list = iges_file_add(504, 1, 0, true, text);
    snprintf(text, sizeof text, "508,1,0,%d,1,0,0;", list);
    ck_assert_int_eq(trim(iges_file_add(508, 1, 0, true, text)), 0);
    is_triangle(&patch.loop.item[0], true);
    again();
    ck_assert_int_eq(trim(iges_file_add(508, 1, 0, true, "508,1,2,1,1,0,0;")), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "kind of edge"));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("iges_trim");
    TCase *tests = tcase_create("iges_trim");
    tcase_add_checked_fixture(tests, setup, iges_file_end);
    tcase_add_test(tests, curves_on_a_surface);
    tcase_add_test(tests, one_curve_alone);
    tcase_add_test(tests, boundaries);
    tcase_add_test(tests, loops_of_edges);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
