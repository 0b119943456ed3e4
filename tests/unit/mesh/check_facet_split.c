/* facet_split: one facet split, edges turned and kept, and who is beside whom. */
#include <check.h>
#include <stdlib.h>

#include "mesh/facet_split.h"

/* A square of two facets: corner i of the mesh, whose vertices have these rows. */
static struct mesh square(int row0, int row2)
{
    const struct vec3 corner[] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
    const int row[] = {row0, 0, row2, 1};
    struct mesh m = {.origin.ledger = NAN};
    for (int i = 0; i < 4; i++) {
        *array_push(&m.vertex) = corner[i];
        *array_push(&m.row) = row[i];
        *array_push(&m.col) = i;
    }
    *array_push(&m.face) = (struct face){{0, 1, 2}};
    *array_push(&m.face) = (struct face){{0, 2, 3}};
    return m;
}

static struct facet_split begin(struct mesh *m, const struct vec3 *point, const double *within,
                                int n)
{
    struct facet_split w = {.mesh = m, .old = 4, .point = point, .within = within};
    const int beyond[] = {-1, -1, 1, 0, -1, -1};
    w.next = mem_alloc((size_t)n, sizeof *w.next);
    for (int i = 0; i < 6; i++)
        *array_push(&w.beyond) = beyond[i];
    *array_push(&w.first) = FACET_SPLIT_NONE;
    *array_push(&w.first) = FACET_SPLIT_NONE;
    for (int i = 0; i < n; i++)
        facet_split_put(&w, facet_split_over(&w, 0, point[i]) ? 0 : 1, i);
    return w;
}

static void end(struct facet_split *w)
{
    array_free(&w->beyond);
    array_free(&w->first);
    array_free(&w->todo);
    free(w->next);
    mesh_free(w->mesh);
}

static bool has_edge(const struct mesh *m, int a, int b)
{
    for (size_t f = 0; f < m->face.n; f++)
        for (int k = 0; k < 3; k++)
            if (m->face.item[f].v[k] == a && m->face.item[f].v[(k + 1) % 3] == b)
                return true;
    return false;
}

/* Each facet is beyond the edges of those beyond its own. */
static void check_beside(const struct facet_split *w)
{
    for (int f = 0; f < (int)w->mesh->face.n; f++)
        for (int k = 0; k < 3; k++) {
            int g = w->beyond.item[3 * f + k], found = 0;
            for (int j = 0; g >= 0 && j < 3; j++)
                found += w->beyond.item[3 * g + j] == f &&
                         w->mesh->face.item[g].v[j] == w->mesh->face.item[f].v[(k + 1) % 3];
            ck_assert_int_eq(found, g >= 0);
        }
}

START_TEST(edges_turn_or_stay)
{
    for (int along = 0; along < 2; along++) { /* the diagonal is no row, or it is one */
        struct vec3 p[] = {{2.2, 1.8, 1}, {1, 3, 0}, {3.5, 0.2, 0}};
        double within[] = {0.1, 2, 2};
        struct mesh m = along ? square(0, 0) : square(0, 1);
        struct facet_split w = begin(&m, p, within, 3);
        int at = -1;
        ck_assert_double_eq_tol(facet_split_worst(&w, 0, &at), 0.9, 1e-9);
        ck_assert_int_eq(at, 0);
        ck_assert(facet_split_apart(&w, 0, p[0]) && !facet_split_apart(&w, 0, vec(4, 4, 3)));
        facet_split_at(&w, 0, 0);
        ck_assert_uint_eq(m.vertex.n, 5);
        ck_assert_uint_eq(m.face.n, 4);
        ck_assert(has_edge(&m, 2, 0) == along);
        ck_assert(has_edge(&m, 4, 3) != along);
        check_beside(&w);
        for (int i = 1; i < 3; i++) { /* the others are over the right facet */
            int lists = 0;
            for (int f = 0; f < 4; f++)
                for (int q = w.first.item[f]; q >= 0; q = w.next[q])
                    lists += q == i && facet_split_over(&w, f, p[i]);
            ck_assert_int_eq(lists, 1);
        }
        end(&w);
    }
}
END_TEST

/* A new vertex has the largest curvature of its facet's corners, where the mesh has any. */
START_TEST(curvatures)
{
    for (int known = 0; known < 2; known++) {
        struct vec3 p = {1.5, 2, 1};
        double within = 0.1, corner[] = {0.3, 0.1, 0.2, 0.7};
        struct mesh m = square(0, 1);
        const int *v = m.face.item[0].v;
        double most = fmax(corner[v[0]], fmax(corner[v[1]], corner[v[2]]));
        for (int i = 0; i < 4 && known; i++)
            *array_push(&m.kmax) = corner[i];
        struct facet_split w = begin(&m, &p, &within, 1);
        facet_split_at(&w, 0, 0);
        ck_assert_uint_eq(m.kmax.n, known ? 5 : 0);
        if (known)
            ck_assert_double_eq(m.kmax.item[4], most);
        end(&w);
    }
}
END_TEST

/* A point beyond the border is over none of the facets: it stays with one of them, the last. */
START_TEST(a_point_over_none_is_kept)
{
    struct vec3 p[] = {{1.8, 2.2, 1}, {-1, 1, 0}};
    double within[] = {0.1, 2};
    struct mesh m = square(0, 0);
    struct facet_split w = begin(&m, p, within, 2);
    facet_split_at(&w, 1, 0);
    ck_assert_uint_eq(m.face.n, 4);
    for (int f = 0; f < 4; f++)
        ck_assert_int_eq(w.first.item[f], f == 3 ? 1 : FACET_SPLIT_NONE);
    ck_assert_int_eq(w.next[1], FACET_SPLIT_NONE);
    end(&w);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("facet_split");
    TCase *tests = tcase_create("facet_split");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, edges_turn_or_stay);
    tcase_add_test(tests, a_point_over_none_is_kept);
    tcase_add_test(tests, curvatures);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
