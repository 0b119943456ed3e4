/*
 * verify_made: coolant and work offset of the first cut against what the program was made with,
 * with its path and without.
 */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "verify/verify_made.h"

static const struct {
    const char *work;    /* made for it; NULL: not known */
    const char *has;     /* the program's */
    bool wet, on;        /* its head says no word of a dry cut; coolant is on */
    int path;            /* 0: none is given; 1: dry; 2: with coolant */
    const char *message; /* part of it; NULL: nothing is said */
} trials[] = {
    {NULL, "G55", false, false, 0, NULL},
    {"G54", "G54", false, false, 0, NULL},
    {"G54", "G55", false, false, 0, "the work offset is G55, and the program was made for G54"},
    {"G54.1 P3", "G54.1 P3", false, false, 0, NULL},
    {"G54.1 P3", "G54.1 P4", false, false, 0, "was made for G54.1 P3"},
    {"G54", "", false, false, 0, NULL}, /* the reader says it */
    {"", "", false, false, 0, NULL},
    {"", "CYCL DEF 247 Q339=+2", false, false, 0, "was made for the active preset"},
    {"CYCL DEF 247 Q339=+1", "", false, false, 0, "cuts without the work offset, CYCL DEF 247"},
    {"CYCL DEF 247 Q339=+1", "CYCL DEF 247 Q339=+2", false, false, 0, "work offset is CYCL DEF"},
    {"CYCL DEF 247 Q339=+1", "CYCL DEF 247 Q339=1", false, false, 0, NULL},
    {NULL, "", true, false, 0, "its head does not say so (COOLANT: NONE)"},
    {NULL, "", true, true, 0, NULL},
    {NULL, "", true, false, 1, NULL}, /* the path knows it */
    {NULL, "", true, false, 2, "the path has coolant on, the program cuts without"},
    {NULL, "", false, false, 2, "the path has coolant on, the program cuts without"},
    {NULL, "", true, true, 2, NULL},
};

START_TEST(what_it_was_made_with)
{
    struct nc_motion motion = {.coolant = trials[_i].on}, path = {.coolant = trials[_i].path == 2};
    struct verdict v = {.program = {.motion = &motion,
                                    .work = trials[_i].work,
                                    .wet = trials[_i].wet,
                                    .path = trials[_i].path ? &path : NULL}};
    snprintf(motion.work, sizeof motion.work, "%s", trials[_i].has);
    *array_push(&motion.piece) = (struct nc_piece){.block = 10, .line = 1};
    *array_push(&v.cut) = (struct centre_segment){.on = true};
    verify_made(&v);
    ck_assert_uint_eq(v.finding.n, trials[_i].message != NULL);
    if (trials[_i].message) {
        ck_assert(v.finding.item[0].fault);
        ck_assert_msg(strstr(v.finding.item[0].text, trials[_i].message) != NULL, "%s",
                      v.finding.item[0].text);
    }
    nc_motion_free(&motion);
    verdict_free(&v);
}
END_TEST

START_TEST(nothing_is_cut)
{
    struct nc_motion motion = {.work = "G55"};
    struct verdict v = {.program = {.motion = &motion, .work = "G54", .wet = true}};
    *array_push(&motion.piece) = (struct nc_piece){.rapid = true};
    verify_made(&v);
    ck_assert_uint_eq(v.finding.n, 0);
    nc_motion_free(&motion);
    verdict_free(&v);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("verify_made");
    TCase *tests = tcase_create("verify_made");
    tcase_add_loop_test(tests, what_it_was_made_with, 0, sizeof trials / sizeof *trials);
    tcase_add_test(tests, nothing_is_cut);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
