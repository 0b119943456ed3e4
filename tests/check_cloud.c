/* cloud: every way of writing three points, every format, every refusal; and the fast reader
 * against the careful one. */
#include <check.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "array.h"
#include "cloud.h"
#include "scratch.h"

static struct vec3s points;
static struct cloud_count count;
static struct error error;

static int read_bytes(const char *text, size_t n)
{
    points.n = 0;
    return cloud_read(scratch_bytes(text, n), &points, &count, &error);
}

static int read_text(const char *text)
{
    return read_bytes(text, strlen(text));
}

static void expect_points(const char *text, size_t n, const double want[][3])
{
    ck_assert_msg(read_text(text) == 0, "%s\n%s", error.text, text);
    ck_assert_msg(points.n == n, "%zu points, not %zu, of\n%s", points.n, n, text);
    ck_assert_uint_eq(count.points, n);
    for (size_t i = 0; i < n; i++) {
        struct vec3 p = points.item[i];
        ck_assert_msg(p.x == want[i][0] && p.y == want[i][1] && p.z == want[i][2],
                      "point %zu: %.17g %.17g %.17g of\n%s", i, p.x, p.y, p.z, text);
    }
}

/* The text must hold the points 1.5 -2.25 3000, 0.5 0.25 -4 and 7 8 9. */
static void three(const char *text)
{
    static const double want[][3] = {{1.5, -2.25, 3000}, {0.5, 0.25, -4}, {7, 8, 9}};
    expect_points(text, 3, want);
}

static void refused_bytes(const char *text, size_t n, const char *says)
{
    ck_assert_msg(read_bytes(text, n) == -1, "read, should say %s:\n%s", says, text);
    ck_assert_msg(strstr(error.text, says) != NULL, "%s\n  lacks: %s", error.text, says);
    ck_assert_msg(strncmp(error.text, scratch_name(), strlen(scratch_name())) == 0, "%s",
                  error.text);
}

static void refused(const char *text, const char *says)
{
    refused_bytes(text, strlen(text), says);
}

START_TEST(partings)
{
    three("1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n");
    three("1.5\t-2.25\t3000\n0.5\t0.25\t-4\n7\t8\t9\n");
    three("  1.5    -2.25  3000 \n0.5 0.25\t -4\t\n\t7 8 9\n");
    three("1.5,-2.25,3000\n0.5,0.25,-4\n7,8,9\n");
    three(" 1.5 , -2.25,\t3000 ,\n0.5,0.25, -4,\n7, 8, 9\n");
    three("1.5;-2.25;3000\n0.5 ; 0.25;-4;\n7;8;9\n");
}
END_TEST

START_TEST(numbers)
{
    three("+1.5 -2.25e0 3e3\n.5 2.5E-1 -4.\n70d-1 0.8D+01 09\n");
    three("15E-1 -225.0e-2 3000.000000000000000000000\n0000000000000000000000.5 .25 -4e+0\n"
          "7.00000000000000000000 8 9\n");
    static const double exact[][3] = {
        {0.1, 123456789.123456789, 4649776.2345},
        {1.7976931348623157e-300, 5e-324, 9007199254740993e-3},
    };
    expect_points("0.1 123456789.123456789 4649776.2345\n"
                  "1.7976931348623157e-300 5e-324 9007199254740.993\n",
                  2, exact);
}
END_TEST

START_TEST(decimal_commas)
{
    three("1,5;-2,25;3000\n0,5;0,25;-4\n7;8;9\n");
    three("1,5 -2,25 3000\n0,5 0,25 -4\n7 8 9\n");
    three("1,5\t-2,25\t3000\n,5\t0,25\t-4,0\n7\t8\t9\n");
    static const double late[][3] = {{0, 0, 0}, {1, 2, 3}, {0.5, 1.5, 2.5}};
    expect_points("0;0;0\n1;2;3\n0,5;1,5;2,5\n", 3, late);
    expect_points("0 0 0\n1 2 3\n0,5 1,5 2,5\n", 3, late);
    refused("1.5 2 3\n1,5 2 3\n", ":2: '1,5'");
    refused("1,5;2;3\n1.5;2;3\n", ":2: '1.5'");
    refused("0 0 0\n1 2 3\n0.5 1 2\n0,5 1 2\n", ":4: '0,5'");
    refused("0 0 0\n1.5 2,5 3\n", ":2: '2,5'");
    refused("0 0 0\n1,500.5 2 3\n", ":2: '1,500.5'");
    refused("1,5,2,5,3,5 1\n2,5,2,5,3,5 1\n,\n", ":3: ");
}
END_TEST

START_TEST(line_ends)
{
    three("1.5 -2.25 3000\r\n0.5 0.25 -4\r\n7 8 9\r\n");
    three("1.5 -2.25 3000\r0.5 0.25 -4\r7 8 9\r");
    three("1.5 -2.25 3000\n0.5 0.25 -4\r7 8 9");
    three("\xEF\xBB\xBF"
          "1.5 -2.25 3000\n\n  \n0.5 0.25 -4\n\r\n7 8 9\n\n\t\n");
}
END_TEST

START_TEST(comments)
{
    three("# made\n#1 2 3\n1.5 -2.25 3000 # first\n// x y z\n0.5 0.25 -4 // second\n"
          "; 5 5 5\n7 8 9 ; third\n# end\n");
    ck_assert_uint_eq(count.comments, 5);
    ck_assert_uint_eq(count.heads, 0);
    ck_assert_uint_eq(count.columns, 3);
    three("#x;y;z\n1.5;-2.25;3000\n0.5;0.25;-4;#last\n7;8;9\n");
    three("1.5 -2.25 3000\n0.5 0.25 -4;no\n7 8 9#9\n");
    refused("1 2 3\n4 5 # 6\n7 8 9\n", ":2: 2 columns");
    refused("1 2 3\n4 5 ; 6\n7 8 9\n", ":2: 2 columns");
}
END_TEST

START_TEST(headings)
{
    three("X Y Z\n1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n");
    ck_assert_uint_eq(count.heads, 1);
    three("\"x [mm]\",\"y [mm]\",\"z [mm]\"\n1.5,-2.25,3000\n0.5,0.25,-4\n7,8,9\n");
    three("Scan of panel 7, 12.3.2019, 600 points\nOperator: H. M.\n\nx y z\n"
          "1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n");
    ck_assert_uint_eq(count.heads, 3);
    three("600 points\n1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n");
    three("12 3 2019 scan of a panel\n1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n");
    ck_assert_uint_eq(count.heads, 1);
    three("12 3 2019 scan, of, a panel\n1.5,-2.25,3000\n0.5,0.25,-4\n7,8,9\n");
    three("M\xFCller\n1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n");
}
END_TEST

START_TEST(further_columns)
{
    three("1.5 -2.25 3000 12\n0.5 0.25 -4 13\n7 8 9 14\n");
    ck_assert_uint_eq(count.columns, 4);
    three("1.5 -2.25 3000 1 2 nan\n0.5 0.25 -4 1 2 3\n7 8 9 1 2 3");
    ck_assert_uint_eq(count.columns, 6);
    three("x,y,z,class\n1.5,-2.25,3000,ground\n0.5,0.25,-4,high wall\n7,8,9,1\n");
    three("1.5 -2.25 3000 a\n0.5 0.25 -4 b,c\n7 8 9\n");
}
END_TEST

/* A heading that names as many columns as there are says where x, y and z stand. */
START_TEST(named_columns)
{
    three("id,x,y,z\nP1,1.5,-2.25,3000\nP2,0.5,0.25,-4\nP3,7,8,9\n");
    three("Z;Y (mm);time;X_mm\n3000;-2,25;0;1,5\n-4;0,25;1;0,5\n9;8;2;7\n");
    three("nx ny nz x y z\n0 0 1 1.5 -2.25 3000\n0 0 1 0.5 0.25 -4\n0 0 1 7 8 9\n");
    three("my x y z\n1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n"); /* four names, three columns */
    three("x y x\n1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n");
    refused("id,x,y,z\nP1,1.5,-2.25,3000\nP2,0.5,0.25\n", ":3: 3 columns");
}
END_TEST

START_TEST(not_finite_is_counted)
{
    three("1.5 -2.25 3000\nnan nan nan\n0.5 0.25 -4\n12.0 NaN 3.0\n-nan(ind) 1 2\n1 -Infinity 2\n"
          "1 2 1e999\n1.#IND 1 2\n1 -1.#INF00 2\n1 1e31 2\n7 8 9\n");
    ck_assert_uint_eq(count.not_finite, 8);
    ck_assert_uint_eq(count.first_not_finite, 2);
    three("nan nan nan\n1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n");
    ck_assert_uint_eq(count.not_finite, 1);
    three("nan;nan;nan\n1,5;-2,25;3000\n0,5;0,25;-4\n7;8;9\n");
    refused("nan nan nan\ninf 1 2\n", "no points (2 rows");
    refused("1 2 3\n1 nano 3\n", ":2: 'nano'");
    refused("1 2 3\n1 inf2x 3\n", ":2: 'inf2x'");
}
END_TEST

START_TEST(broken_rows)
{
    refused("1 2 3\n4 oops 6\n7 8 9\n", ":2: 'oops' is no number");
    refused("1 2 3\n4 5.6.7 6\n7 8 9\n", ":2: '5.6.7'");
    refused("1 2 3\n4 5\n7 8 9\n", ":2: 2 columns");
    refused("1 2 3\nx y z\n7 8 9\n", ":2: 'x'");
    refused("1 2 3\n4 5 6abc\n7 8 9\n", ":2: '6abc'");
    refused("1 2 3\n4 5 0x10\n7 8 9\n", ":2: '0x10'");
    refused("1 2 3\n4 5 --6\n7 8 9\n", ":2: '--6'");
    refused("1 2 3\n4 5 6e\n7 8 9\n", ":2: '6e'");
    refused("1,2,3\n4,,6\n7,8,9\n", ":2: ''");
    refused("1,2,3\n4,5 6\n7,8,9\n", ":2: '5 6'");
    refused("1,2,3\n4 5 6\n7,8,9\n", ":2: '4 5 6'");
    refused("1 2 3\n4,5,6\n7 8 9\n", ":2: '4,5,6'");
    refused("1 2\n3 4\n", ":1: 2 columns");
    refused("1 2\n3 4 5\n", ":1: 2 columns");
    refused("12.5 7.5 oops\n3 4 5\n", ":1: 'oops'");
    refused("5.5\n3 4 5\n", ":1: 1 column in");
    refused("1\n2\n3\n4\n", ":3: ");
}
END_TEST

START_TEST(cut_short)
{
    refused("1 2 3\n4 5 6\n7 8", ":3: 2 columns in the last row");
    refused("1 2 3\n4 5 6\n7", ":3: 1 columns in the last row");
    refused("1 2 3 100\n4 5 6 100\n7 8 9", ":3: 3 columns in the last row, expected 4");
    ck_assert_int_eq(read_text("1 2 3 100\n4 5 6 100\n7 8 9\n"), 0);
}
END_TEST

START_TEST(counts)
{
    three("3\n1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n");
    ck_assert_uint_eq(count.heads, 1);
    three("# PTS\n2\n1.5 -2.25 3000 -100 1 2 3\n0.5 0.25 -4 5 1 2 3\n1\n7 8 9 5 1 2 3\n");
    three("7\nx y z\n1.5 -2.25 3000\n0.5 0.25 -4\n7 8 9\n"); /* no count of what follows */
    refused("4\n1 2 3\n4 5 6\n7 8 9\n", "3 rows, expected the 4 that line 1 says");
    refused("2\n1 2 3\n4 5 6\n7 8 9\n", ":4: a row more than the 2 that line 1 says");
    refused("2\n1 2 3\n4 5 6\n2\n7 8 9\n", "1 rows, expected the 2 that line 4 says");
    refused("3\n1 2 3\n4 5 6\n2\n7 8 9\n", ":4: 1 column in the row");
    refused("99999999999999999999\n1 2 3\n", ":1: ");
    refused("-3\n1 2 3\n", ":1: ");
    refused("3.5\n1 2 3\n", ":1: ");
    refused("3\n", "0 rows, expected the 3");
}
END_TEST

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
        refused(known[i][0], known[i][1]);
    refused_bytes("1\0.\0005\0 \0002\0 \0003\0\n\0", 16, "UTF-16");
    refused_bytes("1 2 3\n4 5\0 6\n7 8 9\n", 19, ":2: a NUL byte");
    refused_bytes("1 2 3\n4 5 6\0\n7 8 9\n", 19, ":2: a NUL byte");
    refused_bytes("1 2 3 5\n4 5 6 5\0\n7 8 9 5\n", 25, ":2: a NUL byte");
    char iges[200];
    snprintf(iges, sizeof iges, "%-72sS      1\n%-72sG      1\n", "made", "1H,,1H;");
    refused(iges, "IGES");
    ck_assert_int_eq(cloud_read("/nonexistent/cloud.xyz", &points, &count, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "No such file"));
    ck_assert_int_eq(cloud_read("/tmp", &points, &count, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "directory"));
}
END_TEST

#define PTX_HEAD(matrix) "2\n2\n9 9 9\n1 0 0\n0 1 0\n0 0 1\n" matrix
#define IDENTITY "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"

START_TEST(ptx)
{
    three(PTX_HEAD(IDENTITY) "1.5 -2.25 3000 0.5\n0.5 0.25 -4 0.5\n0 0 0 0.5\n7 8 9 .5 1 2 3\n");
    ck_assert_uint_eq(count.not_measured, 1);
    ck_assert_uint_eq(count.heads, 10);
    /* a quarter turn about z, then a shift: x y z -> -y + 10, x + 20, z + 30 */
    three(
        PTX_HEAD("0 1 0 0\n-1 0 0 0\n0 0 1 0\n10 20 30 1\n") "-22.25 8.5 2970 .5\n0 0 0 0\n-19.75 "
                                                             "9.5 -34 .5\n-12 3 -21 .5\n");
    three(PTX_HEAD(IDENTITY) "1.5 -2.25 3000\n0.5 0.25 -4\n0 0 0\n0 0 0\n" PTX_HEAD(
        IDENTITY) "0 0 0\n7 8 9\n0 0 0\n0 0 0\n");
    refused(PTX_HEAD(IDENTITY) "1 2 3\n4 5 6\n", "ends behind 2 cells of a PTX grid, expected 4");
    refused(PTX_HEAD(IDENTITY) "1 2 3\n4 5 6\n1 2 3\n1 2 3\n1 2 3\n", ":15: a line of a PTX head");
    refused(PTX_HEAD("1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 nan\n") "1 2 3\n", ":10: ");
    refused(PTX_HEAD("1 0 0 5\n0 1 0 0\n0 0 1 0\n0 0 0 1\n") "1 2 3\n", "PTX matrix");
    refused("2\n2\n0 0 0\n", "ends in a PTX head");
    refused("99999999999\n99999999999\n9 9 9\n1 0 0\n0 1 0\n0 0 1\n" IDENTITY "1 2 3\n",
            "PTX grid of");
}
END_TEST

START_TEST(pcd)
{
    three("# .PCD v0.7\nVERSION 0.7\nFIELDS rgb hist z y x\nSIZE 4 4 4 4 4\nTYPE F F F F F\n"
          "COUNT 1 3 1 1 1\nWIDTH 4\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 4\nDATA ascii\n"
          "5 1 2 3 3000 -2.25 1.5\n5 1 2 3 -4 0.25 0.5\n5 1 2 3 nan nan nan\n5 1 2 3 9 8 7\n");
    ck_assert_uint_eq(count.not_finite, 1);
    refused("VERSION .7\nFIELDS x y z\nPOINTS 3\nDATA ascii\n1 2 3\n4 5 6\n", "expected the 3");
    refused("VERSION .7\nFIELDS x y z\nPOINTS 1\nDATA ascii\n1 2 3\n4 5 6\n", "expected the 1");
    refused("VERSION .7\nFIELDS x y z\nDATA binary\n", ":3: PCD with DATA binary");
    refused("VERSION .7\nFIELDS x y\nDATA ascii\n1 2\n", "without field z");
    refused("VERSION .7\nFIELDS x y z\nDATA ascii\n1 2 3\n4 5\n", ":5: 2 columns");
    refused("VERSION .7\nFIELDS x y z\nCOUNT 1 0 1\nDATA ascii\n1 2 3\n", ":3: COUNT");
    refused("VERSION .7\nFIELDS x y z\n", "ends in a PCD head");
    refused("VERSION .7\n1 2 3\n", ":2: '1' in a PCD head");
}
END_TEST

START_TEST(obj)
{
    three("# Wavefront\nmtllib a.mtl\no part\nv 1.5 -2.25 3000\nv 0.5 0.25 -4 1.0 0.5 0.5 0.5\n"
          "vn 0 0 1\nvt 0 0\nv\t7 8 9\ng a\ns off\nf 1//1 2//1 \\\n 3//1\nf 1 2 3\n");
    refused("v 1 2 3\nv 4 5 6\n7 8 9\n", ":3: '7 8 9', expected a statement");
    refused("o part\nv 1 2 3\nv 4 five 6\n", ":3: 'five'");
    refused("o part\nv 1 2 3\nv 4 5\n", ":3: 2 columns");
}
END_TEST

START_TEST(ply)
{
    three("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
          "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
          "1.5 -2.25 3000\n0.5 0.25 -4\n1 nan 2\n7 8 9\n3 0 1 2\n");
    ck_assert_uint_eq(count.not_finite, 1);
}
END_TEST

START_TEST(appends)
{
    ck_assert_int_eq(read_text("1 2 3\n"), 0);
    ck_assert_int_eq(cloud_read(scratch_text("4 5 6\n7 8 9\n"), &points, &count, &error), 0);
    ck_assert_uint_eq(points.n, 3);
    ck_assert_uint_eq(count.points, 2);
    ck_assert_double_eq(points.item[0].x, 1);
    ck_assert_double_eq(points.item[2].x, 7);
}
END_TEST

START_TEST(long_lines)
{
    size_t n = 300000;
    char *text = malloc(n + 100);
    memset(text, 'x', n);
    text[0] = '#';
    strcpy(text + n, "\n1 2 3\n");
    ck_assert_int_eq(read_text(text), 0);
    ck_assert_uint_eq(points.n, 1);
    memset(text, '1', n);
    strcpy(text + n, " 2 3\n4 5 6\n");
    ck_assert_int_eq(read_text(text), 0);
    ck_assert_uint_eq(points.n, 1);
    ck_assert_uint_eq(count.not_finite, 1);
    memset(text, '0', n);
    strcpy(text + n, "1 2 3\n4 5 6\n");
    ck_assert_int_eq(read_text(text), 0);
    ck_assert_uint_eq(points.n, 2);
    ck_assert_double_eq(points.item[0].x, 1);
    for (size_t i = 0; i < n; i += 2)
        memcpy(text + i, "4 ", 2);
    strcpy(text + n, "\n");
    ck_assert_int_eq(read_text(text), 0);
    ck_assert_uint_eq(count.columns, n / 2);
    free(text);
}
END_TEST

static uint64_t state = 1;

static unsigned below(unsigned n)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (unsigned)(state >> 33) % n;
}

/* A number as some program or other would print it. */
static size_t random_number(char *buf)
{
    static const char *const format[] = {"%.4f", "%.0f", "%.6e", "%+.3f", "%.17g", "%g", "%.1f"};
    double size[] = {1e-3, 1, 100, 1e6, 1e15};
    double x = size[below(5)] * ((double)below(2000001) / 1e6 - 1);
    return (size_t)sprintf(buf, format[below(7)], x);
}

/* Many rows in one style: each number must be strtod's, whatever the path it took. */
START_TEST(random_rows_are_exact)
{
    enum { ROWS = 4000 };
    static char text[ROWS * 120];
    static double want[ROWS][3];
    static const char *const parting[] = {" ", "\t", ",", ", ", ";", "  "};
    for (int style = 0; style < 6; style++) {
        char *p = text;
        for (int i = 0; i < ROWS; i++) {
            for (int k = 0; k < 3; k++) {
                char *from = p;
                p += random_number(p);
                want[i][k] = strtod(from, NULL);
                p += sprintf(p, "%s", k < 2 ? parting[style] : "");
            }
            if (below(3) == 0)
                p += sprintf(p, "%s%u", parting[style], below(100));
            p += sprintf(p, below(20) ? "\n" : "\r\n");
        }
        expect_points(text, ROWS, (const double(*)[3])want);
    }
}
END_TEST

/*
 * The same text with LF, which may go through the fast reader, and with CR, which never does, must
 * give the same points, counts and message, whatever damage is in it.
 */
START_TEST(fast_is_as_careful)
{
    static const char dirt[] = " ,;.-+0123456789eEdD#/nai\txyz";
    static char text[5000];
    for (int round = 0; round < 4000; round++) {
        size_t n = 0;
        const char *parting = round % 4 == 0 ? "," : round % 4 == 1 ? ";" : " ";
        for (unsigned rows = 3 + below(20); rows; rows--) {
            for (int k = 0; k < 3; k++) {
                n += random_number(text + n);
                n += (size_t)sprintf(text + n, "%s", k < 2 ? parting : "");
            }
            n += (size_t)sprintf(text + n, "%s\n", below(3) ? "" : " 7 8");
        }
        for (unsigned changes = below(4); changes; changes--) {
            size_t at = below((unsigned)n - 1);
            if (text[at] != '\n')
                text[at] = dirt[below(sizeof dirt - 1)];
        }
        int status = read_bytes(text, n);
        struct vec3s fast = points;
        struct cloud_count fast_count = count;
        struct error fast_error = error;
        points = (struct vec3s){0};

        for (size_t i = 0; i < n; i++)
            if (text[i] == '\n')
                text[i] = '\r';
        ck_assert_int_eq(read_bytes(text, n), status);
        if (status < 0) {
            ck_assert_str_eq(error.text, fast_error.text);
        } else {
            ck_assert_uint_eq(points.n, fast.n);
            ck_assert_mem_eq(points.item, fast.item, fast.n * sizeof *fast.item);
            ck_assert_uint_eq(count.comments, fast_count.comments);
            ck_assert_uint_eq(count.heads, fast_count.heads);
            ck_assert_uint_eq(count.not_finite, fast_count.not_finite);
        }
        array_free(&fast);
    }
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
        size_t n = strlen(head), total = n + below(400);
        memcpy(text, head, n);
        for (; n < total; n++)
            text[n] = below(8) ? " 0123.\n,-"[below(9)] : (char)below(256);
        if (read_bytes(text, total) < 0)
            ck_assert_ptr_nonnull(strstr(error.text, scratch_name()));
        for (size_t i = 0; i < points.n; i++)
            ck_assert(isfinite(points.item[i].x + points.item[i].y + points.item[i].z));
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

static void clear(void)
{
    array_free(&points);
}

int main(void)
{
    Suite *suite = suite_create("cloud");
    TCase *tests = tcase_create("cloud");
    SRunner *runner = srunner_create(suite);

    tcase_add_checked_fixture(tests, clear, clear);
    tcase_add_test(tests, partings);
    tcase_add_test(tests, numbers);
    tcase_add_test(tests, decimal_commas);
    tcase_add_test(tests, line_ends);
    tcase_add_test(tests, comments);
    tcase_add_test(tests, headings);
    tcase_add_test(tests, further_columns);
    tcase_add_test(tests, named_columns);
    tcase_add_test(tests, not_finite_is_counted);
    tcase_add_test(tests, broken_rows);
    tcase_add_test(tests, cut_short);
    tcase_add_test(tests, counts);
    tcase_add_test(tests, refused_by_name);
    tcase_add_test(tests, ptx);
    tcase_add_test(tests, pcd);
    tcase_add_test(tests, obj);
    tcase_add_test(tests, ply);
    tcase_add_test(tests, appends);
    tcase_add_test(tests, long_lines);
    tcase_add_test(tests, random_rows_are_exact);
    tcase_add_test(tests, fast_is_as_careful);
    tcase_add_test(tests, hostile_bytes);
    tcase_add_test(tests, units);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
