/* meshfile, stl, off: one pyramid in every format, and each way of being damaged. */
#include <check.h>
#include <ctype.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/mesh/meshfile.h"
#include "scratch.h"

static struct error error;
static struct mesh mesh;

static const double apex[5][3] = {{0, 0, 0}, {10, 0, 0}, {10, 8, 0}, {0, 8, 0}, {5, 4, 3.5}};
static const int side[4][3] = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};

static int read_file(const char *file)
{
    mesh_free(&mesh);
    return mesh_read(file, &mesh, &error);
}

static void is_pyramid(const char *file)
{
    ck_assert_msg(read_file(file) == 0, "%s", error.text);
    ck_assert_uint_eq(mesh.vertex.n, 5);
    ck_assert_uint_eq(mesh.face.n, 4);
    for (size_t f = 0; f < 4; f++) {
        for (int i = 0; i < 3; i++) {
            const double *p = apex[side[f][i]];
            struct vec3 v = mesh.vertex.item[mesh.face.item[f].v[i]];
            ck_assert_double_eq(vec_distance(v, vec(p[0], p[1], p[2])), 0);
        }
    }
}

static void refused(const char *file, const char *says)
{
    ck_assert_msg(read_file(file) == -1, "read, should say: %s", says);
    ck_assert_msg(strstr(error.text, says) != NULL, "%s\n  lacks: %s", error.text, says);
    ck_assert_ptr_nonnull(strstr(error.text, scratch_name()));
    ck_assert_uint_eq(mesh.vertex.n + mesh.face.n, 0);
}

static void put_float(char *p, double value)
{
    float f = (float)value;
    uint32_t bits;

    memcpy(&bits, &f, sizeof bits);
    for (int i = 0; i < 4; i++)
        p[i] = (char)(bits >> 8 * i & 0xff);
}

enum { BINARY = 84 + 4 * 50 };

static void make_binary(char bytes[BINARY], const char *head)
{
    memset(bytes, 0, BINARY);
    memcpy(bytes, head, strlen(head));
    bytes[80] = 4;
    for (int f = 0; f < 4; f++) {
        for (int i = 0; i < 9; i++)
            put_float(bytes + 84 + 50 * f + 12 + 4 * i, apex[side[f][i / 3]][i % 3]);
    }
}

static void make_text(char *text, size_t size, const char *style)
{
    int n = snprintf(text, size, "solid a pyramid%s", style);

    for (int f = 0; f < 4; f++) {
        n += snprintf(text + n, size - (size_t)n, "  facet normal 0 0 1%s  outer loop%s", style,
                      style);
        for (int i = 0; i < 3; i++) {
            const double *p = apex[side[f][i]];
            n += snprintf(text + n, size - (size_t)n, "   VERTEX %.3e\t%g  %g%s", p[0], p[1], p[2],
                          style);
        }
        n += snprintf(text + n, size - (size_t)n, "  endloop%s  endfacet%s", style, style);
    }
    snprintf(text + n, size - (size_t)n, "endsolid a pyramid%s", style);
}

START_TEST(stl_text)
{
    char text[2000];

    make_text(text, sizeof text, "\n");
    is_pyramid(scratch_text(text));
    make_text(text, sizeof text, "\r\n");
    is_pyramid(scratch_text(text));
    make_text(text, sizeof text, "\n\n");
    is_pyramid(scratch_text(text));
    ck_assert(mesh_is_there(scratch_name()));
    for (char *p = text; *p; p++) /* as older systems write it */
        *p = (char)toupper((unsigned char)*p);
    is_pyramid(scratch_text(text));
    ck_assert(mesh_is_there(scratch_name()));
}
END_TEST

START_TEST(stl_binary)
{
    char bytes[BINARY + 10];

    make_binary(bytes, "made by nobody");
    is_pyramid(scratch_bytes(bytes, BINARY));
    make_binary(bytes, "solid made by nobody facet normal");
    is_pyramid(scratch_bytes(bytes, BINARY));
    /* Not even the noughts after the head tell this one, only its size. */
    make_binary(bytes, "solid");
    memset(bytes + 5, ' ', 75);
    is_pyramid(scratch_bytes(bytes, BINARY));
}
END_TEST

START_TEST(stl_damaged)
{
    char bytes[BINARY], text[2000], *p;

    make_binary(bytes, "solid");
    refused(scratch_bytes(bytes, BINARY - 1), "ends after 3 facets, expected 4");
    bytes[83] = (char)0x80;
    refused(scratch_bytes(bytes, BINARY), "ends after 4 facets, expected 2147483652");
    make_binary(bytes, "");
    refused(scratch_bytes(bytes, 60), "60 bytes");
    put_float(bytes + 84 + 50 + 20, (double)NAN);
    refused(scratch_bytes(bytes, BINARY), "facet 1");
    make_binary(bytes, "");
    bytes[80] = 0;
    refused(scratch_bytes(bytes, 84), "without facets");

    make_text(text, sizeof text, "\n");
    *strstr(text, "endsolid") = '\0';
    refused(scratch_text(text), "ends after 4 facets");
    make_text(text, sizeof text, "\n");
    strstr(text, "VERTEX")[8] = 'x';
    refused(scratch_text(text), ":4: ");
    make_text(text, sizeof text, "\n");
    p = strstr(text, "VERTEX");
    memcpy(p, "vortex", 6);
    refused(scratch_text(text), ":4: ");
    make_text(text, sizeof text, "\n");
    p = strstr(text, "   VERTEX");
    memmove(p, strchr(p, '\n') + 1, strlen(strchr(p, '\n')));
    refused(scratch_text(text), "wrong place");
    refused(scratch_text("solid nothing\nendsolid nothing\n"), "without facets");
    refused(scratch_text("solid\nfacet\nvertex 1 2 inf\n"), "three finite");
}
END_TEST

START_TEST(off_text)
{
    is_pyramid(scratch_text("OFF\n5 4 0\n0 0 0\n10 0 0\n10 8 0\n0 8 0\n5 4 3.5\n"
                            "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n"));
    is_pyramid(scratch_text("OFF 5 4 8 # counts\n# corners\n0 0 0\n\n10 0 0\n10 8 0\n0 8 0\n"
                            "5 4 3.5\n3 0 1 4 255 0 0\n3 1 2 4\n3 2 3 4\n3 3 0 4"));
    is_pyramid(
        scratch_text("COFF\n5 4 0\n0 0 0 255 0 0 9\n10 0 0 0 0 0 0\n10 8 0 0 0 0 0\n"
                     "0 8 0 1 1 1 1\n5 4 3.5 0 0 0 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n"));
    ck_assert_int_eq(read_file(scratch_text("NOFF\n4 1 0\n0 0 0 0 0 2\n1 0 0 0 0 1\n1 1 0 0 0 1\n"
                                            "0 1 0 0 1 1\n4 0 1 2 3\n")),
                     0);
    ck_assert_uint_eq(mesh.face.n, 2);
    ck_assert_uint_eq(mesh.normal.n, 4);
    ck_assert_double_eq(mesh.normal.item[0].z, 1);
}
END_TEST

START_TEST(off_damaged)
{
    refused(scratch_text("OFF\n"), "counts");
    refused(scratch_text("OFF\n3 x\n"), "counts");
    refused(scratch_text("OFF\n3 0 0\n"), "0 faces");
    refused(scratch_text("OFF\n4000000000 1 0\n"), "4000000000 vertices");
    refused(scratch_text("OFF\n3 1 0\n0 0 0\n1 0 0\n"), "ends after 2 vertices");
    refused(scratch_text("OFF\n3 1 0\n0 0 0\n1 0 0\n1 1\n3 0 1 2\n"), ":5: ");
    refused(scratch_text("OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 nan\n3 0 1 2\n"), ":5: ");
    refused(scratch_text("OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 3\n"), "index 3");
    refused(scratch_text("OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n2 0 1\n"), "a face");
    refused(scratch_text("OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n4000000000 0 1 2\n"), "corners");
    refused(scratch_text("OFF\n3 2 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n"), "ends after 1 facets");
}
END_TEST

START_TEST(ply_and_what_is_none)
{
    is_pyramid(scratch_text("ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\n"
                            "property float y\nproperty float z\nelement face 4\n"
                            "property list uchar int vertex_indices\nend_header\n"
                            "0 0 0\n10 0 0\n10 8 0\n0 8 0\n5 4 3.5\n"
                            "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n"));
    refused(scratch_text("1 2 3\n4 5 6\n"), "ply");
    refused(scratch_text(""), "");
    ck_assert_int_eq(read_file("no/such/file"), -1);
}
END_TEST

/* Text of two bytes a letter is told as that, and not taken for a binary STL; and a binary STL
 * whose name is so written is one. */
START_TEST(utf_16)
{
    static const char *const text[] = {"ply\nformat ascii 1.0\n", "solid a\n", "OFF\n5 4 8\n"};
    char bytes[BINARY];
    for (int i = 0; i < 3; i++)
        for (int high = 0; high < 2; high++)
            for (int mark = 0; mark < 2; mark++) {
                char two[100] = {0};
                size_t n = 0;
                if (mark)
                    memcpy(two, high ? "\xFE\xFF" : "\xFF\xFE", 2);
                for (n = 2 * (size_t)mark; text[i][n / 2 - (size_t)mark]; n += 2)
                    two[n + (size_t)high] = text[i][n / 2 - (size_t)mark];
                refused(scratch_bytes(two, n), "text in UTF-16 encoding, expected UTF-8 or ASCII");
            }
    make_binary(bytes, "");
    memcpy(bytes, "s\0o\0l\0i\0d", 9);
    is_pyramid(scratch_bytes(bytes, BINARY));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("meshfile");
    TCase *tests = tcase_create("meshfile");
    tcase_add_test(tests, stl_text);
    tcase_add_test(tests, stl_binary);
    tcase_add_test(tests, stl_damaged);
    tcase_add_test(tests, off_text);
    tcase_add_test(tests, off_damaged);
    tcase_add_test(tests, ply_and_what_is_none);
    tcase_add_test(tests, utf_16);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
