/* guard_read: which scan guards, where it is placed, and what a ball finds of it: on a floor it
 * stands at its radius, of strays, noise and wrong places what is known is told. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "noisy.h"
#include "said.h"
#include "scratch.h"
#include "shapes.h"
#include "stage/guard_read.h"

static struct guard_scan scan;
static struct vec3s points;
static struct error error;
static char name[300];

static void teardown(void)
{
    guard_scan_free(&scan);
    array_free(&points);
}

/* A floor at z = 0, a point each 0.5 mm over 20 x 20, with noise. */
static void make_floor(double sigma)
{
    noisy_seed(5);
    for (int i = -20; i <= 20; i++)
        for (int k = -20; k <= 20; k++)
            *array_push(&points) = vec(0.5 * i, 0.5 * k, sigma > 0 ? sigma * noisy_normal() : 0);
}

/* The points in a file. */
static void write_floor(void)
{
    char *text = malloc(80 * points.n + 1);
    size_t at = 0;
    for (size_t i = 0; i < points.n; i++)
        at += (size_t)sprintf(text + at, "%.17g %.17g %.17g\n", points.item[i].x, points.item[i].y,
                              points.item[i].z);
    snprintf(name, sizeof name, "%s", scratch_bytes(text, at));
    free(text);
}

static const double RADIUS = 4;
static struct unmets unmet;

static int read_scan(const struct guard_choice *choice, const struct scan_sources *named)
{
    unmets_free(&unmet);
    return guard_scan_read(choice, named, RADIUS, "the mesh", "the mesh guards", &scan, &unmet,
                           &error);
}

/* A mesh of two facets 20 mm wide, in inches: points on them guard, a quarter of the radius apart
 * at most, and the scan stays the corners. */
START_TEST(facets_of_a_mesh)
{
    const char *text = "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\n"
                       "property double y\nproperty double z\nelement face 2\n"
                       "property list uchar int vertex_indices\nend_header\n"
                       "0 0 0\n0.7874015748 0 0\n0.7874015748 0.7874015748 0\n"
                       "0 0.7874015748 0\n3 0 1 2\n3 0 2 3\n";
    struct scan_sources named = {.placed = true, .place = transform_scale(25.4)};
    struct guard_choice choice = {.none = false};
    snprintf(name, sizeof name, "%s", scratch_text(text));
    *array_push(&choice.files) = name;
    ck_assert_int_eq(read_scan(&choice, &named), 0);
    ck_assert_uint_eq(scan.source.item[0].points, 4);
    ck_assert_uint_gt(scan.point.n, 400);
    ck_assert_uint_lt(scan.point.n, 2000);
    for (int i = 0; i < 20; i++)
        for (int k = 0; k < 20; k++) {
            double nearest = HUGE_VAL;
            for (size_t j = 0; j < scan.point.n; j++)
                nearest = fmin(nearest, vec_distance(vec(i, k, 0), scan.point.item[j]));
            ck_assert_double_lt(nearest, 0.65 * RADIUS / 4);
        }
    array_free(&choice.files);
}

/* The file that a stream names, as long as it is the same; what is asked for comes before it. */
START_TEST(which_scan)
{
    struct guard_choice choice = {.none = true};
    struct scan_sources named = {0};
    make_floor(0);
    write_floor();
    scan_sources_add(&named, name, points.item, points.n);
    ck_assert_int_eq(read_scan(&choice, &named), 0);
    ck_assert_uint_eq(scan.point.n, 0);
    choice.none = false;
    ck_assert_int_eq(read_scan(&choice, &named), 0);
    ck_assert_uint_eq(scan.point.n, points.n);
    ck_assert_uint_eq(scan.source.n, 1);
    ck_assert_uint_eq(scan.source.item[0].hash, named.item[0].hash);
    ck_assert(!scan.source.placed);
    guard_scan_free(&scan);
    /* placed as the mesh is, that of -g too */
    named.placed = true;
    named.place = transform_product(transform_shift(vec(1, 2, 3)), transform_scale(25.4));
    for (int given = 0; given < 2; given++) {
        if (given)
            *array_push(&choice.files) = name;
        said_begin();
        int status = read_scan(&choice, &named);
        ck_assert_ptr_nonnull(strstr(said_end(), "placed as the mesh"));
        ck_assert_int_eq(status, 0);
        ck_assert_uint_eq(scan.point.n, points.n);
        ck_assert_uint_eq(scan.source.item[0].hash, named.item[0].hash);
        ck_assert(scan.source.placed);
        struct vec3 want = vec_along(vec(1, 2, 3), 25.4, points.item[7]);
        ck_assert_double_lt(vec_distance(scan.point.item[7], want), 1e-12);
        guard_scan_free(&scan);
    }
    array_free(&choice.files);
    scan_sources_free(&named);
}
END_TEST

/* What it was is told apart from what it is: fewer points, others, none; nothing guards then. */
START_TEST(another_scan)
{
    static const char *const says[] = {"found 1681 points, expected 1682", "found other points",
                                       "read from standard input", "no points"};
    struct guard_choice choice = {.none = false};
    make_floor(0);
    write_floor();
    for (int k = 0; k < 4; k++) {
        struct scan_sources named = {0};
        scan_sources_add_known(&named, k == 2 ? "-" : name, points.n + (k == 0),
                               scan_source_hash(points.item, points.n) + (k == 1));
        if (k == 3)
            scratch_text("# none\n");
        said_begin();
        int status = read_scan(&choice, &named);
        const char *text = said_end();
        ck_assert_int_eq(status, 0);
        ck_assert_msg(strstr(text, says[k]) != NULL, "%s", text);
        ck_assert_ptr_nonnull(strstr(text, "the mesh guards"));
        ck_assert_uint_eq(scan.point.n, 0);
        ck_assert_uint_eq(unmet.n, 1);
        ck_assert_uint_eq(scan.source.n, 1); /* it is named on */
        guard_scan_free(&scan);
        scan_sources_free(&named);
    }
    *array_push(&choice.files) = "/nowhere/at/all"; /* asked for: an error */
    const struct scan_sources none = {0};
    ck_assert_int_eq(read_scan(&choice, &none), -1);
    array_free(&choice.files);
}
END_TEST

static struct guard_read_options usual(double noise)
{
    return (struct guard_read_options){
        .radius = 4, .tolerance = 0.02, .noise = noise, .effort = 1, .threads = 1};
}

static struct gouge_check *guard_of(struct guard_read_options *rule, const struct mesh *mesh,
                                    double near)
{
    scan_sources_free(&scan.source);
    scan = (struct guard_scan){.point = points};
    scan_sources_add(&scan.source, "scan.xyz", points.item, points.n);
    points = (struct vec3s){0};
    said_begin();
    struct gouge_check *guard = guard_read(&scan, mesh, near, rule, &error);
    said_end();
    ck_assert_uint_eq(scan.point.n, 0);
    return guard;
}

static void free_guard(struct gouge_check *guard, struct guard_read_options *rule)
{
    gouge_free(guard);
    array_free(&rule->certain);
    array_free(&rule->doubtful);
    array_free(&rule->curtain);
}

static struct vec3 floor_point(double x, double y, struct vec3 *normal)
{
    *normal = vec(0, 0, 1);
    return vec(x, y, 0);
}

/* A ball of 4 stands 4 over the floor: no higher, and sunk by a fifth of the tolerance at most.  A
 * stray over the floor keeps nothing off, a double counts once. */
START_TEST(a_floor_keeps_the_ball_off)
{
    struct mesh mesh = shape_grid(floor_point, -9, -9, 9, 9, 6, 6);
    struct guard_read_options rule = usual(0);
    make_floor(0);
    struct vec3 twice = points.item[30];
    *array_push(&points) = twice;
    struct gouge_check *guard = guard_of(&rule, &mesh, 1);
    ck_assert_ptr_nonnull(guard);
    ck_assert_double_eq(rule.noise, 0);
    ck_assert_uint_eq(rule.certain.n + rule.doubtful.n, 41 * 41);
    for (int i = 0; i < 200; i++) {
        double x = 16 * noisy_uniform() - 8, y = 16 * noisy_uniform() - 8;
        double deep = gouge_depth(guard, vec(x, y, 4), 4);
        ck_assert_double_le(deep, 1e-9);
        ck_assert_double_ge(deep, -0.02 / 5 - 1e-9);
    }
    free_guard(guard, &rule);
    mesh_free(&mesh);
}
END_TEST

/* Noise is measured where it is not said, and taken out: the ball is nearer to the floor than the
 * highest point lets it; where it is no tenth of the tolerance, it is no noise. */
START_TEST(noise_is_taken_out)
{
    static const double sigma[] = {0.03, 0.001};
    struct mesh mesh = shape_grid(floor_point, -9, -9, 9, 9, 6, 6);
    for (int k = 0; k < 2; k++) {
        struct guard_read_options rule = usual(-1);
        make_floor(sigma[k]);
        *array_push(&points) = vec(0.2, 0.3, 5); /* a stray */
        struct gouge_check *guard = guard_of(&rule, &mesh, 1);
        ck_assert_ptr_nonnull(guard);
        ck_assert_double_lt(gouge_top(guard), 1);
        if (k == 0) /* n points: 4 sigma sqrt(2 / n), of an estimate half as good as the best */
            ck_assert_double_eq_tol(rule.noise, sigma[k], 4 * sigma[k] * sqrt(2.0 / 1681));
        else
            ck_assert_double_eq(rule.noise, 0);
        double sum = 0, highest = 0;
        for (int i = 0; i < 400; i++) {
            double x = 14 * noisy_uniform() - 7, y = 14 * noisy_uniform() - 7;
            double deep = gouge_depth(guard, vec(x, y, 4), 4);
            sum += deep / 400;
            highest = fmax(highest, fabs(deep));
        }
        /* a point beyond three deviations may be no noise: the ball rides on it; on raw points it
         * would ride a deviation high throughout, on the highest of the few below it */
        ck_assert_double_le(highest, 4.5 * sigma[k] + 0.02 / 5);
        if (k == 0)
            ck_assert_double_eq_tol(sum, 0, 0.4 * sigma[k]);
        free_guard(guard, &rule);
    }
    mesh_free(&mesh);
}
END_TEST

/* Noise, that steps may be as well, is told where the tolerance asks for less; not what the user
 * says that it is. */
START_TEST(much_noise_is_told)
{
    static const double sigma[] = {0.03, 0.12, 0.12}, said[] = {-1, -1, 0.12};
    struct mesh mesh = shape_grid(floor_point, -9, -9, 9, 9, 6, 6);
    for (int k = 0; k < 3; k++) {
        struct unmets told = {0};
        struct guard_read_options rule = usual(said[k]);
        rule.unmet = &told;
        make_floor(sigma[k]);
        struct gouge_check *guard = guard_of(&rule, &mesh, 1);
        ck_assert_ptr_nonnull(guard);
        ck_assert_int_eq(unmets_status(&told), k == 1 ? 3 : 0);
        free_guard(guard, &rule);
        unmets_free(&told);
    }
    mesh_free(&mesh);
}
END_TEST

/* Where more than half of the mesh is elsewhere, the scan is another one; half is not more. */
START_TEST(elsewhere)
{
    for (int shift = 0; shift < 3; shift++) {
        static const double by[] = {9, 11, 30};
        struct mesh mesh = shape_grid(floor_point, -9 + by[shift], -9, 9 + by[shift], 9, 6, 6);
        struct guard_read_options rule = usual(0);
        make_floor(0);
        struct gouge_check *guard = guard_of(&rule, &mesh, 1);
        size_t far = 0; /* by truth: beyond 10 + 1 in x */
        for (size_t i = 0; i < mesh.vertex.n; i++)
            far += mesh.vertex.item[i].x > 11;
        ck_assert_int_eq(guard != NULL, 2 * far <= mesh.vertex.n);
        if (!guard) {
            char want[60];
            snprintf(want, sizeof want, "found %zu of %zu mesh vertices", far, mesh.vertex.n);
            ck_assert_msg(strstr(error.text, want) != NULL, "%s", error.text);
        }
        free_guard(guard, &rule);
        mesh_free(&mesh);
        guard_scan_free(&scan);
    }
}
END_TEST

START_TEST(for_a_path)
{
    struct guard_read_options rule = usual(0);
    struct vec3s place = {0};
    for (int i = 0; i < 4; i++)
        *array_push(&place) = vec(i, 0, i < 2 ? 4 : 20);
    for (int k = 0; k < 2; k++) { /* two of four are near; two of five */
        make_floor(0);
        scan = (struct guard_scan){.point = points};
        scan_sources_add(&scan.source, "scan.xyz", points.item, points.n);
        points = (struct vec3s){0};
        struct gouge_check *guard = guard_read_scan(&scan, &rule, &error);
        ck_assert_ptr_nonnull(guard);
        int near = guard_scan_near(&scan, &place, "points of the path", 5, 1, &error);
        ck_assert_int_eq(near, k == 0 ? 0 : -1);
        if (k == 1)
            ck_assert_ptr_nonnull(
                strstr(error.text, "3 of 5 points of the path further than 5 mm"));
        free_guard(guard, &rule);
        guard_scan_free(&scan);
        *array_push(&place) = vec(0, 0, 30);
    }
    array_free(&place);
}
END_TEST

/* A mesh of this very scan may go far beyond it, by its own width to each side: but not all of
 * it. */
START_TEST(the_named_scan)
{
    struct vec3s place = {0};
    for (int i = 0; i < 40; i++)
        *array_push(&place) = vec(0, 0, i < 2 ? 0 : 20);
    make_floor(0);
    scan = (struct guard_scan){.point = points};
    scan_sources_add(&scan.source, "scan.xyz", points.item, points.n);
    points = (struct vec3s){0};
    ck_assert_int_eq(guard_scan_near(&scan, &place, "mesh vertices", 5, 1, &error), -1);
    scan.named = true;
    ck_assert_int_eq(guard_scan_near(&scan, &place, "mesh vertices", 5, 1, &error), 0);
    place.item[0].z = 20;
    ck_assert_int_eq(guard_scan_near(&scan, &place, "mesh vertices", 5, 1, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "39 of 40 mesh vertices further than 5 mm"));
    guard_scan_free(&scan);
    array_free(&place);
}
END_TEST

/* A step that is higher than the path may be off the scan: on its wall, which no point is on, a
 * path is where the scan is; as high before it or behind it, over it or under it is elsewhere. */
START_TEST(a_path_on_a_wall)
{
    const struct {
        double x, z;
        int is;
    } at[] = {{-4, 30, 0}, {0, 8, 0},   {0, 30, 0},  {0, 52, 0},   {4, 30, 0},   {-6, 30, -1},
              {6, 30, -1}, {0, 66, -1}, {0, -6, -1}, {0, 1e6, -1}, {-30, 30, -1}};
    make_floor(0);
    for (size_t i = 0; i < points.n; i++)
        points.item[i].z = points.item[i].x > 0 ? 60 : 0;
    scan = (struct guard_scan){.point = points};
    scan_sources_add(&scan.source, "scan.xyz", points.item, points.n);
    points = (struct vec3s){0};
    for (size_t k = 0; k < sizeof at / sizeof *at; k++) {
        struct vec3 place = vec(at[k].x, 0.2, at[k].z);
        struct vec3s one = {1, 1, &place};
        ck_assert_msg(guard_scan_near(&scan, &one, "points of the path", 5, 1, &error) == at[k].is,
                      "at %g %g", at[k].x, at[k].z);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("guard_read");
    TCase *tests = tcase_create("guard_read");
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, which_scan);
    tcase_add_test(tests, facets_of_a_mesh);
    tcase_add_test(tests, another_scan);
    tcase_add_test(tests, a_floor_keeps_the_ball_off);
    tcase_add_test(tests, noise_is_taken_out);
    tcase_add_test(tests, much_noise_is_told);
    tcase_add_test(tests, elsewhere);
    tcase_add_test(tests, for_a_path);
    tcase_add_test(tests, the_named_scan);
    tcase_add_test(tests, a_path_on_a_wall);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
