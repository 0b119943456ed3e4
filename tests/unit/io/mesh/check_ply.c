/* ply: what is written reads back; foreign files of each format; damage is refused. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/num.h"
#include "io/mesh/ply.h"
#include "scratch.h"

static struct error error;
static struct mesh mesh;

static int read_text(const char *text)
{
    mesh_free(&mesh);
    return ply_read(scratch_text(text), &mesh, &error);
}

static void refused(const char *text, const char *says)
{
    ck_assert_msg(read_text(text) == -1, "read, should say: %s", says);
    ck_assert_msg(strstr(error.text, says) != NULL, "%s\n  lacks: %s", error.text, says);
    ck_assert_ptr_nonnull(strstr(error.text, scratch_name()));
    ck_assert_uint_eq(mesh.vertex.n, 0);
}

#define HEAD(vertices, faces)                                                                  \
    "ply\nformat ascii 1.0\nelement vertex " vertices "\nproperty float x\nproperty float y\n" \
    "property float z\nelement face " faces "\nproperty list uchar int vertex_indices\n"       \
    "end_header\n"
#define THREE "0 0 0\n10 0 0\n0 10 5\n"

static struct mesh small_mesh(void)
{
    struct mesh m = {
        .origin = {.spacing = 4, .direction = -12.25, .ledger = 0.01201, .placed = true}};
    for (int i = 0; i < 4; i++) {
        *array_push(&m.vertex) = vec(i % 2 * 10 + 1.0 / 3, i / 2 * -7.25, 1e6 + i);
        *array_push(&m.normal) = vec_unit(vec(0.1 * i, -0.2, 1));
        *array_push(&m.row) = i / 2;
        *array_push(&m.col) = i % 2 - 1;
        *array_push(&m.kmax) = 0.125 * i - 0.1;
    }
    *array_push(&m.face) = (struct face){{0, 1, 2}};
    *array_push(&m.face) = (struct face){{2, 1, 3}};
    for (int i = 0; i < 16; i++)
        m.origin.place.m[i / 4][i % 4] = i == 5 ? 6.123233995736766e-17 : 1.0 / (i + 1) * 25.4;
    m.origin.source = mem_string("a b\n.xyz", 8);
    m.origin.maker = mem_string("cloud2mesh", 10);
    *array_push(&m.origin.surface) =
        (struct mesh_surface){mem_string("a part.igs:7", 12), 4.634, {1.5, -2, 1e-6}};
    *array_push(&m.origin.surface) = (struct mesh_surface){.name = mem_string("none:9", 6)};
    return m;
}

static void write_mesh(const struct mesh *m)
{
    struct out *out = out_open(scratch_name());
    ply_write(out, m, 1);
    out_close(out);
}

static void expect_close(struct vec3 a, struct vec3 b, double within)
{
    ck_assert_double_le(vec_distance(a, b), within);
}

START_TEST(reads_back_what_it_wrote)
{
    struct mesh m = small_mesh();
    write_mesh(&m);
    ck_assert_int_eq(ply_read(scratch_name(), &mesh, &error), 0);
    ck_assert_uint_eq(mesh.vertex.n, 4);
    ck_assert_uint_eq(mesh.normal.n, 4);
    ck_assert_uint_eq(mesh.row.n, 4);
    ck_assert_uint_eq(mesh.col.n, 4);
    ck_assert_uint_eq(mesh.kmax.n, 4);
    ck_assert_uint_eq(mesh.face.n, 2);
    ck_assert_uint_eq(mesh.origin.surface.n, 2);
    ck_assert_str_eq(mesh.origin.surface.item[0].name, "a part.igs:7");
    ck_assert_double_eq(mesh.origin.surface.item[0].radius, 4.634);
    ck_assert_double_eq(mesh.origin.surface.item[0].at.y, -2);
    ck_assert_str_eq(mesh.origin.surface.item[1].name, "none:9");
    ck_assert_double_eq(mesh.origin.surface.item[1].radius, 0);
    for (size_t i = 0; i < 4; i++) {
        ck_assert_double_eq(mesh.vertex.item[i].x, num_round(m.vertex.item[i].x, 6));
        ck_assert_double_eq(mesh.vertex.item[i].y, num_round(m.vertex.item[i].y, 6));
        ck_assert_double_eq(mesh.vertex.item[i].z, num_round(m.vertex.item[i].z, 6));
        expect_close(mesh.normal.item[i], m.normal.item[i], 2e-9);
        ck_assert_double_eq_tol(vec_length(mesh.normal.item[i]), 1, 1e-15);
        ck_assert_int_eq(mesh.row.item[i], m.row.item[i]);
        ck_assert_int_eq(mesh.col.item[i], m.col.item[i]);
        ck_assert_double_eq_tol(mesh.kmax.item[i], m.kmax.item[i], 1e-9);
    }
    ck_assert_mem_eq(mesh.face.item, m.face.item, 2 * sizeof *m.face.item);
    mesh_free(&m);
}
END_TEST

START_TEST(origin_reads_back)
{
    struct mesh m = small_mesh();
    write_mesh(&m);
    ck_assert_int_eq(ply_read(scratch_name(), &mesh, &error), 0);
    ck_assert_double_eq(mesh.origin.spacing, 4);
    ck_assert_double_eq(mesh.origin.direction, -12.25);
    ck_assert_double_eq(mesh.origin.ledger, 0.0121); /* 0.01201, rounded up */
    ck_assert_str_eq(mesh.origin.maker, "cloud2mesh");
    ck_assert_str_eq(mesh.origin.source, "a b?.xyz"); /* a line end in a name ends no line */
    ck_assert(mesh.origin.placed);
    ck_assert_mem_eq(&mesh.origin.place, &m.origin.place, sizeof m.origin.place);
    mesh_free(&m);
}
END_TEST

START_TEST(stream_is_as_documented)
{
    struct mesh m = {.origin = {.spacing = 4, .ledger = 0.012}};
    for (int i = 0; i < 3; i++) {
        *array_push(&m.vertex) = vec(i == 1, i == 2, -0.0);
        *array_push(&m.normal) = vec(0, 0, 1);
    }
    *array_push(&m.face) = (struct face){{0, 1, 2}};
    m.origin.maker = mem_string("cloud2mesh", 10);
    write_mesh(&m);
    size_t n;
    char *text = scratch_read(&n);
    ck_assert_str_eq(text, "ply\n"
                           "format ascii 1.0\n"
                           "comment cloudmill mesh 1\n"
                           "comment spacing 4\n"
                           "comment direction 0\n"
                           "comment ledger cloud2mesh 0.0120\n"
                           "element vertex 3\n"
                           "property double x\n"
                           "property double y\n"
                           "property double z\n"
                           "property double nx\n"
                           "property double ny\n"
                           "property double nz\n"
                           "element face 1\n"
                           "property list uchar int vertex_indices\n"
                           "end_header\n"
                           "0.000000 0.000000 0.000000 0.000000000 0.000000000 1.000000000\n"
                           "1.000000 0.000000 0.000000 0.000000000 0.000000000 1.000000000\n"
                           "0.000000 1.000000 0.000000 0.000000000 0.000000000 1.000000000\n"
                           "3 0 1 2\n");
    free(text);
    mesh_free(&m);
}
END_TEST

START_TEST(foreign_says_nothing)
{
    ck_assert_int_eq(read_text(HEAD("3", "1") THREE "3 0 1 2\n"), 0);
    ck_assert_uint_eq(mesh.normal.n, 0);
    ck_assert_uint_eq(mesh.row.n, 0);
    ck_assert_uint_eq(mesh.kmax.n, 0);
    ck_assert_ptr_null(mesh.origin.source);
    ck_assert_ptr_null(mesh.origin.maker);
    ck_assert_double_eq(mesh.origin.spacing, 0);
    ck_assert_double_nan(mesh.origin.ledger);
    ck_assert(!mesh.origin.placed);
}
END_TEST

START_TEST(polygons_become_fans)
{
    ck_assert_int_eq(read_text(HEAD("5", "2") THREE "1 1 1\n2 2 2\n5 4 3 2 1 0\n4 0 1 2 3\n"), 0);
    static const struct face want[] = {
        {{4, 3, 2}}, {{4, 2, 1}}, {{4, 1, 0}}, {{0, 1, 2}}, {{0, 2, 3}}};
    ck_assert_uint_eq(mesh.face.n, 5);
    ck_assert_mem_eq(mesh.face.item, want, sizeof want);
}
END_TEST

/* Blanks, empty lines, CRLF, unknown elements and properties, lists inside the vertices. */
/* Plain rows, which are read at once, among others: each is what it says. */
START_TEST(rows_of_all_kinds)
{
    static const char *const row[] = {"0 0 0\n10 0 0\n0 10 5\n", "0 -0 0e0\n1e1 0 +0\n0 10. 5\n",
                                      "0 0 0\r\n10\t0  0\r\n 0 10 5 \n",
                                      "\n0 0 0\n\n10 0 0\n0 10 5\n"};
    char text[600];
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        snprintf(text, sizeof text, HEAD("3", "3") "%s3 0 1 2\n4 2 1 0 2\n\t3 2 0 1.0", row[i]);
        ck_assert_int_eq(read_text(text), 0);
        ck_assert_uint_eq(mesh.vertex.n, 3);
        ck_assert_uint_eq(mesh.face.n, 4);
        ck_assert(mesh.vertex.item[1].x >= 10 && mesh.vertex.item[1].x <= 10);
        ck_assert(mesh.vertex.item[2].z >= 5 && mesh.vertex.item[2].z <= 5);
        ck_assert_int_eq(mesh.face.item[1].v[0], 2);
        ck_assert_int_eq(mesh.face.item[3].v[2], 1);
    }
    refused(HEAD("3", "2") THREE "3 0 1 2\n3 0 1 3\n", "vertex index 3");
    refused(HEAD("3", "2") THREE "3 0 1 2\n3 0 1\n", "too few numbers");
    refused(HEAD("3", "2") THREE "3 0 1 2\n3 0 1 2 2\n", "expected a line end");
    refused(HEAD("3", "1") "0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n", "z");
}
END_TEST

START_TEST(layout_is_free)
{
    ck_assert_int_eq(
        read_text(
            "ply\r\nformat ascii 1.0\r\nobj_info made by hand\r\ncomment source of this: me\r\n"
            "element camera 2\r\nproperty float f\r\nproperty list uchar int tags\r\n"
            "element nothing 1000000000000\r\n"
            "element vertex 3\r\nproperty uchar red\r\nproperty float z\r\n"
            "property list int float w\r\nproperty float x\r\nproperty float nx\r\n"
            "property float y\r\nelement face 1\r\nproperty uchar flag\r\n"
            "property list uint8 uint32 vertex_index\r\nproperty list uchar float uv\r\n"
            "end_header\r\n"
            "35 3 1 2 3\r\n35 0\r\n\r\n"
            "1 5 0 1 7 2\r\n  2\t6 2 9 9  3 7 4 \r\n3 7 1 nan 5 inf 6\r\n"
            "8 3 0 1 2 2 .5 .5\r\n\r\n\r\n"),
        0);
    ck_assert_uint_eq(mesh.vertex.n, 3);
    expect_close(mesh.vertex.item[0], vec(1, 2, 5), 0);
    expect_close(mesh.vertex.item[1], vec(3, 4, 6), 0);
    expect_close(mesh.vertex.item[2], vec(5, 6, 7), 0);
    ck_assert_uint_eq(mesh.normal.n, 0); /* nx alone is no normal */
    ck_assert_uint_eq(mesh.face.n, 1);
}
END_TEST

/* Cut anywhere, a file is refused; nothing else happens. */
START_TEST(cut_anywhere_is_refused)
{
    const char *text = HEAD("3", "2") THREE "3 0 1 2\n3 2 1 0\n";
    for (size_t n = 0; n + 1 < strlen(text); n++) /* the last line end may be missing */
        ck_assert_int_eq(ply_read(scratch_bytes(text, n), &mesh, &error), -1);
}
END_TEST

START_TEST(rows_are_counted)
{
    refused(HEAD("4", "0") THREE, ":12: the file ends after 3 rows of element vertex, expected 4");
    refused(HEAD("3", "2") THREE "3 0 1 2\n",
            ":13: the file ends after 1 rows of element face, expected 2");
    refused(HEAD("3", "1") THREE "3 0 1 2\n\n3 0 1 2\n",
            ":15: more than the 1 rows of element face");
    refused(HEAD("3", "1") "0 0 0\n10 0 0 5\n0 10 5\n3 0 1 2\n", ":11: '5' after the last");
    refused(HEAD("3", "1") "0 0 0\n10 0\n0 10 5\n3 0 1 2\n", ":11: too few numbers");
    refused(HEAD("4294967295", "1"), "4294967295 vertices");
    refused(HEAD("-5", "1"), ":3: PLY element with the count '-5'");
    refused(HEAD("18446744073709551617", "1"), "18446744073709551617");
    refused(HEAD("0", "0"), "no vertices");
    refused(HEAD("3", "0") THREE, "no faces");
}
END_TEST

START_TEST(faces_are_checked)
{
    refused(HEAD("3", "1") THREE "3 0 1 3\n", ":13: face 0 has vertex index 3, expected 0 to 2");
    refused(HEAD("3", "1") THREE "3 0 -1 2\n", "vertex index -1");
    refused(HEAD("3", "1") THREE "3 0 0.5 2\n", "vertex index 0.5");
    refused(HEAD("3", "1") THREE "3 0 nan 2\n", "vertex index");
    refused(HEAD("3", "1") THREE "3 0 1e300 2\n", "vertex index");
    refused(HEAD("3", "1") THREE "2 0 1\n", "face 0 has 2 corners");
    refused(HEAD("3", "1") THREE "-3 0 1 2\n", "length -3");
    refused(HEAD("3", "1") THREE "4294967295 0 1 2\n", "too few");
    refused(HEAD("3", "1") THREE "1e99 0 1 2\n", "length 1e+99");
}
END_TEST

START_TEST(numbers_are_checked)
{
    refused(HEAD("3", "1") "0 0 0\n1 nan 0\n0 10 5\n3 0 1 2\n",
            ":11: vertex 1 has a y that is no finite");
    refused(HEAD("3", "1") "0 0 0\n1 1e999 0\n0 10 5\n3 0 1 2\n", "no finite");
    refused(HEAD("3", "1") "0 0 0\n1 0x10 0\n0 10 5\n3 0 1 2\n", ":11: '0x10' is no number");
    refused(HEAD("3", "1") "0 0 0\n1 2,5 0\n0 10 5\n3 0 1 2\n", "'2,5' is no number");
}
END_TEST

START_TEST(head_is_checked)
{
    refused("", "empty");
    refused("plyx\n1 2 3\n", "the line 'ply'");
    refused("ply\nelement vertex 0\nend_header\n", "no format");
    refused("ply\nformat binary_middle_endian 1.0\nend_header\n", "binary_middle_endian");
    refused("ply\nformat ascii 1.0\n", "end_header");
    refused("ply\nformat ascii 1.0\nproperty float x\nend_header\n", "an element first");
    refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\nend_header\n", "'quad'");
    refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty list int x\nend_header\n", ":4: ");
    refused("ply\nformat ascii 1.0\nelement vertex 1\nelement vertex 1\nend_header\n", "second");
    refused("ply\nformat ascii 1.0\nelement vertex 1\n1 2 3\nend_header\n",
            ":4: '1' in the PLY head");
    refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
            "end_header\n1 2\n",
            "no property z");
    refused("ply\nformat ascii 1.0\nend_header\n", "without element vertex");
    refused("ply\nformat ascii 1.0\ncomment cloudmill mesh 2\nend_header\n",
            ":3: mesh stream of version '2'");
    refused("ply\nformat ascii 1.0\ncomment place 1 2 3\nend_header\n", ":3: comment place with 3");
}
END_TEST

START_TEST(points_alone)
{
    struct vec3s points = {0};
    struct reader r;
    size_t faces;
    *array_push(&points) = vec(9, 9, 9);
    const char *text = HEAD("3", "1") "1 2 3\nnan 5 6\n7 8 9\n3 0 1 99\n";
    ck_assert_int_eq(reader_open(&r, scratch_text(text), &error), 0);
    ck_assert_int_eq(ply_read_points(&r, &points, &faces, &error), 0);
    ck_assert_uint_eq(faces, 1);
    reader_close(&r);
    ck_assert_uint_eq(points.n, 4);
    expect_close(points.item[0], vec(9, 9, 9), 0);
    expect_close(points.item[1], vec(1, 2, 3), 0);
    ck_assert_double_nan(points.item[2].x);
    expect_close(points.item[3], vec(7, 8, 9), 0);
    array_free(&points);
}
END_TEST

static void clear(void)
{
    mesh_free(&mesh);
}

/* A mesh of many parts, written by several threads, gives the bytes of one. */
START_TEST(threads)
{
    enum { SIDE = 100 };
    static const int by[] = {1, 2, 3, 0};
    for (int i = 0; i < SIDE * SIDE; i++) {
        *array_push(&mesh.vertex) = vec(i / 7.0, i % 11 / 3.0, -i * 1e-3);
        *array_push(&mesh.normal) = vec(0, 0.6, 0.8);
        *array_push(&mesh.row) = i / SIDE;
        *array_push(&mesh.col) = i % SIDE;
        *array_push(&mesh.kmax) = 1.0 / (i + 1);
        if (i >= SIDE)
            *array_push(&mesh.face) = (struct face){{i - SIDE, i - 1, i}};
    }
    char *text[4];
    size_t n[4];
    for (int k = 0; k < 4; k++) {
        struct out *out = out_open(scratch_name());
        ply_write(out, &mesh, by[k]);
        out_close(out);
        text[k] = scratch_read(&n[k]);
        ck_assert_uint_eq(n[k], n[0]);
        ck_assert_int_eq(memcmp(text[k], text[0], n[0]), 0);
    }
    ck_assert_uint_gt(n[0], 60 * SIDE * SIDE);
    ck_assert_str_eq(text[0] + n[0] - strlen("3 9899 9998 9999\n"), "3 9899 9998 9999\n");
    for (int k = 0; k < 4; k++)
        free(text[k]);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("ply");
    TCase *tests = tcase_create("ply");
    SRunner *runner = srunner_create(suite);

    tcase_add_checked_fixture(tests, clear, clear);
    tcase_add_test(tests, reads_back_what_it_wrote);
    tcase_add_test(tests, origin_reads_back);
    tcase_add_test(tests, stream_is_as_documented);
    tcase_add_test(tests, foreign_says_nothing);
    tcase_add_test(tests, polygons_become_fans);
    tcase_add_test(tests, rows_of_all_kinds);
    tcase_add_test(tests, layout_is_free);
    tcase_add_test(tests, cut_anywhere_is_refused);
    tcase_add_test(tests, rows_are_counted);
    tcase_add_test(tests, faces_are_checked);
    tcase_add_test(tests, numbers_are_checked);
    tcase_add_test(tests, head_is_checked);
    tcase_add_test(tests, points_alone);
    tcase_add_test(tests, threads);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
