/* keys: each kind of value is taken as it is written, and what is none is told with its place. */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "machine/keys.h"
#include "math/vec.h"

static struct {
    double number;
    int count, choice;
    bool yes;
    char text[8];
    struct vec3 vector;
} value;

static struct keys table(void)
{
    struct keys keys = {0};
    struct key *key = keys_add(&keys, "number", KEY_NUMBER, &value.number);
    key->min = -2, key->max = 5;
    keys_add(&keys, "free", KEY_NUMBER, &value.number);
    key = keys_add(&keys, "count", KEY_COUNT, &value.count);
    key->min = 1, key->max = 9;
    keys_add(&keys, "yes", KEY_YES, &value.yes);
    keys_add(&keys, "vector", KEY_VECTOR, &value.vector);
    key = keys_add(&keys, "text", KEY_TEXT, value.text);
    key->size = sizeof value.text;
    key = keys_add(&keys, "choice", KEY_CHOICE, &value.choice);
    key->words = "one|two|three";
    return keys;
}

/* What keys_set says of a line in a table of its own. */
static int set(const char *text, struct error *error)
{
    struct keys keys = table();
    char line[200];
    strcpy(line, text);
    int status = keys_set(&keys, line, "m.txt", 7, error);
    array_free(&keys);
    return status;
}

static void expect(const char *text)
{
    struct error error;
    ck_assert_msg(set(text, &error) == 0, "%s: %s", text, error.text);
}

static void refuse(const char *text, const char *says)
{
    struct error error;
    ck_assert_msg(set(text, &error) == -1, "%s", text);
    ck_assert_msg(strncmp(error.text, "m.txt:7: ", 9) == 0, "%s", error.text);
    ck_assert_msg(strstr(error.text, says) != NULL, "%s: %s", text, error.text);
}

START_TEST(kinds)
{
    expect("number = -2");
    ck_assert_double_eq(value.number, -2);
    expect("  number=5 \t# the largest\r");
    ck_assert_double_eq(value.number, 5);
    expect("free = -1e7");
    ck_assert_double_eq(value.number, -1e7);
    expect("count = 9");
    ck_assert_int_eq(value.count, 9);
    expect("yes = yes");
    ck_assert(value.yes);
    expect("yes = no");
    ck_assert(!value.yes);
    expect("vector = 1  -2.5\t3");
    ck_assert(value.vector.x == 1 && value.vector.y == -2.5 && value.vector.z == 3);
    expect("text = 7 signs");
    ck_assert_str_eq(value.text, "7 signs");
    static const char *const words[] = {"choice = one", "choice = two", "choice = three"};
    for (int i = 0; i < 3; i++) {
        expect(words[i]);
        ck_assert_int_eq(value.choice, i);
    }
}
END_TEST

START_TEST(refused)
{
    refuse("number = 5.001", "expected -2 to 5");
    refuse("number = nan", "number: found `nan`");
    refuse("number = 1 2", "expected a number");
    refuse("free = inf", "free: found `inf`");
    refuse("count = 2.5", "expected a whole number");
    refuse("count = 0", "expected 1 to 9");
    refuse("yes = y", "expected no|yes");
    refuse("vector = 1 2", "expected three numbers");
    refuse("vector = 1 2 3 4", "expected three numbers");
    refuse("vector = 1 2 3x", "expected three numbers");
    refuse("vector = 1 inf 3", "expected three numbers");
    refuse("text = 8 signs!", "expected fewer than 8");
    refuse("choice = on", "expected one|two|three");
    refuse("choice = onetwo", "expected one|two|three");
    refuse("other = 1", "found `other`");
    refuse("number", "expected key = value");
    refuse(" = 1", "no key before");
    refuse("number = # 1", "no value of number");
}
END_TEST

/* A file may say a key once; the command line may say it again. */
START_TEST(twice)
{
    struct keys keys = table();
    struct error error = {0};
    char first[] = "number = 1", again[] = "number = 2", by_hand[] = "number = 3";
    ck_assert_int_eq(keys_set(&keys, first, "m.txt", 3, &error), 0);
    ck_assert_int_eq(keys_set(&keys, again, "m.txt", 9, &error), -1);
    ck_assert_str_eq(error.text, "m.txt:9: found number again, expected it once (line 3)");
    ck_assert_double_eq(value.number, 1);
    ck_assert_int_eq(keys_set(&keys, by_hand, "--set", 0, &error), 0);
    ck_assert_double_eq(value.number, 3);
    ck_assert_ptr_null(keys_find(&keys, "numbe"));
    ck_assert_ptr_eq(keys_find(&keys, "number")->value, &value.number);
    array_free(&keys);
}
END_TEST

START_TEST(hash)
{
    char line[] = " \tG5 # of \t";
    ck_assert_str_eq(keys_trim(line), "G5");
    char nothing[] = " # all of it";
    ck_assert_str_eq(keys_trim(nothing), "");
    ck_assert(keys_hash_meant("start = #500=1"));
    ck_assert(keys_hash_meant("start = G1 X#[1+2]"));
    ck_assert(!keys_hash_meant("start = G1 # 500"));
    ck_assert(!keys_hash_meant("start = G1"));
    ck_assert(!keys_hash_meant("start = #"));
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("keys");
    TCase *tests = tcase_create("keys");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, kinds);
    tcase_add_test(tests, refused);
    tcase_add_test(tests, twice);
    tcase_add_test(tests, hash);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
