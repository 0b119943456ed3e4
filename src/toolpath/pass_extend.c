/* pass_extend - see pass_extend.h. */
#include "toolpath/pass_extend.h"

#include <stdlib.h>

#include "toolpath/passes.h"

enum { HALVINGS = 6 };
static const double LEAST = 0.1; /* of a step, along the plane: on walls it would go to and fro */

static const double LITTLE = 0.1; /* of a step: not worth a point */

/* A contact so far on in its plane, up (way 1) or down (-1) along. */
static struct contact contact_ahead(const struct border_surface_plane *plane, struct contact c,
                                    double way, double distance)
{
    struct vec3 forward = vec_unit(vec_cross(plane->normal, c.n));

    if (vec_dot(forward, plane->along) * way < 0)
        forward = vec_scale(-1, forward);
    return (struct contact){vec_along(c.p, distance, forward), c.n};
}

/* How far on one place is from another along the plane. */
static double on_by(const struct border_surface_plane *plane, struct vec3 from, struct vec3 to,
                    double way)
{
    return vec_dot(vec_sub(to, from), plane->along) * way;
}

/* It is no farther on than `stop`, which is so far along the plane. */
static bool is_before(const struct border_surface_plane *plane, struct vec3 p, double stop,
                      double way)
{
    return (vec_dot(p, plane->along) - stop) * way < 0;
}

/* The last place before the border of the scan, or `stop`, less than a step on: none that the
 * surface moves back. */
static void follow_to_border(const struct border_surface *b,
                             const struct border_surface_plane *plane, struct contact c, double way,
                             double stop, struct contacts *run)
{
    struct contact last = c;
    double on = 0, off = border_surface_step(b);

    for (int i = 0; i < HALVINGS; i++) {
        double middle = (on + off) / 2;
        struct contact next = contact_ahead(plane, c, way, middle);
        if (border_surface_move(b, plane, &next) && on_by(plane, last.p, next.p, way) > 0 &&
            is_before(plane, next.p, stop, way)) {
            on = middle;
            last = next;
        } else {
            off = middle;
        }
    }
    if (on > LITTLE * border_surface_step(b))
        *array_push(run) = last;
}

/* Appends what follows c, up to the border of the scan or, along the plane, to `stop`; nothing
 * where the scan goes on. */
static void follow_scan(const struct border_surface *b, const struct border_surface_plane *plane,
                        struct contact c, double way, double stop, struct contacts *run)
{
    size_t first = run->n;

    for (;;) {
        struct contact next = contact_ahead(plane, c, way, border_surface_step(b));
        if (!border_surface_move(b, plane, &next)) {
            follow_to_border(b, plane, c, way, stop, run);
            return;
        }
        if (on_by(plane, c.p, next.p, way) < LEAST * border_surface_step(b) ||
            !is_before(plane, next.p, stop, way))
            return;
        if (!border_surface_beside(b, next.p)) {
            run->n = first;
            return;
        }
        *array_push(run) = next;
        c = next;
    }
}

/* A strip while it is extended: what of it was there, and what comes before (backward) and after.
 */
struct extension {
    const struct contact *core;
    size_t n;
    bool closed, other; /* other: of another plane, only to stop at */
    double low, high;   /* along the plane */
    struct contacts before, after;
};

struct extensions {
    size_t n, cap;
    struct extension *item;
};

static void widen_range(const struct border_surface_plane *plane, const struct contact *c, size_t n,
                        struct extension *g)
{
    for (size_t i = 0; i < n; i++) {
        double at = vec_dot(c[i].p, plane->along);
        g->low = fmin(g->low, at);
        g->high = fmax(g->high, at);
    }
}

static struct extension extension_of(const struct border_surface_plane *plane,
                                     const struct slice_chains *chains, size_t k)
{
    const struct slice_chain *chain = &chains->chain.item[k];
    struct extension g = {.core = &chains->point.item[chain->from],
                          .n = chain->to - chain->from,
                          .closed = chain->closed,
                          .low = HUGE_VAL,
                          .high = -HUGE_VAL};

    widen_range(plane, g.core, g.n, &g);
    return g;
}

static void add_strips(const struct border_surface_plane *plane, const struct slice_chains *strips,
                       bool other, struct extensions *all)
{
    for (size_t k = 0; k < strips->chain.n; k++) {
        struct extension g = extension_of(plane, strips, k);
        g.other = other;
        *array_push(all) = g;
    }
}

/* Both ends of strip k, up to where the others are. */
static void extend_ends(const struct border_surface *b, const struct border_surface_plane *plane,
                        struct extensions *all, size_t k)
{
    struct extension *g = &all->item[k];
    double low = -HUGE_VAL, high = HUGE_VAL;

    if (g->closed)
        return;
    for (size_t i = 0; i < all->n; i++) {
        const struct extension *other = &all->item[i];
        if (i != k && other->low > g->high)
            high = fmin(high, other->low);
        if (i != k && other->high < g->low)
            low = fmax(low, other->high);
    }
    follow_scan(b, plane, g->core[0], -1, low, &g->before);
    follow_scan(b, plane, g->core[g->n - 1], 1, high, &g->after);
    widen_range(plane, g->before.item, g->before.n, g);
    widen_range(plane, g->after.item, g->after.n, g);
}

static int compare_extensions(const void *pa, const void *pb)
{
    const struct extension *a = pa, *b = pb;

    return (a->low > b->low) - (a->low < b->low);
}

/* The strips as they have become, in order; those that meet are one. */
static struct slice_chains join_extended(const struct border_surface *b, struct extensions *all)
{
    struct slice_chains to = {0};

    if (all->n > 1)
        qsort(all->item, all->n, sizeof *all->item, compare_extensions);
    for (size_t k = 0; k < all->n; k++) {
        struct extension *g = &all->item[k];
        if (g->other)
            continue;
        size_t from = to.point.n;
        const struct contact *start = g->before.n > 0 ? &g->before.item[g->before.n - 1] : g->core;
        bool meets =
            to.chain.n > 0 && !g->closed && !to.chain.item[to.chain.n - 1].closed &&
            vec_distance(to.point.item[from - 1].p, start->p) < 1.01 * border_surface_step(b);
        for (size_t i = g->before.n; i-- > 0;)
            *array_push(&to.point) = g->before.item[i];
        for (size_t i = 0; i < g->n; i++)
            *array_push(&to.point) = g->core[i];
        for (size_t i = 0; i < g->after.n; i++)
            *array_push(&to.point) = g->after.item[i];
        if (meets)
            to.chain.item[to.chain.n - 1].to = to.point.n;
        else
            *array_push(&to.chain) = (struct slice_chain){from, to.point.n, g->closed};
        array_free(&g->before);
        array_free(&g->after);
    }
    all->n = 0;
    return to;
}

size_t pass_extend_within(const struct border_surface *b, struct slice_chains *strips)
{
    struct slice_chains to = {0};
    size_t left_out = 0;

    for (size_t k = 0; k < strips->chain.n; k++) {
        const struct slice_chain *chain = &strips->chain.item[k];
        size_t from = to.point.n, before = left_out;
        for (size_t i = chain->from; i < chain->to; i++) {
            const struct contact *c = &strips->point.item[i];
            if (chain->closed || border_surface_within(b, c)) {
                *array_push(&to.point) = *c;
                continue;
            }
            left_out++;
            slice_chains_end(&to, from, false);
            from = to.point.n;
        }
        slice_chains_end(&to, from, false);
        if (left_out == before && chain->closed)
            to.chain.item[to.chain.n - 1].closed = true;
    }
    slice_chains_free(strips);
    *strips = to;
    return left_out;
}

double pass_extend_ends(const struct border_surface *b, const struct border_surface_plane *plane,
                        struct slice_chains *strips)
{
    struct extensions all = {0};
    double length = slice_chains_length(strips);

    add_strips(plane, strips, false, &all);
    for (size_t k = 0; k < all.n; k++)
        extend_ends(b, plane, &all, k);
    struct slice_chains longer = join_extended(b, &all);
    slice_chains_free(strips);
    *strips = longer;
    array_free(&all);
    return slice_chains_length(strips) - length;
}

/* Does the scan end beside the mesh, going on from a place in a plane to the next planes (way 1 or
 * -1)? */
static bool ends_beyond(const struct border_surface *b, struct border_surface_plane plane,
                        struct contact c, double way)
{
    while (border_surface_beside(b, c.p)) {
        struct vec3 level = vec_reject(plane.normal, c.n);
        double level2 = vec_dot(level, level), step = border_surface_step(b) * sqrt(level2);
        plane.height += way * step;
        c.p = vec_along(c.p, way * step / level2, level);
        if (!(level2 > 0) || !border_surface_move(b, &plane, &c))
            return true;
    }
    return false;
}

/* A place of a neighbouring plane carried over to this one. */
static bool carry_point(const struct border_surface *b, const struct border_surface_plane *plane,
                        struct contact *c)
{
    double way = plane->height - vec_dot(c->p, plane->normal);
    struct vec3 level = vec_reject(plane->normal, c->n);
    double level2 = vec_dot(level, level);

    if (!(level2 > 0))
        return false;
    c->p = vec_along(c->p, way / level2, level);
    return border_surface_may_be_beside(b, c->p) && border_surface_move(b, plane, c) &&
           border_surface_beside(b, c->p) && ends_beyond(b, *plane, *c, way < 0 ? -1 : 1);
}

static bool is_covered(const struct extensions *all, double at)
{
    for (size_t i = 0; i < all->n; i++) {
        if (at >= all->item[i].low && at <= all->item[i].high)
            return true;
    }
    return false;
}

/* What of n contacts can be carried over, as chains: one ends where a contact can't. */
static void carry_over(const struct border_surface *b, const struct border_surface_plane *plane,
                       const struct contact *c, size_t n, const struct extensions *all,
                       struct slice_chains *pieces)
{
    size_t from = pieces->point.n;

    for (size_t i = 0; i < n; i++) {
        double length = i + 1 < n ? vec_distance(c[i].p, c[i + 1].p) : 0;
        double parts = fmax(1, ceil(length / border_surface_step(b)));
        for (double k = 0; k < parts; k++) {
            size_t next = i + 1 < n ? i + 1 : i;
            struct contact at = {vec_mix(c[i].p, c[next].p, k / parts),
                                 vec_unit(vec_mix(c[i].n, c[next].n, k / parts))};
            if (!is_covered(all, vec_dot(at.p, plane->along)) && carry_point(b, plane, &at)) {
                *array_push(&pieces->point) = at;
                continue;
            }
            if (pieces->point.n > from)
                *array_push(&pieces->chain) = (struct slice_chain){from, pieces->point.n, false};
            from = pieces->point.n;
        }
    }
    if (pieces->point.n > from)
        *array_push(&pieces->chain) = (struct slice_chain){from, pieces->point.n, false};
}

static void drop_last(struct extensions *all)
{
    struct extension *last = &all->item[--all->n];

    array_free(&last->before);
    array_free(&last->after);
}

/* The pieces as strips, each grown; returns how many of them are long enough. */
static size_t add_pieces(const struct border_surface *b, const struct border_surface_plane *plane,
                         const struct slice_chains *pieces, double shortest, struct extensions *all)
{
    size_t before = all->n;

    for (size_t k = 0; k < pieces->chain.n; k++) {
        struct extension g = extension_of(plane, pieces, k);
        if (is_covered(all, (g.low + g.high) / 2)) /* by what the last piece has become */
            continue;
        *array_push(all) = g;
        extend_ends(b, plane, all, all->n - 1);
        if (all->item[all->n - 1].high - all->item[all->n - 1].low < shortest)
            drop_last(all);
    }
    return all->n - before;
}

double pass_extend_beside(const struct border_surface *b, const struct border_surface_plane *plane,
                          const struct pass_extend_neighbours *beside, double shortest,
                          struct slice_chains *strips)
{
    struct extensions all = {0};
    struct slice_chains pieces = {0};
    const struct slice_chains *from = beside->from;
    double length = slice_chains_length(strips);

    add_strips(plane, strips, false, &all);
    if (beside->beyond)
        add_strips(plane, beside->beyond, true, &all);
    for (size_t k = 0; k < from->chain.n; k++) {
        const struct slice_chain *chain = &from->chain.item[k];
        if (!chain->closed)
            carry_over(b, plane, &from->point.item[chain->from], chain->to - chain->from, &all,
                       &pieces);
    }
    if (add_pieces(b, plane, &pieces, shortest, &all) > 0) {
        struct slice_chains more = join_extended(b, &all);
        slice_chains_free(strips);
        *strips = more;
    }
    array_free(&all);
    slice_chains_free(&pieces);
    return slice_chains_length(strips) - length;
}
