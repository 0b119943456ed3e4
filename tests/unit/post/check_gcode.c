/*
 * gcode: random moves as blocks of G-code for every control that has them, read back word by word
 * by a modal reader of this file: they end where the moves end, rounded, and say no word twice.
 */
#include <check.h>
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "chains.h"
#include "post/gcode.h"
#include "post/post_template.h"

static const char *const vector[] = {"I", "J", "K"};

/* What a control that reads the blocks knows. */
struct state {
    double word[128]; /* by address */
    int motion, plane;
    bool inverse, said[128];
};

/* The block that was written last: its words into the state. */
static void read_block(struct state *s, const char *text)
{
    memset(s->said, 0, sizeof s->said);
    while (*text != '\n') {
        char address = *text++, *end;
        ck_assert_msg(isupper((unsigned char)address), "%.40s", text - 1);
        bool direct = strncmp(text, "=DC(", 4) == 0; /* within a turn, the shortest way there */
        double value = strtod(text += direct ? 4 : 0, &end);
        ck_assert_ptr_ne(text, end);
        ck_assert(!direct || (value >= 0 && value < 360 && *end++ == ')'));
        if (direct) /* the shortest way from where the axis stands */
            value = s->word[(int)address] + remainder(value - s->word[(int)address], 360);
        text = end + strspn(end, " ");
        if (address == 'G' && value <= 3)
            s->motion = (int)value;
        else if (address == 'G' && value >= 17 && value <= 19)
            s->plane = (int)value;
        else if (address == 'G')
            s->inverse = value == 93 ? true : value == 94 ? false : s->inverse;
        else
            ck_assert(!s->said[(int)address]);
        if (address != 'G')
            s->said[(int)address] = true;
        if (address != 'G')
            s->word[(int)address] = value;
    }
}

/* A program of one kind of control on the default machine. */
static void begin(struct nc_program *p, enum control_id control, struct machine *m,
                  struct nc_plan *plan, enum interpolation_mode mode)
{
    struct error error;
    *m = machine_default();
    ck_assert_int_eq(machine_control(m, control_row(control)->name, &error), 0);
    ck_assert_int_eq(machine_finish(m, &error), 0);
    *plan = (struct nc_plan){.ability = {.mode = mode, .unit = 1, .digits = {3, 3, 6, 3, 1}}};
    *p = (struct nc_program){.control = control, .machine = m, .plan = plan};
    nc_writer_begin(&p->w, NULL, nc_format_of(m), 0, 99999);
}

static double rounded(double x, double unit)
{
    return unit * round(x / unit);
}

START_TEST(straight)
{
    static const enum control_id control[] = {CONTROL_fanuc, CONTROL_linuxcnc, CONTROL_siemens};
    struct machine m;
    struct nc_plan plan;
    struct nc_program p;
    struct state s = {.word = {0}};
    int shorter = 0;
    seed = 800 + (uint64_t)_i;
    begin(&p, control[_i], &m, &plan, INTERPOLATE_ROTARY);
    plan.ability.feeds = _i == 1 ? NC_FEEDS_INVERSE : NC_FEEDS_TIP;
    struct nc_move move = {.p = {1, 2, 3}, .q = {0.1, 0.2}, .feed = 100};
    for (int i = 0; i < 2000; i++) {
        size_t blocks = p.w.blocks;
        move.kind = chance() < 0.3 ? NC_RAPID : NC_LINE;
        if (chance() < 0.6)
            move.p = vec_along(move.p, 50 * chance() - 25, random_unit());
        if (chance() < 0.4)
            move.q[0] += chance() - 0.5, move.q[1] = chance() - 0.5;
        if (chance() < 0.3)
            move.p.x = move.p.x > 0 ? -1 : 1, move.feed = 10 + round(1e5 * chance()) / 10;
        gcode_straight(&p, &move, vector);
        bool modal_only = p.w.blocks == blocks; /* nothing new to say: no block */
        if (!modal_only)
            read_block(&s, p.w.own);
        ck_assert_int_eq(s.motion, move.kind == NC_RAPID ? 0 : 1);
        ck_assert_double_eq_tol(s.word['X'], rounded(move.p.x, 1e-3), 1e-9);
        ck_assert_double_eq_tol(s.word['Y'], rounded(move.p.y, 1e-3), 1e-9);
        ck_assert_double_eq_tol(s.word['Z'], rounded(move.p.z, 1e-3), 1e-9);
        ck_assert_double_eq_tol(s.word['C'], rounded(DEGREES(move.q[0]), 1e-3), 1e-9);
        ck_assert_double_eq_tol(s.word['A'], rounded(DEGREES(move.q[1]), 1e-3), 1e-9);
        if (move.kind == NC_LINE) {
            ck_assert_double_eq_tol(s.word['F'], move.feed, 0.05001);
            ck_assert_int_eq(s.inverse, plan.ability.feeds == NC_FEEDS_INVERSE);
            ck_assert(!s.inverse || s.said['F']); /* inverse time: F in each block */
        }
        shorter += !s.said['C'];
    }
    ck_assert_int_gt(shorter, 500);
    if (plan.ability.feeds == NC_FEEDS_INVERSE) {
        nc_template(&p, "{?inverse}G94");
        read_block(&s, p.w.own);
        ck_assert(!s.inverse);
    }
}
END_TEST

/* The vector whole or not at all. */
START_TEST(vectors)
{
    struct machine m;
    struct nc_plan plan;
    struct nc_program p;
    struct state s = {.word = {0}};
    begin(&p, CONTROL_fanuc, &m, &plan, INTERPOLATE_VECTOR);
    struct vec3 axis[] = {{0, 0, 1}, {0, 0.6, 0.8}, {0, 0.6, 0.8}, {0, -0.6, 0.8}};
    plan.vector.item = axis;
    for (unsigned i = 0; i < 4; i++) {
        struct nc_move move = {.kind = NC_LINE, .p = {i, 0, 0}, .vector = i, .feed = 100};
        gcode_straight(&p, &move, vector);
        read_block(&s, p.w.own);
        bool changes = i != 2;
        ck_assert_int_eq(s.said['I'], changes);
        ck_assert_int_eq(s.said['J'], changes);
        ck_assert_int_eq(s.said['K'], changes);
        ck_assert_double_eq(s.word['J'], axis[i].y);
        ck_assert(!s.said['C'] && !s.said['A']);
    }
}
END_TEST

/* An arc from where the tool stands, as the manual reads it: radius at both ends, sense, plane. */
START_TEST(arcs)
{
    static const char in_plane[][3] = {"XY", "ZX", "YZ"}, offset[][3] = {"IJ", "KI", "JK"};
    seed = 820;
    for (int i = 0; i < 300; i++) {
        struct machine m;
        struct nc_plan plan;
        struct nc_program p;
        struct state s = {.plane = 17};
        int k = i % 3;
        bool full = i % 5 == 0;
        begin(&p, i % 2 ? CONTROL_fanuc : CONTROL_linuxcnc, &m, &plan, INTERPOLATE_ROTARY);
        p.w.plane = 17;
        double r = 1 + 40 * chance(), u = 2 * PI * chance(), v = full ? u : u + 1 + 4 * chance();
        double c[3] = {100 * chance(), -30 * chance(), 7};
        double from[3] = {c[0], c[1], c[2]}, to[3] = {c[0], c[1], c[2]};
        int a = (3 - k) % 3, b = (a + 1) % 3; /* XY, ZX, YZ */
        from[a] += r * cos(u), from[b] += r * sin(u);
        to[a] += r * cos(v), to[b] += r * sin(v);
        struct nc_arc arc = {.plane = 17 + k, .ccw = i % 4 < 2, .full = full};
        arc.centre = vec(c[0] - from[0], c[1] - from[1], c[2] - from[2]);
        plan.arc.item = &arc;
        struct nc_move start = {.kind = NC_LINE, .p = vec(from[0], from[1], from[2]), .feed = 100};
        struct nc_move move = {.kind = NC_ARC, .p = vec(to[0], to[1], to[2]), .feed = 100};
        gcode_straight(&p, &start, vector);
        read_block(&s, p.w.own);
        double x0 = s.word[(int)in_plane[k][0]], y0 = s.word[(int)in_plane[k][1]];
        gcode_arc(&p, &move);
        read_block(&s, p.w.own);
        ck_assert_int_eq(s.plane, 17 + k);
        ck_assert_int_eq(s.motion, arc.ccw ? 3 : 2);
        double cx = x0 + s.word[(int)offset[k][0]], cy = y0 + s.word[(int)offset[k][1]];
        double x1 = s.word[(int)in_plane[k][0]], y1 = s.word[(int)in_plane[k][1]];
        ck_assert_double_eq_tol(hypot(x0 - cx, y0 - cy), r, 2e-3);
        ck_assert_double_eq_tol(hypot(x1 - cx, y1 - cy), r, 2e-3);
        ck_assert_double_eq_tol(cx, c[a], 2e-3);
        ck_assert_double_eq_tol(cy, c[b], 2e-3);
        /* the end of a whole turn is named, or the control would not move */
        ck_assert(!full || (s.said[(int)in_plane[k][0]] && s.said[(int)in_plane[k][1]]));
        ck_assert(!s.said[k == 0 ? 'K' : k == 1 ? 'J' : 'I']);
    }
}
END_TEST

/* Seconds by the address that the control's manual gives them. */
START_TEST(dwell)
{
    struct machine m;
    struct nc_plan plan;
    struct nc_program p;
    begin(&p, CONTROL_fanuc, &m, &plan, INTERPOLATE_ROTARY);
    p.seconds = 2.5;
    nc_template(&p, m.blocks.dwell);
    ck_assert_int_eq(strncmp(p.w.own, "G4 X2.5\n", 8), 0);
    begin(&p, CONTROL_linuxcnc, &m, &plan, INTERPOLATE_ROTARY);
    p.seconds = 2.5;
    nc_template(&p, m.blocks.dwell);
    ck_assert_int_eq(strncmp(p.w.own, "G4 P2.5\n", 8), 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("gcode");
    TCase *tests = tcase_create("blocks");

    tcase_add_loop_test(tests, straight, 0, 3);
    tcase_add_test(tests, vectors);
    tcase_add_test(tests, arcs);
    tcase_add_test(tests, dwell);
    suite_add_tcase(suite, tests);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
