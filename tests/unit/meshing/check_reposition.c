/* reposition: each criterion alone, and random clouds against a search node by node. */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "meshing/reposition.h"
#include "seed.h"

static uint64_t state = 3;

static double uniform(void)
{
    state = state * 6364136223846793005u + seed_step();
    return (double)(state >> 11) / 9007199254740992.0;
}

/* A grid of t = 4 whose node (5, 5) is at the origin. */
static struct grid grid_about_origin(void)
{
    struct grid g = {{1, 0, -30, 30, -4 * GRID_SLANT * 5, 30}, 4, -30, -4 * GRID_SLANT * 5, 12, 12};
    return g;
}

/* The point chosen for the node at the origin. */
static size_t chosen_at_origin(const struct vec3 *point, size_t n)
{
    struct grid g = grid_about_origin();
    size_t *chosen = reposition(&g, point, n, REACH_NEAREST, 1);
    size_t c = chosen[5 * 12 + 5];
    free(chosen);
    return c;
}

/* `first` beats `second` in either order, each alone is chosen too. */
static void expect_first(struct vec3 first, struct vec3 second)
{
    struct vec3 one_way[2] = {first, second}, other_way[2] = {second, first};
    ck_assert_uint_eq(chosen_at_origin(one_way, 2), 0);
    ck_assert_uint_eq(chosen_at_origin(other_way, 2), 1);
    ck_assert_uint_eq(chosen_at_origin(&second, 1), 0);
}

static struct vec3 polar(double r, double degrees)
{
    return vec(r * cos(RADIANS(degrees)), r * sin(RADIANS(degrees)), 0);
}

START_TEST(nearest_first)
{
    expect_first(polar(1, 270), polar(1.01, 90));
    expect_first(polar(1, 200), polar(1.0001, 60));
}
END_TEST

START_TEST(criterion_a_upper_side)
{
    expect_first(polar(1, 170), polar(1, 300));
    expect_first(polar(1, 0), polar(1, 350)); /* level counts as upper */
    expect_first(polar(1, 180), polar(1, 270));
    expect_first(polar(1, 20), polar(1, 270)); /* A comes before B */
}
END_TEST

START_TEST(criterion_b_middle_triangle)
{
    expect_first(polar(1, 100), polar(1, 20)); /* B comes before C */
    expect_first(polar(1, 90), polar(1, 150));
    expect_first(polar(1, 260), polar(1, 340));
}
END_TEST

START_TEST(criterion_c_larger_x)
{
    expect_first(polar(1, 70), polar(1, 110));
    expect_first(polar(1, 10), polar(1, 50));
    expect_first(polar(1, 130), polar(1, 170));
    expect_first(polar(1, 290), polar(1, 250));
}
END_TEST

START_TEST(then_larger_z)
{
    expect_first(vec(0.5, 0.5, 3), vec(0.5, 0.5, -2));
}
END_TEST

START_TEST(equal_within_rounding)
{
    /* 1e-9 t^2 in the square: 4e-9 / (2 * 1) of the distance at 1 */
    expect_first(polar(1 + 1e-12, 90), polar(1, 270));
}
END_TEST

/* What the criteria say, written down once more: the best point for one node. */
static size_t best_for(const struct grid *g, int column, int row, const struct vec3 *point,
                       const int *owner, size_t n, double within)
{
    struct vec3 node = grid_node(g, column, row);
    size_t best = NO_POINT;
    double least = within * within;
    for (size_t i = 0; i < n; i++) {
        double dx = point[i].x - node.x, dy = point[i].y - node.y, d2 = dx * dx + dy * dy;
        if (owner && owner[i] != row * g->columns + column)
            continue;
        if (d2 < least) { /* random points: no two as near */
            least = d2;
            best = i;
        }
    }
    return best;
}

static int nearest_node(const struct grid *g, struct vec3 p)
{
    int best = 0;
    double least = INFINITY;
    for (int row = 0; row < g->rows; row++)
        for (int column = 0; column < g->columns; column++) {
            struct vec3 node = grid_node(g, column, row);
            double d = hypot(p.x - node.x, p.y - node.y);
            if (d < least) {
                least = d;
                best = row * g->columns + column;
            }
        }
    return best;
}

START_TEST(same_as_node_by_node)
{
    enum { N = 300 };
    struct vec3 point[N];
    int owner[N];
    struct error error;
    for (int cloud = 0; cloud < 12; cloud++) {
        struct grid g;
        for (int i = 0; i < N; i++)
            point[i] = vec(50 * uniform(), 5 + 35 * uniform(), uniform());
        struct plan_extent f = plan_extent_of(point, N, 0);
        ck_assert_int_eq(grid_make(&f, N, 1 + 5 * uniform(), &g, &error), 0);
        for (int i = 0; i < N; i++)
            owner[i] = nearest_node(&g, point[i]);
        size_t *nearest = reposition(&g, point, N, REACH_NEAREST, 1);
        size_t *circle = reposition(&g, point, N, REACH_CIRCLE, 1);
        for (int row = 0; row < g.rows; row++)
            for (int column = 0; column < g.columns; column++) {
                int node = row * g.columns + column;
                size_t own = best_for(&g, column, row, point, owner, N, INFINITY);
                if (own != NO_POINT)
                    ck_assert_uint_eq(nearest[node], own);
                ck_assert_uint_eq(circle[node], best_for(&g, column, row, point, NULL, N, g.t));
            }
        free(nearest);
        free(circle);
    }
}
END_TEST

/* A node that no point is nearest to, in the middle of full ones, takes the nearest point that
 * stands for none; with two of those around it empty it is on the border of a hole, and left. */
START_TEST(empty_node_takes_a_spare_point)
{
    for (int emptied = 1; emptied <= 3; emptied++) {
        struct grid g = grid_about_origin();
        struct vec3 point[200];
        size_t n = 0;
        for (int row = 3; row <= 7; row++)
            for (int column = 3; column <= 7; column++)
                if (!(row == 5 && column >= 5 && column < 5 + emptied) &&
                    !(emptied == 3 && row == 6 && column == 5))
                    point[n++] = grid_node(&g, column, row);
        size_t far = n, spare = n + 1;
        point[n++] = vec(-2.6, 0, 0); /* nearest to the node on the left, which has its own */
        point[n++] = vec(-2.5, 0, 0);
        size_t *chosen = reposition(&g, point, n, REACH_NEAREST, 1);
        ck_assert_uint_eq(chosen[5 * 12 + 5], emptied < 3 ? spare : NO_POINT);
        for (size_t i = 0; i < grid_nodes(&g); i++)
            ck_assert_uint_ne(chosen[i], far);
        free(chosen);
    }
}
END_TEST

/* A regular cloud, where ties are the rule: any order of the points gives the same choice. */
START_TEST(order_does_not_matter)
{
    enum { N = 21 * 17 };
    struct vec3 point[N], shuffled[N];
    struct error error;
    struct grid g;
    for (int i = 0; i < N; i++)
        shuffled[i] = point[i] = vec(i % 21, i / 21, i % 5);
    struct plan_extent f = plan_extent_of(point, N, 0);
    ck_assert_int_eq(grid_make(&f, N, 2, &g, &error), 0);
    for (int round = 0; round < 20; round++) {
        for (int i = N - 1; i > 0; i--) {
            int j = (int)(uniform() * (i + 1));
            struct vec3 t = shuffled[i];
            shuffled[i] = shuffled[j];
            shuffled[j] = t;
        }
        enum reach reach = round % 2 ? REACH_CIRCLE : REACH_NEAREST;
        size_t *a = reposition(&g, point, N, reach, 1), *b = reposition(&g, shuffled, N, reach, 1);
        for (size_t i = 0; i < grid_nodes(&g); i++) {
            ck_assert_int_eq(a[i] == NO_POINT, b[i] == NO_POINT);
            if (a[i] != NO_POINT)
                ck_assert(vec_distance(point[a[i]], shuffled[b[i]]) == 0);
        }
        free(a);
        free(b);
    }
}
END_TEST

static int by_y(const void *a, const void *b)
{
    const struct vec3 *p = a, *q = b;
    return (p->y > q->y) - (p->y < q->y);
}

/* Several threads share points that are sorted by rows, coarsely or well, and do not where they are
 * not: each node takes what it takes of one; equally near points are about many nodes. */
START_TEST(threads)
{
    enum { MANY = 90000 };
    static struct vec3 many[MANY];
    static const double directions[] = {0, 0, 0.4};
    struct error error;
    for (int sorted = 0; sorted < 3; sorted++) {
        for (int i = 0; i < MANY; i++)
            many[i] = vec(floor(300 * uniform()), floor(300 * uniform()), i % 3);
        if (sorted)
            qsort(many, MANY, sizeof *many, by_y);
        struct plan_extent f = plan_extent_of(many, MANY, directions[sorted]);
        struct grid g;
        ck_assert_int_eq(grid_make(&f, MANY, 2, &g, &error), 0);
        size_t *one = reposition(&g, many, MANY, REACH_NEAREST, 1);
        for (int n = 2; n < 5; n++) {
            size_t *other = reposition(&g, many, MANY, REACH_NEAREST, n);
            ck_assert_int_eq(memcmp(one, other, grid_nodes(&g) * sizeof *one), 0);
            free(other);
        }
        free(one);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("reposition");
    TCase *tests = tcase_create("reposition");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, nearest_first);
    tcase_add_test(tests, criterion_a_upper_side);
    tcase_add_test(tests, criterion_b_middle_triangle);
    tcase_add_test(tests, criterion_c_larger_x);
    tcase_add_test(tests, then_larger_z);
    tcase_add_test(tests, equal_within_rounding);
    tcase_add_test(tests, same_as_node_by_node);
    tcase_add_test(tests, empty_node_takes_a_spare_point);
    tcase_add_test(tests, order_does_not_matter);
    tcase_add_test(tests, threads);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
