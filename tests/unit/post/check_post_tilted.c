/*
 * post_tilted: the travel of the linear axes in tilted planes.  On a table that turns about its
 * zero point Z stands where the tip is along the tool's axis, whatever X and Y of the plane, and X
 * and Y stand as far off Z's axis as the tip is from the tool's; above the plane the table is not
 * turned yet, and each axis stands where the tip is in the work.
 */
#include "post/post_tilted.h"

#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "seed.h"

enum { TRIALS = 200 };

static const double LIMIT = 300;
static uint64_t state;

/* -1 to 1 */
static double any(void)
{
    state = state * 6364136223846793005u + seed_step();
    return (double)(int64_t)state / 9223372036854775808.0;
}

/* A program of rapids to places of one tilted plane. */
struct bench {
    struct path path;
    struct machine machine, three;
    struct nc_plan plan;
    struct nc_program program;
    struct error error;
};

/* The tool leans by up to 80 degrees. */
static void begin(struct bench *b)
{
    double lean = RADIANS(10 + 70 * fabs(any())), way = RADIANS(180 * any());
    struct pose at = {{0, 0, 0}, {sin(lean) * cos(way), sin(lean) * sin(way), cos(lean)}};

    memset(b, 0, sizeof *b);
    b->path.name = "path";
    path_add_point(&b->path, at, true);
    b->machine = machine_default();
    ck_assert_int_eq(machine_finish(&b->machine, &b->error), 0);
    b->three = b->machine;
    b->plan.ability.digits.linear = b->plan.ability.digits.angle = 3;
    b->program = (struct nc_program){.control = CONTROL_fanuc,
                                     .path = &b->path,
                                     .machine = &b->three,
                                     .plan = &b->plan,
                                     .options.unit = 1,
                                     .plane = true};
    ck_assert(post_frame_planes(&b->path, &b->program.planes));
    enum nc_plane_angles angles = dialect_of(CONTROL_fanuc)->plane_angles;
    ck_assert_int_eq(post_frame_tilt(&b->path, &b->three, &b->program.planes, angles, 3, &b->error),
                     0);
}

static void end(struct bench *b)
{
    array_free(&b->plan.move);
    array_free(&b->program.planes);
    path_free(&b->path);
}

static void go(struct bench *b, struct vec3 p)
{
    unsigned line = (unsigned)b->plan.move.n + 1;

    *array_push(&b->plan.move) = (struct nc_move){.kind = NC_RAPID, .line = line, .p = p};
}

/* All axes but one go anywhere. */
static void limit(struct machine *m, int axis, double most)
{
    for (int i = 0; i < 3; i++) {
        m->max[i] = i == axis ? most : 1e6;
        m->min[i] = -m->max[i];
    }
}

static bool is_kept(struct bench *b)
{
    b->error.text[0] = '\0';
    return post_tilted_check(&b->program, &b->machine, &b->error) == 0;
}

START_TEST(along_the_tool_stands_z)
{
    state = seed_step();
    for (int trial = 0; trial < TRIALS; trial++) {
        double off = trial % 2 ? 0.01 : -0.01, side = trial % 4 < 2 ? 1 : -1;
        struct bench b;
        begin(&b);
        limit(&b.machine, 2, LIMIT);
        go(&b, vec(0, 0, 0));
        go(&b, vec(500 * any(), 500 * any(), side * (LIMIT + off)));
        ck_assert_int_eq(is_kept(&b), off < 0);
        if (off > 0) {
            ck_assert_ptr_nonnull(strstr(b.error.text, "in a tilted plane a position of"));
            ck_assert_ptr_nonnull(strstr(b.error.text, "axis Z of"));
            ck_assert_ptr_nonnull(strstr(b.error.text, ":2:"));
        }
        end(&b);
    }
}
END_TEST

/* X and Y share the distance of the tip from the tool's axis through the zero point. */
START_TEST(beside_the_tool_stand_x_and_y)
{
    state = seed_step();
    for (int trial = 0; trial < TRIALS; trial++) {
        double way = PI * any(), far = LIMIT;
        struct bench b;
        begin(&b);
        go(&b, vec(0, 0, 0));
        go(&b, vec(far * cos(way), far * sin(way), 100 * any()));
        for (int axis = 0; axis < 2; axis++) {
            limit(&b.machine, axis, far + 0.01);
            ck_assert(is_kept(&b));
        }
        /* both less than the distance by a square's corner: one of them is beyond */
        limit(&b.machine, 0, far * sqrt(0.5) - 0.01);
        b.machine.max[1] = b.machine.max[0];
        b.machine.min[1] = b.machine.min[0];
        ck_assert(!is_kept(&b));
        end(&b);
    }
}
END_TEST

START_TEST(above_a_plane_the_work_is_not_turned)
{
    state = seed_step();
    for (int trial = 0; trial < TRIALS; trial++) {
        struct bench b;
        begin(&b);
        struct vec3 tool = b.program.planes.item[0].axis;
        double lean = fabs(trial % 2 ? tool.y : tool.x), z = LIMIT / fmax(lean, 0.1);
        bool beyond = z * lean > 0.9 * LIMIT;
        limit(&b.machine, trial % 2, 0.9 * LIMIT);
        go(&b, vec(0, 0, z)); /* along the tool, where X and Y of the turned table stand at 0 */
        ck_assert_int_eq(is_kept(&b), !beyond);
        if (beyond)
            ck_assert_ptr_nonnull(strstr(b.error.text, "above a tilted plane a position of"));
        b.plan.move.n = 0;
        go(&b, vec(0, 0, 0));
        go(&b, vec(0, 0, z)); /* the table is turned before */
        ck_assert(is_kept(&b));
        end(&b);
    }
}
END_TEST

/* Half a turn whose ends keep the travel of Z, and whose middle does not. */
START_TEST(on_the_way_of_an_arc)
{
    state = seed_step();
    for (int trial = 0; trial < 20; trial++) {
        double r = trial % 2 ? 20.1 : 19.9;
        struct bench b;
        begin(&b);
        limit(&b.machine, 2, LIMIT);
        go(&b, vec(-r, 0, LIMIT - 20));
        go(&b, vec(r, 0, LIMIT - 20));
        struct nc_move *move = &b.plan.move.item[1];
        move->kind = NC_ARC;
        *array_push(&b.plan.arc) = (struct nc_arc){
            .plane = 18, .ccw = false, .centre = {r, 0, 0}, .radius = r, .axis = {0, 1, 0}};
        ck_assert_int_eq(is_kept(&b), r < 20);
        array_free(&b.plan.arc);
        end(&b);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("post_tilted");
    TCase *tests = tcase_create("post_tilted");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, along_the_tool_stands_z);
    tcase_add_test(tests, beside_the_tool_stand_x_and_y);
    tcase_add_test(tests, above_a_plane_the_work_is_not_turned);
    tcase_add_test(tests, on_the_way_of_an_arc);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
