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

struct walk {
    struct polyline b;
    double limit, slack;
    double reached; /* largest distance of a point so far: below the truth */
    double bound;   /* above the truth, of what has been looked at so far */
};

static double segment_length(struct polyline b, size_t j)
{
    return vec_distance(b.point[j], b.point[j + 1]);
}

static struct foot on_segment(struct polyline b, size_t j, struct vec3 q)
{
    if (b.n < 2)
        return (struct foot){0, 0, vec_distance(q, b.point[0])};
    struct vec3 d = vec_sub(b.point[j + 1], b.point[j]), e = vec_sub(q, b.point[j]);
    double t = vec_segment_foot(b.point[j], b.point[j + 1], q);

    return (struct foot){j, t, vec_length(vec_along(e, -t, d))};
}

/* Certainly, told without a root or a quotient: the piece is farther from q than `distance`. */
static inline bool is_farther(struct polyline b, size_t j, struct vec3 q, double distance)
{
    const double surely = 1 + 1e-9;
    struct vec3 d = vec_sub(b.point[j + 1], b.point[j]), e = vec_sub(q, b.point[j]);
    double d2 = vec_dot(d, d), e2 = vec_dot(e, e), along = vec_dot(d, e);
    double most = surely * distance * distance;

    if (along <= 0)
        return e2 > most;
    if (along < d2)
        return (e2 - most) * d2 > surely * along * along;
    e = vec_sub(e, d);
    return vec_dot(e, e) > most;
}

static double distance_squared(struct polyline b, size_t segment, struct vec3 q)
{
    struct vec3 d = vec_sub(q, vec_segment_nearest(b.point[segment], b.point[segment + 1], q));
    return vec_dot(d, d);
}

double polyline_descend(struct polyline b, struct vec3 q, size_t *segment)
{
    double here = distance_squared(b, *segment, q);
    size_t best = *segment;
    for (size_t i = *segment + 1; i + 1 < b.n; i++) {
        double d = distance_squared(b, i, q);
        if (d > here)
            break;
        best = d < here ? i : best;
        here = d;
    }
    for (size_t i = *segment; i-- > 0;) {
        double d = distance_squared(b, i, q);
        if (d > here)
            break;
        best = d < here ? i : best;
        here = d;
    }
    *segment = best;
    return sqrt(here);
}

struct foot polyline_foot(struct polyline b, struct foot from, double step, struct vec3 q)
{
    struct foot best = on_segment(b, from.segment, q);
    if (b.n < 2)
        return best;
    double reach = step + from.distance, length = segment_length(b, from.segment);

    double way = (1 - from.t) * length;
    for (size_t j = from.segment + 1; j + 1 < b.n; j++) {
        if (way > 1.5 * (reach + best.distance))
            break;
        if (!is_farther(b, j, q, best.distance)) {
            struct foot f = on_segment(b, j, q);
            if (f.distance <= best.distance)
                best = f;
        }
        way += segment_length(b, j);
    }
    way = from.t * length;
    for (size_t j = from.segment; j-- > 0;) {
        if (way > 1.5 * (reach + best.distance))
            break;
        if (!is_farther(b, j, q, best.distance)) {
            struct foot f = on_segment(b, j, q);
            if (f.distance < best.distance)
                best = f;
        }
        way += segment_length(b, j);
    }
    return best;
}

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
    bound = fmin(bound, fmax(fp.distance, on_segment(w->b, fp.segment, q).distance));
    if (is_known(w, bound))
        return;
    bound = fmin(bound, fmax(fq.distance, on_segment(w->b, fq.segment, p).distance));
    if (bound <= w->reached + w->slack || length < w->slack) {
        w->bound = fmax(w->bound, bound);
        return;
    }
    struct vec3 middle = vec_mix(p, q, 0.5);
    struct foot fm = polyline_foot(w->b, fp, length / 2, middle);
    record_distance(w, fm.distance);
    measure_between(w, p, fp, middle, fm);
    measure_between(w, middle, fm, q, fq);
}

double polyline_distance(struct polyline a, struct polyline b, double limit, double slack,
                         struct foot *foot)
{
    struct walk w = {b, limit, slack, 0, 0};
    struct foot before = {0, 0, vec_distance(a.point[0], b.point[0])};

    before = polyline_foot(b, before, 0, a.point[0]);
    record_distance(&w, before.distance);
    if (foot != NULL)
        foot[0] = before;
    for (size_t i = 1; i < a.n && w.reached <= limit; i++) {
        double step = vec_distance(a.point[i - 1], a.point[i]);
        struct foot here = polyline_foot(b, before, step, a.point[i]);
        record_distance(&w, here.distance);
        measure_between(&w, a.point[i - 1], before, a.point[i], here);
        before = here;
        if (foot != NULL)
            foot[i] = here;
    }
    return w.bound;
}
