/* rest_chain - see rest_chain.h. */
#include "rest_chain.h"

#include <stdlib.h>

#include "math/kdtree.h"

static const double ALIKE = 0.5; /* cosine: points of a strip face the same way */
static const double AHEAD = 0.2; /* cosine: a strip turns by no more at a point */

struct chainer {
    const struct contacts *points;
    const struct kdtree *tree;
    bool *used;
    double gap, beside;
    struct sizes found;
};

static struct vec3 place(const struct chainer *c, size_t i)
{
    return c->points->item[i].p;
}

static bool face_alike(const struct chainer *c, size_t i, size_t k)
{
    return vec_dot(c->points->item[i].n, c->points->item[k].n) > ALIKE;
}

/* The next point of a chain that has come to point i by way of `ahead` (zero: by none): the
 * nearest, where a turn counts as way.  points->n: there is none. */
static size_t next_point(struct chainer *c, size_t i, struct vec3 ahead)
{
    size_t best = c->points->n;
    double least = HUGE_VAL;

    c->found.n = 0;
    kdtree_within(c->tree, place(c, i), c->gap, &c->found);
    for (size_t m = 0; m < c->found.n; m++) {
        size_t k = c->found.item[m];
        struct vec3 way = vec_sub(place(c, k), place(c, i));
        double far = vec_length(way), cosine = vec_dot(vec_unit(way), ahead);
        bool first = vec_length(ahead) < 0.5;
        if (c->used[k] || k == i || !face_alike(c, i, k) || (!first && cosine < AHEAD))
            continue;
        far *= first ? 1 : 2 - cosine;
        if (far < least || (far == least && k < best)) {
            least = far;
            best = k;
        }
    }
    return best;
}

/* What the ball cuts on its way from one point to another. */
static void use_beside(struct chainer *c, size_t from, size_t to)
{
    struct vec3 a = place(c, from), b = place(c, to);

    c->found.n = 0;
    kdtree_within(c->tree, vec_mix(a, b, 0.5), vec_distance(a, b) / 2 + c->beside, &c->found);
    for (size_t m = 0; m < c->found.n; m++) {
        size_t k = c->found.item[m];
        if (vec_segment_distance(a, b, place(c, k)) <= c->beside && face_alike(c, to, k))
            c->used[k] = true;
    }
    c->used[from] = c->used[to] = true;
}

/* Goes on from the last of the chain as far as there are points. */
static void grow(struct chainer *c, struct sizes *chain)
{
    for (;;) {
        size_t last = chain->item[chain->n - 1];
        struct vec3 ahead = {0, 0, 0};
        if (chain->n > 1)
            ahead = vec_unit(vec_sub(place(c, last), place(c, chain->item[chain->n - 2])));
        size_t next = next_point(c, last, ahead);
        if (next == c->points->n)
            return;
        c->used[next] = true;
        *array_push(chain) = next;
    }
}

/* Leaves points out of the chain that are cut on the straight way past them, as long as that is no
 * longer than the gap. */
static void straighten(const struct chainer *c, struct sizes *chain)
{
    size_t kept = 1;

    for (size_t i = 1, to; i < chain->n; i = to + 1) {
        struct vec3 from = place(c, chain->item[kept - 1]);
        bool spare = true;
        for (to = i; to + 1 < chain->n && spare;) {
            struct vec3 next = place(c, chain->item[to + 1]);
            spare = vec_distance(from, next) <= c->gap;
            for (size_t k = i; k <= to && spare; k++)
                spare = vec_segment_distance(from, next, place(c, chain->item[k])) <= c->beside;
            to += spare;
        }
        chain->item[kept++] = chain->item[to];
    }
    chain->n = kept;
}

static void reverse(struct sizes *chain)
{
    for (size_t i = 0, k = chain->n; i + 1 < k; i++) {
        size_t swap = chain->item[i];
        chain->item[i] = chain->item[--k];
        chain->item[k] = swap;
    }
}

/* Square to the surface along the chain. */
static struct vec3 plane_of(const struct contacts *c)
{
    struct vec3 normal = {0, 0, 0}, way = vec_sub(c->item[c->n - 1].p, c->item[0].p);

    for (size_t i = 0; i < c->n; i++)
        normal = vec_add(normal, c->item[i].n);
    struct vec3 plane = vec_unit(vec_cross(way, normal));
    return vec_length(plane) > 0.5 ? plane : vec_perpendicular(vec_unit(normal));
}

void rest_chain_points(const struct contacts *points, double gap, double beside,
                       struct rest_strips *strips)
{
    struct vec3s at = {0};
    struct sizes chain = {0};
    struct chainer c = {.points = points,
                        .used = mem_alloc(points->n + 1, sizeof *c.used),
                        .gap = gap,
                        .beside = beside};

    for (size_t i = 0; i < points->n; i++) {
        *array_push(&at) = points->item[i].p;
        c.used[i] = false;
    }
    struct kdtree *tree = kdtree_new(at.item, at.n);
    c.tree = tree;
    for (size_t i = 0; i < points->n; i++) {
        if (c.used[i])
            continue;
        chain.n = 0;
        *array_push(&chain) = i;
        c.used[i] = true;
        grow(&c, &chain);
        reverse(&chain);
        grow(&c, &chain);
        straighten(&c, &chain);
        for (size_t k = 0; k < chain.n; k++)
            use_beside(&c, chain.item[k > 0 ? k - 1 : 0], chain.item[k]);
        struct rest_strip strip = {.planes = {0, 0, 0}};
        for (size_t k = 0; k < chain.n; k++)
            *array_push(&strip.contact) = points->item[chain.item[k]];
        strip.planes = plane_of(&strip.contact);
        *array_push(strips) = strip;
    }
    kdtree_free(tree);
    array_free(&at);
    array_free(&chain);
    array_free(&c.found);
    free(c.used);
}
