/*
 * ncread_watch, ncread_tool: what changes amid a program is remarked once a cut follows, by its
 * block, and only what changes; which tool is held, whose length is on, and what that makes of a
 * piece.
 */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "ncread/ncread_tool.h"
#include "ncread/ncread_watch.h"
#include "reading.h"

static struct machine_tool tools[] = {{1, 100, "BALL 5"}, {2, 80, "MILL"}, {3, NAN, "BLUNT"}};

/* A block of G code or of Siemens, of Klartext where it has a blank's word `TOOL` or the like. */
static void block(const char *text)
{
    c.text = text;
    c.line++;
    c.block = 10 * (long)c.line;
    if (options.dialect == &ncread_heidenhain) {
        char copy[200], *s = copy;
        const char *word[20];
        int n = 0;
        strcpy(copy, text);
        for (s = strtok(copy, " "); s; s = strtok(NULL, " "))
            word[n++] = s;
        ncread_watch_text(&c, n, word);
        ncread_tool_text(&c, n, word);
        return;
    }
    ck_assert_int_eq(options.dialect == &ncread_siemens
                         ? ncread_word_siemens(text, &c.words, &error)
                         : ncread_word_fanuc(text, &c.words, &error),
                     0);
    ncread_watch_words(&c);
    ncread_tool_words(&c);
}

enum { F, S, H };
static const struct ncread_dialect *dialect(int which)
{
    return which == F ? &ncread_fanuc : which == S ? &ncread_siemens : &ncread_heidenhain;
}

static const struct {
    int dialect;
    const char *before, *after, *found; /* NULL: nothing */
} change[] = {
    {F, "T1", "T2", "the tool changes from 1 to 2 amid"},
    {F, "T1", "T1", NULL},
    {F, "G0 X1.", "T2", "the tool becomes 2 amid"},
    {F, "H1", "H2", "the tool's offset H changes from 1 to 2"},
    {F, "G43 H1", "G43 H1", NULL},
    {F, "D1", "D2", "the tool's offset D changes from 1 to 2"},
    {F, "D1", "G41 D2", NULL},
    {F, "D1", "G42. D2", NULL},
    {F, "D1", "G43 D2", "the tool's offset D changes from 1 to 2"},
    {F, "G54", "G55", "the work offset changes from 54 to 55"},
    {F, "G54.1 P1", "G54.1 P2", "the work offset changes from 55.1 to 56.1"},
    {F, "G54", "G54 P2", "the work offset changes from 54 to 56.1"},
    {F, "G54.1 P2", "G54 P2", NULL},
    {F, "G54", "G54 G4 P2", NULL},
    {F, "G54", "G59.9", "the work offset changes"},
    {F, "G54", "G60", NULL},
    {F, "G500", "G599", "the work offset changes from 500 to 599"},
    {F, "G54", "G600", NULL},
    {F, "M8", "M9", "the coolant goes off"},
    {F, "M13", "M9", "the coolant goes off"},
    {F, "M9", "M7", NULL},
    {F, "M8", "M14", NULL},
    {F, "M8", "M10", NULL},
    {F, "M3", "M4", "the spindle turns the other way amid"},
    {F, "M13", "M3", NULL},
    {F, "S900", "S50", "the spindle's speed changes from 900 to 50 amid"},
    {F, "G0 X1.", "S50", "the spindle's speed becomes 50 amid"},
    {F, "S900", "S900", NULL},
    {F, "T1 S900 M3", "T2 S50 M4", "the tool changes from 1 to 2"},
    {S, "S900", "G4 S30", NULL},
    {S, "T=\"BALL 5\"", "T=\"MILL\"", "the tool changes amid"},
    {S, "T=\"BALL 5\"", "T=\"BALL 5\"", NULL},
    {S, "T1", "T=\"BALL 5\"", "the tool changes amid"},
    {S, "T=\"BALL 5\"", "T1", "the tool changes amid"},
    {S, "D1", "D0", "the tool's offset D changes from 1 to 0"},
    {H, "TOOL CALL 1 Z S900", "TOOL CALL 2 Z S900", "the tool changes from 1 to 2"},
    {H, "TOOL CALL \"MILL\" Z", "TOOL CALL \"BLUNT\" Z", "the tool changes amid"},
    {H, "TOOL CALL \"MILL\" Z", "TOOL CALL \"MILL\" Z", NULL},
    {H, "TOOL CALL 1 Z S900", "TOOL CALL Z S1000", NULL},
    {H, "TOOL CALL 1 Z S900", "TOOL CALL S1000", NULL},
    {H, "CYCL DEF 247 Q339=1", "CYCL DEF 247 Q339=2", "the work offset changes"},
    {H, "L X+1", "CYCL DEF 7.0 DATUM", "the work offset becomes"},
    {H, "L X+1", "CYCL DEF 200 DRILLING", NULL},
    {H, "L X+1", "TRANS DATUM AXIS X+3", "the work offset becomes"},
    {H, "L X+1 M8", "L X+2 M9", "the coolant goes off"},
};

START_TEST(changes)
{
    options.dialect = dialect(change[_i].dialect);
    block(options.dialect->offsets ? "G54" : "L X+0");
    block(change[_i].before);
    ncread_watch_cut(&c);
    ncread_watch_cut(&c);
    ck_assert_uint_eq(motion.remark.n, 0);
    block(change[_i].after);
    long at = c.block;
    ck_assert_uint_eq(motion.remark.n, 0); /* none before a cut */
    block("M1");
    ncread_watch_cut(&c);
    ck_assert_uint_eq(motion.remark.n, change[_i].found != NULL);
    if (change[_i].found) {
        const char *text = motion.remark.item[0].text;
        ck_assert_msg(strstr(text, change[_i].found) != NULL, "%s", text);
        ck_assert_int_eq(motion.remark.item[0].block, at);
        ck_assert_uint_eq(motion.remark.item[0].line, c.line - 1);
    }
    ncread_watch_cut(&c); /* told once */
    ck_assert_uint_eq(motion.remark.n, change[_i].found != NULL);
    /* there and back before a cut: nothing has changed */
    if (strcmp(change[_i].before, "M8") != 0 && change[_i].dialect == F) {
        size_t told = motion.remark.n;
        block(change[_i].before);
        block(change[_i].after);
        ncread_watch_cut(&c);
        ck_assert_uint_eq(motion.remark.n, told);
    }
}
END_TEST

START_TEST(first_cut)
{
    static const char *const coolant[] = {"M7", "M8", "M13", "M14", "M9", "M10"};
    for (int i = 0; i < 6; i++) {
        reading_end();
        reading_begin();
        block(coolant[i]);
        ncread_watch_cut(&c);
        ck_assert(motion.coolant == (i < 4));
        ck_assert_int_eq(motion.turns, i == 2 ? 1 : i == 3 ? -1 : 0); /* M13 and M14 do both */
        ck_assert_uint_eq(motion.remark.n, 1);
        ck_assert_ptr_nonnull(strstr(motion.remark.item[0].text, "without a work offset"));
    }
}
END_TEST

/* Spindle, tool and length that the first cut is made with; what comes later is not. */
START_TEST(first_tool)
{
    block("T4 M6");
    block("S900 M4");
    block("G43 H7 G54");
    ncread_watch_cut(&c);
    block("T5 S800 M3 H8");
    ncread_watch_cut(&c);
    ck_assert_int_eq(motion.turns, -1);
    ck_assert_double_eq(motion.speed, 900);
    ck_assert_int_eq(motion.tool, 4);
    ck_assert_int_eq(motion.offset, 7);
    reading_end();
    reading_begin();
    options.dialect = &ncread_siemens;
    block("T=\"BALL 5\" G54");
    ncread_watch_cut(&c);
    ck_assert_int_eq(motion.tool, -1);
    ck_assert_double_eq(motion.speed, 0);
    reading_end();
    reading_begin();
    block("G54");
    ncread_watch_cut(&c);
    ck_assert_int_eq(motion.tool, 0);
}
END_TEST

/* What a cut's piece gets: the length of the tool that is held, and by how much the length that is
 * on is beyond it. */
static void made_with(double length, double beyond)
{
    struct nc_piece piece = {.rapid = false};
    ck_assert_int_eq(ncread_tool_piece(&c, &piece, &error), 0);
    ck_assert_double_eq(piece.length, length);
    ck_assert_double_eq(piece.beyond, beyond);
}

START_TEST(lengths)
{
    block("T1 M6");
    made_with(0, 0); /* the machine file says nothing of tools */
    options.tool = tools;
    options.tools = 3;
    made_with(100, -100); /* no length is on */
    c.here.known[0] = c.here.known[1] = c.here.known[2] = true;
    block("G43 H1");
    ck_assert(!c.here.known[0] && !c.here.known[2]);
    made_with(100, 0);
    c.here.known[0] = true;
    block("G43 H1"); /* no other */
    ck_assert(c.here.known[0]);
    block("G43.4 H2");
    made_with(100, -20);
    block("G43.5 H3"); /* whose length is not said */
    made_with(100, 0);
    block("G43 H77"); /* the shop's own */
    made_with(100, 0);
    block("G49");
    made_with(100, -100);
    block("G43");
    made_with(100, 0);
    block("T2"); /* only brought near, for M6 takes it */
    made_with(100, 0);
    block("M6");
    made_with(80, 20);
    block("T3 M6");
    made_with(0, 0);
}
END_TEST

/* Without M6 T takes the tool; Siemens has D1 on with it. */
START_TEST(other_tool_words)
{
    options.tool = tools;
    options.tools = 3;
    block("T2");
    made_with(80, -80);
    reading_end();
    reading_begin();
    options = (struct ncread_options){.dialect = &ncread_siemens, .tool = tools, .tools = 3};
    block("T=\"BALL 5\" D1 M6");
    ck_assert_int_eq(c.tool.held, 1);
    made_with(100, 0);
    block("D0");
    made_with(100, -100);
    block("D1");
    made_with(100, 0);
    block("T=\"MILL\"");
    made_with(100, 0);
    block("M6");
    made_with(80, 0);
    block("T=\"NONE\" M6");
    ck_assert_int_eq(c.tool.held, 0);
    reading_end();
    reading_begin();
    options = (struct ncread_options){.dialect = &ncread_heidenhain, .tool = tools, .tools = 3};
    block("TOOL CALL 2 Z S900");
    made_with(80, 0);
    block("TOOL CALL \"BALL 5\" Z S900");
    made_with(100, 0);
    block("TOOL CALL Z S1000"); /* the same with another speed */
    made_with(100, 0);
    block("TOOL CALL S1000");
    made_with(100, 0);
    block("TOOL DEF 2");
    made_with(100, 0);
}
END_TEST

/* A head without tool-centre-point control: a cut needs the length. */
START_TEST(length_missing)
{
    struct nc_piece piece = {.table = true};
    options = (struct ncread_options){.dialect = &ncread_fanuc, .tool = tools, .tools = 3};
    options.kinematics = verify_kinematics_trunnion('A', 1);
    block("T3 M6");
    ck_assert_int_eq(ncread_tool_piece(&c, &piece, &error), 0); /* all axes turn the table */
    options.kinematics.axis[0].table = false;
    ck_assert_int_eq(ncread_tool_piece(&c, &piece, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "cuts with tool 3, whose length"));
    piece.rapid = true;
    ck_assert_int_eq(ncread_tool_piece(&c, &piece, &error), 0);
    piece.rapid = piece.table = false;
    ck_assert_int_eq(ncread_tool_piece(&c, &piece, &error), 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("ncread_watch");
    TCase *tests = tcase_create("ncread_watch");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, reading_begin, reading_end);
    tcase_add_loop_test(tests, changes, 0, (int)(sizeof change / sizeof *change));
    tcase_add_test(tests, first_cut);
    tcase_add_test(tests, first_tool);
    tcase_add_test(tests, lengths);
    tcase_add_test(tests, other_tool_words);
    tcase_add_test(tests, length_missing);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
