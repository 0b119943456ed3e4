/* machine: keys, defaults, includes, the chain that comes of them, and what is refused. */
#include <check.h>
#include <dirent.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "machine/machine.h"
#include "seed.h"

static char shipped[1000];
static char folder[] = "/tmp/check_machine.XXXXXX";

static void write_file(const char *name, const char *text)
{
    FILE *f = fopen(name, "wb");
    ck_assert_ptr_nonnull(f);
    fputs(text, f);
    ck_assert_int_eq(fclose(f), 0);
}

static void enter(void)
{
    strcpy(folder + strlen(folder) - 6, "XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(folder));
    ck_assert_int_eq(chdir(folder), 0);
}

static void leave(void)
{
    unlink("one.txt");
    unlink("two.txt");
    ck_assert_int_eq(chdir("/"), 0);
    rmdir(folder);
}

START_TEST(keys_into_the_chain)
{
    struct machine m = machine_default();
    struct error e;
    write_file("one.txt", "name = Mine # a comment\ntype = head-table\naxes = B C\n"
                          "axis.B = 0 -2 0\ncentre.B = 0 0 150\nb.min=-95\nb.max=110\n"
                          "digits.linear = 4\ntcp = no\n\n# nothing\n");
    ck_assert_int_eq(machine_read(&m, "one", &e), 0);
    ck_assert_int_eq(machine_set(&m, "c.max=400", &e), 0);
    ck_assert_int_eq(machine_set(&m, " c.max = 360 ", &e), 0);
    ck_assert_int_eq(machine_finish(&m, &e), 0);
    ck_assert_str_eq(m.name, "Mine");
    ck_assert(!m.tcp);
    ck_assert_int_eq(m.digits.linear, 4);
    ck_assert_int_eq(m.digits.angle, -1);
    ck_assert_int_eq(m.chain.n, 2);
    ck_assert_int_eq(machine_letter(m.letter[0]), 'C');
    ck_assert_int_eq(machine_letter(m.letter[1]), 'B');
    ck_assert_int_eq(m.chain.master, 1);
    ck_assert(m.chain.rotary[0].table && !m.chain.rotary[1].table);
    ck_assert_double_eq(m.chain.rotary[1].axis.y, -1);
    ck_assert_double_eq(m.chain.rotary[1].centre.z, 150);
    ck_assert_double_eq_tol(m.chain.rotary[1].max, RADIANS(110), 1e-15);
    ck_assert_double_eq_tol(m.chain.rotary[0].max, 2 * PI, 1e-15);
}
END_TEST

START_TEST(include_comes_first)
{
    struct machine m = machine_default();
    struct error e;
    write_file("two.txt", "name = Base\na.min = -30\nretract = 77\n");
    write_file("one.txt", "include = two\nname = Own\na.min = -40\n");
    ck_assert_int_eq(machine_read(&m, "./one.txt", &e), 0);
    ck_assert_str_eq(m.name, "Own");
    ck_assert_double_eq(m.min[MACHINE_A], -40);
    ck_assert_double_eq(m.retract, 77);
}
END_TEST

START_TEST(orders_of_the_chain)
{
    struct machine m = machine_default();
    struct error e;
    ck_assert_int_eq(machine_finish(&m, &e), 0); /* A carries C: C is nearest the work */
    ck_assert_int_eq(machine_letter(m.letter[0]), 'C');
    ck_assert_int_eq(m.chain.master, 1);
    ck_assert_int_eq(machine_set(&m, "type=head-head", &e), 0);
    ck_assert_int_eq(machine_set(&m, "axes=C A", &e), 0);
    ck_assert_int_eq(machine_finish(&m, &e), 0); /* C carries A, in the head */
    ck_assert_int_eq(machine_letter(m.letter[0]), 'C');
    ck_assert_int_eq(m.chain.master, 0);
    ck_assert(!m.chain.rotary[0].table);
    ck_assert_int_eq(machine_set(&m, "type=none", &e), 0);
    ck_assert_int_eq(machine_finish(&m, &e), 0);
    ck_assert_int_eq(m.chain.n, 0);
}
END_TEST

static const struct {
    const char *text, *place, *says;
} bad[] = {
    {"name = a\nfrobnicate = 7\n", "one.txt:2: ", "frobnicate"},
    {"tcp = yes\nx.min = 1\ntcp = no\n", "one.txt:3: ", "tcp again"},
    {"digits.linear = 12.3.4\n", "one.txt:1: ", "12.3.4"},
    {"digits.linear = 2.5\n", "one.txt:1: ", "whole number"},
    {"digits.linear = 10\n", "one.txt:1: ", "expected 1 to 9"},
    {"x.min = nan\n", "one.txt:1: ", "nan"},
    {"x.min = inf\n", "one.txt:1: ", "inf"},
    {"\n\nx.min\n", "one.txt:3: ", "expected key = value"},
    {"x.min =   # none\n", "one.txt:1: ", "no value of x.min"},
    {"= 5\n", "one.txt:1: ", "no key"},
    {"x.max = 4\nx.min = 5\n", "one.txt:2: ", "x.min 5 above x.max 4"},
    {"axis.A = 1 0\n", "one.txt:1: ", "three numbers"},
    {"axis.A = 1 0 0 0\n", "one.txt:1: ", "three numbers"},
    {"tcp = perhaps\n", "one.txt:1: ", "no|yes"},
    {"type = table-tabel\n", "one.txt:1: ", "table-table|"},
    {"include = one\n", "one.txt:1: ", "include"},
    {"include = none.txt\n", "one.txt:1: ", "none.txt"},
    {"include =\n", "one.txt:1: ", "include"},
    {"name = \001\n", "one.txt:1: ", "binary"},
};

START_TEST(refused_with_its_line)
{
    struct machine m = machine_default();
    struct error e;
    write_file("one.txt", bad[_i].text);
    ck_assert_int_eq(machine_read(&m, "one.txt", &e), -1);
    ck_assert_msg(strncmp(e.text, bad[_i].place, strlen(bad[_i].place)) == 0, "%s", e.text);
    ck_assert_msg(strstr(e.text, bad[_i].says) != NULL, "%s", e.text);
}
END_TEST

/* An empty file is no machine: what was cut short to nothing must not pass for the default. */
START_TEST(nothing_said)
{
    struct machine m = machine_default();
    struct error e;
    write_file("one.txt", "\n# a remark\n");
    ck_assert_int_eq(machine_read(&m, "one.txt", &e), -1);
    ck_assert_msg(strstr(e.text, "one.txt: found no key, expected lines key = value"), "%s",
                  e.text);
    write_file("one.txt", "# a remark\nname = one");
    ck_assert_int_eq(machine_read(&m, "one.txt", &e), 0);
}
END_TEST

static const struct {
    const char *setting, *says;
} impossible[] = {
    {"axes=A", "two"},
    {"axes=A A", "two"},
    {"axes=A B C", "two"},
    {"axes=A X", "two"},
    {"axis.A=0 0 0", "0 long"},
    {"axis.A=0 0 1", "parallel"},
    {"a.min=200", "a.min 200 above"},
};

START_TEST(refused_together)
{
    struct machine m = machine_default();
    struct error e;
    ck_assert_int_eq(machine_set(&m, impossible[_i].setting, &e), 0);
    ck_assert_int_eq(machine_finish(&m, &e), -1);
    ck_assert_msg(strstr(e.text, impossible[_i].says) != NULL, "%s", e.text);
}
END_TEST

START_TEST(not_found)
{
    struct machine m = machine_default();
    struct error e;
    ck_assert_int_eq(machine_read(&m, "no-such-machine", &e), -1);
    ck_assert_msg(strstr(e.text, "not found") != NULL, "%s", e.text);
    ck_assert_int_eq(machine_set(&m, "nothing", &e), -1);
    ck_assert_int_eq(machine_set(&m, "frob=1", &e), -1);
}
END_TEST

/* The folder of the shipped machines: from the root of the project, or where run.sh says it is. */
static const char *machines(void)
{
    const char *root = getenv("SRC");
    snprintf(shipped, sizeof shipped, "%s/machines", root ? root : ".");
    return shipped;
}

static double chance(void) /* -1..1, a plain generator of Lehmer's */
{
    static uint64_t state = 0;
    state = (state ? state : seed_begin(1)) * 48271 % 2147483647;
    return (double)state / 1073741823.5 - 1;
}

/* One random pose: angles within the travel to an axis, back to angles, and to an axis again; the
 * tip to the linear axes and back. */
static void there_and_back(const struct machine *m, double *axis, double *point)
{
    const struct kinematic_chain *chain = &m->chain;
    double q[ROTARY_MAX] = {0};
    for (int i = 0; i < chain->n; i++) {
        const struct rotary *r = &chain->rotary[i];
        double span = fmin(r->max - r->min, 4 * PI), middle = (r->max + r->min) / 2;
        q[i] = middle + span / 2 * chance();
    }
    struct vec3 a = chain_axis(chain, q), tip = vec(500 * chance(), 500 * chance(), 500 * chance());
    struct chain_solutions s = chain_angles(chain, a);
    if (s.n == 0)
        *axis = 360;
    for (int k = 0; k < s.n; k++) {
        *axis = fmax(*axis, DEGREES(vec_angle(chain_axis(chain, s.q[k]), a)));
        struct vec3 back = chain_tip(chain, chain_linear(chain, tip, s.q[k]), s.q[k]);
        *point = fmax(*point, vec_distance(back, tip));
    }
}

START_TEST(shipped_machines_there_and_back)
{
    DIR *folder_of = opendir(machines());
    const char *poses = getenv("POSES"); /* 1000000 for the figure in the note */
    long n = poses ? atol(poses) : 30000;
    int found = 0;
    char controls[2000];
    snprintf(controls, sizeof controls, "%s/../controls", machines());
    ck_assert_int_eq(setenv("CLOUDMILL_CONTROLS", controls, 1), 0); /* which machines name */
    ck_assert_ptr_nonnull(folder_of);
    for (struct dirent *entry; (entry = readdir(folder_of));) {
        char file[2000];
        struct machine m = machine_default();
        struct error e = {.text = ""};
        double axis = 0, point = 0;
        if (!strstr(entry->d_name, ".txt"))
            continue;
        snprintf(file, sizeof file, "%s/%s", shipped, entry->d_name);
        int read = machine_read(&m, file, &e) == 0 ? machine_finish(&m, &e) : -1;
        ck_assert_msg(read == 0, "%s", e.text);
        for (long i = 0; i < n; i++)
            there_and_back(&m, &axis, &point);
        ck_assert_msg(axis <= 1e-9 && point <= 1e-9, "%s: %g degrees, %g mm", m.name, axis, point);
        if (poses)
            printf("%-24s %.2g degrees %.2g mm\n", entry->d_name, axis, point);
        found++;
    }
    closedir(folder_of);
    ck_assert_int_ge(found, 10);
}
END_TEST

START_TEST(templates_know_their_words)
{
    struct machine m = machine_default();
    struct error e;
    ck_assert_int_eq(machine_set(&m, "tool.change = T{tool} M6|G43 H{tool}", &e), 0);
    ck_assert_int_eq(machine_finish(&m, &e), 0);
    ck_assert_int_eq(machine_set(&m, "home = G53 Z{height}", &e), 0);
    ck_assert_int_eq(machine_finish(&m, &e), -1);
    ck_assert_ptr_nonnull(strstr(e.text, "{height}"));
}
END_TEST

/* The table of controls: each name is found again, and all stand in the choice in its order. */
START_TEST(controls)
{
    char all[200] = "";
    for (int id = 0; id < CONTROLS; id++) {
        const struct control *row = control_row((enum control_id)id);
        ck_assert_int_eq(control_find(row->name), id);
        snprintf(all + strlen(all), sizeof all - strlen(all), "%s%s", id ? "|" : "", row->name);
    }
    ck_assert_str_eq(control_names(), all);
    ck_assert_int_eq(control_find("fan"), CONTROLS);
    ck_assert_int_eq(control_find(""), CONTROLS);
}
END_TEST

/* Tool-centre-point control: the machine's, and of LinuxCNC only where the file names it. */
START_TEST(tcp_of_controls)
{
    static const struct {
        const char *setting;
        bool fanuc, siemens, linuxcnc;
    } row[] = {{"name=any", true, true, false},
               {"control=fanuc", true, true, false},
               {"control=linuxcnc", true, true, true},
               {"tcp=no", false, false, false}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct machine m = machine_default();
        struct error e;
        ck_assert_int_eq(machine_set(&m, row[i].setting, &e), 0);
        ck_assert_int_eq(machine_finish(&m, &e), 0);
        ck_assert_int_eq(machine_has_tcp(&m, CONTROL_fanuc), row[i].fanuc);
        ck_assert_int_eq(machine_has_tcp(&m, CONTROL_siemens), row[i].siemens);
        ck_assert_int_eq(machine_has_tcp(&m, CONTROL_linuxcnc), row[i].linuxcnc);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("machine");
    TCase *tests = tcase_create("files");

    tcase_add_checked_fixture(tests, enter, leave);
    tcase_add_test(tests, keys_into_the_chain);
    tcase_add_test(tests, controls);
    tcase_add_test(tests, tcp_of_controls);
    tcase_add_test(tests, include_comes_first);
    tcase_add_test(tests, orders_of_the_chain);
    tcase_add_loop_test(tests, refused_with_its_line, 0, (int)(sizeof bad / sizeof *bad));
    tcase_add_loop_test(tests, refused_together, 0, (int)(sizeof impossible / sizeof *impossible));
    tcase_add_test(tests, nothing_said);
    tcase_add_test(tests, not_found);
    suite_add_tcase(suite, tests);
    TCase *all = tcase_create("shipped");
    tcase_set_timeout(all, 300);
    tcase_add_test(all, templates_know_their_words);
    tcase_add_test(all, shipped_machines_there_and_back);
    suite_add_tcase(suite, all);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
