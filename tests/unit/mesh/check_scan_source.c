/* scan_source: what changes the hash and what does not, and the words of the streams. */
#include <check.h>
#include <stdlib.h>

#include "mesh/scan_source.h"
#include "rough.h"

enum { N = 50 };

static void fill(struct vec3 *p)
{
    for (int i = 0; i < N; i++)
        p[i] = vec(uniform(), uniform(), uniform());
}

START_TEST(any_change)
{
    struct vec3 p[N];
    fill(p);
    uint64_t hash = scan_source_hash(p, N);

    ck_assert_uint_eq(hash, scan_source_hash(p, N));
    ck_assert_uint_ne(hash, scan_source_hash(p, N - 1));
    ck_assert_uint_ne(hash, scan_source_hash(p + 1, N - 1));
    for (int i = 0; i < N; i++)
        for (int k = 0; k < 3; k++) {
            double *x = k == 0 ? &p[i].x : k == 1 ? &p[i].y : &p[i].z, old = *x;
            *x = nextafter(old, 2);
            ck_assert_uint_ne(hash, scan_source_hash(p, N));
            *x = -old;
            ck_assert_uint_ne(hash, scan_source_hash(p, N));
            *x = old;
        }
    for (int i = 1; i < N; i++) { /* a point instead of another; two that exchange their z */
        struct vec3 q = p[i];
        p[i] = p[i - 1];
        ck_assert_uint_ne(hash, scan_source_hash(p, N));
        p[i] = vec(q.x, q.y, p[i - 1].z);
        p[i - 1].z = q.z;
        ck_assert_uint_ne(hash, scan_source_hash(p, N));
        p[i - 1].z = p[i].z;
        p[i] = q;
    }
    for (int i = 0; i < N / 2; i++) { /* the order does not matter */
        struct vec3 q = p[i];
        p[i] = p[N - 1 - i];
        p[N - 1 - i] = q;
    }
    ck_assert_uint_eq(hash, scan_source_hash(p, N));
}
END_TEST

START_TEST(one_zero)
{
    struct vec3 plus = vec(0, 1, 0), minus = vec(-0.0, 1, -0.0);
    ck_assert_uint_eq(scan_source_hash(&plus, 1), scan_source_hash(&minus, 1));
}
END_TEST

START_TEST(words)
{
    static const char *const bad[] = {"",
                                      "12",
                                      "12,0123456789abcdef",
                                      "12,0123456789abcdef,",
                                      "12,0123456789abcde,a",
                                      "12,0123456789abcdefa,a",
                                      "x,0123456789abcdef,a",
                                      "-1,0123456789abcdef,a",
                                      "12 0123456789abcdef a"};
    struct scan_sources scan = {0};

    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        ck_assert(!scan_sources_read(&scan, bad[i], ','));
    ck_assert(scan_sources_read(&scan, "12,0123456789ABCDEF,a, b.xyz", ','));
    ck_assert(scan_sources_read(&scan, "7 fedcba9876543210 c d", ' '));
    struct scan_sources copy = scan_sources_copy(&scan);
    scan_sources_free(&scan);
    ck_assert_uint_eq(copy.n, 2);
    ck_assert_uint_eq(copy.item[0].points, 12);
    ck_assert_uint_eq(copy.item[0].hash, 0x0123456789abcdef);
    ck_assert_str_eq(copy.item[0].name, "a, b.xyz");
    ck_assert_uint_eq(copy.item[1].hash, 0xfedcba9876543210);
    ck_assert_str_eq(copy.item[1].name, "c d");
    scan_sources_free(&copy);
}
END_TEST

int main(void)
{
    Suite *s = suite_create("scan_source");
    TCase *t = tcase_create("scan_source");
    tcase_add_test(t, any_change);
    tcase_add_test(t, one_zero);
    tcase_add_test(t, words);
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed != 0;
}
