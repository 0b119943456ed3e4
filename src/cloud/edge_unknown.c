/* edge_unknown - see edge_steps.h. */
#include "edge_steps.h"

/* Cosine of 120 degrees: the sides of an edge make less. */
static const double SHARPER = -0.5;

/* In spacings: neighbours that are sides of an edge, no nearer and no farther; places before the
 * point; neighbours that may stand in front of it. */
static const double APART = 0.5, BESIDE = 2, AHEAD = 1.5, ABOUT = 3;

/* Seen from above the sides lie more than 105 degrees apart: at the foot of a wall they do not. */
static const double OPPOSITE = -0.25;

/* Of its way: no neighbour is so far in front of the highest point. */
static const double FRONT = 0.1;

/* Its surface is known, or it is guarded as the points below let it be. */
static bool is_explained(const struct edge_work *work, size_t i)
{
    return work->gap[i] > 0 || edge_flank_certain(work, &work->flank[i]);
}

/* A place that an edge was found at, or that is on a cone, lies in front of the point, or no
 * further behind it than it may be off its surface. */
static bool has_place(const struct edge_work *work, const struct edge_hood *near, struct vec3 front)
{
    double reach = AHEAD * near->spacing, behind = edge_within(work, near->spacing);

    for (size_t k = 0; k < near->n; k++) {
        const struct vec3s *lists[] = {&work->found[near->index[k]],
                                       &work->between[near->index[k]]};
        for (int list = 0; list < 2; list++)
            for (size_t e = 0; e < lists[list]->n; e++) {
                struct vec3 to = vec_sub(lists[list]->item[e], near->point[0]);
                if (vec_dot(to, to) < reach * reach && vec_dot(to, front) > -behind)
                    return true;
            }
    }
    return false;
}

/* No neighbour stands in front of the point. */
static bool is_foremost(const struct edge_hood *near, struct vec3 front)
{
    double reach = ABOUT * near->spacing;

    for (size_t k = 1; k < near->n && near->distance2[k] < reach * reach; k++)
        if (vec_dot(front, vec_sub(near->point[k], near->point[0])) >
            FRONT * sqrt(near->distance2[k]))
            return false;
    return true;
}

/* How far in front the line from a on through the point goes until it is over b. */
static double goes_on(struct vec3 a, struct vec3 b, struct vec3 front)
{
    double level = hypot(a.x, a.y);

    return level > 0 ? fmax(0, -vec_dot(front, a) * hypot(b.x, b.y) / level) : vec_length(b);
}

/* The scan ends beside the point: seen from above three of eight sectors beside each other have no
 * neighbour. */
static bool is_at_border(const struct edge_hood *near)
{
    enum { SECTORS = 8, EMPTY = 3 };
    unsigned has = 0;

    for (size_t k = 1; k < near->n; k++) {
        double x = near->point[k].x - near->point[0].x, y = near->point[k].y - near->point[0].y;
        has |= 1u << (unsigned)((atan2(y, x) + PI) / (2 * PI) * SECTORS) % SECTORS;
    }
    for (unsigned k = 0; k < SECTORS; k++) {
        unsigned twice = has | has << SECTORS;
        if ((twice >> k & ((1u << EMPTY) - 1)) == 0)
            return true;
    }
    return false;
}

bool edge_on_known(const struct edge_work *work, size_t i)
{
    enum { MANY = 4 * EDGE_NEAR };
    const struct point_grid *b = work->options->point_grid;
    uint32_t index[MANY];
    double distance2[MANY];
    size_t n = point_grid_nearest(b, b->point[i], MANY, index, distance2), known = 0;

    for (size_t k = 0; k < n; k++)
        known += edge_flank_certain(work, &work->flank[index[k]]);
    return 3 * known > n;
}

/* The sides a and b of the point are those of an edge. */
static bool is_edge(struct vec3 a, struct vec3 b)
{
    return vec_dot(vec_unit(a), vec_unit(b)) > SHARPER &&
           a.x * b.x + a.y * b.y < OPPOSITE * hypot(a.x, a.y) * hypot(b.x, b.y);
}

double edge_unknown_depth(const struct edge_work *work, size_t i)
{
    struct edge_hood near;
    double most = 0;

    if (is_explained(work, i))
        return 0;
    edge_hood_find(work, i, &near);
    double least = APART * near.spacing, reach = BESIDE * near.spacing;
    if (!edge_on_known(work, i) || is_at_border(&near))
        return 0;
    for (size_t j = 1; j < near.n && near.distance2[j] < reach * reach; j++)
        for (size_t k = j + 1; k < near.n && near.distance2[k] < reach * reach; k++) {
            struct vec3 a = vec_sub(near.point[j], near.point[0]);
            struct vec3 b = vec_sub(near.point[k], near.point[0]);
            if (near.distance2[j] < least * least || !is_edge(a, b))
                continue;
            struct vec3 front = vec_unit(vec_scale(-1, vec_add(vec_unit(a), vec_unit(b))));
            double depth = fmax(goes_on(a, b, front), goes_on(b, a, front));
            if (front.z > 0 && depth > most && is_foremost(&near, front) &&
                !has_place(work, &near, front))
                most = depth;
        }
    return most;
}

bool edge_unknown_counts(const struct edge_work *work, size_t i)
{
    struct edge_hood near;

    edge_hood_find(work, i, &near);
    for (size_t k = 1; k < near.n; k++)
        if (work->unknown[near.index[k]] > 0)
            return true;
    return false;
}
