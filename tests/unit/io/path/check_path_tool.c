/* path_tool, path_motion: feeds and speeds in all their words; where GOHOME and RETRCT lead. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/path/path.h"
#include "scratch.h"

static int read_text(const char *text, struct path *path, struct error *error)
{
    return path_read(scratch_text(text), path, error);
}

/* The last feed of the path, 0: none. */
static double last_feed(const struct path *path)
{
    double feed = 0;
    for (size_t i = 0; i < path->item.n; i++)
        if (path->item.item[i].kind == PATH_FEED)
            feed = path->item.item[i].feed;
    return feed;
}

static const struct {
    const char *head, *words;
    double feed; /* mm/min over the 5 mm of the motion */
} feeds[] = {
    {"", "FEDRAT/MMPM,800", 800},
    {"", "FEDRAT/800,MMPM", 800},
    {"", "FEDRAT/800", 800},
    {"", "FEDRAT/10,IPM", 254},
    {"", "FEDRAT/IPM,10", 254},
    {"", "FEDRAT/2,FPM", 609.6},
    {"", "FEDRAT/.1,MMPR", 200},
    {"", "FEDRAT/IPR,.01", 508},
    {"", "FEDRAT/.001,FPR", 609.6},
    {"", "FEDRAT/PERMIN,141", 141},
    {"", "FEDRAT/.1,PERREV", 200},
    {"UNITS/INCHES\n", "FEDRAT/10", 254},
    {"UNITS/INCHES\n", "FEDRAT/PERMIN,10", 254},
    {"UNITS/INCHES\n", "FEDRAT/100,MMPM", 100},
    {"UNITS/CM\n", "FEDRAT/10", 100},
    {"", "FEDRAT/INVERS,4", 20},
    {"", "FEDRAT/300\nFEDRAT/INVERS,AUTO", 300},
    {"", "FEDRAT/300\nFEDRAT/INVERS,4\nFEDRAT/INVERS,OFF", 300},
};

START_TEST(feeds_in_all_units)
{
    struct path path;
    struct error error = {.text = ""};
    char text[400];
    const char *places = *feeds[_i].head == 0           ? "GOTO/5,0,0"
                         : strstr(feeds[_i].head, "CM") ? "GOTO/.5,0,0"
                                                        : "GOTO/.19685039370,0,0";
    snprintf(text, sizeof text, "SPINDL/RPM,2000\n%sGOTO/0,0,0\n%s\n%s\nFINI\n", feeds[_i].head,
             feeds[_i].words, places);
    ck_assert_msg(read_text(text, &path, &error) == 0, "%s", error.text);
    ck_assert_double_eq_tol(last_feed(&path), feeds[_i].feed, 1e-6);
    path_free(&path);
}
END_TEST

static const struct {
    const char *words;
    double speed;
    bool ccw;
} speeds[] = {
    {"SPINDL/RPM,900,CLW", 900, false},
    {"SPINDL/900,RPM,CCLW", 900, true},
    {"SPINDL/900", 900, false},
    {"SPINDL/CCLW,900", 900, true},
    {"SPINDL/RANGE,2,RPM,900,CLW", 900, false},
    {"SPINDL/MAXRPM,4000,900,RPM", 900, false},
    {"SPINDL/900,RPM,CLW,RANGE,LOW", 900, false},
    {"SPINDL/SMM,31.41592653589793,CLW", 1000, false},
    {"SPINDL/SFM,103.0705", 1000.0, false},
};

START_TEST(speeds_in_all_words)
{
    struct path path;
    struct error error = {.text = ""};
    char text[400];
    snprintf(text, sizeof text, "CUTTER/10\n%s\nGOTO/0,0,0\nFINI\n", speeds[_i].words);
    ck_assert_msg(read_text(text, &path, &error) == 0, "%s", error.text);
    ck_assert_double_eq_tol(path.head.spindle, speeds[_i].speed, 1e-2);
    ck_assert(path.head.spindle_ccw == speeds[_i].ccw);
    path_free(&path);
}
END_TEST

static const struct {
    const char *words, *text;
    size_t unknown;
} later[] = {
    {"SPINDL/OFF", "SPINDL/OFF", 0},
    {"SPINDL/OFF\nSPINDL/ON", "SPINDL/RPM,900.000000,CCLW", 0},
    {"SPINDL/CLW", "SPINDL/RPM,900.000000,CLW", 0},
    {"SPINDL/RANGE,3,500,CLW", "SPINDL/RPM,500.000000,CLW", 0},
    {"SPINDL/500,RPM", "SPINDL/500,RPM", 0},
    {"SPINDL/500,RPM\nSPINDL/OFF\nSPINDL/ON", "SPINDL/RPM,500.000000,CLW", 0},
    {"SPINDL/500,RPM,CCLW\nSPINDL/OFF\nSPINDL/ON", "SPINDL/RPM,500.000000,CCLW", 0},
    {"SPINDL/ORIENT,30", NULL, 1},
};

/* Behind the first one: as it is, or in words that its number cannot be mistaken in. */
START_TEST(speeds_that_follow)
{
    struct path path;
    struct error error = {.text = ""};
    char text[400];
    snprintf(text, sizeof text, "SPINDL/RPM,900,CCLW\nGOTO/0,0,0\n%s\nGOTO/1,0,0\nFINI\n",
             later[_i].words);
    ck_assert_msg(read_text(text, &path, &error) == 0, "%s", error.text);
    ck_assert_uint_eq(path.unknown.n, later[_i].unknown);
    if (later[_i].text)
        ck_assert_str_eq(path.text.item[path.text.n - 1], later[_i].text);
    else
        ck_assert_uint_eq(path.text.n, 0);
    ck_assert_double_eq(path.head.spindle, 900);
    path_free(&path);
}
END_TEST

static const struct {
    const char *words;
    int number, offset;
} loads[] = {{"LOADTL/3", 3, 0},
             {"LOADTL/3,OSETNO,12", 3, 12},
             {"LOADTL/3,LENGTH,90,OSETNO,12", 3, 12},
             {"LOADTL/3,ADJUST,99999999", 3, 99999999},
             {"LOADTL/3,OSETNO,100000000", 3, 0},
             {"LOADTL/3,OSETNO,1.5", 3, 0},
             {"LOADTL/3,OSETNO,0", 3, 0},
             {"LOADTL/3,OSETNO", 3, 0},
             {"LOADTL/99999999", 99999999, 0}};

/* The first tool and one that follows it, each with the number of its offset. */
START_TEST(tools_and_offsets)
{
    struct path path;
    struct error error = {.text = ""};
    char text[400];
    snprintf(text, sizeof text,
             "CUTTER/10\n%s\nSPINDL/RPM,900,CLW\nGOTO/0,0,0\nLOADTL/77,OSETNO,7\nGOTO/1,0,0\n"
             "FINI\n",
             loads[_i].words);
    ck_assert_msg(read_text(text, &path, &error) == 0, "%s", error.text);
    ck_assert_int_eq(path.head.tool, loads[_i].number);
    ck_assert_int_eq(path.head.offset, loads[_i].offset);
    ck_assert_uint_eq(path.tool.n, 1);
    ck_assert_int_eq(path.tool.item[0].number, 77);
    ck_assert_int_eq(path.tool.item[0].offset, 7);
    path_free(&path);
}
END_TEST

static const struct {
    const char *text;
    struct vec3 to; /* of the last but one point */
    size_t points, unknown;
} homes[] = {
    {"FROM/1,2,90\nGOTO/9,9,9\nGOHOME", {1, 2, 90}, 3, 0},
    {"GOTO/9,9,9\nGOHOME", {9, 9, 9}, 2, 1},
    {"GOTO/9,9,9\nGOHOME/3,4,80", {3, 4, 80}, 3, 0},
    {"CLEARP/XYPLAN,19\nGOTO/9,9,9,0,-.6,.8\nRETRCT", {9, 1.5, 19}, 3, 0},
    {"CLRSRF/19\nGOTO/9,9,9\nRETRCT", {9, 9, 19}, 3, 0},
    {"CLRSRF/0,2,0,58\nGOTO/9,9,9,0,1,0\nRETRCT", {9, 29, 9}, 3, 0},
    {"CLRSRF/19\nGOTO/9,9,20\nRETRCT", {9, 9, 20}, 2, 0},
    {"UNITS/CM\nCLRSRF/1.9\nGOTO/.9,.9,.9\nRETRCT\nUNITS/MM", {9, 9, 19}, 3, 0},
    {"TRANS/0,0,5\nCLEARP/XYPLAN,14\nGOTO/9,9,9\nRETRCT\nTRANS/0,0,0", {9, 9, 19}, 3, 0},
    {"GOTO/9,9,9\nRETRCT", {9, 9, 9}, 2, 1},
    {"CLRSRF/19\nGOTO/9,9,9,1,0,0\nRETRCT", {9, 9, 9}, 2, 1},
};

START_TEST(home_and_clear)
{
    struct path path;
    struct error error = {.text = ""};
    char text[400];
    snprintf(text, sizeof text, "%s\nGOTO/50,50,50,0,0,1\nFINI\n", homes[_i].text);
    ck_assert_msg(read_text(text, &path, &error) == 0, "%s", error.text);
    size_t points = 0, last = 0;
    for (size_t i = 0; i < path.item.n; i++)
        if (path.item.item[i].kind == PATH_POINT) {
            if (++points == homes[_i].points - 1)
                last = i;
        }
    ck_assert_uint_eq(points, homes[_i].points);
    ck_assert_double_lt(vec_distance(path.item.item[last].to.p, homes[_i].to), 1e-9);
    ck_assert(path.item.item[last].rapid == (points == 3));
    ck_assert_uint_eq(path.unknown.n, homes[_i].unknown);
    path_free(&path);
}
END_TEST

/* Seconds, or turns at the speed that is on, which become seconds. */
START_TEST(delays)
{
    static const struct {
        const char *text, *kept, *found; /* found: refused */
    } k[] = {{"DELAY/2.5", "DELAY/2.5", NULL},
             {"SPINDL/RPM,600\nDELAY/REV,5", "DELAY/0.500000", NULL},
             {"SPINDL/RPM,900\nDELAY/1,REV", "DELAY/0.066667", NULL},
             {"DELAY/REV,5", NULL, "found DELAY by turns, expected SPINDL"},
             {"DELAY/-1", NULL, "found `DELAY/-1`, expected DELAY/ and seconds"},
             {"DELAY/ON", NULL, "expected DELAY/ and seconds"}};
    for (size_t i = 0; i < sizeof k / sizeof *k; i++) {
        struct path path = {0};
        struct error error = {.text = ""};
        char text[200];
        snprintf(text, sizeof text, "UNITS/MM\nGOTO/0,0,0\n%s\nFINI\n", k[i].text);
        ck_assert_int_eq(read_text(text, &path, &error), k[i].found ? -1 : 0);
        if (k[i].found)
            ck_assert_msg(strstr(error.text, k[i].found) != NULL, "%s", error.text);
        else
            ck_assert_str_eq(path.text.item[path.text.n - 1], k[i].kept);
        path_free(&path);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("path_tool");
    TCase *tests = tcase_create("words");
    tcase_add_loop_test(tests, tools_and_offsets, 0, (int)(sizeof loads / sizeof *loads));
    tcase_add_loop_test(tests, feeds_in_all_units, 0, sizeof feeds / sizeof *feeds);
    tcase_add_loop_test(tests, speeds_in_all_words, 0, sizeof speeds / sizeof *speeds);
    tcase_add_loop_test(tests, speeds_that_follow, 0, sizeof later / sizeof *later);
    tcase_add_test(tests, delays);
    tcase_add_loop_test(tests, home_and_clear, 0, sizeof homes / sizeof *homes);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
