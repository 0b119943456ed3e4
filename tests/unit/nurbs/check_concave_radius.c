/*
 * concave_radius: bicubic graphs z = f(x, y) over a square, whose curvature is known by formula:
 * the place found is at least as concave as any of a dense grid, inside the trimming, from either
 * side.
 */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/array.h"
#include "nurbs/concave_radius.h"
#include "nurbs/trim_loops.h"
#include "nurbs/tessellate.h"
#include "seed.h"

static uint64_t seed;

static double chance(void)
{
    seed = seed * 6364136223846793005u + seed_step();
    return (double)(seed >> 11) / 9007199254740992.0;
}

/* Random poles of a height field with inner knots, x and y linear in u and v, which go from `from`
 * to 4 more. */
static struct patch random_patch(double from)
{
    struct patch p = {0};
    struct nurbs *s = &p.surface;
    size_t n = 7;
    s->u = s->v = (struct nurbs_axis){.degree = 3, .poles = n, .from = from, .to = from + 4};
    s->u.knot = mem_alloc(n + 4, sizeof *s->u.knot);
    s->v.knot = mem_alloc(n + 4, sizeof *s->v.knot);
    for (size_t i = 0; i < n + 4; i++)
        s->u.knot[i] = s->v.knot[i] = from + (i < 4 ? 0 : i > 6 ? 4 : (double)i - 3);
    s->pole = mem_alloc(n * n, sizeof *s->pole);
    for (size_t i = 0; i < n * n; i++) {
        size_t a = i % n, b = i / n;
        double x = (s->u.knot[a + 1] + s->u.knot[a + 2] + s->u.knot[a + 3]) / 3;
        double y = (s->v.knot[b + 1] + s->v.knot[b + 2] + s->v.knot[b + 3]) / 3;
        s->pole[i] = (struct nurbs_pole){10 * x, 10 * y, 12 * chance(), 1};
    }
    return p;
}

/* The most concave place of some is on the border: of the trimming, where a search in directions
 * stalls, and of the range, to which a ridge leads between the samples. */
START_TEST(no_place_is_more_hollow)
{
    seed = 6 + 1000 * (uint64_t)_i;
    for (int turn = 0; turn < 12; turn++) {
        double from = turn % 4 < 2 ? 0 : -1.5, middle = from + 2; /* a span is about 0 */
        struct patch p = random_patch(from);
        struct uv_polygon loops = {0};
        struct uvs disc = {0};
        struct patch_loop ring = {0};
        bool flipped = turn % 2, trimmed = turn % 3 == 0;
        for (int i = 0; i < 100 && trimmed; i++)
            *array_push(&disc) = (struct uv){middle + 1.5 * cos(2 * PI * i / 100),
                                             middle + 1.5 * sin(2 * PI * i / 100)};
        if (trimmed)
            *array_push(&loops) = disc;
        for (size_t i = 0; i < disc.n && trimmed; i++)
            *array_push(&ring) = patch_line(disc.item[i], disc.item[(i + 1) % disc.n]);
        if (trimmed)
            *array_push(&p.loop) = ring;
        struct concave_radius h = concave_radius_find(&p, flipped, 1);
        for (int i = 0; i <= 200; i++)
            for (int k = 0; k <= 200; k++) {
                struct uv at = {from + 4 * i / 200.0, from + 4 * k / 200.0};
                if (trimmed && !uv_polygon_inside(&loops, false, at))
                    continue;
                struct nurbs_place q = nurbs_place(&p.surface, at);
                ck_assert_double_ge(h.curvature + 1e-9, flipped ? -q.k2 : q.k1);
            }
        struct nurbs_place q = nurbs_place(&p.surface, h.at);
        ck_assert_double_lt(fabs(h.curvature - (flipped ? -q.k2 : q.k1)), 1e-9);
        ck_assert_double_lt(vec_distance(q.point, h.point), 1e-9);
        /* inside, or on the border, of 100 chords of a circle of 1.5 about the middle */
        double out = hypot(h.at.u - middle, h.at.v - middle), side = 2 * PI / 100;
        double turned = atan2(h.at.v - middle, h.at.u - middle),
               along = remainder(turned - side / 2, side);
        ck_assert(!trimmed || out * cos(along) < 1.5 * cos(side / 2) + 1e-9);
        uv_polygon_free(&loops);
        patch_free(&p);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("concave_radius");
    TCase *tests = tcase_create("concave_radius");
    SRunner *runner = srunner_create(suite);
    tcase_set_timeout(tests, 60);
    tcase_add_loop_test(tests, no_place_is_more_hollow, 0, 4);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
