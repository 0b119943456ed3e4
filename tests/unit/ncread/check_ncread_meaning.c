/* ncread_meaning: what a control's file says of a word, in every spelling; what it does to the
 * state; which numbers of G and M move the tool. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ncread/ncread_meaning.h"
#include "reading.h"

START_TEST(spellings)
{
    static const struct {
        const char *word;
        enum ncread_meaning meaning;
    } k[] = {{"G234", MEANS_TCP},
             {"G234.0", MEANS_TCP},
             {"G0234", MEANS_TCP},
             {"G49", MEANS_LENGTH_OFF},
             {"G54.1", MEANS_OFFSET},
             {"G54.10", MEANS_OFFSET},
             {"#RTCP ON", MEANS_TCP_VECTORS},
             {"M127", MEANS_IDLE},
             {"G54", MEANS_NOTHING_KNOWN},
             {"H234", MEANS_NOTHING_KNOWN},
             {"G54.2", MEANS_NOTHING_KNOWN},
             {"#RTCP", MEANS_NOTHING_KNOWN},
             {"G", MEANS_NOTHING_KNOWN},
             {"G234x", MEANS_NOTHING_KNOWN},
             {"#rtcp on", MEANS_NOTHING_KNOWN}};
    options.words =
        " G234: tcp | G49:length.off|G54.1: offset | {hash}RTCP ON : tcp.vectors | M127: idle ";
    ck_assert_int_eq(ncread_meaning_check(options.words, &error), 0);
    for (size_t i = 0; i < sizeof k / sizeof *k; i++)
        ck_assert_msg(ncread_meaning_of(&c, k[i].word) == k[i].meaning, "%s", k[i].word);
    struct ncread_word w = {.kind = WORD_ADDRESS, .name = "G", .value = {54.1}};
    ck_assert_int_eq(ncread_meaning_of_word(&c, &w), MEANS_OFFSET);
    w = (struct ncread_word){.name = "#RTCP ON", .value = {3}};
    w.kind = WORD_ADDRESS + 1;
    ck_assert_int_eq(ncread_meaning_of_word(&c, &w), MEANS_TCP_VECTORS);
    options.words = NULL;
    ck_assert_int_eq(ncread_meaning_of(&c, "G234"), MEANS_NOTHING_KNOWN);
    ck_assert_int_eq(ncread_meaning_of_word(&c, &w), MEANS_NOTHING_KNOWN);
    options.words = "";
    ck_assert_int_eq(ncread_meaning_of_word(&c, &w), MEANS_NOTHING_KNOWN);
}
END_TEST

/* A letter alone is for all words of it that have no entry, before it or behind it. */
START_TEST(letters_and_ranges)
{
    static const struct {
        const char *word;
        enum ncread_meaning meaning;
    } k[] = {
        {"G11", MEANS_UNREAD},        {"G0", MEANS_NOTHING_KNOWN},  {"G4", MEANS_NOTHING_KNOWN},
        {"G3.1", MEANS_UNREAD},       {"G5", MEANS_UNREAD},         {"G15", MEANS_OFFSET},
        {"G7", MEANS_IDLE},           {"G91.1", MEANS_UNREAD},      {"G17", MEANS_NOTHING_KNOWN},
        {"M11", MEANS_UNREAD},        {"M12", MEANS_NOTHING_KNOWN}, {"G-1", MEANS_NOTHING_KNOWN},
        {"GOTO", MEANS_NOTHING_KNOWN}};
    options.words =
        "G15: offset | G0-G4: read | G: unread | G17-G19: read | G7: idle | M10-M11: unread";
    ck_assert_int_eq(ncread_meaning_check(options.words, &error), 0);
    for (size_t i = 0; i < sizeof k / sizeof *k; i++)
        ck_assert_msg(ncread_meaning_of(&c, k[i].word) == k[i].meaning, "%s", k[i].word);
    ck_assert_int_lt(ncread_meaning_apply(&c, MEANS_UNREAD, &error), 0);
    options.words = "";
}
END_TEST

START_TEST(bad_keys)
{
    static const char *const k[] = {"G234",  "G234:",        "G234: tpc",
                                    ": tcp", "G1: tcp | G2", "G1: TCP"};
    for (size_t i = 0; i < sizeof k / sizeof *k; i++) {
        ck_assert_msg(ncread_meaning_check(k[i], &error) == -1, "%s", k[i]);
        ck_assert_ptr_nonnull(strstr(error.text, "words: found `"));
    }
    ck_assert_int_eq(ncread_meaning_check("", &error), 0);
    ck_assert_int_eq(ncread_meaning_check(" | ", &error), 0);
}
END_TEST

/* At 1 2 3, on a machine of one rotary axis that is not at zero. */
static void turned(void)
{
    options.kinematics.n = 1;
    c.here = (struct ncread_place){.known = {true, true, true}, .turned = {true}, .turn = {0.1}};
}

START_TEST(what_they_do)
{
    turned();
    ck_assert_int_eq(ncread_meaning_apply(&c, MEANS_IDLE, &error), 0);
    ck_assert(!c.tcp && !c.length && !c.vectors && c.here.known[0]);
    ncread_meaning_apply(&c, MEANS_TCP, &error);
    ck_assert(c.tcp && c.length && !c.vectors); /* where the tip is now nobody knows */
    ck_assert(!c.here.known[0] && !c.here.known[1] && !c.here.known[2]);
    ncread_meaning_apply(&c, MEANS_TCP_VECTORS, &error);
    ck_assert(c.tcp && c.vectors);
    ncread_meaning_apply(&c, MEANS_TCP_OFF, &error);
    ck_assert(!c.tcp && !c.vectors && !c.length);
    turned();
    c.here.turn[0] = 0; /* upright it stays where it is */
    ncread_meaning_apply(&c, MEANS_TCP, &error);
    ck_assert(c.here.known[0] && c.here.known[1] && c.here.known[2]);
    options.words = "G43: never";
    ncread_meaning_apply(&c, MEANS_LENGTH_OFF, &error);
    ck_assert(!c.tcp && c.length); /* it is always on */
    c.length = false;
    ncread_meaning_apply(&c, MEANS_LENGTH, &error);
    ck_assert(c.length && c.here.known[0]);
    ncread_meaning_apply(&c, MEANS_HOME, &error);
    ck_assert(!c.here.known[0] && !c.here.known[2]);
    ncread_meaning_apply(&c, MEANS_MACHINE_ON, &error);
    ck_assert(c.machine_frame);
    ncread_meaning_apply(&c, MEANS_MACHINE_OFF, &error);
    ck_assert(!c.machine_frame);
    ck_assert_int_eq(ncread_meaning_apply(&c, MEANS_INCH, &error), 0);
    ck_assert_double_eq(c.unit, 25.4);
    ck_assert(!c.ended);
    ncread_meaning_apply(&c, MEANS_END, &error);
    ck_assert(c.ended);
}
END_TEST

START_TEST(unknown_words)
{
    char word[20];
    c.line = 4;
    ncread_meaning_note(&c, "G961");
    c.line = 9;
    ncread_meaning_note(&c, "M77");
    ncread_meaning_note(&c, "G961");
    ck_assert_uint_eq(c.unknown_n, 2);
    ck_assert_uint_eq(c.unknown[0].line, 4);
    ck_assert_uint_eq(c.unknown[0].times, 2);
    ck_assert_uint_eq(c.unknown[1].line, 9);
    ck_assert_uint_eq(c.unknown[1].times, 1);
    for (int i = 0; i < 2 * NCREAD_UNKNOWN; i++) {
        snprintf(word, sizeof word, "M%d", 1000 + i);
        ncread_meaning_note(&c, word);
    }
    ck_assert_uint_eq(c.unknown_n, NCREAD_UNKNOWN);
}
END_TEST

/* First and last number of each kind, and those beside them. */
START_TEST(numbers_that_move)
{
    static const int yes[] = {21,  23,  52,  60,  71,  100, 139, 160, 270,  290, 310,
                              389, 410, 429, 431, 449, 489, 531, 539, 109,  171, 960,
                              500, 529, 600, 669, 680, 700, 890, 920, 1079, 2680},
                     no[] = {0,   10,  20,  24,  40,  54,  72,  110, 140, 159,
                             161, 269, 291, 299, 390, 400, 430, 490, 530, 540,
                             599, 610, 640, 691, 900, 910, 930, 940, 999, 2679};
    for (size_t i = 0; i < sizeof yes / sizeof *yes; i++)
        ck_assert_msg(ncread_meaning_moves('G', yes[i]) != NULL, "G%g", yes[i] / 10.0);
    for (size_t i = 0; i < sizeof no / sizeof *no; i++)
        ck_assert_msg(ncread_meaning_moves('G', no[i]) == NULL, "G%g", no[i] / 10.0);
    static const int m_yes[] = {960, 990, 999, 1980, 1400},
                     m_no[] = {959, 1000, 30, 1979, 1981, 1399, 21};
    for (size_t i = 0; i < sizeof m_yes / sizeof *m_yes; i++)
        ck_assert_ptr_nonnull(ncread_meaning_moves('M', m_yes[i]));
    for (size_t i = 0; i < sizeof m_no / sizeof *m_no; i++)
        ck_assert_ptr_null(ncread_meaning_moves('M', m_no[i]));
    ck_assert_ptr_null(ncread_meaning_moves('F', 700));
}
END_TEST

START_TEST(names_that_shape)
{
    static const char *const yes[] = {"X",   "B",      "A2",      "AR",   "RND",
                                      "CHR", "POS[Z]", "POSA[C]", "R[3]", "X1"},
                             *const no[] = {"F",   "S1",   "AXX", "ARX", "RN",
                                            "POS", "SPOS", "D1",  "Q200"};
    for (size_t i = 0; i < sizeof yes / sizeof *yes; i++)
        ck_assert_msg(ncread_meaning_shapes(yes[i]), "%s", yes[i]);
    for (size_t i = 0; i < sizeof no / sizeof *no; i++)
        ck_assert_msg(!ncread_meaning_shapes(no[i]), "%s", no[i]);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("ncread_meaning");
    TCase *tests = tcase_create("ncread_meaning");
    tcase_add_checked_fixture(tests, reading_begin, reading_end);
    tcase_add_test(tests, spellings);
    tcase_add_test(tests, letters_and_ranges);
    tcase_add_test(tests, bad_keys);
    tcase_add_test(tests, what_they_do);
    tcase_add_test(tests, unknown_words);
    tcase_add_test(tests, numbers_that_move);
    tcase_add_test(tests, names_that_shape);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
