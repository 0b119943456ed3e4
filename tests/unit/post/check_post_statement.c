/* post_statement: what a path says between its motions, as the blocks that it becomes, by hand. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "blocks.h"
#include "post/post_statement.h"
#include "scratch.h"

static struct path path;
static struct out *out;

/* To a file that wrote() reads. */
static void begin(void)
{
    out = out_open(scratch_name());
    nc_writer_begin(&p.w, out, p.w.style, 0, 99999);
}

static void setup(void)
{
    blocks_begin((struct nc_ability){.mode = INTERPOLATE_ROTARY});
    path = (struct path){.name = "p.cl"};
    p.path = &path;
    begin();
}

static void teardown(void)
{
    array_free(&plan.move);
    array_free(&path.tool);
    for (size_t i = 0; i < path.text.n; i++)
        free(path.text.item[i]);
    array_free(&path.text);
}

/* The blocks since the last call. */
static const char *wrote(void)
{
    static char text[4000];
    size_t n;
    nc_writer_divert(&p.w, NULL);
    out_close(out);
    char *all = scratch_read(&n);
    snprintf(text, sizeof text, "%s", all);
    free(all);
    out = out_open(scratch_name());
    nc_writer_divert(&p.w, out);
    return text;
}

static void says(const char *statement, const char *blocks)
{
    ck_assert_double_eq(nc_statement(&p, statement), 0);
    ck_assert_str_eq(wrote(), blocks);
}

START_TEST(spindle_and_coolant)
{
    says("SPINDL/RPM,400,CLW", "S400 M3\n");
    says("SPINDL/400", ""); /* as it is */
    says("spindl/400,cclw", "S400 M4\n");
    says("SPINDL/900.5,CCLW", "S901 M4\n");
    ck_assert_double_eq(p.tooling.spindle, 900.5);
    ck_assert(p.tooling.ccw);
    nc_spindle(&p);
    nc_spindle_on(&p);
    ck_assert_str_eq(wrote(), "S901 M4\nM4\n");
    says("SPINDL/OFF", "M5\n");
    says("SPINDL/OFF", "");
    nc_spindle(&p); /* it is to stand */
    ck_assert_str_eq(wrote(), "");
    says("COOLNT/ON", "M8\n");
    says("COOLNT/ON", "");
    says("COOLNT/MIST", "M7\n");
    nc_coolant(&p);
    ck_assert_str_eq(wrote(), "M7\n");
    says("COOLNT/THRU", "(*** COOLNT/THRU: the machine file has no word for it ***)\n");
    says("COOLNT/AIR", "(*** COOLNT/AIR: the machine file has no word for it ***)\n");
    says("COOLNT/OFF", "M9\n");
    nc_coolant(&p);
    ck_assert_str_eq(wrote(), "");
    says("COOLNTS/ON", "");
    says("SPINDLE/1", "");
}
END_TEST

/* A machine with words of its own. */
START_TEST(own_words)
{
    strcpy(machine.blocks.spindle_cw, "M103");
    strcpy(machine.blocks.spindle_ccw, "M104");
    strcpy(machine.blocks.spindle_off, "M105 | | M106 |M107");
    strcpy(machine.blocks.coolant_thru, "M88");
    strcpy(machine.blocks.coolant_off, "none");
    strcpy(machine.blocks.stop, "M100");
    strcpy(machine.blocks.stop_optional, "M101");
    machine.aux[0].number = 12;
    strcpy(machine.aux[0].blocks, "M112 | G4 P1");
    says("SPINDL/400", "S400 M103\n");
    says("SPINDL/400,CCLW", "S400 M104\n");
    says("SPINDL/OFF", "M105\nM106\nM107\n");
    says("COOLNT/THRU", "M88\n");
    says("COOLNT/OFF", "");
    nc_coolant_off(&p);
    says("STOP", "M100\n");
    says("OPSTOP", "M101\n");
    says("AUXFUN/12", "M112\nG4 P1\n");
    says("AUXFUN/13", "M13\n");
}
END_TEST

START_TEST(others)
{
    says("STOP", "M0\n");
    says("stop", "M0\n");
    says("STOPS", "");
    says("OPSTOP", "M1\n");
    says("AUXFUN/0", "M0\n");
    says("AUXFUN/9999", "M9999\n");
    says("AUXFUN/10000", "");
    says("AUXFUN/-1", "");
    says("AUXFUN/1.5", "");
    ck_assert_double_eq(nc_statement(&p, "DELAY/2.5"), 2.5);
    ck_assert_double_eq(nc_statement(&p, "DELAY/0"), 0);
    says("DELAY/REV,3", "");
    says("PPRINT/ a part", "(a part)\n");
    says("REMARK", "()\n");
    /* in pieces of 70, at a blank, or without one as they come */
    says("PPRINT/aaaaaaaaa bbbbbbbbb ccccccccc ddddddddd eeeeeeeee fffffffff ggggggggg hhhhhhhhh",
         "(aaaaaaaaa bbbbbbbbb ccccccccc ddddddddd eeeeeeeee fffffffff ggggggggg)\n"
         "(hhhhhhhhh)\n");
    says("PPRINT/aaaaaaaaaabbbbbbbbbbccccccccccddddddddddeeeeeeeeeeffffffffffgggggggggghh",
         "(aaaaaaaaaabbbbbbbbbbccccccccccddddddddddeeeeeeeeeeffffffffffgggggggggg)\n(hh)\n");
    machine.block_skip = true;
    nc_statement(&p, "OPSKIP/ON");
    says("STOP", "/M0\n");
    nc_statement(&p, "OPSKIP/OFF");
    says("STOP", "M0\n");
}
END_TEST

/* A block that is taken as it stands: nothing is known of what is modal after it. */
START_TEST(inserted)
{
    p.w.known[NC_X] = p.w.known[NC_F] = true;
    p.w.motion = "G1";
    p.w.step = 10;
    says("INSERT/G4 X1", "N10 G4 X1\n");
    ck_assert(!p.w.known[NC_X] && !p.w.known[NC_F]);
    ck_assert_ptr_null(p.w.motion);
    says("INSERT N7 G4 X1", "N7 G4 X1\n");
    says("INSERT", "");
    p.w.known[NC_X] = true;
    p.asked.insert = POST_INSERT_COMMENT;
    says("INSERT/G4 X1", "(G4 X1)\n");
    ck_assert(p.w.known[NC_X]);
}
END_TEST

static void add_text(const char *text)
{
    *array_push(&path.text) = strdup(text);
    *array_push(&plan.move) = (struct nc_move){.kind = NC_TEXT, .index = (unsigned)path.text.n - 1};
}

static void add_tool(int number, int offset)
{
    *array_push(&path.tool) = (struct path_tool){.number = number, .offset = offset};
    *array_push(&plan.move) = (struct nc_move){.kind = NC_TOOL, .index = (unsigned)path.tool.n - 1};
}

static void add_move(enum nc_kind kind)
{
    *array_push(&plan.move) = (struct nc_move){.kind = kind};
}

/* What is said up to a tool's first motion holds at its start. */
START_TEST(tools)
{
    path.head.tool = 4;
    path.head.spindle = 500;
    add_text("COOLNT/ON");
    add_move(NC_PASS);
    add_move(NC_RAPID);
    add_text("SPINDL/700");
    add_tool(6, 16);
    add_text("SPINDL/800,CCLW");
    add_text("COOLNT/OFF");
    add_move(NC_LINE);
    add_text("SPINDL/900");
    nc_tool_first(&p);
    ck_assert(p.tooling.number == 4 && p.tooling.offset == 4 && p.tooling.next == 0);
    ck_assert(p.tooling.spindle == 500 && p.tooling.coolant == COOLANT_ON);
    ck_assert(nc_tool_stays(&p, &plan.move.item[0]));
    ck_assert(!nc_tool_stays(&p, &plan.move.item[3]));
    ck_assert(nc_tool_stays(&p, &plan.move.item[5]));
    ck_assert(nc_tool_stays(&p, &plan.move.item[8]));
    nc_tool_change(&p, &plan.move.item[4]);
    ck_assert(p.tooling.number == 6 && p.tooling.offset == 16 && p.tooling.next == 4);
    ck_assert(p.tooling.spindle == 800 && p.tooling.ccw && p.tooling.coolant == COOLANT_OFF);
    path.head.tool = path.head.offset = 0; /* none: the length of the first */
    nc_tool_first(&p);
    ck_assert(p.tooling.number == 0 && p.tooling.offset == 1);
    path.head.offset = 3;
    nc_tool_first(&p);
    ck_assert_int_eq(p.tooling.offset, 3);
}
END_TEST

START_TEST(missing)
{
    struct nc_missing m = nc_missing(&p);
    ck_assert(!m.tool && !m.spindle && !m.coolant);
    add_move(NC_RAPID); /* the spindle may stand, but there is no tool */
    m = nc_missing(&p);
    ck_assert(m.tool && !m.spindle && !m.coolant);
    add_move(NC_LINE);
    m = nc_missing(&p);
    ck_assert(m.tool && m.spindle);
    p.asked.no_spindle = true;
    m = nc_missing(&p);
    ck_assert(!m.tool && !m.spindle);
    p.asked.no_spindle = false;
    path.head.tool = 1;
    path.head.spindle = 100;
    m = nc_missing(&p);
    ck_assert(!m.tool && !m.spindle && !m.coolant);
    add_tool(0, 0);
    add_text("COOLNT/THRU");
    m = nc_missing(&p);
    ck_assert(!m.tool && m.coolant); /* it moves no more */
    add_move(NC_ARC);
    ck_assert(nc_missing(&p).tool);
    strcpy(machine.blocks.coolant_thru, "M88");
    ck_assert(!nc_missing(&p).coolant);
}
END_TEST

START_TEST(warnings)
{
    const struct nc_move rapid = {.kind = NC_RAPID}, text = {.kind = NC_TEXT},
                         line = {.kind = NC_LINE};
    nc_warn_standing(&p, &rapid);
    nc_warn_standing(&p, &text);
    p.tooling.spindle = 1;
    nc_warn_standing(&p, &line);
    p.tooling.spindle = 0;
    p.asked.no_spindle = true;
    nc_warn_standing(&p, &line);
    nc_warn_no_tool(&p);
    ck_assert_str_eq(wrote(), "");
    p.asked.no_spindle = false;
    nc_warn_standing(&p, &line);
    nc_warn_standing(&p, &line); /* once */
    ck_assert_str_eq(wrote(), "(*** NO SPEED OF THE SPINDLE: IT MAY STAND STILL HERE ***)\n");
    nc_warn_no_tool(&p);
    ck_assert_str_eq(wrote(), "(*** NO TOOL IN THE PATH: THE ONE IN THE SPINDLE IS TAKEN ***)\n");
    p.tooling.number = 1;
    nc_warn_no_tool(&p);
    ck_assert_str_eq(wrote(), "");
}
END_TEST

/* On a machine that has it: with the next straight move in X or Y, a cut to begin it. */
START_TEST(compensation)
{
    static const char *const word[] = {"off", "left", "right"};
    struct nc_move up = {.kind = NC_LINE, .p = {1, 2, 9}}, side = {.kind = NC_LINE, .p = {1, 3, 9}},
                   rapid = {.kind = NC_RAPID, .p = {0, 2, 9}};
    nc_modal(&p.w, NC_X, "X", 1, 3);
    nc_modal(&p.w, NC_Y, "Y", 2, 3);
    nc_end(&p.w);
    says("CUTCOM/LEFT", "X1. Y2.\n");
    ck_assert_ptr_null(nc_cutcom_word(&p, &side, word)); /* the machine has no key for it */
    machine.cutcom = true;
    says("CUTCOM/LEFT,XYPLAN", "");
    ck_assert_ptr_null(nc_cutcom_word(&p, &up, word));
    ck_assert_ptr_null(nc_cutcom_word(&p, &rapid, word));
    ck_assert_str_eq(nc_cutcom_word(&p, &side, word), "left");
    ck_assert_ptr_null(nc_cutcom_word(&p, &side, word));
    says("CUTCOM/RIGHT", "");
    ck_assert_str_eq(nc_cutcom_word(&p, &side, word), "right");
    says("CUTCOM/OFF", "");
    ck_assert_str_eq(nc_cutcom_word(&p, &rapid, word), "off");
    ck_assert(!nc_cutcom_end(&p));
    says("CUTCOM/LEFT", "");
    nc_cutcom_word(&p, &side, word);
    ck_assert(nc_cutcom_end(&p));
    ck_assert(!nc_cutcom_end(&p));
    /* what a path asks for */
    ck_assert(!nc_cutcom_asked(&path));
    add_text("CUTCOM/OFF");
    add_text("CUTCOM/ADJUST");
    ck_assert(!nc_cutcom_asked(&path));
    add_text("CUTCOM/ON,RIGHT");
    ck_assert(nc_cutcom_asked(&path));
    ck_assert(!nc_cutcom_left_out(&path, &machine, &plan.ability));
    plan.ability.feeds = NC_FEEDS_INVERSE;
    ck_assert(nc_cutcom_left_out(&path, &machine, &plan.ability));
    plan.ability.feeds = NC_FEEDS_TIP;
    machine.chain.n = 2;
    plan.ability.tcp = true;
    ck_assert(nc_cutcom_left_out(&path, &machine, &plan.ability));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_statement");
    TCase *tests = tcase_create("post_statement");
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, spindle_and_coolant);
    tcase_add_test(tests, own_words);
    tcase_add_test(tests, others);
    tcase_add_test(tests, inserted);
    tcase_add_test(tests, tools);
    tcase_add_test(tests, missing);
    tcase_add_test(tests, warnings);
    tcase_add_test(tests, compensation);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
