/* ply_source: binary files of both byte orders, all types; cut and damaged ones. */
#include <check.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/mesh/ply.h"
#include "scratch.h"
#include "seed.h"

static struct error error;
static struct mesh mesh;

/* A binary file made byte by byte, all types, in either byte order. */
static unsigned char binary[1000];
static size_t binary_n;

static void put(uint64_t bits, int size, bool big)
{
    for (int i = 0; i < size; i++)
        binary[binary_n++] = (unsigned char)(bits >> 8 * (big ? size - 1 - i : i));
}

static void put_float(float f, bool big)
{
    uint32_t bits;
    memcpy(&bits, &f, sizeof bits);
    put(bits, 4, big);
}

static void put_double(double d, bool big)
{
    uint64_t bits;
    memcpy(&bits, &d, sizeof bits);
    put(bits, 8, big);
}

static void binary_mesh(bool big)
{
    const char *head = "ply\nformat binary_%s_endian 1.0\n"
                       "element tag 2\nproperty list ushort char name\n"
                       "element vertex 3\nproperty char a\nproperty short row\nproperty ushort b\n"
                       "property double x\nproperty float y\nproperty int col\nproperty int8 z\n"
                       "element face 1\nproperty list uint ushort vertex_indices\nend_header\n";
    binary_n = (size_t)snprintf((char *)binary, sizeof binary, head, big ? "big" : "little");
    put(3, 2, big);
    put(0x0A0D0A, 3, big);
    put(0, 2, big);
    for (int i = 0; i < 3; i++) {
        put(0x80, 1, big);
        put((uint64_t)(-2 + i), 2, big);
        put(0xFFFF, 2, big);
        put_double(1e-3 + i, big);
        put_float(0.25f * (float)i, big);
        put((uint64_t)(-100000 * i), 4, big);
        put((uint64_t)(-128 + i), 1, big);
    }
    put(3, 4, big);
    for (uint64_t i = 0; i < 3; i++)
        put(i, 2, big);
}

START_TEST(binary_of_both_orders)
{
    for (int big = 0; big < 2; big++) {
        mesh_free(&mesh);
        binary_mesh(big);
        ck_assert_msg(ply_read(scratch_bytes(binary, binary_n), &mesh, &error) == 0, "%s",
                      error.text);
        ck_assert_uint_eq(mesh.vertex.n, 3);
        for (int i = 0; i < 3; i++) {
            ck_assert_double_eq(
                vec_distance(mesh.vertex.item[i], vec(1e-3 + i, 0.25 * i, -128 + i)), 0);
            ck_assert_int_eq(mesh.row.item[i], -2 + i);
            ck_assert_int_eq(mesh.col.item[i], -100000 * i);
        }
        ck_assert_uint_eq(mesh.face.n, 1);
    }
}
END_TEST

/* Cut anywhere, a file is refused; nothing else happens. */
START_TEST(cut_anywhere_is_refused)
{
    binary_mesh(false);
    for (size_t n = 0; n < binary_n; n++)
        ck_assert_int_eq(ply_read(scratch_bytes(binary, n), &mesh, &error), -1);
    binary[binary_n++] = 7;
    ck_assert_int_eq(ply_read(scratch_bytes(binary, binary_n), &mesh, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "more than the 1 rows of element face"));
}
END_TEST

/* Random bytes changed in good files: an error or a mesh whose indices hold, never more. */
START_TEST(damage_is_survived)
{
    uint64_t state = 7;
    for (int round = 0; round < 3000; round++) {
        binary_mesh(round % 2);
        for (int k = 0; k < 1 + round % 4; k++) {
            state = state * 6364136223846793005u + seed_step();
            binary[(state >> 33) % binary_n] = (unsigned char)(state >> 20);
        }
        if (ply_read(scratch_bytes(binary, binary_n), &mesh, &error) < 0)
            continue;
        for (size_t f = 0; f < mesh.face.n; f++)
            for (int i = 0; i < 3; i++) {
                ck_assert_int_ge(mesh.face.item[f].v[i], 0);
                ck_assert_int_lt(mesh.face.item[f].v[i], (int)mesh.vertex.n);
            }
        mesh_free(&mesh);
    }
}
END_TEST

static void clear(void)
{
    mesh_free(&mesh);
}

int main(void)
{
    Suite *suite = suite_create("ply_source");
    TCase *tests = tcase_create("ply_source");
    SRunner *runner = srunner_create(suite);

    tcase_add_checked_fixture(tests, clear, clear);
    tcase_add_test(tests, binary_of_both_orders);
    tcase_add_test(tests, cut_anywhere_is_refused);
    tcase_add_test(tests, damage_is_survived);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
