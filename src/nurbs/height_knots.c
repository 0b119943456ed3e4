/* height_knots - see height_knots.h. */
#include "nurbs/height_knots.h"

#include <stdlib.h>

#include "math/elementary.h"
#include "base/array.h"

enum { CELLS = 512, START = 3, TURNS = 5, LEAST_POINTS = 2 };

static const double POWER = 0.25;  /* of the error: a cubic's falls with the fourth of its span */
static const double STRONGEST = 2; /* a density changes by no more than this at once */
static const double GROWTH = 1.25, HELPS = 0.93;
static const double MOST_WORK = 3e9; /* poles times width^2 */

/* One direction: the density of knots over equal cells of the range. */
struct side {
    double range[2], density[CELLS];
    double *knot;
    size_t knots; /* inner ones */
};

struct search {
    const struct vec3 *point; /* a sample of them */
    size_t n;
    const struct height_knots_options *options;
    struct side side[2];
    size_t fits;
};

static double cell_start(const struct side *s, size_t cell)
{
    return s->range[0] + (s->range[1] - s->range[0]) * (double)cell / CELLS;
}

/* `count` inner knots that have as much of the density between them. */
static void spread_knots(struct side *s, size_t count)
{
    double whole = 0, sum = 0;

    free(s->knot);
    s->knot = mem_alloc(count + 1, sizeof *s->knot);
    s->knots = count;
    for (size_t c = 0; c < CELLS; c++)
        whole += s->density[c];
    for (size_t k = 0, c = 0; k < count; k++) {
        double want = whole * (double)(k + 1) / (double)(count + 1);
        while (c + 1 < CELLS && sum + s->density[c] < want)
            sum += s->density[c++];
        s->knot[k] =
            cell_start(s, c) + (want - sum) / s->density[c] * (s->range[1] - s->range[0]) / CELLS;
    }
}

/* The strip between knots that a place is in. */
static size_t strip_of(const struct side *s, double t)
{
    size_t low = 0, high = s->knots;

    while (low < high) {
        size_t middle = (low + high) / 2;
        if (s->knot[middle] <= t)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* The density follows the errors of the strips; one without points keeps its own. */
static void follow_errors(struct side *s, const double *error)
{
    double sum = 0, count = 0;

    for (size_t k = 0; k <= s->knots; k++)
        if (error[k] > 0) {
            sum += log(error[k]);
            count++;
        }
    double mean = count > 0 ? exp(sum / count) : 1;
    for (size_t c = 0; c < CELLS; c++) {
        double e = error[strip_of(s, (cell_start(s, c) + cell_start(s, c + 1)) / 2)];
        if (e > 0)
            s->density[c] *= fmin(fmax(pow(e / mean, POWER), 1 / STRONGEST), STRONGEST);
    }
}

/* Distance of the worst point, and of the worst of each strip. */
static double measure(const struct search *s, const struct height_fit *fit, double *error[2])
{
    double worst = 0;

    for (size_t i = 0; i < s->n; i++) {
        double off = fabs(height_fit_off(fit, s->point[i]));
        double *of_x = &error[0][strip_of(&s->side[0], s->point[i].x)];
        double *of_y = &error[1][strip_of(&s->side[1], s->point[i].y)];
        *of_x = fmax(*of_x, off);
        *of_y = fmax(*of_y, off);
        worst = fmax(worst, off);
    }
    return worst;
}

static struct height_fit fit_of(const struct search *s)
{
    const struct side *x = &s->side[0], *y = &s->side[1];

    return height_fit_new(x->range, x->knot, x->knots, y->range, y->knot, y->knots);
}

static bool is_too_much(const struct search *s, size_t nx, size_t ny)
{
    double poles = (double)(nx + 4) * (double)(ny + 4),
           width = 3.0 * (double)(nx < ny ? nx : ny) + 15;

    return poles * LEAST_POINTS > (double)s->n || poles * width * width > MOST_WORK;
}

/* With so many inner knots, wherever they serve best: the error of a point at worst; the sides as
 * they were then. */
static double try_counts(struct search *s, size_t nx, size_t ny)
{
    size_t count[2] = {nx, ny};
    double best = HUGE_VAL;
    struct side kept[2] = {s->side[0], s->side[1]};
    int turns = s->options->uniform ? 1 : TURNS;

    for (int turn = 0; turn < turns && best > s->options->error; turn++) {
        double *error[2];
        for (int d = 0; d < 2; d++) {
            spread_knots(&s->side[d], count[d]);
            error[d] = mem_alloc(count[d] + 1, sizeof *error[d]);
        }
        struct height_fit fit = fit_of(s);
        double worst = height_fit_solve(&fit, s->point, s->n, s->options->smooth)
                           ? measure(s, &fit, error)
                           : HUGE_VAL;
        s->fits++;
        if (worst < best) {
            best = worst;
            kept[0] = s->side[0];
            kept[1] = s->side[1];
        }
        for (int d = 0; d < 2; d++) {
            if (isfinite(worst) && !s->options->uniform)
                follow_errors(&s->side[d], error[d]);
            free(error[d]);
        }
        height_fit_free(&fit);
    }
    for (int d = 0; d < 2; d++) { /* knots are made again from the density */
        double *knot = s->side[d].knot;
        s->side[d] = kept[d];
        s->side[d].knot = knot;
        spread_knots(&s->side[d], count[d]);
    }
    return best;
}

struct counts {
    size_t x, y;
};

static size_t more(size_t n)
{
    return (size_t)ceil((double)(n + 1) * GROWTH);
}

/* Upwards until the error is kept: in the direction that lowers it more, or in both where neither
 * helps.  False: it is not kept. */
static bool grow(struct search *s, struct counts *c, double *worst)
{
    *worst = try_counts(s, c->x, c->y);
    while (*worst > s->options->error) {
        struct side before[2] = {s->side[0], s->side[1]};
        struct counts next[3] = {{more(c->x), c->y}, {c->x, more(c->y)}, {more(c->x), more(c->y)}};
        double off[2];
        for (int k = 0; k < 2; k++) {
            for (int d = 0; d < 2; d++) {
                double *knot = s->side[d].knot;
                s->side[d] = before[d];
                s->side[d].knot = knot;
            }
            off[k] = is_too_much(s, next[k].x, next[k].y) ? HUGE_VAL
                                                          : try_counts(s, next[k].x, next[k].y);
        }
        int way = off[0] <= off[1] ? 0 : 1;
        way = off[way] > HELPS * *worst ? 2 : way;
        if (is_too_much(s, next[way].x, next[way].y))
            return false;
        *c = next[way];
        *worst = try_counts(s, c->x, c->y);
    }
    return true;
}

/* Fewer of one direction, by less and less; the sides stay as they were where it does not serve. */
static bool shrink(struct search *s, struct counts *c, int direction, size_t by, double *worst)
{
    struct counts next = *c;
    size_t *n = direction == 0 ? &next.x : &next.y;
    struct side before[2] = {s->side[0], s->side[1]};

    if (*n < by)
        return false;
    *n -= by;
    double off = try_counts(s, next.x, next.y);
    if (off <= s->options->error) {
        *c = next;
        *worst = off;
        return true;
    }
    for (int d = 0; d < 2; d++) {
        double *knot = s->side[d].knot;
        s->side[d] = before[d];
        s->side[d].knot = knot;
        spread_knots(&s->side[d], d == 0 ? c->x : c->y);
    }
    return false;
}

static void shrink_all(struct search *s, struct counts *c, double *worst)
{
    size_t most = c->x > c->y ? c->x : c->y, by = most / 8 > 0 ? most / 8 : 1;

    for (;;) {
        int longer = c->x >= c->y ? 0 : 1; /* a knot less there leaves fewer poles out */
        if (shrink(s, c, 1 - longer, by, worst) || shrink(s, c, longer, by, worst))
            continue;
        if (by == 1)
            return;
        by = by / 2;
    }
}

/* Every so many of the points, from all over. */
static struct vec3 *sample(const struct vec3 *point, size_t n, size_t most, size_t *taken)
{
    size_t step = most > 0 && n > most ? (n - 1) / most + 1 : 1;
    struct vec3 *some = mem_alloc(n / step + 1, sizeof *some);

    *taken = 0;
    for (size_t i = 0; i < n; i += step)
        some[(*taken)++] = point[i];
    return some;
}

/* The fit to all points with the knots that were found, and a few more where these leave more. */
static int finish(struct search *s, struct counts c, const struct vec3 *point, size_t n,
                  struct height_knots *result)
{
    enum { ROUNDS = 8 };

    for (int round = 0; round < ROUNDS; round++) {
        if (round > 0) {
            c.x += c.x / 24 + 1;
            c.y += c.y / 24 + 1;
            spread_knots(&s->side[0], c.x);
            spread_knots(&s->side[1], c.y);
            height_fit_free(&result->fit);
        }
        result->fit = fit_of(s);
        s->fits++;
        if (!height_fit_solve(&result->fit, point, n, s->options->smooth)) {
            height_fit_free(&result->fit);
            return -1;
        }
        result->worst = 0;
        for (size_t i = 0; i < n; i++)
            result->worst = fmax(result->worst, fabs(height_fit_off(&result->fit, point[i])));
        if (result->worst <= s->options->error || result->bounded || is_too_much(s, c.x, c.y))
            break;
    }
    return 0;
}

int height_knots_search(const struct vec3 *point, size_t n, const double range_x[2],
                        const double range_y[2], const struct height_knots_options *options,
                        struct height_knots *result)
{
    struct search s = {.options = options};
    struct counts c = {START, START};
    double worst;

    *result = (struct height_knots){.worst = HUGE_VAL};
    struct vec3 *some = sample(point, n, options->sampled, &s.n);
    s.point = some;
    for (int d = 0; d < 2; d++) {
        const double *range = d == 0 ? range_x : range_y;
        s.side[d].range[0] = range[0];
        s.side[d].range[1] = range[1];
        for (size_t k = 0; k < CELLS; k++)
            s.side[d].density[k] = 1;
        spread_knots(&s.side[d], START);
    }
    if (grow(&s, &c, &worst))
        shrink_all(&s, &c, &worst);
    else
        result->bounded = true;
    for (int d = 0; d < 2; d++)
        spread_knots(&s.side[d], d == 0 ? c.x : c.y);
    int status = finish(&s, c, point, n, result);
    result->fits = s.fits;
    free(s.side[0].knot);
    free(s.side[1].knot);
    free(some);
    return status;
}
