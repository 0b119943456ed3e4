/* svg - what is written adds up to what was meant; texts are escaped; counts are grouped. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "plot/svg.h"

static char written[1 << 20];

/* What `draw` writes. */
static const char *output(void (*draw)(struct svg *svg))
{
    char name[] = "/tmp/check_svg.XXXXXX";
    int fd = mkstemp(name);
    ck_assert_int_ge(fd, 0);
    close(fd);
    struct svg svg = {.out = out_open(name)};
    draw(&svg);
    out_close(svg.out);
    FILE *file = fopen(name, "r");
    ck_assert_ptr_nonnull(file);
    size_t n = fread(written, 1, sizeof written - 1, file);
    written[n] = '\0';
    fclose(file);
    unlink(name);
    return written;
}

static double place(int i, int k)
{
    return 50 * sin(i * 1.7 + k) + 0.03 * i;
}

static void chain(struct svg *svg)
{
    svg_path(svg, "stroke=\"#000\"");
    svg_move(svg, place(0, 0), place(0, 1));
    for (int i = 1; i < 500; i++)
        svg_line(svg, place(i, 0), place(i, 1));
    svg_close(svg);
    svg_move(svg, 7, 8);
    svg_dot(svg, 3, 4);
    svg_path_end(svg);
}

START_TEST(steps_add_up)
{
    const char *p = strstr(output(chain), "d=\"M") + 4;
    long x = 0, y = 0, step[2];
    for (int i = 0; i < 500; i++) {
        for (int k = 0; k < 2; k++) {
            char *end;
            while (*p == 'l' || *p == '\n')
                p++;
            step[k] = strtol(p, &end, 10);
            p = end;
        }
        x += step[0];
        y += step[1];
        ck_assert_int_eq(x, lround(10 * place(i, 0)));
        ck_assert_int_eq(y, lround(10 * place(i, 1)));
    }
    ck_assert(*p == 'z');
    /* behind z the pen is back at the start */
    char want[80];
    long fx = lround(10 * place(0, 0)), fy = lround(10 * place(0, 1));
    snprintf(want, sizeof want, "zm%ld%s%ldm-40 -40h0\"", 70 - fx, 80 - fy < 0 ? "" : " ", 80 - fy);
    char *minus = strstr(want, "-40 -40");
    memmove(minus + 3, minus + 4, strlen(minus + 4) + 1);
    ck_assert_msg(strstr(p, want) == p, "%.60s, not %s", p, want);
}
END_TEST

static void texts(struct svg *svg)
{
    svg_text(svg, 1, 2, "start", 12, false, "a<b> & \"c\" \x01\xC3\xA9 \xFF\xC3");
    svg_text(svg, 1, 2, "end", 12, true, "\xED\xA0\x80|\xEF\xBF\xBF|\xC0\xAF|\xF0\x9F\x98\x80");
}

START_TEST(texts_are_escaped)
{
    const char *s = output(texts);
    ck_assert_ptr_nonnull(strstr(s, ">a&lt;b&gt; &amp; &quot;c&quot; ?\xC3\xA9 ?"
                                    "?</text>"));
    ck_assert_ptr_nonnull(strstr(s, ">?"
                                    "?"
                                    "?|?"
                                    "?"
                                    "?|?"
                                    "?|\xF0\x9F\x98\x80</text>"));
}
END_TEST

START_TEST(counts_are_grouped)
{
    static const struct {
        size_t n;
        const char *text;
    } known[] = {
        {0, "0"}, {999, "999"}, {1000, "1,000"}, {17036, "17,036"}, {1000000, "1,000,000"}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        char text[SVG_COUNT];
        svg_count(text, known[i].n);
        ck_assert_str_eq(text, known[i].text);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("svg");
    TCase *tests = tcase_create("svg");
    tcase_add_test(tests, steps_add_up);
    tcase_add_test(tests, texts_are_escaped);
    tcase_add_test(tests, counts_are_grouped);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
