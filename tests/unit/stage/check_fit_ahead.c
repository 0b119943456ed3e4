/* fit_ahead: what is fitted while a path is read, what is left for its end, and that both together
 * are what one fit of the whole path is. */
#include "stage/fit_ahead.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "said.h"

enum { PASSES = 5, POINTS = 11 };

static struct fitter_options options;
static struct fitter fitter;
static size_t prepared, fits;
static double work;

static int prepare(void *settings, struct path *in, struct error *error)
{
    (void)settings;
    prepared++;
    return in->head.cutter_n > 2 ? error_at(error, in->name, 0, "found no such thing") : 0;
}

static void fit(const void *settings, const struct fit_request *request, struct run *points,
                struct fitted_run *run)
{
    (void)settings;
    ck_assert_uint_eq(points->n, POINTS);
    ck_assert_double_eq(points->item[0].tip.y, (double)run->pass); /* its own points */
    path_add_point(&run->fitted, request->in->item.item[run->to - 1].to, false);
    *(double *)run->result = (double)run->pass;
    work = request->work;
    fits++;
}

static void setup(void)
{
    prepared = fits = 0;
    options = fitter_defaults(0.01);
    fitter = (struct fitter){.name = "tested",
                             .options = &options,
                             .prepare = prepare,
                             .fit = fit,
                             .result_size = sizeof(double)};
}

static struct path path_with(size_t runs)
{
    struct path path = {.name = "path"};
    path.head.cutter[0] = 8;
    path.head.cutter[1] = 4;
    path.head.cutter_n = 2;
    path.head.runs = (struct path_runs){runs, 800};
    return path;
}

/* A pass of touching points at y = its number, that the listener hears of before. */
static void add_pass(struct path *path, size_t pass, const struct path_listener *listener)
{
    if (listener)
        listener->pass(listener->context, path);
    path_add_pass(path, pass);
    for (int i = 0; i < POINTS; i++) {
        struct pose at = {vec(i, (double)pass, 0), vec(0, 0, 1)};
        struct contact contact = {at.p, at.a};
        path_set_contact(path, path_add_point(path, at, false), contact);
    }
}

static void check_all(const struct fitted_runs *runs)
{
    ck_assert_uint_eq(runs->n, PASSES);
    for (size_t k = 0; k < PASSES; k++) {
        const struct fitted_run *run = &runs->item[k];
        ck_assert_uint_eq(run->pass, k + 1);
        ck_assert_uint_eq(run->from, k * (POINTS + 1) + 1);
        ck_assert_uint_eq(run->to, (k + 1) * (POINTS + 1));
        ck_assert_double_eq(*(double *)run->result, (double)(k + 1));
        ck_assert_uint_eq(run->fitted.item.n, 1);
    }
}

static void end(struct fit_ahead *ahead, struct path *path)
{
    struct gouge_refit_options gouge;
    struct fitted_runs runs;
    struct error error;
    struct range all = {0, path->item.n};
    ck_assert_int_eq(fit_ahead_rest(ahead, path, all, &gouge, &runs, &error), 0);
    check_all(&runs);
    ck_assert_uint_eq(fits, PASSES);
    for (size_t k = 0; k < runs.n; k++)
        fitted_run_free(&fitter, &runs.item[k]);
    array_free(&runs);
    gouge_refit_free(&gouge);
    fit_ahead_free(ahead);
    path_free(path);
}

/* With one thread each pass is fitted when the next begins; with more no later than at the end. */
START_TEST(while_it_is_read)
{
    for (int threads = 1; threads < 4; threads++) {
        setup();
        struct fit_ahead *ahead = fit_ahead_new(&fitter, threads);
        struct path_listener listener = fit_ahead_listener(ahead);
        struct path path = path_with(24000);
        for (size_t k = 1; k <= PASSES; k++) {
            add_pass(&path, k, &listener);
            ck_assert(fit_ahead_began(ahead));
            if (threads == 1)
                ck_assert_uint_eq(fits, k - 1);
        }
        end(ahead, &path);
        ck_assert_uint_eq(prepared, 1);
        ck_assert_double_eq(work, 0.5); /* as the head says, not by the 55 points */
    }
}
END_TEST

/* Without RUNS, of a part, or where the fitter changes the path: at the end, as the path is then.
 */
START_TEST(at_its_end)
{
    for (int why = 0; why < 4; why++) {
        setup();
        fitter.whole = why == 1;
        options.part_text = why == 2 ? "1/1" : NULL;
        struct fit_ahead *ahead = fit_ahead_new(&fitter, 1);
        struct path_listener listener = fit_ahead_listener(ahead);
        struct path path = path_with(why == 0 ? 0 : 24000);
        path.head.track = why == 3 ? TRACK_CONTACT : TRACK_TIP;
        for (size_t k = 1; k <= PASSES; k++)
            add_pass(&path, k, &listener);
        ck_assert(!fit_ahead_began(ahead));
        ck_assert_uint_eq(fits, 0);
        if (why == 3)
            path.head.track = TRACK_TIP;
        end(ahead, &path);
        ck_assert_double_eq(work, why == 0 ? 1 : 0.5);
    }
}
END_TEST

/* What the fitter refuses is left to whoever reads the whole path; a scan that is not there is told
 * at the end; and what was begun may be given up. */
START_TEST(errors)
{
    for (int threads = 1; threads < 3; threads++) {
        setup();
        struct path path = path_with(24000);
        path.head.cutter_n = 3;
        struct fit_ahead *ahead = fit_ahead_new(&fitter, threads);
        struct path_listener listener = fit_ahead_listener(ahead);
        add_pass(&path, 1, &listener);
        add_pass(&path, 2, &listener);
        ck_assert(!fit_ahead_began(ahead));
        fit_ahead_free(ahead);

        path.head.cutter_n = 2;
        ahead = fit_ahead_new(&fitter, threads);
        listener = fit_ahead_listener(ahead);
        add_pass(&path, 3, &listener);
        fit_ahead_free(ahead);

        char *file = mem_string("/nowhere/at/all", strlen("/nowhere/at/all"));
        *array_push(&options.gouge.scan.files) = file;
        ahead = fit_ahead_new(&fitter, threads);
        listener = fit_ahead_listener(ahead);
        add_pass(&path, 4, &listener);
        struct gouge_refit_options gouge;
        struct fitted_runs runs;
        struct error error;
        struct range all = {0, path.item.n};
        said_begin();
        ck_assert_int_eq(fit_ahead_rest(ahead, &path, all, &gouge, &runs, &error), -1);
        said_end();
        ck_assert_ptr_nonnull(strstr(error.text, "/nowhere/at/all"));
        fit_ahead_free(ahead);
        array_free(&options.gouge.scan.files);
        free(file);
        path_free(&path);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("fit_ahead");
    TCase *tests = tcase_create("fit_ahead");
    SRunner *runner = srunner_create(suite);
    tcase_add_test(tests, while_it_is_read);
    tcase_add_test(tests, at_its_end);
    tcase_add_test(tests, errors);
    suite_add_tcase(suite, tests);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
