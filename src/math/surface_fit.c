/* surface_fit - see surface_fit.h. */
#include "math/surface_fit.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/parallel.h"
#include "math/cubic.h"
#include "math/moment_fit.h"
#include "math/ridge_direction.h"
#include "rough_place.h"

enum { WIDEST = 1024 };

struct surface_fit_hood {
    size_t n;
    uint32_t index[WIDEST];
    double distance2[WIDEST], weight[WIDEST];
    double off[WIDEST]; /* the points, off the last surface fitted */
    struct vec3 point[WIDEST];
    size_t gathered; /* so many, nearest to ... */
    struct vec3 at;
    size_t steep; /* a quadric was fitted to so many of them; 0: none yet */
    struct quadric steep_quadric;
    int steep_status;
    struct surface_fit_hood *along; /* room for one that is longer one way */
};

enum { LEAST = 32, FEW = 64, MOST = 362, STEPS = 8, REFITS = 2 };

static const double TUKEY = 4.685; /* in standard deviations: 95 % efficient on normal noise */

static bool is_same(struct vec3 a, struct vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* The k points nearest to a place; they may be there already. */
static void gather_hood(const struct point_grid *b, struct vec3 vertex, size_t k,
                        struct surface_fit_hood *hood)
{
    if (hood->gathered >= k && is_same(hood->at, vertex)) {
        hood->n = k;
        return;
    }
    hood->n = point_grid_nearest(b, vertex, k, hood->index, hood->distance2);
    for (size_t i = 0; i < hood->n; i++)
        hood->point[i] = b->point[hood->index[i]];
    if (!is_same(hood->at, vertex))
        hood->steep = 0;
    hood->at = vertex;
    hood->gathered = hood->n;
}

/* quadric_fit_steep of the first n points gathered, about the place they are nearest to; `guess` is
 * that of the place. */
static int fit_steep(struct surface_fit_hood *hood, size_t n, struct vec3 guess,
                     struct quadric *quadric)
{
    if (hood->steep != n) {
        hood->steep_status =
            quadric_fit_steep(hood->point, n, hood->at, guess, &hood->steep_quadric);
        hood->steep = n;
    }
    *quadric = hood->steep_quadric;
    return hood->steep_status;
}

/* Weights of the first k points by how far they are off a surface; returns their spread about it.
 * Where it passes a good part of them by it is not theirs: infinite. *farthest: the largest of
 * their distances. */
static double weigh_points(struct surface_fit_hood *hood, size_t k, double sigma, double *farthest)
{
    const double terms = 6, most = 0.6;
    double sum = 0, sum2 = 0;
    *farthest = 0;
    for (size_t i = 0; i < k; i++) {
        double off = hood->off[i], r = off / (TUKEY * sigma);
        *farthest = fabs(off) > *farthest ? fabs(off) : *farthest;
        double root = r * r < 1 ? 1 - r * r : 0;
        hood->weight[i] = root * root;
        sum += hood->weight[i];
        sum2 += hood->weight[i] * off * off;
    }
    return sum > fmax(terms, most * (double)k) ? sqrt(sum2 / (sum - terms)) : INFINITY;
}

/* Is the foot certain to `part` of sigma, and the normal to `tilt` radians? */
static bool is_certain(const struct quadric *q, double sigma, double part, double tilt)
{
    return q->variance < part * part && sigma * sqrt(q->tilt) < tilt;
}

/* So uncertain that a neighbourhood that is bent tells more. */
static bool is_useless(const struct quadric *q, double sigma)
{
    return !is_certain(q, sigma, 0.8, 0.06);
}

/* In the frame of a normal that is nearly right: a cubic or, where the points carry none, a
 * quadric. -1: neither. */
static int fit_weighted(const struct surface_fit_hood *hood, const double *weight, size_t k,
                        struct vec3 vertex, struct vec3 normal, double sigma, struct quadric *q)
{
    if (cubic_fit(hood->point, weight, k, vertex, normal, q) == 0 && !is_useless(q, sigma))
        return 0;
    return quadric_fit_weighted(hood->point, weight, k, vertex, normal, q);
}

/* A surface through the first k points in the frame of a normal, all of which count alike; -1:
 * there is none. *farthest: how far they are off it at most, all in hood->off. */
static int fit_alike(struct surface_fit_hood *hood, size_t k, struct vec3 vertex,
                     struct vec3 normal, double sigma, struct surface_fit *fit, double *farthest)
{
    if (fit_weighted(hood, NULL, k, vertex, normal, sigma, &fit->q) < 0)
        return -1;
    fit->n = k;
    quadric_off_all(&fit->q, hood->point, k, hood->off);
    fit->spread = weigh_points(hood, k, INFINITY, farthest);
    return 0;
}

/* The same, what is far off counting less and less. */
static int fit_through(struct surface_fit_hood *hood, size_t k, struct vec3 vertex,
                       struct vec3 normal, struct vec3 guess, double sigma, struct surface_fit *fit)
{
    const double far = 3.5; /* in sigma */
    struct quadric *q = &fit->q;
    double farthest;
    if (fit_alike(hood, k, vertex, normal, sigma, fit, &farthest) < 0)
        return -1;
    for (int i = 0; i < REFITS && farthest > far * sigma; i++) {
        struct quadric next;
        fit->spread = weigh_points(hood, k, fmax(sigma, fit->spread), &farthest);
        if (fit_weighted(hood, hood->weight, k, vertex, quadric_normal(q), sigma, &next) < 0)
            break;
        *q = next;
        quadric_off_all(q, hood->point, k, hood->off);
        fit->spread = weigh_points(hood, k, fmax(sigma, fit->spread), &farthest);
    }
    fit->offset = vec_dot(vec_sub(quadric_foot(q), vertex), guess);
    fit->reach = vec_distance(hood->point[k - 1], vertex);
    return 0;
}

/* The surface through the first k points, in the frame of a quadric through some of them; where
 * that leads nowhere, as on laser lines it may, through all of them, or straight up.  -1: they
 * carry none. */
static int fit_to(struct surface_fit_hood *hood, size_t k, struct vec3 vertex, struct vec3 guess,
                  double sigma, struct surface_fit *fit)
{
    const size_t some[] = {k < 48 ? k : 48, k, 0};
    int fitted = -1;
    for (int i = 0; i < 3 && fitted < 0; i++) {
        struct vec3 normal = vec(0, 0, 1);
        if (some[i] > 0) {
            if (fit_steep(hood, some[i], guess, &fit->q) < 0)
                continue;
            normal = quadric_normal(&fit->q);
        }
        fitted = fit_through(hood, k, vertex, normal, guess, sigma, fit);
    }
    return fitted;
}

/* Do the feet, and the normals, of a wide neighbourhood and of its nearer part differ by no more
 * than noise explains, `times` as much? */
static bool same_foot(const struct surface_fit *wide, const struct surface_fit *part, double sigma,
                      double times)
{
    const double sigmas = 2.5, tilts = 4.25; /* by chance, of two slopes: exp(-tilts^2 / 2) */
    /* of the difference of nested fits; of a cubic and a quadric, about that of the cubic */
    double variance = fmax(part->q.variance - wide->q.variance, wide->q.variance);
    struct vec3 turn = vec_sub(quadric_normal(&wide->q), quadric_normal(&part->q));
    struct vec3 way = vec_unit(turn); /* on few scan lines the slope across is far less certain */
    double of_wide = quadric_tilt_along(&wide->q, way);
    double tilt = fmax(quadric_tilt_along(&part->q, way) - of_wide, of_wide);
    return fabs(wide->offset - part->offset) <= times * sigmas * sigma * sqrt(variance) &&
           vec_length(turn) <= times * tilts * sigma * sqrt(tilt);
}

/* Is the wide neighbourhood spread as its nearer part is? */
static bool same_spread(const struct surface_fit *wide, const struct surface_fit *part,
                        double sigma)
{
    double bent = 1 + 3 / sqrt(2 * (double)wide->n);
    return wide->spread <= bent * fmax(part->spread, sigma);
}

static bool surfaces_agree(const struct surface_fit *wide, const struct surface_fit *part,
                           double sigma)
{
    return same_foot(wide, part, sigma, 1) && same_spread(wide, part, sigma);
}

/* Where to gather from: the foot of the vertex on a first fit, for the points nearest to one that
 * is off the surface are off to the same side. */
static struct vec3 first_foot(const struct surface_fit_options *rule, struct vec3 vertex,
                              struct vec3 guess, struct surface_fit_hood *hood)
{
    const size_t some = 2 * (size_t)LEAST;
    const double far = 4;
    struct surface_fit fit;
    gather_hood(rule->point_grid, vertex, some, hood);
    if (fit_to(hood, hood->n, vertex, guess, rule->sigma, &fit) < 0 ||
        is_useless(&fit.q, rule->sigma) || fabs(fit.offset) > far * rule->sigma)
        return vertex;
    return quadric_foot(&fit.q);
}

/* From few points to many, LEAST to MOST: the last neighbourhood of a place that agrees with all
 * within it.  `guess`: the normal there, roughly, on either side. */
static size_t widest_hood(const struct surface_fit_options *rule, struct vec3 vertex,
                          struct vec3 guess, struct surface_fit_hood *hood)
{
    struct surface_fit fit[STEPS];
    size_t widest = LEAST, n = 0;
    vertex = first_foot(rule, vertex, guess, hood);
    gather_hood(rule->point_grid, vertex, MOST, hood);
    double k = LEAST;
    for (int step = 0; step < STEPS; step++, k *= sqrt(2)) {
        size_t count = (size_t)(k + 0.5);
        if (count > hood->n || fit_to(hood, count, vertex, guess, rule->sigma, &fit[n]) < 0 ||
            is_useless(&fit[n].q, rule->sigma))
            continue;
        for (size_t i = 0; i < n; i++)
            if (!surfaces_agree(&fit[n], &fit[i], rule->sigma))
                return widest;
        widest = count;
        n++;
    }
    return widest;
}

/* Certain enough to go without more points, where these agree: of the foot in sigma, of the normal
 * in radians. */
static const double SETTLED_PART = 0.35, SETTLED_TILT = 0.04;

static bool is_settled(const struct quadric *q, double sigma)
{
    return is_certain(q, sigma, SETTLED_PART, SETTLED_TILT);
}

/* The neighbourhood to begin with, wider where it carries no surface or, at a border, an uncertain
 * one.  Returns its size, 0: there is none. */
static size_t begin_at(const struct surface_fit_options *rule, struct vec3 vertex,
                       struct vec3 guess, struct surface_fit_hood *hood, struct surface_fit *fit)
{
    size_t began = 0, most = 4 * rule->neighbours < WIDEST ? 4 * rule->neighbours : WIDEST;
    for (size_t k = rule->neighbours; k <= WIDEST; k *= 2) {
        struct surface_fit wide;
        gather_hood(rule->point_grid, vertex, k, hood);
        if (fit_to(hood, hood->n, vertex, guess, rule->sigma, &wide) == 0) {
            bool useless = began == 0 || is_useless(&fit->q, rule->sigma);
            if (!useless && (k > most || !surfaces_agree(&wide, fit, rule->sigma)))
                return began;
            *fit = wide;
            began = hood->n;
            if (is_settled(&fit->q, rule->sigma) ||
                (!is_useless(&fit->q, rule->sigma) && !surface_fit_holds(fit, rule->sigma)))
                return began; /* more points would not hold it either */
        }
        if (hood->n < k)
            break;
    }
    return began;
}

/* Is the nearer part the better one?  The more uncertain it is itself, the more that takes to say:
 * where chance alone chooses it, its own error is what is got. */
static bool is_better(const struct surface_fit *part, const struct surface_fit *fit, double sigma)
{
    const struct quadric *q = &part->q;
    double foot = q->variance / (SETTLED_PART * SETTLED_PART);
    double turn = sigma * sigma * q->tilt / (SETTLED_TILT * SETTLED_TILT);
    double unsettled = fmax(foot, turn), times = 1 + fmin(1, unsettled * unsettled);
    return !is_useless(q, sigma) &&
           !(same_foot(fit, part, sigma, times) && same_spread(fit, part, sigma));
}

/* The surface for a vertex: false when no neighbourhood has one. */
static bool fit_at(const struct surface_fit_options *rule, struct vec3 vertex, struct vec3 guess,
                   struct surface_fit_hood *hood, struct surface_fit *fit)
{
    const double narrow = 0.05; /* sigma, in widths of the neighbourhood */
    size_t k = begin_at(rule, vertex, guess, hood, fit);
    if (k > 0 && rule->sigma > narrow * sqrt(hood->distance2[k - 1])) {
        vertex = first_foot(rule, vertex, guess, hood);
        k = begin_at(rule, vertex, guess, hood, fit);
    }
    for (struct surface_fit part; k / 2 >= LEAST && k > rule->neighbours / 16; k /= 2) {
        if (fit_through(hood, k / 2, vertex, quadric_normal(&fit->q), guess, rule->sigma, &part) <
                0 ||
            !is_better(&part, fit, rule->sigma))
            break;
        *fit = part;
    }
    return k > 0;
}

/* The points lie all around, and no frame shows them much closer to a surface than `fit` does: a
 * rough place. */
static bool frames_are_alike(const struct surface_fit_options *rule, struct vec3 vertex,
                             struct vec3 guess, const struct surface_fit *fit)
{
    const double lean = 0.25, part = 0.8;
    const struct vec3 up[2] = {guess, vec(0, 0, 1)};
    double spacing = point_grid_spacing(rule->point_grid);

    for (int i = 0; i < 2; i++) {
        struct moment_fit m;
        double radius = moment_fit_radius((double)rule->neighbours, spacing, up[i]);
        if (moment_fit_ball(rule->point_grid, vertex, up[i], radius, &m) < 0 || m.lean > lean ||
            m.cubic_spread < part * fit->spread)
            return false;
    }
    return true;
}

/* Where the frame of the few nearest points led nowhere, as on laser lines it may: that of all of
 * them, and straight up. */
static void try_other_frames(const struct surface_fit_options *rule, struct vec3 vertex,
                             struct vec3 guess, struct surface_fit_hood *hood,
                             struct surface_fit *fit)
{
    struct surface_fit other;
    struct vec3 normal[2] = {guess, vec(0, 0, 1)};
    if (frames_are_alike(rule, vertex, guess, fit))
        return;
    gather_hood(rule->point_grid, vertex, rule->neighbours, hood);
    if (fit_steep(hood, hood->n, guess, &other.q) == 0)
        normal[0] = quadric_normal(&other.q);
    for (int i = 0; i < 2; i++)
        if (fit_through(hood, hood->n, vertex, normal[i], guess, rule->sigma, &other) == 0 &&
            other.spread < fit->spread)
            *fit = other;
}

struct surface_fit_hood *surface_fit_hood_new(void)
{
    struct surface_fit_hood *hood = mem_alloc(1, sizeof *hood);

    hood->along = mem_alloc(1, sizeof *hood->along);
    return hood;
}

void surface_fit_hood_free(struct surface_fit_hood *hood)
{
    free(hood->along);
    free(hood);
}

bool surface_fit_holds(const struct surface_fit *fit, double sigma)
{
    const double bent = 2;
    return fit->spread <= bent * sigma;
}

/* ---- along ribs and grooves */

/* Neighbourhoods longer one way: how much, of how many points, which ways are tried about one. */
struct longer {
    double aspect;
    size_t points;
    int tries;   /* to either side ... */
    double step; /* ... by so much, radians */
};

enum { LONGEST = 72 }; /* points of such a neighbourhood at most */

/* What a rib or groove leaves at most, in sigma: else it is a crease.  Where all points alike leave
 * so many times that, none without weight would bring them there. */
static const double SHARP = 1.6, HOPELESS = 2;

/* The surface through a neighbourhood that is longer along one of the directions half a turn has,
 * `step` apart about a middle one: the one that all its points alike are closest to.  False: it
 * fits no better than *fit. */
static bool best_along(const struct surface_fit_options *rule, const struct surface_fit_hood *wide,
                       struct vec3 vertex, struct vec3 guess, const struct longer *longer,
                       double *angle, struct surface_fit *fit)
{
    struct surface_fit_hood *hood = wide->along;
    double least = HOPELESS * SHARP * rule->sigma, best = 0, farthest;
    struct vec3 normal = quadric_normal(&fit->q), u = vec_perpendicular(normal);
    struct vec3 v = vec_cross(normal, u), found[LONGEST];
    struct surface_fit along;
    size_t n = 0;

    for (int i = -longer->tries; i <= longer->tries; i++) {
        double a = *angle + i * longer->step;
        struct vec3 way = vec_along(vec_scale(cos(a), u), sin(a), v);
        hood->n = neighbourhood_along(wide->point, wide->n, vertex, way, longer->aspect,
                                      longer->points, hood->point);
        if (fit_alike(hood, hood->n, vertex, normal, rule->sigma, &along, &farthest) < 0 ||
            along.spread >= least)
            continue;
        least = along.spread;
        best = a;
        n = hood->n;
        memcpy(found, hood->point, n * sizeof *found);
    }
    if (n == 0)
        return false;
    memcpy(hood->point, found, n * sizeof *found);
    if (fit_through(hood, n, vertex, normal, guess, rule->sigma, &along) < 0 ||
        along.spread >= fit->spread || is_useless(&along.q, rule->sigma))
        return false;
    *fit = along;
    *angle = best;
    return true;
}

/* The way in which a surface bends least, from the perpendicular of its normal on, radians. */
static double straight_angle(const struct quadric *q)
{
    double xx = 2 * q->c[3], xy = q->c[4], yy = 2 * q->c[5];
    double turn = 0.5 * atan2(2 * xy, xx - yy) + (xx + yy < 0 ? 0 : PI / 2);
    struct vec3 way = vec_along(vec_scale(cos(turn), q->u), sin(turn), q->v);
    struct vec3 normal = quadric_normal(q), u = vec_perpendicular(normal);

    return atan2(vec_dot(way, vec_cross(normal, u)), vec_dot(way, u));
}

/* The better surface where there is a rib or a groove. */
static void fit_along(const struct surface_fit_options *rule, struct vec3 vertex, struct vec3 guess,
                      struct surface_fit_hood *hood, struct surface_fit *fit)
{
    static const struct longer rough = {3, 36, 1, PI / 9}, fine = {6, LONGEST, 2, PI / 30};
    const double better = 0.85;
    struct surface_fit along = *fit, best;
    double angle = straight_angle(&fit->q);

    gather_hood(rule->point_grid, vertex, (size_t)(rough.aspect * (double)rough.points), hood);
    if (!best_along(rule, hood, vertex, guess, &rough, &angle, &along) ||
        along.spread > better * fit->spread || along.spread > SHARP * rule->sigma)
        return;
    gather_hood(rule->point_grid, vertex, (size_t)(fine.aspect * (double)fine.points), hood);
    best = along;
    best.spread *= 1.1; /* of fewer points and more of them */
    if (best_along(rule, hood, vertex, guess, &fine, &angle, &best))
        along = best;
    if (along.spread < SHARP * rule->sigma)
        *fit = along;
}

/* ---- the first round: one set of sums */

/* What points may be spread about a surface that explains them, in sigma. */
static const double ROUGH = 1.2;

/* The cubic through about k points around the foot of a place, fit->n 0: they carry none.  False:
 * it does not explain them, or they are not all around. */
static bool fit_moments(const struct surface_fit_options *rule, struct vec3 place,
                        struct vec3 guess, size_t k, struct surface_fit *fit)
{
    const double lean = 0.25, narrow = 0.05, far = 4, sigma = rule->sigma;
    double radius = moment_fit_radius((double)k, point_grid_spacing(rule->point_grid), guess);
    struct moment_fit m;
    struct vec3 from = place;

    fit->n = 0;
    if (moment_fit_ball(rule->point_grid, from, guess, radius, &m) < 0)
        return false;
    if (sigma > narrow * radius) { /* points near to one that is off are off to the same side */
        from = quadric_foot(&m.cubic);
        if (vec_distance(from, place) > far * sigma ||
            moment_fit_ball(rule->point_grid, from, quadric_normal(&m.cubic), radius, &m) < 0)
            return false;
    }
    *fit = (struct surface_fit){m.cubic, 0, m.cubic_spread, radius, m.n};
    fit->offset = vec_dot(vec_sub(quadric_foot(&fit->q), place), guess);
    return m.lean < lean && m.cubic_spread <= ROUGH * sigma && !is_useless(&fit->q, sigma);
}

/* A ball of as many points as the rule begins with: where it tells enough and its nearer half
 * agrees, that is the surface, and else one of twice as many.  False: for the second round. */
static bool fit_first(const struct surface_fit_options *rule, struct vec3 place, struct vec3 guess,
                      struct surface_fit *fit)
{
    size_t k = rule->neighbours;
    struct surface_fit other;

    fit->n = 0;
    if (k > MOMENT_FIT_MOST / 2 || !fit_moments(rule, place, guess, k, fit))
        return false;
    if (is_settled(&fit->q, rule->sigma))
        return k / 2 < LEAST || (fit_moments(rule, place, guess, k / 2, &other) &&
                                 surfaces_agree(fit, &other, rule->sigma));
    if (fit_moments(rule, place, guess, 2 * k, &other) && surfaces_agree(&other, fit, rule->sigma))
        *fit = other;
    return true;
}

/* The points are so far off the first round's surface, and those of each cell off a plane, that
 * none is there to be found: that is as good as any. */
static bool has_no_surface(const struct surface_fit_options *rule, struct vec3 place,
                           const struct surface_fit *fit)
{
    const double far = 10; /* in sigma */

    return fit->n > 0 && fit->spread > far * rule->sigma &&
           rough_place(rule->point_grid, place, far * rule->sigma);
}

bool surface_fit_at(const struct surface_fit_options *rule, struct vec3 place, struct vec3 guess,
                    struct surface_fit_hood *hood, struct surface_fit *fit)
{
    const double rough = ROUGH, torn = 8; /* in sigma */
    hood->gathered = hood->steep = 0;     /* of another place */
    if (fit_first(rule, place, guess, fit) || has_no_surface(rule, place, fit))
        return true;
    if (rule->first) {
        fit->spread = INFINITY;
        return fit->n > 0;
    }
    if (!fit_at(rule, place, guess, hood, fit))
        return false;
    if (!surface_fit_holds(fit, rule->sigma) && (rule->along || fit->spread < torn * rule->sigma))
        try_other_frames(rule, place, guess, hood, fit);
    if (rule->along && fit->spread > rough * rule->sigma && fit->spread < torn * rule->sigma &&
        fit->n <= FEW)
        fit_along(rule, place, guess, hood, fit);
    return true;
}

/* ---- how many points most surfaces take */

enum { SAMPLE = 200, FEWEST = 32 };

struct sample {
    const struct surface_fit_options *rule;
    const struct vec3 *place, *guess;
    size_t places, n; /* of them, looked at */
    size_t *widest;
};

static void choose(void *context, size_t from, size_t to)
{
    const struct sample *sample = context;
    struct surface_fit_hood *hood = surface_fit_hood_new();
    for (size_t i = from; i < to; i++) {
        size_t at = i * sample->places / sample->n;
        hood->gathered = hood->steep = 0;
        sample->widest[i] = widest_hood(sample->rule, sample->place[at], sample->guess[at], hood);
    }
    surface_fit_hood_free(hood);
}

static int by_size(const void *a, const void *b)
{
    size_t x = *(const size_t *)a, y = *(const size_t *)b;
    return (x > y) - (x < y);
}

size_t surface_fit_typical(const struct surface_fit_options *rule, const struct vec3 *place,
                           const struct vec3 *guess, size_t n, int threads)
{
    size_t some = n < SAMPLE ? n : SAMPLE;
    struct sample sample = {rule, place, guess, n, some, mem_alloc(some, sizeof(size_t))};
    parallel_for(threads, some, choose, &sample);
    qsort(sample.widest, some, sizeof *sample.widest, by_size);
    size_t typical = some > 0 ? sample.widest[some / 2] : FEWEST;
    free(sample.widest);
    return typical;
}
