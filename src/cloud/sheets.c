/* sheets - see sheets.h. */
#include "cloud/sheets.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/parallel.h"
#include "math/quadric.h"

enum { PLACES = 2000, NEAR = 48, FEWEST_PLACES = 3 };
enum { MIDDLE = NEAR / 2, ROUND = 6 }; /* those nearest to the place; to a point */

static const double APART = 4.5;    /* spreads of a group */
static const double PART = 0.25;    /* of the points in each group */
static const double MIXED = 0.75;   /* of the neighbours that would be across by chance */
static const double AS_NEAR = 1.2;  /* times the nearest one's distance */
static const double LEAST = 0.001;  /* of the neighbourhood's radius: less is in printed digits */
static const double UPRIGHT = 0.35; /* least z of the normal */

struct search {
    const struct point_grid *point_grid;
    const unsigned char *out;
    size_t places;
    double *distance; /* at each place; 0: one sheet */
};

/* The split of sorted values whose groups are spread least; returns how many are in the first. */
static size_t best_split(const double *value, size_t n)
{
    double sum = 0, all = 0, best = -1;
    size_t split = 0;

    for (size_t i = 0; i < n; i++)
        all += value[i];
    for (size_t i = 1; i < n; i++) {
        sum += value[i - 1];
        double d = sum / (double)i - (all - sum) / (double)(n - i);
        double between = (double)i * (double)(n - i) * d * d;
        if (between > best) {
            best = between;
            split = i;
        }
    }
    return split;
}

static double mean_of(const double *value, size_t n)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += value[i];
    return sum / (double)n;
}

static double squares_of(const double *value, size_t n)
{
    double mean = mean_of(value, n), sum = 0;
    for (size_t i = 0; i < n; i++)
        sum += (value[i] - mean) * (value[i] - mean);
    return sum;
}

/* Part of the nearest neighbours along the surface that are of the other group; of a lattice's
 * points several are as near, and one of them alone says nothing. */
static double mixed_part(const struct vec3 *point, const bool *upper, size_t n, struct vec3 normal)
{
    double mixed = 0, along[NEAR];

    for (size_t i = 0; i < n; i++) {
        double nearest = HUGE_VAL;
        size_t all = 0, other = 0;
        for (size_t k = 0; k < n; k++) {
            struct vec3 d = vec_sub(point[k], point[i]);
            along[k] = vec_dot(d, d) - vec_dot(d, normal) * vec_dot(d, normal);
            if (k != i)
                nearest = fmin(nearest, along[k]);
        }
        for (size_t k = 0; k < n; k++) {
            bool near = k != i && along[k] <= AS_NEAR * AS_NEAR * nearest;
            all += near;
            other += near && upper[k] != upper[i];
        }
        mixed += (double)other / (double)all;
    }
    return mixed / (double)n;
}

/* Whether the nearest points of the other group, seen along the normal, are round point i, and not
 * to one side of it as at a step. */
static bool is_among(const struct vec3 *point, const bool *upper, size_t i, struct vec3 normal)
{
    struct quadric q = quadric_frame(point[i], normal);
    double turn[NEAR], last = HUGE_VAL, far[ROUND];
    size_t n = 0;

    for (size_t k = 0; k < NEAR; k++) {
        struct vec3 to = quadric_local(&q, point[k]);
        double r = hypot(to.x, to.y);
        if (upper[k] == upper[i] || (n == ROUND && r >= last))
            continue;
        size_t at = n < ROUND ? n++ : ROUND - 1;
        for (; at > 0 && far[at - 1] > r; at--) { // cppcheck-suppress uninitvar
            far[at] = far[at - 1];
            turn[at] = turn[at - 1];
        }
        far[at] = r;
        turn[at] = atan2(to.y, to.x);
        last = far[n - 1];
    }
    doubles_sort(turn, n);
    double widest = n > 0 ? turn[0] + 2 * PI - turn[n - 1] : 2 * PI;
    for (size_t k = 0; k + 1 < n; k++)
        widest = fmax(widest, turn[k + 1] - turn[k]);
    return widest < PI;
}

/* Of the points in the middle of both groups two fifths and more are among the other one. */
static bool are_among(const struct vec3 *point, const bool *upper, struct vec3 normal)
{
    size_t all[2] = {0, 0}, among[2] = {0, 0};

    for (size_t i = 0; i < MIDDLE; i++) {
        all[upper[i]]++;
        among[upper[i]] += is_among(point, upper, i, normal);
    }
    return 5 * among[0] > 2 * all[0] && 5 * among[1] > 2 * all[1];
}

/* The surfaces of both groups do not meet: hardly a point of one is nearer to the other's, as the
 * foot of a rib is to that of the points beside.  *apart, which one surface through both groups
 * makes too little of, is then how far the points of each are off the other's. */
static bool are_parallel(const struct vec3 *point, const bool *upper, struct vec3 normal,
                         double *apart)
{
    const double half = 0.5, most = 0.9;
    double sum = 0;
    struct vec3 group[2][NEAR];
    struct quadric q[2];
    size_t n[2] = {0, 0}, off[2] = {0, 0};

    for (size_t i = 0; i < NEAR; i++)
        group[upper[i]][n[upper[i]]++] = point[i];
    for (int k = 0; k < 2; k++)
        if (quadric_settle(group[k], n[k], group[k][0], normal, &q[k]) < 0)
            return false;
    for (size_t i = 0; i < NEAR; i++) {
        double above = quadric_off(&q[!upper[i]], point[i]);
        off[upper[i]] += (upper[i] ? above : -above) > half * *apart;
        sum += upper[i] ? above : -above;
    }
    *apart = sum / NEAR;
    return (double)off[0] > most * (double)n[0] && (double)off[1] > most * (double)n[1];
}

/* Distance of the two sheets at a place, 0: there is one, or points that count for nothing. */
static double look_at(const struct search *s, struct vec3 place)
{
    const struct point_grid *b = s->point_grid;
    uint32_t index[NEAR];
    double distance2[NEAR], off[NEAR], sorted[NEAR];
    struct vec3 point[NEAR];
    bool upper[NEAR];
    struct quadric q;

    if (point_grid_nearest(b, place, NEAR, index, distance2) < NEAR)
        return 0;
    for (size_t i = 0; i < NEAR; i++) {
        if (s->out && s->out[index[i]])
            return 0;
        point[i] = b->point[index[i]];
    }
    if (quadric_fit_free(point, NEAR, place, &q) < 0)
        return 0;
    struct vec3 normal = quadric_normal(&q);
    if (fabs(normal.z) < UPRIGHT)
        return 0;
    for (size_t i = 0; i < NEAR; i++)
        off[i] = sorted[i] = quadric_off(&q, point[i]);
    doubles_sort(sorted, NEAR);
    size_t n = best_split(sorted, NEAR), rest = NEAR - n;
    if ((double)n < PART * NEAR || (double)rest < PART * NEAR)
        return 0;
    double apart = mean_of(sorted + n, rest) - mean_of(sorted, n);
    double spread = sqrt((squares_of(sorted, n) + squares_of(sorted + n, rest)) / (NEAR - 2));
    if (!(apart > fmax(APART * spread, LEAST * sqrt(distance2[NEAR - 1]))))
        return 0;
    for (size_t i = 0; i < NEAR; i++)
        upper[i] = off[i] >= sorted[n];
    double chance = 2 * (double)n * (double)rest / (double)(NEAR * NEAR);
    if (mixed_part(point, upper, NEAR, normal) < MIXED * chance)
        return 0;
    return are_among(point, upper, normal) && are_parallel(point, upper, normal, &apart) ? apart
                                                                                         : 0;
}

static struct vec3 place_of(const struct search *s, size_t i)
{
    const struct point_grid *b = s->point_grid;
    return b->point[(size_t)(((double)i + 0.5) / (double)s->places * (double)b->n)];
}

static void look_at_places(void *context, size_t from, size_t to)
{
    const struct search *s = context;
    for (size_t i = from; i < to; i++)
        s->distance[i] = look_at(s, place_of(s, i));
}

struct sheets sheets_find(const struct point_grid *point_grid, const unsigned char *out,
                          int threads)
{
    size_t places = point_grid->n < PLACES ? point_grid->n : PLACES;
    struct search s = {point_grid, out, places, mem_alloc(places, sizeof(double))};
    struct sheets sheets = {.looked = places};

    parallel_for(threads, places, look_at_places, &s);
    for (size_t i = 0; i < places; i++)
        if (s.distance[i] > 0) {
            if (s.distance[i] > sheets.widest) {
                sheets.widest = s.distance[i];
                sheets.at = place_of(&s, i);
            }
            s.distance[sheets.places++] = s.distance[i];
        }
    if (sheets.places < FEWEST_PLACES)
        sheets = (struct sheets){.looked = places};
    if (sheets.places > 0) {
        doubles_sort(s.distance, sheets.places);
        sheets.distance = s.distance[sheets.places / 2];
    }
    free(s.distance);
    return sheets;
}
