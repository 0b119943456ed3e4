/* path_judged - see path_judged.h. */
#include "path_judged.h"

#include <stdlib.h>

#include "coverage_judge.h"
#include "stage/path_options.h"

/* What a judge finds left by the program for each point that it finds by the path, at most: of 50
 * known shapes with noise it found one more of nine on one, and fewer or as many on the others. */
static const double JUDGED = 1.05;

/* A ball that comes so near to a point, of what rows may leave, could cut it. */
static const double SURE = 0.5;

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

/* What is on the points out of reach or kept off, where it is more than `least`; else 0. */
static double *ask(const struct path_coverage *c, double least)
{
    size_t n;
    const struct coverage_point *point = coverage_points(c->coverage, &n);
    double *height = mem_alloc(n + 1, sizeof *height);

    for (size_t i = 0; i < n; i++) {
        bool may = point[i].state == COVERAGE_KEPT || point[i].state == COVERAGE_OUT;
        height[i] = may && point[i].height > least ? point[i].height : 0;
    }
    return height;
}

static size_t left_beyond(const struct path_coverage *c, double limit)
{
    size_t n, left = 0;
    const struct coverage_point *point = coverage_points(c->coverage, &n);

    for (size_t i = 0; i < n; i++)
        left += point[i].state == COVERAGE_LEFT && point[i].height > limit;
    return left;
}

/* Leaves what is on those that are judged to be within reach. */
static void judge(const struct path_coverage *c, struct vec3s *place, double limit, double *height)
{
    const struct coverage_judge_options options = {.radius = c->options.radius,
                                                   .limit = limit,
                                                   .near = SURE * (c->rows + ROUNDED),
                                                   .noise = fmax(path_options.noise, 0),
                                                   .holder = c->options.holder,
                                                   .chain = &c->rule->chain,
                                                   .scan = c->scan,
                                                   .threads = c->options.threads};
    size_t n;
    const struct coverage_point *point = coverage_points(c->coverage, &n);
    struct vec3s asked = {0};

    for (size_t i = 0; i < n; i++)
        *array_push(&asked) = point[i].p;
    coverage_judge_left(asked.item, height, n, place, &options);
    array_free(&asked);
}

/* Where so much may be left. */
static struct path_judged judged_by(const struct path_coverage *c, double limit,
                                    const double *height)
{
    size_t n;
    const struct coverage_point *point = coverage_points(c->coverage, &n);
    struct path_judged judged = {.limit = limit};

    for (size_t i = 0; i < n; i++) {
        if (height[i] <= limit)
            continue;
        if (judged.n++ == 0 || height[i] > judged.worst.height)
            judged.worst = point[i];
    }
    return judged;
}

struct path_verdicts path_judged(const struct path_coverage *c, struct vec3s *place)
{
    double limit = c->allowed + ROUNDED, last = c->allowed + STAGES * c->tolerance;
    double *height = ask(c, limit);

    judge(c, place, limit, height);
    struct path_verdicts verdicts = {.worse = judged_by(c, last, height),
                                     .as_is = judged_by(c, limit, height)};
    free(height);
    verdicts.worse.left = coverage_report(c->coverage).left.n;
    verdicts.as_is.left = left_beyond(c, limit);
    verdicts.worse.much = is_much(c, &verdicts.worse, 1);
    if (!verdicts.worse.much && is_much(c, &verdicts.as_is, FITTED)) {
        verdicts.worse = verdicts.as_is;
        verdicts.worse.much = true;
    }
    verdicts.as_is.much = !verdicts.worse.much && is_much(c, &verdicts.as_is, 1);
    return verdicts;
}
