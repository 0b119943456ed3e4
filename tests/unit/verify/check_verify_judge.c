/*
 * verify_judge: a short program over one point, whose figures are set one at a time to either side
 * of what is allowed: what is said of it, at which block, and whether it is refused for it.
 */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "math/elementary.h"
#include "verify/verify_judge.h"

#define RADIUS 4.0

/* A rapid down beside the part, a cut along X over the point, a rapid up: N10, N20, N30. */
struct trial {
    struct nc_motion motion, path;
    struct vec3s part;
    struct verdict v;
};

static void move_to(struct nc_motion *motion, struct vec3 to, struct vec3 axis, bool rapid)
{
    size_t n = motion->piece.n;
    struct nc_piece *last = n > 0 ? &motion->piece.item[n - 1] : NULL;
    struct vec3 from = last ? last->p[1] : vec(-20, 0, 30), was = last ? last->q[1] : vec(0, 0, 1);
    *array_push(&motion->piece) = (struct nc_piece){.rapid = rapid,
                                                    .block = 10 * (int)(n + 1),
                                                    .line = n + 1,
                                                    .feed = 1000,
                                                    .p = {from, to},
                                                    .q = {was, axis}};
}

static void add_cut(struct trial *t, size_t piece, bool on)
{
    const struct nc_piece *p = &t->motion.piece.item[piece];
    *array_push(&t->v.cut) = (struct centre_segment){.a = vec_along(p->p[0], RADIUS, p->q[0]),
                                                     .b = vec_along(p->p[1], RADIUS, p->q[1]),
                                                     .s = {0, 1},
                                                     .piece = (unsigned)piece,
                                                     .on = on};
}

static struct nc_motion three_moves(double height)
{
    const struct vec3 up = {0, 0, 1};
    struct nc_motion m = {.name = "three", .kinematics.tool = {0, 0, 1}};
    move_to(&m, vec(-20, 0, height), up, true);
    move_to(&m, vec(20, 0, height), up, false);
    move_to(&m, vec(20, 0, 30), up, true);
    return m;
}

/* The ball is on the point in the middle of the cut, and nothing is wrong. */
static void trial_begin(struct trial *t)
{
    memset(t, 0, sizeof *t);
    t->motion = three_moves(0);
    *array_push(&t->part) = vec(5, 0, 0);
    t->v.program = (struct verify_program){.machine = "table-ac",
                                           .motion = &t->motion,
                                           .part = &t->part,
                                           .post = -1,
                                           .axis = -1,
                                           .made_for = ""};
    t->v.options = (struct verify_options){.radius = RADIUS,
                                           .tolerance = 0.01,
                                           .left = 0.05,
                                           .band = 1,
                                           .limits = {.rapid = {1e5, 1e5, 1e5, 1e5, 1e5, 1e5}},
                                           .threads = 1};
    t->v.asked = t->part.n;
    t->v.limit = 0.05;
    struct deviation_map *map = &t->v.map;
    map->points = 1;
    map->touch = 0.01;
    map->deviation = mem_alloc(1, sizeof *map->deviation);
    map->segment = mem_alloc(1, sizeof *map->segment);
    map->region = mem_alloc(1, 1);
    map->deviation[0] = 0;
    map->segment[0] = 0;
    map->region[0] = 1;
    add_cut(t, 1, true);
}

static void trial_free(struct trial *t)
{
    nc_motion_free(&t->motion);
    nc_motion_free(&t->path);
    array_free(&t->part);
    verdict_free(&t->v);
}

/* ---- figures */

static void as_it_is(struct verdict *v)
{
    (void)v;
}

static void deep(struct verdict *v)
{
    v->map.gouge = 0.0102;
}

static void deep_by_little(struct verdict *v)
{
    v->map.gouge = 0.010002;
}

static void deep_by_noise(struct verdict *v)
{
    v->map.gouge = 0.0102;
    v->noise = 0.001;
}

static void leave_in_region(struct verdict *v, double over)
{
    v->options.partial = true;
    v->map.over = v->map.deviation[0] = over;
    v->map.cut = 1;
}

static void region_left(struct verdict *v)
{
    leave_in_region(v, 0.0512);
}

/* All of the points may have more, but not so much more. */
static void region_left_share(struct verdict *v)
{
    leave_in_region(v, 0.0749);
    v->options.share = 1;
}

static void region_left_far(struct verdict *v)
{
    leave_in_region(v, 0.0751);
    v->options.share = 1;
}

static void region_left_by_noise(struct verdict *v)
{
    region_left(v);
    v->noise = 0.002;
}

static void part_left(struct verdict *v)
{
    v->coverage.sum[COVERAGE_LEFT] = (struct part_coverage_sum){1, 2.5, 0.4, 0};
}

static void part_left_by_little(struct verdict *v)
{
    v->coverage.sum[COVERAGE_LEFT] = (struct part_coverage_sum){1, 2.5, 0.043312, 0};
    v->limit = 0.043309;
}

static void part_left_share(struct verdict *v)
{
    part_left(v);
    v->options.share = 1;
}

static void part_left_not_judged(struct verdict *v)
{
    part_left(v);
    v->options.left = HUGE_VAL;
}

static void part_left_of_region(struct verdict *v)
{
    part_left(v);
    v->options.partial = true;
}

static void rapid_through(struct verdict *v)
{
    v->rapid = (struct verdict_rapid){.depth = 0.5, .points = 1, .point = 0, .piece = 2};
}

/* To 0 under a top of 2 that nobody is at, of a program of the suite's own and of another's. */
static void from_the_dark(struct verdict *v)
{
    struct nc_motion *motion = (struct nc_motion *)v->program.motion;
    motion->piece.item[0].p[1].x = -25; /* off the part */
    motion->piece.item[0].dark = true;
    ((struct vec3s *)v->program.part)->item[0].z = 2;
    v->program.post = 0;
}

static void from_the_dark_elsewhere(struct verdict *v)
{
    from_the_dark(v);
    v->program.post = -1;
}

static void from_the_dark_above(struct verdict *v)
{
    from_the_dark(v);
    ((struct nc_motion *)v->program.motion)->piece.item[0].p[1].z = 2;
}

static void ends_below(struct verdict *v)
{
    ((struct vec3s *)v->program.part)->item[0].z = 40;
    v->program.guarded = true;
}

static void ends_below_elsewhere(struct verdict *v)
{
    ends_below(v);
    v->program.guarded = false;
}

static void ends_above(struct verdict *v)
{
    ends_below(v);
    struct nc_motion *motion = (struct nc_motion *)v->program.motion;
    motion->piece.item[motion->piece.n - 1].p[1].z = 40;
}

static void outliers_gouged(struct verdict *v)
{
    v->outliers = (struct verdict_outliers){7, 2, 0.75, {1, 2, 3}};
}

static void steep_gouged(struct verdict *v)
{
    v->steep = (struct verdict_steep){0.25, 7, 1, {1, 2, 3}};
}

static void outliers_clear(struct verdict *v)
{
    v->outliers = (struct verdict_outliers){7, 0, 0, {1, 2, 3}};
}

static void ball_as_said(struct verdict *v)
{
    v->program.ball = RADIUS + 0.0009;
}

static void ball_other(struct verdict *v)
{
    v->program.ball = RADIUS + 0.0012;
}

static void machine_as_said(struct verdict *v)
{
    v->program.made_for = "Table AC, of a shop";
}

static void machine_other(struct verdict *v)
{
    v->program.made_for = "Table BC";
}

static struct holder_collision hit(double width, size_t piece)
{
    return (struct holder_collision){
        .depth = 0.25, .piece = piece, .at = {1, 2, 3}, .height = 9, .width = width, .pieces = 4};
}

static void shaft_in_part(struct verdict *v)
{
    v->part_holder = hit(RADIUS * 1.009, 1);
}

static void holder_in_part(struct verdict *v)
{
    v->part_holder = hit(RADIUS * 1.011, 0);
}

static void holder_in_stock(struct verdict *v)
{
    v->stock.holder = hit(20, 1);
}

static void ball_under(struct verdict *v)
{
    v->under = (struct under_scan){0.5, 1, {1, 2, 3}, 0, RADIUS, 3};
}

static void shaft_under(struct verdict *v)
{
    v->under = (struct under_scan){0.5, 2, {1, 2, 3}, 6, RADIUS, 3};
}

static void holder_under(struct verdict *v)
{
    v->under = (struct under_scan){0.5, 1, {1, 2, 3}, 60, 20, 3};
}

static void rapid_in_stock(struct verdict *v)
{
    v->stock.rapid = 0.125;
    v->stock.rapid_piece = 2;
    v->stock.rapid_at = vec(1, 2, 3);
    v->stock.rapids = 5;
}

static void axis_beyond(struct verdict *v)
{
    v->axes.beyond = 6;
    v->axes.travel = (struct axis_peak){-121.5, 3, 1};
}

static void axis_without_angles(struct verdict *v)
{
    v->axes.unreachable = 1;
    v->axes.unreachable_at = 1;
}

static void axis_fast(struct verdict *v)
{
    v->axes.fast = 2;
    v->axes.speed = (struct axis_peak){1.25, 5, 1};
}

static void axis_fast_strict(struct verdict *v)
{
    axis_fast(v);
    v->options.limits.strict = true;
}

static void unmet(struct verdict *v)
{
    v->program.unmet = 1;
    v->program.unmet_first = "meshnorm, 0.2 mm";
}

static void unmet_more(struct verdict *v)
{
    unmet(v);
    v->program.unmet = 2;
}

/* A way at rapid of so much by the head, of which `found` is in the program. */
static void way(struct verdict *v, double said, double found)
{
    v->program.rapid = said;
    v->axes.rapid_length = found;
}

static void rapid_missing(struct verdict *v)
{
    way(v, 206.7, 200.7);
}

static void rapid_as_said(struct verdict *v)
{
    way(v, 206.7, 206.61);
}

/* Two moves are rounded by no more than this: the head says a tenth. */
static void rapid_short(struct verdict *v)
{
    way(v, 206.7, 206.595);
}

/* Hundreds are, in sum: of 1,256 moves of a program it was 0.2 mm. */
static void rapid_of_many(struct verdict *v)
{
    for (int i = 0; i < 400; i++)
        move_to((struct nc_motion *)v->program.motion, vec(20, 0, 30 + i % 2), vec(0, 0, 1), true);
    way(v, 206.7, 206.25);
}

/* Six moves that are printed with two decimals. */
static void rapid_of_few_digits(struct verdict *v)
{
    v->options.digit = 0.01;
    for (int i = 0; i < 6; i++)
        move_to((struct nc_motion *)v->program.motion, vec(20, 0, 30 + i % 2), vec(0, 0, 1), true);
    way(v, 206.7, 206.54);
}

static void rapid_more(struct verdict *v)
{
    way(v, 206.7, 220);
}

static void rapid_not_said(struct verdict *v)
{
    way(v, 0, 200.7);
}

static void nothing_cut(struct verdict *v)
{
    v->cut.n = 0;
    v->map.region[0] = 0;
}

static void nothing_to_cut(struct verdict *v)
{
    nothing_cut(v);
    v->options.left = HUGE_VAL;
}

static void beyond_the_band(struct verdict *v)
{
    v->map.deviation[0] = 1.1;
}

static void within_the_band(struct verdict *v)
{
    v->map.deviation[0] = 0.9;
}

static void out_of_region(struct verdict *v)
{
    v->map.region[0] = 0;
}

static const struct {
    void (*set)(struct verdict *v);
    bool fault;
    const char *text; /* NULL: nothing is said */
} figures[] = {
    {as_it_is, false, NULL},
    {deep, true,
     "N20 (line 2): the ball is 0.0102 mm deep in the part at 5.000 0.000 0.000, "
     "tolerance 0.01"},
    {deep_by_little, true,
     "N20 (line 2): the ball is 0.010002 mm deep in the part at 5.000 0.000 0.000, "
     "tolerance 0.01"},
    {deep_by_noise, false, NULL},
    {region_left, true,
     "N20 (line 2): 0.0512 mm of material is left at 5.000 0.000 0.000, at most 0.05 (1 points of "
     "the region; 0 points may be)"},
    {region_left_by_noise, false, NULL},
    {region_left_share, false,
     "N20 (line 2): 0.0749 mm of material is left at 5.000 0.000 0.000, at most 0.05 (1 points of "
     "the region; 1 points may be)"},
    {region_left_far, true,
     "N20 (line 2): 0.0751 mm of material is left at 5.000 0.000 0.000, at most 0.075 (1 points of "
     "the region; 1 points may be)"},
    {part_left, true,
     "N20 (line 2): 0.4000 mm of material is left at 5.000 0.000 0.000, at most 0.05 (1 points, "
     "2.5 mm2 that the tool reaches; 0 points may be)"},
    {part_left_by_little, true,
     "N20 (line 2): 0.04331 mm of material is left at 5.000 0.000 0.000, at most 0.043309 (1 "
     "points, 2.5 mm2 that the tool reaches; 0 points may be)"},
    {part_left_share, false,
     "N20 (line 2): 0.4000 mm of material is left at 5.000 0.000 0.000, at most 0.05 (1 points, "
     "2.5 mm2 that the tool reaches; 1 points may be)"},
    {part_left_not_judged, false, NULL},
    {part_left_of_region, false, NULL},
    {rapid_through, true,
     "N30 (line 3): a rapid move goes 0.500 mm deep through the part at 5.000 0.000 0.000"},
    {from_the_dark, true,
     "N10 (line 1): a rapid move comes from a place that is not known to 2.000 mm below the part's "
     "top: an approach is missing"},
    {from_the_dark_elsewhere, false,
     "N10 (line 1): a rapid move comes from a place that is not known to 2.000 mm below the part's "
     "top: an approach is missing"},
    {from_the_dark_above, false, NULL},
    {ends_below, true,
     "N30 (line 3): the program ends 10.000 mm below the part's top: a retract is missing"},
    {rapid_missing, true,
     "its rapid moves are 200.7 mm long, and 206.7 by its head: a retract or an approach is "
     "missing"},
    {rapid_as_said, false, NULL},
    {rapid_short, true,
     "its rapid moves are 206.6 mm long, and 206.7 by its head: a retract or an approach is "
     "missing"},
    {rapid_of_many, false, NULL},
    {rapid_of_few_digits, false, NULL},
    {rapid_more, false, NULL},
    {rapid_not_said, false, NULL},
    {ends_below_elsewhere, false, NULL},
    {ends_above, false, NULL},
    {outliers_gouged, false,
     "the ball is up to 0.750 mm deep in 2 of 7 points taken for outliers, as at 1.000 2.000 "
     "3.000; they are not judged"},
    {outliers_clear, false, NULL},
    {steep_gouged, true,
     "N20 (line 2): the ball is 0.2500 mm deep between points of a steep flank at 1.000 2.000 "
     "3.000, "
     "tolerance 0.01"},
    {ball_as_said, false, NULL},
    {ball_other, true, "the program's head says a ball of radius 4.0012, it is judged with 4"},
    {machine_as_said, false, NULL},
    {machine_other, false,
     "the program's head says the machine Table BC, it is judged on table-ac (-m)"},
    {shaft_in_part, true,
     "N20 (line 2): the shaft goes 0.250 mm deep into the part at 1.000 2.000 3.000, 9.0 mm up the "
     "tool (blocks: 4)"},
    {holder_in_part, true,
     "N10 (line 1): the holder goes 0.250 mm deep into the part at 1.000 2.000 3.000, in a rapid "
     "move, 9.0 mm up the tool (blocks: 4)"},
    {holder_in_stock, true,
     "N20 (line 2): the holder goes 0.250 mm deep into the stock at 1.000 2.000 3.000, 9.0 mm up "
     "the tool (blocks: 4)"},
    {ball_under, true,
     "N20 (line 2): the ball goes 0.500 mm deep under the scan at 1.000 2.000 3.000 (blocks: 3)"},
    {shaft_under, true,
     "N30 (line 3): the shaft goes 0.500 mm deep under the scan at 1.000 2.000 3.000, in a rapid "
     "move (blocks: 3)"},
    {holder_under, true,
     "N20 (line 2): the holder goes 0.500 mm deep under the scan at 1.000 2.000 3.000 (blocks: 3)"},
    {rapid_in_stock, true,
     "N30 (line 3): a rapid move goes 0.125 mm deep into the stock at 1.000 2.000 3.000 (blocks: "
     "5)"},
    {axis_beyond, true, "N20 (line 2): axis A at -121.500 is beyond its travel (blocks: 6)"},
    {axis_without_angles, true, "N20 (line 2): a tool axis that the machine's axes cannot reach"},
    {axis_fast, false,
     "N20 (line 2): axis C would have to move at 1.25 of its largest speed (blocks: 2)"},
    {axis_fast_strict, true,
     "N20 (line 2): axis C would have to move at 1.25 of its largest speed (blocks: 2)"},
    {unmet, true, "its head says UNMET: meshnorm, 0.2 mm"},
    {unmet_more, true, "its head says UNMET: meshnorm, 0.2 mm, and more"},
    {nothing_cut, true, "N10 (line 1): nothing is cut, all moves are rapid"},
    {nothing_to_cut, false, "N10 (line 1): nothing is cut, all moves are rapid"},
    {beyond_the_band, true, "N10 (line 1): the ball comes near no point of the part"},
    {within_the_band, false, NULL},
    {out_of_region, true, "N10 (line 1): the ball comes near no point of the part"}};

/* That is said, and nothing else. */
static void check_said(const struct verdict *v, const char *text, bool fault)
{
    ck_assert_msg(v->finding.n == (text != NULL), "%zu findings: %s", v->finding.n,
                  v->finding.n > 0 ? v->finding.item[v->finding.n - 1].text : "");
    ck_assert_int_eq(verdict_refused(v), fault);
    if (text)
        ck_assert_str_eq(v->finding.item[0].text, text);
}

START_TEST(figures_on_either_side)
{
    struct trial t;
    trial_begin(&t);
    figures[_i].set(&t.v);
    verify_judge(&t.v);
    check_said(&t.v, figures[_i].text, figures[_i].fault);
    trial_free(&t);
}
END_TEST

/* Time that is given the other way round is kept by no control that slows down. */
START_TEST(inverse_feeds_are_not_slowed_down)
{
    struct trial t;
    trial_begin(&t);
    t.motion.piece.item[1].inverse = true;
    axis_fast(&t.v);
    verify_judge(&t.v);
    ck_assert(verdict_refused(&t.v));
    trial_free(&t);
}
END_TEST

START_TEST(remarks_of_the_reader)
{
    struct trial t;
    trial_begin(&t);
    *array_push(&t.motion.remark) = (struct nc_remark){.line = 2, .block = 20, .text = "M8 twice"};
    verify_judge(&t.v);
    check_said(&t.v, "N20 (line 2): M8 twice", true);
    trial_free(&t);
}
END_TEST

/* What each piece does, and the cuts between rapid moves counted. */
START_TEST(pieces_summed)
{
    struct trial t;
    trial_begin(&t);
    t.v.map.deviation[0] = -0.005;
    move_to(&t.motion, vec(0, 30, 30), vec(0, 0, 1), false);
    move_to(&t.motion, vec(0, 60, 30), vec(0, 0, 1), false);
    verify_judge(&t.v);
    const unsigned pass[] = {0, 1, 1, 2, 2};
    ck_assert_uint_eq(t.v.passes, 2);
    for (size_t i = 0; i < 5; i++) {
        ck_assert_uint_eq(t.v.piece[i].pass, pass[i]);
        ck_assert_double_eq_tol(t.v.piece[i].gouge, i == 1 ? 0.005 : 0, 1e-9);
        ck_assert(t.v.piece[i].over == 0);
    }
    trial_free(&t);
}
END_TEST

/* ---- motions */

/* Of the ball that is at the point where its tip is at 5 0 0: a move from `from` to `to` between
 * the cut and the last one. */
static const struct {
    struct vec3 from, to;
    const char *text; /* NULL: nothing is said */
} rapids[] = {
    {{20, 0, 30}, {5, 0, 0.02}, NULL},
    {{20, 0, 30}, {5, 0, 0.005}, "N50 (line 5): a rapid move ends on the part (blocks: 1)"},
    {{5, 0, 0}, {5, 0, 30}, NULL}, /* it leaves the part */
    {{5, 0, 0}, {5, 0, 0}, NULL},  /* and does not move at all */
    {{4.5, 0, 0.2},
     {5.5, 0, 0.2},
     "N50 (line 5): a rapid move goes along beside the part (blocks: 1)"},
    {{4.5, 0, 1.2}, {5.5, 0, 1.2}, NULL},   /* higher than a fifth of the radius */
    {{4.9, 0, 0.1}, {5.05, 0, 0.6}, NULL}}; /* up the tool */

START_TEST(rapids_at_the_part)
{
    struct trial t;
    trial_begin(&t);
    move_to(&t.motion, rapids[_i].from, vec(0, 0, 1), false); /* in the air, but for its end */
    move_to(&t.motion, rapids[_i].to, vec(0, 0, 1), true);
    move_to(&t.motion, vec(5, 0, 40), vec(0, 0, 1), true);
    verify_judge(&t.v);
    check_said(&t.v, rapids[_i].text, rapids[_i].text != NULL);
    trial_free(&t);
}
END_TEST

/* The point is a wall beside the ball whose tip is at 1 0 -4.  The cut ends at 1 0 `left`, the tool
 * leaves up to `up`, turns there, and comes down `aside` of that way at rapid. */
static const struct {
    double left, up, aside, lean;
    bool said;
} returns[] = {{-6, 30, 0, 0, false},   {-6, 30, 0.005, 0, false},
               {-6, 30, 0.02, 0, true}, {-4.5, 30, 0, 0, true}, /* too near to where it goes on */
               {-6, -5, 0, 0, true}, /* it did not leave by that way: higher up aside */
               {-6, 30, 0, 0.002, true}};

START_TEST(rapids_that_come_back)
{
    double up = returns[_i].up, lean = returns[_i].lean;
    struct vec3 z = vec(0, 0, 1), axis = vec(sin(lean), 0, cos(lean));
    struct trial t;
    trial_begin(&t);
    t.v.map.touch = 0.1;
    move_to(&t.motion, vec(1, 0, returns[_i].left), z, false);
    move_to(&t.motion, vec(1, 0, up), z, true);
    if (up < 0)
        move_to(&t.motion, vec(-3, 0, 30), z, true);
    move_to(&t.motion, vec(1 - returns[_i].aside, 0, 30), axis, true);
    size_t last = t.motion.piece.n;
    move_to(&t.motion, vec(1 - returns[_i].aside, 0, -4), axis, true);
    move_to(&t.motion, vec(1, 0, returns[_i].left), z, false);
    move_to(&t.motion, vec(1, 0, 30), z, true);
    verify_judge(&t.v);
    char text[100];
    snprintf(text, sizeof text, "N%zu (line %zu): a rapid move ends on the part (blocks: 1)",
             10 * (last + 1), last + 1);
    check_said(&t.v, returns[_i].said ? text : NULL, returns[_i].said);
    trial_free(&t);
}
END_TEST

/* Over points far apart a rapid move ends no farther off them than a ball on the part may be; then
 * the tool goes on at feed. */
static const struct {
    double up;
    struct vec3 on;
    bool said;
} plunges[] = {{0.3, {5, 0, 0}, false},      /* down the tool: it was off the part */
               {0.3, {5.1, 0, 0}, true},     /* aside */
               {0.15, {5, 0, 0}, true},      /* by less than tells */
               {0.3, {5, 0, 0.3}, true},     /* not at all */
               {0.05, {5, 0, -0.25}, true}}; /* into the part */

START_TEST(rapids_that_a_plunge_follows)
{
    const struct vec3 z = {0, 0, 1};
    struct trial t;
    trial_begin(&t);
    t.v.map.touch = 0.4;
    size_t last = t.motion.piece.n + 1;
    move_to(&t.motion, vec(5, 0, 30), z, true);
    move_to(&t.motion, vec(5, 0, plunges[_i].up), z, true);
    move_to(&t.motion, plunges[_i].on, z, false);
    move_to(&t.motion, vec(5, 0, 30), z, true);
    verify_judge(&t.v);
    char text[100];
    snprintf(text, sizeof text, "N%zu (line %zu): a rapid move ends on the part (blocks: 1)",
             10 * (last + 1), last + 1);
    check_said(&t.v, plunges[_i].said ? text : NULL, plunges[_i].said);
    trial_free(&t);
}
END_TEST

START_TEST(an_end_on_the_part)
{
    struct trial t;
    trial_begin(&t);
    move_to(&t.motion, vec(5, 0, 0.005), vec(0, 0, 1), false);
    verify_judge(&t.v);
    check_said(&t.v, "N40 (line 4): the program ends on the part: no retract follows", true);
    trial_free(&t);
}
END_TEST

/* A block of a cut that is a millimetre off the part, at rapid: on its course, or not. */
static const struct {
    double aside, up, after; /* its end and that of the next block, mm */
    bool said;
} alone[] = {{0, 0, 0, true},
             {0.3, 0, 0.6, true},
             {1, 0, 1, false},   /* at 45 degrees */
             {0, 3, 3, false},   /* up */
             {0, 0, -3, false}}; /* the cut goes on elsewhere */

START_TEST(a_block_at_rapid_on_the_course_of_a_cut)
{
    const struct vec3 z = {0, 0, 1};
    struct trial t;
    trial_begin(&t);
    move_to(&t.motion, vec(3, 0, 1), z, false);
    move_to(&t.motion, vec(4, 0, 1), z, false);
    move_to(&t.motion, vec(5, alone[_i].aside, 1 + alone[_i].up), z, true);
    move_to(&t.motion, vec(6, alone[_i].after, 1 + alone[_i].up), z, false);
    move_to(&t.motion, vec(6, 0, 30), z, true);
    verify_judge(&t.v);
    check_said(&t.v,
               alone[_i].said ? "N60 (line 6): a rapid move goes along beside the part (blocks: 1)"
                              : NULL,
               alone[_i].said);
    trial_free(&t);
}
END_TEST

/* The axis leans about Y by `out` degrees over `length` mm, then by `back` over as much. */
static const struct {
    double out, back, length;
    bool on, said;
} turns[] = {{20, -20, 0.3, true, true},
             {20, -11, 0.3, true, true},
             {20, -9, 0.3, true, false},   /* by less than half */
             {20, -20, 0.3, false, false}, /* in the air */
             {4.9, -4.9, 0.01, true, false},
             {20, -20, 0.47, true, false}, /* 0.349 rad, R 4: 1.396 mm of rolling, 0.93 of way */
             {20, -20, 0.46, true, true},  /* 1.5 times 0.92 is less than that */
             {20, 20, 0.3, true, false}};

START_TEST(turns_of_the_axis)
{
    struct trial t;
    trial_begin(&t);
    double lean = RADIANS(turns[_i].out), then = RADIANS(turns[_i].out + turns[_i].back);
    /* away from the point, so that no rapid move touches it */
    move_to(&t.motion, vec(60, 0, 30), vec(0, 0, 1), false);
    move_to(&t.motion, vec(60 + turns[_i].length, 0, 30), vec(sin(lean), 0, cos(lean)), false);
    move_to(&t.motion, vec(60 + 2 * turns[_i].length, 0, 30), vec(sin(then), 0, cos(then)), false);
    for (size_t i = 3; i < 6; i++)
        add_cut(&t, i, turns[_i].on);
    verify_judge(&t.v);
    char text[200];
    snprintf(text, sizeof text,
             "N60 (line 6): the tool axis swings out by %.3f degrees and back on the part (blocks: "
             "1)",
             turns[_i].out);
    check_said(&t.v, turns[_i].said ? text : NULL, turns[_i].said);
    trial_free(&t);
}
END_TEST

/* ---- a program against its path */

static const struct {
    double up, lean; /* of the path, mm and degrees */
    double post, axis;
    double feed; /* of the program, to the path's 1000 */
    bool contact, coolant;
    const char *text; /* NULL: nothing is said */
} paths[] = {
    {0, 0, -1, -1, 1000, false, false, NULL},
    {0.0075, 0, -1, -1, 1000, false, false, NULL},
    {0.0085, 0, -1, -1, 1000, false, false,
     "the program leaves out line 2 of the path, 0.0085 mm off it at "},
    {0.0085, 0, 0.0082, -1, 1000, false, false, NULL},
    {0.0085, 0, 0.0078, -1, 1000, false, false,
     "the program leaves out line 2 of the path, 0.0085 mm off it at "},
    {0, 0.24, -1, -1, 1000, false, false, NULL},
    {0, 0.26, -1, -1, 1000, false, false, "the tool axis is 0.260 degrees off the path's at "},
    {0, 0.26, -1, 0.255, 1000, false, false, NULL},
    {0, 0, -1, -1, 1490, false, false, NULL},
    {0.00804, 0, -1, -1, 1000, false, false, NULL}, /* all three are printed as the limit */
    {0, 0.2504, -1, -1, 1000, false, false, NULL},
    {0, 0, -1, -1, 1500.3, false, false, NULL},
    {0, 0, -1, -1, 1501, false, false, "the feed is 1.501 times the path's"},
    {0, 0, -1, -1, 1510, false, false, "the feed is 1.51 times the path's"},
    {0, 0, -1, -1, 1510, true, false, NULL},
    {0, 0, -1, -1, 51, false, false, NULL},
    {0, 0, -1, -1, 49, false, false, "the feed is 1/20.41 of the path's"},
    {0, 0, -1, -1, 49, true, false, NULL},
    {0, 0, -1, -1, 1000, false, true, "the path has coolant on, the program cuts without"}};

START_TEST(against_the_path)
{
    struct trial t;
    trial_begin(&t);
    t.path = three_moves(paths[_i].up);
    for (size_t i = 0; i < t.path.piece.n; i++)
        for (int k = 0; k < 2; k++)
            t.path.piece.item[i].q[k] =
                vec(0, sin(RADIANS(paths[_i].lean)), cos(RADIANS(paths[_i].lean)));
    t.path.coolant = paths[_i].coolant;
    t.motion.piece.item[1].feed = paths[_i].feed;
    t.v.program.path = &t.path;
    t.v.program.post = paths[_i].post;
    t.v.program.axis = paths[_i].axis;
    t.v.program.contact_feed = paths[_i].contact;
    verify_judge(&t.v);
    ck_assert_int_eq(verdict_refused(&t.v), paths[_i].text != NULL);
    bool said = paths[_i].text == NULL;
    for (size_t i = 0; i < t.v.finding.n; i++) {
        ck_assert_ptr_eq(strstr(t.v.finding.item[i].text, "N20 (line 2): "),
                         t.v.finding.item[i].text);
        said = said || strstr(t.v.finding.item[i].text, paths[_i].text);
    }
    ck_assert_msg(said, "%s", t.v.finding.n > 0 ? t.v.finding.item[0].text : "nothing");
    trial_free(&t);
}
END_TEST

static const struct {
    int turns;
    double speed;
    int tool, offset;
    const char *text; /* NULL: nothing is said */
} tools[] = {{1, 8000, 3, 7, NULL},
             {1, 8060, 3, 7, NULL},
             {0, 0, -1, 0, NULL},
             {-1, 8000, 3, 7, "the path turns the spindle clockwise, the program the other way"},
             {1, 8100, 3, 7, "the path's spindle turns at 8000, the program's at 8100"},
             {1, 0, 3, 7, "the path's spindle turns at 8000, the program says no speed"},
             {1, 8000, 7, 7, "the path is for tool 3, the program takes tool 7"},
             {1, 8000, 3, 3, "the path is for the length H7, the program switches on H3"}};

/* What the first cut is made with. */
START_TEST(tool_of_the_path)
{
    struct trial t;
    trial_begin(&t);
    t.path = three_moves(0);
    for (size_t i = 0; i < t.path.piece.n; i++)
        t.path.piece.item[i].q[0] = t.path.piece.item[i].q[1] = vec(0, 0, 1);
    t.path.turns = 1;
    t.path.speed = 8000;
    t.path.tool = 3;
    t.path.offset = 7;
    t.motion.turns = tools[_i].turns;
    t.motion.speed = tools[_i].speed;
    t.motion.tool = tools[_i].tool;
    t.motion.offset = tools[_i].offset;
    t.v.program.path = &t.path;
    t.v.program.post = t.v.program.axis = -1;
    verify_judge(&t.v);
    ck_assert_int_eq(verdict_refused(&t.v), tools[_i].text != NULL);
    ck_assert_uint_eq(t.v.finding.n, tools[_i].text != NULL);
    if (tools[_i].text)
        ck_assert_ptr_nonnull(strstr(t.v.finding.item[0].text, tools[_i].text));
    trial_free(&t);
}
END_TEST

/* A cut that is off in its middle alone. */
START_TEST(a_tip_off_the_path)
{
    for (int beyond = 0; beyond < 2; beyond++) {
        struct trial t;
        trial_begin(&t);
        t.path = three_moves(0);
        t.motion.piece.n = 1;
        move_to(&t.motion, vec(0, 0, beyond ? 0.0085 : 0.0075), vec(0, 0, 1), false);
        move_to(&t.motion, vec(20, 0, 0), vec(0, 0, 1), false);
        move_to(&t.motion, vec(20, 0, 30), vec(0, 0, 1), true);
        t.v.program.path = &t.path;
        verify_judge(&t.v);
        ck_assert_int_eq(verdict_refused(&t.v), beyond);
        if (beyond)
            ck_assert_ptr_nonnull(strstr(t.v.finding.item[0].text,
                                         ": the tip is 0.0085 mm off the path at 0.000 0.000 "
                                         "0.009"));
        trial_free(&t);
    }
}
END_TEST

/* A path that goes on where the program is over: a fault, but not of a part of a program. */
START_TEST(what_the_program_leaves_out)
{
    struct trial t;
    trial_begin(&t);
    t.v.program.of_whole = _i == 1;
    t.path = three_moves(0);
    t.path.piece.n = 2;
    move_to(&t.path, vec(20, 15, 0), vec(0, 0, 1), false);
    t.v.program.path = &t.path;
    verify_judge(&t.v);
    ck_assert_int_eq(verdict_refused(&t.v), _i == 0);
    ck_assert_ptr_nonnull(strstr(t.v.finding.item[0].text,
                                 "the program leaves out line 3 of the path, 15.0000 mm off it at "
                                 "20.000 15.000 0.000"));
    trial_free(&t);
}
END_TEST

#define COUNT(a) ((int)(sizeof(a) / sizeof *(a)))

int main(void)
{
    Suite *suite = suite_create("verify_judge");
    TCase *tests = tcase_create("verify_judge");
    SRunner *runner = srunner_create(suite);
    tcase_add_loop_test(tests, figures_on_either_side, 0, COUNT(figures));
    tcase_add_test(tests, inverse_feeds_are_not_slowed_down);
    tcase_add_test(tests, remarks_of_the_reader);
    tcase_add_test(tests, pieces_summed);
    tcase_add_loop_test(tests, rapids_at_the_part, 0, COUNT(rapids));
    tcase_add_loop_test(tests, rapids_that_come_back, 0, COUNT(returns));
    tcase_add_loop_test(tests, rapids_that_a_plunge_follows, 0, COUNT(plunges));
    tcase_add_test(tests, an_end_on_the_part);
    tcase_add_loop_test(tests, a_block_at_rapid_on_the_course_of_a_cut, 0,
                        sizeof alone / sizeof *alone);
    tcase_add_loop_test(tests, turns_of_the_axis, 0, COUNT(turns));
    tcase_add_loop_test(tests, against_the_path, 0, COUNT(paths));
    tcase_add_loop_test(tests, tool_of_the_path, 0, (int)(sizeof tools / sizeof *tools));
    tcase_add_test(tests, a_tip_off_the_path);
    tcase_add_loop_test(tests, what_the_program_leaves_out, 0, 2);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
