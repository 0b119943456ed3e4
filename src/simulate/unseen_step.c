/* unseen_step - see unseen_step.h. */
#include "unseen_step.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "math/quadric.h"

/* Points that are looked at, the nearest of which make planes with the point. */
enum { MOST = UNSEEN_STEP_POINTS, TRIED = 10, FEWEST_LOW = 5, FEWEST_HIGH = 3, STRAY = 1 };

static const double ON = 0.08;   /* spacings: so far off a plane a point is on it */
static const double STEP = 0.3;  /* spacings: the least step */
static const double LEVEL = 1.5; /* of the lowest: so high are points of one upper side */
static const double LEANS = 0.3; /* least z of a plane that steps are seen on */
static const double ASIDE = 0.2; /* of the reach: the middle of the high points is farther off */
static const double AHEAD = 0.9; /* cosine: a low point is on the way to a high one */

bool unseen_step_is_foot(struct vec3 p, const struct vec3 *low, size_t lows,
                         const struct vec3 *high, size_t highs, double reach)
{
    double x = 0, y = 0;

    for (size_t k = 0; k < highs; k++) {
        x += (high[k].x - p.x) / (double)highs;
        y += (high[k].y - p.y) / (double)highs;
    }
    double far = hypot(x, y);
    if (far < ASIDE * reach)
        return false;
    for (size_t k = 0; k < lows; k++) {
        double u = low[k].x - p.x, v = low[k].y - p.y;
        if (x * u + y * v > AHEAD * far * hypot(u, v))
            return false;
    }
    return true;
}

/* A point and how far it is from another as seen from above, squared. */
struct beside {
    struct vec3 p;
    double far2;
};

static int by_distance(const void *pa, const void *pb)
{
    const struct beside *a = pa, *b = pb;

    return a->far2 != b->far2 ? (a->far2 > b->far2) - (a->far2 < b->far2)
                              : vec_compare(&a->p, &b->p);
}

/* The nearest of the points, p itself the first; returns how many, and how far these reach. */
static size_t take_nearest(struct vec3 p, const struct vec3s *near, struct vec3 point[MOST],
                           double *reach)
{
    struct beside *beside = mem_alloc(near->n, sizeof *beside);
    size_t n = near->n < MOST ? near->n : MOST;

    for (size_t k = 0; k < near->n; k++) {
        double x = near->item[k].x - p.x, y = near->item[k].y - p.y;
        beside[k] = (struct beside){near->item[k], x * x + y * y};
    }
    qsort(beside, near->n, sizeof *beside, by_distance);
    for (size_t k = 0; k < n; k++)
        point[k] = beside[k].p;
    *reach = n > 0 ? sqrt(beside[n - 1].far2) : 0;
    free(beside);
    return n;
}

/* A plane through a point, and which of the others are on it. */
struct side {
    struct vec3 at, normal;
};

static double above(const struct side *side, struct vec3 p)
{
    return vec_dot(side->normal, vec_sub(p, side->at));
}

static size_t count_on(const struct side *side, const struct vec3 *point, size_t n, double within)
{
    size_t on = 0;

    for (size_t k = 0; k < n; k++)
        on += fabs(above(side, point[k])) <= within;
    return on;
}

/* Of the planes through the first point and two of the next ones that which most points are on;
 * false: too few are. */
static bool find_side(const struct vec3 *point, size_t n, double within, struct side *side)
{
    size_t tried = n < TRIED ? n : TRIED, most = 0;

    for (size_t a = 1; a < tried; a++)
        for (size_t b = a + 1; b < tried; b++) {
            struct vec3 normal =
                vec_cross(vec_sub(point[a], point[0]), vec_sub(point[b], point[0]));
            double length = vec_length(normal);
            if (!(fabs(normal.z) > LEANS * length))
                continue;
            struct side of = {point[0], vec_scale((normal.z > 0 ? 1 : -1) / length, normal)};
            size_t on = count_on(&of, point, n, within);
            if (on > most) {
                most = on;
                *side = of;
            }
        }
    return most >= FEWEST_LOW;
}

/* The plane of least squares through those on it (all, where `within` is infinite). */
static void settle_side(const struct vec3 *point, size_t n, double within, struct side *side)
{
    struct vec3 on[MOST], mean = vec(0, 0, 0);
    size_t count = 0;

    for (size_t k = 0; k < n; k++)
        if (fabs(above(side, point[k])) <= within)
            on[count++] = point[k];
    struct vec3 normal = plane_normal(on, count);
    for (size_t k = 0; k < count; k++)
        mean = vec_along(mean, 1 / (double)count, on[k]);
    *side = (struct side){mean, normal.z < 0 ? vec_scale(-1, normal) : normal};
}

/* All are within half a step of one plane. */
static bool is_flat(const struct vec3 *point, size_t n, double step)
{
    struct side all = {point[0], vec(0, 0, 1)};

    settle_side(point, n, HUGE_VAL, &all);
    return count_on(&all, point, n, step / 2) == n;
}

/* A bend that comes to all of them. */
static bool is_one_surface(const struct vec3 *point, size_t n, double within)
{
    struct quadric q;

    return quadric_fit_free(point, n, point[0], &q) == 0 &&
           quadric_spread(&q, point, n, 6) < within;
}

/* The lowest of those more than a step above the side. */
static double lowest_above(const struct side *side, const struct vec3 *point, size_t n, double step)
{
    double lowest = HUGE_VAL;

    for (size_t k = 0; k < n; k++)
        if (above(side, point[k]) > step)
            lowest = fmin(lowest, above(side, point[k]));
    return lowest;
}

double unseen_step_over(struct vec3 p, const struct vec3s *near)
{
    struct vec3 point[MOST], low[MOST], high[MOST];
    double reach, sum = 0, top = p.z;
    size_t n = take_nearest(p, near, point, &reach), lows = 0, highs = 0, between = 0;
    double spacing = reach * sqrt(PI / MOST), on = ON * spacing, step = STEP * spacing;
    struct side side;

    if (n < MOST || is_flat(point, n, step) || !find_side(point, n, on, &side))
        return 0;
    settle_side(point, n, on, &side);
    double upper = LEVEL * lowest_above(&side, point, n, step);
    for (size_t k = 0; k < n; k++) {
        double off = above(&side, point[k]);
        if (off > step && off <= upper) {
            high[highs++] = point[k];
            sum += off;
            top = fmax(top, point[k].z);
        } else if (off > on && off <= step) {
            between++;
        } else if (off <= on) {
            low[lows++] = point[k];
        }
    }
    if (highs < FEWEST_HIGH || between > STRAY || is_one_surface(point, n, on) ||
        !unseen_step_is_foot(p, low, lows, high, highs, reach))
        return 0;
    return fmin(sum / (double)highs / side.normal.z, top - p.z);
}
