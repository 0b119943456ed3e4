/* cl_dialect, cl_catia, cl_nx: the words that one CAM system alone has, as the motion that they
 * mean, by hand; and what is wrong with them, by its line. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/path/path.h"
#include "scratch.h"

static struct path path;
static struct error error;

static void teardown(void)
{
    path_free(&path);
}

static int take(const char *text)
{
    path_free(&path);
    path = (struct path){0};
    return path_read(scratch_text(text), &path, &error);
}

static void taken(const char *text)
{
    ck_assert_msg(take(text) == 0, "%s", error.text);
}

/* The k-th motion. */
static const struct path_item *motion(size_t k)
{
    for (size_t i = 0; i < path.item.n; i++)
        if (path.item.item[i].kind <= PATH_SPLINE && k-- == 0)
            return &path.item.item[i];
    ck_abort_msg("no motion");
}

static void ends_at(size_t k, struct vec3 p, struct vec3 axis)
{
    ck_assert_double_lt(vec_distance(motion(k)->to.p, p), 1e-9);
    ck_assert_double_lt(vec_distance(motion(k)->to.a, axis), 1e-9);
}

static const struct bspline *curve_of(size_t k)
{
    ck_assert_int_eq(motion(k)->kind, PATH_SPLINE);
    return &path.spline.item[motion(k)->index].curve;
}

#define CATIA "$$*CATIA0\nUNITS/MM\nMULTAX\nCUTTER/10\nFEDRAT/800,MMPM\nGOTO/10,0,0,0,0,1\n"
#define UP ((struct vec3){0, 0, 1})

/* From 10 0 to 0 10 about 0 0: the short way to the left, the long one to the right. */
START_TEST(arcs_of_catia)
{
    static const char *const along[] = {"0,1,0", "0,-1,0", "0.003,-1,0.0004"};
    for (int i = 0; i < 3; i++) {
        char text[500];
        snprintf(text, sizeof text,
                 CATIA
                 "INDIRV/%s\nTLON,GOFWD/ (CIRCLE/ 0, 0,0,10),ON,(LINE/ 0,0,0, 0,10,0)\nFINI\n",
                 along[i]);
        taken(text);
        ck_assert_int_eq(motion(1)->kind, PATH_ARC);
        const struct path_arc *arc = &path.arc.item[motion(1)->index];
        ck_assert_double_lt(vec_length(arc->centre), 1e-12);
        ck_assert_double_eq(arc->radius, 10);
        /* square to the tool exactly, though the direction has few digits */
        ck_assert_double_eq(vec_distance(arc->axis, vec(0, 0, i == 0 ? 1 : -1)), 0);
        ends_at(1, vec(0, 10, 0), UP);
    }
}
END_TEST

START_TEST(wrong_arcs_of_catia)
{
    static const char *const k[][2] = {
        {"TLON,GOFWD/ (CIRCLE/ 0,0,0,10),ON,(LINE/ 0,0,0,0,10,0)\n", "without a direction"},
        {"INDIRV/0,1,0\nTLON,GOFWD/ (CIRCLE/ 0,0,10),ON,(LINE/ 0,0,0,0,10,0)\n",
         "without (CIRCLE/ and 4 numbers"},
        {"INDIRV/0,1,0\nTLON,GOFWD/ (CIRCLE/ 0,0,0,10),ON,(LINE/ 0,0,0,0,10)\n",
         "without (LINE/ and 6 numbers"},
        {"INDIRV/-1,0.1,0\nTLON,GOFWD/ (CIRCLE/ 0,0,0,10),ON,(LINE/ 0,0,0,0,10,0)\n",
         "points to its centre"}};
    for (size_t i = 0; i < sizeof k / sizeof *k; i++) {
        char text[500];
        snprintf(text, sizeof text, CATIA "%sFINI\n", k[i][0]);
        ck_assert_int_eq(take(text), -1);
        ck_assert_msg(strstr(error.text, k[i][1]) != NULL, "%s", error.text);
        ck_assert_ptr_nonnull(strstr(error.text, i == 0 ? ":7: " : ":8: "));
    }
}
END_TEST

/* A number that is none, or beyond any, is no length and no place. */
START_TEST(curves_of_no_numbers)
{
    static const char *const length[] = {"1E999", "nan", "X", "-50"};
    for (size_t i = 0; i < sizeof length / sizeof *length; i++) {
        char text[600];
        snprintf(text, sizeof text,
                 CATIA "BEGIN NURBS_SIEMENS(D=1,AXIS=VAR,LENGTH=%s);\n"
                       "N0,XT=10,YT=0,ZT=0,XH=10,YH=0,ZH=50,DK=0,W=1;\n"
                       "N1,XT=12,YT=0,ZT=0,XH=12,YH=0,ZH=50,DK=0,W=1;\nEND NURBS;\nFINI\n",
                 length[i]);
        ck_assert_msg(take(text) == -1, "%s", length[i]);
        ck_assert_msg(strstr(error.text, ":7: ") != NULL, "%s", error.text);
    }
}
END_TEST

/* The guide's cubic of four poles is a Bezier curve; its knots are scaled to its length, 12. */
START_TEST(curves_of_catia)
{
    taken(CATIA "BEGIN NURBS_SIEMENS(D=3,F=4000,AXIS=0,0.6,0.8);\nN0,XT=10,YT=0,ZT=0,DK=0,W=1;\n"
                "N1,XT=14,YT=0,ZT=0,DK=0,W=1;\nN2,XT=18,YT=0,ZT=0,DK=7,W=1;\n"
                "N3,XT=22,YT=0,ZT=0,DK=0,W=1;\nEND NURBS;\nFINI\n");
    const struct bspline *c = curve_of(1);
    ck_assert_int_eq(c->degree, 3);
    ck_assert_uint_eq(c->poles, 4);
    for (int i = 0; i < 8; i++)
        ck_assert_double_eq_tol(c->knot[i], i < 4 ? 0 : 12, 1e-6);
    ck_assert_double_eq(c->pole[2].x, 18);
    ck_assert_ptr_null(c->head);
    ends_at(1, vec(22, 0, 0), vec(0, 0.6, 0.8));
    const struct poses *straight = &path.spline.item[motion(1)->index].fallback;
    ck_assert_double_lt(vec_distance(straight->item[straight->n - 1].p, vec(22, 0, 0)), 1e-9);
    /* of the second degree with a knot inside, a third of the way; the axis by its head */
    taken(CATIA "BEGIN NURBS_SIEMENS(D=2,AXIS=VAR,LENGTH=50);\n"
                "N0,XT=10,YT=0,ZT=0,XH=10,YH=0,ZH=50,DK=0,W=1;\n"
                "N1,XT=12,YT=0,ZT=0,XH=12,YH=0,ZH=50,DK=0,W=1;\n"
                "N2,XT=16,YT=0,ZT=0,XH=16,YH=0,ZH=50,DK=1,W=1;\n"
                "N3,XT=22,YT=0,ZT=0,XH=52,YH=0,ZH=40,DK=2,W=1;\nEND NURBS;\nFINI\n");
    c = curve_of(1);
    ck_assert_int_eq(c->degree, 2);
    ck_assert_double_eq(c->length, 50);
    ck_assert_double_eq(c->head[2].z, 50);
    ck_assert_double_eq_tol(c->knot[3] / c->knot[4], 1.0 / 3, 1e-12);
    ck_assert_double_eq(c->knot[2], 0);
    ends_at(1, vec(22, 0, 0), vec(0.6, 0, 0.8));
    /* the highest degree there is */
    char text[2000];
    int n = snprintf(text, sizeof text, CATIA "BEGIN NURBS_SIEMENS(D=7);\n");
    for (int i = 0; i < 8; i++)
        n += snprintf(text + n, sizeof text - (size_t)n, "N%d,XT=%d,YT=0,ZT=0,DK=%d,W=1;\n", i,
                      10 + i, i == 2);
    snprintf(text + n, sizeof text - (size_t)n, "END NURBS;\nFINI\n");
    taken(text);
    ck_assert_int_eq(curve_of(1)->degree, 7);
    ends_at(1, vec(17, 0, 0), UP);
}
END_TEST

#define POLE(n, x, dk) "N" #n ",XT=" #x ",YT=0,ZT=0,DK=" #dk ",W=1;\n"
#define FOUR POLE(0, 10, 0) POLE(1, 14, 0) POLE(2, 18, 7) POLE(3, 22, 0)

START_TEST(wrong_curves_of_catia)
{
    static const char *const k[][2] = {
        {"BEGIN NURBS_SIEMENS(D=8,F=1);\n", "D=8 in NURBS_SIEMENS, expected a degree of 1 to 7"},
        {"BEGIN NURBS_SIEMENS(D=2.5);\n", "D=2.5"},
        {"BEGIN NURBS_SIEMENS(D=3,AXIS=VAR);\n", "AXIS=VAR without LENGTH"},
        {"BEGIN NURBS_SIEMENS(D=3,AXIS=0,x,1);\n", "AXIS= without three numbers"},
        {"BEGIN NURBS_SIEMENS(D=3);\nN0,XT=1,YT=2,DK=0,W=1;\n", "without ZT="},
        {"BEGIN NURBS_SIEMENS(D=3);\nN0,XT=1,YT=2,ZT=0,W=1;\n", "without DK of 0 or more"},
        {"BEGIN NURBS_SIEMENS(D=3);\nN0,XT=1,YT=2,ZT=0,DK=0,W=0.5;\n", "weight 0.5"},
        {"BEGIN NURBS_SIEMENS(D=3);\nN0,XT=1e9,YT=2,ZT=0,DK=0,W=1;\n", "too far for any machine"},
        {"BEGIN NURBS_SIEMENS(D=3);\n" POLE(0, 10, 0) "END NURBS;\n",
         "with 1 poles, expected at least 4"},
        {"BEGIN NURBS_SIEMENS(D=3);\nGOTO/1,2,3\n", "expected END NURBS first"},
        {"BEGIN NURBS_SIEMENS(D=3);\n" POLE(0, 11, 0) POLE(1, 14, 0) POLE(2, 18, 7)
             POLE(3, 22, 0) "END NURBS;\n",
         "1.0000 mm from where the tool is"},
        {"BEGIN NURBS_SIEMENS(D=3);\n" POLE(0, 10, 0) POLE(1, 14, 3) POLE(2, 18, 7)
             POLE(3, 22, 0) "END NURBS;\n",
         "DK 3 at pole 1"},
        {"BEGIN NURBS_SIEMENS(D=3);\n" POLE(0, 10, 0) POLE(1, 14, 0) POLE(2, 18, 7)
             POLE(3, 22, 1) "END NURBS;\n",
         "DK 1 at pole 3"},
        {"BEGIN NURBS_SIEMENS(D=3);\n" POLE(0, 10, 0) POLE(1, 14, 0) POLE(2, 18, 0)
             POLE(3, 22, 0) "END NURBS;\n",
         "DK are all 0"}};
    for (size_t i = 0; i < sizeof k / sizeof *k; i++) {
        char text[800];
        snprintf(text, sizeof text, CATIA "%sFINI\n", k[i][0]);
        ck_assert_msg(take(text) == -1, "%s", k[i][1]);
        ck_assert_msg(strstr(error.text, k[i][1]) != NULL, "%s", error.text);
    }
    ck_assert_int_eq(take("$$*CATIA0\nUNITS/MM\nBEGIN NURBS_SIEMENS(D=3);\n" FOUR "END NURBS;\n"),
                     -1);
    ck_assert_ptr_nonnull(strstr(error.text, "expected a GOTO before it"));
}
END_TEST

#define NX                                                                            \
    "TOOL PATH/ROUGH,TOOL,BALL_10\nTLDATA/MILL,10,5,75,0,0\nMSYS/0,0,0,1,0,0,0,1,0\n" \
    "FEDRAT/MMPM,800\nGOTO/0,0,0,0,0,1\n"

/* A second system that is turned a quarter about z at 100 0 0: its x is the first one's y. */
START_TEST(systems_of_nx)
{
    taken(NX "GOTO/1,2,3\nEND-OF-PATH\nTOOL PATH/FINE,TOOL,BALL_10\nTLDATA/MILL,10,5,75,0,0\n"
             "MSYS/100,0,0,0,1,0,-1,0,0\nGOTO/1,2,3,1,0,0\nEND-OF-PATH\n");
    ends_at(0, vec(0, 0, 0), UP);
    ends_at(1, vec(1, 2, 3), UP);
    ends_at(2, vec(98, 1, 3), vec(0, 1, 0));
    ck_assert_str_eq(path.head.tool_name, "BALL_10");
    ck_assert_uint_eq(path.tool.n, 0); /* the same again */
    /* each path begins upright, whatever the last one ended with */
    taken(NX "GOTO/1,2,3,0,0.6,0.8\nEND-OF-PATH\nTOOL PATH/FINE,TOOL,BALL_10\n"
             "TLDATA/MILL,10,5,75,0,0\nMSYS/0,0,0,1,0,0,0,1,0\nGOTO/4,5,6\nEND-OF-PATH\n");
    ends_at(1, vec(1, 2, 3), vec(0, 0.6, 0.8));
    ends_at(2, vec(4, 5, 6), UP);
    ck_assert_int_eq(take("TOOL PATH/A,TOOL,B\nTLDATA/MILL,10,5,75,0,0\nNURBS\nEND-OF-PATH\n"), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "before any position"));
    ck_assert_int_eq(take(NX "CYCLE/DRILL,RAPTO,3,FEDTO,-10,MMPM,100\nNURBS\nEND-OF-PATH\n"), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "among the holes"));
    ck_assert_int_eq(take(NX "MSYS/0,0,0,1,0,0,0.1,1,0\nEND-OF-PATH\n"), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "not square"));
    ck_assert_int_eq(take("TOOL PATH/A,TOOL,B\nTLDATA/MILL,0,5\nEND-OF-PATH\n"), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "no diameter"));
}
END_TEST

START_TEST(curves_of_nx)
{
    taken(NX "NURBS\nKNOT/0.25,1\nCNTRL/4,0,0\nCNTRL/8,0,0\nCNTRL/12,0,0\nCNTRL/16,0,0\n"
             "END-OF-PATH\n");
    const struct bspline *c = curve_of(1);
    ck_assert_uint_eq(c->poles, 5);
    ck_assert_double_eq_tol(c->knot[4] / c->knot[5], 0.25, 1e-12);
    ck_assert_double_eq_tol(c->knot[8], 16, 1e-6);
    ck_assert_double_eq(c->knot[3], 0);
    ends_at(1, vec(16, 0, 0), UP);
    static const char *const k[][2] = {
        {"NURBS\nKNOT/1\nCNTRL/4,0,0\nCNTRL/8,0,0\n", "3 poles and 1 knots"},
        {"NURBS\nKNOT/0.5,1\nCNTRL/4,0,0\nCNTRL/8,0,0\nCNTRL/9,0,0\n", "4 poles and 2 knots"},
        {"NURBS\nKNOT/0.5\nCNTRL/4,0,0\nCNTRL/8,0,0\nCNTRL/9,0,0\n", "knot 1 of NURBS to be 0.5"},
        {"NURBS\nKNOT/0,1\nCNTRL/4,0,0\nCNTRL/8,0,0\nCNTRL/9,0,0\nCNTRL/10,0,0\n", "to be 0,"},
        {"NURBS\nKNOT/1,1\nCNTRL/4,0,0\nCNTRL/8,0,0\nCNTRL/9,0,0\nCNTRL/10,0,0\n", "knot 1"},
        {"NURBS\nKNOT/1\nCNTRL/4,0\n", "2 numbers in CNTRL"},
        {"NURBS\nCNTRL/4,0,1e9\n", "too far for any machine"},
        {"KNOT/1\n", "KNOT without NURBS"},
        {"CNTRL/1,2,3\n", "CNTRL without NURBS"}};
    for (size_t i = 0; i < sizeof k / sizeof *k; i++) {
        char text[800];
        snprintf(text, sizeof text, NX "%sEND-OF-PATH\n", k[i][0]);
        ck_assert_msg(take(text) == -1, "%s", k[i][1]);
        ck_assert_msg(strstr(error.text, k[i][1]) != NULL, "%s", error.text);
    }
}
END_TEST

/* MAKINO-FF has no FINI: it ends with a section, however blanks stand beside its commas. */
START_TEST(end_of_makino)
{
#define MAKINO "PPRINT/APTCL-SPEC,MAKINO-FF,1\nUNITS/MM\nGOTO/1,2,3\n"
    taken(MAKINO "PPRINT/END-SECTION,PROCESS-END-PATH\n");
    taken(MAKINO "PPRINT/END-SECTION , PROCESS-END-PATH\n");
    ck_assert_int_eq(take(MAKINO "PPRINT/END-SECTION,MACHINING\n"), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "the input ends without FINI"));
    ck_assert_int_eq(take(MAKINO), -1);
}
END_TEST

/* SolidWorks: the third column of CSYS is the tool axis; INSERT is a comment. */
START_TEST(solidworks)
{
    taken("INSERT/BALL 10\nUNITS/MM\nCUTTER/10\nCSYS/1,0,0,0,0,0.8,0.6,0,0,-0.6,0.8,0\n"
          "TRNTYP/WORLD,0,0,0\nINSERT/FINE\nFEDRAT/800,MMPM\nGOTO/1,2,3\nFINI\n");
    ends_at(0, vec(1, 2, 3), vec(0, 0.6, 0.8));
    ck_assert_uint_eq(path.text.n, 2);
    ck_assert_int_eq(strncmp(path.text.item[0], "PPRINT", 6), 0);
    ck_assert_int_eq(strncmp(path.text.item[1], "PPRINT", 6), 0);
    ck_assert_int_eq(take("UNITS/MM\nTRNTYP/WORLD,0,0,1\nFINI\n"), -1);
    ck_assert_ptr_nonnull(strstr(error.text, ":2: found TRNTYP/WORLD,0,0,1, expected 0,0,0"));
    ck_assert_int_eq(take("UNITS/MM\nTRNTYP/LOCAL\nFINI\n"), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "found TRNTYP/LOCAL, expected TRNTYP/WORLD"));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cl_dialect");
    TCase *tests = tcase_create("cl_dialect");
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, arcs_of_catia);
    tcase_add_test(tests, wrong_arcs_of_catia);
    tcase_add_test(tests, curves_of_no_numbers);
    tcase_add_test(tests, curves_of_catia);
    tcase_add_test(tests, wrong_curves_of_catia);
    tcase_add_test(tests, systems_of_nx);
    tcase_add_test(tests, curves_of_nx);
    tcase_add_test(tests, end_of_makino);
    tcase_add_test(tests, solidworks);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
