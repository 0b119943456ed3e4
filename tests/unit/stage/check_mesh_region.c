/*
 * check_mesh_region - what is taken of a plate that rises in a quarter of a cylinder has the area
 * that is known; options and files that are none are refused.
 */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "stage/mesh_region.h"
#include "scratch.h"

enum { CELLS = 40 };

/* Flat from x = -20 to 0, then the quarter of a cylinder of radius 20 about y, down to the
 * steepness of 90 degrees; 40 mm along y.  Two surfaces: A:5 is flat, A:7 bent. */
static struct mesh plate(void)
{
    struct mesh m = {0};
    for (int i = 0; i <= CELLS; i++)
        for (int k = 0; k <= CELLS; k++) {
            double u = 2.0 * i / CELLS - 1, t = fmax(u, 0) * PI / 2, y = 40.0 * k / CELLS;
            *array_push(&m.vertex) =
                u <= 0 ? vec(20 * u, y, 0) : vec(20 * sin(t), y, 20 * cos(t) - 20);
            *array_push(&m.normal) = vec(sin(t), 0, cos(t));
        }
    for (int i = 0; i < CELLS; i++)
        for (int k = 0; k < CELLS; k++) {
            int a = i * (CELLS + 1) + k, b = a + CELLS + 1;
            *array_push(&m.face) = (struct face){{a, b, b + 1}};
            *array_push(&m.face) = (struct face){{a, b + 1, a + 1}};
            for (int n = 0; n < 2; n++)
                *array_push(&m.surface) = i >= CELLS / 2;
        }
    *array_push(&m.origin.surface) = (struct mesh_surface){mem_string("A:5", 3), 0, {0, 0, 0}};
    *array_push(&m.origin.surface) = (struct mesh_surface){mem_string("A:7", 3), 0, {0, 0, 0}};
    return m;
}

static double area_of(struct mesh_region_options options)
{
    struct mesh mesh = plate(), part;
    struct error error;
    double sum = 0;
    options.up = vec(0, 0, 1);
    ck_assert(mesh_region_given(&options));
    ck_assert_int_eq(mesh_region_take(&options, &mesh, &part, &error), 0);
    ck_assert_uint_eq(part.normal.n, part.vertex.n);
    for (size_t f = 0; f < part.face.n; f++)
        sum += vec_length(mesh_face_cross(&part, f)) / 2;
    mesh_free(&mesh);
    mesh_free(&part);
    return sum;
}

/* Facets of a circle of 80 sides: shorter than it by 1 - (pi/80)^2 / 6. */
static const double bent = 1 - PI * PI / 80 / 80 / 6;

START_TEST(nothing_asked_for)
{
    ck_assert(!mesh_region_given(&(struct mesh_region_options){.up = {0, 0, 1}}));
}
END_TEST

START_TEST(surfaces_by_their_numbers)
{
    ck_assert_double_eq_tol(area_of((struct mesh_region_options){.faces = "5"}), 800, 1e-9);
    double round = 40 * 20 * PI / 2 * bent;
    ck_assert_double_eq_tol(area_of((struct mesh_region_options){.faces = "6-8"}), round, 0.01);
    ck_assert_double_eq_tol(area_of((struct mesh_region_options){.faces = "5,7"}), 800 + round,
                            0.01);
}
END_TEST

START_TEST(a_box)
{
    const double box[] = {-7.25, 3.5, -1, -2.5, 31.75, 1};
    ck_assert_double_eq_tol(area_of((struct mesh_region_options){.box = box}), 4.75 * 28.25, 1e-6);
}
END_TEST

/* 20 to 50 degrees of the cylinder.  Between two vertices h apart the cosine is taken to run
 * evenly: by h^2/8 of itself wrong, the angle by that over its tangent. */
START_TEST(a_steepness)
{
    const double h = PI / CELLS, off = h * h / 8 * (1 / tan(RADIANS(20)) + 1 / tan(RADIANS(50)));
    double got = area_of((struct mesh_region_options){.steep = "20:50"});
    ck_assert_double_eq_tol(got, 40 * 20 * RADIANS(30) * bent, 40 * 20 * off);
    got = area_of((struct mesh_region_options){.steep = "20:50", .faces = "5"});
    ck_assert_double_eq_tol(got, 0, 1e-9);
}
END_TEST

/* What was taken by surfaces or slopes is a region of points by its outline, with a border half as
 * wide again; none where all of it is at the border, or where much is under another part. */
START_TEST(an_outline)
{
    const struct {
        const char *faces, *steep;
        double border, low, high; /* along x, with the border; 0: nothing is known */
    } is[] = {{"5", NULL, 1, -18.5, -1.5},
              {NULL, "0:30", 0.5, -19.25, 9.25},
              {NULL, "30:60", 0.5, 10.75, 20 * 0.8660254 - 0.75},
              {NULL, "85:90", 0.5, 0, 0},
              {"5", NULL, 20, 0, 0}};
    for (size_t i = 0; i < sizeof is / sizeof *is; i++) {
        struct region_polygons polygons = {0};
        struct mesh_region_options options = {.faces = is[i].faces,
                                              .steep = is[i].steep,
                                              .border = is[i].border,
                                              .polygons = &polygons};
        area_of(options);
        struct region region = mesh_region_of_points(&options);
        ck_assert_int_eq(region_given(&region), is[i].high > is[i].low);
        for (double x = -25; x < 25 && region_given(&region); x += 0.1)
            if (fabs(x - is[i].low) > 0.2 && fabs(x - is[i].high) > 0.2)
                ck_assert_int_eq(region_holds(&region, vec(x, 20, 3)),
                                 x > is[i].low && x < is[i].high);
        region_polygons_free(&polygons);
    }
}
END_TEST

/* A square with a triangle cut out of it, on the flat part. */
START_TEST(polygons)
{
    const char *file = scratch_text("# outside\n-15 5\n-5,5\n-5;15\n -15\t15 \n\n"
                                    "-12 8\n-8 8\n-8 12\n");
    ck_assert_double_eq_tol(area_of((struct mesh_region_options){.region = file}), 100 - 8, 1e-6);
}
END_TEST

static void refused(struct mesh_region_options options, const char *what)
{
    struct mesh mesh = plate(), part = {0};
    struct error error = {0};
    options.up = vec(0, 0, 1);
    ck_assert_int_eq(mesh_region_take(&options, &mesh, &part, &error), -1);
    ck_assert_msg(strstr(error.text, what) != NULL, "%s", error.text);
    ck_assert(error.file == (options.region != NULL));
    mesh_free(&mesh);
    mesh_free(&part);
}

START_TEST(what_cannot_be_taken)
{
    const double upside_down[] = {0, 0, 0, 1, -1, 1}, flat[] = {0, 0, 0, 1, 1, 0};
    const char *const faces[] = {"", "5,", "7-5", "a", "5;7", "-5", "8", "1-4"};
    const char *const steep[] = {"", "45", "45:", "50:20", "-1:20", "0:181", "0:45x", "20:20"};
    for (size_t i = 0; i < sizeof faces / sizeof *faces; i++)
        refused((struct mesh_region_options){.faces = faces[i]}, "--faces");
    for (size_t i = 0; i < sizeof steep / sizeof *steep; i++)
        refused((struct mesh_region_options){.steep = steep[i]}, "--steep");
    refused((struct mesh_region_options){.box = upside_down}, "--box: found 0 to -1 in y");
    refused((struct mesh_region_options){.box = flat}, "in z");
}
END_TEST

START_TEST(files_that_hold_no_polygon)
{
    const struct {
        const char *text, *what;
    } bad[] = {{"# none\n", "no polygon"},     {"1 2\n3 4\n", "polygon of 2 corners"},
               {"1 2\n\n", "polygon of 1"},    {"1\n", ":1: found no two"},
               {"1 2\n3 x\n", ":2: found no"}, {"1 2 3\n", ":1: found no"},
               {"1 inf\n", ":1: found no"}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        refused((struct mesh_region_options){.region = scratch_text(bad[i].text)}, bad[i].what);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("mesh_region");
    TCase *tcase = tcase_create("mesh_region");
    tcase_add_test(tcase, nothing_asked_for);
    tcase_add_test(tcase, surfaces_by_their_numbers);
    tcase_add_test(tcase, a_box);
    tcase_add_test(tcase, a_steepness);
    tcase_add_test(tcase, an_outline);
    tcase_add_test(tcase, polygons);
    tcase_add_test(tcase, what_cannot_be_taken);
    tcase_add_test(tcase, files_that_hold_no_polygon);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
