/* edge_crest - see edge_steps.h. */
#include <stdlib.h>

#include "base/parallel.h"
#include "crest_fit.h"
#include "edge_steps.h"

/* In spacings: points about that a crest is fitted to; places of a crest so far along it. */
static const double ABOUT = 4, BESIDE = 4, REPLACED = 2;

/* In spacings: a point beside a crest stands out from its nearest by more. */
static const double OUT = 0.03;

/* In spacings: farther from its points a crest amid noise is not known where these are on lines,
 * for few are on its sides, and how steep they are the noise tells. */
static const double NOISY = 1.25;

/* Of a spacing: so far a side goes on below its last point, where something begins at its foot. */
static const double BEYOND = 0.7;

static int compare_near(const void *pa, const void *pb)
{
    const struct vec3 *a = pa, *b = pb;

    if (a->z != b->z)
        return a->z < b->z ? -1 : 1;
    return (a->x > b->x) - (a->x < b->x);
}

/* The points about point i as seen from above, nearest first; returns how many. */
static size_t find_about(const struct point_grid *b, size_t i, double reach, struct vec3 *point,
                         size_t *index)
{
    enum { MANY = 1024 };
    struct vec3 from = b->point[i], near[MANY]; /* x: index, z: squared distance */
    struct point_grid_walk walk = point_grid_about(b, from, reach);
    size_t n = 0;

    for (size_t k; n < MANY && point_grid_next(&walk, &k);) {
        double x = b->point[k].x - from.x, y = b->point[k].y - from.y;
        if (x * x + y * y <= reach * reach)
            near[n++] = vec((double)k, 0, k == i ? -1 : x * x + y * y);
    }
    qsort(near, n, sizeof *near, compare_near); // cppcheck-suppress uninitvar
    n = n < CREST_POINTS ? n : CREST_POINTS;
    for (size_t k = 0; k < n; k++)
        point[k] = b->point[index[k] = (size_t)near[k].x];
    return n;
}

/* The crests about all points, NULL: none; and those found since. */
struct crests {
    const struct edge_work *work;
    bool *may; /* there may be one */
    struct crest_fit **of, **next;
};

/* The point stands out from the nearest, as one beside a crest does. */
static bool stands_out(const struct edge_work *work, size_t i)
{
    struct edge_hood near;

    edge_hood_find(work, i, &near);
    return near.n >= EDGE_NEAR && edge_hood_out(&near, EDGE_SMOOTH) > OUT * near.spacing;
}

/* Nothing is certain of its own side, but of a third of the points about; or these are smooth, and
 * it stands out. */
static bool may_have(const struct edge_work *work, size_t i)
{
    enum { MANY = 4 * EDGE_NEAR };
    const struct point_grid *b = work->options->point_grid;
    uint32_t index[MANY];
    double distance2[MANY];
    size_t smooth = 0;

    if (!work->flank[i].rough || edge_flank_certain(work, &work->flank[i]))
        return false;
    if (edge_on_known(work, i))
        return true;
    if (!stands_out(work, i))
        return false;
    size_t n = point_grid_nearest(b, b->point[i], MANY, index, distance2);
    for (size_t k = 0; k < n; k++)
        smooth += !work->flank[index[k]].rough || edge_flank_certain(work, &work->flank[index[k]]);
    return 3 * smooth > n;
}

static struct crest_fit *copy_of(const struct crest_fit *fit)
{
    struct crest_fit *copy = mem_alloc(1, sizeof *copy);

    *copy = *fit;
    return copy;
}

static struct crest_fit *find_crest(const struct crests *crests, size_t i)
{
    const struct edge_work *work = crests->work;
    const struct point_grid *b = work->options->point_grid;
    double spacing = point_grid_spacing(b);
    struct vec3 point[CREST_POINTS];
    size_t index[CREST_POINTS];
    enum crest_role role[CREST_POINTS];
    struct crest_fit fit;

    if (!crests->may[i])
        return NULL;
    size_t n = find_about(b, i, ABOUT * spacing, point, index);
    if (crest_fit_find(point, n, spacing, edge_within(work, spacing), edge_even(work, spacing),
                       &fit, role) != 0)
        return NULL;
    return copy_of(&fit);
}

/* Begun with those of neighbours; in the place of its own if it is fitted much better. */
static struct crest_fit *follow_crest(const struct crests *crests, size_t i)
{
    const struct edge_work *work = crests->work;
    enum { TRIED = 3 };
    const double better = 0.6;
    const struct point_grid *b = work->options->point_grid;
    double spacing = point_grid_spacing(b);
    struct vec3 point[CREST_POINTS];
    size_t index[CREST_POINTS], tried = 0;
    enum crest_role role[CREST_POINTS];
    struct crest_fit fit;

    if (!crests->may[i])
        return NULL;
    double rms = better * (crests->of[i] ? crests->of[i]->rms : edge_even(work, spacing) / better);
    size_t n = find_about(b, i, ABOUT * spacing, point, index);
    for (size_t k = 1; k < n && tried < TRIED; k++) {
        const struct crest_fit *other = crests->of[index[k]];
        if (!other || other->rms > rms)
            continue;
        tried++;
        if (crest_fit_follow(point, n, spacing, edge_within(work, spacing), rms, other, &fit,
                             role) == 0)
            return copy_of(&fit);
    }
    return NULL;
}

/* A neighbour's, fitted much better, explains the point, too. */
static bool yields(const struct crests *crests, size_t i)
{
    const double better = 0.3;
    const struct point_grid *b = crests->work->options->point_grid;
    double spacing = point_grid_spacing(b), within = edge_within(crests->work, spacing);
    struct vec3 point[CREST_POINTS];
    size_t index[CREST_POINTS];
    enum crest_role role;

    if (!crests->of[i])
        return false;
    size_t n = find_about(b, i, REPLACED * spacing, point, index);
    for (size_t k = 1; k < n; k++) {
        const struct crest_fit *other = crests->of[index[k]];
        if (!other || other->rms > better * crests->of[i]->rms)
            continue;
        crest_fit_roles(other, point, 1, spacing, within, &role);
        if (role == CREST_SIDE)
            return true;
    }
    return false;
}

/* What is known about a crest at its first point, when its places are put. */
struct crest_about {
    const struct crest_fit *fit;
    size_t n, others;
    struct vec3 point[CREST_POINTS], other[CREST_POINTS]; /* the points that have crests, too */
    enum crest_role role[CREST_POINTS];
};

static double plan2(struct vec3 a, struct vec3 b)
{
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/* The place is nearest to this point of all that have a crest, and no other point than those that
 * the crest explains is nearer still; as seen from above. */
static bool is_here(const struct crest_about *about, struct vec3 place)
{
    double least = HUGE_VAL, own = plan2(about->point[0], place);
    enum crest_role what = CREST_OTHER;

    for (size_t k = 0; k < about->others; k++)
        if (plan2(about->other[k], place) < own)
            return false;
    for (size_t k = 0; k < about->n; k++)
        if (plan2(about->point[k], place) < least) {
            least = plan2(about->point[k], place);
            what = about->role[k];
        }
    return what != CREST_OTHER;
}

/* As far in space from all that the crest explains as it was fitted to, nobody knows of it: of
 * noise it may be as steep as anything. */
static bool is_near(const struct crest_about *about, double reach, struct vec3 place)
{
    for (size_t k = 0; k < about->n; k++)
        if (about->role[k] != CREST_OTHER && vec_distance(about->point[k], place) < reach)
            return true;
    return false;
}

/* A place of the crest or its sides, of which the point knows. */
static bool place_at(const struct crest_about *about, double reach, double s, double d,
                     struct vec3 *place)
{
    return crest_fit_at(about->fit, s, d, place) && is_here(about, *place) &&
           is_near(about, reach, *place);
}

static void add_across(const struct edge_work *work, const struct crest_about *about, double s,
                       struct vec3s *edge, struct vec3s *between)
{
    const double dense = 0.65;
    const struct crest_fit *fit = about->fit;
    double pitch = dense * work->options->along;
    double spacing = point_grid_spacing(work->options->point_grid);
    double reach = (work->lines && work->options->noise > 0 ? NOISY : ABOUT) * spacing;
    struct vec3 place;

    if (place_at(about, reach, s, 0, &place))
        *array_push(edge) = place;
    for (int side = 0; side < 2; side++) {
        double down = pitch / hypot(1, fit->c[side ? 5 : 3]);
        double far = fit->far[side] + BEYOND * spacing;
        for (double d = down; d < far; d += down)
            if (place_at(about, reach, s, side ? d : -d, &place))
                *array_push(between) = place;
    }
}

static void add_crest(const struct crests *crests, size_t i, struct vec3s *edge,
                      struct vec3s *between)
{
    const struct edge_work *work = crests->work;
    const double dense = 0.65;
    const struct point_grid *b = work->options->point_grid;
    double spacing = point_grid_spacing(b), pitch = dense * work->options->along;
    struct crest_about about = {.fit = crests->of[i]};
    size_t index[CREST_POINTS];

    if (!about.fit)
        return;
    about.n = find_about(b, i, ABOUT * spacing, about.point, index);
    for (size_t k = 1; k < about.n; k++)
        if (crests->of[index[k]])
            about.other[about.others++] = about.point[k];
    crest_fit_roles(about.fit, about.point, about.n, spacing, edge_within(work, spacing),
                    about.role);
    double from = fmax(-BESIDE * spacing, about.fit->from);
    double to = fmin(BESIDE * spacing, about.fit->to);
    for (double s = from; s <= to; s += pitch)
        add_across(work, &about, s, edge, between);
}

/* ---- of all points */

static void find_crests(void *context, size_t from, size_t to)
{
    const struct crests *crests = context;

    for (size_t i = from; i < to; i++) {
        crests->may[i] = may_have(crests->work, i);
        crests->next[i] = find_crest(crests, i);
    }
}

static void follow_crests(void *context, size_t from, size_t to)
{
    const struct crests *crests = context;

    for (size_t i = from; i < to; i++)
        crests->next[i] = follow_crest(crests, i);
}

static void find_yielding(void *context, size_t from, size_t to)
{
    const struct crests *crests = context;

    for (size_t i = from; i < to; i++)
        crests->next[i] = yields(crests, i) ? crests->of[i] : NULL;
}

static void add_crests(void *context, size_t from, size_t to)
{
    const struct crests *crests = context;

    for (size_t i = from; i < to; i++)
        add_crest(crests, i, &crests->work->found[i], &crests->work->between[i]);
}

/* Takes those found since in the place of the ones before; false: there are none. */
static bool take_next(const struct crests *crests, size_t n)
{
    bool any = false;

    for (size_t i = 0; i < n; i++)
        if (crests->next[i]) {
            free(crests->of[i]);
            crests->of[i] = crests->next[i];
            any = true;
        }
    return any;
}

static void drop_yielding(const struct crests *crests, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (crests->next[i]) {
            free(crests->of[i]);
            crests->of[i] = NULL;
        }
}

void edge_crests_add(const struct edge_work *work)
{
    enum { TURNS = 8 };
    size_t n = work->options->point_grid->n;
    int threads = work->options->threads;
    struct crests crests = {work, mem_alloc(n, sizeof *crests.may), mem_alloc(n, sizeof *crests.of),
                            mem_alloc(n, sizeof *crests.next)};

    for (size_t i = 0; i < n; i++)
        crests.of[i] = NULL;
    parallel_for(threads, n, find_crests, &crests);
    bool any = take_next(&crests, n);
    for (int turn = 0; turn < TURNS && any; turn++) {
        parallel_for(threads, n, follow_crests, &crests);
        any = take_next(&crests, n);
    }
    parallel_for(threads, n, find_yielding, &crests);
    drop_yielding(&crests, n);
    parallel_for(threads, n, add_crests, &crests);
    for (size_t i = 0; i < n; i++)
        free(crests.of[i]);
    free(crests.may);
    free(crests.of);
    free(crests.next);
}
