/* plan_star - see plan_star.h. */
#include "plan_star.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/parallel.h"
#include "math/predicates.h"

/* Corners about one point, at most; points one of which is a corner of the facet about a place. */
enum { STAR = 64, NEAREST = 4 };

struct star_work {
    const struct point_grid *scan;
    const struct plan_star_options *options;
    bool *corner; /* of each point: facets are looked for about it */
    plan_star_facet *facet;
    void *context;
};

static int by_distance(const void *pa, const void *pb)
{
    const struct plan_beside *a = pa, *b = pb;

    return a->far2 != b->far2 ? (a->far2 > b->far2) - (a->far2 < b->far2)
                              : (a->index > b->index) - (a->index < b->index);
}

/* A long way goes up or down steeply from the point to one near to it. */
static bool is_steep(const struct star_work *work, size_t i)
{
    const struct point_grid *g = work->scan;
    struct vec3 p = g->point[i];
    double reach = work->options->near, least = work->options->least;
    struct point_grid_walk walk = point_grid_about(g, p, reach);

    for (size_t k; point_grid_next(&walk, &k);) {
        struct vec3 to = vec_sub(g->point[k], p);
        double far2 = to.x * to.x + to.y * to.y, up2 = to.z * to.z;
        if (far2 < reach * reach && up2 > far2 && up2 + far2 > least * least)
            return true;
    }
    return false;
}

bool plan_star_about(const struct point_grid *g, size_t i, double reach, struct plan_about *about)
{
    struct vec3 p = g->point[i];
    struct point_grid_walk walk = point_grid_about(g, p, reach);

    about->n = 0;
    for (size_t k; point_grid_next(&walk, &k);) {
        struct uv at = {g->point[k].x - p.x, g->point[k].y - p.y};
        double far2 = at.u * at.u + at.v * at.v;
        if (far2 >= reach * reach || far2 == 0)
            continue;
        if (about->n == PLAN_STAR_CROWD)
            return false;
        about->item[about->n++] = (struct plan_beside){at, far2, (uint32_t)k};
    }
    if (about->n > 0)
        qsort(about->item, about->n, sizeof *about->item, by_distance);
    return about->n > 0;
}

size_t plan_star_corner(const struct plan_about *about, struct uv a, struct uv b)
{
    size_t best = PLAN_STAR_NONE;

    for (size_t k = 0; k < about->n; k++) {
        struct uv at = about->item[k].at;
        if (orient2d(a, b, at) > 0 &&
            (best == PLAN_STAR_NONE || incircle(a, b, about->item[best].at, at) > 0))
            best = k;
    }
    return best;
}

/* The points nearest to a place, seen from above, nearest first; returns how many. */
static size_t nearest_to(const struct point_grid *g, struct vec3 place, double reach,
                         struct plan_beside near[NEAREST])
{
    struct point_grid_walk walk = point_grid_about(g, place, reach);
    size_t n = 0;

    for (size_t k; point_grid_next(&walk, &k);) {
        struct uv at = {g->point[k].x - place.x, g->point[k].y - place.y};
        struct plan_beside beside = {at, at.u * at.u + at.v * at.v, (uint32_t)k};
        if (beside.far2 > reach * reach || (n == NEAREST && beside.far2 >= near[n - 1].far2))
            continue;
        n += n < NEAREST;
        size_t j = n - 1;
        for (; j > 0 && near[j - 1].far2 > beside.far2; j--)
            near[j] = near[j - 1];
        near[j] = beside;
    }
    return n;
}

/* The facet at a point, with those about it, that a place seen from it is in. */
static bool is_in_star(const struct plan_about *about, struct uv place, size_t *left, size_t *right)
{
    const struct uv zero = {0, 0};
    size_t b = 0;

    for (int turn = 0; turn < STAR; turn++) {
        struct uv from = about->item[b].at;
        size_t c = plan_star_corner(about, zero, from);
        if (c == PLAN_STAR_NONE)
            return false;
        struct uv to = about->item[c].at;
        if (!(orient2d(zero, from, place) < 0) && !(orient2d(from, to, place) < 0) &&
            !(orient2d(to, zero, place) < 0)) {
            *left = b;
            *right = c;
            return true;
        }
        b = c;
        if (b == 0)
            return false;
    }
    return false;
}

bool plan_star_over(const struct point_grid *scan, struct vec3 place, double reach,
                    size_t corner[3])
{
    struct plan_beside near[NEAREST];
    size_t n = nearest_to(scan, place, reach, near);
    struct plan_about *about = mem_alloc(1, sizeof *about);
    bool found = false;

    for (size_t k = 0; k < n && !found; k++) {
        size_t left, right;
        struct uv seen = {-near[k].at.u, -near[k].at.v};
        found = plan_star_about(scan, near[k].index, reach, about) &&
                is_in_star(about, seen, &left, &right);
        if (found) {
            corner[0] = near[k].index;
            corner[1] = about->item[left].index;
            corner[2] = about->item[right].index;
        }
    }
    free(about);
    return found;
}

/* Diameter of the circle through the origin and two places. */
static double circle_of(struct uv a, struct uv b)
{
    double area2 = fabs(a.u * b.v - a.v * b.u);
    double product = hypot(a.u, a.v) * hypot(b.u, b.v) * hypot(a.u - b.u, a.v - b.v);

    return area2 > 0 ? product / area2 : HUGE_VAL;
}

/* Facets are looked for about both points, and about the first of them first. */
static bool is_before(const struct star_work *work, size_t i, size_t other)
{
    return i < other || !work->corner[other];
}

/* The facet of point i and two about it, if it is to be found about this one. */
static void tell_of(const struct star_work *work, size_t i, const struct plan_about *about,
                    const struct plan_beside *left, const struct plan_beside *right,
                    struct plan_about *other)
{
    if (is_before(work, i, left->index) && is_before(work, i, right->index) &&
        !(circle_of(left->at, right->at) > work->options->gap))
        work->facet(work->context, about, (size_t[]){i, left->index, right->index}, other);
}

/* The facets about point i: counter-clockwise from the point nearest to it, which is next to it,
 * and where they end, at a gap, clockwise, too. */
static void go_round(const struct star_work *work, size_t i, const struct plan_about *about,
                     struct plan_about *other)
{
    const struct uv zero = {0, 0};
    bool back = false;
    size_t b = 0;

    for (int turn = 0; turn < STAR; turn++) {
        struct uv at = about->item[b].at;
        size_t c = back ? plan_star_corner(about, at, zero) : plan_star_corner(about, zero, at);
        if (c == PLAN_STAR_NONE && back)
            return;
        if (c == PLAN_STAR_NONE) {
            back = true;
            b = 0;
            continue;
        }
        tell_of(work, i, about, &about->item[back ? c : b], &about->item[back ? b : c], other);
        b = c;
        if (b == 0)
            return;
    }
}

static void find_corners(void *context, size_t from, size_t to)
{
    const struct star_work *work = context;
    struct plan_about *about = mem_alloc(1, sizeof *about);

    for (size_t i = from; i < to; i++)
        work->corner[i] =
            is_steep(work, i) && plan_star_about(work->scan, i, work->options->gap, about);
    free(about);
}

static void find_facets(void *context, size_t from, size_t to)
{
    const struct star_work *work = context;
    struct plan_about *about = mem_alloc(2, sizeof *about);

    for (size_t i = from; i < to; i++)
        if (work->corner[i] && plan_star_about(work->scan, i, work->options->gap, &about[0]))
            go_round(work, i, &about[0], &about[1]);
    free(about);
}

void plan_star_facets(const struct point_grid *scan, const struct plan_star_options *options,
                      plan_star_facet *facet, void *context)
{
    struct star_work work = {.scan = scan,
                             .options = options,
                             .corner = mem_alloc(scan->n + 1, sizeof *work.corner),
                             .facet = facet,
                             .context = context};

    parallel_for(options->threads, scan->n, find_corners, &work);
    parallel_for(options->threads, scan->n, find_facets, &work);
    free(work.corner);
}
