/*
 * ncread_plane: the blocks of tilted planes of three controls against matrices of this file, and
 * what is said in a plane as it is in the work.
 */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "ncread/ncread_plane.h"
#include "ncread/ncread_state.h"

struct matrix {
    double m[3][3];
};

/* About the axis X, Y or Z of the frame that stands, a product is applied from the right. */
static struct matrix about(int axis, double degrees)
{
    double c = cos(RADIANS(degrees)), s = sin(RADIANS(degrees));
    int i = (axis + 1) % 3, j = (axis + 2) % 3;
    struct matrix r = {.m = {{0}}};
    r.m[axis][axis] = 1;
    r.m[i][i] = r.m[j][j] = c;
    r.m[i][j] = -s;
    r.m[j][i] = s;
    return r;
}

static struct matrix product(struct matrix a, struct matrix b)
{
    struct matrix r = {.m = {{0}}};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 3; k++)
                r.m[i][j] += a.m[i][k] * b.m[k][j];
    return r;
}

static struct vec3 turned(struct matrix a, struct vec3 v)
{
    return vec(a.m[0][0] * v.x + a.m[0][1] * v.y + a.m[0][2] * v.z,
               a.m[1][0] * v.x + a.m[1][1] * v.y + a.m[1][2] * v.z,
               a.m[2][0] * v.x + a.m[2][1] * v.y + a.m[2][2] * v.z);
}

static struct ncread_options options;
static struct nc_motion motion;
static struct ncread c;
static struct error error;

static void setup(void)
{
    options =
        (struct ncread_options){.tcp = true, .kinematics = verify_kinematics_trunnion('A', 1)};
    motion = (struct nc_motion){0};
    c = (struct ncread){
        .options = &options, .motion = &motion, .name = "p.nc", .line = 3, .block = -1};
    c.here = (struct ncread_place){
        .known = {true, true, true}, .turned = {true, true}, .has_axis = true};
}

static void teardown(void)
{
    array_free(&c.words);
    array_free(&c.pole_p);
    array_free(&c.pole_q);
    nc_motion_free(&motion);
}

enum { FANUC, SIEMENS, KLARTEXT };

static int run(int control, const char *text)
{
    c.text = text;
    if (control == SIEMENS)
        return ncread_plane_cycle800(&c, &error);
    if (control == KLARTEXT)
        return ncread_plane_spatial(&c, &error);
    ck_assert_int_eq(ncread_word_fanuc(text, &c.words, &error), 0);
    return ncread_plane_g(&c, &error);
}

/* What it says of a block that begins a plane: of Fanuc that its other words are its own. */
static int begins(int control)
{
    return control == FANUC ? 2 : 1;
}

static const struct {
    int control;
    const char *text;
    struct vec3 origin;
    int axis[3];
    double degrees[3];
} plane[] = {
    {FANUC, "G68.2 X1. Y-2. Z3. I30. J40. K-50.", {1, -2, 3}, {2, 0, 2}, {30, 40, -50}},
    {FANUC, "N10 G68.2 X0. Y0. Z0. I0. J90. K0.", {0, 0, 0}, {2, 0, 2}, {0, 90, 0}},
    {SIEMENS,
     "CYCLE800(4,\"TABLE\",200000,57,1,-2,3,30,40,-50,0,0,0,1,0,1)",
     {1, -2, 3},
     {0, 1, 2},
     {30, 40, -50}},
    {SIEMENS, "N5 CYCLE800(0,\"\",0,57,0,0,0,20)", {0, 0, 0}, {0, 1, 2}, {20, 0, 0}},
    {KLARTEXT,
     "7 PLANE SPATIAL SPA+30 SPB+40 SPC-50 TURN MB MAX FMAX",
     {0, 0, 0},
     {2, 1, 0},
     {-50, 40, 30}},
    {KLARTEXT,
     "7 PLANE SPATIAL SPA-20.5 SPB+0 SPC+0 MOVE DIST50",
     {0, 0, 0},
     {2, 1, 0},
     {0, 0, -20.5}},
};

/* The frame, and what is known of where the tool is in it: nothing. */
START_TEST(entered)
{
    struct matrix r = about(plane[_i].axis[0], plane[_i].degrees[0]);
    for (int i = 1; i < 3; i++)
        r = product(r, about(plane[_i].axis[i], plane[_i].degrees[i]));
    ck_assert_int_eq(run(plane[_i].control, plane[_i].text), begins(plane[_i].control));
    ck_assert(c.tilted.on);
    ck_assert_double_lt(vec_distance(c.tilted.origin, plane[_i].origin), 1e-15);
    ck_assert_double_lt(vec_distance(c.tilted.x, turned(r, vec(1, 0, 0))), 1e-14);
    ck_assert_double_lt(vec_distance(c.tilted.y, turned(r, vec(0, 1, 0))), 1e-14);
    ck_assert_double_lt(vec_distance(c.tilted.z, turned(r, vec(0, 0, 1))), 1e-14);
    for (int i = 0; i < 3; i++)
        ck_assert(!c.here.known[i]);
    ck_assert(!c.here.has_axis);
    /* not within itself */
    ck_assert_int_eq(run(plane[_i].control, plane[_i].text), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "p.nc:3: a tilted plane within another"));
}
END_TEST

START_TEST(not_under_tcp)
{
    c.tcp = true;
    ck_assert_int_eq(run(plane[_i].control, plane[_i].text), -1);
    ck_assert(!c.tilted.on);
}
END_TEST

/* Left: the frame is the work's, where the axes stand is not known; a machine without any has its
 * tool upright. */
START_TEST(left)
{
    static const char *const off[] = {"G69", "CYCLE800()", "8 PLANE RESET STAY"};
    static const int first[] = {0, 2, 4};
    for (int without = 0; without < 2; without++) {
        setup();
        if (without)
            options.kinematics.n = 0;
        ck_assert_int_eq(run(_i, plane[first[_i]].text), begins(_i));
        if (_i == FANUC)
            ck_assert_int_eq(run(_i, "G53.1"), 1);
        c.here = (struct ncread_place){
            .known = {true, true, true}, .turned = {true, true}, .has_axis = true};
        ck_assert_int_eq(run(_i, off[_i]), _i == FANUC ? 0 : 1);
        ck_assert(!c.tilted.on);
        ck_assert(!c.here.known[0] && !c.here.known[1] && !c.here.known[2]);
        ck_assert(!c.here.turned[0] && !c.here.turned[1]);
        ck_assert(c.here.has_axis == (without == 1));
        array_free(&c.words);
    }
}
END_TEST

/* G69 without a plane changes nothing; other blocks are none of these. */
START_TEST(others)
{
    ck_assert_int_eq(run(FANUC, "G69"), 0);
    ck_assert(c.here.known[0] && c.here.has_axis && c.here.turned[1]);
    ck_assert_int_eq(run(FANUC, "G1 X1. I2."), 0);
    ck_assert_int_lt(run(FANUC, "G69 G68.2 X0. Y0. Z0. I0. J0. K0."), 0);
    ck_assert_ptr_nonnull(strstr(error.text, "in one block"));
    ck_assert_int_eq(run(SIEMENS, "G1 X1 A3=1"), 0);
    ck_assert_int_eq(run(KLARTEXT, "L X+1 F100"), 0);
    ck_assert(!c.tilted.on && c.here.known[0]);
}
END_TEST

static const struct {
    int control;
    const char *text, *found;
} bad[] = {
    {FANUC, "G53.1", "G53.1 without G68.2"},
    {FANUC, "G68.2 X1. Y2. Z3. I0. J0.", "X Y Z I J K"},
    {FANUC, "G68.2 X1. Y2. Z3 I0. J0. K0.", "decimal points"},
    {SIEMENS, "CYCLE800(0,\"\",0,39,0,0,0,20,0,0)", "another mode than 57"},
    {SIEMENS, "CYCLE800(0,\"\",0", "another mode than 57"},
    {KLARTEXT, "PLANE SPATIAL SPA+30 SPB+40 TURN", "SPA SPB SPC"},
    {KLARTEXT, "PLANE SPATIAL SPA+30 SPB40 SPC+0 TURN", "with their signs"},
    {KLARTEXT, "PLANE SPATIAL SPA+ SPB+40 SPC+0 TURN", "with their signs"},
    {KLARTEXT, "PLANE SPATIAL SPA+30 SPB+40 SPC+0 STAY", "without TURN or MOVE"},
};

START_TEST(refused)
{
    ck_assert_int_eq(run(bad[_i].control, bad[_i].text), -1);
    ck_assert_msg(strstr(error.text, bad[_i].found) != NULL, "%s", error.text);
    ck_assert(!c.tilted.on);
}
END_TEST

static struct vec3 in_work(struct matrix r, struct vec3 origin, struct vec3 v)
{
    return vec_add(origin, turned(r, v));
}

/* A piece of each shape, said in the plane. */
START_TEST(pieces_in_the_work)
{
    struct matrix r = product(product(about(2, 30), about(0, 40)), about(2, -50));
    struct vec3 o = {1, -2, 3}, p0 = {4, 5, 6}, p1 = {-7, 8, 9}, up = {0, 0, 1};
    struct nc_piece piece = {.shape = (unsigned char)_i, .p = {p0, p1}, .q = {up, up}};
    *array_push(&motion.arc) = (struct nc_motion_arc){p0, up, 2};
    *array_push(&motion.arc) = (struct nc_motion_arc){p1, vec(0, 1, 0), 1.5};
    for (int k = 0; k < 2; k++)
        *array_push(&motion.polynomial) = (struct nc_motion_polynomial){
            .p = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {1, 0, 2}, {3, 2, 1}}};
    piece.index = 1;

    ncread_plane_turn(&c, &piece); /* no plane: as it was */
    ck_assert_double_lt(vec_distance(piece.p[1], p1), 1e-15);
    ck_assert_int_eq(run(FANUC, plane[0].text), 2);
    ncread_plane_turn(&c, &piece);
    ck_assert_double_lt(vec_distance(piece.p[0], in_work(r, o, p0)), 1e-13);
    ck_assert_double_lt(vec_distance(piece.p[1], in_work(r, o, p1)), 1e-13);
    for (int k = 0; k < 2; k++)
        ck_assert_double_lt(vec_distance(piece.q[k], turned(r, up)), 1e-14);
    /* the arc or polynomial of the piece, and no other */
    const struct nc_motion_arc *arc = motion.arc.item;
    bool is_arc = _i == SHAPE_ARC, is_sum = _i == SHAPE_POLYNOMIAL;
    ck_assert_double_lt(vec_distance(arc[0].centre, p0), 1e-15);
    ck_assert_double_lt(vec_distance(arc[1].centre, is_arc ? in_work(r, o, p1) : p1), 1e-13);
    ck_assert_double_lt(
        vec_distance(arc[1].normal, is_arc ? turned(r, vec(0, 1, 0)) : vec(0, 1, 0)), 1e-14);
    ck_assert_double_eq(arc[1].angle, 1.5);
    for (int i = 0; i < NC_MOTION_DEGREE; i++) {
        struct vec3 was = motion.polynomial.item[0].p[i], is = motion.polynomial.item[1].p[i];
        ck_assert_double_lt(vec_distance(is, is_sum ? turned(r, was) : was), 1e-13);
    }
}
END_TEST

START_TEST(poles_in_the_work)
{
    struct matrix r = product(product(about(2, 30), about(0, 40)), about(2, -50));
    struct vec3 o = {1, -2, 3};
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 4; i++) {
            *array_push(&c.pole_p) = vec(i, 2 * i, 3 - i);
            *array_push(&c.pole_q) = vec(0, 0, 1);
        }
        c.spline.p[1] = vec(3, 6, 0);
        c.spline.q[1] = vec(0, 0, 1);
        ncread_plane_turn_poles(&c);
        for (int i = 0; i < 4; i++) {
            struct vec3 p = vec(i, 2 * i, 3 - i), q = vec(0, 0, 1);
            ck_assert_double_lt(vec_distance(c.pole_p.item[i], k ? in_work(r, o, p) : p), 1e-13);
            ck_assert_double_lt(vec_distance(c.pole_q.item[i], k ? turned(r, q) : q), 1e-14);
        }
        ck_assert_double_lt(vec_distance(c.spline.p[1], c.pole_p.item[3]), 1e-13);
        ck_assert_double_lt(vec_distance(c.spline.q[1], c.pole_q.item[3]), 1e-14);
        c.pole_p.n = c.pole_q.n = 0;
        if (k == 0)
            ck_assert_int_eq(run(FANUC, plane[0].text), 2);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("ncread_plane");
    TCase *tests = tcase_create("ncread_plane");
    SRunner *runner = srunner_create(suite);
    int planes = (int)(sizeof plane / sizeof *plane);
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_loop_test(tests, entered, 0, planes);
    tcase_add_loop_test(tests, not_under_tcp, 0, planes);
    tcase_add_loop_test(tests, left, 0, 3);
    tcase_add_test(tests, others);
    tcase_add_loop_test(tests, refused, 0, (int)(sizeof bad / sizeof *bad));
    tcase_add_loop_test(tests, pieces_in_the_work, 0, SHAPE_SPLINE);
    tcase_add_test(tests, poles_in_the_work);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
