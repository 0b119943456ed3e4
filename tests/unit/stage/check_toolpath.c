/* toolpath: the order of the moves, and where each of them may go. */
#include "stage/toolpath.h"

#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static const double R = 5;

/* Two rows of a floor, and one far from them. */
static void make_path(struct toolpath *t)
{
    struct contact contact[3];

    for (size_t pass = 1; pass <= 3; pass++) {
        double y = pass < 3 ? 2.0 * (double)pass : 60, sign = pass % 2 ? 1 : -1;
        for (int i = 0; i < 3; i++)
            contact[i] = (struct contact){vec(sign * (4 * i - 4), y, 0), vec(0, 0, 1)};
        toolpath_strip(t, pass, contact, 3, vec(sign, 0, 0));
    }
    toolpath_end(t);
}

static struct toolpath make_toolpath(struct path *path, const struct gouge_check *guard)
{
    return (struct toolpath){
        .path = path,
        .rule =
            {.radius = R, .feed = 800, .plunge = 300, .clearance = 20, .approach = 3, .longest = 6},
        .lift = {.guard = guard,
                 .offset = R,
                 .limit = R,
                 .tolerance = 0.01,
                 .step = 0.05,
                 .axis = {.kind = AXIS_LEAN, .tilt = 0.25},
                 .feed = {.side = {0, 1, 0}}}};
}

static struct gouge_check *make_floor(void)
{
    struct vec3s points = {0};
    for (int i = -10; i <= 10; i++)
        for (int k = -5; k <= 70; k++)
            *array_push(&points) = vec(i, k, 0);
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    array_free(&points);
    return guard;
}

static struct vec3 ball_of(const struct path_item *item)
{
    return vec_along(item->to.p, R, item->to.a);
}

/* Only what touches has cut, and where a link goes from row to row nothing has. */
static void check_cut(const struct toolpath *t)
{
    bool ends[10] = {false};

    ck_assert_uint_eq(t->ball.n, 9);
    for (size_t i = 0; i < t->ball.n; i++)
        ck_assert_double_eq_tol(t->ball.item[i].z, R, 1e-9);
    for (size_t i = 0; i < t->ball_end.n; i++)
        ends[t->ball_end.item[i]] = true;
    for (size_t i = 0; i <= 9; i++)
        ck_assert_int_eq(ends[i], i % 3 == 0);
}

START_TEST(passes_links_and_feeds_are_in_order)
{
    struct gouge_check *guard = make_floor();
    struct path path = {0};
    struct toolpath t = make_toolpath(&path, guard);
    make_path(&t);

    size_t pass = 0, touching = 0, rapids = 0;
    double feed = 0;
    for (size_t i = 0; i < path.item.n; i++) {
        const struct path_item *item = &path.item.item[i];
        if (item->kind == PATH_PASS)
            ck_assert_uint_eq(item->index, ++pass);
        if (item->kind == PATH_FEED)
            feed = item->feed;
        if (item->kind != PATH_POINT)
            continue;
        touching += item->touches;
        rapids += item->rapid;
        if (item->touches) {
            ck_assert(!item->rapid);
            ck_assert_double_eq(feed, 800);
            struct contact at = path.contact.item[item->contact];
            ck_assert_double_lt(vec_distance(ball_of(item), vec_along(at.p, R, at.n)), 1e-9);
        }
    }
    ck_assert_uint_eq(pass, 3);
    ck_assert_uint_eq(touching, 9);
    ck_assert_uint_eq(t.low, 1);  /* from pass 1 to pass 2 */
    ck_assert_uint_eq(t.high, 2); /* to pass 1 and to pass 3 */
    ck_assert_uint_eq(rapids, 6); /* over, down, up; twice */
    ck_assert_int_eq(toolpath_conclude(&t), 0);
    check_cut(&t);
    toolpath_free(&t);
    path_free(&path);
    gouge_free(guard);
}
END_TEST

START_TEST(the_ball_is_clear_on_every_rapid)
{
    struct gouge_check *guard = make_floor();
    struct path path = {0};
    struct toolpath t = make_toolpath(&path, guard);
    make_path(&t);

    const struct path_item *before = NULL;
    for (size_t i = 0; i < path.item.n; i++) {
        const struct path_item *item = &path.item.item[i];
        if (item->kind != PATH_POINT)
            continue;
        ck_assert_double_le(gouge_depth(guard, ball_of(item), R), 1e-6);
        if (before && item->rapid)
            ck_assert_double_le(gouge_depth_along(guard, ball_of(before), ball_of(item), R + 1), 0);
        before = item;
    }
    const struct path_item *first = &path.item.item[1], *last = before;
    ck_assert(first->rapid && last->rapid);
    ck_assert_double_eq_tol(first->to.p.z, 20, 1e-9);
    ck_assert_double_eq_tol(last->to.p.z, 20, 1e-9);
    toolpath_free(&t);
    path_free(&path);
    gouge_free(guard);
}
END_TEST

START_TEST(a_lid_above_the_strip_is_told)
{
    /* A floor with a lid 12 mm above it: the ball fits below, but no tool gets there. */
    struct vec3s points = {0};
    for (int i = -30; i <= 30; i++)
        for (int k = -30; k <= 100; k++) {
            *array_push(&points) = vec(i, k, 0);
            *array_push(&points) = vec(i, k, 12);
        }
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    array_free(&points);
    struct path path = {0};
    struct toolpath t = make_toolpath(&path, guard);
    t.rule.clearance = 30;
    make_path(&t);
    ck_assert_uint_eq(t.report.unreachable, 9);
    ck_assert_int_eq(toolpath_conclude(&t), 3);
    t.rule.avoid = true;
    ck_assert_int_eq(toolpath_conclude(&t), 0);
    for (size_t i = 0; i < path.item.n; i++)
        if (path.item.item[i].kind == PATH_POINT)
            ck_assert_double_ge(path.item.item[i].to.p.z, 12 - 1);
    toolpath_free(&t);
    path_free(&path);
    gouge_free(guard);
}
END_TEST

START_TEST(what_stands_in_a_gutter_is_measured)
{
    /* A gutter of radius 4 along y between planes of 45 degrees: at its bottom stays what a ball of
     * 5 leaves that touches both planes, (5 - 4) (sqrt 2 - 1). */
    struct vec3s points = {0};
    struct contact contact[9];
    double half = 4 * sin(PI / 4);
    for (int i = -100; i <= 100; i++) {
        double x = 0.1 * i;
        double z = fabs(x) < half ? 4 * sqrt(2) - sqrt(16 - x * x) : fabs(x);
        for (int k = -60; k <= 60; k++)
            *array_push(&points) = vec(x, 0.1 * k, z);
    }
    for (int i = 0; i < 9; i++) {
        double u = PI / 4 * (i - 4) / 4;
        contact[i] =
            (struct contact){vec(4 * sin(u), 0, 4 * sqrt(2) - 4 * cos(u)), vec(-sin(u), 0, cos(u))};
    }
    struct gouge_check *guard = gouge_from_points(points.item, points.n);
    array_free(&points);
    struct path path = {0};
    struct toolpath t = make_toolpath(&path, guard);
    t.lift.between = true;
    t.lift.uncut = 0.03;
    toolpath_strip(&t, 1, contact, 9, vec(1, 0, 0));
    toolpath_end(&t);
    ck_assert_double_eq_tol(t.uncut_height, sqrt(2) - 1, 0.01);
    ck_assert_double_le(fabs(t.uncut_at.x), 0.5);
    ck_assert_uint_eq(t.uncut_pass, 1);
    ck_assert_int_eq(toolpath_conclude(&t), 3);
    t.rule.avoid = true;
    ck_assert_int_eq(toolpath_conclude(&t), 0);
    toolpath_free(&t);
    path_free(&path);
    gouge_free(guard);
}
END_TEST

START_TEST(without_a_guard_the_moves_are_the_same)
{
    struct path path = {0};
    struct toolpath t = make_toolpath(&path, NULL);
    make_path(&t);
    ck_assert_uint_eq(t.low, 1);
    ck_assert_uint_eq(t.high, 2);
    toolpath_free(&t);
    path_free(&path);
}
END_TEST

/* Reads up to `size` bytes of a file, and takes it away. */
static size_t read_away(const char *name, char *text, size_t size)
{
    FILE *file = fopen(name, "rb");
    ck_assert_ptr_nonnull(file);
    size_t n = fread(text, 1, size, file);
    fclose(file);
    remove(name);
    return n;
}

START_TEST(a_path_written_as_it_is_made_is_the_same)
{
    static char whole[20000], streamed[20000];
    char name[] = "/tmp/check_toolpath.XXXXXX";
    close(mkstemp(name));
    struct gouge_check *guard = make_floor();
    struct path path = {.head = {.multax = true, .tool = 3, .clearance = 20, .chord = NAN}};
    struct path piece = path;
    struct toolpath kept = make_toolpath(&path, guard), t = make_toolpath(&piece, guard);

    make_path(&kept);
    kept.out = out_open(name);
    path_write(kept.out, &path);
    out_close(kept.out);
    size_t n = read_away(name, whole, sizeof whole);
    t.streams = true;
    t.output = name;
    make_path(&t);
    path_write_end(t.out, &t.path->head);
    out_close(t.out);
    ck_assert_uint_gt(n, 1000);
    ck_assert_uint_eq(read_away(name, streamed, sizeof streamed), n);
    ck_assert_mem_eq(whole, streamed, n);
    ck_assert_uint_eq(piece.item.n, 0);
    toolpath_free(&t);
    toolpath_free(&kept);
    path_free(&path);
    path_free(&piece);
    gouge_free(guard);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("toolpath");
    TCase *tests = tcase_create("toolpath");
    tcase_add_test(tests, passes_links_and_feeds_are_in_order);
    tcase_add_test(tests, the_ball_is_clear_on_every_rapid);
    tcase_add_test(tests, a_path_written_as_it_is_made_is_the_same);
    tcase_add_test(tests, a_lid_above_the_strip_is_told);
    tcase_add_test(tests, what_stands_in_a_gutter_is_measured);
    tcase_add_test(tests, without_a_guard_the_moves_are_the_same);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
