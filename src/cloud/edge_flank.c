/* edge_flank - see edge_steps.h. */
#include <stdlib.h>

#include "base/array.h"
#include "base/parallel.h"
#include "edge_steps.h"
#include "math/cubic.h"
#include "math/plane_fit.h"
#include "math/side_fit.h"

/* Neighbours that a smooth surface goes through; the same on scan lines: on five of them; those
 * that planes are tried through. */
enum { SMOOTH = EDGE_SMOOTH, LINED = 36, TRIED = 12 };

/* So many points deep flanks go on towards an edge. */
enum { CONTINUED = 2 };

/* In spacings: a surface off its points by less is a flank; so narrow a flank is none; a point so
 * far from all others is on none of theirs. */
static const double FLAT = 0.02, BENT = 0.015, NARROW = 0.25, APART = 2,
                    LONE = 1; /* in cells of the grid */

/* The normal of a flank below or above a place, and how far that is above the flank. */
double edge_flank_above(const struct edge_flank *flank, struct vec3 p, struct vec3 *normal)
{
    struct vec3 foot = quadric_nearest(&flank->q, p);

    *normal = quadric_normal_at(&flank->q, foot);
    return vec_dot(*normal, vec_sub(p, foot));
}

/* A surface of its own is known of the point: a flank, or one of all its neighbours. */
bool edge_flank_known(const struct edge_flank *flank)
{
    return flank->valid || (!flank->rough && flank->spacing > 0);
}

/* Points of a surface may be off it by this. */
double edge_within(const struct edge_work *work, double spacing)
{
    return EDGE_SIGMAS * work->options->noise + FLAT * spacing;
}
/* How far points may be off their surface on average. */
double edge_even(const struct edge_work *work, double spacing)
{
    return fmax(EDGE_UNEVEN * work->options->noise, EDGE_EVEN * spacing);
}

static bool is_smooth(const struct edge_work *work, const struct edge_hood *near, double spacing,
                      struct quadric *q, double *rms, bool *bent)
{
    double least = edge_even(work, spacing);
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
    return EDGE_SIGMAS * work->options->noise + FLAT * spacing + BENT * distance2 / spacing;
}

/* How many neighbours lie on the plane, each the less the further off it is (Torr and Zisserman's
 * MSAC, 2000); where they can't be more than `most`, not all of them are counted. */
static double weigh_plane(const struct edge_hood *near, const double *least, struct vec3 normal,
                          double most)
{
    double on = 0;

    for (size_t k = 0; k < near->n && on + (double)(near->n - k) > most; k++) {
        double off = vec_dot(normal, vec_sub(near->point[k], near->point[0]));
        double part = off / least[k];
        on += fmax(0, 1 - part * part);
    }
    return on;
}

/* The plane through the point and two neighbours that most of them lie on; false: there is none. */
static bool find_plane(const struct edge_work *work, const struct edge_hood *near, double spacing,
                       struct vec3 *normal)
{
    const double skew = 0.3; /* sine of the angle between the two */
    double most = 0, least[EDGE_NEAR];

    for (size_t k = 0; k < near->n; k++)
        least[k] = allowed(work, spacing, near->distance2[k]);
    for (size_t a = 1; a < TRIED; a++)
        for (size_t b = a + 1; b < TRIED; b++) {
            struct vec3 to_a = vec_sub(near->point[a], near->point[0]);
            struct vec3 to_b = vec_sub(near->point[b], near->point[0]);
            struct vec3 across = vec_cross(to_a, to_b);
            double l = vec_length(across);
            if (!(l > skew * sqrt(near->distance2[a] * near->distance2[b])))
                continue;
            double on = weigh_plane(near, least, vec_scale(1 / l, across), most);
            if (on > most) {
                most = on;
                *normal = vec_scale(1 / l, across);
            }
        }
    return most >= EDGE_FEWEST;
}

/* Gathers the neighbours on the surface, `bend` by how much more with their distance. */
static size_t gather_on(const struct edge_work *work, const struct edge_hood *near, double spacing,
                        const struct quadric *q, double bend, struct vec3 *on)
{
    size_t n = 0;

    for (size_t k = 0; k < near->n; k++) {
        double least = EDGE_SIGMAS * work->options->noise + FLAT * spacing +
                       bend * near->distance2[k] / spacing;
        if (fabs(quadric_off(q, near->point[k])) <= least)
            on[n++] = near->point[k];
    }
    return n;
}

static bool fit_side(const struct vec3 *on, size_t n, struct vec3 origin, double spacing,
                     struct side_fit *fit)
{
    struct plane_fit plane;

    if (n < EDGE_FEWEST || plane_fit(on, n, &plane) < 0 || plane.width < NARROW * spacing ||
        side_fit_plane(on, n, origin, plane.normal, fit) < 0)
        return false;
    if (n >= 2 * EDGE_FEWEST)
        side_fit_bend(on, n, fit);
    return true;
}

/* The surface of most neighbours on one plane through the point: `own`, and the point itself. */
static bool fit_flank(const struct edge_work *work, const struct edge_hood *near, double spacing,
                      bool own, struct side_fit *fit)
{
    const size_t many = 9;
    struct vec3 on[EDGE_NEAR], normal;
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
           fabs(quadric_off(&fit->q, near->point[0])) <= EDGE_SIGMAS * noise + FLAT * spacing;
}

static void find_flank(const struct edge_work *work, const struct edge_hood *near,
                       struct edge_flank *flank)
{
    struct side_fit fit;

    if (!fit_flank(work, near, flank->spacing, true, &fit))
        return;
    flank->q = fit.q;
    flank->rms = fit.rms;
    quadric_face_up(&flank->q);
    flank->valid = quadric_normal(&flank->q).z > EDGE_UPRIGHT;
}

static void find_flanks(void *context, size_t from, size_t to)
{
    const struct edge_work *work = context;
    struct edge_hood near;

    for (size_t i = from; i < to; i++) {
        struct edge_flank *flank = &work->flank[i];
        edge_hood_find(work, i, &near);
        flank->spacing = near.spacing;
        flank->bent = flank->rough = true;
        if (near.n < EDGE_NEAR)
            continue;
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
    struct edge_hood near;

    for (size_t i = from; i < to; i++) {
        struct edge_flank *flank = &work->flank[i];
        if (!flank->rough || flank->confirmed)
            continue;
        edge_hood_find(work, i, &near);
        flank->valid = false;
        if (near.n == EDGE_NEAR)
            find_flank(work, &near, flank);
    }
}

/* A plane through points of several sides is on none of them: their own flanks run across it. */
static bool is_confirmed(const struct edge_work *work, const struct edge_hood *near,
                         const struct edge_flank *flank)
{
    const double alike = 0.992, part = 0.7; /* cosine of 7 degrees */
    double least = edge_within(work, flank->spacing);
    size_t on = 0, same = 0;
    struct vec3 normal;

    for (size_t k = 1; k < near->n; k++) {
        const struct edge_flank *other = &work->flank[near->index[k]];
        if (!edge_flank_known(other) ||
            fabs(edge_flank_above(flank, near->point[k], &normal)) > least)
            continue;
        on++;
        same += fabs(vec_dot(normal, quadric_normal_at(&other->q, near->point[k]))) > alike;
    }
    return same >= EDGE_FEWEST / 2 && (double)same >= part * (double)on;
}

/* The surface through the point and the neighbours that are on it; false: there is none through all
 * of these that is certain. */
static bool refit_flank(const struct edge_work *work, const struct edge_hood *near,
                        struct edge_flank *flank)
{
    struct vec3 on[EDGE_NEAR], way = quadric_normal_at(&flank->q, near->point[0]);
    double least = edge_within(work, flank->spacing);
    struct side_fit fit;
    size_t n = 0;

    for (size_t k = 0; k < near->n; k++)
        if (k == 0 || fabs(quadric_off(&flank->q, near->point[k])) <= least)
            on[n++] = near->point[k];
    if (n < 2 * EDGE_FEWEST || side_fit_plane(on, n, near->point[0], way, &fit) < 0)
        return false;
    side_fit_bend(on, n, &fit);
    flank->q = fit.q;
    flank->rms = fit.rms;
    quadric_face_up(&flank->q);
    return quadric_normal_at(&flank->q, near->point[0]).z > EDGE_UPRIGHT &&
           edge_flank_certain(work, flank) && fabs(quadric_off(&flank->q, near->point[0])) <= least;
}

/* A rough point that no certain flank goes through takes the surface of its nearest neighbour that
 * has one and goes on to it, as beside the rim of a groove, whose wall bends too much for a
 * plane. */
static struct edge_flank continue_flank(const struct edge_work *work, const struct edge_hood *near,
                                        struct edge_flank own)
{
    struct vec3 normal;

    for (size_t k = 1; k < EDGE_MEETING; k++) {
        const struct edge_flank *other = &work->flank[near->index[k]];
        struct edge_flank flank = own;
        if (!edge_flank_certain(work, other) ||
            fabs(edge_flank_above(other, near->point[0], &normal)) >
                allowed(work, own.spacing, near->distance2[k]))
            continue;
        flank.q = other->q;
        flank.rms = other->rms;
        flank.valid = flank.continued = true;
        if (refit_flank(work, near, &flank))
            return flank;
    }
    return own;
}

static void continue_flanks(void *context, size_t from, size_t to)
{
    const struct edge_work *work = context;
    struct edge_hood near;

    for (size_t i = from; i < to; i++) {
        const struct edge_flank *own = &work->flank[i];
        work->chosen[i] = *own;
        if (!own->rough || (own->valid && edge_flank_certain(work, own)))
            continue;
        edge_hood_find(work, i, &near);
        if (near.n == EDGE_NEAR)
            work->chosen[i] = continue_flank(work, &near, *own);
    }
}

/* The flank that a rough point takes: its own, if its neighbours confirm it; but that of a
 * neighbour, if it lies on it too and that is fitted much better, or it has none. */
static struct edge_flank choose_flank(const struct edge_work *work, const struct edge_hood *near,
                                      size_t i)
{
    const double better = 0.6;
    struct edge_flank own = work->flank[i];
    double least = edge_within(work, own.spacing);
    struct vec3 normal;

    own.valid = own.confirmed;
    for (size_t k = 1; k < near->n; k++) {
        const struct edge_flank *other = &work->flank[near->index[k]];
        if (!other->confirmed || (k >= EDGE_MEETING && !edge_flank_certain(work, other)) ||
            (own.valid && !(other->rms < better * own.rms)) ||
            fabs(edge_flank_above(other, near->point[0], &normal)) > least)
            continue;
        own.q = other->q;
        own.rms = other->rms;
        own.valid = true;
    }
    return own;
}

/* A neighbour's surface with less bends than the point's cubic goes through it, too: another way,
 * the less so the nearer it is; or it is certain, and the cubic is not. */
static bool is_plainer(const struct edge_work *work, const struct edge_flank *other, struct vec3 p,
                       const struct edge_flank *cubic)
{
    const double alike = 0.985, blunt = 0.9962, better = 0.3; /* cosines of 10 and 5 degrees */
    double close = fmax(work->options->sink, work->options->noise);
    struct vec3 way = quadric_normal_at(&cubic->q, p), normal;
    double off = fabs(edge_flank_above(other, p, &normal));

    if (!(other->bent ? other->confirmed : edge_flank_certain(work, other)) ||
        off > edge_within(work, cubic->spacing) || normal.z <= EDGE_UPRIGHT)
        return false;
    if (off > close)
        return vec_dot(way, normal) <= alike;
    return vec_dot(way, normal) <= blunt ||
           (edge_flank_certain(work, other) && !edge_flank_certain(work, cubic) &&
            other->rms < better * cubic->rms);
}

/* A cubic has bends enough to go round an edge, more so among noise: where a surface is plainer, it
 * is that one. */
static struct edge_flank plainer_flank(const struct edge_work *work, const struct edge_hood *near,
                                       size_t i)
{
    struct edge_flank own = work->flank[i];

    for (size_t k = 1; k < EDGE_MEETING; k++) {
        const struct edge_flank *other = &work->flank[near->index[k]];
        if (!is_plainer(work, other, near->point[0], &own))
            continue;
        own.q = other->q;
        own.rms = other->rms;
        own.valid = true;
        break;
    }
    return own;
}

static void choose_flanks(void *context, size_t from, size_t to)
{
    const struct edge_work *work = context;
    struct edge_hood near;

    for (size_t i = from; i < to; i++) {
        work->chosen[i] = work->flank[i];
        if (!work->flank[i].bent)
            continue;
        edge_hood_find(work, i, &near);
        if (near.n == EDGE_NEAR)
            work->chosen[i] =
                work->flank[i].rough ? choose_flank(work, &near, i) : plainer_flank(work, &near, i);
    }
}

static void confirm_flanks(void *context, size_t from, size_t to)
{
    const struct edge_work *work = context;
    struct edge_hood near;

    for (size_t i = from; i < to; i++)
        if (work->flank[i].valid && !work->flank[i].confirmed) {
            edge_hood_find(work, i, &near);
            work->flank[i].confirmed = is_confirmed(work, &near, &work->flank[i]);
        }
}

/* The points of the flank are no further off it than a ball may sink, or noise is: continued as far
 * as it goes it is where they tell. */
bool edge_flank_certain(const struct edge_work *work, const struct edge_flank *flank)
{
    const double uneven = 1.7; /* noises: the mean of a dozen points is more in one of a thousand */

    return edge_flank_known(flank) &&
           flank->rms <= fmax(uneven * work->options->noise, work->options->sink);
}

bool edge_flank_holds(const struct point_grid *point_grid, double noise, size_t i)
{
    const struct edge_points_options options = {.point_grid = point_grid, .noise = noise};
    const struct edge_work work = {.options = &options};
    struct side_fit fit;
    struct edge_hood near;

    edge_hood_find(&work, i, &near);
    if (near.n < EDGE_NEAR)
        return false;
    double spacing = sqrt(PI * near.distance2[EDGE_NEAR - 1] / EDGE_NEAR);
    double apart = fmin(APART * spacing, LONE * point_grid->cell);
    return near.distance2[1] <= apart * apart && fit_flank(&work, &near, spacing, false, &fit);
}

static void find_ribs(void *context, size_t from, size_t to)
{
    const struct edge_work *work = context;

    for (size_t i = from; i < to; i++)
        if (!edge_flank_known(&work->flank[i]) ||
            (work->flank[i].rough && !edge_flank_certain(work, &work->flank[i])))
            edge_along_find(work, i);
}

void edge_flanks_take_chosen(struct edge_work *work)
{
    struct edge_flank *flank = work->flank;

    work->flank = work->chosen;
    work->chosen = flank;
}

/* On scan lines from neighbours on many of these, and where these do not tell, on few. */
void edge_flanks_find(struct edge_work *work)
{
    size_t n = work->options->point_grid->n;
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
    edge_flanks_take_chosen(work);
    for (int turn = 0; turn < CONTINUED; turn++) {
        parallel_for(threads, n, continue_flanks, work);
        edge_flanks_take_chosen(work);
    }
    edge_flanks_widen(work);
    free(work->chosen);
    work->chosen = work->flank;
    if (work->options->fill)
        parallel_for(threads, n, find_ribs, work);
}
