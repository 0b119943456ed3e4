/*
 * company and stitch: borders that run side by side share vertices; those that only cross or touch
 * stay as they are.
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/array.h"
#include "known.h"
#include "nurbs/sew.h"

/* How many vertices are joined or inserted between two patches, of 4 and 7 cells. */
static size_t meet(struct patch a, struct patch b, double gap, double *moved)
{
    struct patch p[2] = {a, b};
    struct patches all = {.n = 2, .item = p};
    struct sheet s[2];
    struct patch_mesh q;
    for (int i = 0; i < 2; i++)
        tessellate(&p[i], (struct tessellation){i ? 7 : 4, 0.01, 1}, &s[i]);
    patch_mesh_make(s, 2, 0, &q);
    struct sew_count count = sew(&q, &all, gap, 0.01);
    *moved = count.moved;
    for (size_t i = 0; i < q.edge.n; i++) { /* every border edge is one of its triangle */
        const struct patch_mesh_edge *e = &q.edge.item[i];
        const int *v = q.face.item[e->face].v;
        int found = 0;
        for (int k = 0; k < 3; k++)
            found += (size_t)v[k] == e->from && (size_t)v[(k + 1) % 3] == e->to;
        ck_assert_int_eq(found, 1);
    }
    patch_mesh_free(&q);
    for (int i = 0; i < 2; i++) {
        sheet_free(&s[i]);
        patch_free(&p[i]);
    }
    return count.joined + count.inserted;
}

static struct patch left(void)
{
    return known_flat(vec(0, 0, 0), vec(40, 0, 0), vec(0, 40, 0), vec(40, 40, 0));
}

START_TEST(side_by_side)
{
    double moved;
    for (int k = 0; k < 5; k++) { /* up to 0.04 apart: ends joined, 3 and 6 inserted */
        double d = 0.01 * k;
        struct patch right =
            known_flat(vec(40 + d, 0, 0), vec(80, 0, 0), vec(40, 40, d), vec(80, 40, 0));
        ck_assert_uint_eq(meet(left(), right, 0.05, &moved), 2 + 3 + 6);
        ck_assert_double_lt(fabs(moved - d / 2), 1e-12);
    }
    struct patch right =
        known_flat(vec(40.06, 0, 0), vec(80, 0, 0), vec(40.06, 40, 0), vec(80, 40, 0));
    ck_assert_uint_eq(meet(left(), right, 0.05, &moved), 0);
}
END_TEST

/* The border of one runs through that of the other at 45 degrees, through a vertex of both. */
START_TEST(crossing)
{
    double moved;
    struct patch other =
        known_flat(vec(30, 10, 0.02), vec(30, 10, 30), vec(58, 38, 0.02), vec(58, 38, 30));
    ck_assert_uint_eq(meet(left(), other, 0.05, &moved), 0);
    ck_assert_double_eq(moved, 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("company");
    TCase *tests = tcase_create("company");
    SRunner *runner = srunner_create(suite);
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, side_by_side);
    tcase_add_test(tests, crossing);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
