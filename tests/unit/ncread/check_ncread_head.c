/* ncread_head: what the comments at the head of a program say, each form of it; what is not
 * understood, and what stands behind the end of a line, says nothing. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ncread/ncread_head.h"
#include "scratch.h"

static struct ncread_head head;

static void setup(void)
{
    head = (struct ncread_head){.post = -1, .axis = -1};
}

static void line(const char *text)
{
    ncread_head_line(&head, text);
}

static const struct {
    const char *tool[3];
    double ball, flute; /* below zero: not given */
    const char *holder;
} tools[] = {
    {{"(TOOL: BALL R5 FLUTE 20 HOLDER 5:60)"}, 5, 20, "5:60"},
    {{"; TOOL: BALL R2.5"}, 2.5, -1, ""},
    {{"12 ; TOOL: BALL R3 FLUTE 0"}, 3, 0, ""},
    {{"(TOOL: CUTTER D10 R2)"}, 0, -1, ""},
    {{"(TOOL: BALL R4 CUTTER R5 FLUTE 9)"}, 4, -1, ""},
    /* goes on in the next line: behind a blank, or within the word */
    {{"(TOOL: BALL R5 FLUTE)", "(TOOL+: 20 HOLDER 5:60+)", "(TOOL+: 10:20)"}, 5, 20, "5:60+10:20"},
    {{"; TOOL: BALL R5", "; TOOL+: FLUTE 7"}, 5, 7, ""},
    /* another tool */
    {{"(TOOL: BALL R5 FLUTE 20 HOLDER 5:60)", "(TOOL: BALL R6)"}, 6, -1, ""},
    {{"TOOL: BALL R5"}, 0, -1, ""}, /* no comment */
    {{"(A TOOL: BALL R5)"}, 0, -1, ""},
    {{"(TOOL: R-5 ROUGH RX)"}, 0, -1, ""},
};

START_TEST(tool)
{
    for (int i = 0; i < 3 && tools[_i].tool[i]; i++)
        line(tools[_i].tool[i]);
    ck_assert_double_eq(head.ball, tools[_i].ball);
    ck_assert(head.flute_given == (tools[_i].flute >= 0));
    ck_assert_double_eq(head.flute, fmax(tools[_i].flute, 0));
    ck_assert_str_eq(head.holder, tools[_i].holder);
}
END_TEST

/* No more of a tool than there is room for, a line wholly or not at all. */
START_TEST(long_tool)
{
    char text[700] = "(TOOL+: ";
    memset(text + 8, '1', 600);
    strcpy(text + 608, ")");
    line("(TOOL: BALL R5 HOLDER 5:)");
    line(text);
    line(text); /* does not fit any more */
    ck_assert_uint_eq(strlen(head.holder), 602);
    ck_assert_double_eq(head.ball, 5);
    ck_assert_uint_lt(strlen(head.tool), sizeof head.tool);
}
END_TEST

START_TEST(words)
{
    line("(CONTROL: siemens)");
    line("; MACHINE:  head-ca  ");
    line("(SET: A.max=30 x)\r");
    line("(SCAN: 1681,3cad464a0113cb05,scan.xyz)");
    line("(FEED: CONTACT)");
    line("(CLOUDMILL NCPOST FOR FANUC, FORK HEAD C/A)");
    line("(TOLERANCE NCPOST 0.0011)");
    line("(TOLERANCE SUM 0.0112 MM, AXIS 0.0063 DEG)");
    line("(TOLERANCE CLOUD2MESH   0.0062)");
    ck_assert_double_eq(head.mesh, 0.0062);
    line("(SCALLOP: 0.02 TOLERANCE: 0.01)");
    ck_assert(!head.noise_given);
    line("(NOISE: 0.005)");
    ck_assert(head.noise_given);
    ck_assert_double_eq(head.noise, 0.005);
    line("; NOISE: 0");
    ck_assert(head.noise_given && head.noise == 0);
    for (int i = 0; i < 3; i++) {
        line((const char *const[]){"(NOISE: -1)", "(NOISE: little)", "(NOISE:)"}[i]);
        ck_assert(head.noise == 0 && (i == 2 || !head.noise_given));
    }
    line("(UNMET: MESHNORM: KEPT OFF BY THE SURFACE)");
    line("(UNMET+: UP TO 0.1 MM, WORST)");
    line("(UNMET+: AT 1.000 2.000 3.000)");
    line("(UNMET: BIARCFIT: ANOTHER)");
    line("(UNMET+: OF IT)");
    ck_assert_uint_eq(head.unmet, 2);
    ck_assert_str_eq(head.unmet_first, "MESHNORM: KEPT OFF BY THE SURFACE UP TO 0.1 MM, WORST AT "
                                       "1.000 2.000 3.000");
    ck_assert_str_eq(head.control_file, "siemens");
    ck_assert_str_eq(head.machine_file, "head-ca");
    ck_assert_str_eq(head.set, "A.max=30 x");
    ck_assert_uint_eq(head.scans, 1);
    ck_assert_double_eq(head.scan_points[0], 1681);
    for (int i = 0; i < NCREAD_SCANS; i++)
        line("(SCAN: 7,3cad464a0113cb05,more.xyz)");
    ck_assert_uint_eq(head.scans, NCREAD_SCANS);
    ck_assert_double_eq(head.scan_points[NCREAD_SCANS - 1], 7);
    ck_assert_uint_eq(head.scan_hash[NCREAD_SCANS - 1], 0x3cad464a0113cb05);
    ck_assert(head.contact_feed && head.numbered && !head.centre);
    line("; *** ATTENTION: X Y Z ARE THE CENTRE OF THE BALL, NOT THE TIP ***");
    ck_assert(head.centre);
    ck_assert_str_eq(head.machine, "FORK HEAD C/A");
    ck_assert_double_eq(head.post, 0.0011);
    ck_assert_double_eq(head.axis, 0.0063);
    ck_assert_double_eq(head.scallop, 0.02);
    ck_assert_double_eq(head.tolerance, 0.01);
    line("; TOLERANCE: 0.03");
    ck_assert_double_eq(head.tolerance, 0.03);
    ck_assert_double_eq(head.scallop, 0.02);
}
END_TEST

/* Of a program of ncpost alone, and whether it is that of all of it. */
START_TEST(the_way)
{
    line("; Cut 879.3 mm, rapid 206.7 mm, 1.2 min");
    line("; Part 1 of 3; figures below are those of the whole");
    ck_assert(head.rapid == 0 && !head.of_whole);
    line("(CLOUDMILL NCPOST FOR FANUC, TABLE-TABLE A/C)");
    line("(CUT 879.3 MM, RAPID 206.7 MM, 1.2 MIN)");
    ck_assert_double_eq(head.rapid, 206.7);
    ck_assert(!head.of_whole);
    line(_i == 0 ? "(PART 1 OF 3; FIGURES BELOW ARE THOSE OF THE WHOLE)"
                 : "5 ; From pass 3 on; figures below are those of the whole");
    ck_assert(head.of_whole);
    line("; Cut 879.3 mm, turn 206.7 mm");
    ck_assert_double_eq(head.rapid, 0);
}
END_TEST

/* In more than one line, too; what is no region, or too long for one, is none. */
START_TEST(the_region)
{
    static const char *const bad[] = {"(REGION: )",
                                      "(REGION: BORDER 1)",
                                      "(REGION: BORDER x BOX 0 0 0 1 1 1)",
                                      "(REGION: BORDER 1 BOX 0 0 0 1 1)",
                                      "(REGION: BORDER 1 BOX 0 0 0 1 1 1 BALL 3)",
                                      "(REGION: BORDER 1 POLYGON 0 0 1)",
                                      "(REGION: BOX 0 0 0 1 1 inf)"};
    struct region region = {.border = 0};
    ck_assert(!ncread_head_region(&head, &region));
    line("(REGION: BORDER 0.75 BOX 0 -5 -5.5 40 30)");
    line("; REGION+: 10 POLYGON 0 0 10 0");
    line("14 ; REGION+: 10 10 POLYGON 1 1 2 1 1 2");
    ck_assert(ncread_head_region(&head, &region));
    ck_assert_double_eq(region.border, 0.75);
    ck_assert_double_eq(region.box.low.z, -5.5);
    ck_assert_double_eq(region.box.high.z, 10);
    ck_assert_uint_eq(region.polygons.from.n, 2);
    ck_assert_uint_eq(region.polygons.corner.n, 6);
    ck_assert_double_eq(region.polygons.corner.item[2].y, 10);
    region_polygons_free(&region.polygons);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        line(bad[i]);
        region = (struct region){.border = 0};
        ck_assert_msg(!ncread_head_region(&head, &region), "%s", bad[i]);
        ck_assert(!region_given(&region));
    }
    line("(REGION: BORDER 0.75 BOX 0 -5 -5.5 40 30 7 POLYGON 1 1 2 1 1 2)");
    for (size_t i = 0; i < NCREAD_HEAD_REGION / 9; i++)
        line("(REGION+: 10.5 10.5)");
    ck_assert(!ncread_head_region(&head, &region));
}
END_TEST

START_TEST(what_is_not_said)
{
    static const char *const text[] = {"",
                                       "(",
                                       ";",
                                       "G1 X3",
                                       "(FEED: TIP)",
                                       "CONTROL: siemens",
                                       "(SCALLOP)",
                                       "(CLOUDMILL)",
                                       "(Tolerance)",
                                       "(Tolerance sum 0.01 mm)"};
    struct ncread_head empty = head;
    for (size_t i = 0; i < sizeof text / sizeof *text; i++)
        line(text[i]);
    ck_assert_mem_eq(&head, &empty, sizeof head);
    /* what was in the line before, behind the end of this one */
    line("(Tolerance sum 1,\0axis 7 deg)");
    line("(Tolerance sum 1, \0axis 7 deg)");
    ck_assert_double_eq(head.axis, -1);
    line("; Cloudmill ncpost");
    ck_assert(head.numbered);
    ck_assert_str_eq(head.machine, "");
}
END_TEST

/* Rows of the placing: each on its own, what is no number or not finite says nothing. */
START_TEST(place)
{
    line("(PLACE2: 0 2 0 -5.5)");
    ck_assert_int_eq(head.place_rows, 2);
    ck_assert_double_eq(head.place.m[0][0], 1); /* the others as they are without */
    ck_assert_double_eq(head.place.m[1][1], 2);
    ck_assert_double_eq(head.place.m[1][3], -5.5);
    line("(PLACE1: 1 0 0)");
    line("(PLACE3: 1 0 1e999 3)");
    ck_assert_int_eq(head.place_rows, 2);
    line("(PLACE3: 0 0 1 3)");
    line("(PLACE1: 1 0 0 5)");
    ck_assert_int_eq(head.place_rows, 7);
    ck_assert_double_eq(head.place.m[0][3], 5);
    ck_assert_double_eq(head.place.m[2][3], 3);
}
END_TEST

/* Of a file its first thousand lines. */
START_TEST(of_a_file)
{
    struct error error;
    char *text = calloc(1, 20000);
    for (int more = 0; more < 2; more++) {
        *text = '\0';
        for (int i = 0; i < 999 + more; i++)
            strcat(text, "(NOTE)\n");
        strcat(text, "(TOOL: BALL R5)\n");
        setup();
        ck_assert_int_eq(ncread_head_of(scratch_text(text), &head, &error), 0);
        ck_assert_double_eq(head.ball, more ? 0 : 5);
    }
    free(text);
    ck_assert_int_eq(ncread_head_of("no/such/file", &head, &error), -1);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("ncread_head");
    TCase *tests = tcase_create("ncread_head");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, setup, NULL);
    tcase_add_loop_test(tests, tool, 0, (int)(sizeof tools / sizeof *tools));
    tcase_add_test(tests, long_tool);
    tcase_add_test(tests, words);
    tcase_add_loop_test(tests, the_way, 0, 2);
    tcase_add_test(tests, the_region);
    tcase_add_test(tests, what_is_not_said);
    tcase_add_test(tests, place);
    tcase_add_test(tests, of_a_file);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
