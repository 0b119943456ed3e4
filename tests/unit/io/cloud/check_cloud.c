/* cloud: every format, recognised by content, and every refusal. */
#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clouds.h"
#include "scratch.h"

#define PTX_HEAD(matrix) "2\n2\n9 9 9\n1 0 0\n0 1 0\n0 0 1\n" matrix
#define IDENTITY "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"

START_TEST(refused_by_name)
{
    static const char *const known[][2] = {
        {"\xFF\xFE"
         "1 ",
         "UTF-16"},
        {"\xFE\xFF 1", "UTF-16"},
        {"\x1F\x8B\x08", "gzip"},
        {"PK\003\004", "zip"},
        {"BZh91AY", "bzip2"},
        {"\xFD"
         "7zXZ",
         "xz"},
        {"LASF", "LAS"},
        {"ASTM-E57", "E57"},
        {"solid part\nfacet normal 0 0 1\n", "STL"},
        {"OFF\n8 6 0\n1 2 3\n", "OFF"},
        {"# vtk DataFile Version 3.0\n", "VTK"},
        {"ISO-10303-21;\n", "STEP"},
        {"\x01\x02\x03\x04\x05", "binary"},
        {"", "empty"},
        {"\n\n", "no points"},
        {"# x y z\nX Y Z\n", "no points"},
        {"x\x01y and a text that is long enough to be none but for this\n1 2 3\n", ":1: control"},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        clouds_refused(known[i][0], known[i][1]);
    clouds_refused_bytes("1\0.\0005\0 \0002\0 \0003\0\n\0", 16, "UTF-16");
    clouds_refused_bytes("1 2 3\n4 5\0 6\n7 8 9\n", 19, ":2: a NUL byte");
    clouds_refused_bytes("1 2 3\n4 5 6\0\n7 8 9\n", 19, ":2: a NUL byte");
    clouds_refused_bytes("1 2 3 5\n4 5 6 5\0\n7 8 9 5\n", 25, ":2: a NUL byte");
    char iges[200];
    snprintf(iges, sizeof iges, "%-72sS      1\n%-72sG      1\n", "made", "1H,,1H;");
    clouds_refused(iges, "IGES");
    ck_assert_int_eq(
        cloud_read("/nonexistent/cloud.xyz", &clouds.points, &clouds.count, &clouds.error), -1);
    ck_assert_ptr_nonnull(strstr(clouds.error.text, "No such file"));
    ck_assert_int_eq(cloud_read("/tmp", &clouds.points, &clouds.count, &clouds.error), -1);
    ck_assert_ptr_nonnull(strstr(clouds.error.text, "directory"));
}
END_TEST

START_TEST(ptx)
{
    clouds_three(
        PTX_HEAD(IDENTITY) "1.5 -2.25 3000 0.5\n0.5 0.25 -4 0.5\n0 0 0 0.5\n7 8 9 .5 1 2 3\n");
    ck_assert_uint_eq(clouds.count.not_measured, 1);
    ck_assert_uint_eq(clouds.count.heads, 10);
    /* a quarter turn about z, then a shift: x y z -> -y + 10, x + 20, z + 30 */
    clouds_three(
        PTX_HEAD("0 1 0 0\n-1 0 0 0\n0 0 1 0\n10 20 30 1\n") "-22.25 8.5 2970 .5\n0 0 0 0\n-19.75 "
                                                             "9.5 -34 .5\n-12 3 -21 .5\n");
    clouds_three(PTX_HEAD(IDENTITY) "1.5 -2.25 3000\n0.5 0.25 -4\n0 0 0\n0 0 0\n" PTX_HEAD(
        IDENTITY) "0 0 0\n7 8 9\n0 0 0\n0 0 0\n");
    clouds_refused(PTX_HEAD(IDENTITY) "1 2 3\n4 5 6\n",
                   "ends after 2 cells of a PTX grid, expected 4");
    clouds_refused(PTX_HEAD(IDENTITY) "1 2 3\n4 5 6\n1 2 3\n1 2 3\n1 2 3\n",
                   ":15: a line of a PTX head");
    clouds_refused(PTX_HEAD("1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 nan\n") "1 2 3\n", ":10: ");
    clouds_refused(PTX_HEAD("1 0 0 5\n0 1 0 0\n0 0 1 0\n0 0 0 1\n") "1 2 3\n", "PTX matrix");
    clouds_refused("2\n2\n0 0 0\n", "ends in a PTX head");
    clouds_refused("99999999999\n99999999999\n9 9 9\n1 0 0\n0 1 0\n0 0 1\n" IDENTITY "1 2 3\n",
                   "PTX grid of");
}
END_TEST

START_TEST(pcd)
{
    clouds_three(
        "# .PCD v0.7\nVERSION 0.7\nFIELDS rgb hist z y x\nSIZE 4 4 4 4 4\nTYPE F F F F F\n"
        "COUNT 1 3 1 1 1\nWIDTH 4\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 4\nDATA ascii\n"
        "5 1 2 3 3000 -2.25 1.5\n5 1 2 3 -4 0.25 0.5\n5 1 2 3 nan nan nan\n5 1 2 3 9 8 7\n");
    ck_assert_uint_eq(clouds.count.not_finite, 1);
    clouds_refused("VERSION .7\nFIELDS x y z\nPOINTS 3\nDATA ascii\n1 2 3\n4 5 6\n",
                   "expected the 3");
    clouds_refused("VERSION .7\nFIELDS x y z\nPOINTS 1\nDATA ascii\n1 2 3\n4 5 6\n",
                   "expected the 1");
    clouds_refused("VERSION .7\nFIELDS x y z\nDATA binary\n", ":3: PCD with DATA binary");
    clouds_refused("VERSION .7\nFIELDS x y\nDATA ascii\n1 2\n", "without field z");
    clouds_refused("VERSION .7\nFIELDS x y z\nDATA ascii\n1 2 3\n4 5\n", ":5: 2 columns");
    clouds_refused("VERSION .7\nFIELDS x y z\nCOUNT 1 0 1\nDATA ascii\n1 2 3\n", ":3: COUNT");
    clouds_refused("VERSION .7\nFIELDS x y z\n", "ends in a PCD head");
    clouds_refused("VERSION .7\n1 2 3\n", ":2: '1' in a PCD head");
}
END_TEST

START_TEST(obj)
{
    clouds_three(
        "# Wavefront\nmtllib a.mtl\no part\nv 1.5 -2.25 3000\nv 0.5 0.25 -4 1.0 0.5 0.5 0.5\n"
        "vn 0 0 1\nvt 0 0\nv\t7 8 9\ng a\ns off\nf 1//1 2//1 \\\n 3//1\nf 1 2 3\n");
    clouds_refused("v 1 2 3\nv 4 5 6\n7 8 9\n", ":3: '7 8 9', expected a statement");
    clouds_refused("o part\nv 1 2 3\nv 4 five 6\n", ":3: 'five'");
    clouds_refused("o part\nv 1 2 3\nv 4 5\n", ":3: 2 columns");
}
END_TEST

START_TEST(ply)
{
    clouds_three(
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "1.5 -2.25 3000\n0.5 0.25 -4\n1 nan 2\n7 8 9\n3 0 1 2\n");
    ck_assert_uint_eq(clouds.count.not_finite, 1);
}
END_TEST

START_TEST(appends)
{
    ck_assert_int_eq(clouds_text("1 2 3\n"), 0);
    ck_assert_int_eq(
        cloud_read(scratch_text("4 5 6\n7 8 9\n"), &clouds.points, &clouds.count, &clouds.error),
        0);
    ck_assert_uint_eq(clouds.points.n, 3);
    ck_assert_uint_eq(clouds.count.points, 2);
    ck_assert_double_eq(clouds.points.item[0].x, 1);
    ck_assert_double_eq(clouds.points.item[2].x, 7);
}
END_TEST

/* Any bytes at all: an answer, and no more. */
START_TEST(hostile_bytes)
{
    static const char *const start[] = {
        "",          "1\n2\n",     "VERSION 1\nFIELDS x y z\nDATA ascii\n",
        "v 1 2 3\n", "5\n1 2 3\n", PTX_HEAD(IDENTITY)};
    char text[600];
    for (int round = 0; round < 6000; round++) {
        const char *head = start[round % 6];
        size_t n = strlen(head), total = n + clouds_below(400);
        memcpy(text, head, n);
        for (; n < total; n++)
            text[n] = clouds_below(8) ? " 0123.\n,-"[clouds_below(9)] : (char)clouds_below(256);
        if (clouds_bytes(text, total) < 0)
            ck_assert_ptr_nonnull(strstr(clouds.error.text, scratch_name()));
        for (size_t i = 0; i < clouds.points.n; i++)
            ck_assert(isfinite(clouds.points.item[i].x + clouds.points.item[i].y +
                               clouds.points.item[i].z));
    }
}
END_TEST

START_TEST(units)
{
    ck_assert_double_eq(cloud_unit("mm"), 1);
    ck_assert_double_eq(cloud_unit("cm"), 10);
    ck_assert_double_eq(cloud_unit("m"), 1000);
    ck_assert_double_eq(cloud_unit("um"), 0.001);
    ck_assert_double_eq(cloud_unit("inch"), 25.4);
    ck_assert_double_eq(cloud_unit("in"), 25.4);
    ck_assert_double_eq(cloud_unit("ell"), 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cloud");
    TCase *tests = tcase_create("cloud");
    SRunner *runner = srunner_create(suite);

    tcase_add_checked_fixture(tests, clouds_clear, clouds_clear);
    tcase_add_test(tests, refused_by_name);
    tcase_add_test(tests, ptx);
    tcase_add_test(tests, pcd);
    tcase_add_test(tests, obj);
    tcase_add_test(tests, ply);
    tcase_add_test(tests, appends);
    tcase_add_test(tests, hostile_bytes);
    tcase_add_test(tests, units);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
