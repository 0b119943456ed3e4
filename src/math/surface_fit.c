/* surface_fit - see surface_fit.h. */
#include "math/surface_fit.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/cubic.h"

enum { LEAST = 32, FEW = 64, MOST = 362, STEPS = 8, REFITS = 2 };

static const double TUKEY = 4.685; /* in standard deviations: 95 % efficient on normal noise */

void surface_fit_gather(const struct point_grid *b, struct vec3 vertex, size_t k,
                        struct surface_fit_hood *hood)
{
    hood->n = point_grid_nearest(b, vertex, k, hood->index, hood->distance2);
    for (size_t i = 0; i < hood->n; i++)
        hood->point[i] = b->point[hood->index[i]];
}

/* Weights of the first k points; returns their spread about the quadric.  Where it passes a good
 * part of them by it is not theirs: infinite. *farthest: the largest of their distances. */
static double weigh(const struct quadric *q, struct surface_fit_hood *hood, size_t k, double sigma,
                    double *farthest)
{
    const double terms = 6, most = 0.6;
    double sum = 0, sum2 = 0;
    *farthest = 0;
    for (size_t i = 0; i < k; i++) {
        double off = quadric_off(q, hood->point[i]), r = off / (TUKEY * sigma);
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

int surface_fit_through(struct surface_fit_hood *hood, size_t k, struct vec3 vertex,
                        struct vec3 normal, struct vec3 guess, double sigma,
                        struct surface_fit *fit)
{
    const double far = 3.5; /* in sigma */
    struct quadric *q = &fit->q;
    double farthest;
    if (fit_weighted(hood, NULL, k, vertex, normal, sigma, q) < 0)
        return -1;
    fit->n = k;
    fit->spread = weigh(q, hood, k, INFINITY, &farthest);
    for (int i = 0; i < REFITS && farthest > far * sigma; i++) {
        struct quadric next;
        fit->spread = weigh(q, hood, k, fmax(sigma, fit->spread), &farthest);
        if (fit_weighted(hood, hood->weight, k, vertex, quadric_normal(q), sigma, &next) < 0)
            break;
        *q = next;
        fit->spread = weigh(q, hood, k, fmax(sigma, fit->spread), &farthest);
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
            if (quadric_fit_steep(hood->point, some[i], vertex, guess, &fit->q) < 0)
                continue;
            normal = quadric_normal(&fit->q);
        }
        fitted = surface_fit_through(hood, k, vertex, normal, guess, sigma, fit);
    }
    return fitted;
}

/* Do the feet, and the normals, of a wide neighbourhood and of its nearer part differ by no more
 * than noise explains, `times` as much? */
static bool same_foot(const struct surface_fit *wide, const struct surface_fit *part, double sigma,
                      double times)
{
    const double sigmas = 2.5, tilts = 3;
    /* of the difference of nested fits; of a cubic and a quadric, about that of the cubic */
    double variance = fmax(part->q.variance - wide->q.variance, wide->q.variance);
    double tilt = fmax(part->q.tilt - wide->q.tilt, wide->q.tilt);
    double turn = vec_distance(quadric_normal(&wide->q), quadric_normal(&part->q));
    return fabs(wide->offset - part->offset) <= times * sigmas * sigma * sqrt(variance) &&
           turn <= times * tilts * sigma * sqrt(tilt);
}

/* Is the wide neighbourhood spread as its nearer part is? */
static bool same_spread(const struct surface_fit *wide, const struct surface_fit *part,
                        double sigma)
{
    double bent = 1 + 3 / sqrt(2 * (double)wide->n);
    return wide->spread <= bent * fmax(part->spread, sigma);
}

static bool agree(const struct surface_fit *wide, const struct surface_fit *part, double sigma)
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
    surface_fit_gather(rule->point_grid, vertex, some, hood);
    if (fit_to(hood, hood->n, vertex, guess, rule->sigma, &fit) < 0 ||
        is_useless(&fit.q, rule->sigma) || fabs(fit.offset) > far * rule->sigma)
        return vertex;
    return quadric_foot(&fit.q);
}

size_t surface_fit_widest(const struct surface_fit_options *rule, struct vec3 vertex,
                          struct vec3 guess, struct surface_fit_hood *hood)
{
    struct surface_fit fit[STEPS];
    size_t widest = LEAST, n = 0;
    vertex = first_foot(rule, vertex, guess, hood);
    surface_fit_gather(rule->point_grid, vertex, MOST, hood);
    double k = LEAST;
    for (int step = 0; step < STEPS; step++, k *= sqrt(2)) {
        size_t count = (size_t)(k + 0.5);
        if (count > hood->n || fit_to(hood, count, vertex, guess, rule->sigma, &fit[n]) < 0 ||
            is_useless(&fit[n].q, rule->sigma))
            continue;
        for (size_t i = 0; i < n; i++)
            if (!agree(&fit[n], &fit[i], rule->sigma))
                return widest;
        widest = count;
        n++;
    }
    return widest;
}

/* Certain enough to go without more points, where these agree. */
static bool is_settled(const struct quadric *q, double sigma)
{
    return is_certain(q, sigma, 0.35, 0.04);
}

/* The neighbourhood to begin with, wider where it carries no surface or, at a border, an uncertain
 * one.  Returns its size, 0: there is none. */
static size_t begin_at(const struct surface_fit_options *rule, struct vec3 vertex,
                       struct vec3 guess, struct surface_fit_hood *hood, struct surface_fit *fit)
{
    size_t began = 0, most = 4 * rule->neighbours < SURFACE_FIT_WIDEST ? 4 * rule->neighbours
                                                                       : SURFACE_FIT_WIDEST;
    for (size_t k = rule->neighbours; k <= SURFACE_FIT_WIDEST; k *= 2) {
        struct surface_fit wide;
        surface_fit_gather(rule->point_grid, vertex, k, hood);
        if (fit_to(hood, hood->n, vertex, guess, rule->sigma, &wide) == 0) {
            bool useless = began == 0 || is_useless(&fit->q, rule->sigma);
            if (!useless && (k > most || !agree(&wide, fit, rule->sigma)))
                return began;
            *fit = wide;
            began = hood->n;
            if (is_settled(&fit->q, rule->sigma))
                return began;
        }
        if (hood->n < k)
            break;
    }
    return began;
}

/* Is the nearer part the better one?  Where it is uncertain itself that takes more to say. */
static bool is_better(const struct surface_fit *part, const struct surface_fit *fit, double sigma)
{
    double times = is_settled(&part->q, sigma) ? 1 : 2;
    return !is_useless(&part->q, sigma) &&
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
        if (surface_fit_through(hood, k / 2, vertex, quadric_normal(&fit->q), guess, rule->sigma,
                                &part) < 0 ||
            !is_better(&part, fit, rule->sigma))
            break;
        *fit = part;
    }
    return k > 0;
}

/* Where the frame of the few nearest points led nowhere, as on laser lines it may: that of all of
 * them, and straight up. */
static void try_other_frames(const struct surface_fit_options *rule, struct vec3 vertex,
                             struct vec3 guess, struct surface_fit_hood *hood,
                             struct surface_fit *fit)
{
    struct surface_fit other;
    struct vec3 normal[2] = {guess, vec(0, 0, 1)};
    surface_fit_gather(rule->point_grid, vertex, rule->neighbours, hood);
    if (quadric_fit_steep(hood->point, hood->n, vertex, guess, &other.q) == 0)
        normal[0] = quadric_normal(&other.q);
    for (int i = 0; i < 2; i++)
        if (surface_fit_through(hood, hood->n, vertex, normal[i], guess, rule->sigma, &other) ==
                0 &&
            other.spread < fit->spread)
            *fit = other;
}

struct surface_fit_hood *surface_fit_hood_new(void)
{
    return mem_alloc(1, sizeof(struct surface_fit_hood));
}

void surface_fit_hood_free(struct surface_fit_hood *hood)
{
    free(hood);
}

bool surface_fit_useless(const struct surface_fit *fit, double sigma)
{
    return is_useless(&fit->q, sigma);
}

bool surface_fit_holds(const struct surface_fit *fit, double sigma)
{
    const double bent = 2;
    return fit->spread <= bent * sigma;
}

bool surface_fit_at(const struct surface_fit_options *rule, struct vec3 place, struct vec3 guess,
                    struct surface_fit_hood *hood, struct surface_fit *fit)
{
    const double rough = 1.2, torn = 8; /* in sigma */
    if (!fit_at(rule, place, guess, hood, fit))
        return false;
    if (!surface_fit_holds(fit, rule->sigma))
        try_other_frames(rule, place, guess, hood, fit);
    if (rule->along && fit->spread > rough * rule->sigma && fit->spread < torn * rule->sigma &&
        fit->n <= FEW)
        surface_fit_along(rule, place, guess, hood, fit);
    return true;
}
