/* cloud_normals: on a half-ball and a torus all normals point out, close to the exact ones. */
#include <check.h>
#include <stdlib.h>

#include "cloud/segment_steps.h"
#include "rough.h"

/* Both surfaces are curved by 1 / RADIUS at most. */
static const double RADIUS = 4;

/* Points within the reach h of a place are off its tangent plane by h^2 / (2 RADIUS) at most; where
 * they spread by h / 4 at least in each direction, a plane through them tilts by 2 h / RADIUS.
 * Noise tilts it by sigma over the spread h / 2 and the root of their number, of which 5 are
 * allowed. */
static double allowed(const struct vec3s *p, const size_t *near, size_t i, double noise)
{
    double reach = 0;
    for (size_t k = 0; k < CLOUD_NEAR; k++)
        reach = fmax(reach, vec_distance(p->item[i], p->item[near[i * CLOUD_NEAR + k]]));
    return 2 * reach / RADIUS + 5 * noise / (reach / 2 * sqrt(CLOUD_NEAR));
}

static void check(const struct vec3s *p, struct vec3 (*exact)(struct vec3), double noise)
{
    size_t *near = cloud_neighbours(p->item, p->n, 2);
    struct vec3 *normal = mem_alloc(p->n, sizeof *normal);
    cloud_normals(p->item, p->n, near, vec(0, 0, 1), 2, normal);
    for (size_t i = 0; i < p->n; i++) {
        ck_assert_double_eq_tol(vec_length(normal[i]), 1, 1e-12);
        ck_assert_double_le(vec_angle(normal[i], exact(p->item[i])), allowed(p, near, i, noise));
    }
    free(normal);
    free(near);
}

static struct vec3 of_ball(struct vec3 p)
{
    return vec_unit(p);
}

static struct vec3 of_torus(struct vec3 p)
{
    return vec_unit(vec_sub(p, vec_scale(12, vec_unit(vec(p.x, p.y, 0)))));
}

START_TEST(half_ball)
{
    for (int noisy = 0; noisy < 2; noisy++) {
        struct vec3s p = {0};
        for (int i = 0; i < 6000; i++) {
            double z = uniform(), a = 2 * PI * uniform(), r = sqrt(1 - z * z);
            *array_push(&p) =
                vec_scale(4 + 0.01 * noisy * normal(), vec(r * cos(a), r * sin(a), z));
        }
        check(&p, of_ball, 0.01 * noisy);
        array_free(&p);
    }
}
END_TEST

START_TEST(torus)
{
    struct vec3s p = {0};
    while (p.n < 9000) {
        double u = 2 * PI * uniform(), v = PI * uniform(), r = 12 + 4 * cos(v);
        if (16 * uniform() < r)
            *array_push(&p) = vec(r * cos(u), r * sin(u), 4 * sin(v));
    }
    check(&p, of_torus, 0);
    array_free(&p);
}
END_TEST

/* Two sheets apart: each has its own highest point. */
START_TEST(two_pieces_and_their_spacing)
{
    struct vec3s p = {0};
    rectangle(&p, 2500, vec(0, 0, 0), vec(20, 0, 2), vec(0, 20, 0), 0);
    rectangle(&p, 2500, vec(40, 0, -9), vec(20, 0, -2), vec(0, 20, 0), 0);
    size_t *near = cloud_neighbours(p.item, p.n, 1);
    struct vec3 *normal = mem_alloc(p.n, sizeof *normal);
    cloud_normals(p.item, p.n, near, vec(0, 0, 1), 1, normal);
    for (size_t i = 0; i < p.n; i++)
        ck_assert_double_gt(normal[i].z, 0.99);
    ck_assert_double_eq_tol(cloud_spacing(p.item, p.n, near), 0.4, 0.04);
    free(normal);
    free(near);
    array_free(&p);
}
END_TEST

/* The roof of a box and its walls, random points: all normals point out, and beside its edges
 * hardly one is between those of two sides. */
START_TEST(sharp_edges)
{
    for (int noisy = 0; noisy < 2; noisy++) {
        const double noise = 0.02 * noisy;
        struct vec3s p = {0};
        rectangle(&p, 6000, vec(0, 0, 10), vec(30, 0, 0), vec(0, 20, 0), noise);
        rectangle(&p, 3000, vec(0, 0, 0), vec(30, 0, 0), vec(0, 0, 10), noise);
        rectangle(&p, 3000, vec(0, 20, 0), vec(30, 0, 0), vec(0, 0, 10), noise);
        rectangle(&p, 2000, vec(0, 0, 0), vec(0, 20, 0), vec(0, 0, 10), noise);
        rectangle(&p, 2000, vec(30, 0, 0), vec(0, 20, 0), vec(0, 0, 10), noise);
        size_t *near = cloud_neighbours(p.item, p.n, 2), between = 0;
        struct vec3 *normal = mem_alloc(p.n, sizeof *normal);
        cloud_normals(p.item, p.n, near, vec(0, 0, 1), 2, normal);
        for (size_t i = 0; i < p.n; i++) {
            struct vec3 n = vec(fabs(normal[i].x), fabs(normal[i].y), normal[i].z);
            bool out = vec_dot(normal[i], vec_sub(p.item[i], vec(15, 10, 0))) > 0;
            ck_assert(out || n.z < 0.2);
            between += fmax(fmax(n.x, n.y), n.z) < cos(RADIANS(15));
        }
        /* of 16000 about 4, and 5 times its root more; 959 without a choice of planes */
        ck_assert_uint_le(between, 14);
        free(normal);
        free(near);
        array_free(&p);
    }
}
END_TEST

/* A pocket whose upright walls are its highest points: its floor tells which side is up. */
START_TEST(pocket)
{
    struct vec3s p = {0};
    rectangle(&p, 4000, vec(-10, -10, 0), vec(20, 0, 0), vec(0, 20, 0), 0);
    rectangle(&p, 2000, vec(-10, -10, 0), vec(20, 0, 0), vec(0, 0, 10), 0);
    rectangle(&p, 2000, vec(-10, 10, 0), vec(20, 0, 0), vec(0, 0, 10), 0);
    rectangle(&p, 2000, vec(-10, -10, 0), vec(0, 20, 0), vec(0, 0, 10), 0);
    rectangle(&p, 2000, vec(10, -10, 0), vec(0, 20, 0), vec(0, 0, 10), 0);
    size_t *near = cloud_neighbours(p.item, p.n, 1);
    struct vec3 *normal = mem_alloc(p.n, sizeof *normal);
    cloud_normals(p.item, p.n, near, vec(0, 0, 1), 1, normal);
    for (size_t i = 0; i < p.n; i++)
        ck_assert_double_gt(vec_dot(normal[i], vec_sub(vec(0, 0, 12), p.item[i])), 0);
    free(normal);
    free(near);
    array_free(&p);
}
END_TEST

static double rise(double from, double width, double at)
{
    return fmin(1, fmax(0, 0.5 + (at - from) / width));
}

/* An oblique slot, 3 deep, in a ground that leans. */
static double slot(double x, double y)
{
    return 0.3 * x - 3 * rise(0, 0.3, 1.5 - fabs(y - 0.3 * x));
}

static double pocket_of(double x, double y)
{
    return -3 * rise(0, 0.8, fmin(2 - fabs(x - 1), 2 - fabs(y + 1)));
}

static double cross(double x, double y)
{
    return 3 * fmax(rise(0, 0.3, 1 - fabs(x - 1.5)), 0.7 * rise(0, 0.3, 1 - fabs(y - 1)));
}

/* Lines of points as a laser leaves them, dense along and far apart, turned about x: how many of
 * the normals look to the other side. */
static size_t turned_over(double (*height)(double x, double y), double apart, double lean)
{
    const double along = 0.26, fine = 0.005, c = cos(RADIANS(lean)), s = sin(RADIANS(lean));
    struct vec3s p = {0}, out = {0};
    for (double x = -6; x <= 6; x += apart) {
        double way = 0;
        for (double y = -5; y <= 5; y += fine) {
            way += hypot(fine, height(x, y + fine) - height(x, y));
            if (way < along)
                continue;
            way -= along;
            struct vec3 at = vec(x, y, height(x, y)), n = {0, 0, 1};
            n.x = (height(x - fine, y) - height(x + fine, y)) / (2 * fine);
            n.y = (height(x, y - fine) - height(x, y + fine)) / (2 * fine);
            *array_push(&p) = vec(at.x, c * at.y - s * at.z, s * at.y + c * at.z);
            *array_push(&out) = vec_unit(vec(n.x, c * n.y - s * n.z, s * n.y + c * n.z));
        }
    }
    size_t *near = cloud_neighbours(p.item, p.n, 2), over = 0;
    struct vec3 *normal = mem_alloc(p.n, sizeof *normal);
    cloud_normals(p.item, p.n, near, vec(0, 0, 1), 2, normal);
    for (size_t i = 0; i < p.n; i++)
        over += vec_dot(normal[i], out.item[i]) < -0.3;
    free(normal);
    free(near);
    array_free(&p);
    array_free(&out);
    return over;
}

/* Nothing is over these: they face up, but for a few points amid walls that lines cut through. */
START_TEST(lines_from_above)
{
    ck_assert_uint_le(turned_over(cross, 1.26, 0), 20);
    ck_assert_uint_le(turned_over(slot, 0.88, 0), 20);
    ck_assert_uint_le(turned_over(pocket_of, 1.07, 0), 20);
}
END_TEST

/* Too steep to be seen from above, and highest where lines end: most of it faces up. */
START_TEST(lines_that_lean)
{
    ck_assert_uint_le(turned_over(slot, 0.88, 60), 20);
    ck_assert_uint_le(turned_over(slot, 1.26, -72), 20);
    ck_assert_uint_le(turned_over(pocket_of, 1.07, 72), 20);
    ck_assert_uint_le(turned_over(pocket_of, 1.26, -72), 20);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cloud_normals");
    TCase *tests = tcase_create("cloud_normals");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, half_ball);
    tcase_add_test(tests, torus);
    tcase_add_test(tests, two_pieces_and_their_spacing);
    tcase_add_test(tests, sharp_edges);
    tcase_add_test(tests, pocket);
    tcase_add_test(tests, lines_from_above);
    tcase_add_test(tests, lines_that_lean);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
