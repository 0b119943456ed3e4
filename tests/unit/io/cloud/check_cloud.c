/* cloud: every format, recognised by content, and every refusal. */
#include <check.h>
#include <math.h>
#include <stdint.h>
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
        {"LASF", "ends in the head of a LAS file"},
        {"ASTM-E57", "pdal translate"},
        {"solid part\nfacet normal 0 0 1\n", "STL"},
        {"OFF\n8 6 0\n1 2 3\n", "the OFF file ends after 1 vertices"},
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
        cloud_read("/nonexistent/cloud.xyz", 1, &clouds.points, &clouds.count, &clouds.error), -1);
    ck_assert_ptr_nonnull(strstr(clouds.error.text, "No such file"));
    ck_assert_int_eq(cloud_read("/tmp", 1, &clouds.points, &clouds.count, &clouds.error), -1);
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
    clouds_refused("VERSION .7\nFIELDS x y z\nDATA binary_compressed\n", "pcl_convert_pcd");
    clouds_refused("VERSION .7\nFIELDS x y z\nDATA raw\n", ":3: PCD with DATA raw");
    clouds_refused("VERSION .7\nFIELDS x y\nDATA ascii\n1 2\n", "without field z");
    clouds_refused("VERSION .7\nFIELDS x y z\nDATA ascii\n1 2 3\n4 5\n", ":5: 2 columns");
    clouds_refused("VERSION .7\nFIELDS x y z\nCOUNT 1 0 1\nDATA ascii\n1 2 3\n", ":3: COUNT");
    clouds_refused("VERSION .7\nFIELDS x y z\n", "ends in a PCD head");
    clouds_refused("VERSION .7\n1 2 3\n", ":2: '1' in a PCD head");
}
END_TEST

/* Numbers as binary files hold them, on whatever machine. */
static size_t put(char *p, uint64_t value, int n)
{
    for (int i = 0; i < n; i++)
        p[i] = (char)(value >> 8 * i);
    return (size_t)n;
}

static size_t put_float(char *p, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return put(p, bits, 4);
}

static size_t put_double(char *p, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return put(p, bits, 8);
}

static const double three[][3] = {{1.5, -2.25, 3000}, {0.5, 0.25, -4}, {7, 8, 9}};

/* The points that were read are those of `three`. */
static void read_three(const char *bytes, size_t n)
{
    ck_assert_msg(clouds_bytes(bytes, n) == 0, "%s", clouds.error.text);
    ck_assert_uint_eq(clouds.points.n, 3);
    for (size_t i = 0; i < 3; i++) {
        ck_assert_double_eq_tol(clouds.points.item[i].x, three[i][0], 1e-9);
        ck_assert_double_eq_tol(clouds.points.item[i].y, three[i][1], 1e-9);
        ck_assert_double_eq_tol(clouds.points.item[i].z, three[i][2], 1e-9);
    }
}

START_TEST(pcd_binary)
{
    char file[1000];
    static const char head[] = "VERSION .7\nFIELDS a y b x z\nSIZE 2 8 1 4 4\nTYPE U F I F F\n"
                               "COUNT 1 1 3 1 1\nWIDTH 4\nHEIGHT 1\nPOINTS 4\nDATA binary\n";
    size_t n = strlen(head);
    memcpy(file, head, n);
    for (int i = 0; i < 4; i++) {
        const double *p = three[i == 3 ? 2 : i];
        n += put(file + n, 0x0A0D, 2); /* bytes of line ends */
        n += put_double(file + n, i == 2 ? NAN : p[1]);
        n += put(file + n, 0, 3);
        n += put_float(file + n, (float)p[0]);
        n += put_float(file + n, (float)p[2]);
    }
    read_three(file, n);
    ck_assert_uint_eq(clouds.count.not_finite, 1);
    clouds_refused_bytes(file, n - 1, "3 points, expected the 4 of its PCD head");
    clouds_refused("VERSION .7\nFIELDS x y z\nPOINTS 1\nDATA binary\n", "without SIZE");
    clouds_refused("VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nPOINTS 1\nDATA binary\n", "without TYPE");
    clouds_refused("VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nDATA binary\n",
                   "without POINTS");
    clouds_refused("VERSION .7\nFIELDS x y z\nSIZE 4 4 2\nTYPE F F I\nPOINTS 1\nDATA binary\n",
                   "field z of type I 2");
    clouds_refused("VERSION .7\nFIELDS x y z\nSIZE 4 4 9\n", ":3: SIZE with '9'");
    clouds_refused("VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F D\n", ":4: TYPE with 'D'");
    clouds_refused("VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 4000000000\n"
                   "DATA binary\n",
                   "0 points, expected the 4000000000");
}
END_TEST

/* A LAS file of version 1.minor and a point format with the points `three` and one that is
 * withheld before the last; its length. */
static size_t las(char *file, int minor, int format, size_t record)
{
    size_t head = minor == 4 ? 375 : minor == 3 ? 235 : 227, n = head + 10;
    memset(file, 0, n);
    memcpy(file, "LASF", 4);
    put(file + 24, 1, 1), put(file + 25, (uint64_t)minor, 1);
    put(file + 94, head, 2), put(file + 96, n, 4);
    put(file + 104, (uint64_t)format, 1), put(file + 105, record, 2);
    if (minor == 4)
        put(file + 247, 4, 8);
    else
        put(file + 107, 4, 4);
    for (int i = 0; i < 3; i++) {
        put_double(file + 131 + 8 * i, 0.01 * (i + 1));
        put_double(file + 155 + 8 * i, 100.0 * i);
    }
    for (int k = 0; k < 4; k++) {
        const double *p = three[k == 3 ? 2 : k];
        memset(file + n, 0, record);
        for (int i = 0; i < 3; i++)
            put(file + n + 4 * i, (uint64_t)llround((p[i] - 100.0 * i) / (0.01 * (i + 1))), 4);
        if (k == 2)
            put(file + n + 15, format < 6 ? 0x80 : 4, 1);
        n += record;
    }
    return n;
}

START_TEST(las_files)
{
    static const size_t record[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
    char file[1000];
    for (int format = 0; format < 11; format++) {
        int minor = format < 2 ? format % 3 : format < 4 ? 2 : format < 6 ? 3 : 4;
        size_t n = las(file, minor, format, record[format] + (size_t)(format % 2));
        ck_assert_msg(clouds_bytes(file, n) == 0, "%d: %s", format, clouds.error.text);
        ck_assert_uint_eq(clouds.points.n, 3);
        ck_assert_uint_eq(clouds.count.withheld, 1);
        for (size_t i = 0; i < 3; i++) {
            ck_assert_double_eq_tol(clouds.points.item[i].x, three[i][0], 0.0051);
            ck_assert_double_eq_tol(clouds.points.item[i].y, three[i][1], 0.0101);
            ck_assert_double_eq_tol(clouds.points.item[i].z, three[i][2], 0.0151);
        }
        clouds_refused_bytes(file, n - 1, "ends after 3 points, expected the 4");
        clouds_refused_bytes(file, 230, "ends in the head of a LAS file"); /* before its data */
        put(file + 105, record[format] - 1, 2);
        clouds_refused_bytes(file, n, "records of length");
    }
    size_t n = las(file, 2, 0, 20);
    put(file + 104, 0x80 | 3, 1);
    clouds_refused_bytes(file, n, "LAZ file");
    put(file + 104, 11, 1);
    clouds_refused_bytes(file, n, "point format 11");
    n = las(file, 2, 0, 20);
    put(file + 25, 5, 1);
    clouds_refused_bytes(file, n, "version 1.5");
    n = las(file, 2, 0, 20);
    put(file + 94, 100, 2);
    clouds_refused_bytes(file, n, "head of length 100");
    n = las(file, 2, 0, 20);
    put(file + 96, 200, 4);
    clouds_refused_bytes(file, n, "points from byte 200");
    n = las(file, 2, 0, 20);
    put_double(file + 139, 0);
    clouds_refused_bytes(file, n, "scale 0");
    put_double(file + 139, NAN);
    clouds_refused_bytes(file, n, "scale nan");
    put_double(file + 139, 1);
    put_double(file + 163, INFINITY);
    clouds_refused_bytes(file, n, "offset inf");
    n = las(file, 4, 6, 30);
    put(file + 247, UINT64_MAX, 8);
    clouds_refused_bytes(file, n, "ends after 4 points, expected the 18446744073709551615");
}
END_TEST

START_TEST(off)
{
    clouds_three("OFF\n3 1 0\n1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n3 0 1 2\n");
    ck_assert_uint_eq(clouds.count.facets, 1);
    clouds_three("NOFF 3 1 0\n1.5 -2.25 3000 0 0 1\n0.5 0.25 -4 0 0 1\n7 8 9 0 0 1\n"
                 "3 0 1 2\n");
    clouds_refused("OFF\n3 1 0\n1 2 3\n", "ends after 1 vertices");
}
END_TEST

START_TEST(stl)
{
    clouds_three("solid part\nfacet normal 0 0 1\nouter loop\nvertex 1.5 -2.25 3000\n"
                 "vertex 0.5 0.25 -4\nvertex 7 8 9\nendloop\nendfacet\nendsolid part\n");
    ck_assert_uint_eq(clouds.count.facets, 1);
    clouds_three("SOLID PART\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 1.5 -2.25 3.0E+3\n"
                 "VERTEX 0.5 0.25 -4\nVERTEX 7 8 9\nENDLOOP\nENDFACET\nENDSOLID PART\n");
    ck_assert_uint_eq(clouds.count.facets, 1);
    char file[84 + 50] = "binary";
    put(file + 80, 1, 4);
    for (size_t i = 0; i < 9; i++)
        put_float(file + 96 + 4 * i, (float)three[i / 3][i % 3]);
    read_three(file, sizeof file);
}
END_TEST

/* A last row without a line end is counted: nobody knows whether its last number is whole. */
START_TEST(open_end)
{
    clouds_three("1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n");
    ck_assert_uint_eq(clouds.count.open_end, 0);
    clouds_three("1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9");
    ck_assert_uint_eq(clouds.count.open_end, 3);
    clouds_three("v 1.5 -2.25 3000\nv 0.5 0.25 -4\nv 7 8 9");
    ck_assert_uint_eq(clouds.count.open_end, 3);
    clouds_three("1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n# the end");
    ck_assert_uint_eq(clouds.count.open_end, 0);
}
END_TEST

/* The first column may number the rows. */
START_TEST(numbered)
{
    static const char *const first_three = "1 1.5 -2.25 3000\n2 0.5 0.25 -4\n3 7 8 9\n";
    char text[200000];
    const double as_x[][3] = {{1, 1.5, -2.25}, {2, 0.5, 0.25}, {3, 7, 8}};
    clouds_expect(first_three, 3, as_x); /* too few to know */
    ck_assert(!clouds.count.indexed);
    snprintf(text, sizeof text, "%s4 1 2 nan\n", first_three);
    clouds_three(text);
    ck_assert(clouds.count.indexed);
    ck_assert_uint_eq(clouds.count.not_finite, 1);
    ck_assert_uint_eq(clouds.count.first_not_finite, 4);
    clouds_three("100,1.5,-2.25,3000,5\n101,0.5,0.25,-4,5\n\n102,7,8,9,5\n103,nan,1,2,5\n");
    clouds_three("0;1,5;-2,25;3000\n1;0,5;0,25;-4\n2;7;8;9\n3;nan;1;2\n");
    snprintf(text, sizeof text, "%s5 1 2 3\n", first_three); /* 4 is missing */
    const double four[][3] = {{1, 1.5, -2.25}, {2, 0.5, 0.25}, {3, 7, 8}, {5, 1, 2}};
    clouds_expect(text, 4, four);
    ck_assert(!clouds.count.indexed);
    const double reals[][3] = {{1, 1.5, -2.25}, {2, 0.5, 0.25}, {3, 7, 8}, {4, 1, 2}};
    clouds_expect("1.0 1.5 -2.25 1\n2.0 0.5 0.25 1\n3.0 7 8 1\n4.0 1 2 1\n", 4, reals);
    clouds_expect("1 1.5 -2.25 a\n2 0.5 0.25 b\n3 7 8 c\n4 1 2 d\n", 4, reals);
    size_t n = 0;
    for (int i = 0; i < 5000; i++) /* long enough to be sure; then the numbers begin anew */
        n += (size_t)snprintf(text + n, sizeof text - n, "%d %d.5 2 3\n", i % 4500, i);
    ck_assert_int_eq(clouds_text(text), 0);
    ck_assert(clouds.count.indexed);
    ck_assert_uint_eq(clouds.points.n, 5000);
    ck_assert_double_eq(clouds.points.item[4999].x, 4999.5);
    ck_assert_double_eq(clouds.points.item[0].x, 0.5);
    n = 0;
    for (int i = 0; i < 5000; i++) /* a grid with a point at each millimetre */
        n += (size_t)snprintf(text + n, sizeof text - n, "%d %d 2.5 3\n", i % 100, i / 100);
    ck_assert_int_eq(clouds_text(text), 0);
    ck_assert(!clouds.count.indexed);
    ck_assert_double_eq(clouds.points.item[4999].x, 99);
    ck_assert_double_eq(clouds.points.item[4999].z, 2.5);
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
        cloud_read(scratch_text("4 5 6\n7 8 9\n"), 1, &clouds.points, &clouds.count, &clouds.error),
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
    tcase_add_test(tests, pcd_binary);
    tcase_add_test(tests, las_files);
    tcase_add_test(tests, off);
    tcase_add_test(tests, stl);
    tcase_add_test(tests, open_end);
    tcase_add_test(tests, numbered);
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
