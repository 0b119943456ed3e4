/*
 * ncread_home, and the step of block numbers: a move at rapid that nothing follows is remarked, or
 * is a blind one for the judge, by what was said of Z before it.
 */
#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "reading.h"

static struct ncread_head head;

/* A table A C, tool centre point control off, block numbers by tens. */
static void begin(bool ours)
{
    reading_begin();
    head = (struct ncread_head){.numbered = ours};
    options.head = &head;
    options.tcp = true;
    options.kinematics = verify_kinematics_trunnion('A', 1);
    c.unit = 25.4;
}

/* A block of G code that goes to `at` at rapid, all of it known, `tracked` or not. */
static void go(const char *text, double z, bool tracked)
{
    struct ncread_place to = {.known = {true, true, true}, .at = {1, 2, z}};
    c.line++;
    c.block = 10 * (long)c.line;
    ck_assert_int_eq(ncread_word_fanuc(text, &c.words, &error), 0);
    ncread_home_words(&c);
    if (!strstr(text, "G28") && !strstr(text, "G53"))
        ncread_home_go(&c, &to, true, tracked);
    c.here = to;
    if (!tracked)
        memset(c.here.known, 0, sizeof c.here.known);
}

/* The tool has gone to Z of here, by a piece. */
static void cut(double z)
{
    *array_push(&motion.piece) = (struct nc_piece){0};
    c.here = (struct ncread_place){.known = {true, true, true}, .at = {1, 2, z}};
}

enum { NOTHING, EARLY, STRAY, BARE, BLIND };
static const struct {
    bool ours, pieces, tracked;
    const char *before, *block;
    double z;
    int found;
} move[] = {
    /* at the start */
    {true, false, false, "", "G0 A0.", 0, EARLY},
    {true, false, true, "", "G0 X1.", 0, EARLY},
    {true, false, true, "", "G0 X1. Z5.", 0, NOTHING},
    {true, false, true, "G28 Z0.", "G0 X1.", 0, NOTHING},
    {false, false, true, "G28", "G0 X1.", 0, NOTHING},
    {true, false, true, "G28", "G0 X1.", 0, BARE},
    {true, false, true, "G53 Z0.", "G0 X1.", 0, NOTHING},
    {true, false, true, "G53 X0.", "M5", 0, EARLY},
    {true, false, true, "T1 M6", "G0 X1.", 0, EARLY},
    {false, false, true, "T1 M6", "G0 X1.", 0, NOTHING},
    {true, false, false, "", "G0 Z0.", 0, BLIND},
    {false, false, false, "T1 M6", "G0 Z0.", 0, BLIND},
    {false, false, false, "G28 Z0.", "G0 X1. Z0.", 0, BLIND},
    /* after a cut at 5 */
    {true, true, false, "", "G0 X1.", 5, STRAY},
    {true, true, false, "", "G0 Z5.", 5, STRAY},
    {true, true, false, "", "G0 Z4.", 4, STRAY},
    {true, true, false, "", "G0 X1. Z6.", 6, STRAY},
    {true, true, false, "", "G0 A0. Z6.", 6, STRAY},
    {true, true, false, "", "G0 Z6.", 6, BLIND},
    {true, true, false, "G28 Z0.", "G0 X1.", 5, NOTHING},
    {true, true, false, "G28 Z0.", "G0 A0.", 5, NOTHING},
    {true, true, false, "G28 Z0.", "G0 X1. Z4.", 4, STRAY},
    {true, true, false, "", "G0 A0.", 5, EARLY},
    {false, true, false, "", "G0 A0.", 5, BLIND},
    {false, true, false, "", "G0 X1.", 5, STRAY},
    {true, true, true, "", "G0 X1.", 5, NOTHING},
    {true, true, true, "", "G0 A1.", 5, NOTHING},
    {true, true, true, "", "G28 X0. Y0.", 5, EARLY},
    {false, true, true, "", "G28 X0. Y0.", 5, BLIND},
    {true, true, true, "", "G28 X0. Z0.", 5, BLIND},
    {false, true, true, "", "G28", 5, BLIND},
    {false, true, true, "", "G53 A0.", 5, BLIND},
    {false, true, true, "G28 Z0.", "G28 X0. Y0.", 5, NOTHING},
    {false, true, true, "", "G28 Z0.", 5, NOTHING},
};

START_TEST(moves)
{
    static const char *const text[] = {NULL, "X, Y or a rotary axis goes at rapid before Z",
                                       "a rapid move to a place of the work without tool",
                                       "goes home without an axis"};
    begin(move[_i].ours);
    if (move[_i].pieces)
        cut(5);
    if (*move[_i].before)
        go(move[_i].before, 5, true);
    if (!move[_i].pieces)
        c.here = (struct ncread_place){0};
    go(move[_i].block, move[_i].z, move[_i].tracked);
    int found = move[_i].found, remark = found > NOTHING && found < BLIND;
    ck_assert_uint_eq(motion.remark.n, (size_t)remark);
    ck_assert_uint_eq(motion.blind.n, (size_t)(found == BLIND));
    if (remark) {
        ck_assert_ptr_nonnull(strstr(motion.remark.item[0].text, text[found]));
        ck_assert(!motion.remark.item[0].notice);
    }
    reading_end();
}
END_TEST

/* In mm, of the block and the piece that it stands behind. */
START_TEST(blind)
{
    begin(false);
    go("G0 Z2.", 2, false);
    cut(5);
    go("G28 X0.", 5, true);
    ck_assert_uint_eq(motion.blind.n, 2);
    const struct nc_blind *b = motion.blind.item;
    ck_assert(b[0].z_said && !b[1].z_said);
    ck_assert_double_eq_tol(b[0].z, 50.8, 1e-9);
    ck_assert_uint_eq(b[0].pieces, 0);
    ck_assert_uint_eq(b[1].pieces, 1);
    ck_assert_int_eq(b[1].block, 20);
    ck_assert_uint_eq(b[1].line, 2);
    reading_end();
}
END_TEST

/* Up, so that the table may turn, but not X and Y go; a place of the work ends that. */
START_TEST(raised)
{
    begin(false);
    cut(5);
    go("G0 Z60.", 60, false);
    go("G0 A0.", 60, false);
    ck_assert_uint_eq(motion.remark.n, 0);
    ck_assert_uint_eq(motion.blind.n, 1);
    go("G0 X1.", 60, false);
    ck_assert_uint_eq(motion.remark.n, 1);
    go("G0 X1.", 60, false); /* told once */
    ck_assert_uint_eq(motion.remark.n, 1);
    go("G0 Z5.", 5, true);
    go("G0 A0.", 5, false);
    ck_assert_uint_eq(motion.blind.n, 2);
    reading_end();
}
END_TEST

/* Others than ncpost begin without a word of Z: told, and no fault. */
START_TEST(notice)
{
    begin(false);
    go("G0 X1.", 5, true);
    ck_assert_uint_eq(motion.remark.n, 1);
    ck_assert(motion.remark.item[0].notice);
    reading_end();
}
END_TEST

static const struct {
    const char *block[7];
    bool machine;
} text[] = {
    {{"L", "X+0", "M91"}, true},         {{"L", "IX+0", "M91"}, true},
    {{"L", "C+0", "FMAX", "M91"}, true}, {{"L", "Z+0", "M91"}, false},
    {{"L", "X+0", "FMAX"}, false},       {{"FN", "X+0", "M91"}, false},
};

START_TEST(klartext)
{
    int n = 0;
    begin(false);
    cut(5);
    while (text[_i].block[n])
        n++;
    ncread_home_text(&c, n, text[_i].block);
    ck_assert_uint_eq(motion.blind.n, text[_i].machine);
    reading_end();
}
END_TEST

/* Numbers of blocks, 0: no more; the first one before which a block is missing. */
static const struct {
    int number[6], missing;
} step[] = {
    {{10, 20, 30, 40}, 0},  {{5, 10, 15}, 0},       {{10, 20, 40}, 40}, {{10, 30, 40}, 30},
    {{20, 30, 40, 60}, 60}, {{10, 40, 60, 70}, 40}, {{10, 15, 20}, 0},  {{100, 110, 130}, 130},
};

START_TEST(steps)
{
    begin(true);
    c.last_block = -1;
    for (int i = 0; step[_i].number[i]; i++)
        ck_assert_int_eq(ncread_block(&c, step[_i].number[i], &error), 0);
    ck_assert((motion.remark.n > 0) == (step[_i].missing > 0));
    if (step[_i].missing)
        ck_assert_int_eq(motion.remark.item[0].block, step[_i].missing);
    reading_end();
}
END_TEST

#define ROWS(a) (int)(sizeof(a) / sizeof *(a))

int main(void)
{
    Suite *suite = suite_create("ncread_home");
    TCase *home = tcase_create("home");
    tcase_add_loop_test(home, moves, 0, ROWS(move));
    tcase_add_test(home, blind);
    tcase_add_test(home, raised);
    tcase_add_test(home, notice);
    tcase_add_loop_test(home, klartext, 0, ROWS(text));
    tcase_add_loop_test(home, steps, 0, ROWS(step));
    suite_add_tcase(suite, home);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
