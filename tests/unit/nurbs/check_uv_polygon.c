/* uvloops: what is inside random stars by another rule, the sum of the angles at a place. */
#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/array.h"
#include "nurbs/uv_polygon.h"

static uint64_t state = 7;

static double uniform(double low, double high)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * ((double)(state >> 11) / 9007199254740992.0);
}

static struct uvs star(struct uv at, double least, double most, int n, bool backwards)
{
    struct uvs loop = {0};
    for (int i = 0; i < n; i++) {
        double a = 2 * PI * (backwards ? n - i : i) / n, r = uniform(least, most);
        *array_push(&loop) = (struct uv){at.u + r * cos(a), at.v + r * sin(a)};
    }
    return loop;
}

/* How often the loop goes round: the angles under which its sides are seen. */
static int turns(const struct uvs *loop, struct uv p)
{
    double sum = 0;
    for (size_t i = 0; i < loop->n; i++) {
        struct uv a = loop->item[i], b = loop->item[(i + 1) % loop->n];
        a.u -= p.u, a.v -= p.v, b.u -= p.u, b.v -= p.v;
        sum += atan2(a.u * b.v - a.v * b.u, a.u * b.u + a.v * b.v);
    }
    return (int)floor(sum / (2 * PI) + 0.5);
}

START_TEST(inside_by_angles)
{
    for (int turn = 0; turn < 60; turn++) {
        struct uv_polygon loops = {0};
        for (int k = 0; k < 3; k++)
            *array_push(&loops) = star((struct uv){uniform(-1, 1), uniform(-1, 1)}, 0.3, 2,
                                       3 + (int)uniform(0, 20), uniform(0, 1) < 0.5);
        for (int i = 0; i < 200; i++) {
            struct uv p = {uniform(-3, 3), uniform(-3, 3)};
            int n = 0;
            for (size_t k = 0; k < 3; k++)
                n += abs(turns(&loops.item[k], p));
            ck_assert(uv_polygon_inside(&loops, false, p) == (n % 2 == 1));
            ck_assert(uv_polygon_inside(&loops, true, p) == (n % 2 == 0));
        }
        uv_polygon_free(&loops);
    }
}
END_TEST

/* An outer loop and a hole in it: each backwards as it is made. */
START_TEST(hands)
{
    for (int k = 0; k < 4; k++) {
        struct uv_polygon loops = {0};
        *array_push(&loops) = star((struct uv){0, 0}, 2, 3, 17, k & 1);
        *array_push(&loops) = star((struct uv){0, 0}, 0.5, 1, 9, k & 2);
        ck_assert(uv_polygon_backwards(&loops, 0, false) == (k & 1));
        ck_assert(uv_polygon_backwards(&loops, 1, false) != ((k & 2) != 0));
        ck_assert(uv_polygon_backwards(&loops, 0, true) != (k & 1));
        uv_polygon_free(&loops);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("uvloops");
    TCase *tests = tcase_create("uvloops");
    SRunner *runner = srunner_create(suite);
    tcase_set_timeout(tests, 60);
    tcase_add_test(tests, inside_by_angles);
    tcase_add_test(tests, hands);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
