/* stream - kinds of streams by their first bytes. */
#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "plot/stream.h"

static const struct {
    const char *head;
    enum stream_kind kind;
} known[] = {
    {"1 2 3\n4 5 6\n", STREAM_CLOUD},
    {"X Y Z\n1 2 3\n", STREAM_CLOUD},
    {"# scan\n1 2 3\n", STREAM_CLOUD},
    {"// scan\n1,2,3\n", STREAM_CLOUD},
    {"v 1 2 3\nv 2 3 4\n", STREAM_CLOUD},
    {"17036\n1 2 3\n", STREAM_CLOUD},
    {"", STREAM_CLOUD},
    {"ply\nformat ascii 1.0\nelement vertex 3\nend_header\n", STREAM_CLOUD},
    {"ply\nformat ascii 1.0\nelement vertex 3\nelement face 0\nend_header\n", STREAM_CLOUD},
    {"ply\nformat ascii 1.0\nelement vertex 3\nelement face 1\nend_header\n", STREAM_MESH},
    {"solid part\nfacet normal 0 0 1\n", STREAM_MESH},
    {"SOLID PART\r\nFACET NORMAL 0 0 1\r\n", STREAM_MESH},
    {"OFF\n3 1 0\n", STREAM_MESH},
    {"PARTNO/PANEL\nUNITS/MM\n", STREAM_PATH},
    {"$$* Pro/CLfile\n", STREAM_PATH},
    {"\r\nUNITS / MM\r\n", STREAM_PATH},
    {"TOOL PATH/A,TOOL,B\n", STREAM_PATH},
    {"GOTO/1,2,3\n", STREAM_PATH},
    {"%\nO0001 (PART)\n", STREAM_PROGRAM},
    {"; made by\nN10 G17 G90\n", STREAM_PROGRAM},
    {"(made by)\nG21\n", STREAM_PROGRAM},
    {"0 BEGIN PGM PART MM\n", STREAM_PROGRAM},
};

START_TEST(each_is_told)
{
    const char *head = known[_i].head;
    ck_assert_msg(stream_tell(head, strlen(head)) == known[_i].kind, "%.20s", head);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("stream");
    TCase *tests = tcase_create("stream");
    tcase_add_loop_test(tests, each_is_told, 0, (int)(sizeof known / sizeof *known));
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
