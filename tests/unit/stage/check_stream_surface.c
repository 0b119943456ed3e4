/* stream_surface: vertices, normals, curvatures, noise and ledger of a file that is read band by
 * band are those of the same points in memory, on known surfaces, with noise and without, near the
 * origin and far from it; and as near to the truth. */
#include "stage/cloud_stream.h"

#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "cloud/noise.h"
#include "io/mesh/meshfile.h"
#include "noisy.h"
#include "scratch.h"
#include "stage/cloud_prepare.h"

static struct vec3s points;
static struct error error;

static void teardown(void)
{
    array_free(&points);
}

/* ---- surfaces over 40 x 30 mm: height and normal */

struct surface {
    double (*height)(double x, double y);
    struct vec3 (*normal)(double x, double y); /* any length, up */
};

static double sphere(double x, double y)
{
    return sqrt(45 * 45 - (x - 20) * (x - 20) - (y - 15) * (y - 15));
}

static struct vec3 sphere_normal(double x, double y)
{
    return vec(x - 20, y - 15, sphere(x, y));
}

/* The outer side of a torus about the x axis: 40 to the middle of a tube of 20. */
static double tube(double x)
{
    return 40 + sqrt(20 * 20 - (x - 20) * (x - 20) / 4);
}

static double torus(double x, double y)
{
    return sqrt(tube(x) * tube(x) - (y - 15) * (y - 15));
}

static struct vec3 torus_normal(double x, double y)
{
    double slope = -(x - 20) / 4 / sqrt(20 * 20 - (x - 20) * (x - 20) / 4), r = tube(x);
    return vec(-slope * r, y - 15, torus(x, y));
}

static double saddle(double x, double y)
{
    return ((x - 20) * (x - 20) - (y - 15) * (y - 15)) / 50;
}

static struct vec3 saddle_normal(double x, double y)
{
    return vec(-(x - 20) / 25, (y - 15) / 25, 1);
}

static double plane(double x, double y)
{
    return 0.7 * x - 0.4 * y;
}

static struct vec3 plane_normal_of(double x, double y)
{
    (void)x, (void)y;
    return vec(-0.7, 0.4, 1);
}

static double waves(double x, double y)
{
    return 2 * sin(x / 4) * cos(y / 5);
}

static struct vec3 waves_normal(double x, double y)
{
    return vec(-0.5 * cos(x / 4) * cos(y / 5), 0.4 * sin(x / 4) * sin(y / 5), 1);
}

static const struct surface surface[] = {{sphere, sphere_normal},
                                         {torus, torus_normal},
                                         {saddle, saddle_normal},
                                         {plane, plane_normal_of},
                                         {waves, waves_normal}};

enum { SURFACES = sizeof surface / sizeof *surface };

/* Points of it about 0.4 mm apart, moved by noise along the normal, about `origin`. */
static void scan(const struct surface *s, double sigma, struct vec3 origin)
{
    points.n = 0;
    for (int i = 0; i < 7500; i++) {
        double x = 40 * noisy_uniform(), y = 30 * noisy_uniform();
        struct vec3 p = vec(x, y, s->height(x, y));
        if (hypot(x - 30, y - 20) > 2) /* a hole */
            *array_push(&points) =
                vec_add(origin, vec_along(p, sigma * noisy_normal(), vec_unit(s->normal(x, y))));
    }
}

/* The points as a file, with all their digits. */
static const char *write_points(void)
{
    char *text = malloc(80 * points.n + 1);
    size_t at = 0;
    for (size_t i = 0; i < points.n; i++)
        at += (size_t)sprintf(text + at, "%.17g %.17g %.17g\n", points.item[i].x, points.item[i].y,
                              points.item[i].z);
    const char *name = scratch_bytes(text, at);
    free(text);
    return name;
}

static struct cloudmesh_options usual(double spacing, double direction, bool scan_nodes)
{
    return (struct cloudmesh_options){.spacing = spacing,
                                      .direction = direction,
                                      .normals = normals_of("quadric"),
                                      .effort = 1,
                                      .smooth = true,
                                      .scan_nodes = scan_nodes,
                                      .silent = true};
}

/* By bands of so many points, from a file, and read back; what it says of noise and ledger. */
static struct mesh in_bands(const struct cloudmesh_options *options, double noise, size_t at_a_time,
                            int threads)
{
    const struct transform none = transform_identity();
    struct cloud_stream stream;
    struct mesh mesh = {.origin.ledger = NAN};

    ck_assert_int_eq(
        cloud_stream_begin(write_points(), &none, options, 0, threads, &stream, &error), 0);
    ck_assert_int_eq(cloud_stream_nodes(&stream, &error), 0);
    ck_assert_int_eq(cloud_stream_surface(&stream, noise, at_a_time, &error), 0);
    const struct mesh_origin origin = {.ledger = NAN};
    struct out *out = out_open(scratch_name());
    cloud_stream_write(out, &stream, &origin);
    out_close(out);
    ck_assert_msg(mesh_read(scratch_name(), &mesh, &error) == 0, "%s", error.text);
    mesh.origin.noise = stream.noise;
    mesh.origin.ledger = stream.ledger;
    cloud_stream_free(&stream);
    return mesh;
}

/* Of all points in memory. */
static struct mesh in_memory(const struct cloudmesh_options *options, double noise)
{
    struct mesh mesh = {.origin.ledger = NAN};
    struct cloudmesh_options with_mean = *options;
    struct cloudmesh result;
    struct point_grid grid;
    struct vec3s copy = {0};

    for (size_t i = 0; i < points.n; i++)
        *array_push(&copy) = points.item[i];
    double mean = cloudmesh_spacing(options, copy.item, copy.n);
    ck_assert_int_eq(point_grid_make(copy.item, copy.n, mean, 1, &grid, &error), 0);
    double measured = noise_sigma(&grid, 1);
    point_grid_free(&grid);
    mesh.origin.noise = noise >= 0 ? noise : measured;
    with_mean.mean = mean;
    ck_assert_int_eq(cloudmesh_make(&with_mean, &copy, cloud_prepare_noise(noise, measured, mean),
                                    1, &mesh, &result, &error),
                     0);
    array_free(&copy);
    return mesh;
}

/* To the digits that are written. */
static void same(const struct mesh *got, const struct mesh *want)
{
    const double digit6 = 0.51e-6, digit9 = 0.51e-9, far = 1e-15; /* of what is far off */

    ck_assert_uint_eq(got->vertex.n, want->vertex.n);
    ck_assert_uint_eq(got->face.n, want->face.n);
    ck_assert_uint_gt(got->face.n, 100);
    ck_assert_double_eq(got->origin.noise, want->origin.noise);
    ck_assert_double_eq_tol(got->origin.ledger, want->origin.ledger, 1e-6 * want->origin.ledger);
    for (size_t i = 0; i < got->vertex.n; i++) {
        struct vec3 p = got->vertex.item[i], q = want->vertex.item[i];
        struct vec3 n = got->normal.item[i], m = want->normal.item[i];
        double of = digit6 + far * vec_length(q);
        ck_assert_msg(fabs(p.x - q.x) <= of && fabs(p.y - q.y) <= of && fabs(p.z - q.z) <= of,
                      "vertex %zu: %.7f %.7f %.7f, expected %.7f %.7f %.7f", i, p.x, p.y, p.z, q.x,
                      q.y, q.z);
        /* normals are made unit vectors when they are read: a digit more or less */
        ck_assert_msg(vec_distance(n, m) <= 3 * digit9, "normal %zu off by %g", i,
                      vec_distance(n, m));
        ck_assert_double_eq_tol(got->kmax.item[i], want->kmax.item[i], digit9);
        ck_assert_int_eq(got->row.item[i], want->row.item[i]);
        ck_assert_int_eq(got->col.item[i], want->col.item[i]);
    }
    for (size_t i = 0; i < got->face.n; i++)
        for (int k = 0; k < 3; k++)
            ck_assert_int_eq(got->face.item[i].v[k], want->face.item[i].v[k]);
}

/* Root mean square of the angles from the true normals, radians. */
static double off_truth(const struct mesh *mesh, const struct surface *s, struct vec3 origin)
{
    double sum = 0;

    for (size_t i = 0; i < mesh->vertex.n; i++) {
        struct vec3 p = vec_sub(mesh->vertex.item[i], origin);
        double off = vec_distance(mesh->normal.item[i], vec_unit(s->normal(p.x, p.y)));
        sum += off * off;
    }
    return sqrt(sum / (double)mesh->vertex.n);
}

/* The narrowest bands are of one row, with 60 points of it or 200. */
static void both(int k, double sigma, double noise, struct vec3 origin, double spacing,
                 double direction, bool scan_nodes, double most)
{
    struct cloudmesh_options options = usual(spacing, direction, scan_nodes);
    scan(&surface[k], sigma, origin);
    struct mesh want = in_memory(&options, noise);
    for (size_t at_a_time = 1; at_a_time<20 * points.n; at_a_time *= sigma> 0 ? 90000 : 300) {
        struct mesh got = in_bands(&options, noise, at_a_time, at_a_time > 1 ? 2 : 1);
        same(&got, &want);
        double off = off_truth(&got, &surface[k], origin);
        ck_assert_msg(off <= most, "surface %d: normals off by %g, expected %g", k, off, most);
        mesh_free(&got);
    }
    mesh_free(&want);
}

/* What a cubic through 36 points leaves: radius 1.35 mm, 4th derivatives up to 2 / 4^4. */
START_TEST(without_noise)
{
    both(_i, 0, -1, vec(0, 0, 0), 1.2, 0, false, 2e-3);
}
END_TEST

/* Through k points of a disc with a radius of r = 0.4 sqrt(k / pi) mm a slope is uncertain by
 * 2 sigma / (r sqrt(k)), and both slopes by sqrt(2) times that: with 32 points, the fewest,
 * 0.0078 by a quadric, for a cubic twice as much. */
START_TEST(with_noise)
{
    both(_i, 0.02, -1, vec(0, 0, 0), 1.2, 0, false, 0.016);
}
END_TEST

START_TEST(far_from_the_origin)
{
    both(_i, 0, -1, vec(512345678.0, 5234567890.0, 812345.0), 1.2, 0, false, 2e-3);
    if (surface[_i].height == plane || surface[_i].height == waves)
        both(_i, 0.02, -1, vec(512345678.0, 5234567890.0, 812345.0), 1.2, 0, false, 0.016);
}
END_TEST

static const struct {
    double sigma, noise, spacing, direction;
    bool scan_nodes;
    double most;
} way[] = {{0, -1, 1, 27, false, 2e-3},
           {0.02, -1, 4, -60, false, 0.016},
           {0.02, 0.03, 0.8, 90, false, 0.016},
           {0.01, 0, 1.2, 5, false, 0.03}, /* no noise, says the user */
           {0.02, -1, 1.2, 5, true, 0.016},
           {0, 0, 1.2, 5, true, 4e-3}};

START_TEST(turned_coarse_fine)
{
    both(4, way[_i].sigma, way[_i].noise, vec(0, 0, 0), way[_i].spacing, way[_i].direction,
         way[_i].scan_nodes, way[_i].most);
}
END_TEST

/* Points that are there twice count once: to the digits but the last, but where a node at the
 * border takes another point by that, one of a hundred at most. */
START_TEST(points_twice)
{
    struct cloudmesh_options options = usual(1.2, 0, false);
    scan(&surface[4], 0, vec(0, 0, 0));
    size_t n = points.n, others = 0;
    struct mesh want = in_memory(&options, 0);
    for (size_t i = 0; i < n; i += 50) {
        struct vec3 again = points.item[i];
        *array_push(&points) = again;
    }
    struct mesh got = in_bands(&options, 0, 1000, 1);
    ck_assert_uint_eq(got.vertex.n, want.vertex.n);
    for (size_t i = 0; i < got.vertex.n; i++) {
        struct vec3 p = want.vertex.item[i];
        bool other = vec_distance(got.vertex.item[i], p) > 0.02 ||
                     vec_distance(got.normal.item[i], want.normal.item[i]) > 0.05;
        bool inside = fabs(p.x - 20) < 19 && fabs(p.y - 15) < 14 && hypot(p.x - 30, p.y - 20) > 3;
        ck_assert(!other || !inside);
        others += other;
    }
    ck_assert_uint_le(others, got.vertex.n / 100);
    mesh_free(&got);
    mesh_free(&want);
}
END_TEST

/* Too few points for a surface, and a file that is another one by the next look. */
START_TEST(what_cannot_be)
{
    const struct transform none = transform_identity();
    struct cloudmesh_options options = usual(1.2, 0, false);
    struct cloud_stream stream;

    scan(&surface[0], 0, vec(0, 0, 0));
    points.n = 7000;
    const char *file = write_points();
    scratch_no_room(); /* the file is read again */
    ck_assert_int_eq(cloud_stream_begin(file, &none, &options, 0, 1, &stream, &error), 0);
    scratch_room();
    ck_assert_int_eq(cloud_stream_nodes(&stream, &error), 0);
    points.n = 6990;
    write_points();
    ck_assert_int_eq(cloud_stream_surface(&stream, -1, 1000, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "changes while it is read"));
    options.spacing = 3;
    points.n = 40; /* 4 mm apart */
    ck_assert_int_eq(cloud_stream_begin(write_points(), &none, &options, 0, 1, &stream, &error), 0);
    if (cloud_stream_nodes(&stream, &error) == 0) {
        ck_assert_int_eq(cloud_stream_surface(&stream, -1, 10, &error), 0);
        ck_assert_double_ge(stream.ledger, 0);
        cloud_stream_free(&stream);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("stream_surface");
    TCase *tests = tcase_create("stream_surface");
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_loop_test(tests, without_noise, 0, SURFACES);
    tcase_add_loop_test(tests, with_noise, 0, SURFACES);
    tcase_add_loop_test(tests, far_from_the_origin, 0, SURFACES);
    tcase_add_loop_test(tests, turned_coarse_fine, 0, sizeof way / sizeof *way);
    tcase_add_test(tests, points_twice);
    tcase_add_test(tests, what_cannot_be);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
