/*
 * polyline_boxes - a foot point by boxes around many pieces of a polyline: where it goes round and
 * round in one spot, or stays there, all of them may be near.  And what the walk along the pieces
 * has in common with that.
 */
#ifndef CLOUDMILL_POLYLINE_BOXES_H
#define CLOUDMILL_POLYLINE_BOXES_H

#include <stdbool.h>

#include "curve/polyline.h"

static inline double polyline_piece_length(struct polyline b, size_t j)
{
    return vec_distance(b.point[j], b.point[j + 1]);
}

/* Piece j has no length: it stays where it is. */
static inline bool polyline_stays(struct polyline b, size_t j)
{
    return vec_compare(&b.point[j], &b.point[j + 1]) == 0;
}

/* The foot of q on piece j. */
static inline struct foot polyline_on_piece(struct polyline b, size_t j, struct vec3 q)
{
    if (b.n < 2)
        return (struct foot){0, 0, vec_distance(q, b.point[0])};
    struct vec3 d = vec_sub(b.point[j + 1], b.point[j]), e = vec_sub(q, b.point[j]);
    double t = vec_segment_foot(b.point[j], b.point[j + 1], q);

    return (struct foot){j, t, vec_length(vec_along(e, -t, d))};
}

/* Certainly, told without a root or a quotient: the piece is farther from q than `distance`. */
static inline bool polyline_is_farther(struct polyline b, size_t j, struct vec3 q, double distance)
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

/* So far along the polyline a foot may have come when the nearest so far is at this distance. */
static inline double polyline_farthest(double reach, double distance)
{
    return 1.5 * (reach + distance);
}

struct polyline_boxes;

struct polyline_boxes *polyline_boxes_new(struct polyline b);
void polyline_boxes_free(struct polyline_boxes *boxes);

/* polyline_foot with a reach; of several feet as near the last one. */
struct foot polyline_boxes_foot(const struct polyline_boxes *boxes, struct foot from, double reach,
                                struct vec3 q);

#endif
