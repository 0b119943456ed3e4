/* ncread_state, ncread_gcode: arcs of every kind against their circles, what a move needs before it
 * cuts, where one goes from the dark, block numbers, and the words of G code. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ncread/ncread_gcode.h"
#include "reading.h"

/* In a cut, at 10 0 5 with the axis upright; no rotary axes. */
static void setup(void)
{
    reading_begin();
    c.line = 7;
    c.block = c.last_block = -1;
    c.plane = 17;
    c.unit = 1;
    c.absolute = c.said = c.spindle = c.length = true;
    c.feed = 300;
    c.move = MOVE_LINE;
    c.here = (struct ncread_place){
        .known = {true, true, true}, .at = {10, 0, 5}, .has_axis = true, .axis = {0, 0, 1}};
}

static struct ncread_place to(double x, double y, double z)
{
    struct ncread_place place = c.here;
    place.at[0] = x, place.at[1] = y, place.at[2] = z;
    return place;
}

static void says(const char *what)
{
    ck_assert_msg(strstr(error.text, what) != NULL, "%s, not %s", error.text, what);
}

static const struct nc_motion_arc *arc_of(const struct nc_piece *piece)
{
    ck_assert_int_eq(piece->shape, SHAPE_ARC);
    return &motion.arc.item[piece->index];
}

static void arc_is(const struct nc_piece *piece, struct vec3 centre, struct vec3 normal,
                   double turn)
{
    const struct nc_motion_arc *arc = arc_of(piece);
    ck_assert_double_lt(vec_distance(arc->centre, centre), 1e-9);
    ck_assert_double_lt(vec_distance(arc->normal, normal), 1e-9);
    ck_assert_double_eq_tol(arc->angle, turn * 2 * PI, 1e-9);
}

/* About the origin, a quarter turn, three quarters, whole ones; in each plane. */
START_TEST(arcs_by_centre)
{
    struct ncread_place place = to(0, 10, 5);
    struct nc_piece piece = ncread_piece(&c, &place);
    const struct vec3 zero = {0, 0, 0}, z = {0, 0, 1};
    ck_assert_int_eq(ncread_arc(&c, &piece, zero, true, &error), 0);
    arc_is(&piece, zero, z, 0.25);
    ck_assert_int_eq(ncread_arc(&c, &piece, zero, false, &error), 0);
    arc_is(&piece, zero, z, -0.75);
    piece.p[1] = piece.p[0];
    ck_assert_int_eq(ncread_arc(&c, &piece, zero, true, &error), 0);
    arc_is(&piece, zero, z, 1);
    ck_assert_int_eq(ncread_arc(&c, &piece, zero, false, &error), 0);
    arc_is(&piece, zero, z, -1);
    /* G18: from z over x, as seen from y */
    c.plane = 18;
    piece.p[0] = vec(0, 3, 10), piece.p[1] = vec(10, 3, 0);
    ck_assert_int_eq(ncread_arc(&c, &piece, vec(0, 3, 0), true, &error), 0);
    arc_is(&piece, vec(0, 3, 0), vec(0, 1, 0), 0.25);
    c.plane = 19;
    piece.p[0] = vec(3, 10, 0), piece.p[1] = vec(3, 0, 10);
    ck_assert_int_eq(ncread_arc(&c, &piece, vec(3, 0, 0), true, &error), 0);
    arc_is(&piece, vec(3, 0, 0), vec(1, 0, 0), 0.25);
    piece.p[1] = vec(3, 0, 10.0049); /* so much is rounding */
    ck_assert_int_eq(ncread_arc(&c, &piece, vec(3, 0, 0), true, &error), 0);
    piece.p[1] = vec(3, 0, 10.0051);
    ck_assert_int_eq(ncread_arc(&c, &piece, vec(3, 0, 0), true, &error), -1);
    says("not at one distance");
    c.unit = INCH; /* and less of an inch */
    piece.p[1] = vec(3, 0, 10.001);
    ck_assert_int_eq(ncread_arc(&c, &piece, vec(3, 0, 0), true, &error), -1);
    piece.p[1] = piece.p[0];
    ck_assert_int_eq(ncread_arc(&c, &piece, piece.p[0], true, &error), -1);
    c.inverse_time = true;
    ck_assert_int_eq(ncread_arc(&c, &piece, vec(3, 0, 0), true, &error), -1);
    says("inverse time");
}
END_TEST

/* R 10: the short way with R above zero, the long one below; both ways round. */
START_TEST(arcs_by_radius)
{
    struct ncread_place place = to(0, 10, 5);
    static const struct {
        double radius, turn;
        bool ccw;
        struct vec3 centre;
    } k[] = {{10, 0.25, true, {0, 0, 5}},
             {10, -0.25, false, {10, 10, 5}},
             {-10, 0.75, true, {10, 10, 5}},
             {-10, -0.75, false, {0, 0, 5}}};
    for (size_t i = 0; i < 4; i++) {
        struct nc_piece piece = ncread_piece(&c, &place);
        ck_assert_int_eq(ncread_arc_radius(&c, &piece, k[i].radius, k[i].ccw, &error), 0);
        arc_is(&piece, k[i].centre, vec(0, 0, 1), k[i].turn);
    }
    struct nc_piece piece = ncread_piece(&c, &place);
    ck_assert_int_eq(ncread_arc_radius(&c, &piece, 7.069, true, &error), 0); /* 7.0711 and 0.005 */
    arc_is(&piece, vec(5, 5, 5), vec(0, 0, 1), 0.5);
    ck_assert_int_eq(ncread_arc_radius(&c, &piece, 7.06, true, &error), -1);
    says("further apart than its diameter");
    piece.p[1] = piece.p[0];
    ck_assert_int_eq(ncread_arc_radius(&c, &piece, 7, true, &error), -1);
    says("whose ends coincide");
}
END_TEST

/* On a circle of radius 5 about 1 2 3 in a tilted plane, by thirds and by seven eighths. */
START_TEST(arcs_through_a_point)
{
    struct vec3 centre = vec(1, 2, 3), n = vec_unit(vec(1, 2, 2)), u = vec_unit(vec(2, -1, 0));
    static const double turn[] = {0.3, 0.5, 0.875};
    for (size_t i = 0; i < 3; i++) {
        struct nc_piece piece = {
            .p = {vec_along(centre, 5, u), vec_along(centre, 5, vec_turn(u, n, 2 * PI * turn[i]))}};
        struct vec3 middle = vec_along(centre, 5, vec_turn(u, n, 2 * PI * turn[i] / 3));
        ck_assert_int_eq(ncread_arc_through(&c, &piece, middle, &error), 0);
        arc_is(&piece, centre, n, turn[i]);
    }
    struct nc_piece piece = {.p = {{0, 0, 0}, {2, 2, 2}}};
    ck_assert_int_eq(ncread_arc_through(&c, &piece, vec(1, 1, 1), &error), -1);
    says("lie on a line");
}
END_TEST

static void cut_fails(const char *what)
{
    struct ncread_place place = to(0, 10, 5);
    size_t n = motion.piece.n;
    ck_assert_int_eq(ncread_go(&c, &place, ncread_piece(&c, &place), false, &error), -1);
    says(what);
    ck_assert_uint_eq(motion.piece.n, n);
    reading_end();
    setup();
}

START_TEST(before_a_cut)
{
    struct ncread_place place = to(0, 10, 5);
    ck_assert_int_eq(ncread_go(&c, &place, ncread_piece(&c, &place), false, &error), 0);
    ck_assert_uint_eq(motion.piece.n, 1);
    ck_assert_uint_eq(motion.lines, 1);
    ck_assert(!motion.piece.item[0].rapid);
    ck_assert_double_eq(motion.piece.item[0].feed, 300);
    ck_assert_uint_eq(motion.piece.item[0].line, 7);
    ck_assert_double_eq(c.here.at[1], 10);
    c.said = false;
    cut_fails("p.nc:7: cuts before its unit");
    c.unit = 0;
    cut_fails("cuts before its unit");
    c.spindle = false;
    cut_fails("spindle is off");
    c.feed = 0;
    cut_fails("without a feed");
    c.inverse_time = true;
    cut_fails("no F in a block under inverse time");
    c.here.known[1] = false;
    c.block = 30;
    cut_fails("p.nc:7: N30: cuts from a place or with an axis that is not known");
    c.here.has_axis = false;
    cut_fails("not known");
    options.tcp = true;
    options.kinematics.n = 1;
    c.here.turned[0] = true;
    c.here.turn[0] = 5;
    cut_fails("without tool centre point control");
    options.kinematics.n = 1;
    cut_fails("rotary axes whose place is not known");
}
END_TEST

/* At rapid all of that is no matter; from the dark only the end is known. */
START_TEST(rapid_moves)
{
    struct ncread_place place = to(0, 10, 5);
    c.spindle = c.said = false;
    c.here.known[0] = place.known[0] = false;
    ck_assert_int_eq(ncread_go(&c, &place, ncread_piece(&c, &place), true, &error), 0);
    ck_assert_uint_eq(motion.piece.n, 0); /* nor is this end */
    place.known[0] = true;
    ck_assert_int_eq(ncread_go(&c, &place, ncread_piece(&c, &place), true, &error), 0);
    ck_assert_uint_eq(motion.piece.n, 1);
    ck_assert(motion.piece.item[0].rapid);
    ck_assert_double_eq(vec_distance(motion.piece.item[0].p[0], vec(0, 10, 5)), 0);
    place = to(4, 4, 4);
    ck_assert_int_eq(ncread_go(&c, &place, ncread_piece(&c, &place), true, &error), 0);
    ck_assert_double_eq(vec_distance(motion.piece.item[1].p[0], vec(0, 10, 5)), 0);
    ck_assert_double_eq(vec_distance(motion.piece.item[1].p[1], vec(4, 4, 4)), 0);
    ck_assert_uint_eq(motion.lines, 0);
    /* turned without the control following: the tip is nobody knows where */
    options.tcp = true;
    options.kinematics.n = 1;
    place.turned[0] = true;
    place.turn[0] = 30;
    c.here = place;
    ck_assert_int_eq(ncread_go(&c, &place, ncread_piece(&c, &place), true, &error), 0);
    ck_assert_uint_eq(motion.piece.n, 2);
    ck_assert(!c.here.known[0] && !c.here.known[1] && !c.here.known[2]);
}
END_TEST

START_TEST(numbers_of_blocks)
{
    struct ncread_head head = {.numbered = true};
    ck_assert_int_eq(ncread_block(&c, 10, &error), 0);
    ck_assert_int_eq(ncread_block(&c, 10, &error), -1);
    says("its number does not rise");
    ck_assert_int_eq(ncread_block(&c, 20, &error), 0);
    ck_assert_int_eq(ncread_block(&c, 50, &error), 0); /* of others nothing is expected */
    ck_assert_uint_eq(motion.remark.n, 0);
    options.head = &head;
    ck_assert_int_eq(ncread_block(&c, 60, &error), 0);
    ck_assert_int_eq(ncread_block(&c, 70, &error), 0);
    ck_assert_uint_eq(motion.remark.n, 0);
    ck_assert_int_eq(ncread_block(&c, 90, &error), 0);
    ck_assert_uint_eq(motion.remark.n, 1);
    ck_assert_ptr_nonnull(strstr(motion.remark.item[0].text, "N80 before it is missing"));
    ck_assert_int_eq(ncread_block(&c, 9899, &error), 0);
    ck_assert_int_eq(ncread_block(&c, 10, &error), -1);
    ck_assert_int_eq(ncread_block(&c, 9900, &error), 0);
    size_t told = motion.remark.n;
    ck_assert_int_eq(ncread_block(&c, 100, &error), 0); /* begins anew */
    ck_assert_uint_eq(motion.remark.n, told);
}
END_TEST

/* An error names the block, also one that is number 0; -1 is none. */
START_TEST(errors_name_the_block)
{
    static const struct {
        long block;
        const char *said;
    } row[] = {{-1, ":7: what it is"}, {0, ":7: N0: what it is"}, {120, ":7: N120: what it is"}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        c.block = row[i].block;
        ck_assert_int_eq(ncread_error(&c, &error, "what it is"), -1);
        says(row[i].said);
    }
}
END_TEST

START_TEST(modal_words)
{
    static const int plain[] = {400, 540, 593, 640, 800}, none[] = {50, 90, 280, 430, 830, 1540};
    for (int tenths = 0; tenths <= 30; tenths += 10) {
        ck_assert_int_eq(ncread_gcode_g(&c, tenths, &error), 1);
        ck_assert_int_eq(c.move, tenths / 10);
    }
    for (int plane = 17; plane <= 19; plane++) {
        ck_assert_int_eq(ncread_gcode_g(&c, 10 * plane, &error), 1);
        ck_assert_int_eq(c.plane, plane);
    }
    c.said = false;
    ck_assert_int_eq(ncread_gcode_g(&c, 910, &error), 1);
    ck_assert(!c.absolute && c.said);
    ncread_gcode_g(&c, 900, &error);
    ck_assert(c.absolute);
    ncread_gcode_g(&c, 901, &error);
    ck_assert(c.absolute_centre && c.absolute);
    ncread_gcode_g(&c, 911, &error);
    ck_assert(!c.absolute_centre && c.absolute);
    ncread_gcode_g(&c, 930, &error);
    ck_assert(c.inverse_time);
    ncread_gcode_g(&c, 940, &error);
    ck_assert(!c.inverse_time);
    ck_assert_int_eq(ncread_gcode_g(&c, 410, &error), 0);
    options.cutcom = true;
    ck_assert_int_eq(ncread_gcode_g(&c, 410, &error), 1);
    ck_assert_int_eq(ncread_gcode_g(&c, 420, &error), 1);
    for (size_t i = 0; i < sizeof plain / sizeof *plain; i++)
        ck_assert_int_eq(ncread_gcode_g(&c, plain[i], &error), 1);
    ck_assert(!c.setting);
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        ck_assert_int_eq(ncread_gcode_g(&c, none[i], &error), 0);
    c.unit = 0;
    ck_assert_int_eq(ncread_gcode_g(&c, 200, &error), 1);
    ck_assert_double_eq(c.unit, 25.4);
}
END_TEST

static struct gcode_block block_of(const char *text)
{
    struct gcode_block b = {.to = c.here};
    ck_assert_int_eq(ncread_word_fanuc(text, &c.words, &error), 0);
    for (size_t i = 0; i < c.words.n; i++)
        ck_assert(ncread_gcode_address(&c, &c.words.item[i], &b));
    return b;
}

START_TEST(addresses)
{
    struct gcode_block b = block_of("X1.5 Z-2. F450.");
    ck_assert(b.named && b.moved && !b.radius_named && !ncread_gcode_centred(&b));
    ck_assert(b.to.at[0] == 1.5 && b.to.at[1] == 0 && b.to.at[2] == -2);
    ck_assert(c.feed == 450 && c.feed_here);
    b = block_of("X0.");
    ck_assert(b.named && !b.moved);
    c.absolute = false; /* from where it is */
    b = block_of("X1.5 Z-2.");
    ck_assert(b.to.at[0] == 11.5 && b.to.at[1] == 0 && b.to.at[2] == 3);
    b.machine = true;
    ncread_gcode_address(&c, &c.words.item[0], &b);
    ck_assert_double_eq(b.to.at[0], 1.5);
    c.absolute = true;
    b = block_of("I1. K3. R7.");
    ck_assert(!b.named && b.radius_named && b.radius == 7 && ncread_gcode_centred(&b));
    ck_assert(b.centre_named[0] && !b.centre_named[1] && b.centre_named[2] && b.centre[2] == 3);
    /* the centre from where it is, or where named from the zero */
    struct nc_piece piece = {.p = {{10, 20, 30}}};
    ck_assert_double_eq(vec_distance(ncread_gcode_centre(&c, &b, &piece), vec(11, 20, 33)), 0);
    c.absolute_centre = true;
    ck_assert_double_eq(vec_distance(ncread_gcode_centre(&c, &b, &piece), vec(1, 20, 3)), 0);
    /* an arc of a whole turn names no place, a line must */
    ck_assert(!ncread_gcode_goes(&c, &b));
    c.move = MOVE_CW;
    ck_assert(ncread_gcode_goes(&c, &b));
    c.move = MOVE_CCW;
    ck_assert(ncread_gcode_goes(&c, &b));
    c.vectors = true;
    ck_assert(!ncread_gcode_goes(&c, &b));
    c.vectors = false;
    c.setting = true;
    ck_assert(!ncread_gcode_goes(&c, &b));
    struct ncread_word p = {.name = "P", .value = {3}};
    ck_assert(ncread_gcode_address(&c, &p, &b));
    c.setting = false;
    ck_assert(!ncread_gcode_address(&c, &p, &b));
    /* the axes of a move in the machine's frame are not known after it */
    block_of("X1. Z2.");
    ncread_gcode_forget(&c);
    ck_assert(!c.here.known[0] && c.here.known[1] && !c.here.known[2]);
}
END_TEST

START_TEST(statements)
{
    options.words = "{hash}RTCP ON: tcp | {hash}RTCP OFF: tcp.off";
    ck_assert_int_eq(ncread_gcode_statement(&c, "N10 #RTCP ON (follow)", &error), 1);
    ck_assert(c.tcp);
    ck_assert_int_eq(ncread_gcode_statement(&c, "#RTCP OFF", &error), 1);
    ck_assert(!c.tcp);
    ck_assert_int_eq(ncread_gcode_statement(&c, "#RTCP", &error), 0);
    ck_assert_int_eq(ncread_gcode_statement(&c, "N10 G1 X1", &error), 0);
    ck_assert_int_eq(ncread_gcode_statement(&c, "(#RTCP ON)", &error), 0);
}
END_TEST

static void words_of(const char *line)
{
    c.words.n = 0;
    ck_assert_int_eq(ncread_word_fanuc(line, &c.words, &error), 0);
}

/* A G that nobody knows may move the tool, mirror or turn, with a place in the block or without; an
 * M is its machine maker's. */
START_TEST(words_that_nobody_knows)
{
    static const char *const places[] = {"X", "Y", "Z", "A", "B", "C"};
    char text[40];
    for (int i = 0; i < 6; i++) {
        snprintf(text, sizeof text, "G333 Q1. %s2.", places[i]);
        words_of(text);
        ck_assert_int_lt(ncread_unknown(&c, &c.words.item[0], &error), 0);
        says("found G333 with a place");
    }
    ck_assert(!c.setting);
    words_of("M333 X1.");
    ck_assert_int_eq(ncread_unknown(&c, &c.words.item[0], &error), 0);
    ck_assert(!c.setting);
    words_of("G333 Q1. P2. R3.");
    ck_assert_int_lt(ncread_unknown(&c, &c.words.item[0], &error), 0);
    says("found G333, which this reader does not know");
    ck_assert(!c.setting);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("ncread_state");
    TCase *tests = tcase_create("ncread_state");
    tcase_add_checked_fixture(tests, setup, reading_end);
    tcase_add_test(tests, arcs_by_centre);
    tcase_add_test(tests, arcs_by_radius);
    tcase_add_test(tests, arcs_through_a_point);
    tcase_add_test(tests, before_a_cut);
    tcase_add_test(tests, rapid_moves);
    tcase_add_test(tests, numbers_of_blocks);
    tcase_add_test(tests, errors_name_the_block);
    tcase_add_test(tests, modal_words);
    tcase_add_test(tests, addresses);
    tcase_add_test(tests, statements);
    tcase_add_test(tests, words_that_nobody_knows);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
