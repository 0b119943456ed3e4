#include "clouds.h"

#include <check.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "scratch.h"
#include "seed.h"

struct clouds clouds;

void clouds_clear(void)
{
    array_free(&clouds.points);
}

int clouds_bytes(const char *text, size_t n)
{
    clouds.points.n = 0;
    return cloud_read(scratch_bytes(text, n), 1, &clouds.points, &clouds.count, &clouds.error);
}

int clouds_text(const char *text)
{
    return clouds_bytes(text, strlen(text));
}

void clouds_expect(const char *text, size_t n, const double want[][3])
{
    ck_assert_msg(clouds_text(text) == 0, "%s\n%s", clouds.error.text, text);
    ck_assert_msg(clouds.points.n == n, "%zu points, not %zu, of\n%s", clouds.points.n, n, text);
    ck_assert_uint_eq(clouds.count.points, n);
    for (size_t i = 0; i < n; i++) {
        struct vec3 p = clouds.points.item[i];
        ck_assert_msg(p.x == want[i][0] && p.y == want[i][1] && p.z == want[i][2],
                      "point %zu: %.17g %.17g %.17g of\n%s", i, p.x, p.y, p.z, text);
    }
}

void clouds_three(const char *text)
{
    static const double want[][3] = {{1.5, -2.25, 3000}, {0.5, 0.25, -4}, {7, 8, 9}};
    clouds_expect(text, 3, want);
}

void clouds_refused_bytes(const char *text, size_t n, const char *says)
{
    ck_assert_msg(clouds_bytes(text, n) == -1, "read, should say %s:\n%s", says, text);
    ck_assert_msg(strstr(clouds.error.text, says) != NULL, "%s\n  lacks: %s", clouds.error.text,
                  says);
    ck_assert_msg(strncmp(clouds.error.text, scratch_name(), strlen(scratch_name())) == 0, "%s",
                  clouds.error.text);
}

void clouds_refused(const char *text, const char *says)
{
    clouds_refused_bytes(text, strlen(text), says);
}

static uint64_t state = 1;

unsigned clouds_below(unsigned n)
{
    state = state * 6364136223846793005u + seed_step();
    return (unsigned)(state >> 33) % n;
}

size_t clouds_number(char *buf)
{
    static const char *const format[] = {"%.4f", "%.0f", "%.6e", "%+.3f", "%.17g", "%g", "%.1f"};
    double size[] = {1e-3, 1, 100, 1e6, 1e15};
    double x = size[clouds_below(5)] * ((double)clouds_below(2000001) / 1e6 - 1);
    return (size_t)sprintf(buf, format[clouds_below(7)], x);
}
