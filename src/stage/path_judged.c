/* path_judged - see path_judged.h. */
#include "path_judged.h"

#include <stdlib.h>

#include "cloud/judged_scan.h"
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

size_t path_judged_most(size_t n)
{
    return (size_t)ceil(JUDGED * (double)n);
}

/* A share that is printed as no more than may be, in percent, is no more. */
static const double PERCENT = 0.005;

/* With n points judged left beside those that are it is more than so many times the share that may
 * be left. */
static bool is_more(const struct path_coverage *c, const struct path_judged *judged, size_t n,
                    double times)
{
    double share = path_options.left_share, points = (double)coverage_report(c->coverage).points;
    double may = share > 0 && n == 0 ? share + PERCENT : share; /* of n it is a bound */

    return 100 * (double)(judged->left + path_judged_most(n)) > times * may * points;
}

static bool is_much(const struct path_coverage *c, const struct path_judged *judged, double times)
{
    return is_more(c, judged, judged->n - judged->unseen, times) ||
           is_more(c, judged, judged->n, JUDGED_SCAN_UNSEEN * times);
}

/* What a judge is asked of, and what is on it: on none that is out of reach; of the others, whether
 * only an edge that goes on unseen would put them there. */
struct asked {
    struct coverage_point *point;
    double *height;
    bool *unseen;
    size_t n;
};

/* Of noisy points those that a judge has, also those that are left, for it takes them to be
 * elsewhere; of others those out of reach or kept off on which is more than `least`. */
static struct asked ask(const struct path_coverage *c, double least)
{
    size_t n;
    const struct coverage_point *point = coverage_points(c->judged ? c->judged : c->coverage, &n);
    struct asked asked = {mem_alloc(n + 1, sizeof *asked.point),
                          mem_alloc(n + 1, sizeof *asked.height),
                          mem_alloc(n + 1, sizeof *asked.unseen), n};

    for (size_t i = 0; i < n; i++) {
        bool may = point[i].state == COVERAGE_KEPT || point[i].state == COVERAGE_OUT ||
                   (c->judged && point[i].state == COVERAGE_LEFT);
        asked.point[i] = point[i];
        asked.unseen[i] = false;
        asked.height[i] = may && point[i].height > least ? point[i].height : 0;
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

/* Leaves what is on those that are judged to be within reach; if `unseen`, by a judge that knows of
 * all edges that may go on. */
static void judge(const struct path_coverage *c, const struct vec3s *place, double limit,
                  bool unseen, const struct asked *asked, double *height)
{
    const struct coverage_judge_options options = {.radius = c->options.radius,
                                                   .limit = limit,
                                                   .near = SURE * (c->rows + ROUNDED),
                                                   .noise = fmax(path_options.noise, 0),
                                                   .holder = c->options.holder,
                                                   .chain = &c->rule->chain,
                                                   .scan = c->scan,
                                                   .unseen = unseen,
                                                   .threads = c->options.threads};
    struct vec3s at = {0}, solid = {0};

    for (size_t i = 0; i < asked->n; i++)
        *array_push(&at) = asked->point[i].p;
    vec3s_add(&solid, place->item, place->n); /* it is moved off its noise */
    coverage_judge_left(at.item, height, asked->n, &solid, &options);
    array_free(&at);
    array_free(&solid);
}

static void find_unseen(const struct path_coverage *c, const struct vec3s *place, double limit,
                        const struct asked *asked)
{
    double *height = mem_alloc(asked->n + 1, sizeof *height);

    for (size_t i = 0; i < asked->n; i++)
        height[i] = asked->point[i].state == COVERAGE_LEFT ? 0 : asked->height[i];
    judge(c, place, limit, true, asked, height);
    for (size_t i = 0; i < asked->n; i++)
        asked->unseen[i] =
            asked->height[i] > 0 && asked->point[i].state != COVERAGE_LEFT && !(height[i] > 0);
    free(height);
}

/* Where so much may be left. */
static struct path_judged judged_by(const struct path_coverage *c, const struct asked *asked,
                                    double limit)
{
    struct path_judged judged = {.limit = limit};

    for (size_t i = 0; i < asked->n; i++) {
        if (asked->height[i] <= limit)
            continue;
        if (asked->point[i].state == COVERAGE_LEFT) {
            judged.left++;
            continue;
        }
        judged.unseen += asked->unseen[i];
        if (judged.n++ == 0 || asked->height[i] > judged.worst.height)
            judged.worst = asked->point[i];
    }
    if (!c->judged)
        judged.left = left_beyond(c, limit);
    return judged;
}

/* By both limits. */
static struct path_verdicts verdicts_of(const struct path_coverage *c, const struct asked *asked,
                                        double last, double limit)
{
    struct path_verdicts verdicts = {.worse = judged_by(c, asked, last),
                                     .as_is = judged_by(c, asked, limit)};

    if (!c->judged)
        verdicts.worse.left = coverage_report(c->coverage).left.n;
    verdicts.worse.much = is_much(c, &verdicts.worse, 1);
    if (!verdicts.worse.much && is_much(c, &verdicts.as_is, FITTED)) {
        verdicts.worse = verdicts.as_is;
        verdicts.worse.much = true;
    }
    verdicts.worse.more = is_more(c, &verdicts.worse, verdicts.worse.n, 1);
    verdicts.as_is.much = !verdicts.worse.much && is_much(c, &verdicts.as_is, 1);
    return verdicts;
}

struct path_verdicts path_judged(const struct path_coverage *c, const struct vec3s *place)
{
    /* what is left of points by a hair a fitter may leave more of: of exact ones few are */
    int stages = c->judged ? STAGES - 1 : STAGES;
    double limit = c->allowed + ROUNDED, last = c->allowed + stages * c->tolerance;
    struct asked asked = ask(c, limit);

    judge(c, place, limit, false, &asked, asked.height);
    struct path_verdicts verdicts = verdicts_of(c, &asked, last, limit);
    bool may_be_unseen =
        c->scan && !is_more(c, &verdicts.worse, verdicts.worse.n, JUDGED_SCAN_UNSEEN);
    if ((verdicts.worse.much || verdicts.as_is.much) && may_be_unseen) {
        find_unseen(c, place, limit, &asked);
        verdicts = verdicts_of(c, &asked, last, limit);
    }
    free(asked.point);
    free(asked.height);
    free(asked.unseen);
    return verdicts;
}
