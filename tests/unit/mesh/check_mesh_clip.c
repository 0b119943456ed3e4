/* mesh_clip: a ball's upper half cut by planes and by steepness has the area that is known, and its
 * new vertices are where they should be. */
#include <check.h>
#include <stdlib.h>

#include "mesh/mesh_clip.h"

enum { RINGS = 40, AROUND = 120 };

static const double R = 10;

static struct mesh half_ball(void)
{
    struct mesh m = {0};
    for (int ring = 0; ring <= RINGS; ring++)
        for (int k = 0; k < AROUND; k++) {
            double lean = PI / 2 * (ring + 0.001) / (RINGS + 0.001), t = 2 * PI * k / AROUND;
            struct vec3 n = vec(sin(lean) * cos(t), sin(lean) * sin(t), cos(lean));
            *array_push(&m.normal) = n;
            *array_push(&m.vertex) = vec_scale(R, n);
            int a = ring * AROUND + k, b = ring * AROUND + (k + 1) % AROUND;
            if (ring == RINGS)
                continue;
            *array_push(&m.face) = (struct face){{a, a + AROUND, b}};
            *array_push(&m.face) = (struct face){{b, a + AROUND, b + AROUND}};
        }
    return m;
}

static double area(const struct mesh *m)
{
    double sum = 0;
    for (size_t f = 0; f < m->face.n; f++)
        sum += vec_length(mesh_face_cross(m, f)) / 2;
    return sum;
}

/* Every vertex is a facet's, has a unit normal and lies on the ball. */
static void holds(const struct mesh *m)
{
    bool *used = mem_alloc(m->vertex.n, sizeof *used);
    ck_assert_uint_eq(m->normal.n, m->vertex.n);
    for (size_t f = 0; f < m->face.n; f++)
        for (int i = 0; i < 3; i++)
            used[m->face.item[f].v[i]] = true;
    for (size_t v = 0; v < m->vertex.n; v++) {
        ck_assert(used[v]);
        ck_assert_double_eq_tol(vec_length(m->normal.item[v]), 1, 1e-9);
        ck_assert_double_eq_tol(vec_length(m->vertex.item[v]), R, 2e-3);
    }
    free(used);
}

/* Of a zone of the height h there are 2 pi R h (Archimedes). */
START_TEST(planes)
{
    for (int i = 1; i < 10; i++) {
        struct mesh m = half_ball();
        double whole = area(&m), at = i - 0.37;
        mesh_clip_plane(&m, vec(0, 0, 1), at);
        mesh_clip_unused(&m);
        holds(&m);
        for (size_t v = 0; v < m.vertex.n; v++)
            ck_assert_double_ge(m.vertex.item[v].z, at - 1e-9);
        ck_assert_double_eq_tol(area(&m) / whole, (R - at) / R, 2e-3);
        mesh_free(&m);
    }
}
END_TEST

/* Edges far longer than the grid is fine are cut as they are: on their chords, inside the ball. */
START_TEST(long_edges_are_straight)
{
    struct mesh m = half_ball();
    double deepest = 0;

    m.origin.spacing = 1e-3;
    mesh_clip_plane(&m, vec(0, 0, 1), 4.63);
    for (size_t v = 0; v < m.vertex.n; v++)
        deepest = fmax(deepest, R - vec_length(m.vertex.item[v]));
    ck_assert_double_gt(deepest, 2e-3); /* of what holds() lets by */
    mesh_free(&m);
}
END_TEST

/* Two halves are the whole. */
START_TEST(halves)
{
    struct mesh a = half_ball(), b = mesh_clip_copy(&a);
    struct vec3 d = vec_unit(vec(1, 0.3, 0.2));
    double whole = area(&a);
    ck_assert_double_eq_tol(area(&b), whole, 1e-9);
    mesh_clip_plane(&a, d, 1.3);
    mesh_clip_plane(&b, vec_scale(-1, d), -1.3);
    ck_assert_double_eq_tol(area(&a) + area(&b), whole, 1e-3 * whole);
    ck_assert_double_gt(area(&a), 0.3 * whole);
    mesh_free(&a);
    mesh_free(&b);
}
END_TEST

/* From 20 to 50 degrees: cos 20 - cos 50 of the half. */
START_TEST(steep)
{
    struct mesh m = half_ball();
    double whole = area(&m), least = RADIANS(20), most = RADIANS(50);
    mesh_clip_steep(&m, vec(0, 0, 1), least, most);
    mesh_clip_unused(&m);
    holds(&m);
    for (size_t v = 0; v < m.vertex.n; v++) {
        double lean = vec_angle(m.normal.item[v], vec(0, 0, 1));
        ck_assert_double_ge(lean, least - 0.01);
        ck_assert_double_le(lean, most + 0.01);
    }
    ck_assert_double_eq_tol(area(&m) / whole, cos(least) - cos(most), 5e-3);
    mesh_free(&m);
}
END_TEST

START_TEST(surfaces)
{
    struct mesh m = half_ball();
    const bool keep[] = {false, true, false};
    size_t kept = 0;
    for (size_t f = 0; f < m.face.n; f++) {
        *array_push(&m.surface) = (int)(f % 3);
        kept += f % 3 == 1;
    }
    mesh_clip_surfaces(&m, keep);
    ck_assert_uint_eq(m.face.n, kept);
    ck_assert_uint_eq(m.surface.n, kept);
    for (size_t f = 0; f < m.face.n; f++)
        ck_assert_int_eq(m.surface.item[f], 1);
    mesh_free(&m);
}
END_TEST

/* What lies over a slanted square without a triangle in it has their area, seen along z. */
START_TEST(polygons_seen_from_above)
{
    const struct vec3 corner[] = {{6, 1, 0},  {1, 6, 0},   {-5, 0, 0}, {0, -5, 0},
                                  {-1, 0, 0}, {2.5, 1, 0}, {0.5, 3, 0}};
    struct mesh m = half_ball();
    struct region_polygons p = {0};
    double seen = 0;
    for (int i = 0; i < 7; i++)
        *array_push(&p.corner) = corner[i];
    *array_push(&p.from) = 0;
    *array_push(&p.from) = 4;
    mesh_clip_polygons(&m, &p);
    mesh_clip_unused(&m);
    holds(&m);
    for (size_t f = 0; f < m.face.n; f++)
        seen += mesh_face_cross(&m, f).z / 2;
    /* |(-5, 5)| |(-6, -6)|, and half of (3.5, 1) x (1.5, 3); a border that
     * another side crosses gets a corner as round as the ball: 0.5^2 / 8 R off, for 0.5 mm */
    ck_assert_double_eq_tol(seen, 60 - (3.5 * 3 - 1.5) / 2, 0.5 * 0.5 * 0.5 / 8 / R);
    array_free(&p.corner);
    array_free(&p.from);
    mesh_free(&m);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("mesh_clip");
    TCase *tests = tcase_create("mesh_clip");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, planes);
    tcase_add_test(tests, halves);
    tcase_add_test(tests, long_edges_are_straight);
    tcase_add_test(tests, steep);
    tcase_add_test(tests, surfaces);
    tcase_add_test(tests, polygons_seen_from_above);

    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
