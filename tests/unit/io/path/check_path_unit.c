/* path_unit: inches, where nothing but the feeds says so. */
#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/path/path.h"
#include "math/elementary.h"
#include "scratch.h"

/* Without UNITS a path is in inches where its feeds are, whatever the words are written like and
 * wherever its first feed is; in both: refused. */
START_TEST(a_unit_that_is_not_said)
{
    static const struct {
        const char *feed;
        double x; /* of GOTO/1,0,0, mm; 0: refused */
    } cases[] = {{"FEDRAT/10,IPM", 25.4},
                 {"fedrat/ipm,10", 25.4},
                 {"FEDRAT/.1,IPR", 25.4},
                 {"CYCLE/DRILL,.5,IPM,10,.1", 25.4},
                 {"FEDRAT/10,MMPM", 1},
                 {"FEDRAT/10", 1},
                 {"PPRINT IPM", 1},
                 {"PPRINT FEDRATE IPM", 1},
                 {"PPRINT FEDRAT XIPM IPM2", 1},
                 {"$$ UNITS/MM\nFEDRAT/10,IPM", 1},
                 {"$$ UNIT=MM\nFEDRAT/10,IPM", 1},
                 {"$$ UNITSX UNI\nFEDRAT/10,IPM", 25.4},
                 {"PPRINT FEDRA IPM", 1},
                 {"FEDRAT/10,IPM\nFEDRAT/10,MMPM", 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        for (int far = 0; far < 2; far++) { /* at once, and 20 kB behind the start */
            struct path path;
            struct error error = {.text = ""};
            static char text[30000];
            size_t n = 0;
            for (int k = 0; k < 800 * far; k++)
                n += (size_t)sprintf(text + n, "$$ a remark, number %d\n", k);
            sprintf(text + n, "SPINDL/1000,RPM\n%s\nGOTO/1,0,0\nFINI\n", cases[i].feed);
            int result = path_read(scratch_text(text), &path, &error);
            ck_assert_msg((result < 0) == (cases[i].x == 0), "%zu: %s", i, error.text);
            if (result < 0) {
                ck_assert_ptr_nonnull(strstr(error.text, "feeds in inches and in mm"));
                continue;
            }
            double x = path.item.item[path.item.n - 1].to.p.x;
            ck_assert_msg(fabs(x - cases[i].x) < 1e-9, "%s: %g", cases[i].feed, x);
            ck_assert_int_eq(path.inches_taken, cases[i].x > 1);
            path_free(&path);
        }
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("path_unit");
    TCase *tests = tcase_create("path_unit");
    tcase_add_test(tests, a_unit_that_is_not_said);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
