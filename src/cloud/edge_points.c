/* edge_points - see edge_points.h. */
#include "cloud/edge_points.h"

#include <stdbool.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/parallel.h"
#include "cloud/scan_lines.h"
#include "cone_tip.h"
#include "math/cubic.h"
#include "math/plane_fit.h"
#include "math/side_fit.h"

/* Neighbours; those that a smooth surface goes through; those that planes are tried through; those
 * whose flanks may meet the point's. */
enum {
    NEAR = 40,
    SMOOTH = 24,
    LINED = 36, /* the same on scan lines: on five of them */
    TRIED = 12,
    MEETING = 16,
    FEWEST = 6,
    ABOUT = 8,
    STEPS = 6,
    RINGS = 8
};

/* In spacings: a surface off its points by less is smooth or a flank; so far beyond the points an
 * edge may be; so narrow a flank is none; a point so far from all others is on none of theirs. */
static const double EVEN = 0.012, FLAT = 0.02, BENT = 0.015, REACH = 2.8, NARROW = 0.25, APART = 2,
                    LONE = 1, /* in cells of the grid */
    LINES = 3;                /* the most that lines are taken to be apart */

static const double SIGMAS = 3;
static const double SHARP = 0.94; /* cosine of two flanks' normals: 20 degrees */
static const double UPRIGHT = 0.004;
/* A point so far below a flank, by its distance, is down a wall; where the other side is known,
 * too, and lies as far below: down a step. */
static const double WALL = 0.9, STEP = 0.1;
static const double FACING = 0.35; /* least z of a flank that is continued over its wall */

/* The surface of a point's own side. */
struct flank {
    bool bent, rough; /* the neighbourhood is no one quadric; nor a cubic */
    bool valid;       /* it has a flank */
    bool confirmed;   /* by those of its neighbours */
    double spacing, rms;
    struct quadric q; /* if valid, or of the neighbourhood */
};

struct edge_work {
    const struct edge_points_options *options;
    bool lines; /* the scan is on lines, far apart against the points on them */
    bool wide;  /* neighbours on many of them are looked at, or those on few */
    struct flank *flank, *chosen;
    struct vec3s *found;   /* places of edges, of each point */
    struct vec3s *between; /* and of its flank */
    double *gap;           /* so far its flank goes on to points below; 0: it does not */
};

struct hood {
    size_t n;
    double spacing; /* of the points about, mm */
    uint32_t index[NEAR];
    double distance2[NEAR];
    struct vec3 point[NEAR];
};

/* How far the scan lines about a place are apart: so many mean spacings as the nearest points are
 * nearer. */
static double line_distance(const double *distance2, double spacing)
{
    enum { NEXT = 4 }; /* two to each side on the line */

    return spacing * spacing / fmax(sqrt(distance2[NEXT]) / 2, spacing / LINES);
}

/* Of MANY nearest points those that are not too near to each other: no denser along lines than a
 * half of the mean spacing, or `wide`, than a good half of what the lines are apart, and so on more
 * lines than the nearest alone.  Through the nearest alone, on three lines, a smooth surface goes
 * whatever is between; but across a narrow flank only many on a line tell of it. */
static void thin_hood(const struct point_grid *b, size_t i, bool wide, struct hood *near)
{
    enum { MANY = 8 * NEAR };
    const double half = 0.5, good_half = 0.7;
    uint32_t index[MANY];
    double distance2[MANY];
    size_t n = point_grid_nearest(b, b->point[i], wide ? MANY : MANY / 2, index, distance2);

    near->n = 0;
    near->spacing = n >= NEAR ? sqrt(PI * distance2[NEAR - 1] / NEAR) : 0;
    if (n < NEAR)
        return;
    double least =
        wide ? good_half * line_distance(distance2, near->spacing) : half * near->spacing;
    for (size_t k = 0; k < n && near->n < NEAR; k++) {
        struct vec3 p = b->point[index[k]];
        bool apart_from_all = true;
        for (size_t j = 0; j < near->n && apart_from_all; j++) {
            struct vec3 to = vec_sub(p, near->point[j]);
            apart_from_all = vec_dot(to, to) >= least * least;
        }
        if (!apart_from_all)
            continue;
        near->index[near->n] = index[k];
        near->distance2[near->n] = distance2[k];
        near->point[near->n++] = p;
    }
}

static void find_hood(const struct edge_work *work, size_t i, struct hood *near)
{
    const struct point_grid *b = work->options->point_grid;

    if (work->lines) {
        thin_hood(b, i, work->wide, near);
        return;
    }
    near->n = point_grid_nearest(b, b->point[i], NEAR, near->index, near->distance2);
    for (size_t k = 0; k < near->n; k++)
        near->point[k] = b->point[near->index[k]];
    near->spacing = near->n >= NEAR ? sqrt(PI * near->distance2[NEAR - 1] / NEAR) : 0;
}

/* The normal of a flank below or above a place, and how far that is above the flank. */
static double above(const struct flank *flank, struct vec3 p, struct vec3 *normal)
{
    struct vec3 foot = quadric_nearest(&flank->q, p);

    *normal = quadric_normal_at(&flank->q, foot);
    return vec_dot(*normal, vec_sub(p, foot));
}

/* A surface of its own is known of the point: a flank, or one of all its neighbours. */
static bool has_surface(const struct flank *flank)
{
    return flank->valid || (!flank->rough && flank->spacing > 0);
}

/* Points of a surface may be off it by this. */
static double within(const struct edge_work *work, double spacing)
{
    return SIGMAS * work->options->noise + FLAT * spacing;
}

/* ---- flanks */

/* How far points may be off their surface on average. */
static double even(const struct edge_work *work, double spacing)
{
    return fmax(1.4 * work->options->noise, EVEN * spacing);
}

static bool is_smooth(const struct edge_work *work, const struct hood *near, double spacing,
                      struct quadric *q, double *rms, bool *bent)
{
    double least = even(work, spacing);
    size_t some = work->lines ? LINED : SMOOTH;
    struct quadric cubic;

    *bent = true;
    if (quadric_fit_free(near->point, some, near->point[0], q) != 0)
        return false;
    *rms = quadric_spread(q, near->point, some, 6);
    *bent = *rms > least;
    if (!*bent)
        return true;
    if (cubic_fit(near->point, NULL, some, near->point[0], quadric_normal(q), &cubic) != 0)
        return false;
    double less = quadric_spread(&cubic, near->point, some, 10);
    if (less > least)
        return false;
    *q = cubic;
    *rms = less;
    return true;
}

/* How far a point so far away may be off a plane that its flank touches. */
static double allowed(const struct edge_work *work, double spacing, double distance2)
{
    return SIGMAS * work->options->noise + FLAT * spacing + BENT * distance2 / spacing;
}

/* How many neighbours lie on the plane, each the less the further off it is (Torr and Zisserman's
 * MSAC, 2000). */
static double weigh_plane(const struct edge_work *work, const struct hood *near, double spacing,
                          struct vec3 normal)
{
    double on = 0;

    for (size_t k = 0; k < near->n; k++) {
        double off = vec_dot(normal, vec_sub(near->point[k], near->point[0]));
        double part = off / allowed(work, spacing, near->distance2[k]);
        on += fmax(0, 1 - part * part);
    }
    return on;
}

/* The plane through the point and two neighbours that most of them lie on; false: there is none. */
static bool find_plane(const struct edge_work *work, const struct hood *near, double spacing,
                       struct vec3 *normal)
{
    const double skew = 0.3; /* sine of the angle between the two */
    double most = 0;

    for (size_t a = 1; a < TRIED; a++)
        for (size_t b = a + 1; b < TRIED; b++) {
            struct vec3 to_a = vec_sub(near->point[a], near->point[0]);
            struct vec3 to_b = vec_sub(near->point[b], near->point[0]);
            struct vec3 across = vec_cross(to_a, to_b);
            double l = vec_length(across);
            if (!(l > skew * sqrt(near->distance2[a] * near->distance2[b])))
                continue;
            double on = weigh_plane(work, near, spacing, vec_scale(1 / l, across));
            if (on > most) {
                most = on;
                *normal = vec_scale(1 / l, across);
            }
        }
    return most >= FEWEST;
}

/* Gathers the neighbours on the surface, `bend` by how much more with their distance. */
static size_t gather_on(const struct edge_work *work, const struct hood *near, double spacing,
                        const struct quadric *q, double bend, struct vec3 *on)
{
    size_t n = 0;

    for (size_t k = 0; k < near->n; k++) {
        double least =
            SIGMAS * work->options->noise + FLAT * spacing + bend * near->distance2[k] / spacing;
        if (fabs(quadric_off(q, near->point[k])) <= least)
            on[n++] = near->point[k];
    }
    return n;
}

static bool fit_side(const struct vec3 *on, size_t n, struct vec3 origin, double spacing,
                     struct side_fit *fit)
{
    struct plane_fit plane;

    if (n < FEWEST || plane_fit(on, n, &plane) < 0 || plane.width < NARROW * spacing ||
        side_fit_plane(on, n, origin, plane.normal, fit) < 0)
        return false;
    if (n >= 2 * FEWEST)
        side_fit_bend(on, n, fit);
    return true;
}

/* The surface of most neighbours on one plane through the point: `own`, and the point itself. */
static bool fit_flank(const struct edge_work *work, const struct hood *near, double spacing,
                      bool own, struct side_fit *fit)
{
    const size_t many = 9;
    struct vec3 on[NEAR], normal;
    double noise = work->options->noise;

    if (!find_plane(work, near, spacing, &normal))
        return false;
    struct quadric q = quadric_frame(near->point[0], normal);
    size_t n = gather_on(work, near, spacing, &q, 0, on);
    if (n < many)
        n = gather_on(work, near, spacing, &q, BENT, on);
    if (!fit_side(on, n, near->point[0], spacing, fit))
        return false;
    n = gather_on(work, near, spacing, &fit->q, 0, on);
    for (size_t k = 0, others = 0; !own && k < near->n; k++) {
        if (k < n && vec_distance(on[k], near->point[0]) > 0)
            on[others++] = on[k];
        if (k + 1 == near->n)
            n = others;
    }
    return fit_side(on, n, near->point[0], spacing, fit) &&
           fit->rms <= 1.5 * noise + FLAT * spacing &&
           fabs(quadric_off(&fit->q, near->point[0])) <= SIGMAS * noise + FLAT * spacing;
}

static void find_flank(const struct edge_work *work, const struct hood *near, struct flank *flank)
{
    struct side_fit fit;

    if (!fit_flank(work, near, flank->spacing, true, &fit))
        return;
    flank->q = fit.q;
    flank->rms = fit.rms;
    quadric_face_up(&flank->q);
    flank->valid = quadric_normal(&flank->q).z > UPRIGHT;
}

static void find_flanks(void *context, size_t from, size_t to)
{
    const struct edge_work *work = context;
    struct hood near;

    for (size_t i = from; i < to; i++) {
        struct flank *flank = &work->flank[i];
        find_hood(work, i, &near);
        if (near.n < NEAR)
            continue;
        flank->spacing = near.spacing;
        flank->rough =
            !is_smooth(work, &near, flank->spacing, &flank->q, &flank->rms, &flank->bent);
        if (flank->rough)
            find_flank(work, &near, flank);
        else
            quadric_face_up(&flank->q);
    }
}

/* Those that were not confirmed, from other neighbours. */
static void find_flanks_again(void *context, size_t from, size_t to)
{
    const struct edge_work *work = context;
    struct hood near;

    for (size_t i = from; i < to; i++) {
        struct flank *flank = &work->flank[i];
        if (!flank->rough || flank->confirmed)
            continue;
        find_hood(work, i, &near);
        flank->valid = false;
        if (near.n == NEAR)
            find_flank(work, &near, flank);
    }
}

/* A plane through points of several sides is on none of them: their own flanks run across it. */
static bool is_confirmed(const struct edge_work *work, const struct hood *near,
                         const struct flank *flank)
{
    const double alike = 0.992, part = 0.7; /* cosine of 7 degrees */
    double least = within(work, flank->spacing);
    size_t on = 0, same = 0;
    struct vec3 normal;

    for (size_t k = 1; k < near->n; k++) {
        const struct flank *other = &work->flank[near->index[k]];
        if (!has_surface(other) || fabs(above(flank, near->point[k], &normal)) > least)
            continue;
        on++;
        same += fabs(vec_dot(normal, quadric_normal_at(&other->q, near->point[k]))) > alike;
    }
    return same >= FEWEST / 2 && (double)same >= part * (double)on;
}

/* The flank that a rough point takes: its own, if its neighbours confirm it; but that of a
 * neighbour, if it lies on it too and that is fitted much better, or it has none. */
static struct flank choose_flank(const struct edge_work *work, const struct hood *near, size_t i)
{
    const double better = 0.6;
    struct flank own = work->flank[i];
    double least = within(work, own.spacing);
    struct vec3 normal;

    own.valid = own.confirmed;
    for (size_t k = 1; k < MEETING; k++) {
        const struct flank *other = &work->flank[near->index[k]];
        if (!other->confirmed || (own.valid && !(other->rms < better * own.rms)) ||
            fabs(above(other, near->point[0], &normal)) > least)
            continue;
        own.q = other->q;
        own.rms = other->rms;
        own.valid = true;
    }
    return own;
}

static void choose_flanks(void *context, size_t from, size_t to)
{
    const struct edge_work *work = context;
    struct hood near;

    for (size_t i = from; i < to; i++) {
        work->chosen[i] = work->flank[i];
        if (!work->flank[i].rough)
            continue;
        find_hood(work, i, &near);
        if (near.n == NEAR)
            work->chosen[i] = choose_flank(work, &near, i);
    }
}

static void confirm_flanks(void *context, size_t from, size_t to)
{
    const struct edge_work *work = context;
    struct hood near;

    for (size_t i = from; i < to; i++)
        if (work->flank[i].valid && !work->flank[i].confirmed) {
            find_hood(work, i, &near);
            work->flank[i].confirmed = is_confirmed(work, &near, &work->flank[i]);
        }
}

/* ---- where they meet */

/* Moves a place to where n flanks meet, n 2 or 3, by Newton's steps of least length; false: they do
 * not meet near to it. */
static bool move_to_meeting(const struct flank *const *flank, int n, double reach, struct vec3 *p)
{
    struct vec3 start = *p, normal[3];
    double h[3], most = 0;

    for (int step = 0; step < STEPS; step++) {
        most = 0;
        for (int k = 0; k < n; k++) {
            h[k] = above(flank[k], *p, &normal[k]);
            most = fmax(most, fabs(h[k]));
        }
        if (most < 1e-7)
            return true;
        if (n == 2) { /* the least move with normal[k] * d = -h[k] */
            double c = vec_dot(normal[0], normal[1]), s2 = 1 - c * c;
            if (s2 < 0.01)
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
    const struct flank *a = &work->flank[i], *b = &work->flank[k];
    double least = within(work, fmax(a->spacing, b->spacing));
    struct vec3 na, nb;

    if (!b->valid || above(a, point[k], &na) > -least || above(b, point[i], &nb) > -least)
        return false;
    above(a, point[i], &na);
    above(b, point[k], &nb);
    return vec_dot(na, nb) < SHARP;
}

/* A point is on a flank of one of the neighbours. */
static bool is_on_any(const struct edge_work *work, const struct hood *near, struct vec3 p,
                      double least)
{
    struct vec3 normal;

    for (size_t k = 0; k < near->n; k++) {
        const struct flank *flank = &work->flank[near->index[k]];
        if (flank->valid && fabs(above(flank, p, &normal)) <= least)
            return true;
    }
    return false;
}

/* The points of the scan about a place of an edge bear it out: one of them is near, none is above
 * the edge, and each is on one of the two flanks, on a flank of its own, or at a tip on one of
 * others. */
static bool is_borne_out(const struct edge_work *work, const struct hood *near,
                         const struct flank *const *pair, bool tip, double spacing, struct vec3 at)
{
    const struct point_grid *b = work->options->point_grid;
    uint32_t index[ABOUT];
    double distance2[ABOUT], least = within(work, spacing);
    size_t n = point_grid_nearest(b, at, ABOUT, index, distance2);
    struct vec3 normal;

    if (n < ABOUT || distance2[0] > REACH * REACH * spacing * spacing)
        return false;
    for (size_t k = 0; k < n; k++) {
        const struct flank *own = &work->flank[index[k]];
        double h0 = above(pair[0], b->point[index[k]], &normal);
        double h1 = above(pair[1], b->point[index[k]], &normal);
        bool on = fabs(h0) <= 2 * least || fabs(h1) <= 2 * least;
        if (fmax(h0, h1) > 2 * least && distance2[k] < spacing * spacing)
            return false;
        if (!on && !own->valid && !(tip && is_on_any(work, near, b->point[index[k]], least)))
            return false;
    }
    return true;
}

/* A third flank among those of the neighbours that the place is above; NULL: none. */
static const struct flank *flank_below(const struct edge_work *work, const struct hood *near,
                                       struct vec3 at, double least)
{
    const struct flank *worst = NULL;
    double most = least;
    struct vec3 normal;

    for (size_t k = 0; k < MEETING; k++) {
        const struct flank *other = &work->flank[near->index[k]];
        double h = other->valid ? above(other, at, &normal) : 0;
        if (h > most) {
            most = h;
            worst = other;
        }
    }
    return worst;
}

/* Moves a place of an edge back to where the edge ends: where its two flanks meet the one of all
 * others that they meet first. */
static bool move_to_tip(const struct edge_work *work, const struct hood *near,
                        const struct flank **meeting, double spacing, struct vec3 *at)
{
    double least = within(work, spacing);

    for (int turn = 0; turn < STEPS && meeting[2]; turn++) {
        if (!move_to_meeting(meeting, 3, REACH * spacing, at))
            return false;
        const struct flank *other = flank_below(work, near, *at, least / 2);
        if (other == meeting[2])
            return false;
        if (!other)
            return true;
        meeting[2] = other;
    }
    return !flank_below(work, near, *at, least);
}

/* Adds a place of the edge of a pair, or the tip where it ends if the place is beyond that. */
static void add_place(const struct edge_work *work, const struct hood *near,
                      const struct flank *const *pair, double spacing, struct vec3 at,
                      struct vec3s *to)
{
    const struct flank *meeting[3] = {pair[0], pair[1], NULL};
    double least = within(work, spacing) / 2;

    if (!move_to_meeting(meeting, 2, REACH * spacing, &at))
        return;
    meeting[2] = flank_below(work, near, at, least);
    if (meeting[2] && !move_to_tip(work, near, meeting, spacing, &at))
        return;
    for (size_t k = 0; k < to->n; k++)
        if (vec_distance(at, to->item[k]) < work->options->along / 3)
            return;
    if (is_borne_out(work, near, pair, meeting[2] != NULL, spacing, at))
        *array_push(to) = at;
}

/* The edge between point i and one of its neighbours, a spacing to both sides. */
static void add_edge(const struct edge_work *work, const struct hood *near, size_t i, size_t k,
                     struct vec3s *to)
{
    const struct vec3 *point = work->options->point_grid->point;
    const struct flank *pair[2] = {&work->flank[i], &work->flank[k]};
    double spacing = fmax(pair[0]->spacing, pair[1]->spacing);
    struct vec3 at = vec_mix(point[i], point[k], 0.5), normal[2];

    if (!move_to_meeting(pair, 2, REACH * spacing, &at) ||
        vec_distance(at, point[i]) > REACH * spacing ||
        vec_distance(at, point[k]) > REACH * spacing)
        return;
    above(pair[0], at, &normal[0]);
    above(pair[1], at, &normal[1]);
    struct vec3 way = vec_unit(vec_cross(normal[0], normal[1]));
    int steps = (int)ceil(0.75 * spacing / work->options->along);
    for (int s = -steps; s <= steps; s++)
        add_place(work, near, pair, spacing, vec_along(at, 0.75 * spacing * s / steps, way), to);
}

/* ---- tips of cones */

/* No point about stands higher, seen along the normal of the neighbourhood. */
static bool is_top(const struct hood *near)
{
    struct vec3 up = plane_normal(near->point, near->n);

    if (up.z < 0)
        up = vec_scale(-1, up);
    for (size_t k = 1; k < ABOUT; k++)
        if (vec_dot(up, vec_sub(near->point[k], near->point[0])) > 0)
            return false;
    return true;
}

/* The cone about its tip; with noise a cubic may do as well. */
static bool find_cone(const struct edge_work *work, const struct hood *near,
                      const struct flank *flank, struct cone_tip *tip)
{
    const double better = 0.75;
    double least = within(work, near->spacing) + SIGMAS * EVEN * near->spacing;
    struct quadric cubic;

    if (cone_tip_fit(near->point, near->n, even(work, near->spacing), tip) != 0 ||
        tip->worst > least)
        return false;
    return flank->rough || (cubic_fit(near->point, NULL, near->n, near->point[0],
                                      quadric_normal(&flank->q), &cubic) == 0 &&
                            tip->rms < better * quadric_spread(&cubic, near->point, near->n, 10));
}

/* The tip of a cone about a point of it, and places round it as far as all neighbours know. */
static void add_cone(const struct edge_work *work, const struct hood *near,
                     const struct flank *flank, struct vec3s *edge, struct vec3s *between)
{
    const double dense = 0.65;
    double pitch = dense * work->options->along;
    struct cone_tip tip;

    if (!find_cone(work, near, flank, &tip))
        return;
    *array_push(edge) = cone_tip_at(&tip, 0, 0);
    double down = pitch / hypot(1, tip.c[1]);
    for (int ring = 1; ring * down < tip.reach; ring++) {
        double r = ring * down, parts = ceil(2 * PI * r / pitch);
        for (double k = 0; k < parts; k++)
            *array_push(between) = cone_tip_at(&tip, r, 2 * PI * k / parts);
    }
}

/* ---- cliffs */

/* What is seen from above about a point of a flank: points of the flank, those so steeply below it
 * that a wall is between, and points whose flank meets it in a known edge. */
struct cliff {
    struct vec3 from;
    const struct quadric *q;
    struct vec3s on, below;
    struct sizes beyond;
};

/* The points of the flank are no further off it than a ball may sink, or noise is: continued as far
 * as it goes it is where they tell. */
static bool is_certain(const struct edge_work *work, const struct flank *flank)
{
    return has_surface(flank) &&
           flank->rms <= fmax(1.4 * work->options->noise, work->options->sink);
}

/* A place of the flank over (x, y). */
static struct vec3 place_above(const struct cliff *cliff, double x, double y)
{
    struct vec3 n = quadric_normal_at(cliff->q, cliff->from), p = cliff->from;

    p.z -= (n.x * (x - p.x) + n.y * (y - p.y)) / n.z;
    p.x = x;
    p.y = y;
    return quadric_nearest(cliff->q, p);
}

/* Points below the flank whose own surface the point is not above are beyond an edge. */
static void sort_by_height(const struct edge_work *work, size_t i, size_t k, struct cliff *cliff)
{
    const struct flank *own = &work->flank[i], *other = &work->flank[k];
    const struct vec3 p = work->options->point_grid->point[k];
    double least = within(work, fmax(own->spacing, other->spacing));
    struct vec3 normal;
    double off = above(own, p, &normal), far = vec_distance(p, cliff->from);
    double down = has_surface(other) ? above(other, cliff->from, &normal) : 0;

    if (fabs(off) <= least)
        *array_push(&cliff->on) = p;
    else if (off < 0 && has_surface(other) && down <= least)
        *array_push(&cliff->beyond) = k;
    else if (off < -WALL * far ||
             (off < -STEP * far && is_certain(work, other) && down > STEP * far))
        *array_push(&cliff->below) = p;
}

/* The points within REACH of point i as seen from above. */
static struct cliff find_cliff(const struct edge_work *work, size_t i)
{
    const struct point_grid *b = work->options->point_grid;
    struct cliff cliff = {.from = b->point[i], .q = &work->flank[i].q};
    double reach = fmin(REACH * point_grid_spacing(b), b->cell);
    size_t column = point_grid_column(b, cliff.from.x), row = point_grid_row(b, cliff.from.y);
    size_t c0 = column > 0 ? column - 1 : 0, c1 = column + 1 < b->columns ? column + 1 : column;

    for (size_t r = row > 0 ? row - 1 : 0; r <= row + 1 && r < b->rows; r++)
        for (size_t k = b->first[r * b->columns + c0]; k < b->first[r * b->columns + c1 + 1]; k++)
            if (k != i && hypot(b->point[k].x - cliff.from.x, b->point[k].y - cliff.from.y) < reach)
                sort_by_height(work, i, k, &cliff);
    return cliff;
}

/* The wall may be beyond the place: this is on the way to a point below it, before all others of
 * these, and no other point of the flank is nearer. */
static bool is_before_wall(const struct cliff *cliff, double u, double v)
{
    const double beside = 0.7; /* cosine of 45 degrees */
    bool before = false;

    for (size_t k = 0; k < cliff->on.n; k++) {
        double x = cliff->on.item[k].x - cliff->from.x, y = cliff->on.item[k].y - cliff->from.y;
        if (2 * (u * x + v * y) > x * x + y * y)
            return false;
    }
    for (size_t k = 0; k < cliff->below.n; k++) {
        double x = cliff->below.item[k].x - cliff->from.x;
        double y = cliff->below.item[k].y - cliff->from.y, ahead = u * x + v * y;
        if (ahead > x * x + y * y)
            return false;
        before = before || ahead > beside * sqrt((u * u + v * v) * (x * x + y * y));
    }
    return before;
}

/* The place is no further than the edges that are known. */
static bool is_before_edges(const struct edge_work *work, const struct cliff *cliff, struct vec3 at)
{
    struct vec3 normal;

    for (size_t k = 0; k < cliff->beyond.n; k++) {
        const struct flank *other = &work->flank[cliff->beyond.item[k]];
        if (above(other, at, &normal) > within(work, other->spacing))
            return false;
    }
    return true;
}

/* The flank of point i goes on up to the points below: where the wall between is nobody knows. */
static void fill_cliff(const struct edge_work *work, const struct cliff *cliff, double reach,
                       struct vec3s *to)
{
    const double dense = 0.65, triangle = 0.8660254037844386;
    double pitch = dense * work->options->along;
    int rings = (int)fmin(reach / pitch, RINGS);

    for (int j = -rings; j <= rings; j++)
        for (int k = -rings; k <= rings; k++) {
            double u = pitch * (k + j / 2.0), v = pitch * j * triangle;
            if (!is_before_wall(cliff, u, v))
                continue;
            struct vec3 at = place_above(cliff, cliff->from.x + u, cliff->from.y + v);
            if (is_before_edges(work, cliff, at))
                *array_push(to) = at;
        }
}

/* The wall itself may go down from there to a point below, without points that were seen. */
static void fill_wall(const struct edge_work *work, const struct cliff *cliff, struct vec3s *to)
{
    enum { MOST = 60 };
    const double nearly = 0.9;

    for (size_t k = 0; k < cliff->below.n; k++) {
        struct vec3 foot = cliff->below.item[k];
        double u = nearly * (foot.x - cliff->from.x), v = nearly * (foot.y - cliff->from.y);
        if (!is_before_wall(cliff, u, v))
            continue;
        struct vec3 at = place_above(cliff, cliff->from.x + u, cliff->from.y + v);
        double parts = fmin(ceil((at.z - foot.z) / work->options->along), MOST);
        for (double part = 1; part < parts && is_before_edges(work, cliff, at); part++)
            *array_push(to) = vec(at.x, at.y, at.z + part / parts * (foot.z - at.z));
    }
}

/* From the point to the nearest of those below, seen from above. */
static double width_of(const struct cliff *cliff)
{
    double least = HUGE_VAL;

    for (size_t k = 0; k < cliff->below.n; k++)
        least = fmin(least, hypot(cliff->below.item[k].x - cliff->from.x,
                                  cliff->below.item[k].y - cliff->from.y));
    return least;
}

static void add_cliff(const struct edge_work *work, size_t i)
{
    struct cliff cliff = find_cliff(work, i);
    struct vec3s *to = &work->between[i];
    size_t before = to->n;

    if (cliff.below.n > 0) {
        fill_cliff(work, &cliff, REACH * work->flank[i].spacing, to);
        fill_wall(work, &cliff, to);
    }
    if (to->n > before)
        work->gap[i] = width_of(&cliff);
    array_free(&cliff.on);
    array_free(&cliff.below);
    array_free(&cliff.beyond);
}

static void find_edges(void *context, size_t from, size_t to)
{
    const struct edge_work *work = context;
    struct hood near;

    for (size_t i = from; i < to; i++) {
        if (is_certain(work, &work->flank[i]) && quadric_normal(&work->flank[i].q).z > FACING)
            add_cliff(work, i);
        if (!work->flank[i].bent)
            continue;
        find_hood(work, i, &near);
        if (is_top(&near))
            add_cone(work, &near, &work->flank[i], &work->found[i], &work->between[i]);
        if (!work->flank[i].valid)
            continue;
        for (size_t k = 1; k < MEETING; k++)
            if (near.index[k] > i && is_edge_between(work, i, near.index[k]))
                add_edge(work, &near, i, near.index[k], &work->found[i]);
    }
}

/* ---- flanks filled up to their edges */

/* What is known about a flank at point i: which of the neighbours are on it, which are in a hollow
 * with it, each above the other's surface, and places of its edges. */
struct flank_patch {
    const struct flank *flank;
    bool on[NEAR], hollow[NEAR];
    struct vec3s side; /* points and places of edges on it */
    size_t edges;      /* of these, places of edges */
    size_t sharp;      /* neighbours in a hollow that is sharp */
};

/* The flank of a point in a hollow turns up sharply from this one. */
static bool is_sharp(const struct flank_patch *patch, const struct flank *other, struct vec3 p)
{
    struct vec3 normal[2];

    above(patch->flank, p, &normal[0]);
    above(other, p, &normal[1]);
    return vec_dot(normal[0], normal[1]) < SHARP;
}

static struct flank_patch find_patch(const struct edge_work *work, const struct hood *near,
                                     size_t i)
{
    struct flank_patch patch = {.flank = &work->flank[i]};
    double least = within(work, patch.flank->spacing);
    struct vec3 normal;

    for (size_t k = 0; k < near->n; k++) {
        const struct vec3s *edge = &work->found[near->index[k]];
        const struct flank *other = &work->flank[near->index[k]];
        double h = above(patch.flank, near->point[k], &normal);
        patch.on[k] = fabs(h) <= least;
        patch.hollow[k] =
            h > least && has_surface(other) && above(other, near->point[0], &normal) > least;
        if (patch.on[k])
            *array_push(&patch.side) = near->point[k];
        for (size_t e = 0; e < edge->n; e++)
            if (fabs(above(patch.flank, edge->item[e], &normal)) <= least) {
                *array_push(&patch.side) = edge->item[e];
                patch.edges++;
            }
        patch.sharp += patch.hollow[k] && other->valid && is_sharp(&patch, other, near->point[k]);
    }
    return patch;
}

/* No point that knows the flank is nearer to the place than point i, all points about have
 * surfaces, and the place is above none of these, but for hollows. */
static bool is_on_patch(const struct edge_work *work, const struct hood *near,
                        const struct flank_patch *patch, struct vec3 at)
{
    const double about = 2, beside = 1.5; /* beside: in spacings, for a point on the edge itself */
    double out = vec_distance(at, near->point[0]), least = within(work, patch->flank->spacing);
    double reach = fmax(about * out, (work->lines ? REACH : beside) * patch->flank->spacing);
    struct vec3 normal;

    for (size_t k = 1; k < near->n; k++) {
        const struct flank *other = &work->flank[near->index[k]];
        double far = vec_distance(at, near->point[k]);
        if (patch->on[k] && other->valid && far < out)
            return false;
        if (far >= reach || patch->hollow[k])
            continue;
        if (!has_surface(other) ? far < about * out
                                : above(other, at, &normal) > (patch->on[k] ? least : least / 4))
            return false;
    }
    return true;
}

/* Every half plane of the flank through the place has a point or an edge of it that is near. */
static bool is_surrounded(const struct flank_patch *patch, struct vec3 at, double near)
{
    enum { SECTORS = 12 };
    const struct quadric *q = &patch->flank->q;
    bool has[SECTORS] = {false};

    for (size_t k = 0; k < patch->side.n; k++) {
        struct vec3 to = vec_sub(patch->side.item[k], at);
        double u = vec_dot(to, q->u), v = vec_dot(to, q->v);
        if (hypot(u, v) <= near)
            has[(int)((atan2(v, u) + PI) / (2 * PI) * SECTORS) % SECTORS] = true;
    }
    for (int from = 0; from < SECTORS; from++) {
        bool any = false;
        for (int k = 0; k < SECTORS / 2; k++)
            any = any || has[(from + k) % SECTORS];
        if (!any)
            return false;
    }
    return true;
}

/* Places of the flank of point i that are nearest to it, as dense as those of edges are on
 * these. */
static void fill_patch(const struct edge_work *work, const struct hood *near,
                       const struct flank_patch *patch, struct vec3s *to)
{
    const double dense = 0.65, triangle = 0.8660254037844386;
    const struct quadric *q = &patch->flank->q;
    double pitch = dense * work->options->along, reach = sqrt(near->distance2[SMOOTH]);
    struct vec3 off = vec_sub(near->point[0], q->origin);
    int rings = (int)fmin(reach / pitch, RINGS);

    for (int j = -rings; j <= rings; j++)
        for (int i = -rings; i <= rings; i++) {
            double u = pitch * (i + j / 2.0), v = pitch * j * triangle;
            if ((i == 0 && j == 0) || hypot(u, v) > reach)
                continue;
            struct vec3 at = quadric_at(q, vec_dot(off, q->u) + u, vec_dot(off, q->v) + v);
            if (is_on_patch(work, near, patch, at) &&
                is_surrounded(patch, at, fmax(reach, 2 * hypot(u, v))))
                *array_push(to) = at;
        }
}

static void fill_flanks(void *context, size_t from, size_t to)
{
    const struct edge_work *work = context;
    struct hood near;

    for (size_t i = from; i < to; i++) {
        if (!work->flank[i].valid)
            continue;
        find_hood(work, i, &near);
        struct flank_patch patch = find_patch(work, &near, i);
        if (patch.edges > 0 || patch.sharp >= FEWEST) /* elsewhere it is rough */
            fill_patch(work, &near, &patch, &work->between[i]);
        array_free(&patch.side);
    }
}

bool edge_flank_holds(const struct point_grid *point_grid, double noise, size_t i)
{
    const struct edge_points_options options = {.point_grid = point_grid, .noise = noise};
    const struct edge_work work = {.options = &options};
    struct side_fit fit;
    struct hood near;

    find_hood(&work, i, &near);
    if (near.n < NEAR)
        return false;
    double spacing = sqrt(PI * near.distance2[NEAR - 1] / NEAR);
    double apart = fmin(APART * spacing, LONE * point_grid->cell);
    return near.distance2[1] <= apart * apart && fit_flank(&work, &near, spacing, false, &fit);
}

/* Appends what was found of each point, which is freed; returns how much. */
static size_t append_all(struct vec3s *found, size_t n, struct vec3s *to)
{
    size_t before = to->n;

    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < found[i].n; k++)
            *array_push(to) = found[i].item[k];
        array_free(&found[i]);
    }
    free(found);
    return to->n - before;
}

/* The flanks of all points; on scan lines from neighbours on many of these, and where these do not
 * tell, on few. */
static void find_all_flanks(struct edge_work *work, size_t n)
{
    int threads = work->options->threads;

    work->wide = work->lines;
    parallel_for(threads, n, find_flanks, work);
    parallel_for(threads, n, confirm_flanks, work);
    work->wide = false;
    if (work->lines) {
        parallel_for(threads, n, find_flanks_again, work);
        parallel_for(threads, n, confirm_flanks, work);
    }
    parallel_for(threads, n, choose_flanks, work);
    free(work->flank);
    work->flank = work->chosen;
}

static struct edge_gaps sum_gaps(const struct edge_work *work)
{
    struct edge_gaps gaps = {.n = 0};

    for (size_t i = 0; i < work->options->point_grid->n; i++) {
        gaps.n += work->gap[i] > 0;
        if (work->gap[i] > gaps.widest) {
            gaps.widest = work->gap[i];
            gaps.at = work->options->point_grid->point[i];
        }
    }
    return gaps;
}

size_t edge_points(const struct edge_points_options *options, struct vec3s *to,
                   struct edge_gaps *gaps)
{
    size_t n = options->point_grid->n;
    struct edge_work work = {.options = options,
                             .lines = scan_lines_found(options->point_grid),
                             .flank = mem_alloc(n, sizeof *work.flank),
                             .chosen = mem_alloc(n, sizeof *work.chosen),
                             .found = mem_alloc(n, sizeof *work.found),
                             .between = mem_alloc(n, sizeof *work.between),
                             .gap = mem_alloc(n, sizeof *work.gap)};

    for (size_t i = 0; i < n; i++) {
        work.flank[i] = (struct flank){.valid = false};
        work.found[i] = work.between[i] = (struct vec3s){0};
        work.gap[i] = 0;
    }
    find_all_flanks(&work, n);
    parallel_for(options->threads, n, find_edges, &work);
    work.wide = work.lines;
    if (options->fill)
        parallel_for(options->threads, n, fill_flanks, &work);
    append_all(work.between, n, to);
    *gaps = sum_gaps(&work);
    free(work.gap);
    free(work.flank);
    return append_all(work.found, n, to);
}
