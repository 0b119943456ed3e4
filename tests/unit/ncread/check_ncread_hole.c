/*
 * ncread_hole: drilling cycles of each control as moves: over the hole at rapid, down to the clear
 * height, at feed to the bottom, and out; their dwells by the makers' manuals, counted by hand.
 */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "ncread/ncread_hole.h"
#include "reading.h"

/* On a machine of three axes, spindle on, at 1 2 50. */
static void setup(void)
{
    reading_begin();
    c.line = 3;
    c.block = -1;
    c.plane = 17;
    c.unit = 1;
    c.absolute = c.said = c.spindle = c.length = true;
    c.speed = 400;
    c.feed = 300;
    c.here = (struct ncread_place){.known = {true, true, true}, .at = {1, 2, 50}, .has_axis = true};
}

/* The moves since the last call: where each ends and its feed, 0 at rapid. */
static size_t seen;

static void ends(size_t n, const double want[][4])
{
    ck_assert_uint_eq(motion.piece.n - seen, n);
    for (size_t i = 0; i < n; i++) {
        const struct nc_piece *p = &motion.piece.item[seen + i];
        ck_assert_double_lt(vec_distance(p->p[1], vec(want[i][0], want[i][1], want[i][2])), 1e-12);
        ck_assert(p->rapid == (want[i][3] == 0));
        if (!p->rapid)
            ck_assert_double_eq_tol(p->feed, want[i][3], 1e-12);
    }
    seen = motion.piece.n;
    ck_assert_double_eq(c.feed, 300); /* the one that is on stays */
}

/* A block of Fanuc's kind: its cycle word, then the hole. */
static int block(int code, const char *text, double x, double y)
{
    struct ncread_place to = c.here;
    ck_assert_int_eq(ncread_word_fanuc(text, &c.words, &error), 0);
    if (code >= 0)
        ck_assert(ncread_hole_code(&c, code));
    to.at[0] = x;
    to.at[1] = y;
    return ncread_hole_block(&c, &to, 0.001, &error);
}

/* G98: back to where the tool was before the first hole; G99: to R. */
START_TEST(levels)
{
    ck_assert(ncread_hole_code(&c, 980));
    ck_assert_int_eq(block(810, "Z-5. R3.", 10, 20), 0);
    ends(4,
         (const double[][4]){{10, 20, 50, 0}, {10, 20, 3, 0}, {10, 20, -5, 300}, {10, 20, 50, 0}});
    ck_assert_int_eq(block(-1, "", 12, 20), 0); /* the same for the next hole */
    ends(4,
         (const double[][4]){{12, 20, 50, 0}, {12, 20, 3, 0}, {12, 20, -5, 300}, {12, 20, 50, 0}});
    ck_assert(ncread_hole_code(&c, 990));
    ck_assert_int_eq(block(-1, "Z-6.", 12, 20), 0);
    ends(3, (const double[][4]){{12, 20, 3, 0}, {12, 20, -6, 300}, {12, 20, 3, 0}});
    ck_assert_int_eq(block(-1, "R4.", 13, 20), -1); /* the tool is at 3 */
    ck_assert_ptr_nonnull(strstr(error.text, "below its clear height"));
    ck_assert(ncread_hole_code(&c, 980)); /* up again to where the cycle began */
    ck_assert_int_eq(block(-1, "R3.", 14, 20), 0);
    ends(3, (const double[][4]){{14, 20, 3, 0}, {14, 20, -6, 300}, {14, 20, 50, 0}});
}
END_TEST

/* Which come out at feed, which wait for P. */
START_TEST(codes)
{
    static const struct {
        int code;
        bool slow, waits;
    } k[] = {{730, false, false}, {740, true, true},   {810, false, false},
             {820, false, true},  {830, false, false}, {840, true, true},
             {850, true, false},  {860, false, true},  {890, true, true}};
    for (size_t i = 0; i < sizeof k / sizeof *k; i++) {
        reading_end();
        setup();
        seen = 0;
        ck_assert_int_eq(block(k[i].code, "Z-1. R2. P1500", 1, 2), 0);
        ck_assert(c.hole.on);
        ck_assert_double_eq_tol(motion.dwell, k[i].waits ? 1.5 / 60 : 0, 1e-15);
        if (k[i].slow)
            ends(3, (const double[][4]){{1, 2, 2, 0}, {1, 2, -1, 300}, {1, 2, 2, 300}});
        else
            ends(3, (const double[][4]){{1, 2, 2, 0}, {1, 2, -1, 300}, {1, 2, 2, 0}});
        /* the next cycle knows no P of this one once it was off */
        ck_assert(ncread_hole_code(&c, 800));
        ck_assert(!c.hole.on);
        ck_assert_int_eq(block(k[i].code, "Z-1. R2.", 1, 2), 0);
        ck_assert_double_eq_tol(motion.dwell, k[i].waits ? 1.5 / 60 : 0, 1e-15);
    }
    for (int code = 0; code <= 40; code += 10) { /* G0 to G3 cancel it too, and are no cycle */
        c.hole.on = true;
        ck_assert(!ncread_hole_code(&c, code));
        ck_assert(c.hole.on == (code > 30));
    }
    ck_assert(!ncread_hole_code(&c, 760));
    ck_assert(!ncread_hole_code(&c, -10));
}
END_TEST

/* G91: R from where the cycle began, Z from R; LinuxCNC counts each anew from where the tool is. */
START_TEST(incremental)
{
    for (int linuxcnc = 0; linuxcnc < 2; linuxcnc++) {
        reading_end();
        setup();
        seen = 0;
        options.dialect = linuxcnc ? &ncread_linuxcnc : &ncread_fanuc;
        c.absolute = false;
        ck_assert_int_eq(block(810, "Z-8. R-10.", 10, 20), 0);
        ends(4, (const double[][4]){
                    {10, 20, 50, 0}, {10, 20, 40, 0}, {10, 20, 32, 300}, {10, 20, 40, 0}});
        ck_assert_int_eq(block(-1, "Z-9. R-10.", 10, 20), 0);
        double r = linuxcnc ? 30 : 40;
        if (linuxcnc)
            ends(3, (const double[][4]){{10, 20, r, 0}, {10, 20, r - 9, 300}, {10, 20, r, 0}});
        else
            ends(2, (const double[][4]){{10, 20, r - 9, 300}, {10, 20, r, 0}});
        c.absolute = true;
        ck_assert_int_eq(block(-1, "Z-9.", 10, 20), -1);
        ck_assert_ptr_nonnull(strstr(error.text, "without its Z and R after G90 or G91"));
    }
}
END_TEST

START_TEST(refused)
{
    static const char *const found[] = {"from a place that is not known",
                                        "outside G17",
                                        "before G90 or G91",
                                        "tool centre point",
                                        "heights are not in order",
                                        "heights are not in order",
                                        "below its clear height"};
    if (_i == 0)
        c.here.known[2] = false;
    if (_i == 1)
        c.plane = 18;
    if (_i == 2)
        c.said = false;
    if (_i == 3)
        c.tcp = true;
    const char *text = _i == 4   ? "Z3. R3."
                       : _i == 5 ? "Z-3. R51."
                       : _i == 6 ? "Z-3. R51."
                                 : "Z-3. R3.";
    if (_i == 6)
        ck_assert(ncread_hole_code(&c, 990));
    else
        ck_assert(ncread_hole_code(&c, 980));
    ck_assert_int_eq(block(810, text, 1, 2), -1);
    ck_assert_msg(strstr(error.text, found[_i]) != NULL, "%s", error.text);
    ck_assert_uint_eq(motion.piece.n, 0);
}
END_TEST

START_TEST(dwells)
{
    static const struct {
        const char *text;
        double seconds; /* below zero: it is none */
    } k[] = {{"G4 X1.5", 1.5}, {"G4 F2.", 2}, {"G4 P2500", 2.5}, {"G4 P2500 S3", 2.5},
             {"G1 X1.5", -1},  {"X4.", -1},   {"G4", 0}};
    for (size_t i = 0; i < sizeof k / sizeof *k; i++) {
        double before = motion.dwell;
        ck_assert_int_eq(ncread_word_fanuc(k[i].text, &c.words, &error), 0);
        ck_assert(ncread_hole_dwell(&c, 0.001) == (k[i].seconds >= 0));
        ck_assert_double_eq_tol(motion.dwell - before, fmax(k[i].seconds, 0) / 60, 1e-15);
    }
}
END_TEST

static const struct {
    const char *call, *name;
    double level, clear, bottom, down, out, dwell; /* out 0: at rapid */
} siemens[] = {
    {"MCALL CYCLE81(20,5,2,-8)", "CYCLE81", 20, 7, -8, 300, 0, 0},
    {"MCALL CYCLE82(20,5,2,-8,,1.5)", "CYCLE82", 20, 7, -8, 300, 0, 1.5},
    /* 13 deep: first to 0 (5), then 4, 3, 1: 4 steps, so 3 waits of 0.5; 2 at the bottom */
    {"MCALL CYCLE83(20,5,2,-8,,0,,1,0.5,0.25,,0,,2,,2)", "CYCLE83", 20, 7, -8, 300, 0, 3.5},
    /* the same with chips brought out: 0.25 more above each but the first */
    {"MCALL CYCLE83(20,5,2,-8,,0,,1,0.5,0.25,,1,,2,,2)", "CYCLE83", 20, 7, -8, 300, 0, 4.25},
    /* the first step by its length, none shorter: 5, 5, 3; at the bottom as after the others */
    {"MCALL CYCLE83(20,5,2,-8,,,5,,0.5,,,0)", "CYCLE83", 20, 7, -8, 300, 0, 1.5},
    {"MCALL CYCLE84(20,5,2,-8,,0.7,3,,1.25,,400)", "CYCLE84", 20, 7, -8, 500, 500, 0.7},
    {"MCALL CYCLE84(20,5,2,-8,,,3,,-1.25,,400)", "CYCLE84", 20, 7, -8, 500, 500, 0},
    {"MCALL CYCLE85(20,5,2,-8,,1,120,240)", "CYCLE85", 20, 7, -8, 120, 240, 1},
    {"MCALL CYCLE85(20,5,2,-8)", "CYCLE85", 20, 7, -8, 300, 300, 0},
};

START_TEST(calls)
{
    struct ncread_place to = c.here;
    c.text = siemens[_i].call;
    ck_assert_int_eq(ncread_hole_call(&c, siemens[_i].name, &error), 0);
    ck_assert_int_eq(ncread_hole_down(&c, &to, &error), 0);
    double clear = siemens[_i].clear, out = siemens[_i].out;
    ends(out > 0 ? 4 : 3, out > 0
                              ? (const double[][4]){{1, 2, clear, 0},
                                                    {1, 2, siemens[_i].bottom, siemens[_i].down},
                                                    {1, 2, clear, out},
                                                    {1, 2, siemens[_i].level, 0}}
                              : (const double[][4]){{1, 2, clear, 0},
                                                    {1, 2, siemens[_i].bottom, siemens[_i].down},
                                                    {1, 2, siemens[_i].level, 0},
                                                    {0}});
    ck_assert_double_eq_tol(motion.dwell, siemens[_i].dwell / 60, 1e-15);
}
END_TEST

START_TEST(bad_calls)
{
    static const char *const k[][3] = {
        {"CYCLE81(20,5,2,-8)", "CYCLE81", "without MCALL"},
        {"MCALL CYCLE81(20,5,2)", "CYCLE81", "four heights"},
        {"MCALL CYCLE81(20,,2,-8)", "CYCLE81", "four heights"},
        {"MCALL CYCLE83(20,5,2,-8,,,0)", "CYCLE83", "first step"},
        {"MCALL CYCLE84(20,5,2,-8,,,3,,,,400)", "CYCLE84", "pitch or speed"},
        {"MCALL CYCLE84(20,5,2,-8,,,3,,0,,400)", "CYCLE84", "pitch or speed"},
        {"MCALL CYCLE84(20,5,2,-8,,,3,,1,,0)", "CYCLE84", "pitch or speed"}};
    for (size_t i = 0; i < sizeof k / sizeof *k; i++) {
        c.text = k[i][0];
        ck_assert_int_eq(ncread_hole_call(&c, k[i][1], &error), -1);
        ck_assert_msg(strstr(error.text, k[i][2]) != NULL, "%s", error.text);
    }
}
END_TEST

static const struct {
    const char *number, *q[12];
    double level, clear, bottom, down, out, dwell;
} klartext[] = {
    {"200",
     {"Q200=2", "Q201=-13", "Q206=150", "Q202=13", "Q210=0", "Q203=+5", "Q204=15", "Q211=0.5"},
     20,
     7,
     -8,
     150,
     0,
     0.5},
    /* in steps of 5: drawn up twice, and waits there */
    {"200",
     {"Q200=2", "Q201=-13", "Q206=150", "Q202=5", "Q210=1", "Q203=+5", "Q204=15", "Q211=0"},
     20,
     7,
     -8,
     150,
     0,
     2},
    /* a second height below the first one does not count; reaming, out at its own feed */
    {"201",
     {"Q200=2", "Q201=-13", "Q206=150", "Q211=1", "Q208=250", "Q203=+5", "Q204=1"},
     7,
     7,
     -8,
     150,
     250,
     1},
    {"201",
     {"Q200=2", "Q201=-13", "Q206=150", "Q208=0", "Q203=+5", "Q204=15"},
     20,
     7,
     -8,
     150,
     150,
     0},
    /* deep: 5, 4, 4 (no less); chips broken twice before it is drawn up, once */
    {"205",
     {"Q200=2", "Q201=-13", "Q206=150", "Q202=5", "Q210=1", "Q203=+5", "Q204=15", "Q212=1",
      "Q205=4", "Q213=1"},
     20,
     7,
     -8,
     150,
     0,
     1},
    {"207", {"Q200=2", "Q201=-13", "Q239=-1.25", "Q203=+5", "Q204=15"}, 20, 7, -8, 500, 500, 0},
};

START_TEST(defined)
{
    struct ncread_place to = c.here;
    size_t n = 0;
    ncread_hole_define(&c, klartext[_i].number);
    for (; n < 12 && klartext[_i].q[n]; n++)
        ck_assert_int_eq(ncread_hole_parameter(&c, klartext[_i].q[n], &error), 0);
    ck_assert_uint_eq(c.hole.lines, n);
    ck_assert_int_eq(ncread_hole_m99(&c, &to, &error), 0);
    double clear = klartext[_i].clear, out = klartext[_i].out, level = klartext[_i].level;
    ends(out > 0 ? (level > clear ? 4 : 3) : 3,
         out > 0 ? (const double[][4]){{1, 2, clear, 0},
                                       {1, 2, klartext[_i].bottom, klartext[_i].down},
                                       {1, 2, clear, out},
                                       {1, 2, level, 0}}
                 : (const double[][4]){{1, 2, clear, 0},
                                       {1, 2, klartext[_i].bottom, klartext[_i].down},
                                       {1, 2, level, 0},
                                       {0}});
    ck_assert_double_eq_tol(motion.dwell, klartext[_i].dwell / 60, 1e-15);
    /* another definition knows nothing of this one; other cycles are none */
    ncread_hole_define(&c, "200");
    ck_assert_int_eq(ncread_hole_m99(&c, &to, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "M99 without a cycle and its heights"));
}
END_TEST

START_TEST(bad_definitions)
{
    static const char *const line[] = {"X=3", "Q199=1", "Q400=1", "Q200 1", "Q200=", "Q200=X"};
    for (size_t i = 0; i < sizeof line / sizeof *line; i++)
        ck_assert_int_eq(ncread_hole_parameter(&c, line[i], &error), -1);
    ncread_hole_define(&c, "199");
    ck_assert_int_eq(c.hole.cycle, 0);
    ncread_hole_define(&c, "208");
    ck_assert_int_eq(c.hole.cycle, 0);
    ncread_hole_define(&c, "207");
    ck_assert_int_eq(c.hole.cycle, 207);
}
END_TEST

static void begin(void)
{
    setup();
    seen = 0;
}

int main(void)
{
    Suite *suite = suite_create("ncread_hole");
    TCase *tests = tcase_create("ncread_hole");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, begin, reading_end);
    tcase_add_test(tests, levels);
    tcase_add_test(tests, codes);
    tcase_add_test(tests, incremental);
    tcase_add_loop_test(tests, refused, 0, 7);
    tcase_add_test(tests, dwells);
    tcase_add_loop_test(tests, calls, 0, (int)(sizeof siemens / sizeof *siemens));
    tcase_add_test(tests, bad_calls);
    tcase_add_loop_test(tests, defined, 0, (int)(sizeof klartext / sizeof *klartext));
    tcase_add_test(tests, bad_definitions);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
