/* iges_parts: faces are as often and where the file's instances, groups and solids put them, each
 * with its shell (IGES 5.3, 4.47, 4.53, 4.56, 4.69 to 4.73); what never ends is an error. */
#include "iges_files.h"

#include "base/array.h"
#include "io/nurbs/iges_parts.h"
#include "math/elementary.h"

static struct iges_parts parts;
static int bodies;

static void setup(void)
{
    iges_file_begin();
    bodies = 0;
}

static void teardown(void)
{
    iges_file_end();
    array_free(&parts);
    parts = (struct iges_parts){0};
}

static bool is_face(int type)
{
    return type == 510 || type == 128;
}

static int find(void)
{
    iges_file_read();
    return iges_parts(&iges, is_face, &bodies, &parts, &error);
}

static int add(int type, int matrix, const char *format, int a, int b, int c)
{
    /* cppcheck-suppress wrongPrintfScanfArgNum ; formats use as many as they need */
    return iges_file_format(type, 0, matrix, false, format, a, b, c);
}

/* One part of the face, which takes the point 1, 2, 3 there. */
static void stands(int face, int body, bool cavity, double x, double y, double z)
{
    for (size_t i = 0; i < parts.n; i++) {
        struct vec3 p = transform_point(&parts.item[i].to, vec(1, 2, 3));
        if (parts.item[i].entity->number == face && vec_distance(p, vec(x, y, z)) < 1e-12) {
            ck_assert_int_eq(parts.item[i].body, body);
            ck_assert_int_eq(parts.item[i].cavity, cavity);
            return;
        }
    }
    ck_abort_msg("no part of %d at %g %g %g", face, x, y, z);
}

START_TEST(faces_alone)
{
    int a = iges_file_add(510, 0, 0, false, "510,0;");
    iges_file_add(110, 0, 0, false, "110,0.,0.,0.,1.,0.,0.;");
    int b = iges_file_add(128, 0, 0, false, "128,0;");
    ck_assert_int_eq(find(), 0);
    ck_assert_uint_eq(parts.n, 2);
    stands(a, 0, false, 1, 2, 3);
    stands(b, 0, false, 1, 2, 3);
    ck_assert_int_eq(bodies, 0);
}
END_TEST

/* A definition is where its instances are, twice here: scaled, then shifted, then moved by the
 * instance's own matrix; and not where it is defined. */
START_TEST(subfigures)
{
    int face = iges_file_add(510, 0, 0, true, "510,0;");
    int inner = add(308, 0, "308,0,4HPART,1,%d;", face, 0, 0);
    int turn = iges_file_add(124, 0, 0, true, "124,0.,-1.,0.,100.,1.,0.,0.,0.,0.,0.,1.,0.;");
    add(408, 0, "408,%d,10.,20.,30.,2.;", inner, 0, 0);
    int small = add(408, turn, "408,%d,1.,0.,0.;", inner, 0, 0);
    ck_assert_int_eq(find(), 0);
    ck_assert_uint_eq(parts.n, 2);
    stands(face, 0, false, 12, 24, 36);
    stands(face, 0, false, 100 - 2, 2, 3);
    teardown();
    /* an instance within another definition is in each of its instances */
    int outer = add(308, 0, "308,1,5HOUTER,2,%d,%d;", small, face, 0);
    add(408, 0, "408,%d,0.,0.,7.,1.;", outer, 0, 0);
    add(408, 0, "408,%d,0.,0.,-7.,3.;", outer, 0, 0);
    ck_assert_int_eq(find(), 0);
    ck_assert_uint_eq(parts.n, 5); /* the first stands alone as before */
    stands(face, 0, false, 98, 2, 10);
    stands(face, 0, false, 3 * 98, 6, 9 - 7);
    stands(face, 0, false, 1, 2, 10);
    stands(face, 0, false, 3, 6, 2);
}
END_TEST

/* 184: parts with a matrix each, or none (0). */
START_TEST(assemblies)
{
    int face = iges_file_add(510, 0, 0, true, "510,0;");
    int shell = add(514, 0, "514,1,%d,1;", face, 0, 0);
    int solid = add(186, 0, "186,%d,1,0;", shell, 0, 0);
    int up = iges_file_add(124, 0, 0, true, "124,1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,50.;");
    char text[200];
    snprintf(text, sizeof text, "184,2,%d,%d,%d,0;", solid, solid, up);
    iges_file_add(184, 1, up, false, text);
    ck_assert_int_eq(find(), 0);
    ck_assert_uint_eq(parts.n, 2);
    stands(face, 1, false, 1, 2, 103);
    stands(face, 2, false, 1, 2, 53);
    ck_assert_int_eq(bodies, 2);
}
END_TEST

/* Of four parts each has its own matrix, the third none. */
START_TEST(assembly_of_four)
{
    int face = iges_file_add(510, 0, 0, true, "510,0;");
    int shell = add(514, 0, "514,1,%d,1;", face, 0, 0);
    int solid = add(186, 0, "186,%d,1,0;", shell, 0, 0), up[4] = {0};
    char text[200];
    for (int i = 0; i < 4; i++)
        if (i != 2) {
            snprintf(text, sizeof text, "124,1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,%d.;", 10 * (i + 1));
            up[i] = iges_file_add(124, 0, 0, true, text);
        }
    snprintf(text, sizeof text, "184,4,%d,%d,%d,%d,%d,%d,%d,%d;", solid, solid, solid, solid, up[0],
             up[1], up[2], up[3]);
    iges_file_add(184, 1, 0, false, text);
    ck_assert_int_eq(find(), 0);
    ck_assert_uint_eq(parts.n, 4);
    for (int i = 0; i < 4; i++)
        stands(face, i + 1, false, 1, 2, i == 2 ? 3 : 3 + 10 * (i + 1));
}
END_TEST

/* A solid with two voids: three shells, whose faces are of bodies 5, 6, 7 after four others. */
START_TEST(voids)
{
    int face[4], shell[3];
    for (int i = 0; i < 4; i++)
        face[i] = iges_file_add(510, 0, 0, true, "510,0;");
    shell[0] = add(514, 0, "514,2,%d,1,%d,0;", face[0], face[1], 0);
    shell[1] = add(514, 0, "514,1,%d,1;", face[2], 0, 0);
    shell[2] = add(514, 0, "514,1,%d,1;", face[3], 0, 0);
    add(186, 0, "186,%d,1,2,%d,0,%d,0;", shell[0], shell[1], shell[2]);
    bodies = 4;
    ck_assert_int_eq(find(), 0);
    ck_assert_uint_eq(parts.n, 4);
    for (int i = 0; i < 4; i++)
        stands(face[i], i < 2 ? 5 : 4 + i, i >= 2, 1, 2, 3);
    ck_assert_int_eq(bodies, 7);
}
END_TEST

/* A group only names what stands elsewhere; an instance of a solid (430) is one of its own. */
START_TEST(groups_and_instances)
{
    int face = iges_file_add(510, 0, 0, true, "510,0;"),
        other = iges_file_add(128, 0, 0, false, "128,0;");
    int shell = add(514, 0, "514,1,%d,1;", face, 0, 0);
    int solid = add(186, 0, "186,%d,1,0;", shell, 0, 0);
    int side = iges_file_add(124, 0, 0, true, "124,1.,0.,0.,9.,0.,1.,0.,0.,0.,0.,1.,0.;");
    int instance = add(430, side, "430,%d;", solid, 0, 0);
    add(402, 0, "402,2,%d,%d;", other, instance, 0);
    ck_assert_int_eq(find(), 0);
    ck_assert_uint_eq(parts.n, 2);
    stands(other, 0, false, 1, 2, 3);
    stands(face, 1, false, 10, 2, 3);
}
END_TEST

START_TEST(without_end)
{
    /* two definitions that hold an instance of each other, and one instance outside */
    iges_file_add(308, 0, 0, true, "308,0,1HA,1,5;"); /* 1 */
    iges_file_add(308, 0, 0, true, "308,0,1HB,1,7;"); /* 3 */
    iges_file_add(408, 0, 0, true, "408,3,0.,0.,0.,1.;");
    iges_file_add(408, 0, 0, true, "408,1,0.,0.,0.,1.;");
    iges_file_add(408, 0, 0, false, "408,1,0.,0.,0.,1.;");
    ck_assert_int_eq(find(), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "without end"));
    teardown();
    setup();
    iges_file_add(408, 0, 0, false, "408,77,0.,0.,0.,1.;");
    ck_assert_int_eq(find(), -1);
    teardown();
    setup(); /* a count beyond what is there */
    int face = iges_file_add(510, 0, 0, true, "510,0;");
    add(186, 0, "186,%d,1,0;", add(514, 0, "514,9,%d,1;", face, 0, 0), 0, 0);
    ck_assert_int_eq(find(), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "514 with a count of 9 parts but 1"));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("iges_parts");
    TCase *tests = tcase_create("iges_parts");
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, faces_alone);
    tcase_add_test(tests, subfigures);
    tcase_add_test(tests, assemblies);
    tcase_add_test(tests, assembly_of_four);
    tcase_add_test(tests, voids);
    tcase_add_test(tests, groups_and_instances);
    tcase_add_test(tests, without_end);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
