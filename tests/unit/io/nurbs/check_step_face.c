/* step_face: bounds of a face in a plane run with the material on their left, whatever their flags
 * and their edges' say; polygons, vertices and seams; what is left out, and what is no surface. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "io/nurbs/step_face.h"
#include "scratch.h"

static struct step step;
static struct patches patches;
static struct error error;

static void teardown(void)
{
    step_free(&step);
    patches_free(&patches);
    step = (struct step){0};
    patches = (struct patches){0};
}

/* Reads face #90 in mm, as it lies. */
static int read_face(const char *data)
{
    static const char *const common =
        "#1=CARTESIAN_POINT('',(0.,0.,0.));\n#2=DIRECTION('',(0.,0.,1.));\n"
        "#3=DIRECTION('',(1.,0.,0.));\n#4=AXIS2_PLACEMENT_3D('',#1,#2,#3);\n"
        "#5=PLANE('',#4);\n#6=SPHERICAL_SURFACE('',#4,5.);\n#7=CIRCLE('',#4,2.);\n"
        "#8=CARTESIAN_POINT('',(2.,0.,0.));\n#9=VERTEX_POINT('',#8);\n"
        "#10=EDGE_CURVE('',#9,#9,#7,.T.);\n#11=EDGE_CURVE('',#9,#9,#7,.F.);\n"
        "#12=CARTESIAN_POINT('',(4.,0.,0.));\n#13=CARTESIAN_POINT('',(4.,3.,0.));\n"
        "#14=CARTESIAN_POINT('',(0.,3.,0.));\n#15=POLY_LOOP('',(#1,#12,#13,#14));\n"
        "#16=CARTESIAN_POINT('',(0.,0.,5.));\n#17=VERTEX_POINT('',#16);\n"
        "#18=VERTEX_LOOP('',#17);\n#19=FOLIUM_SURFACE('',#4);\n#20=FOLIUM('',#4);\n"
        "#21=EDGE_CURVE('',#9,#9,#20,.T.);\n";
    char text[6000];
    struct reader r;
    struct step_values v = {0};
    teardown();
    snprintf(text, sizeof text,
             "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n%s%sENDSEC;\nEND-ISO-10303-21;\n", common,
             data);
    ck_assert_int_eq(reader_open(&r, scratch_text(text), &error), 0);
    ck_assert_msg(step_read(&r, &step, &error) == 0, "%s", error.text);
    reader_close(&r);
    struct step_place place = {&step, transform_identity(), 1, 1};
    ck_assert_int_eq(step_values(&step, step_find(&step, 90), &v, &error), 0);
    struct patch patch = {.entity = 90, .body = 3};
    int got = step_face(&place, &v, step_record(&v, "ADVANCED_FACE"), patch, &patches, &error);
    array_free(&v);
    return got;
}

/* What a loop encloses, seen from +z: positive where it runs counterclockwise, mm^2. */
static double enclosed(const struct patch_loop *loop)
{
    enum { PARTS = 400 };
    double sum = 0;
    for (size_t i = 0; i < loop->n; i++) {
        const struct nurbs_curve *c = &loop->item[i];
        struct vec3 p = nurbs_curve_point(c, c->t.from);
        for (int k = 1; k <= PARTS; k++) {
            double t = c->t.from + (c->t.to - c->t.from) * k / PARTS;
            struct vec3 q = nurbs_curve_point(c, t);
            sum += (p.x * q.y - p.y * q.x) / 2;
            p = q;
        }
    }
    return sum;
}

/* The edge's sense on its curve, and the flags of its place in the loop, of the bound and of the
 * face: each .F. turns the loop round, the face's because bounds run about the face's normal, and
 * the loop is about the surface's. */
START_TEST(each_flag_turns_the_loop)
{
    for (int i = 0; i < 16; i++) {
        char data[400];
        const char *flag[] = {".T.", ".F."};
        snprintf(data, sizeof data,
                 "#80=ORIENTED_EDGE('',*,*,#%d,%s);\n#81=EDGE_LOOP('',(#80));\n"
                 "#82=FACE_OUTER_BOUND('',#81,%s);\n#90=ADVANCED_FACE('',(#82),#5,%s);\n",
                 i & 1 ? 11 : 10, flag[i >> 1 & 1], flag[i >> 2 & 1], flag[i >> 3 & 1]);
        ck_assert_msg(read_face(data) == 0, "%s", error.text);
        ck_assert_uint_eq(patches.n, 1);
        ck_assert_uint_eq(patches.item[0].loop.n, 1);
        const struct patch_loop *loop = &patches.item[0].loop.item[0];
        ck_assert(loop->space && loop->directed);
        int turned = (i & 1) + (i >> 1 & 1) + (i >> 2 & 1) + (i >> 3 & 1);
        double area = turned % 2 ? -4 * 3.14159265358979 : 4 * 3.14159265358979;
        ck_assert_double_eq_tol(enclosed(loop), area, 1e-3);
    }
}
END_TEST

START_TEST(polygons_and_holes)
{
    ck_assert_int_eq(read_face("#80=ORIENTED_EDGE('',*,*,#10,.F.);\n#81=EDGE_LOOP('',(#80));\n"
                               "#82=FACE_OUTER_BOUND('',#15,.T.);\n#83=FACE_BOUND('',#81,.T.);\n"
                               "#90=ADVANCED_FACE('',(#82,#83),#5,.T.);\n"),
                     0);
    const struct patch *p = &patches.item[0];
    ck_assert_uint_eq(p->loop.n, 2);
    ck_assert_uint_eq(p->loop.item[0].n, 4);
    ck_assert_double_eq_tol(enclosed(&p->loop.item[0]), 12, 1e-9);
    ck_assert_double_lt(enclosed(&p->loop.item[1]), 0);
    ck_assert_int_eq(p->entity, 90);
    ck_assert_int_eq(p->body, 3);
    ck_assert(!p->open);
}
END_TEST

/* A whole sphere, bounded by a vertex at its pole or by a seam that is run twice: no loops. */
START_TEST(vertices_and_seams_bound_nothing)
{
    static const char *const whole[] = {
        "#80=FACE_BOUND('',#18,.T.);\n#90=ADVANCED_FACE('',(#80),#6,.T.);\n",
        "#78=ORIENTED_EDGE('',*,*,#10,.T.);\n#79=ORIENTED_EDGE('',*,*,#10,.F.);\n"
        "#80=EDGE_LOOP('',(#78,#79));\n#81=FACE_BOUND('',#80,.T.);\n"
        "#90=ADVANCED_FACE('',(#81),#6,.T.);\n"};
    for (int i = 0; i < 2; i++) {
        ck_assert_msg(read_face(whole[i]) == 0, "%s", error.text);
        ck_assert_uint_eq(patches.n, 1);
        ck_assert_uint_eq(patches.item[0].loop.n, 0);
        struct nurbs *s = &patches.item[0].surface;
        struct uv middle = {(s->u.from + s->u.to) / 2, (s->v.from + s->v.to) / 2};
        ck_assert_double_eq_tol(vec_length(nurbs_point(s, middle)), 5, 1e-9);
    }
}
END_TEST

START_TEST(what_is_not_read_is_counted)
{
    ck_assert_int_eq(read_face("#82=FACE_OUTER_BOUND('',#15,.T.);\n"
                               "#90=ADVANCED_FACE('',(#82),#19,.T.);\n"),
                     0);
    ck_assert_uint_eq(patches.n, 0);
    ck_assert_uint_eq(patches.left.n, 1);
    ck_assert_str_eq(patches.left.item[0].kind, "FOLIUM_SURFACE");
    ck_assert_int_eq(patches.left.item[0].entity, 90);
    ck_assert_int_eq(read_face("#80=ORIENTED_EDGE('',*,*,#21,.T.);\n#81=EDGE_LOOP('',(#80));\n"
                               "#82=FACE_BOUND('',#81,.T.);\n#83=FACE_OUTER_BOUND('',#15,.T.);\n"
                               "#90=ADVANCED_FACE('',(#83,#82),#5,.T.);\n"),
                     0);
    ck_assert_uint_eq(patches.n, 1);
    ck_assert_int_eq(patches.item[0].ignored, 1);
    ck_assert(patches.item[0].open);
}
END_TEST

static const struct {
    const char *data, *says;
} wrong[] = {
    {"#82=FACE_OUTER_BOUND('',#15,.T.);\n#90=ADVANCED_FACE('',(#82),#7,.T.);\n",
     "which is a CIRCLE, expected a surface"},
    {"#82=FACE_OUTER_BOUND('',#15,.T.);\n#90=ADVANCED_FACE('',(#82),#77,.T.);\n", "#77"},
    {"#82=FACE_OUTER_BOUND('',#15,.T.);\n#90=ADVANCED_FACE('',(#82),#5,.X.);\n", "#90"},
    {"#82=FACE_OUTER_BOUND('',#15,5);\n#90=ADVANCED_FACE('',(#82),#5,.T.);\n", "#82"},
    {"#80=ORIENTED_EDGE('',*,*,#76,.T.);\n#81=EDGE_LOOP('',(#80));\n"
     "#82=FACE_BOUND('',#81,.T.);\n#90=ADVANCED_FACE('',(#82),#5,.T.);\n",
     "#76"},
    {"#90=ADVANCED_FACE('',7,#5,.T.);\n", "#90: no list of bounds"},
    {"#90=ADVANCED_FACE('',$,#5,.T.);\n", "#90: no list of bounds"},
};

START_TEST(what_is_wrong_is_named)
{
    ck_assert_int_eq(read_face(wrong[_i].data), -1);
    ck_assert_msg(strstr(error.text, wrong[_i].says) != NULL, "%s", error.text);
    ck_assert_uint_eq(patches.n, 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("step_face");
    TCase *tests = tcase_create("step_face");
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, each_flag_turns_the_loop);
    tcase_add_test(tests, polygons_and_holes);
    tcase_add_test(tests, vertices_and_seams_bound_nothing);
    tcase_add_test(tests, what_is_not_read_is_counted);
    tcase_add_loop_test(tests, what_is_wrong_is_named, 0, (int)(sizeof wrong / sizeof *wrong));
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
