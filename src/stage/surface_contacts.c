/* surface_contacts - see surface_contacts.h. */
#include "surface_contacts.h"

#include <math.h>
#include <stdlib.h>

#include "base/parallel.h"
#include "curve/run.h"

/* So often intervals are halved. */
enum { HALVINGS = 8 };

/* What the threads share that put points on surfaces. */
struct projecting {
    const struct surface_contacts *rule;
    struct contact *point;
    bool *beside;
};

static void project_points(void *context, size_t from, size_t to)
{
    struct projecting *p = context;
    const struct surface_contacts *rule = p->rule;

    for (size_t i = from; i < to; i++)
        p->beside[i] = project_contact(rule->on, rule->plane, rule->reach, &p->point[i]) < 0;
}

/* ---- between two contacts */

/* Contacts of one chain.  An interval, by its first one, is `on` the surfaces if both ends are. */
struct chain_points {
    struct contacts point;
    struct {
        size_t n, cap;
        bool *item;
    } on;
};

static void chain_points_add(struct chain_points *chain, struct contact contact, bool on)
{
    *array_push(&chain->point) = contact;
    *array_push(&chain->on) = on;
}

static void chain_points_free(struct chain_points *chain)
{
    array_free(&chain->point);
    array_free(&chain->on);
}

/* What the threads share that look at the intervals of a chain. */
struct halving {
    const struct surface_contacts *rule;
    const struct chain_points *chain;
    const struct run *run; /* their centres */
    const struct vec3 *tangent;
    struct contact *middle;
    bool *off; /* the curve is, of what the surface has there */
};

static struct run run_of(const struct contacts *points, double radius)
{
    struct run run = {.radius = radius};

    for (size_t i = 0; i < points->n; i++) {
        struct contact c = points->item[i];
        struct vec3 ball = vec_along(c.p, radius, c.n);
        *array_push(&run) =
            (struct run_point){.tip = ball, .ball = ball, .contact = c.p, .normal = c.n};
    }
    return run;
}

static void halve(void *context, size_t from, size_t to)
{
    struct halving *h = context;
    const struct surface_contacts *rule = h->rule;

    for (size_t i = from; i < to; i++) {
        const struct contact *a = &h->chain->point.item[i], *b = a + 1;
        struct contact middle = {vec_mix(a->p, b->p, 0.5), vec_unit(vec_add(a->n, b->n))};
        h->off[i] = h->chain->on.item[i] &&
                    project_contact(rule->on, rule->plane, rule->reach, &middle) >= 0;
        if (!h->off[i])
            continue;
        struct vec3 ball = vec_along(middle.p, rule->radius, middle.n);
        h->middle[i] = middle;
        struct vec3 curve = run_middle(h->run, h->tangent, i);
        h->off[i] = fabs(vec_dot(vec_sub(curve, ball), middle.n)) > rule->off;
    }
}

/* Puts contacts between where the curve is off; `finer` is what comes of it.  False: nowhere. */
static bool halve_chain(const struct surface_contacts *rule, const struct chain_points *chain,
                        struct chain_points *finer)
{
    size_t n = chain->point.n;
    struct run run = run_of(&chain->point, rule->radius);
    struct vec3 *tangent = mem_alloc(n, sizeof *tangent);
    struct halving h = {.rule = rule,
                        .chain = chain,
                        .run = &run,
                        .tangent = tangent,
                        .middle = mem_alloc(n, sizeof *h.middle),
                        .off = mem_alloc(n, sizeof *h.off)};

    run_tangents(&run, false, tangent);
    parallel_for(rule->threads, n - 1, halve, &h);
    for (size_t i = 0; i < n; i++) {
        chain_points_add(finer, chain->point.item[i], chain->on.item[i]);
        if (i + 1 < n && h.off[i])
            chain_points_add(finer, h.middle[i], true);
    }
    array_free(&run);
    free(tangent);
    free(h.middle);
    free(h.off);
    return finer->point.n > n;
}

/* Appends to `points` the contacts [from, to), and those between them. */
static void refine(const struct surface_contacts *rule, const struct projecting *put, size_t from,
                   size_t to, struct contacts *points)
{
    struct chain_points chain = {0};
    bool more = to > from + 1;

    for (size_t i = from; i < to; i++)
        chain_points_add(&chain, put->point[i],
                         i + 1 < to && !put->beside[i] && !put->beside[i + 1]);
    for (int k = 0; more && k < HALVINGS; k++) {
        struct chain_points finer = {0};
        more = halve_chain(rule, &chain, &finer);
        chain_points_free(&chain);
        chain = finer;
    }
    for (size_t i = 0; i < chain.point.n; i++)
        *array_push(points) = chain.point.item[i];
    chain_points_free(&chain);
}

size_t surface_contacts_put(const struct surface_contacts *rule, struct slice_chains *chains)
{
    size_t n = chains->point.n, beside = 0;
    struct projecting put = {rule, chains->point.item, mem_alloc(n + 1, sizeof *put.beside)};
    struct contacts points = {0};

    parallel_for(rule->threads, n, project_points, &put);
    for (size_t i = 0; i < n; i++)
        beside += put.beside[i];
    for (size_t k = 0; k < chains->chain.n; k++) {
        struct slice_chain *chain = &chains->chain.item[k];
        size_t from = points.n;
        refine(rule, &put, chain->from, chain->to, &points);
        chain->from = from;
        chain->to = points.n;
    }
    array_free(&chains->point);
    chains->point = points;
    free(put.beside);
    return beside;
}
