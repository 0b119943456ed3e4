/* greedy_insert, with facet_split: a coarse mesh of rows is brought within an error of points that
 * are anywhere between, judged by the distance to all facets; its rows and its cover stay. */
#include <check.h>
#include <stdlib.h>

#include "meshing/greedy_insert.h"
#include "mesh/mesh_distance.h"
#include "mesh/facet_split.h"
#include "rough.h"

enum { ROWS = 9, COLUMNS = 11 };

static double level(double x, double y)
{
    return 1e-3 * sin(x + y);
}

static double wave(double x, double y)
{
    return 0.8 * sin(x) * cos(0.7 * y);
}

static double rough(double x, double y)
{
    return wave(x, y) + 0.02 * normal();
}

/* Rows of the triangular grid of side 2, from (0, 0). */
static struct mesh grid(double (*height)(double, double))
{
    struct mesh m = {.origin.ledger = NAN};
    for (int r = 0; r < ROWS; r++)
        for (int c = 0; c < COLUMNS; c++) {
            double x = 2 * c + r % 2, y = 1.75 * r;
            *array_push(&m.vertex) = vec(x, y, height(x, y));
            *array_push(&m.normal) = vec(0, 0, 1);
            *array_push(&m.kmax) = r == 4 ? 0.3 : 0.1;
            *array_push(&m.row) = r;
            *array_push(&m.col) = c;
        }
    for (int r = 0; r + 1 < ROWS; r++)
        for (int c = 0; c + 1 < COLUMNS; c++) {
            int v = r * COLUMNS + c, u = v + COLUMNS;
            if (r % 2 == 0) {
                *array_push(&m.face) = (struct face){{v, v + 1, u}};
                *array_push(&m.face) = (struct face){{v + 1, u + 1, u}};
            } else {
                *array_push(&m.face) = (struct face){{v, v + 1, u + 1}};
                *array_push(&m.face) = (struct face){{v, u + 1, u}};
            }
        }
    return m;
}

/* Area from above; no facet looks down, or has an edge along a row gone. */
static double area(const struct mesh *m)
{
    double sum = 0;
    size_t along = 0;
    for (size_t f = 0; f < m->face.n; f++) {
        double z = mesh_face_cross(m, f).z;
        ck_assert_double_ge(z, -1e-9);
        sum += z / 2;
        for (int k = 0; k < 3; k++) {
            int a = m->face.item[f].v[k], b = m->face.item[f].v[(k + 1) % 3];
            along += m->row.item[a] >= 0 && m->row.item[a] == m->row.item[b];
        }
    }
    /* an edge of a row in the middle has two facets, of the first and the last one */
    ck_assert_uint_eq(along, (2 * ROWS - 2) * (COLUMNS - 1));
    return sum;
}

/* From a vertex nearby the point is steeper than 85 degrees: such points are left alone. */
static bool is_steep(const struct mesh *m, struct vec3 p)
{
    for (size_t v = 0; v < m->vertex.n; v++) {
        struct vec3 d = vec_sub(p, m->vertex.item[v]);
        if (fabs(d.z) > 11.43 * hypot(d.x, d.y) && hypot(d.x, d.y) < 0.1)
            return true;
    }
    return false;
}

static void check(struct vec3s *p, double (*height)(double, double), double error, size_t most)
{
    struct mesh m = grid(height);
    double before = area(&m);
    size_t old = m.vertex.n;
    double *within = mem_alloc(p->n, sizeof *within), *off = mem_alloc(p->n, sizeof *off);
    for (size_t i = 0; i < p->n; i++)
        within[i] = error;
    size_t more = greedy_insert(&m, p->item, within, p->n, 2);
    ck_assert_uint_eq(m.vertex.n, old + more);
    ck_assert_uint_le(more, most);
    ck_assert_double_eq_tol(area(&m), before, 1e-9);
    ck_assert_uint_eq(m.face.n, 2 * (ROWS - 1) * (COLUMNS - 1) + 2 * more);
    mesh_distance(&m, p->item, p->n, 1, off);
    for (size_t i = 0; i < p->n; i++)
        ck_assert(off[i] <= error || is_steep(&m, p->item[i]));
    ck_assert_uint_eq(m.normal.n, m.vertex.n);
    ck_assert_uint_eq(m.kmax.n, m.vertex.n);
    for (size_t v = old; v < m.vertex.n; v++) {
        ck_assert_int_eq(m.row.item[v], -1);
        ck_assert_double_eq_tol(vec_length(m.normal.item[v]), 1, 1e-9);
        ck_assert_double_ge(m.kmax.item[v], 0.1);
    }
    free(off);
    free(within);
    mesh_free(&m);
}

/* Points over the inside of the grid. */
static struct vec3s scan(size_t n, double (*height)(double, double))
{
    struct vec3s p = {0};
    for (size_t i = 0; i < n; i++) {
        double x = 1 + 19 * uniform(), y = 14 * uniform();
        *array_push(&p) = vec(x, y, height(x, y));
    }
    return p;
}

START_TEST(smooth_and_rough)
{
    struct vec3s p = scan(4000, level);
    check(&p, level, 0.01, 0);
    array_free(&p);
    p = scan(4000, wave);
    check(&p, wave, 0.05, 600);
    array_free(&p);
    p = scan(1500, rough);
    check(&p, wave, 0.01, 1500);
    array_free(&p);
}
END_TEST

/* One point in a facet, one on an edge between rows, one on a row, and one right over a vertex. */
START_TEST(single_points)
{
    struct vec3s p = {0};
    *array_push(&p) = vec(5.1, 4, 1);
    *array_push(&p) = vec(7.5, 2.625, 1);
    *array_push(&p) = vec(11.3, 7, 1);
    check(&p, level, 0.1, 3);
    array_free(&p);
    struct mesh m = grid(level);
    struct vec3 over = vec_along(m.vertex.item[40], 1, vec(0, 0, 1));
    double within = 0.1;
    over.x += 0.05; /* steep */
    ck_assert_uint_eq(greedy_insert(&m, &over, &within, 1, 1), 0);
    within = 2;
    ck_assert_uint_eq(greedy_insert(&m, &over, &within, 1, 1), 0);
    mesh_free(&m);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("greedy_insert");
    TCase *tests = tcase_create("greedy_insert");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, smooth_and_rough);
    tcase_add_test(tests, single_points);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
