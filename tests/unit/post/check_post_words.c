/*
 * post_words: the words of a block as text, and angles read back as a control takes them; what the
 * tables of the machine say of offsets and tools.
 */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "blocks.h"
#include "chains.h"
#include "post/post_words.h"

static struct path path;
static struct error error;

/* Rotary axes C and then A, without end. */
static void setup(void)
{
    blocks_begin((struct nc_ability){.mode = INTERPOLATE_ROTARY, .tcp = true});
    ck_assert_int_eq(machine_finish(&machine, &error), 0);
    path = (struct path){.name = "p.cl"};
    p.path = &path;
}

static void teardown(void)
{
    array_free(&plan.move);
    array_free(&plan.vector);
    array_free(&path.tool);
    array_free(&p.planes);
}

START_TEST(places)
{
    nc_place(&p, vec(1.5, -2, 3.0004));
    ck_assert_str_eq(said(), "X1.5 Y-2. Z3.");
    nc_place(&p, vec(1.5, -2.1, 3));
    ck_assert_str_eq(said(), "Y-2.1");
    nc_place(&p, vec(1.5, -2.1, 3));
    ck_assert_str_eq(said(), "");
}
END_TEST

static const char *turn(double c, double a)
{
    const double q[ROTARY_MAX] = {RADIANS(c), RADIANS(a)};
    nc_rotary(&p, q);
    return said();
}

/* The tilting axis first; of the first axis alone. */
START_TEST(angles)
{
    const double q[ROTARY_MAX] = {RADIANS(10), RADIANS(-20.5)};
    ck_assert_int_eq(machine.letter[0], MACHINE_C);
    machine.rotary_words = ROTARY_PLAIN;
    ck_assert_str_eq(turn(30, -20.5), "A-20.5 C30.");
    ck_assert_str_eq(turn(750, -20.5), "C750.");
    ck_assert_str_eq(turn(750, -20.5), "");
    nc_rotary_axes(&p, 1, q);
    ck_assert_str_eq(said(), "C10.");
    nc_rotary_axes(&p, 0, q);
    ck_assert_str_eq(said(), "");
}
END_TEST

/* Where a control that knows its axis at `at` goes by the word of it. */
static double gone_to(const char *text, double at, enum machine_rotary_words words)
{
    const char *s = strchr(text, 'C');
    if (!s)
        return at;
    bool dc = strncmp(s, "C=DC(", 5) == 0;
    char *end;
    double value = strtod(s + (dc ? 5 : 1), &end);
    ck_assert(dc == (words == ROTARY_DC) && (*end == ')') == dc);
    if (words == ROTARY_PLAIN)
        return value;
    ck_assert(fabs(value) < 360 || (words == ROTARY_SIGNED && value == -360));
    if (words == ROTARY_SIGNED) { /* the sign says which way round to the angle */
        double to = fabs(value), turns = floor((to - at) / 360 + 1e-9);
        bool back = value < 0;
        to -= 360 * turns; /* at <= to < at + 360 */
        return back ? to - (to - at > 1e-6 ? 360 : 0) : to;
    }
    ck_assert_double_ge(value, 0);
    return at + remainder(value - at, 360); /* the shortest way */
}

/* Random turns of less than half a turn each: read back, the axis is where it was sent. */
START_TEST(turns_read_back)
{
    static const struct {
        enum control_id control;
        int key;
        enum machine_rotary_words words;
    } k[] = {{CONTROL_fanuc, ROTARY_OWN, ROTARY_PLAIN},
             {CONTROL_fanuc, ROTARY_PLAIN, ROTARY_PLAIN},
             {CONTROL_fanuc, ROTARY_WITHIN, ROTARY_WITHIN},
             {CONTROL_fanuc, ROTARY_SIGNED, ROTARY_SIGNED},
             {CONTROL_fanuc, ROTARY_SHORTEST, ROTARY_WITHIN},
             {CONTROL_siemens, ROTARY_OWN, ROTARY_DC},
             {CONTROL_siemens, ROTARY_SHORTEST, ROTARY_DC},
             {CONTROL_siemens, ROTARY_DC, ROTARY_DC}};
    double at = 0, is = 0;
    seed = 900 + (uint64_t)_i;
    p.control = k[_i].control;
    machine.rotary_words = k[_i].key;
    turn(0, 0);
    for (int i = 0; i < 2000; i++) {
        is += i % 7 == 0 ? 0 : i % 5 == 0 ? 90 * floor(3 * chance() - 1) : 350 * chance() - 175;
        is = round(1000 * is) / 1000;
        if (i % 11 == 0)
            is = 360 * round(is / 360); /* whole turns */
        if (fabs(is - at) >= 180)
            is = at;
        const char *text = turn(is, 0);
        ck_assert(strchr(text, 'A') == NULL);
        ck_assert((*text == '\0') == (fabs(is - at) < 1e-9));
        at = gone_to(text, at, k[_i].words);
        ck_assert_msg(fabs(at - is) < 2e-9 * (1 + fabs(is)), "%s: %.4f, not %.4f", text, at, is);
    }
}
END_TEST

/* An axis with an end has the angle as it is, whatever the key says; ten turns are no end. */
START_TEST(ends_of_travel)
{
    for (int more = 0; more < 2; more++) {
        nc_forget(&p.w, NC_X, NC_F);
        machine.rotary_words = ROTARY_WITHIN;
        machine.chain.rotary[0].min = RADIANS(-1800);
        machine.chain.rotary[0].max = RADIANS(1800 + more);
        ck_assert_str_eq(turn(-30, 0), more ? "A0. C330." : "A0. C-30.");
    }
}
END_TEST

/* With tool centre point control switched on at zero the axes leave home at zero, or as near as
 * they can be. */
START_TEST(start)
{
    const struct nc_move move = {.q = {RADIANS(40), RADIANS(50)}};
    machine.rotary_words = ROTARY_PLAIN;
    machine.tcp_frame = TCP_FRAME_ZERO;
    machine.chain.rotary[1].min = RADIANS(5);
    ck_assert(nc_zero_first(&p));
    nc_rotary_start(&p, &move);
    ck_assert_str_eq(said(), "A5. C0.");
    machine.chain.rotary[1].min = RADIANS(-100);
    machine.chain.rotary[1].max = RADIANS(-7);
    nc_rotary_start(&p, &move);
    ck_assert_str_eq(said(), "A-7.");
    machine.tcp_frame = TCP_FRAME_STANDS;
    ck_assert(!nc_zero_first(&p));
    nc_rotary_start(&p, &move);
    ck_assert_str_eq(said(), "A50. C40.");
    machine.tcp_frame = TCP_FRAME_ZERO;
    plan.ability.tcp = false;
    ck_assert(!nc_zero_first(&p));
    plan.ability.tcp = true;
    machine.chain.n = 0;
    ck_assert(!nc_zero_first(&p));
}
END_TEST

/* A vector is said whole or not at all. */
START_TEST(vectors)
{
    static const char *const address[] = {"I", "J", "K"};
    struct nc_move move = {.vector = 0, .q = {RADIANS(40), RADIANS(50)}};
    *array_push(&plan.vector) = vec(0, 0.6, 0.8);
    *array_push(&plan.vector) = vec(0, 0.6, 0.8);
    *array_push(&plan.vector) = vec(0.5, 0.6, 0.8);
    *array_push(&plan.vector) = vec(0.5, 0.5, 0.8);
    *array_push(&plan.vector) = vec(0.5, 0.5, 0.7);
    plan.ability.mode = INTERPOLATE_VECTOR;
    static const char *const want[] = {"I0. J0.6 K0.8", "", "I0.5 J0.6 K0.8", "I0.5 J0.5 K0.8",
                                       "I0.5 J0.5 K0.7"};
    for (unsigned i = 0; i < 5; i++) {
        move.vector = i;
        nc_axis(&p, &move, address);
        ck_assert_str_eq(said(), want[i]);
    }
    plan.ability.mode = INTERPOLATE_ROTARY;
    nc_axis(&p, &move, address);
    ck_assert_str_eq(said(), "A50. C40.");
}
END_TEST

START_TEST(feeds)
{
    struct nc_move move = {.kind = NC_LINE, .feed = 500};
    nc_feed(&p, &move);
    ck_assert_str_eq(said(), "F500.");
    nc_feed(&p, &move);
    ck_assert_str_eq(said(), "");
    move.kind = NC_RAPID;
    move.feed = 700;
    nc_feed(&p, &move);
    ck_assert_str_eq(said(), "");
    move.kind = NC_ARC;
    nc_feed(&p, &move);
    ck_assert_str_eq(said(), "F700.");
    p.w.inverse = true; /* in each block */
    nc_feed(&p, &move);
    ck_assert_str_eq(said(), "F700.");
}
END_TEST

/* The offset of the n-th tool: its own, that of the largest number below, or the machine's. */
START_TEST(offsets)
{
    strcpy(machine.offset, "G54");
    ck_assert_str_eq(nc_work_offset(&p, 0), "");
    ck_assert_str_eq(nc_work_offset(&p, 3), "G54");
    strcpy(machine.tool_offset[1], "G55");
    strcpy(machine.tool_offset[MACHINE_OFFSETS - 1], "G59");
    static const struct {
        size_t n;
        const char *offset;
    } k[] = {{0, ""},     {1, "G54"},  {2, "G55"},  {3, "G55"},
             {19, "G55"}, {20, "G59"}, {21, "G59"}, {1000, "G59"}};
    for (size_t i = 0; i < sizeof k / sizeof *k; i++)
        ck_assert_str_eq(nc_work_offset(&p, k[i].n), k[i].offset);
}
END_TEST

static void add_tool(int number, const char *name)
{
    struct path_tool *tool = array_push(&path.tool);
    *tool = (struct path_tool){.number = number};
    strcpy(tool->name, name);
}

/* The next tool is that of the first change that is still to come. */
START_TEST(tools)
{
    add_tool(7, "SEVEN");
    add_tool(0, "");
    add_tool(9, "NINE");
    static const struct nc_move move[] = {{.kind = NC_PASS},
                                          {.kind = NC_TEXT, .index = 2},
                                          {.kind = NC_RAPID, .index = 3},
                                          {.kind = NC_TOOL, .index = 0},
                                          {.kind = NC_HOLE},
                                          {.kind = NC_TOOL, .index = 1},
                                          {.kind = NC_PLANE},
                                          {.kind = NC_TOOL, .index = 2},
                                          {.kind = NC_LINE}};
    static const int after[] = {7, 0, 9, 0};
    for (size_t i = 0; i < sizeof move / sizeof *move; i++)
        *array_push(&plan.move) = move[i];
    for (size_t taken = 0; taken < 4; taken++) {
        p.tooling.taken = taken;
        ck_assert_int_eq(nc_tool_after(&p), after[taken]);
    }
    static const size_t first[] = {2, 2, 2, 4, 4, 8, 8, 8, 8};
    for (size_t i = 0; i < sizeof first / sizeof *first; i++) {
        p.tooling.next = i;
        ck_assert_ptr_eq(nc_first_move(&p), &plan.move.item[first[i]]);
    }
}
END_TEST

START_TEST(names)
{
    add_tool(7, "SEVEN");
    add_tool(8, "");
    strcpy(path.head.tool_name, "FIRST");
    p.control = CONTROL_siemens;
    ck_assert_ptr_null(nc_tool_name(&p)); /* the machine has no names */
    machine.tool_names = true;
    ck_assert_str_eq(nc_tool_name(&p), "FIRST");
    p.tooling.taken = 1;
    p.tooling.number = 7;
    ck_assert_str_eq(nc_tool_name(&p), "SEVEN");
    p.tooling.taken = 2;
    p.tooling.number = 8;
    ck_assert_ptr_null(nc_tool_name(&p));
    machine.tools = 2; /* the machine's own name comes first, where it has one */
    machine.tool[0] = (struct machine_tool){.number = 8, .name = "EIGHT"};
    machine.tool[1] = (struct machine_tool){.number = 7, .name = ""};
    ck_assert_str_eq(nc_tool_name(&p), "EIGHT");
    p.tooling.taken = 1;
    p.tooling.number = 7;
    ck_assert_str_eq(nc_tool_name(&p), "SEVEN");
    p.control = CONTROL_fanuc; /* which calls none by its name */
    ck_assert_ptr_null(nc_tool_name(&p));
}
END_TEST

/* A place of a plane about X and the turned Y, by two matrices: b about Y, then a about X. */
START_TEST(above_a_plane)
{
    const double a = RADIANS(25), b = RADIANS(-40);
    struct nc_move move = {.p = {3, 4, 50}};
    *array_push(&p.planes) = (struct nc_plane){.axis = {0, 0, 1}};
    *array_push(&p.planes) = (struct nc_plane){.axis = {sin(b), -sin(a) * cos(b), cos(a) * cos(b)}};
    p.control = CONTROL_siemens;
    ck_assert_double_lt(vec_distance(nc_above_plane(&p, &move), move.p), 1e-12);
    p.at_plane = 1;
    struct vec3 t = {3 * cos(b) + 50 * sin(b), 4, -3 * sin(b) + 50 * cos(b)};
    struct vec3 want = {t.x, t.y * cos(a) - t.z * sin(a), t.y * sin(a) + t.z * cos(a)};
    ck_assert_double_lt(vec_distance(nc_above_plane(&p, &move), want), 1e-12);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_words");
    TCase *tests = tcase_create("post_words");
    SRunner *runner = srunner_create(suite);
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, places);
    tcase_add_test(tests, angles);
    tcase_add_loop_test(tests, turns_read_back, 0, 8);
    tcase_add_test(tests, ends_of_travel);
    tcase_add_test(tests, start);
    tcase_add_test(tests, vectors);
    tcase_add_test(tests, feeds);
    tcase_add_test(tests, offsets);
    tcase_add_test(tests, tools);
    tcase_add_test(tests, names);
    tcase_add_test(tests, above_a_plane);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
