/* slice against spheres and planes known exactly, brute force, and meshes with borders and holes.
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "toolpath/slice.h"
#include "toolpath/scallop.h"
#include "shapes.h"
#include "seed.h"

static uint64_t state = 7;

static double uniform(double low, double high)
{
    state = state * 6364136223846793005u + seed_step();
    return low + (high - low) * ((double)(state >> 11) / 9007199254740992.0);
}

static struct vec3 direction(void)
{
    return vec_unit(vec(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)));
}

static struct slice_chains cut_at(const struct mesh *mesh, struct vec3 normal, double height,
                                  bool smooth)
{
    struct slice_chains chains = {0};
    struct slice *cut = slice_new(mesh, normal, smooth, 1);

    slice_at(cut, height, &chains);
    slice_free(cut);
    return chains;
}

/* The farthest that points are off the sphere of radius 50, and normals off the exact ones. */
static void off_sphere(const struct slice_chains *chains, double *off, double *turned)
{
    *off = *turned = 0;
    for (size_t i = 0; i < chains->point.n; i++) {
        const struct contact *c = &chains->point.item[i];
        *off = fmax(*off, fabs(vec_length(c->p) - 50));
        *turned = fmax(*turned, vec_angle(c->p, c->n));
    }
}

START_TEST(points_are_on_the_sphere_and_on_the_plane)
{
    struct mesh mesh = shape_grid(shape_sphere, -20, -20, 20, 20, 20, 20);
    double chord = 3.5, sagitta = chord * chord / (8 * 50);

    for (int i = 0; i < 50; i++) {
        struct vec3 normal = vec_unit(vec(uniform(-1, 1), uniform(-1, 1), uniform(-0.3, 0.3)));
        double height = vec_dot(normal, vec(uniform(-15, 15), uniform(-15, 15), 47)), off, turned;
        struct slice_chains flat = cut_at(&mesh, normal, height, false);
        struct slice_chains smooth = cut_at(&mesh, normal, height, true);
        ck_assert_uint_gt(flat.chain.n, 0);
        ck_assert_uint_eq(flat.chain.n, smooth.chain.n);
        for (size_t k = 0; k < smooth.point.n; k++)
            ck_assert_double_lt(fabs(vec_dot(smooth.point.item[k].p, normal) - height), 1e-9);
        for (size_t k = 0; k < flat.point.n; k++)
            ck_assert_double_lt(fabs(vec_dot(flat.point.item[k].p, normal) - height), 1e-9);
        off_sphere(&flat, &off, &turned);
        ck_assert_double_lt(off, sagitta);
        off_sphere(&smooth, &off, &turned);
        ck_assert_double_lt(off, sagitta / 500);
        ck_assert_double_lt(turned, 1e-3);
        slice_chains_free(&flat);
        slice_chains_free(&smooth);
    }
    mesh_free(&mesh);
}
END_TEST

/* Edges far longer than the grid is fine span what nobody saw: they are straight. */
START_TEST(long_edges_are_straight)
{
    struct mesh mesh = shape_grid(shape_sphere, -20, -20, 20, 20, 20, 20);
    double chord = 3.5, sagitta = chord * chord / (8 * 50);
    struct vec3 normal = vec_unit(vec(1, 2, 0.1));
    struct slice_chains flat = cut_at(&mesh, normal, 3.3, false);
    struct slice_chains smooth = cut_at(&mesh, normal, 3.3, true);
    mesh.origin.spacing = chord;
    struct slice_chains usual = cut_at(&mesh, normal, 3.3, true);
    mesh.origin.spacing = sagitta / 4;
    struct slice_chains gap = cut_at(&mesh, normal, 3.3, true);

    ck_assert_uint_gt(gap.point.n, 0);
    ck_assert_uint_eq(gap.point.n, flat.point.n);
    for (size_t k = 0; k < gap.point.n; k++)
        ck_assert_double_lt(vec_distance(gap.point.item[k].p, flat.point.item[k].p), 1e-9);
    ck_assert_uint_eq(usual.point.n, smooth.point.n);
    for (size_t k = 0; k < usual.point.n; k++)
        ck_assert_double_eq(vec_distance(usual.point.item[k].p, smooth.point.item[k].p), 0);
    slice_chains_free(&flat);
    slice_chains_free(&smooth);
    slice_chains_free(&usual);
    slice_chains_free(&gap);
    mesh_free(&mesh);
}
END_TEST

START_TEST(the_error_is_of_the_fourth_order)
{
    double off[2], turned;

    for (int i = 0; i < 2; i++) {
        struct mesh mesh = shape_grid(shape_sphere, -20, -20, 20, 20, 10 << i, 10 << i);
        struct slice_chains chains = cut_at(&mesh, vec_unit(vec(1, 2, 0.1)), 3.3, true);
        off_sphere(&chains, &off[i], &turned);
        slice_chains_free(&chains);
        mesh_free(&mesh);
    }
    ck_assert_double_gt(off[0] / off[1], 12);
}
END_TEST

/* True when both points lie in the triangle (its plane and inside its sides), but for what a point
 * nearer to the one before, which is left out, may be off. */
static bool holds(const struct mesh *mesh, size_t facet, const struct contact *c)
{
    const int *v = mesh->face.item[facet].v;
    const double crowded = 1e-3;
    struct vec3 n = vec_unit(mesh_face_cross(mesh, facet));

    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 3; i++) {
            struct vec3 a = mesh->vertex.item[v[i]], b = mesh->vertex.item[v[(i + 1) % 3]];
            struct vec3 in = vec_cross(n, vec_unit(vec_sub(b, a)));
            struct vec3 d = vec_sub(c[k].p, a);
            if (vec_dot(d, in) < -crowded || fabs(vec_dot(d, n)) > crowded)
                return false;
        }
    }
    return true;
}

START_TEST(neighbours_lie_in_one_facet)
{
    struct mesh mesh = shape_grid(shape_wave, 0, 0, 44, 51, 12, 14);

    for (int i = 0; i < 40; i++) {
        struct vec3 normal = direction();
        double height = vec_dot(normal, mesh.vertex.item[(size_t)uniform(0, 195)]) + 0.013;
        struct slice_chains chains = cut_at(&mesh, normal, height, false);
        for (size_t k = 0; k < chains.chain.n; k++) {
            for (size_t p = chains.chain.item[k].from; p + 1 < chains.chain.item[k].to; p++) {
                size_t facet = 0;
                while (facet < mesh.face.n && !holds(&mesh, facet, &chains.point.item[p]))
                    facet++;
                ck_assert_msg(facet < mesh.face.n, "plane %d, point %zu", i, p);
            }
        }
        slice_chains_free(&chains);
    }
    mesh_free(&mesh);
}
END_TEST

START_TEST(every_facet_on_the_plane_is_cut_once)
{
    struct mesh mesh = shape_grid(shape_wave, 0, 0, 44, 51, 30, 30);
    struct slice *cut = slice_new(&mesh, vec_unit(vec(3, 1, 2)), false, 1);

    for (int i = 0; i < 100; i++) {
        double height = uniform(slice_low(cut), slice_high(cut)), length = 0, sum = 0;
        struct vec3 normal = vec_unit(vec(3, 1, 2));
        struct slice_chains chains = {0};
        /* The same length as the facets' own crossings, each from its corners. */
        for (size_t f = 0; f < mesh.face.n; f++) {
            struct vec3 end[2];
            int n = 0;
            for (int k = 0; k < 3; k++) {
                struct vec3 a = mesh.vertex.item[mesh.face.item[f].v[k]];
                struct vec3 b = mesh.vertex.item[mesh.face.item[f].v[(k + 1) % 3]];
                double ha = vec_dot(a, normal) - height, hb = vec_dot(b, normal) - height;
                if (ha * hb < 0 && n < 2)
                    end[n++] = vec_mix(a, b, ha / (ha - hb));
            }
            if (n == 2)
                length += vec_distance(end[0], end[1]);
        }
        slice_at(cut, height, &chains);
        for (size_t k = 0; k < chains.chain.n; k++) {
            for (size_t p = chains.chain.item[k].from; p + 1 < chains.chain.item[k].to; p++)
                sum += vec_distance(chains.point.item[p].p, chains.point.item[p + 1].p);
        }
        ck_assert_double_eq_tol(sum, length, 0.01);
        slice_chains_free(&chains);
    }
    slice_free(cut);
    mesh_free(&mesh);
}
END_TEST

/* Points over all planes of a step along a direction. */
static size_t count_points(const struct mesh *mesh, struct vec3 normal, double step, size_t *planes)
{
    struct slice *cut = slice_new(mesh, normal, true, 1);
    struct doubles height = {0};
    struct slice_chains chains = {0};

    scallop_equal(slice_low(cut), slice_high(cut), step, &height);
    for (size_t i = 0; i < height.n; i++)
        slice_at(cut, height.item[i], &chains);
    size_t n = chains.point.n;
    ck_assert_uint_eq(chains.chain.n, height.n);
    *planes = height.n;
    slice_chains_free(&chains);
    array_free(&height);
    slice_free(cut);
    return n;
}

/* Paper 2: 9,023 = 22 * 401 + 201 points at step 2 over 44 mm, 13,033 = 32 * 401 + 201 at step 5
 * over 160 mm, on 200 x 200 cells: the first plane is on the border, the last one just inside. */
START_TEST(counts_of_the_paper)
{
    struct mesh s1 = shape_grid(shape_wave, 0, 0, 44, 51, 200, 200);
    struct mesh s2 = shape_grid(shape_wave, 0, 0, 102, 160, 200, 200);
    size_t planes;

    ck_assert_uint_eq(count_points(&s1, vec(1, 0, 0), 2, &planes), 9023);
    ck_assert_uint_eq(planes, 23);
    ck_assert_uint_eq(count_points(&s2, vec(0, 1, 0), 5, &planes), 13033);
    ck_assert_uint_eq(planes, 33);
    mesh_free(&s1);
    mesh_free(&s2);
}
END_TEST

/* A mesh stream has 6 decimals: a border that is straight stays one when it is turned and rounded.
 */
START_TEST(a_border_that_is_rounded_is_still_one)
{
    struct mesh mesh = shape_grid(shape_wave, 0, 0, 44, 51, 50, 50);
    size_t planes;

    for (size_t v = 0; v < mesh.vertex.n; v++) {
        struct vec3 p = vec_turn(mesh.vertex.item[v], vec(0, 0, 1), 0.7);
        mesh.vertex.item[v] =
            vec(round(p.x * 1e6) / 1e6, round(p.y * 1e6) / 1e6, round(p.z * 1e6) / 1e6);
        mesh.normal.item[v] = vec_turn(mesh.normal.item[v], vec(0, 0, 1), 0.7);
    }
    ck_assert_uint_eq(count_points(&mesh, vec(cos(0.7), sin(0.7), 0), 4, &planes),
                      51 + (planes - 1) * 101);
    mesh_free(&mesh);
}
END_TEST

START_TEST(a_ring_is_closed)
{
    struct mesh mesh = shape_ball(50, 40, 60);

    for (int i = 0; i < 30; i++) {
        struct vec3 normal = direction();
        double height = uniform(-40, 40), sum = 0;
        struct slice_chains chains = cut_at(&mesh, normal, height, true);
        ck_assert_uint_eq(chains.chain.n, 1);
        ck_assert(chains.chain.item[0].closed);
        const struct contact *c = chains.point.item;
        ck_assert_double_eq(vec_distance(c[0].p, c[chains.point.n - 1].p), 0);
        for (size_t k = 0; k + 1 < chains.point.n; k++) {
            /* Forwards is normal x surface normal. */
            ck_assert_double_gt(vec_dot(vec_sub(c[k + 1].p, c[k].p), vec_cross(normal, c[k].n)), 0);
            sum += vec_distance(c[k].p, c[k + 1].p);
        }
        ck_assert_double_eq_tol(sum, 2 * PI * sqrt(2500 - height * height), 2.5);
        slice_chains_free(&chains);
    }
    mesh_free(&mesh);
}
END_TEST

START_TEST(a_hole_breaks_a_chain)
{
    struct mesh mesh = shape_grid(shape_sphere, -20, -20, 20, 20, 20, 20);
    size_t kept = 0;

    for (size_t f = 0; f < mesh.face.n; f++) {
        struct vec3 p = mesh.vertex.item[mesh.face.item[f].v[0]];
        if (fabs(p.x) > 5 || fabs(p.y) > 5)
            mesh.face.item[kept++] = mesh.face.item[f];
    }
    mesh.face.n = kept;
    struct slice_chains through = cut_at(&mesh, vec(0, 1, 0), 0.7, true);
    struct slice_chains beside = cut_at(&mesh, vec(0, 1, 0), 12.7, true);
    ck_assert_uint_eq(through.chain.n, 2);
    ck_assert_uint_eq(beside.chain.n, 1);
    for (size_t i = 0; i < through.point.n; i++)
        ck_assert_double_gt(fabs(through.point.item[i].p.x), 4);
    slice_chains_free(&through);
    slice_chains_free(&beside);
    mesh_free(&mesh);
}
END_TEST

/* Three sheets on one edge: no way through is better than another. */
START_TEST(an_edge_of_three_facets_ends_chains)
{
    struct mesh mesh = {0};
    static const struct vec3 p[] = {{0, -5, 0}, {0, 5, 0}, {9, 0, 0}, {-9, 0, 0}, {0, 0, 9}};

    for (int i = 0; i < 5; i++) {
        *array_push(&mesh.vertex) = p[i];
        *array_push(&mesh.normal) = vec(0, 0, 1);
    }
    for (int i = 2; i < 5; i++)
        *array_push(&mesh.face) = (struct face){{0, 1, i}};
    struct slice_chains chains = cut_at(&mesh, vec(0, 1, 0), 1, false);
    ck_assert_uint_eq(chains.chain.n, 3);
    slice_chains_free(&chains);
    mesh_free(&mesh);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("slice");
    TCase *tests = tcase_create("slice");
    tcase_add_test(tests, points_are_on_the_sphere_and_on_the_plane);
    tcase_add_test(tests, the_error_is_of_the_fourth_order);
    tcase_add_test(tests, long_edges_are_straight);
    tcase_add_test(tests, neighbours_lie_in_one_facet);
    tcase_add_test(tests, every_facet_on_the_plane_is_cut_once);
    tcase_add_test(tests, counts_of_the_paper);
    tcase_add_test(tests, a_border_that_is_rounded_is_still_one);
    tcase_add_test(tests, a_ring_is_closed);
    tcase_add_test(tests, a_hole_breaks_a_chain);
    tcase_add_test(tests, an_edge_of_three_facets_ends_chains);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
