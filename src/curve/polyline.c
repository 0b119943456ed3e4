/*
 * polyline - foot points followed along a chain, and bounds between them.
 *
 * The distance to one straight piece is a convex function along another, so that its largest value
 * is at an end: as long as both ends of a piece of `a` have their feet on the same piece of `b`,
 * nothing between is further away.  Where they have not, the piece is bounded by either of the two
 * pieces of `b`, by the distance being no steeper than 1, or is halved.
 */
#include "curve/polyline.h"

#include <stdbool.h>

#include "polyline_boxes.h"

enum {
    STAY = 8,   /* pieces without length in a row that are worth to be known */
    SHORT = 16, /* pieces of a walk that nobody counts */
    OFTEN = 8,  /* times that all pieces are walked, before boxes are made */
};

struct walk {
    struct polyline_feet b;
    double limit, slack;
    double reached; /* largest distance of a point so far: below the truth */
    double bound;   /* above the truth, of what has been looked at so far */
};

static double distance_squared(struct polyline b, size_t segment, struct vec3 q)
{
    struct vec3 d = vec_sub(q, vec_segment_nearest(b.point[segment], b.point[segment + 1], q));
    return vec_dot(d, d);
}

void polyline_find_stays(struct polyline b, struct stays *stays)
{
    for (size_t first = 0, last; first < b.n; first = last + 1) {
        for (last = first; last + 1 < b.n && polyline_stays(b, last); last++) {
        }
        if (last - first >= STAY)
            *array_push(stays) = (struct stay){first, last};
    }
}

/* The stay that piece i is part of; NULL: none. */
static const struct stay *stay_at(const struct stays *stays, size_t i)
{
    size_t lo = 0, hi = stays->n;

    while (lo < hi) {
        size_t middle = (lo + hi) / 2;
        if (stays->item[middle].last <= i)
            lo = middle + 1;
        else
            hi = middle;
    }
    return lo < stays->n && stays->item[lo].first <= i ? &stays->item[lo] : NULL;
}

size_t polyline_stay_end(const struct stays *stays, size_t i)
{
    const struct stay *stay = stays->n > 0 ? stay_at(stays, i) : NULL;

    return stay ? stay->last : i;
}

/* Of the pieces of a stay, which are all as far away, the last in a direction in the place of
 * piece i. */
static size_t past_stay(const struct stays *stays, size_t i, bool onwards)
{
    const struct stay *stay = stay_at(stays, i);

    return !stay ? i : onwards ? stay->last - 1 : stay->first;
}

double polyline_descend(struct polyline b, const struct stays *stays, struct vec3 q,
                        size_t *segment)
{
    double here = distance_squared(b, *segment, q);
    size_t best = *segment;
    for (size_t i = *segment + 1; i + 1 < b.n; i++) {
        double d = distance_squared(b, i, q);
        if (d > here)
            break;
        best = d < here ? i : best;
        i = d < here ? i : past_stay(stays, i, true);
        here = d;
    }
    for (size_t i = *segment; i-- > 0;) {
        double d = distance_squared(b, i, q);
        if (d > here)
            break;
        best = d < here ? i : best;
        i = d < here ? i : past_stay(stays, i, false);
        here = d;
    }
    *segment = best;
    return sqrt(here);
}

/* ---- foot points */

struct polyline_feet polyline_feet_on(struct polyline b)
{
    return (struct polyline_feet){.b = b};
}

void polyline_feet_free(struct polyline_feet *feet)
{
    polyline_boxes_free(feet->boxes);
    *feet = (struct polyline_feet){.b = feet->b};
}

/* The foot on piece j in the place of the one that is farther, or, looking back, as far. */
static void take_nearer(struct polyline b, size_t j, struct vec3 q, bool onwards, struct foot *best)
{
    if (polyline_is_farther(b, j, q, best->distance))
        return;
    struct foot f = polyline_on_piece(b, j, q);
    if (f.distance < best->distance || (onwards && f.distance <= best->distance))
        *best = f;
}

/* Counts the pieces of a walk, if they are many. */
static void count_walk(struct polyline_feet *feet, size_t pieces)
{
    feet->walked += pieces > SHORT ? pieces : 0;
}

static struct foot walk_to_foot(struct polyline_feet *feet, struct foot from, double reach,
                                struct vec3 q)
{
    struct polyline b = feet->b;
    struct foot best = polyline_on_piece(b, from.segment, q);
    double length = polyline_piece_length(b, from.segment), way = (1 - from.t) * length;
    size_t j;

    for (j = from.segment + 1; j + 1 < b.n && !(way > polyline_farthest(reach, best.distance));
         j++) {
        take_nearer(b, j, q, true, &best);
        way += polyline_piece_length(b, j);
    }
    count_walk(feet, j - from.segment);
    way = from.t * length;
    for (j = from.segment; j > 0 && !(way > polyline_farthest(reach, best.distance)); j--) {
        take_nearer(b, j - 1, q, false, &best);
        way += polyline_piece_length(b, j - 1);
    }
    count_walk(feet, from.segment - j);
    return best;
}

struct foot polyline_foot(struct polyline_feet *feet, struct foot from, double step, struct vec3 q)
{
    double reach = step + from.distance;

    if (feet->b.n < 2)
        return polyline_on_piece(feet->b, 0, q);
    if (feet->boxes)
        return polyline_boxes_foot(feet->boxes, from, reach, q);
    struct foot foot = walk_to_foot(feet, from, reach, q);
    if (feet->walked / OFTEN > feet->b.n)
        feet->boxes = polyline_boxes_new(feet->b);
    return foot;
}

/* ---- the largest distance */

/* Nothing new: within what is known, and near enough. */
static bool is_known(const struct walk *w, double bound)
{
    return bound <= w->bound && bound <= w->reached + w->slack;
}

static void record_distance(struct walk *w, double distance)
{
    w->reached = fmax(w->reached, distance);
    w->bound = fmax(w->bound, distance);
}

/* Takes into account the piece from p to q, whose ends have been. */
static void measure_between(struct walk *w, struct vec3 p, struct foot fp, struct vec3 q,
                            struct foot fq)
{
    if (fp.segment == fq.segment || w->reached > w->limit)
        return;
    double length = vec_distance(p, q);
    double bound = (fp.distance + fq.distance + length) / 2;
    if (is_known(w, bound))
        return;
    bound = fmin(bound, fmax(fp.distance, polyline_on_piece(w->b.b, fp.segment, q).distance));
    if (is_known(w, bound))
        return;
    bound = fmin(bound, fmax(fq.distance, polyline_on_piece(w->b.b, fq.segment, p).distance));
    if (bound <= w->reached + w->slack || length < w->slack) {
        w->bound = fmax(w->bound, bound);
        return;
    }
    struct vec3 middle = vec_mix(p, q, 0.5);
    struct foot fm = polyline_foot(&w->b, fp, length / 2, middle);
    record_distance(w, fm.distance);
    measure_between(w, p, fp, middle, fm);
    measure_between(w, middle, fm, q, fq);
}

double polyline_distance(struct polyline a, struct polyline b, double limit, double slack,
                         struct foot *foot)
{
    struct walk w = {polyline_feet_on(b), limit, slack, 0, 0};
    struct foot before = {0, 0, vec_distance(a.point[0], b.point[0])};

    before = polyline_foot(&w.b, before, 0, a.point[0]);
    record_distance(&w, before.distance);
    if (foot != NULL)
        foot[0] = before;
    for (size_t i = 1; i < a.n && w.reached <= limit; i++) {
        double step = vec_distance(a.point[i - 1], a.point[i]);
        struct foot here = polyline_foot(&w.b, before, step, a.point[i]);
        record_distance(&w, here.distance);
        measure_between(&w, a.point[i - 1], before, a.point[i], here);
        before = here;
        if (foot != NULL)
            foot[i] = here;
    }
    polyline_feet_free(&w.b);
    return w.bound;
}
