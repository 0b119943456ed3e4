/*
 * iges: a file is put together here, column by column, and the ways that files differ are put into
 * it: delimiters, texts that hold them, defaults, exponents, units, column 65, transformations,
 * records without line ends; and what must be refused.
 */
#include <check.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "io/nurbs/iges_surface.h"
#include "scratch.h"

/* A file in the making: its directory and parameters grow entity by entity. */
struct file {
    char global[400], directory[8000], parameter[16000];
    int entities, lines;
    const char *end; /* of a line */
};

static struct file new_file(const char *global)
{
    struct file f = {.end = "\n"};
    snprintf(f.global, sizeof f.global, "%s", global);
    return f;
}

static const char *const MM = "1H,,1H;,4Hpart,4Hfile,4Hmake,1H1,32,38,6,308,15,4Hpart,1.,2,2HMM,1,"
                              "0.01,13H261121.101010,1E-6,200.,,,11,0;";

static void append(char *to, size_t size, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static void append(char *to, size_t size, const char *format, ...)
{
    size_t n = strlen(to);
    va_list list;
    va_start(list, format);
    ck_assert_int_lt(vsnprintf(to + n, size - n, format, list), (int)(size - n));
    va_end(list);
}

/* Lines of `width` characters of the parameters; width 65 runs on into column 65. */
static void add(struct file *f, int type, int form, int matrix, size_t width,
                const char *parameters)
{
    int number = 2 * f->entities + 1, first = f->lines + 1;
    for (const char *p = parameters; *p; p += strlen(p) < width ? strlen(p) : width) {
        char text[70];
        snprintf(text, sizeof text, "%-*.*s", (int)width, (int)width, p);
        append(f->parameter, sizeof f->parameter, "%s%*dP%7d%s", text, 72 - (int)width, number,
               ++f->lines, f->end);
    }
    append(f->directory, sizeof f->directory, "%8d%8d%8d%8d%8d%8d%8d%8d%8sD%7d%s", type, first, 0,
           0, 0, 0, matrix, 0, "00000000", number, f->end);
    append(f->directory, sizeof f->directory, "%8d%8d%8d%8d%8d%16s%8s%8dD%7d%s", type, 0, 0,
           f->lines - first + 1, form, "", "", 0, number + 1, f->end);
    f->entities++;
}

static int read_file(const struct file *f, struct patches *patches, struct error *error)
{
    char text[32000] = "";
    int globals = 0;
    append(text, sizeof text, "%-72sS%7d%s", "made by check_iges", 1, f->end);
    for (const char *g = f->global; *g; g += strlen(g) < 72 ? strlen(g) : 72)
        append(text, sizeof text, "%-72.72sG%7d%s", g, ++globals, f->end);
    append(text, sizeof text, "%s%sS%7dG%7dD%7dP%7d%40sT%7d%s", f->directory, f->parameter, 1,
           globals, 2 * f->entities, f->lines, "", 1, f->end);
    struct reader r;
    struct iges iges;
    *patches = (struct patches){0};
    ck_assert_int_eq(reader_open(&r, scratch_text(text), error), 0);
    int status = iges_read(&r, &iges, error);
    reader_close(&r);
    if (status == 0) {
        status = iges_surfaces(&iges, 0, patches, error);
        iges_free(&iges);
    }
    return status;
}

/* The corners of the first surface and its middle, in mm. */
static void expect(const struct file *f, double scale, struct vec3 shift)
{
    struct patches patches;
    struct error error = {.text = ""};
    ck_assert_msg(read_file(f, &patches, &error) == 0, "%s", error.text);
    ck_assert_uint_eq(patches.n, 1);
    const struct nurbs *s = &patches.item[0].surface;
    for (int i = 0; i < 9; i++) {
        double u = i % 3 / 2.0, v = i / 3 / 2.0;
        struct vec3 p = nurbs_point(s, (struct uv){u, v});
        struct vec3 want = vec_add(vec_scale(scale, vec(40 * u, 30 * v, 8 * u * v)), shift);
        ck_assert_double_lt(vec_distance(p, want), 1e-9);
    }
    patches_free(&patches);
}

static const char *const PATCH = "128,1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,"
                                 "0.,0.,0.,40.,0.,0.,0.,30.,0.,40.,30.,8.,0.,1.,0.,1.;";

START_TEST(plain)
{
    struct file f = new_file(MM);
    add(&f, 128, 0, 0, 64, PATCH);
    expect(&f, 1, vec(0, 0, 0));
    f = new_file(MM);
    f.end = "\r\n";
    add(&f, 128, 0, 0, 64, PATCH);
    expect(&f, 1, vec(0, 0, 0));
    f = new_file(MM);
    f.end = "";
    add(&f, 128, 0, 0, 64, PATCH);
    expect(&f, 1, vec(0, 0, 0));
}
END_TEST

START_TEST(column_65)
{
    struct file f = new_file(MM);
    add(&f, 128, 0, 0, 65, PATCH);
    expect(&f, 1, vec(0, 0, 0));
    f = new_file(MM);
    add(&f, 128, 0, 0, 17, PATCH); /* numbers broken over lines have blanks after them */
    struct patches patches;
    struct error error;
    read_file(&f, &patches, &error); /* refused or read, never a crash */
    patches_free(&patches);
}
END_TEST

START_TEST(numbers_and_defaults)
{
    struct file f = new_file(MM);
    add(&f, 128, 0, 0, 64,
        "128 ,1,1, 1,1,,,,,,,,1.,1D0,,0.,1.0E+00,1.d0,.1D1,1,+1.,10.E-1,,,,4.D+1,,,,30,,40.,"
        "3.0D1,8.,,1.,,1.;");
    expect(&f, 1, vec(0, 0, 0));
    f = new_file(MM); /* no range at all: that of the knots; pointers after it count for nothing */
    add(&f, 128, 0, 0, 64,
        "128,1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,"
        "0.,0.,0.,40.,0.,0.,0.,30.,0.,40.,30.,8.;");
    expect(&f, 1, vec(0, 0, 0));
    f = new_file(MM); /* a range beyond the knots is cut to them */
    add(&f, 128, 0, 0, 64,
        "128,1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,"
        "0.,0.,0.,40.,0.,0.,0.,30.,0.,40.,30.,8.,-1.,2.,0.,1.,0,0;");
    expect(&f, 1, vec(0, 0, 0));
}
END_TEST

START_TEST(global_section)
{
    static const struct {
        const char *global;
        double scale;
    } way[] = {
        {",,4Hpart,4Hfile,4Hmake,1H1,32,38,6,308,15,4Hpart,1.,2,2HMM;", 1},
        {"1H,,,9Ha,b;c,d;e,4Hfile,,,,,,,,,,2,2HMM;", 1},
        {"1H,,1H;,,,,,,,,,,,,1,4HINCH;", 25.4},
        {"1H,,1H;,,,,,,,,,,,2.,1,4HINCH;", 12.7},
        {"1H,,1H;,,,,,,,,,,,,3,2HCM;", 10},
        {"1H,,1H;,,,,,,,,,,,,6,1HM;", 1000},
        {"1H,,1H;;", 25.4},
        {",;", 25.4},
        {",,;", 25.4},
    };
    for (size_t i = 0; i < sizeof way / sizeof *way; i++) {
        struct file f = new_file(way[i].global);
        add(&f, 128, 0, 0, 64, PATCH);
        expect(&f, way[i].scale, vec(0, 0, 0));
    }
    struct file f = new_file("1H//1H#/4Hp,;,/4Hfile/4Hmake/1H1/32/38/6/308/15/4Hpart/1./2/2HMM#");
    char text[400];
    snprintf(text, sizeof text, "%s", PATCH);
    for (char *p = text; *p; p++)
        *p = *p == ',' ? '/' : *p == ';' ? '#' : *p;
    add(&f, 128, 0, 0, 64, text);
    expect(&f, 1, vec(0, 0, 0));
}
END_TEST

/* Each of the 26 parameters has its kind, from the third to the last. */
START_TEST(kinds_of_the_global_section)
{
    static const char *const good[26] = {"1H,",
                                         "1H;",
                                         "4Hpart",
                                         "4Hfile",
                                         "4Hmake",
                                         "1H1",
                                         "32",
                                         "38",
                                         "6",
                                         "308",
                                         "15",
                                         "4Hpart",
                                         "1.",
                                         "2",
                                         "2HMM",
                                         "1",
                                         "0.01",
                                         "13H261121.101010",
                                         "1E-6",
                                         "90.",
                                         "2Hme",
                                         "2Hus",
                                         "11",
                                         "0",
                                         "13H261121.101010",
                                         "3Happ"};
    for (int wrong = 0; wrong <= 26; wrong++) {
        char global[400] = "", found[80];
        for (int i = 0; i < 26; i++) {
            const char *bad = strchr(good[i], 'H') ? "7" : "1Hx";
            append(global, sizeof global, "%s%s", i + 1 == wrong && i > 1 ? bad : good[i],
                   i < 25 ? "," : ";");
        }
        struct file f = new_file(global);
        struct patches patches;
        struct error error = {.text = ""};
        add(&f, 128, 0, 0, 64, PATCH);
        int got = read_file(&f, &patches, &error);
        patches_free(&patches);
        ck_assert_msg(got == (wrong > 2 ? -1 : 0), "%d: %s", wrong, error.text);
        snprintf(found, sizeof found, "as parameter %d of the global section", wrong);
        ck_assert_msg(wrong <= 2 || strstr(error.text, found), "%d: %s", wrong, error.text);
    }
}
END_TEST

/* Entity 3 shifts by (1, 2, 3), entity 5 turns x to y and points to 3: first turned, then shifted.
 */
START_TEST(transformations)
{
    struct file f = new_file(MM);
    struct patches patches;
    struct error error = {.text = ""};
    add(&f, 128, 0, 5, 64, PATCH);
    add(&f, 124, 0, 0, 64, "124,1.,0.,0.,1.,0.,1.,0.,2.,0.,0.,1.,3.;");
    add(&f, 124, 0, 3, 64, "124,0.,-1.,0.,0.,1.,0.,0.,0.,0.,0.,1.,0.;");
    ck_assert_msg(read_file(&f, &patches, &error) == 0, "%s", error.text);
    struct vec3 p = nurbs_point(&patches.item[0].surface, (struct uv){1, 0.5});
    ck_assert_double_lt(vec_distance(p, vec(-15 + 1, 40 + 2, 4 + 3)), 1e-12);
    patches_free(&patches);
    f = new_file(MM);
    add(&f, 128, 0, 3, 64, PATCH);
    add(&f, 124, 0, 3, 64, "124,1.,0.,0.,1.,0.,1.,0.,2.,0.,0.,1.,3.;");
    ck_assert_int_eq(read_file(&f, &patches, &error), -1);
    patches_free(&patches);
}
END_TEST

/* A 144 with a loop of a line, an arc, a polyline and a spline; a hole in space alone, placed as
 * the 144 is; one of a curve that is not read is counted. */
START_TEST(trimming)
{
    struct file f = new_file(MM);
    struct patches patches;
    struct error error = {.text = ""};
    add(&f, 144, 0, 25, 64, "144,3,1,3,5,17,19,23;");
    add(&f, 128, 0, 0, 64, PATCH);
    add(&f, 142, 0, 0, 64, "142,0,3,7,0,1;");
    add(&f, 102, 0, 0, 64, "102,4,9,11,13,15;");
    add(&f, 110, 0, 0, 64, "110,0.1,0.1,0.,0.9,0.1,0.;");
    add(&f, 100, 0, 0, 64, "100,0.,0.9,0.5,0.9,0.1,0.9,0.9;");
    add(&f, 106, 11, 0, 64, "106,1,3,0.,0.9,0.9,0.5,0.8,0.1,0.9;");
    add(&f, 126, 0, 0, 64,
        "126,1,1,1,0,1,0,0.,0.,1.,1.,1.,1.,0.1,0.9,0.,0.1,0.1,0.,0.,1.,0.,0.,1.;");
    add(&f, 142, 0, 0, 64, "142,0,3,0,9,2;");
    add(&f, 142, 0, 0, 64, "142,0,3,21,0,1;");
    add(&f, 116, 0, 0, 64, "116,9.,9.,9.;");
    add(&f, 142, 0, 0, 64, "142,0,3,7,9,2;");
    add(&f, 124, 0, 0, 64, "124,1.,0.,0.,100.,0.,1.,0.,0.,0.,0.,1.,0.;");
    ck_assert_msg(read_file(&f, &patches, &error) == 0, "%s", error.text);
    ck_assert_uint_eq(patches.n, 1);
    const struct patch *p = &patches.item[0];
    ck_assert_uint_eq(p->loop.n, 3);
    ck_assert_int_eq(p->entity, 3);
    ck_assert_int_eq(p->ignored, 1);
    ck_assert_int_eq(p->ignored_entity, 19);
    for (int i = 1; i < 3; i++) { /* the second has both and prefers space */
        const struct patch_loop *hole = &p->loop.item[i];
        ck_assert(hole->space);
        ck_assert_uint_eq(hole->n, 1);
        struct vec3 at = nurbs_curve_point(&hole->item[0], 1);
        ck_assert_double_lt(vec_distance(at, vec(100.9, 0.1, 0)), 1e-12);
    }
    ck_assert(!p->loop.item[0].space);
    const struct patch_loop *l = &p->loop.item[0];
    for (size_t i = 0; i < l->n; i++) {
        const struct nurbs_curve *a = &l->item[i], *b = &l->item[(i + 1) % l->n];
        struct vec3 end = nurbs_curve_point(a, a->t.to), begin = nurbs_curve_point(b, b->t.from);
        ck_assert_double_lt(vec_distance(end, begin), 1e-12);
        for (int k = 0; k <= 8 && a->t.degree == 2; k++) {
            struct vec3 q = nurbs_curve_point(a, k / 8.0);
            ck_assert_double_lt(fabs(vec_distance(q, vec(0.9, 0.5, 0)) - 0.4), 1e-12);
            ck_assert_double_gt(q.x, 0.9 - 1e-12);
        }
    }
    patches_free(&patches);
}
END_TEST

static void refused(int type, const char *parameters, const char *words)
{
    struct file f = new_file(MM);
    struct patches patches;
    struct error error = {.text = ""};
    add(&f, type, 0, 0, 64, parameters);
    ck_assert_int_eq(read_file(&f, &patches, &error), -1);
    ck_assert_msg(strstr(error.text, words) != NULL, "%s: no '%s'", error.text, words);
    patches_free(&patches);
}

START_TEST(refusals)
{
    struct file f = new_file(MM);
    struct patches patches;
    struct error error;
    refused(144, "144,1,1,0,5;", "expected a surface");
    refused(128, "128,1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.;", "expected 34");
    refused(128, "128,1,1,1,1,0,0,1,0,0,0.,0.,1.,1.", "cut short");
    refused(128, "128,1.5,1,1,1;", "whole number");
    refused(128, "128,99Habc;", "99 characters");
#define SQUARE(knots, weights, last, range)                                                      \
    "128,1,1,1,1,0,0,1,0,0," knots ",0.,0.,1.,1.," weights ",0.,0.,0.,40.,0.,0.,0.,30.,0.," last \
    "," range ";"
    refused(128, SQUARE("0.,0.,1.,1.", "1.,1.,1.,1.", "5Hhello,30.,8.", "0.,1.,0.,1."), "a text");
    refused(128, SQUARE("0.,0.,1.,1.", "1.,1.,1.,1.", "1E13,30.,8.", "0.,1.,0.,1."), "1e+13");
    refused(128, SQUARE("0.,0.,1E308,1E308", "1.,1.,1.,1.", "40.,30.,8.", "0.,1.,0.,1."), "1e+308");
    refused(128, SQUARE("0.,0.,1.,1.", "1.,-1.,1.,1.", "40.,30.,8.", "0.,1.,0.,1."), "weight -1");
    refused(128, SQUARE("0.,0.,1.,1.", "1.,1.,1.,1.", "40.,30.,8.", "1.,0.,0.,1."), "range in u");
    refused(128, SQUARE("0.,2.,1.,1.", "1.,1.,1.,1.", "40.,30.,8.", "0.,1.,0.,1."),
            "below the one");
    refused(128, SQUARE("0.,0.,1.,1.", "1.,1.,1.,1.", "40.,30.,1E999", "0.,1.,0.,1."), "finite");
    add(&f, 128, 0, 0, 64, PATCH);
    f.parameter[70] = '7'; /* the pointer back */
    ck_assert_int_eq(read_file(&f, &patches, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "directory entry"));
    patches_free(&patches);
    f.parameter[70] = ' ';
    f.parameter[79] = '9'; /* the sequence number */
    ck_assert_int_eq(read_file(&f, &patches, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "sequence"));
    patches_free(&patches);
}
END_TEST

/* A plane without an end that nothing trims is no part of the model, and none that is left out. */
START_TEST(planes_without_end)
{
    struct file f = new_file(MM);
    struct patches patches;
    struct error error = {.text = ""};
    add(&f, 128, 0, 0, 64, PATCH);
    add(&f, 108, 0, 0, 64, "108,0.,0.,1.,5.,0,0.,0.,0.,0.;");
    ck_assert_msg(read_file(&f, &patches, &error) == 0, "%s", error.text);
    ck_assert_uint_eq(patches.n, 1);
    ck_assert_uint_eq(patches.left.n, 0);
    patches_free(&patches);
}
END_TEST

/* What else IGES has than lines of 80 characters is told by the letter of the first one. */
START_TEST(other_forms)
{
    static const char *const word[] = {"compressed", "binary"};
    for (int i = 0; i < 2; i++) {
        char text[100];
        struct reader r;
        struct iges iges;
        struct error error = {.text = ""};
        snprintf(text, sizeof text, "%-72s%c%7d\n", "", "CB"[i], 1);
        ck_assert_int_eq(reader_open(&r, scratch_text(text), &error), 0);
        ck_assert_int_eq(iges_read(&r, &iges, &error), -1);
        reader_close(&r);
        ck_assert_msg(strstr(error.text, word[i]) != NULL, "%s", error.text);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("iges");
    TCase *tests = tcase_create("iges");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, plain);
    tcase_add_test(tests, column_65);
    tcase_add_test(tests, numbers_and_defaults);
    tcase_add_test(tests, global_section);
    tcase_add_test(tests, kinds_of_the_global_section);
    tcase_add_test(tests, transformations);
    tcase_add_test(tests, trimming);
    tcase_add_test(tests, refusals);
    tcase_add_test(tests, planes_without_end);
    tcase_add_test(tests, other_forms);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
