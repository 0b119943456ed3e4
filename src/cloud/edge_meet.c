/* edge_meet - see edge_steps.h. */
#include "edge_steps.h"

enum { STEPS = 6 };

/* Cosine of two certain flanks' normals where there is no noise: 6 degrees. */
static const double BLUNT = 0.9945;

/* Moves a place to where n flanks meet, n 2 or 3, by Newton's steps of least length; false: they do
 * not meet near to it. */
static bool move_to_meeting(const struct edge_flank *const *flank, int n, double reach,
                            struct vec3 *p)
{
    struct vec3 start = *p, normal[3];
    double h[3], most = 0;

    for (int step = 0; step < STEPS; step++) {
        most = 0;
        for (int k = 0; k < n; k++) {
            h[k] = edge_flank_above(flank[k], *p, &normal[k]);
            most = fmax(most, fabs(h[k]));
        }
        if (most < 1e-7)
            return true;
        if (n == 2) { /* the least move with normal[k] * d = -h[k] */
            double c = vec_dot(normal[0], normal[1]), s2 = 1 - c * c;
            if (s2 < 0.004)
                return false;
            *p = vec_along(*p, (-h[0] + c * h[1]) / s2, normal[0]);
            *p = vec_along(*p, (-h[1] + c * h[0]) / s2, normal[1]);
        } else {
            struct vec3 a = vec_cross(normal[1], normal[2]), b = vec_cross(normal[2], normal[0]),
                        c = vec_cross(normal[0], normal[1]);
            double volume = vec_dot(normal[0], a);
            if (fabs(volume) < 0.02)
                return false;
            struct vec3 d = vec_add(vec_scale(h[0], a), vec_scale(h[1], b));
            *p = vec_along(*p, -1 / volume, vec_along(d, h[2], c));
        }
        if (vec_distance(*p, start) > reach)
            return false;
    }
    return most < 1e-3 * reach;
}

/* Two neighbours on two sides of a convex edge. */
static bool is_edge_between(const struct edge_work *work, size_t i, size_t k)
{
    const struct vec3 *point = work->options->point_grid->point;
    const struct edge_flank *a = &work->flank[i], *b = &work->flank[k];
    double least = edge_within(work, fmax(a->spacing, b->spacing));
    struct vec3 na, nb;

    if (!edge_flank_known(b) || edge_flank_above(a, point[k], &na) > -least ||
        edge_flank_above(b, point[i], &nb) > -least)
        return false;
    edge_flank_above(a, point[i], &na);
    edge_flank_above(b, point[k], &nb);
    bool blunt = !(work->options->noise > 0) && edge_flank_certain(work, a) &&
                 edge_flank_certain(work, b); /* noise looks like such edges */
    return vec_dot(na, nb) < (blunt ? BLUNT : EDGE_SHARP);
}

/* A point is on a flank of one of the neighbours. */
static bool is_on_any(const struct edge_work *work, const struct edge_hood *near, struct vec3 p,
                      double least)
{
    struct vec3 normal;

    for (size_t k = 0; k < near->n; k++) {
        const struct edge_flank *flank = &work->flank[near->index[k]];
        if (flank->valid && fabs(edge_flank_above(flank, p, &normal)) <= least)
            return true;
    }
    return false;
}

/* The edge ends in a hollow with the point's flank, as at the foot of a pyramid: it is above that,
 * where that is certain. */
static bool ends_before(const struct edge_work *work, const struct edge_flank *own, struct vec3 at,
                        double least)
{
    struct vec3 normal;

    return own->valid && edge_flank_certain(work, own) &&
           edge_flank_above(own, at, &normal) > least;
}

/* The points of the scan about a place of an edge bear it out: one of them is near, none is above
 * the edge but in a hollow with it, and each is on one of the two flanks, on a flank of its own, or
 * at a tip on one of others. */
static bool is_borne_out(const struct edge_work *work, const struct edge_hood *near,
                         const struct edge_flank *const *pair, bool tip, double spacing,
                         struct vec3 at)
{
    const struct point_grid *b = work->options->point_grid;
    uint32_t index[EDGE_ABOUT];
    double distance2[EDGE_ABOUT], least = edge_within(work, spacing);
    size_t n = point_grid_nearest(b, at, EDGE_ABOUT, index, distance2);
    struct vec3 normal;

    if (n < EDGE_ABOUT || distance2[0] > EDGE_REACH * EDGE_REACH * spacing * spacing)
        return false;
    for (size_t k = 0; k < n; k++) {
        const struct edge_flank *own = &work->flank[index[k]];
        double h0 = edge_flank_above(pair[0], b->point[index[k]], &normal);
        double h1 = edge_flank_above(pair[1], b->point[index[k]], &normal);
        bool on = fabs(h0) <= 2 * least || fabs(h1) <= 2 * least;
        if (fmax(h0, h1) > 2 * least && distance2[k] < spacing * spacing &&
            !ends_before(work, own, at, least))
            return false;
        if (!on && !own->valid && !(tip && is_on_any(work, near, b->point[index[k]], least)))
            return false;
    }
    return true;
}

/* How far a point is above the higher one of two flanks. */
static double above_pair(const struct edge_flank *const *pair, struct vec3 p)
{
    struct vec3 normal;

    return fmax(edge_flank_above(pair[0], p, &normal), edge_flank_above(pair[1], p, &normal));
}

/* The flank of neighbour k is a third one, that may end the edge of a pair: that of a point on one
 * of the pair is none, nor one that is certain and whose point is above one of them, in a hollow
 * with it. */
static bool is_third(const struct edge_work *work, const struct edge_hood *near,
                     const struct edge_flank *const *pair, size_t k, double least)
{
    const struct edge_flank *other = &work->flank[near->index[k]];
    double h = above_pair(pair, near->point[k]);

    return other->valid && (k < EDGE_MEETING || edge_flank_certain(work, other)) &&
           (h < -least || (h > 2 * least && !edge_flank_certain(work, other)));
}

/* A third flank among those of the neighbours that the place is above; NULL: none. */
static const struct edge_flank *flank_below(const struct edge_work *work,
                                            const struct edge_hood *near,
                                            const struct edge_flank *const *pair, struct vec3 at,
                                            double least)
{
    const struct edge_flank *worst = NULL;
    double most = least;
    struct vec3 normal;

    for (size_t k = 0; k < near->n; k++) {
        const struct edge_flank *other = &work->flank[near->index[k]];
        double h = other->valid ? edge_flank_above(other, at, &normal) : 0;
        if (h > most && is_third(work, near, pair, k, least)) {
            most = h;
            worst = other;
        }
    }
    return worst;
}

/* Moves a place of an edge back to where the edge ends: where its two flanks meet the one of all
 * others that they meet first. */
static bool move_to_tip(const struct edge_work *work, const struct edge_hood *near,
                        const struct edge_flank **meeting, double spacing, struct vec3 *at)
{
    double least = edge_within(work, spacing);

    for (int turn = 0; turn < STEPS && meeting[2]; turn++) {
        if (!move_to_meeting(meeting, 3, EDGE_REACH * spacing, at))
            return false;
        const struct edge_flank *other = flank_below(work, near, meeting, *at, least / 2);
        if (other == meeting[2])
            return false;
        if (!other)
            return true;
        meeting[2] = other;
    }
    return !flank_below(work, near, meeting, *at, least);
}

/* Adds a place of the edge of a pair, or the tip where it ends if the place is beyond that.  True:
 * the edge goes on there. */
static bool add_place(const struct edge_work *work, const struct edge_hood *near,
                      const struct edge_flank *const *pair, double spacing, struct vec3 at,
                      struct vec3s *to)
{
    const struct edge_flank *meeting[3] = {pair[0], pair[1], NULL};
    double least = edge_within(work, spacing) / 2;

    if (!move_to_meeting(meeting, 2, EDGE_REACH * spacing, &at))
        return false;
    meeting[2] = flank_below(work, near, pair, at, least);
    if (meeting[2] && !move_to_tip(work, near, meeting, spacing, &at))
        return false;
    for (size_t k = 0; k < to->n; k++)
        if (vec_distance(at, to->item[k]) < work->options->along / 3)
            return !meeting[2];
    if (!is_borne_out(work, near, pair, meeting[2] != NULL, spacing, at))
        return false;
    *array_push(to) = at;
    return !meeting[2];
}

/* No point of the scan is near, seen from above. */
static bool is_in_gap(const struct edge_work *work, struct vec3 at)
{
    const double wide = 0.75; /* spacings: about one place of six is so far from points anywhere */
    const struct point_grid *scan = work->options->point_grid;
    struct edge_about about = edge_about_place(scan, at, wide * point_grid_spacing(scan));
    size_t k;

    return !edge_about_next(&about, &k);
}

/* The edge between point i and one of its neighbours, three quarters of a spacing to both sides,
 * and on through a gap between points. */
static void add_edge(const struct edge_work *work, const struct edge_hood *near, size_t i, size_t k,
                     struct vec3s *to)
{
    const struct vec3 *point = work->options->point_grid->point;
    const struct edge_flank *pair[2] = {&work->flank[i], &work->flank[k]};
    double spacing = fmax(pair[0]->spacing, pair[1]->spacing);
    struct vec3 at = vec_mix(point[i], point[k], 0.5), normal[2];

    if (!move_to_meeting(pair, 2, EDGE_REACH * spacing, &at) ||
        vec_distance(at, point[i]) > EDGE_REACH * spacing ||
        vec_distance(at, point[k]) > EDGE_REACH * spacing)
        return;
    edge_flank_above(pair[0], at, &normal[0]);
    edge_flank_above(pair[1], at, &normal[1]);
    struct vec3 way = vec_unit(vec_cross(normal[0], normal[1]));
    int steps = (int)ceil(0.75 * spacing / work->options->along);
    double step = 0.75 * spacing / steps;
    for (int s = -steps; s <= steps; s++)
        add_place(work, near, pair, spacing, vec_along(at, step * s, way), to);
    bool certain = edge_flank_certain(work, pair[0]) && edge_flank_certain(work, pair[1]);
    for (int side = -1; side <= 1 && certain; side += 2)
        for (int s = steps + 1; s * step <= EDGE_REACH * spacing; s++) {
            struct vec3 p = vec_along(at, side * step * s, way);
            if (!is_in_gap(work, p) || !add_place(work, near, pair, spacing, p, to))
                break;
        }
}

void edge_meet_add(const struct edge_work *work, const struct edge_hood *near, size_t i,
                   struct vec3s *to)
{
    for (size_t k = 1; k < EDGE_MEETING; k++)
        if (near->index[k] > i && work->flank[near->index[k]].valid &&
            is_edge_between(work, i, near->index[k]))
            add_edge(work, near, i, near->index[k], to);
}

void edge_meet_across(const struct edge_work *work, size_t i, const struct sizes *across,
                      struct vec3s *to)
{
    struct edge_hood near = {.n = 0};

    for (size_t k = 0; k < across->n; k++) {
        if (!is_edge_between(work, i, across->item[k]))
            continue;
        if (near.n == 0)
            edge_hood_find(work, i, &near);
        if (near.n == EDGE_NEAR)
            add_edge(work, &near, i, across->item[k], to);
    }
}
