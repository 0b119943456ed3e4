/*
 * path_cycle: what each system writes after CYCLE, against the hole it means; and
 * (path_expand_cycles) the motions that it stands for, by their depths.
 */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/path/path.h"
#include "io/path/path_parse.h"
#include "scratch.h"

#define CREO "$$* Pro/CLfile 8.0\n"

static int read_cycle(const char *head, const char *words, struct path *path, struct error *error)
{
    char text[4096];
    snprintf(text, sizeof text,
             "%sSPINDL/RPM,1000,CLW\nRAPID\nGOTO/0,0,50\nCYCLE/%s\nGOTO/10,0,0\nGOTO/20,0,-3\n"
             "CYCLE/OFF\nFINI\n",
             head, words);
    bool mm = strncmp(head, "UNITS/MM", 8) == 0; /* feeds in inches are meant */
    return path_read_as(scratch_text(text), mm ? PATH_UNIT_MM : PATH_UNIT_SAID, path, error);
}

static const struct {
    const char *head, *words;
    enum path_cycle_kind kind;
    double depth, clear, retract, step, next, dwell, feed, pitch;
} means[] = {
    {"", "DRILL,DEPTH,10,MMPM,200,CLEAR,2", CYCLE_DRILL, 10, 2, 2, 0, 0, 0, 200, 0},
    {"UNITS/MM\n", "DRILL,RAPTO,3,FEDTO,-10,RTRCTO,5,IPM,10", CYCLE_DRILL, 10, 3, 5, 0, 0, 0, 254,
     0},
    {"", "DRILL,10,200,MMPM,2", CYCLE_DRILL, 10, 2, 2, 0, 0, 0, 200, 0},
    {"", "DRILL,DEPTH,10", CYCLE_DRILL, 10, 1, 1, 0, 0, 0, 0, 0},
    {"UNITS/INCHES\n", "DRILL,1,8,IPM,.1", CYCLE_DRILL, 25.4, 2.54, 2.54, 0, 0, 0, 203.2, 0},
    {"UNITS/INCHES\n", "DRILL,DEPTH,1,CLEAR,.1", CYCLE_DRILL, 25.4, 2.54, 2.54, 0, 0, 0, 0, 0},
    {"", "DEEP,20,200,MMPM,2,5", CYCLE_DEEP, 20, 2, 2, 5, 5, 0, 200, 0},
    {"", "DEEPHL,20,INCR,5,300,MMPM,1.5", CYCLE_DEEP, 20, 1.5, 1.5, 5, 5, 0, 300, 0},
    {"", "BRKCHP,20,INCR,5,300,MMPM,1.5,DWELL,2", CYCLE_BREAK, 20, 1.5, 1.5, 5, 5, 2, 300, 0},
    {"", "DRILL,10,MMPM,200,2", CYCLE_DRILL, 10, 2, 2, 0, 0, 0, 200, 0},
    {"", "DRILL,DEEP,RAPTO,3,STEP,6,4,5,FEDTO,-20", CYCLE_DEEP, 20, 3, 3, 6, 4, 0, 0, 0},
    {"", "DEEP2,DEPTH,20,1STPECK,6,SUBPECK,3", CYCLE_DEEP, 20, 1, 1, 6, 3, 0, 0, 0},
    {"", "BRKCHP,DEPTH,20,STEP,5,CLEAR,2,BACK,.5", CYCLE_BREAK, 20, 2, 2, 5, 5, 0, 0, 0},
    {"", "FACE,DEPTH,2,DWELL,1.5", CYCLE_DRILL, 2, 1, 1, 0, 0, 1.5, 0, 0},
    {"", "FACE,DEPTH,2,REV,5", CYCLE_DRILL, 2, 1, 1, 0, 0, 0.3, 0, 0},
    {"", "FACE,DEPTH,2,DWELL,REV,5", CYCLE_DRILL, 2, 1, 1, 0, 0, 0.3, 0, 0},
    {"", "TAP,DEPTH,10,PITCH,1.5", CYCLE_TAP, 10, 1, 1, 0, 0, 0, 1500, 1.5},
    {"", "TAP,RIGID,DEPTH,10,MMPR,1.5", CYCLE_TAP, 10, 1, 1, 0, 0, 0, 1500, 0},
    {"", "TAP,DEPTH,10,TPI,20", CYCLE_TAP, 10, 1, 1, 0, 0, 0, 1270, 1.27},
    {"UNITS/MM\n", "TAP,10,1,IPM,20,2", CYCLE_TAP, 10, 2, 2, 0, 0, 0, 1270, 1.27},
    {"", "TAP,10,1.5,MMPR,2", CYCLE_TAP, 10, 2, 2, 0, 0, 0, 1500, 0},
    {"UNITS/MM\n", "BORE,DEPTH,10,IPR,.01", CYCLE_BORE, 10, 1, 1, 0, 0, 0, 254, 0},
    {"", "BORE,DRAG,DEPTH,10", CYCLE_DRAG, 10, 1, 1, 0, 0, 0, 0, 0},
    {"", "BORE,MANUAL,DEPTH,10", CYCLE_MANUAL, 10, 1, 1, 0, 0, 0, 0, 0},
    {"", "DRILL,CLEAR,5,RAPTO,3,DEPTH,10", CYCLE_DRILL, 10, 3, 5, 0, 0, 0, 0, 0},
    {CREO, "DRILL,DEPTH,10,CLEAR,5,RAPTO,3", CYCLE_DRILL, 10, 2, 5, 0, 0, 0, 0, 0},
    {CREO, "DRILL,DEPTH,10,CLEAR,5,RAPTO,7", CYCLE_DRILL, 10, -2, 5, 0, 0, 0, 0, 0},
    {CREO, "DRILL,DEPTH,10,CLEAR,5,RETURN,12", CYCLE_DRILL, 10, 5, 12, 0, 0, 0, 0, 0},
    {CREO, "DRILL,DEPTH,10,CLEAR,5,RETURN,0", CYCLE_DRILL, 10, 5, 50, 0, 0, 0, 0, 0},
    {"", "DRILL,DEPTH,10,CLEAR,5,RETURN,0", CYCLE_DRILL, 10, 5, 5, 0, 0, 0, 0, 0},
    {"", "DRILL,RAPTO,3,FEDTO,-10,RTRCTO,AUTO", CYCLE_DRILL, 10, 3, 50, 0, 0, 0, 0, 0},
    {"", "DRILL,RAPTO,-3,FEDTO,-10", CYCLE_DRILL, 10, -3, 1, 0, 0, 0, 0, 0},
    {"", "CSINK,DEPTH,2,DIAMET,12,CLEAR,2", CYCLE_DRILL, 2, 2, 2, 0, 0, 0, 0, 0},
};

START_TEST(what_it_means)
{
    struct path path;
    struct error error = {.text = ""};
    ck_assert_msg(read_cycle(means[_i].head, means[_i].words, &path, &error) == 0, "%s",
                  error.text);
    const struct path_cycle *c = &path.cycle.item[0];
    ck_assert_int_eq((int)c->kind, (int)means[_i].kind);
    ck_assert_double_eq_tol(c->depth, means[_i].depth, 1e-9);
    ck_assert_double_eq_tol(c->clear, means[_i].clear, 1e-9);
    double unit = *means[_i].head == 'U' ? 25.4 : 1;
    double usual = means[_i].retract;
    ck_assert_double_eq_tol(c->retract, usual == 50 ? 50 * unit : usual, 1e-9);
    ck_assert_double_eq_tol(c->step, means[_i].step, 1e-9);
    ck_assert_double_eq_tol(c->next, means[_i].next, 1e-9);
    ck_assert_double_eq_tol(c->dwell, means[_i].dwell, 1e-9);
    ck_assert_double_eq_tol(c->feed, means[_i].feed, 1e-9);
    ck_assert_double_eq_tol(c->pitch, means[_i].pitch, 1e-9);
    path_free(&path);
}
END_TEST

static const char *const wrong[] = {
    "DRILL",
    "DRILL,CLEAR,2",
    "FROB,DEPTH,2",
    "DRILL,DEPTH,2,5",
    "DEEP,20,200,2,5,1",
    "DEEP,DEPTH,20,STEP,-1",
    "DEEP,DEPTH,20,STEP,.00001",
    "DRILL,DEPTH,3,RAPTO,-3",
    "DRILL,DEPTH,3,DWELL,-1",
    "DRILL,DEPTH,3,MMPM,-1",
    "BORE,BACK,DEPTH,3",
    "THRU,DEPTH,3",
};

START_TEST(what_is_refused)
{
    struct path path;
    struct error error = {.text = ""};
    ck_assert_msg(read_cycle("", wrong[_i], &path, &error) < 0, "taken: %s", wrong[_i]);
    ck_assert_msg(strstr(error.text, "found ") && strstr(error.text, ":4: "), "%s", error.text);
}
END_TEST

/* RTRCTO,AUTO: each hole is left at the height the tool came from. */
START_TEST(home_from_each)
{
    struct path path;
    struct error error = {.text = ""};
    ck_assert_int_eq(read_cycle("", "DRILL,RAPTO,3,FEDTO,-10,RTRCTO,AUTO", &path, &error), 0);
    for (size_t i = 0; i < path.item.n; i++)
        if (path.item.item[i].kind == PATH_HOLE) {
            const struct path_cycle *c = &path.cycle.item[path.item.item[i].index];
            ck_assert_double_eq_tol(path.item.item[i].to.p.z + c->retract, 50, 1e-9);
        }
    ck_assert_uint_eq(path.cycle.n, 2);
    path_free(&path);
    /* the second mouth is above where the tool came from: it is left as usual */
    ck_assert_int_eq(path_read(scratch_text("GOTO/0,0,20\nCYCLE/DRILL,RAPTO,3,FEDTO,9,RTRCTO,AUTO\n"
                                            "GOTO/9,0,0\nGOTO/9,9,30\nGOTO/9,5,0\nFINI\n"),
                               &path, &error),
                     0);
    ck_assert_uint_eq(path.cycle.n, 3);
    ck_assert_double_eq(path.cycle.item[0].retract, 20);
    ck_assert_double_eq(path.cycle.item[1].retract, 3);
    ck_assert_double_eq(path.cycle.item[2].retract, 20);
    path_free(&path);
}
END_TEST

/* The heights of all points, rapid ones in brackets, and the texts' first letters. */
static const char *motions(const struct path *path)
{
    static char text[400];
    char *end = text;
    for (size_t i = 0; i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        if (item->kind == PATH_POINT)
            end += sprintf(end, item->rapid ? "(%g) " : "%g ", item->to.p.z);
        else if (item->kind == PATH_TEXT)
            end += sprintf(end, "%.8s ", path->text.item[item->index]);
    }
    return text;
}

static const struct {
    const char *words, *heights;
} written[] = {
    {"DRILL,DEPTH,4,CLEAR,2,MMPM,9", "(50) (50) (2) -4 (2) (2) (-1) -7 (-1) "},
    {"DRILL,DEPTH,4,RAPTO,-1,MMPM,9", "(50) (50) (1) (-1) -4 (1) (1) (-2) (-4) -7 (-2) "},
    {"DEEP,DEPTH,4,STEP,2,CLEAR,1,MMPM,9",
     "(50) (50) (1) -2 (1) (-1.746) -4 (1) (1) (-2) -5 (-2) (-4.746) -7 (-2) "},
    {"BORE,DEPTH,4,CLEAR,2,MMPM,9", "(50) (50) (2) -4 2 (2) (-1) -7 -1 "},
    {"BORE,MANUAL,DEPTH,4,CLEAR,2,MMPM,9",
     "(50) (50) (2) -4 SPINDL/O STOP (2) SPINDL/R (2) (-1) -7 SPINDL/O STOP (-1) SPINDL/R "},
    {"TAP,DEPTH,4,CLEAR,2,PITCH,1",
     "(50) (50) (2) -4 SPINDL/R 2 SPINDL/R (2) (-1) -7 SPINDL/R -1 SPINDL/R "},
};

START_TEST(as_motions)
{
    struct path path;
    struct error error = {.text = ""};
    ck_assert_msg(read_cycle("", written[_i].words, &path, &error) == 0, "%s", error.text);
    path_expand_cycles(&path);
    ck_assert_str_eq(motions(&path), written[_i].heights);
    path_free(&path);
}
END_TEST

/* What is written is read as the same. */
START_TEST(written_back)
{
    struct path path, again;
    struct error error = {.text = ""};
    char text[CYCLE_TEXT];
    ck_assert_int_eq(read_cycle(means[_i].head, means[_i].words, &path, &error), 0);
    struct path_cycle c = path.cycle.item[0];
    path_cycle_text(&c, text);
    ck_assert_msg(read_cycle("", text + strlen("CYCLE/"), &again, &error) == 0, "%s", error.text);
    const struct path_cycle *d = &again.cycle.item[0];
    ck_assert_int_eq((int)c.kind, (int)d->kind);
    ck_assert_double_eq_tol(c.depth, d->depth, 1e-6);
    ck_assert_double_eq_tol(c.clear, d->clear, 1e-6);
    ck_assert_double_eq_tol(c.retract, d->retract, 1e-6);
    ck_assert_double_eq_tol(c.next, d->next, 1e-6);
    ck_assert_double_eq_tol(c.dwell, d->dwell, 1e-6);
    ck_assert_double_eq_tol(c.feed, d->feed, 1e-6);
    path_free(&path);
    path_free(&again);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("path_cycle");
    TCase *tests = tcase_create("cycles");
    tcase_add_loop_test(tests, what_it_means, 0, sizeof means / sizeof *means);
    tcase_add_loop_test(tests, what_is_refused, 0, sizeof wrong / sizeof *wrong);
    tcase_add_test(tests, home_from_each);
    tcase_add_loop_test(tests, as_motions, 0, sizeof written / sizeof *written);
    tcase_add_loop_test(tests, written_back, 0, sizeof means / sizeof *means);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
