/* crest_fit: the crest of a ring found again, of a leaning roof, from points on both sides
 * and from a neighbour's crest; of one that is rounded, with its radius; none on a sphere. */
#include <check.h>
#include <stdlib.h>

#include "cloud/crest_fit.h"
#include "noisy.h"

enum { N = 60 };

static const double SPACING = 0.5, WITHIN = 0.01, EVEN = 0.006;

static struct vec3 point[N];
static enum crest_role role[N];

static int compare(const void *pa, const void *pb)
{
    const struct vec3 *a = pa, *b = pb;
    double da = hypot(a->x - point[0].x, a->y - point[0].y);
    double db = hypot(b->x - point[0].x, b->y - point[0].y);
    return (da > db) - (da < db);
}

/* Points as dense as SPACING says about (x, y), the first of them there. */
static void make(double (*height)(double x, double y), double x, double y)
{
    double radius = SPACING * sqrt(N / PI);

    point[0] = vec(x, y, height(x, y));
    for (int i = 1; i < N;) {
        double u = radius * (2 * noisy_uniform() - 1), v = radius * (2 * noisy_uniform() - 1);
        if (hypot(u, v) < radius)
            point[i++] = vec(x + u, y + v, height(x + u, y + v));
    }
    qsort(point + 1, N - 1, sizeof *point, compare);
}

static double ring(double x, double y)
{
    return fmax(0, 4 - 4 * fabs(hypot(x, y) - 6));
}

static double leaning(double x, double y)
{
    double d = x - 0.3 * y;
    return 5 + 0.2 * y - (d > 0 ? 2 : 0.1) * fabs(d);
}

static double sphere(double x, double y)
{
    return sqrt(100 - x * x - y * y);
}

/* The leaning roof's sides, an arc of this radius between them in the plane across. */
static double radius;

static double rounded(double x, double y)
{
    const double left = 0.1, right = 2;
    double across = hypot(1, 0.3), d = (x - 0.3 * y) / across, a = atan(left), b = atan(right);
    double touch = radius * tan((a + b) / 2), middle = radius * sin(a) - touch * cos(a);
    double z = 5 + 0.2 * (y + 0.3 * x) / across;

    if (d <= -touch * cos(a) || d >= touch * cos(b))
        return z - (d > 0 ? right * d : -left * d);
    return z - touch * sin(a) - radius * cos(a) +
           sqrt(radius * radius - (d - middle) * (d - middle));
}

/* Roles begin as what no point has here. */
static int find(struct crest_fit *fit)
{
    for (size_t i = 0; i < N; i++)
        role[i] = CREST_OTHER;
    return crest_fit_find(point, N, SPACING, WITHIN, EVEN, fit, role);
}

static double below; /* so far what off_by looked at was below the surface, at most */

/* How far it is off the surface, across its sides, at most. */
static double off_by(const struct crest_fit *fit, double (*height)(double x, double y),
                     double across)
{
    double worst = below = 0;
    for (double s = -0.8; s <= 0.8; s += 0.1)
        for (double d = -across; d <= across; d += 0.05) {
            struct vec3 at;
            double along, beside;
            if (fabs(d) > fit->far[d > 0])
                continue;
            ck_assert(crest_fit_at(fit, s, d, &at));
            ck_assert(crest_fit_local(fit, at.x, at.y, &along, &beside));
            ck_assert_double_eq_tol(along, s, 1e-9);
            ck_assert_double_eq_tol(beside, d, 1e-9);
            double slope = fit->c[d > 0 ? 5 : 3] + s * fit->c[d > 0 ? 6 : 4];
            double off = (at.z - height(at.x, at.y)) / sqrt(1 + slope * slope);
            worst = fmax(worst, fabs(off));
            below = fmax(below, -off);
        }
    return worst;
}

/* Of n tries that succeed with this share: five standard deviations below their mean, rounded
 * down. */
static int fewest(int n, double share)
{
    return (int)(n * share - 5 * sqrt(n * share * (1 - share)));
}

/* What is explained: the points of a side are as near to it as was asked. */
static void is_explained(const struct crest_fit *fit)
{
    for (size_t i = 0; i < N; i++) {
        double s, d;
        if (role[i] != CREST_SIDE)
            continue;
        ck_assert(crest_fit_local(fit, point[i].x, point[i].y, &s, &d));
        const double *side = fit->c + (d > 0 ? 5 : 3), slope = side[0] + side[1] * s;
        double z = fit->c[0] + fit->c[1] * s + fit->c[2] * s * s - slope * fabs(d);
        ck_assert_double_le(fabs(point[i].z - z) / sqrt(1 + slope * slope), WITHIN * (1 + 1e-9));
    }
    ck_assert_double_le(fit->rms, EVEN);
}

/*
 * Sides a millimetre wide, with ten numbers to be found from some thirty points, a few of which are
 * of the foot and near enough to be taken for a side's.  Over 100 seeds of 20 places a crest was
 * found at 66 of 100 of them, within WITHIN of the ring for 87 of 100 of these; a neighbour's was
 * followed for 96 of 100, within WITHIN for 99.  Here: five standard deviations from these shares.
 */
START_TEST(of_a_ring)
{
    enum { PLACES = 80 };
    struct crest_fit fit, other;
    int found = 0, good = 0, followed = 0, true_too = 0;

    noisy_seed(1);
    for (int k = 0; k < PLACES; k++) {
        make(ring, 6.1, 0.3);
        if (find(&fit) != 0)
            continue;
        found++;
        is_explained(&fit);
        good += off_by(&fit, ring, 0.6) <= WITHIN;
        make(ring, 5.9, -0.7);
        if (crest_fit_follow(point, N, SPACING, WITHIN, EVEN, &fit, &other, role) != 0)
            continue;
        followed++;
        is_explained(&other);
        true_too += off_by(&other, ring, 0.6) <= WITHIN;
    }
    ck_assert_int_ge(found, fewest(PLACES, 0.66));
    ck_assert_int_ge(good, fewest(found, 0.87));
    ck_assert_int_ge(followed, fewest(found, 0.96));
    ck_assert_int_ge(true_too, fewest(followed, 0.99));
}
END_TEST

/* Nothing is beside the sides: what is found is exact.  99 of 100 are. */
START_TEST(of_a_leaning_roof)
{
    enum { PLACES = 40 };
    struct crest_fit fit;
    int found = 0;

    noisy_seed(2);
    for (int k = 0; k < PLACES; k++) {
        make(leaning, 0.1, 0);
        if (find(&fit) != 0)
            continue;
        found++;
        ck_assert_double_le(off_by(&fit, leaning, 1), fit.c[7] > 0 ? WITHIN : 1e-6);
        for (size_t i = 0; i < N; i++)
            ck_assert_int_eq(role[i], CREST_SIDE);
    }
    ck_assert_int_ge(found, fewest(PLACES, 0.99));
}
END_TEST

START_TEST(of_nothing_else)
{
    struct crest_fit fit;

    noisy_seed(4);
    for (int k = 0; k < 20; k++) {
        make(sphere, 1, 2);
        ck_assert_int_eq(find(&fit), -1);
    }
}
END_TEST

/*
 * Nothing is beside the sides and their arc here, either: what is found is it, or sharp where no
 * point is far enough under a sharp crest: it is then as near to its points as was asked, but
 * between them, where there are few, it may be off.  Over 40 seeds of 200 places for each radius a
 * crest was found at 97 of 100 at least; of these 997 of 1,000 at least are within 2 * WITHIN or,
 * sharp, nowhere farther below the surface, and only of the narrowest any may be sharp.
 */
START_TEST(of_a_round_ridge)
{
    enum { PLACES = 40 };
    struct crest_fit fit;
    int found = 0, good = 0;

    radius = 0.4 + 0.4 * _i;
    noisy_seed(5 + (unsigned)_i);
    for (int k = 0; k < PLACES; k++) {
        make(rounded, 0.1, 0);
        if (find(&fit) != 0)
            continue;
        found++;
        double off = off_by(&fit, rounded, 1);
        if (fit.c[7] > 0) {
            good += off <= 2 * WITHIN;
        } else {
            is_explained(&fit);
            good += _i == 0 && below <= 2 * WITHIN; /* others: wider than points are apart */
        }
    }
    ck_assert_int_ge(found, fewest(PLACES, 0.97));
    ck_assert_int_ge(good, fewest(found, 0.997));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("crest_fit");
    TCase *tests = tcase_create("crest_fit");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, of_a_ring);
    tcase_add_test(tests, of_a_leaning_roof);
    tcase_add_test(tests, of_nothing_else);
    tcase_add_loop_test(tests, of_a_round_ridge, 0, 3);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
