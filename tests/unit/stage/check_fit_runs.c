/* fit_runs: runs and links of a path that grows are those of the whole path. */
#include "stage/fit_runs.h"
#include "seed.h"

#include <check.h>
#include <stdlib.h>

#include "base/array.h"

static unsigned state = 1;

static unsigned draw(unsigned n)
{
    state = state * 1664525 + seed_step_32();
    return (state >> 16) % n;
}

/* Points that touch and that do not, rapids and words, in some order; a pass begins at *cut. */
static struct path random_path(size_t *cut, size_t cuts)
{
    struct path path = {.name = "path"};
    for (size_t k = 0; k < cuts; k++) {
        cut[k] = path.item.n;
        path_add_pass(&path, k + 1);
        for (unsigned parts = 1 + draw(4); parts > 0; parts--) {
            unsigned kind = draw(4), n = draw(9);
            for (unsigned i = 0; i < n; i++) {
                struct pose at = {vec((double)path.item.n, 0.01 * (double)(i * i), 0),
                                  vec(0, 0, 1)};
                if (kind == 3) {
                    path_add_feed(&path, 100);
                    continue;
                }
                struct path_item *item = path_add_point(&path, at, kind == 2);
                if (kind == 0)
                    path_set_contact(&path, item, (struct contact){at.p, at.a});
            }
        }
    }
    return path;
}

START_TEST(as_it_grows)
{
    enum { CUTS = 6 };
    size_t links = 0;
    for (int time = 0; time < 400; time++) {
        size_t cut[CUTS];
        struct path path = random_path(cut, CUTS);
        struct run_finder once = {.tolerance = 1}, growing = {.tolerance = 1};
        struct fitted_runs whole = {0}, parts = {0};
        run_finder_look(&once, &path, &whole);
        size_t all = path.item.n;
        for (size_t k = 0; k <= CUTS && path.contact.n > 0; k++) {
            bool touches = false;
            path.item.n = k < CUTS ? cut[k] : all;
            for (size_t i = 0; i < path.item.n; i++)
                touches = touches || path.item.item[i].touches;
            if (touches) /* before, what is a run is not known */
                run_finder_look(&growing, &path, &parts);
        }
        if (path.contact.n > 0) {
            ck_assert_uint_eq(parts.n, whole.n);
            ck_assert_uint_eq(growing.found, once.found);
        }
        for (size_t i = 0; i < parts.n; i++) {
            const struct fitted_run *a = &parts.item[i], *b = &whole.item[i];
            ck_assert_uint_eq(a->from, b->from);
            ck_assert_uint_eq(a->to, b->to);
            ck_assert_uint_eq(a->pass, b->pass);
            ck_assert_uint_eq(a->number, i);
            ck_assert(a->link == b->link);
            links += a->link;
            for (size_t j = a->from + 1; j < a->to; j++)
                ck_assert(path.item.item[j].kind == PATH_POINT && !path.item.item[j].rapid &&
                          path.item.item[j].touches == !a->link);
        }
        array_free(&whole);
        array_free(&parts);
        path_free(&path);
    }
    ck_assert_uint_gt(links, 50);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("fit_runs");
    TCase *tests = tcase_create("fit_runs");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, as_it_grows);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
