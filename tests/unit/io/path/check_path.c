/* check_path - the path stream: what is read, what is refused, and that writing gives it back. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "io/path/path.h"

static char folder[] = "/tmp/cloudmill-path.XXXXXX";
static char in_name[64], out_name[64];

/* Reads the text as a path. */
static int read_text(const char *text, struct path *path, struct error *error)
{
    FILE *f = fopen(in_name, "w");
    ck_assert_ptr_nonnull(f);
    ck_assert_int_ge(fputs(text, f), 0);
    ck_assert_int_eq(fclose(f), 0);
    return path_read(in_name, path, error);
}

static char *written(const struct path *path)
{
    struct out *out = out_open(out_name);
    path_write(out, path);
    out_close(out);
    static char text[8192];
    FILE *f = fopen(out_name, "r");
    ck_assert_ptr_nonnull(f);
    text[fread(text, 1, sizeof text - 1, f)] = '\0';
    fclose(f);
    return text;
}

#define HEAD                                                                    \
    "PARTNO/PANEL 7\nUNITS/MM\nMULTAX/ON\n"                                     \
    "CUTTER/16.000000,8.000000,0.000000,8.000000,0.000000,0.000000,60.000000\n" \
    "LOADTL/3\nSPINDL/RPM,8000.000000,CLW\nCOOLNT/ON\n$$-> CLOUDMILL/1\n"

static const char whole[] =
    HEAD "$$-> TOOL/FLUTE,20.000000,HOLDER,3:40+10:25.5:20\n"
         "$$-> LEDGER/cloud2mesh,0.012000\n$$-> CHORD/0.090000\n$$-> CLEAR/40.000000\n"
         "$$-> NOISE/0.002500\n$$-> REGION/BORDER,1.250000\n"
         "$$-> REGION/BOX,0.000000,-5.000000,-5.500000,40.000000,30.000000,10.000000\n"
         "$$-> REGION/POLYGON,0.000000,0.000000,9.000000,0.000000,9.000000,9.000000\n"
         "$$-> REGION/CORNERS,0.000000,9.000000\n"
         "$$-> REGION/POLYGON,1.000000,1.000000,2.000000,1.000000,1.000000,2.000000\n$$-> "
         "PASS/1\nRAPID\nGOTO/0.000000,0.000000,40.000000,0.000000000,0.000000000,1.000000000\n"
         "FEDRAT/MMPM,800.000000\n"
         "$$-> CONTCT/1.000000,0.000000,0.000000,0.000000000,0.600000000,0.800000000\n"
         "GOTO/1.000000,0.000000,0.000000,0.000000000,0.600000000,0.800000000\n"
         "CIRCLE/0.000000,0.000000,0.000000,0.000000000,0.000000000,1.000000000,1.000000\n"
         "GOTO/0.000000,1.000000,0.000000,0.000000000,0.600000000,0.800000000\n"
         "MOVNRB/5AXIS,LENGTH,100.000000\nMOVNRB/ON,4,8,0,4,3.000000\n"
         "MOVNRB/1,0.000000,0.000000,0.000000,0.000000,3.000000,3.000000, $\n3.000000,3.000000\n"
         "MOVNRB/2,0.000000,1.000000,0.000000,0.000000,2.000000,0.000000, $\n"
         "0.000000,3.000000,0.000000,0.000000,4.000000,0.000000\n"
         "MOVNRB/3,0.000000,61.000000,80.000000,0.000000,62.000000,80.000000, $\n"
         "0.000000,63.000000,80.000000,0.000000,64.000000,80.000000\n"
         "MOVNRB/NEXT\nGOTO/0.000000,4.000000,0.000000,0.000000000,0.600000000,0.800000000\n"
         "MOVNRB/OFF\nSTOP\nFINI\n";

START_TEST(what_is_read_is_written_back)
{
    struct path path;
    struct error error = {.text = ""};
    ck_assert_msg(read_text(whole, &path, &error) == 0, "%s", error.text);
    ck_assert_str_eq(written(&path), whole);
    ck_assert_uint_eq(path.item.n, 7);
    ck_assert_double_eq(path_ball(&path), 8);
    ck_assert_double_eq_tol(path_spent(&path), 0.012, 1e-12);
    ck_assert_int_eq(path.item.item[4].kind, PATH_ARC);
    ck_assert_int_eq(path.item.item[5].kind, PATH_SPLINE);
    ck_assert_double_eq_tol(path.item.item[5].to.a.y, 0.6, 1e-12);

    struct holder holder = path_holder(&path); /* the flute, R 8, is wider than the shank */
    ck_assert_int_eq(holder.n, 3);
    ck_assert_double_eq(holder.part[0].high, 8);
    ck_assert_double_eq(holder.part[0].length, 20);
    ck_assert_double_eq(holder.part[1].low, 3);
    ck_assert_double_eq(holder.part[2].high, 25.5);

    struct path copy = {0};
    path_head_copy(&copy.head, &path.head);
    path_add_items(&copy, &path, 0, path.item.n);
    path_free(&path);
    ck_assert_str_eq(written(&copy), whole);
    path_free(&copy);
}
END_TEST

START_TEST(units_labels_and_continuations)
{
    struct path path;
    struct error error = {.text = ""};
    const char *text = "partno part 5 $ no continuation\r\nUnits / Inches\r\n"
                       "GOTO/ 1.0, 2.0, $ $$ half of it\n  .5, 0, $\n0, 1\n"
                       "FEDRAT/10.,IPM\nGODLTA/0,0,-.5\nFINI\nnot read\n";
    ck_assert_msg(read_text(text, &path, &error) == 0, "%s", error.text);
    ck_assert_str_eq(path.head.partno, "part 5 $ no continuation");
    ck_assert_uint_eq(path.item.n, 3);
    ck_assert_double_eq_tol(path.item.item[0].to.p.z, 12.7, 1e-12);
    ck_assert_double_eq_tol(path.item.item[1].feed, 254, 1e-12);
    ck_assert_double_eq_tol(path.item.item[2].to.p.z, 0, 1e-12);
    path_free(&path);
}
END_TEST

START_TEST(from_is_carried_in_millimetres)
{
    struct path path;
    struct error error = {.text = ""};
    const char *text =
        "UNITS/INCHES\nFROM/1,2,-3,0,0.6,0.8\nCIRCLE/1,3,-3,0,0,1\nGOTO/2,3,-3\nFINI\n";
    ck_assert_msg(read_text(text, &path, &error) == 0, "%s", error.text);
    const char *again = written(&path);
    ck_assert_ptr_nonnull(strstr(
        again, "\nFROM/25.400000,50.800000,-76.200000,0.000000000,0.600000000,0.800000000\n"));
    path_free(&path);
    ck_assert_msg(read_text(again, &path, &error) == 0, "%s", error.text);
    path_free(&path);
}
END_TEST

static const struct {
    const char *text, *message;
} refused[] = {
    {"", "empty"},
    {"UNITS/MM\n", "FINI"},
    {"UNITS/CUBITS\nFINI\n", "CUBITS"},
    {"GOTO/1,2\nFINI\n", ":1: found 2 numbers"},
    {"GOTO/1,2,3,4,5\nFINI\n", "found 5 numbers"},
    {"GOTO/1,2,nan\nFINI\n", "`NAN`"},
    {"GOTO/1,2,1e308\nFINI\n", "too large"},
    {"GOTO/1,2,3,0,0,0\nFINI\n", "length zero"},
    {"GOTO/1,0,0\nCIRCLE/0,0,0,0,0,1,1\nFINI\n", ":3: found FINI after CIRCLE"},
    {"GOTO/1,0,0\nCIRCLE/0,0,0,0,0,1,-1\nGOTO/0,1,0\nFINI\n", "radius -1"},
    {"GOTO/1,0,0\nCIRCLE/0,0,0,0,0,0,1\nGOTO/0,1,0\nFINI\n", "length zero"},
    {"GOTO/1,0,0\nCIRCLE/0,0,0,0,0,1,1\nGOTO/0,1.1,0\nFINI\n", "end of a CIRCLE 1.1000 mm"},
    {"GOTO/1,0,0\nCIRCLE/0,0,0.1,0,0,1,1\nGOTO/0,1,0\nFINI\n", "0.1000 mm off its plane"},
    {"GOTO/1,0,0\nSPLINE/1,2,3\nFINI\n", "geometry word SPLINE"},
    {"L1 = LINE/1,2,3\nFINI\n", "geometry word"},
    {"FEDRAT/MMPM,0\nFINI\n", "feed of 0"},
    {"FEDRAT/nan\nFINI\n", "NAN"},
    {"GOTO/1,2, $\n", "continued"},
    {"GOTO/1,2,3\001\nFINI\n", "binary"},
    {"GOTO/0,0,0\nMOVNRB/M3AXIS\nMOVNRB/ON,4,8,0,4,1\nMOVNRB/1,0,0,0,0,1,1,1\nFINI\n", "7 knots"},
    {"GOTO/0,0,0\nMOVNRB/M3AXIS\nMOVNRB/ON,4,8,0,4,1\nMOVNRB/1,0,0,0,1,0,1,1,1\nFINI\n", "knot 5"},
    {"GOTO/0,0,0\nMOVNRB/M3AXIS\nMOVNRB/ON,4,8,0,4,1\nMOVNRB/1,1,0,0,0,1,1,1,1\nFINI\n", "knot 2"},
    {"GOTO/0,0,0\nMOVNRB/M3AXIS\nMOVNRB/ON,4,9,0,4,1\nFINI\n", "knots = poles + order"},
    {"GOTO/0,0,0\nMOVNRB/M3AXIS\nFINI\n", "within MOVNRB"},
    {"GOTO/0,0,0\nMOVNRB/2,1,2,3\nFINI\n", "out of its order"},
};

START_TEST(what_is_refused)
{
    struct path path;
    struct error error = {.text = ""};
    ck_assert_msg(read_text(refused[_i].text, &path, &error) < 0, "taken: %s", refused[_i].text);
    ck_assert_msg(strstr(error.text, refused[_i].message) != NULL, "%s", error.text);
    ck_assert_msg(strncmp(error.text, in_name, strlen(in_name)) == 0, "%s", error.text);
}
END_TEST

START_TEST(unknown_words_are_counted_and_carried)
{
    struct path path;
    struct error error = {.text = ""};
    ck_assert_int_eq(read_text("FROBNI/1\nFROBNI/2\nGRONK\nFINI\n", &path, &error), 0);
    ck_assert_uint_eq(path.unknown.n, 2);
    ck_assert_uint_eq(path.unknown.item[0].times, 2);
    ck_assert_uint_eq(path.text.n, 3);
    path_free(&path);
}
END_TEST

START_TEST(runs_are_rows_of_contact_points)
{
    struct path path = {0};
    struct pose pose = {{0, 0, 0}, {0, 0, 1}};
    path_add_pass(&path, 1);
    path_add_point(&path, pose, true);
    path_add_point(&path, pose, false); /* approach: no contact */
    for (int i = 0; i < 3; i++)
        path_add_point(&path, pose, false)->touches = true;
    path_add_point(&path, pose, false);                 /* retract */
    path_add_point(&path, pose, false)->touches = true; /* alone: no run */
    path_add_pass(&path, 2);
    for (int i = 0; i < 2; i++)
        path_add_point(&path, pose, false)->touches = true;
    size_t from = 0, to = 0;
    ck_assert(path_next_run(&path, &from, &to));
    ck_assert_uint_eq(from, 3);
    ck_assert_uint_eq(to, 6);
    from = to;
    ck_assert(path_next_run(&path, &from, &to));
    ck_assert_uint_eq(from, 9);
    ck_assert_uint_eq(to, 11);
    from = to;
    ck_assert(!path_next_run(&path, &from, &to));
    path_free(&path);
}
END_TEST

int main(void)
{
    if (!mkdtemp(folder))
        return 1;
    snprintf(in_name, sizeof in_name, "%s/in.cl", folder);
    snprintf(out_name, sizeof out_name, "%s/out.cl", folder);
    Suite *suite = suite_create("path");
    TCase *tests = tcase_create("path");
    tcase_add_test(tests, what_is_read_is_written_back);
    tcase_add_test(tests, units_labels_and_continuations);
    tcase_add_test(tests, from_is_carried_in_millimetres);
    tcase_add_loop_test(tests, what_is_refused, 0, (int)(sizeof refused / sizeof *refused));
    tcase_add_test(tests, unknown_words_are_counted_and_carried);
    tcase_add_test(tests, runs_are_rows_of_contact_points);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    remove(in_name);
    remove(out_name);
    remove(folder);
    return failed != 0;
}
