/*
 * check_template - fields of templates: what each is, where each may stand, and every kind of bad
 * text refused with what was found and what was expected.
 */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "machine/control_text.h"
#include "machine/machine.h"
#include "machine/template.h"
#include "scratch.h"
#include "seed.h"

START_TEST(fields)
{
    struct template_field f;
    ck_assert(template_field("{tool} M6", &f));
    ck_assert_int_eq(f.word, TEMPLATE_TOOL);
    ck_assert_uint_eq(f.length, 6);
    ck_assert_int_eq(f.width, 0);
    ck_assert(template_field("{program:4}", &f));
    ck_assert_int_eq(f.word, TEMPLATE_PROGRAM);
    ck_assert_int_eq(f.width, 4);
    ck_assert_uint_eq(f.length, 11);
    ck_assert(template_field("{?!tcp}G49", &f));
    ck_assert_int_eq(f.condition, WHEN_TCP);
    ck_assert(f.negated);
    ck_assert_int_eq(f.word, TEMPLATE_NONE);
    ck_assert_uint_eq(f.length, 7);
    ck_assert(!template_field("tool}", &f));
    ck_assert(!template_field("{tool", &f));
    ck_assert(!template_field("{too}", &f));
    ck_assert(!template_field("{?tool:4}", &f));
    ck_assert(!template_field("{head:4}", &f)); /* blocks have no width */
    ck_assert(!template_field("", &f));
}
END_TEST

/* Good and bad text: what the message holds, "": it is good. */
static const struct {
    enum template_place place;
    const char *text, *found;
} text_case[] = {
    {TEMPLATE_IN_KEY, "", ""},
    {TEMPLATE_IN_KEY, "T{tool} M6|G43 H{offset:2}", ""},
    {TEMPLATE_IN_KEY, "T{tool:1} H{offset:20}", ""},
    {TEMPLATE_IN_KEY, "{?rotary}G43.4|{?!rotary}G43.5", ""},
    {TEMPLATE_IN_KEY, "} and more }", ""}, /* a closing brace alone is text */
    {TEMPLATE_IN_KEY, "T{tool", "`{tool`, expected } after it"},
    {TEMPLATE_IN_KEY, "T{", "`{`, expected } after it"},
    {TEMPLATE_IN_KEY, "T{tool{offset}", "`{tool{offset}`, expected } after it"},
    {TEMPLATE_IN_KEY, "T{frob} M6", "`{frob}`, expected {tool}"},
    {TEMPLATE_IN_KEY, "T{} M6", "`{}`, expected {tool}"},
    {TEMPLATE_IN_KEY, "{?frob}M6", "`{?frob}`"},
    {TEMPLATE_IN_KEY, "{Tool}", "`{Tool}`"},
    {TEMPLATE_IN_KEY, "{tool:0}", "a width of 1 to 20"},
    {TEMPLATE_IN_KEY, "{tool:21}", "found `{tool:21}`, expected a value with a width of 1 to 20"},
    {TEMPLATE_IN_KEY, "{tool:999999999999999999999}", "a width of 1 to 20"},
    {TEMPLATE_IN_KEY, "{tool:-4}", "a width of 1 to 20"},
    {TEMPLATE_IN_KEY, "{tool:4x}", "a width of 1 to 20"},
    {TEMPLATE_IN_KEY, "{tool:}", "a width of 1 to 20"},
    {TEMPLATE_IN_KEY, "{home}", "`{home}`"}, /* a key holds no key: it could be itself */
    {TEMPLATE_IN_KEY, "{X}", "`{X}`"},
    {TEMPLATE_IN_KEY, "{n}", "`{n}`"},
    {TEMPLATE_IN_SECTION, "{line}%", ""},
    {TEMPLATE_IN_SECTION, "{?tcp}{?!vectors}{tcp.on}", ""},
    {TEMPLATE_IN_SECTION, "G49 {home}", ""},
    {TEMPLATE_IN_SECTION, "{rapid} {X} {Y}", ""},
    {TEMPLATE_IN_SECTION, "M9 {head}", "before {head}, expected that alone"},
    {TEMPLATE_IN_SECTION, "{head} M9", "after {head}, expected that alone"},
    {TEMPLATE_IN_SECTION, "{home}{home}", "after {home}, expected that alone"},
    {TEMPLATE_IN_SECTION, "{text}", "`{text}`, expected a field of cloudmill-control(5)"},
    {TEMPLATE_IN_NUMBER, "N{n:5}", ""},
    {TEMPLATE_IN_NUMBER, "N{tool}", "`{tool}`, expected {n}"},
    {TEMPLATE_IN_NUMBER, "{?tcp}{n}", "`{?tcp}`, expected {n}"},
    {TEMPLATE_IN_COMMENT, "({text})", ""},
    {TEMPLATE_IN_COMMENT, "({n})", "`{n}`, expected {text}"},
};

START_TEST(text)
{
    struct error error = {.text = ""};
    int result = template_check(text_case[_i].text, text_case[_i].place, &error);
    ck_assert_int_eq(result, *text_case[_i].found ? -1 : 0);
    if (*text_case[_i].found)
        ck_assert_msg(strstr(error.text, text_case[_i].found) != NULL, "%s: %s", text_case[_i].text,
                      error.text);
}
END_TEST

static uint64_t state;

static size_t any(size_t n)
{
    state = state * 6364136223846793005u + seed_step();
    return (size_t)(state >> 33) % n;
}

/* Any text: no crash, and what is accepted has fields alone that may stand there. */
START_TEST(any_text)
{
    static const char *const part[] = {"{",      "}",   "{tool}", "{?tcp}", ":",       "4",
                                       "{home}", "{n}", "{text}", "G1",     "|",       "{?!rpm}",
                                       " ",      "{X}", "{line}", "#",      "{tool:3}"};
    struct error error;
    state = 7 + (uint64_t)_i;
    for (int i = 0; i < 20000; i++) {
        char s[200] = "";
        for (size_t k = any(8) + 1; k > 0; k--)
            strcat(s, part[any(sizeof part / sizeof *part)]);
        if (template_check(s, (enum template_place)_i, &error) != 0)
            continue;
        struct template_field f;
        for (const char *c = strchr(s, '{'); c; c = strchr(c + 1, '{')) {
            ck_assert_msg(template_field(c, &f), "%s", s);
            ck_assert(f.word != TEMPLATE_N || _i == TEMPLATE_IN_NUMBER);
            ck_assert(f.word != TEMPLATE_TEXT || _i == TEMPLATE_IN_COMMENT);
            ck_assert(f.word < TEMPLATE_FIRST_WORD || f.word == TEMPLATE_NONE ||
                      _i == TEMPLATE_IN_SECTION);
        }
    }
}
END_TEST

START_TEST(sections)
{
    struct control_text t = {.title = ""};
    struct error error;
    for (int i = 0; i < CONTROL_SECTIONS; i++) {
        char line[40] = "[";
        strcat(strcat(line, control_section_name((enum control_section)i)), "]");
        ck_assert_int_eq(control_section_find(line), i);
    }
    ck_assert_int_eq(control_section_find("[frob]"), CONTROL_SECTIONS);
    ck_assert_int_eq(control_section_find("["), CONTROL_SECTIONS);
    ck_assert_int_eq(control_section_find("[starts]"), CONTROL_SECTIONS);
    ck_assert_int_eq(control_section_add(&t, SECTION_END, "M30", &error), 0);
    ck_assert_int_eq(control_section_add(&t, SECTION_END, "{line}%", &error), 0);
    ck_assert_str_eq(t.section[SECTION_END], "M30\n{line}%\n");
    int lines = 2;
    while (control_section_add(&t, SECTION_END, "G4 X1.", &error) == 0)
        lines++;
    ck_assert_int_gt(lines, 250); /* full: refused, not overrun */
    ck_assert_ptr_ne(strstr(error.text, "[end]"), NULL);
    ck_assert_uint_lt(strlen(t.section[SECTION_END]), CONTROL_SECTION_SIZE);
}
END_TEST

/* A control file with something wrong in it: the line that the message names, and what it says. */
static const struct {
    const char *text;
    int line;
    const char *found;
} file_case[] = {
    {"base = fanuc\nhome = {frob}\n", 2, "{frob}"},
    {"base = fanuc\n\n[start]\n%\n{tool\n", 5, "expected } after it"},
    {"base = fanuc\n[frob]\n", 2, "[start], [tool]"},
    {"base = fanuc\n[end]\nM30\n[end]\nM2\n", 4, "again"},
    {"base = nosuchcontrol\n", 1, "not found"},
    {"base =\n", 1, "base = NAME"},
    {"base = fanuc\nfrob = 1\n", 2, "frob"},
    {"base = fanuc\ncomment = {text\n", 2, "} after it"},
    {"base = fanuc\nnumber = N\n", 2, "{n} in it"},
    {"base = fanuc\ncomment.width = 7\n", 2, "40 to 132"},
    {"base = fanuc\npoint = perhaps\n", 2, "no|yes"},
    {"base = fanuc\n[end]\nM\001\n", 3, "binary"},
    {"title = none\n", -1, "no base"},
};

START_TEST(bad_files)
{
    struct machine m = machine_default();
    struct error error = {.text = ""};
    const char *file = scratch_text(file_case[_i].text);
    int result = machine_control(&m, file, &error);
    if (file_case[_i].line == 0) {
        ck_assert_int_eq(result, 0);
        return;
    }
    char place[500];
    ck_assert_int_eq(result, -1);
    if (file_case[_i].line > 0)
        snprintf(place, sizeof place, "%s:%d: ", file, file_case[_i].line);
    else
        snprintf(place, sizeof place, "%s: ", file);
    ck_assert_msg(strncmp(error.text, place, strlen(place)) == 0, "%s", error.text);
    ck_assert_msg(strstr(error.text, file_case[_i].found) != NULL, "%s", error.text);
}
END_TEST

/* A file that names itself as its base ends with an error, not without end. */
START_TEST(base_of_itself)
{
    struct machine m = machine_default();
    struct error error = {.text = ""};
    char own[500];
    const char *file = scratch_text("base = fanuc\n");
    snprintf(own, sizeof own, "base = %s\n", file);
    ck_assert_str_eq(scratch_text(own), file);
    ck_assert_int_eq(machine_control(&m, file, &error), -1);
    ck_assert_msg(strstr(error.text, "no file to include itself") != NULL, "%s", error.text);
}
END_TEST

/* Keys of the control are defaults; sections replace those of the base, and no others. */
START_TEST(layers)
{
    struct machine m = machine_default(), fanuc = machine_default();
    struct error error = {.text = ""};
    const char *file = scratch_text("base = fanuc\ntitle = Own\nsplines = no\n[end]\nM2 # last\n");
    ck_assert_int_eq(machine_control(&fanuc, "fanuc", &error), 0);
    ck_assert_msg(machine_control(&m, file, &error) == 0, "%s", error.text);
    ck_assert_str_eq(m.text.title, "Own");
    ck_assert_int_eq(m.text.dialect, CONTROL_fanuc);
    ck_assert(!m.splines && fanuc.splines);
    ck_assert_str_eq(m.text.section[SECTION_END], "M2\n");
    ck_assert_str_eq(m.text.section[SECTION_START], fanuc.text.section[SECTION_START]);
    ck_assert_str_eq(m.blocks.home, fanuc.blocks.home);
    for (int i = 0; i < CONTROL_SECTIONS; i++)
        ck_assert_int_ne(*fanuc.text.section[i], '\0');
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("template");
    TCase *tcase = tcase_create("template");
    tcase_add_test(tcase, fields);
    tcase_add_loop_test(tcase, text, 0, (int)(sizeof text_case / sizeof *text_case));
    tcase_add_loop_test(tcase, any_text, 0, TEMPLATE_IN_COMMENT + 1);
    tcase_add_test(tcase, sections);
    tcase_add_loop_test(tcase, bad_files, 0, (int)(sizeof file_case / sizeof *file_case));
    tcase_add_test(tcase, base_of_itself);
    tcase_add_test(tcase, layers);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
