/* fitter: which items a fitter is given, what goes over as it is, what is fitted again in parts and
 * stays, and the ledger: with a fitter of lines that does what it is told. */
#include "stage/fitter.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "said.h"
#include "scratch.h"

static const double R = 4;

/* What the fitter was asked for, in the order of the runs (one thread). */
struct asked {
    size_t from, to, points;
    bool link, rough;
    double axis_share, work;
};

static struct {
    struct fitter_options options;
    struct {
        size_t n, cap;
        struct asked *item;
    } asked;
    double deep_x; /* motions over this x are too deep, NAN: none */
    int deep_part; /* by this part of the tool ... */
    double share;  /* ... until the axis tolerance is no more than this share */
    double spends; /* times the number of the pass */
    size_t reported, freed;
    bool refuse;
} told;

struct result {
    double spent;
    size_t *held;
};

static int prepare(void *settings, struct path *in, struct error *error)
{
    ck_assert_ptr_eq(settings, &told);
    return told.refuse ? error_at(error, in->name, 0, "found no such thing") : 0;
}

/* From the run's first point to its last in one line. */
static void fit(const void *settings, const struct fit_request *request, struct run *points,
                struct fitted_run *run)
{
    struct result *result = run->result;
    (void)settings;
    ck_assert_double_eq(result->spent, 0);
    ck_assert_ptr_null(result->held);
    *array_push(&told.asked) = (struct asked){
        run->from, run->to, points->n, run->link, run->rough, request->axis_share, request->work};
    const struct path_item *last = &request->in->item.item[run->to - 1];
    path_add_point(&run->fitted, last->to, false);
    *result = (struct result){told.spends * (double)run->pass, malloc(8)};
    run->swept = true;
    for (size_t i = 1; i < points->n; i++) {
        double a = points->item[i - 1].ball.x, b = points->item[i].ball.x;
        if ((a - told.deep_x) * (b - told.deep_x) > 0 || !(fabs(told.deep_x) < 1e9) ||
            request->axis_share <= told.share)
            continue;
        struct vec3 at = vec_along(points->item[i - 1].ball, (told.deep_x - a) / (b - a),
                                   vec_sub(points->item[i].ball, points->item[i - 1].ball));
        struct gouge gouge = {at, 0.5, (enum tool_part)told.deep_part};
        *array_push(&run->gouge.left) = gouge;
        run->gouge.deepest = gouge;
    }
}

static void result_free(void *result)
{
    free(((struct result *)result)->held);
    told.freed++;
}

static void report(const void *settings, const struct path *in, const struct fitted_runs *runs,
                   struct unmets *unmet)
{
    (void)settings;
    (void)in;
    told.reported = runs->n;
    for (size_t i = 0; i < runs->n; i++)
        if (runs->item[i].gouge.deepest.depth > 0)
            unmet_say(unmet, "deep");
}

static double spent(const void *result)
{
    return ((const struct result *)result)->spent;
}

static struct fitter fitter;

static void setup(void)
{
    memset(&told, 0, sizeof told);
    told.options = fitter_defaults(0.01);
    told.deep_x = NAN;
    fitter = (struct fitter){.name = "tested",
                             .options = &told.options,
                             .settings = &told,
                             .prepare = prepare,
                             .fit = fit,
                             .report = report,
                             .spent = spent,
                             .result_size = sizeof(struct result),
                             .result_free = result_free};
}

static void teardown(void)
{
    array_free(&told.asked);
}

static char *put(char *to, double x, double y, double z, bool touches)
{
    if (touches)
        to += sprintf(to, "$$-> CONTCT/%g,%g,%g,0,0,1\n", x, y, z);
    return to + sprintf(to, "GOTO/%.6f,%.6f,%.6f,0,0,1\n", x, y, z);
}

/* Passes 1 and 2 of eleven points 1 mm apart along x, at y 0 and 2, with a rapid before each and a
 * statement between; without contacts a run is what is at feed. */
static const char *two_passes(void)
{
    static char name[300];
    char *text = malloc(9000), *to = text;
    to += sprintf(to,
                  "UNITS/MM\nMULTAX/ON\nCUTTER/%g,%g\n$$-> CHORD/0.003\n$$-> LEDGER/first,0.005\n",
                  2 * R, R);
    for (int pass = 1; pass <= 2; pass++) {
        to += sprintf(to, "$$-> PASS/%d\nRAPID\n", pass);
        to = put(to, 0, 2 * pass - 2, 20, false);
        to += sprintf(to, "FEDRAT/600,MMPM\n");
        for (int i = 0; i <= 10; i++)
            to = put(to, i, 2 * pass - 2, 0, false);
        to += sprintf(to, pass == 1 ? "COOLNT/ON\n" : "FINI\n");
    }
    snprintf(name, sizeof name, "%s", scratch_text(text));
    free(text);
    return name;
}

/* Runs the fitter on a file; what was written is read back. */
static int fitted(const char *file, struct path *out, struct error *error)
{
    char name[320];
    snprintf(name, sizeof name, "%s.fitted", file);
    const char *files[] = {file};
    struct cli cli = {.tool = "tested", .threads = 1, .output = name};
    cli.file = (char **)files;
    cli.files = 1;
    said_begin();
    int status = fitter_run(&fitter, &cli, error);
    said_end();
    *out = (struct path){.name = ""};
    if (status >= 0) {
        ck_assert_int_eq(path_read(name, out, error), 0);
        remove(name);
    }
    return status;
}

static size_t points_of(const struct path *path)
{
    size_t n = 0;
    for (size_t i = 0; i < path->item.n; i++)
        n += path->item.item[i].kind == PATH_POINT;
    return n;
}

START_TEST(runs_and_what_is_between)
{
    struct path out;
    struct error error;
    told.spends = 0.001;
    ck_assert_int_eq(fitted(two_passes(), &out, &error), 0);
    ck_assert_uint_eq(told.asked.n, 2);
    ck_assert_uint_eq(told.reported, 2);
    ck_assert_uint_eq(told.freed, 2);
    for (size_t k = 0; k < 2; k++) {
        ck_assert_uint_eq(told.asked.item[k].points, 11);
        ck_assert_uint_eq(told.asked.item[k].to - told.asked.item[k].from, 11);
        ck_assert(!told.asked.item[k].link);
        ck_assert_double_eq(told.asked.item[k].axis_share, 1);
        ck_assert_double_eq(told.asked.item[k].work, 1);
    }
    /* the first point of a run stays, the others are one line; rapids, feeds and words stay */
    static const enum path_kind kinds[] = {PATH_PASS,  PATH_POINT, PATH_FEED, PATH_POINT,
                                           PATH_POINT, PATH_TEXT,  PATH_PASS, PATH_POINT,
                                           PATH_FEED,  PATH_POINT, PATH_POINT};
    size_t n = sizeof kinds / sizeof *kinds, at = 0;
    for (size_t i = 0; i < out.item.n; i++) {
        const struct path_item *item = &out.item.item[i];
        if (item->kind == PATH_FEED && i > 0 && out.item.item[i - 1].kind == PATH_FEED)
            continue;
        ck_assert_uint_lt(at, n);
        ck_assert_int_eq(item->kind, kinds[at]);
        if (at == 4 || at == 10)
            ck_assert_double_lt(vec_distance(item->to.p, vec(10, at == 4 ? 0 : 2, 0)), 1e-9);
        if (at == 3 || at == 9)
            ck_assert_double_lt(vec_distance(item->to.p, vec(0, at == 3 ? 0 : 2, 0)), 1e-9);
        at++;
    }
    ck_assert_uint_eq(at, n);
    /* 0.005 before, and the worse of the passes' 0.001 and 0.002; the chord is the fitter's now */
    ck_assert_double_eq_tol(path_spent(&out), 0.005 + 0.002, 1e-9);
    ck_assert(!(out.head.chord >= 0));
    path_free(&out);
}
END_TEST

/* Half of a path is its pass, and both halves together the whole. */
START_TEST(in_parts_of_the_path)
{
    size_t points = 0;
    for (long k = 1; k <= 2; k++) {
        struct error error;
        told.asked.n = told.freed = 0;
        told.options.part = (struct path_part){k, 2};
        const char *files[] = {two_passes()};
        char name[320];
        snprintf(name, sizeof name, "%s.fitted", files[0]);
        struct cli cli = {.tool = "tested", .threads = 1, .output = name};
        cli.file = (char **)files;
        cli.files = 1;
        ck_assert_int_eq(fitter_run(&fitter, &cli, &error), 0);
        ck_assert_uint_eq(told.asked.n, 1);
        ck_assert_uint_eq(told.freed, 1);
        FILE *f = fopen(name, "r");
        ck_assert_ptr_nonnull(f);
        char line[200];
        while (fgets(line, sizeof line, f)) {
            points += strncmp(line, "GOTO", 4) == 0;
            if (strncmp(line, "CUTTER", 6) == 0)
                ck_assert_int_eq(k, 1);
            if (strncmp(line, "FINI", 4) == 0)
                ck_assert_int_eq(k, 2);
        }
        fclose(f);
        remove(name);
    }
    ck_assert_uint_eq(points, 2 * 3);
}
END_TEST

/* Where the ball stays too deep the motion there stays as it came, with more of its neighbours each
 * time, and the rest is fitted; the result of what is given up is freed. */
START_TEST(too_deep_stays)
{
    struct path out;
    struct error error;
    told.deep_x = 4.5;
    told.deep_part = TOOL_BALL;
    ck_assert_int_eq(fitted(two_passes(), &out, &error), 0);
    /* of each pass: the whole, then 0 to 3 and 6 to 10: the motion and one more to both sides */
    static const size_t want[][2] = {{0, 11}, {0, 4}, {6, 11}};
    ck_assert_uint_eq(told.asked.n, 6);
    size_t first = told.asked.item[0].from;
    for (size_t k = 0; k < 3; k++) {
        ck_assert_uint_eq(told.asked.item[k].from - first, want[k][0]);
        ck_assert_uint_eq(told.asked.item[k].to - first, want[k][1]);
    }
    ck_assert_uint_eq(told.freed, 6);
    ck_assert_uint_eq(told.reported, 4);
    /* rapid, 0, 3, 4, 5, 6, 10 */
    ck_assert_uint_eq(points_of(&out), 2 * 7);
    path_free(&out);
    /* as published: it is told */
    told.options.paper = true;
    told.asked.n = 0;
    ck_assert_int_eq(fitted(two_passes(), &out, &error), EXIT_UNMET);
    ck_assert_uint_eq(told.asked.n, 2);
    ck_assert_uint_eq(points_of(&out), 2 * 3);
    ck_assert_uint_ge(out.head.unmet.n, 1);
    path_free(&out);
}
END_TEST

/* Where only what is above the ball is too deep the whole is fitted again, with 0.3 of the axis
 * tolerance, then with 0.09; then in parts. */
START_TEST(too_deep_by_the_axis)
{
    struct path out;
    struct error error;
    told.deep_x = 4.5;
    told.deep_part = TOOL_SHAFT;
    told.share = 0.1;
    ck_assert_int_eq(fitted(two_passes(), &out, &error), 0);
    ck_assert_uint_eq(told.asked.n, 6);
    for (size_t k = 0; k < 6; k++) {
        static const double share[] = {1, 0.3, 0.09};
        ck_assert_double_eq_tol(told.asked.item[k].axis_share, share[k % 3], 1e-12);
        ck_assert_uint_eq(told.asked.item[k].points, 11);
    }
    ck_assert_uint_eq(told.freed, 6);
    ck_assert_uint_eq(points_of(&out), 2 * 3);
    path_free(&out);
    told.share = 0;
    told.asked.n = 0;
    ck_assert_int_eq(fitted(two_passes(), &out, &error), 0);
    ck_assert_uint_eq(told.asked.item[3].points, 4); /* never clear: in parts */
    ck_assert_uint_eq(points_of(&out), 2 * 7);
    path_free(&out);
}
END_TEST

/* Where the axis turns and the tip stands nothing is fitted. */
START_TEST(a_standing_turn_stays)
{
    char text[3000], *to = text;
    struct path out;
    struct error error;
    to += sprintf(to, "UNITS/MM\nMULTAX/ON\nCUTTER/8,4\n");
    for (int i = 0; i <= 5; i++)
        to = put(to, i, 0, 0, false);
    /* 0.02 mm for 0.1 radians: less than 0.3 mm for one */
    to += sprintf(to, "GOTO/5.02,0,0,0.0998334166,0,0.995004165\n");
    for (int i = 6; i <= 9; i++)
        to += sprintf(to, "GOTO/%d,0,0,0.0998334166,0,0.995004165\n", i);
    sprintf(to, "FINI\n");
    char name[300];
    snprintf(name, sizeof name, "%s", scratch_text(text));
    ck_assert_int_eq(fitted(name, &out, &error), 0);
    ck_assert_uint_eq(told.asked.n, 2);
    ck_assert_uint_eq(told.asked.item[0].points, 6);
    ck_assert_uint_eq(told.asked.item[1].points, 5);
    ck_assert_uint_eq(points_of(&out), 4); /* 0, 5, 5.02, 9 */
    path_free(&out);
    told.asked.n = 0;
    told.options.paper = true;
    ck_assert_int_eq(fitted(name, &out, &error), 0);
    ck_assert_uint_eq(told.asked.n, 1);
    path_free(&out);
}
END_TEST

/* A pass of eleven points at y 0, n points round in a half circle of radius 2, that touch nothing,
 * and a pass at y 4 back. */
static const char *with_link(int n)
{
    static char name[300];
    char *text = malloc(9000), *to = text;
    to += sprintf(to, "UNITS/MM\nMULTAX/ON\nCUTTER/8,4\n$$-> PASS/1\nFEDRAT/600,MMPM\n");
    for (int i = 0; i <= 10; i++)
        to = put(to, i, 0, 0, true);
    for (int i = 1; i <= n; i++)
        to = put(to, 10 + 2 * sin(PI * i / (n + 1)), 2 - 2 * cos(PI * i / (n + 1)), 0, false);
    to += sprintf(to, "$$-> PASS/2\n");
    for (int i = 0; i <= 10; i++)
        to = put(to, 10 - i, 4, 0, true);
    sprintf(to, "FINI\n");
    snprintf(name, sizeof name, "%s", scratch_text(text));
    free(text);
    return name;
}

/* Ways with the tool down are runs of their own where a scan guards and they have points enough.
 * They are rough where they are not smooth: straight lines between their points further off a curve
 * than ten tolerances, which is 2 (1 - cos 22.5 degrees) = 0.15 mm with three, and 0.049 with six,
 * which turn by 26 degrees: then it may be thirty.  They begin at the point before. */
START_TEST(links)
{
    static const struct {
        int n;
        double tolerance;
        bool stay, paper, guarded;
        size_t runs;
        bool rough;
    } row[] = {{8, 0.02, false, false, true, 3, false},  {3, 0.02, false, false, true, 3, false},
               {2, 0.1, false, false, true, 2, false},   {3, 0.01, false, false, true, 3, true},
               {6, 0.003, false, false, true, 3, false}, {6, 0.001, false, false, true, 3, true},
               {8, 0.02, true, false, true, 2, false},   {8, 0.02, false, true, true, 2, false},
               {8, 0.02, false, false, false, 2, false}};
    char scan[400];
    snprintf(scan, sizeof scan, "%s.scan", scratch_name());
    FILE *f = fopen(scan, "w");
    ck_assert_ptr_nonnull(f);
    for (int i = -4; i <= 24; i++)
        for (int k = -4; k <= 12; k++)
            fprintf(f, "%g %g 0\n", 0.5 * i, 0.5 * k);
    fclose(f);
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        struct path out;
        struct error error;
        told.asked.n = 0;
        told.options.tolerance = row[k].tolerance;
        told.options.links_stay = row[k].stay;
        told.options.paper = row[k].paper;
        told.options.gouge.noise = 0;
        told.options.gouge.scan.files.n = 0;
        if (row[k].guarded)
            *array_push(&told.options.gouge.scan.files) = scan;
        ck_assert_int_ge(fitted(with_link(row[k].n), &out, &error), 0);
        ck_assert_uint_eq(told.asked.n, row[k].runs);
        for (size_t i = 0; i < told.asked.n; i++) {
            const struct asked *a = &told.asked.item[i];
            ck_assert_int_eq(a->link, row[k].runs == 3 && i == 1);
            ck_assert_int_eq(a->rough, a->link && row[k].rough);
            ck_assert_uint_eq(a->points, a->link ? (size_t)row[k].n + 1 : 11);
            if (i > 0 && told.asked.item[i].link)
                ck_assert_uint_eq(a->from, told.asked.item[i - 1].to - 1);
        }
        path_free(&out);
    }
    array_free(&told.options.gouge.scan.files);
    remove(scan);
}
END_TEST

START_TEST(least_length)
{
    struct fitter_options options = fitter_defaults(0.02);
    struct path path = {.name = "path"};
    ck_assert_double_eq(options.tolerance, 0.02);
    ck_assert_double_eq(options.angle, 1);
    ck_assert_double_lt(options.gouge.noise, 0);
    /* three blocks of 2 ms: at 800 mm/min 0.08 mm */
    ck_assert_double_eq_tol(fitter_least(&options, &path), 0.08, 1e-12);
    path_add_feed(&path, 600);
    ck_assert_double_eq_tol(fitter_least(&options, &path), 0.06, 1e-12);
    path_add_feed(&path, 3000);
    path_add_feed(&path, 1000);
    ck_assert_double_eq_tol(fitter_least(&options, &path), 0.3, 1e-12);
    path_add_feed(&path, 60000);
    ck_assert_double_eq(fitter_least(&options, &path), 1);
    options.least_given = true;
    ck_assert_double_eq(fitter_least(&options, &path), 0);
    options.least = 7;
    ck_assert_double_eq(fitter_least(&options, &path), 7);
    path_free(&path);
}
END_TEST

START_TEST(errors_write_nothing)
{
    struct path out;
    struct error error;
    ck_assert_int_eq(fitted("/nowhere/at/all", &out, &error), -1);
    told.refuse = true;
    ck_assert_int_eq(fitted(two_passes(), &out, &error), -1);
    ck_assert_ptr_nonnull(strstr(error.text, "found no such thing"));
    ck_assert_uint_eq(told.asked.n, 0);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("fitter");
    TCase *tests = tcase_create("fitter");
    tcase_add_checked_fixture(tests, setup, teardown);
    tcase_add_test(tests, runs_and_what_is_between);
    tcase_add_test(tests, in_parts_of_the_path);
    tcase_add_test(tests, too_deep_stays);
    tcase_add_test(tests, too_deep_by_the_axis);
    tcase_add_test(tests, a_standing_turn_stays);
    tcase_add_test(tests, links);
    tcase_add_test(tests, least_length);
    tcase_add_test(tests, errors_write_nothing);
    suite_add_tcase(suite, tests);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_ENV);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed > 0;
}
