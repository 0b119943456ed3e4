/* fitter - see fitter.h. */
#include "stage/fitter.h"

#include <math.h>
#include <stdlib.h>

#include "base/out.h"
#include "base/parallel.h"
#include "io/path/path_run.h"
#include "stage/path_check.h"

struct fitter_options fitter_defaults(double tolerance)
{
    return (struct fitter_options){
        .tolerance = tolerance, .angle = 1, .gouge = {.noise = -1, .effort = 1}};
}

/* What the threads share. */
struct workload {
    const struct fitter *fitter;
    const struct path *in;
    const struct gouge_refit_options *gouge;
    struct fitted_runs *runs;
};

static struct fitted_runs find_runs(const struct fitter *fitter, const struct path *in)
{
    struct fitted_runs runs = {0};
    size_t at = 0, pass = 0;

    for (size_t from = 0, to; path_next_run(in, &from, &to); from = to) {
        for (; at < from; at++)
            if (in->item.item[at].kind == PATH_PASS)
                pass = in->item.item[at].index;
        *array_push(&runs) = (struct fitted_run){
            .from = from, .to = to, .pass = pass, .result = mem_alloc(1, fitter->result_size)};
    }
    return runs;
}

static void fit_runs(void *context, size_t from, size_t to)
{
    const struct workload *w = context;
    for (size_t i = from; i < to; i++) {
        struct fitted_run *run = &w->runs->item[i];
        struct run points = path_run_read(w->in, run->from, run->to);
        w->fitter->fit(w->fitter->settings, w->gouge, w->in, &points, run);
        array_free(&points);
    }
}

/* The path with the fitted items in the place of the runs; all else goes over as it is. */
static struct path assemble(const struct path *in, const struct fitted_runs *runs)
{
    struct path out = {.name = in->name};
    size_t done = 0;

    path_head_copy(&out.head, &in->head);
    out.head.chord = NAN;
    for (size_t i = 0; i < runs->n; i++) {
        const struct fitted_run *run = &runs->item[i];
        path_add_items(&out, in, done, run->from + 1);
        path_add_items(&out, &run->fitted, 0, run->fitted.item.n);
        done = run->to;
    }
    path_add_items(&out, in, done, in->item.n);
    return out;
}

static void free_runs(const struct fitter *fitter, struct fitted_runs *runs)
{
    for (size_t i = 0; i < runs->n; i++) {
        path_free(&runs->item[i].fitted);
        if (fitter->result_free)
            fitter->result_free(runs->item[i].result);
        free(runs->item[i].result);
    }
    array_free(runs);
}

static int read_path(const struct fitter *fitter, const char *file, struct path *in,
                     struct error *error)
{
    if (path_read(file, in, error) < 0)
        return -1;
    for (size_t i = 0; i < in->unknown.n; i++)
        say("%s:%u: unknown word %s, copied", in->name, in->unknown.item[i].line,
            in->unknown.item[i].word);
    if (fitter->prepare(fitter->settings, in, error) < 0)
        return -1;
    if (in->head.track != TRACK_CONTACT && !(path_ball(in) > 0))
        say("%s: no ball nose CUTTER: the tolerance is kept at the tracked point alone", in->name);
    return 0;
}

static void write_path(const char *file, const struct path *path)
{
    struct out *o = out_open(file);
    path_write(o, path);
    out_close(o);
}

int fitter_run(const struct fitter *fitter, const struct cli *cli, struct error *error)
{
    const struct fitter_options *options = fitter->options;
    struct gouge_refit_options gouge = {0};
    struct path in = {0};

    if (read_path(fitter, cli->file[0], &in, error) < 0 ||
        gouge_options_read(&options->gouge, &in, options->paper, options->tolerance, cli->threads,
                           &gouge, error) < 0) {
        path_free(&in);
        return -1;
    }
    struct fitted_runs runs = find_runs(fitter, &in);
    struct workload workload = {fitter, &in, &gouge, &runs};
    parallel_shown("fitting", cli->threads, runs.n, fit_runs, &workload);
    double lift = 0;
    for (size_t i = 0; i < runs.n; i++)
        lift = fmax(lift, runs.item[i].gouge.lift);

    struct path out = assemble(&in, &runs);
    struct fitter_outcome outcome = fitter->report(fitter->settings, &in, &runs);
    if (runs.n > 0)
        path_spend(&out, fitter->name, outcome.spent + lift);
    write_path(cli->output, &out);
    struct path_check check = {.tool = gouge, .threads = cli->threads};
    path_check_items(&check, &out, 0, out.item.n);
    if (lift > 0)
        note("points lifted by at most %.4f mm where motions went too deep between them", lift);
    int status = path_check_conclude(&check);
    gouge_refit_free(&gouge);
    free_runs(fitter, &runs);
    path_free(&in);
    path_free(&out);
    return outcome.status == EXIT_DONE ? status : outcome.status;
}
