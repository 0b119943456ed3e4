/* path_judged - see path_judged.h. */
#include "path_judged.h"

#include <stdlib.h>

#include "coverage_judge.h"
#include "stage/path_options.h"

/* What a judge finds left by the program for each point that it finds by the path, at most: of
 * fourteen scans it found 0.4 to 1. */
static const double JUDGED = 1.05;

/* So much more is no fault to a judge, mm: what places and radii printed may be off. */
static const double ROUNDED = 0.001;

/* Most paths get a fitter, whose tolerance makes up for some more: of 69 models from above it did
 * so for four with up to 1.14 times as much as may be left.  Beyond this it may not. */
static const double FITTED = 2;

static double share(const struct path_judged *judged)
{
    return 100 * ((double)judged->left + JUDGED * (double)judged->n);
}

/* More than so many times the share that may be left. */
static bool is_much(const struct path_coverage *c, const struct path_judged *judged, double times)
{
    double may = path_options.left_share * (double)coverage_report(c->coverage).points;

    return share(judged) > times * may;
}

/* The points with more than `least` and no more than `most` on them that are out of reach or kept
 * off: how many. */
static size_t ask(const struct path_coverage *c, double least, double most, double *height)
{
    size_t n, asked = 0;
    const struct coverage_point *point = coverage_points(c->coverage, &n);

    for (size_t i = 0; i < n; i++) {
        double h = point[i].height;
        bool may = point[i].state == COVERAGE_KEPT || point[i].state == COVERAGE_OUT;
        if (!may || h <= least || h > most)
            continue;
        height[i] = h;
        asked++;
    }
    return asked;
}

static size_t left_beyond(const struct path_coverage *c, double limit)
{
    size_t n, left = 0;
    const struct coverage_point *point = coverage_points(c->coverage, &n);

    for (size_t i = 0; i < n; i++)
        left += point[i].state == COVERAGE_LEFT && point[i].height > limit;
    return left;
}

static void judge(const struct path_coverage *c, const struct vec3s *place, double *height,
                  struct path_judged *judged)
{
    const struct coverage_judge_options options = {.radius = c->options.radius,
                                                   .limit = judged->limit,
                                                   .noise = fmax(path_options.noise, 0),
                                                   .holder = c->options.holder,
                                                   .chain = &c->rule->chain,
                                                   .scan = c->scan,
                                                   .threads = c->options.threads};
    size_t n, at;
    const struct coverage_point *point = coverage_points(c->coverage, &n);

    judged->n = coverage_judge_left(place->item, height, place->n, &options, &at);
    if (judged->n > 0)
        judged->worst = point[at];
}

/* None that was out of reach by the larger limit is asked for again, and nothing where even all
 * others were no more than may be. */
struct path_verdicts path_judged(const struct path_coverage *c, const struct vec3s *place)
{
    double limit = c->allowed + ROUNDED;
    struct path_judged last = {.limit = c->allowed + STAGES * c->tolerance,
                               .left = coverage_report(c->coverage).left.n};
    struct path_judged straight = {.limit = limit, .left = left_beyond(c, limit)};
    double *height = mem_alloc(place->n + 1, sizeof *height);

    for (size_t i = 0; i < place->n; i++)
        height[i] = 0;
    ask(c, last.limit, INFINITY, height);
    judge(c, place, height, &last);
    last.much = is_much(c, &last, 1);
    straight.n = last.n + ask(c, straight.limit, last.limit, height);
    if (is_much(c, &straight, 1))
        judge(c, place, height, &straight);
    free(height);
    straight.much = is_much(c, &straight, FITTED);
    struct path_verdicts verdicts = {
        .worse = straight.much && share(&straight) > share(&last) ? straight : last,
        .as_is = straight};
    verdicts.as_is.much = !verdicts.worse.much && is_much(c, &straight, 1);
    return verdicts;
}
