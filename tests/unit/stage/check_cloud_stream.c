/* cloud_stream: by looks at the file the mesh that cloudmesh makes of the points in memory, and its
 * extent, count and hash; what is no surface, and a file that changes, are seen. */
#include "stage/cloud_stream.h"

#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "io/cloud/cloud_spool.h"
#include "io/mesh/meshfile.h"
#include "scratch.h"

static struct vec3s points;
static struct error error;

static void teardown(void)
{
    array_free(&points);
}

/* About 20 x 15 mm, a point each 0.5, not quite in rows, none in a hole of radius 3. */
static void scan(void)
{
    for (int j = 0; j <= 30; j++)
        for (int i = 0; i <= 40; i++) {
            double x = 0.5 * i + 0.03125 * (j % 3) - 4, y = 0.5 * j + 0.03125 * (i % 4) + 2;
            if (hypot(x - 6, y - 9) > 3)
                *array_push(&points) = vec(x, y, round(64 * sin(x / 3) * cos(y / 4)) / 32);
        }
}

/* The points as a file, whose name lasts. */
static const char *file_of(size_t n)
{
    static char name[300];
    char *text = malloc(60 * n + 1);
    size_t at = 0;
    for (size_t i = 0; i < n; i++)
        at += (size_t)sprintf(text + at, "%.17g %.17g %.17g\n", points.item[i].x, points.item[i].y,
                              points.item[i].z);
    snprintf(name, sizeof name, "%s", scratch_bytes(text, at));
    free(text);
    return name;
}

static struct cloudmesh_options usual(void)
{
    return (struct cloudmesh_options){.normals = normals_of("facet"),
                                      .effort = 1,
                                      .smooth = true,
                                      .scan_nodes = true,
                                      .silent = true};
}

START_TEST(what_it_serves)
{
    struct cloudmesh_options options = usual();
    ck_assert(cloud_stream_serves(&options));
    options.normals = normals_of("quadric");
    ck_assert(cloud_stream_serves(&options));
    options = usual();
    options.error = 0.1;
    ck_assert(!cloud_stream_serves(&options));
    options = usual();
    options.subdivide = true;
    ck_assert(!cloud_stream_serves(&options));
    options = usual();
    options.paper = true;
    ck_assert(!cloud_stream_serves(&options));
    options = usual();
    options.smooth = false;
    ck_assert(!cloud_stream_serves(&options));
    options = usual();
    options.method = CLOUDMESH_DELAUNAY;
    ck_assert(!cloud_stream_serves(&options));
}
END_TEST

/* Count, hash, box and spacing are those of the points. */
START_TEST(looks)
{
    struct cloudmesh_options options = usual();
    struct cloud_stream stream;
    const struct transform metres = transform_scale(1000);
    scan();
    for (int placed = 0; placed < 2; placed++) {
        struct transform place = placed ? metres : transform_identity();
        double s = placed ? 1000 : 1;
        ck_assert_int_eq(cloud_stream_begin(file_of(points.n), &place, &options,
                                            placed ? 1 : points.n, 1, &stream, &error),
                         0);
        ck_assert_uint_eq(stream.kept.n, placed ? 0 : points.n);
        struct box box = {points.item[0], points.item[0]};
        for (size_t i = 0; i < points.n; i++) {
            struct vec3 p = points.item[i];
            box.low = vec(fmin(box.low.x, p.x), fmin(box.low.y, p.y), fmin(box.low.z, p.z));
            box.high = vec(fmax(box.high.x, p.x), fmax(box.high.y, p.y), fmax(box.high.z, p.z));
        }
        ck_assert_uint_eq(stream.n, points.n);
        ck_assert_uint_eq(stream.hash, scan_source_hash(points.item, points.n)); /* as read */
        ck_assert_double_lt(vec_distance(stream.box.low, vec_scale(s, box.low)), 1e-9 * s);
        ck_assert_double_lt(vec_distance(stream.box.high, vec_scale(s, box.high)), 1e-9 * s);
        /* a point for each quarter of a square mm, but at the border */
        ck_assert_double_eq_tol(stream.mean, 0.5 * s, 0.05 * s);
        cloud_stream_free(&stream);
    }
}
END_TEST

/* The mesh stream, read back, and what cloudmesh makes: vertex by vertex and facet by facet. */
static void same_mesh_of(double spacing, double direction, size_t keep, int threads)
{
    struct cloudmesh_options options = usual();
    struct cloud_stream stream;
    const struct transform none = transform_identity();
    options.spacing = spacing;
    options.direction = direction;
    ck_assert_int_eq(
        cloud_stream_begin(file_of(points.n), &none, &options, keep, threads, &stream, &error), 0);
    ck_assert_int_eq(cloud_stream_nodes(&stream, &error), 0);
    const struct mesh_origin origin = {.ledger = NAN};
    struct out *out = out_open(scratch_name());
    cloud_stream_write(out, &stream, &origin);
    out_close(out);
    cloud_stream_free(&stream);
    struct mesh got = {.origin.ledger = NAN}, want = {.origin.ledger = NAN};
    ck_assert_msg(mesh_read(scratch_name(), &got, &error) == 0, "%s", error.text);
    struct vec3s copy = {0};
    struct cloudmesh result;
    for (size_t i = 0; i < points.n; i++)
        *array_push(&copy) = points.item[i];
    ck_assert_int_eq(cloudmesh_make(&options, &copy, 0, 1, &want, &result, &error), 0);
    ck_assert_uint_eq(got.vertex.n, want.vertex.n);
    ck_assert_uint_eq(got.face.n, want.face.n);
    ck_assert_uint_gt(got.face.n, 100);
    for (size_t i = 0; i < got.vertex.n; i++) {
        ck_assert_double_lt(vec_distance(got.vertex.item[i], want.vertex.item[i]), 1e-6);
        ck_assert_double_gt(vec_dot(got.normal.item[i], want.normal.item[i]), 1 - 1e-9);
        ck_assert_int_eq(got.row.item[i], want.row.item[i]);
        ck_assert_int_eq(got.col.item[i], want.col.item[i]);
    }
    for (size_t i = 0; i < got.face.n; i++)
        for (int k = 0; k < 3; k++)
            ck_assert_int_eq(got.face.item[i].v[k], want.face.item[i].v[k]);
    for (size_t i = 0; i < got.face.n; i++) { /* none over the hole */
        struct vec3 p = vec(0, 0, 0);
        for (int k = 0; k < 3; k++)
            p = vec_along(p, 1.0 / 3, got.vertex.item[got.face.item[i].v[k]]);
        ck_assert_double_gt(hypot(p.x - 6, p.y - 9), 1.5);
    }
    mesh_free(&got);
    mesh_free(&want);
    array_free(&copy);
}

/* All points kept, too many to be kept, and none to be kept. */
static void same_mesh(double spacing, double direction, int threads)
{
    same_mesh_of(spacing, direction, points.n, threads);
    same_mesh_of(spacing, direction, points.n - 1, threads);
    same_mesh_of(spacing, direction, 0, threads);
}

START_TEST(the_same_mesh)
{
    scan();
    same_mesh(1, 0, 1);
    same_mesh(0, 0, 1);
    same_mesh(0.8, 30, 2);
    same_mesh(0, 90, 2);
}
END_TEST

/* -1 or 1 of the first two looks. */
static int begun(const char *file)
{
    struct cloudmesh_options options = usual();
    const struct transform none = transform_identity();
    struct cloud_stream stream;
    int status = cloud_stream_begin(file, &none, &options, CLOUD_STREAM_KEEP, 1, &stream, &error);
    if (status == 0)
        cloud_stream_free(&stream);
    return status;
}

START_TEST(no_surface)
{
    ck_assert_int_eq(begun("-"), 1);
    ck_assert_int_eq(begun("/nowhere/at/all"), 1);
    ck_assert_int_eq(begun("/dev/null"), 1);
    ck_assert_int_eq(begun(scratch_text("1 2 3\n4 5 6\n")), 1);
    ck_assert_int_eq(begun(scratch_text("1 2 3\n1 2 4\n1 2 5\n1 2 6\n")), 1); /* upright */
    ck_assert_int_eq(begun(scratch_text("0 0 3\n1 2 4\n2 4 5\n3 6 6\n")), 1); /* one line */
    ck_assert_int_eq(begun(scratch_text("0 0 3\n9 9 4\n0 0 5\n9 9 6\n")), 1); /* two places */
    ck_assert_int_eq(begun(scratch_text("0 0 3\n1 2 4\n2 4 5\n3 6.1 6\n")), 0);
    ck_assert_int_eq(begun(scratch_text("0 0 3\n1 2 four\n2 4 5\n3 7 6\n")), -1);
}
END_TEST

/* Between two looks a point went: that matters where the file is read again, and only there. */
START_TEST(a_file_that_changes)
{
    struct cloudmesh_options options = usual();
    const struct transform none = transform_identity();
    struct cloud_stream stream;
    scan();
    const char *file = file_of(points.n);
    ck_assert_int_eq(cloud_stream_begin(file, &none, &options, 0, 1, &stream, &error), 0);
    ck_assert(cloud_spool_holds(stream.spool));
    file_of(points.n - 1);
    ck_assert_int_eq(cloud_stream_nodes(&stream, &error), 0);
    cloud_stream_free(&stream);
    file = file_of(points.n);
    scratch_no_room();
    ck_assert_int_eq(cloud_stream_begin(file, &none, &options, 0, 1, &stream, &error), 0);
    scratch_room();
    ck_assert(!cloud_spool_holds(stream.spool));
    file_of(points.n - 1);
    ck_assert_int_eq(cloud_stream_nodes(&stream, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "changes while it is read"));
}
END_TEST

/* A grid so wide that no facet has room is told with its size. */
START_TEST(no_facet)
{
    struct cloudmesh_options options = usual();
    const struct transform none = transform_identity();
    struct cloud_stream stream;
    scan();
    options.spacing = 100;
    int status = cloud_stream_begin(file_of(points.n), &none, &options, 0, 1, &stream, &error);
    ck_assert_int_eq(status, 0);
    ck_assert_int_eq(cloud_stream_nodes(&stream, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "100"));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cloud_stream");
    TCase *tests = tcase_create("cloud_stream");
    tcase_add_checked_fixture(tests, NULL, teardown);
    tcase_add_test(tests, what_it_serves);
    tcase_add_test(tests, looks);
    tcase_add_test(tests, the_same_mesh);
    tcase_add_test(tests, no_surface);
    tcase_add_test(tests, a_file_that_changes);
    tcase_add_test(tests, no_facet);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
