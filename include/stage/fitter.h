/*
 * fitter - the tools that replace the points of a path's cutting runs by curves: what they share.
 *
 * A new fitter is one file, src/NAME.c, with its table of options, a row `struct fitter`, and a
 * main that calls fitter_run.  The row says how one run is fitted and what is reported; all else
 * is here: the path is read, the scan to keep clear of too, the runs are found and fitted in
 * parallel, and so are the links between them with the tool down; what is neither is carried
 * through, the ledger is kept, and the exit status says whether all holds.
 *
 * The mathematics of a fitter is a folder of its own (arcfit, splinefit), which fits a reference
 * (curve/reference.h) and knows nothing of paths.
 */
#ifndef CLOUDMILL_FITTER_H
#define CLOUDMILL_FITTER_H

#include "base/cli.h"
#include "base/effort.h"
#include "io/path/path.h"
#include "io/path/path_part.h"
#include "stage/gouge_options.h"

/* The options that all fitters have; a fitter's table of options fills them. */
struct fitter_options {
    double tolerance; /* -e, mm: of the tip and the ball's centre */
    bool tolerance_given;
    double angle; /* --axis-tolerance, degrees */
    bool angle_given;
    bool paper;      /* --paper: as published */
    bool links_stay; /* links are not fitted */
    bool report;     /* --report: a table on standard error */
    double least;    /* --min-length: of a piece, mm; 0: any */
    bool least_given;
    const char *part_text; /* --part: K/N; NULL: the whole path */
    struct path_part part; /* what it says */
    struct gouge_options gouge;
};

/* The rows of the options table that are the same in all fitters. */
#define FITTER_OPTIONS(common)                                                         \
    {0,        "no-guard",                                                             \
     NULL,     "by no scan, not even the one that the path names",                     \
     CLI_FLAG, &(common)->gouge.scan.none,                                             \
     0,        0,                                                                      \
     0,        NULL},                                                                  \
        {0,          "noise",                                                          \
         "MM",       "noise of the scan (default: the path's, or measured)",           \
         CLI_NUMBER, &(common)->gouge.noise,                                           \
         0,          10,                                                               \
         0,          NULL},                                                            \
        EFFORT_OPTION(&(common)->gouge.effort),                                        \
        {0,        "part",                                                             \
         "K/N",    "only part K of N: whole passes, to be joined by cat",              \
         CLI_TEXT, &(common)->part_text,                                               \
         0,        0,                                                                  \
         0,        NULL},                                                              \
    {                                                                                  \
        0, "min-length", "MM",                                                         \
            "no piece or knot span shorter, unless the tolerance forbids it; 0: any\n" \
            "(6 ms at the path's feed: 0.08 mm at 800 mm/min)",                        \
            CLI_NUMBER, &(common)->least, 0, 100, 0, &(common)->least_given            \
    }

/* As they are when none is given, with this tolerance. */
struct fitter_options fitter_defaults(double tolerance);

/* The least length of a piece, mm: the one that was asked for; else what the path's largest feed
 * goes in three blocks of 2 ms, which any control can read ahead, without one 800 mm/min. */
double fitter_least(const struct fitter_options *options, const struct path *in);

/* -1 and why where the tolerance is as large as the ball of the path: nothing would then tell the
 * part from air, and ncverify refuses such a program. */
int fitter_check_tolerance(const struct fitter_options *options, const struct path *in,
                           struct error *error);

/* One cutting run, and what became of it. */
struct fitted_run {
    size_t from, to;           /* items [from, to) of the path */
    size_t pass;               /* the pass that it is part of */
    size_t number;             /* of the run, for the driver */
    bool link;                 /* it touches nothing */
    bool rough;                /* a link whose lines do not lead round smoothly; */
    struct vec3 leave, arrive; /* directions of the motions before and after a link; zero: none */
    struct vec3 out[2];        /* normals where it begins and ends; zero: not known */
    bool stays;                /* set by the fit: its points stay as they came */
    struct path fitted;        /* the items that take the place of [from + 1, to) */
    struct gouge_refit_result gouge;
    bool swept;   /* all its motions were held against the guard, for `gouge` */
    void *result; /* the fitter's own, all zero before the fit */
};

struct fitted_runs {
    size_t n, cap;
    struct fitted_run *item;
};

/* What a fit of one run is asked for. */
struct fit_request {
    const struct gouge_refit_options *gouge;
    const struct path *in;
    double axis_share; /* of the axis tolerance that may be used */
    double work;       /* share of the usual work: less where there are very many points */
};

struct fitter {
    const char *name;                     /* of the tool: its entry in the ledger */
    const struct fitter_options *options; /* as they were parsed */
    void *settings;                       /* the fitter's own, handed to the functions below */
    bool whole; /* `prepare` changes more than the head: not before all of the path is read */

    /* Checks and changes the path that was read; unless `whole`, its head alone may be there.  -1:
     * an error. */
    int (*prepare)(void *settings, struct path *in, struct error *error);

    /*
     * Fits one run: fills its fitted, gouge and result.  The points are those of its items
     * (path_run.h), and may be lifted.  Called in parallel.  A run that stays too deep is fitted
     * again with less of the axis tolerance, then in parts, without the motions next to the places
     * that are too deep: these stay as they came.  A link that is rough is not to be followed; it
     * stays unless there is another way.
     */
    void (*fit)(const void *settings, const struct fit_request *request, struct run *points,
                struct fitted_run *run);

    /* Reports on all runs: the table where it is asked for, the totals, and what is unmet. */
    void (*report)(const void *settings, const struct path *in, const struct fitted_runs *runs,
                   struct unmets *unmet);

    /* What a result spent of the tolerance, mm. */
    double (*spent)(const void *result);

    size_t result_size;
    void (*result_free)(void *result); /* what a result holds; NULL: nothing */
};

/*
 * All of a fitter's work once its options are parsed: reads the path, fits its runs, writes the new
 * path.  Returns the exit status; -1: an error, nothing is written.
 */
int fitter_run(const struct fitter *fitter, const struct cli *cli, struct error *error);

#endif
