/* cloud_options: units are as cloud_unit knows them, a part of an unlikely size is told. */
#include "stage/cloud_options.h"

#include <stdlib.h>
#include <string.h>

#include "io/cloud/cloud.h"
#include "said.h"

START_TEST(each_word_is_a_unit)
{
    static const double mm[] = {1, 10, 1000, 0.001, 25.4, 25.4};
    char words[] = UNIT_WORDS;
    int n = 0;
    for (char *word = strtok(words, "|"); word; word = strtok(NULL, "|"), n++) {
        ck_assert_str_eq(word, unit_name[n]);
        ck_assert_double_eq(cloud_unit(word), mm[n]);
    }
    ck_assert_int_eq(n, sizeof mm / sizeof *mm);
}
END_TEST

/* From 1 mm to 3 m, both ends with it, nothing is said. */
START_TEST(sizes)
{
    static const struct {
        double longest;
        bool told;
    } row[] = {{0.999, true}, {1, false}, {50, false}, {3000, false}, {3000.1, true}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        said_begin();
        say_unlikely_size("scan.xyz", row[i].longest);
        const char *text = said_end();
        ck_assert_int_eq(strstr(text, "scan.xyz") && strstr(text, "(-u)"), row[i].told);
        ck_assert_int_eq(*text != '\0', row[i].told);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("cloud_options");
    TCase *tests = tcase_create("cloud_options");
    tcase_add_test(tests, each_word_is_a_unit);
    tcase_add_test(tests, sizes);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
