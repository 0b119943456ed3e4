/* feature_link, feature_relocate: a roof's ridge and a wall over a grid of facets, with some of
 * what crosses it forgotten: it comes back where it was, and only between its ends. */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "feature/feature_steps.h"

enum { COLUMNS = 7, ROWS = 12 };

static struct mesh m;
static struct mesh_edges edges;
static struct feature *feature;
static double slope; /* of the line x = 3.4 + slope y */

/* How far a place is from the line, as the x goes; > 0 on the higher side of the wall. */
static double off_line(struct vec3 p)
{
    return p.x - 3.4 - slope * p.y;
}

static double height(enum feature_kind kind, struct vec3 p)
{
    return kind == FEATURE_WALL ? (off_line(p) > 0 ? 5 : 0) : -0.7 * fabs(off_line(p));
}

/* What crosses an edge, exactly. */
static struct feature crossing(enum feature_kind kind, struct vec3 a, struct vec3 b)
{
    struct feature f = {.kind = FEATURE_NONE};
    double from = off_line(a), to = off_line(b);
    if ((from > 0) == (to > 0))
        return f;
    struct vec3 at = vec_mix(a, b, from / (from - to)), out = vec_unit(vec(1, -slope, 0));
    double unit = hypot(1, slope);
    f.kind = kind;
    for (int i = 0; i < 2; i++) {
        double sign = (i == 0 ? from : to) > 0 ? 1 : -1;
        f.place[i] = vec(at.x, at.y, kind == FEATURE_WALL && sign > 0 ? 5 : 0);
        f.normal[i] = kind == FEATURE_WALL
                          ? vec(0, 0, 1)
                          : vec_unit(vec(sign * 0.7 * unit * out.x, sign * 0.7 * unit * out.y, 1));
        f.end[i] = f.normal[i];
        f.foot[i] = i == 0 ? a : b;
    }
    f.wall = kind == FEATURE_WALL ? vec_scale(-1, out) : vec(0, 0, 0);
    f.along = vec_unit(vec(slope, 1, 0));
    f.known = 10;
    return f;
}

static void set_up(enum feature_kind kind)
{
    m = (struct mesh){0};
    for (int j = 0; j < ROWS; j++)
        for (int i = 0; i < COLUMNS; i++) {
            struct vec3 p = vec(i + 0.5 * (j % 2), 0.866 * j, 0);
            p.z = height(kind, p);
            *array_push(&m.vertex) = p;
            *array_push(&m.normal) = vec(0, 0, 1);
        }
    for (int j = 0; j + 1 < ROWS; j++)
        for (int i = 0; i + 1 < COLUMNS; i++) {
            int a = j * COLUMNS + i, b = a + 1, c = a + COLUMNS, d = c + 1;
            *array_push(&m.face) = j % 2 ? (struct face){{a, b, d}} : (struct face){{a, b, c}};
            *array_push(&m.face) = j % 2 ? (struct face){{a, d, c}} : (struct face){{b, d, c}};
        }
    edges = mesh_edges_find(&m);
    feature = mem_alloc(edges.n, sizeof *feature);
    for (size_t e = 0; e < edges.n; e++)
        feature[e] =
            crossing(kind, m.vertex.item[edges.edge[e].v[0]], m.vertex.item[edges.edge[e].v[1]]);
}

static void tear_down(void)
{
    mesh_edges_free(&edges);
    mesh_free(&m);
    free(feature);
}

/* Forgets what crosses edges whose middles have y in this range; returns how many did. */
static size_t forget(double from, double to)
{
    size_t n = 0;
    for (size_t e = 0; e < edges.n; e++) {
        double y = (m.vertex.item[edges.edge[e].v[0]].y + m.vertex.item[edges.edge[e].v[1]].y) / 2;
        if (feature[e].kind == FEATURE_NONE || y < from || y > to)
            continue;
        feature[e].kind = FEATURE_NONE;
        n++;
    }
    return n;
}

static void compare(const struct feature *was)
{
    for (size_t e = 0; e < edges.n; e++) {
        ck_assert_int_eq(feature[e].kind, was[e].kind);
        for (int i = 0; i < 2 && was[e].kind != FEATURE_NONE; i++) {
            ck_assert_double_le(vec_distance(feature[e].place[i], was[e].place[i]), 1e-9);
            ck_assert_double_le(vec_distance(feature[e].normal[i], was[e].normal[i]), 1e-9);
            ck_assert_double_le(vec_distance(feature[e].foot[i], was[e].foot[i]), 1e-9);
        }
    }
}

START_TEST(gaps)
{
    for (int kind = FEATURE_CREASE; kind <= FEATURE_WALL; kind++)
        for (slope = -0.21; slope < 0.3; slope += 0.13) {
            set_up(kind);
            struct feature *was = mem_alloc(edges.n, sizeof *was);
            memcpy(was, feature, edges.n * sizeof *was);
            size_t all = feature_link_longest(&edges, feature), gone = forget(3, 4);
            ck_assert_uint_ge(all, 2 * ROWS - 2);
            ck_assert_uint_gt(gone, 1);
            size_t longest = feature_link_longest(&edges, feature);
            ck_assert_uint_lt(longest, all - gone);
            ck_assert_uint_ge(2 * longest, all - gone);
            feature_link_close(&m, &edges, feature);
            compare(was);
            ck_assert_uint_gt(forget(8.3, 99), 1); /* to the border */
            feature_link_close(&m, &edges, feature);
            compare(was);
            free(was);
            tear_down();
        }
}
END_TEST

/* Neither across a gap that is too long, nor where there is none. */
START_TEST(ends)
{
    slope = 0.1;
    set_up(FEATURE_CREASE);
    struct feature *was = mem_alloc(edges.n, sizeof *was);
    ck_assert_uint_gt(forget(2, 99), 12);
    memcpy(was, feature, edges.n * sizeof *was);
    feature_link_close(&m, &edges, feature);
    compare(was);
    free(was);
    tear_down();
}
END_TEST

/* Vertices stand a quarter of an edge off in the end, and on their sheets. */
START_TEST(settled)
{
    slope = 0;
    set_up(FEATURE_CREASE);
    struct feature_relocate s = {&m, &edges, feature, 0.4, 0.05};
    struct mesh before = {.vertex = {m.vertex.n, 0, mem_alloc(m.vertex.n, sizeof(struct vec3))},
                          .normal = {m.normal.n, 0, mem_alloc(m.normal.n, sizeof(struct vec3))}};
    unsigned char *beside = mem_alloc(m.vertex.n, 1);
    memcpy(before.vertex.item, m.vertex.item, m.vertex.n * sizeof(struct vec3));
    memcpy(before.normal.item, m.normal.item, m.vertex.n * sizeof(struct vec3));
    for (size_t v = 0; v < m.vertex.n; v += 3)
        m.vertex.item[v].z += 0.04;
    feature_relocate_feet(&s);
    feature_relocate_places(&s, beside);
    feature_relocate_normals(&s);
    for (size_t v = 0; v < m.vertex.n; v++) {
        struct vec3 p = m.vertex.item[v];
        if (fabs(off_line(p)) > 0.6)
            continue;
        ck_assert(beside[v]);
        ck_assert_double_ge(fabs(off_line(p)), 0.2);
        ck_assert_double_eq_tol(p.z, height(FEATURE_CREASE, p), 1e-9);
        ck_assert_double_gt(m.normal.item[v].x * off_line(p), 0.1);
    }
    for (size_t e = 0; e < edges.n; e++)
        feature[e].kind = FEATURE_NONE;
    feature_relocate_back(&s, &before);
    for (size_t v = 0; v < m.vertex.n; v++)
        ck_assert(vec_distance(m.vertex.item[v], before.vertex.item[v]) == 0);
    free(beside);
    mesh_free(&before);
    tear_down();
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("feature_link");
    TCase *tests = tcase_create("feature_link");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, gaps);
    tcase_add_test(tests, ends);
    tcase_add_test(tests, settled);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
