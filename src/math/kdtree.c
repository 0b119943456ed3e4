/*
 * kdtree - nearest points by the planes that part the tree: the distance to a node's cell is
 * carried down and changed in one coordinate at a time (Arya and Mount 1993).  Ways through the
 * tree are in kdtree_beside.c.
 */
#include "math/kdtree.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "kdnodes.h"

enum { ON_STACK = 256 };

/* So many points about equally far are not sorted by insertion. */
enum { CROWD = 32 };

struct kdtree *kdtree_new(const struct vec3 *point, size_t n)
{
    return kdnodes_build(point, n, 1);
}

struct kdtree *kdtree_new_by(const struct vec3 *point, size_t n, int threads)
{
    return kdnodes_build(point, n, threads);
}

void kdtree_free(struct kdtree *tree)
{
    kdnodes_free(tree);
}

static double square(double x)
{
    return x * x;
}

/* The nearest points so far: a heap with the farthest of them on top. */
struct nearest {
    const struct kdtree *tree;
    double q[3];
    double off[3]; /* from q to the box of the node in hand, in each coordinate */
    size_t k, n;
    size_t *index;
    double *distance2;
};

/* Puts a point where `at` is free, among the first n, those under it nearer; among equals the
 * larger index is the farther. */
static void settle(struct nearest *s, size_t at, size_t n, size_t index, double distance2)
{
    size_t *all = s->index;
    double *d2 = s->distance2;

    for (size_t child; (child = 2 * at + 1) < n; at = child) {
        if (child + 1 < n && (d2[child + 1] > d2[child] ||
                              (d2[child + 1] == d2[child] && all[child + 1] > all[child])))
            child++;
        if (d2[child] < distance2 || (d2[child] == distance2 && all[child] < index))
            break;
        all[at] = all[child];
        d2[at] = d2[child];
    }
    all[at] = index;
    d2[at] = distance2;
}

static void offer(struct nearest *s, const struct kd_point *p)
{
    double d2 = kd_distance2(p->c, s->q);

    if (s->n < s->k) {
        s->index[s->n] = p->index;
        s->distance2[s->n++] = d2;
        for (size_t at = s->n == s->k ? s->k / 2 : 0; at-- > 0;)
            settle(s, at, s->k, s->index[at], s->distance2[at]);
        return;
    }
    if (d2 < s->distance2[0] || (d2 == s->distance2[0] && p->index < s->index[0]))
        settle(s, 0, s->n, p->index, d2);
}

/* `box2` is the squared distance from q to the box of [from, to). */
static void search_nearest(struct nearest *s, size_t from, size_t to, double box2)
{
    if (to - from <= KD_LEAF) {
        for (size_t i = from; i < to; i++)
            offer(s, &s->tree->point[i]);
        return;
    }
    size_t middle = from + (to - from) / 2;
    int axis = s->tree->axis[middle];
    double beyond = s->tree->point[middle].c[axis] - s->q[axis], before = s->off[axis];
    bool left = beyond >= 0;

    if (left)
        search_nearest(s, from, middle, box2);
    else
        search_nearest(s, middle + 1, to, box2);
    offer(s, &s->tree->point[middle]);
    double far2 = box2 - square(before) + square(beyond);
    if (s->n < s->k || far2 * (1 - 1e-12) <= s->distance2[0]) {
        s->off[axis] = beyond;
        if (left)
            search_nearest(s, middle + 1, to, far2);
        else
            search_nearest(s, from, middle, far2);
        s->off[axis] = before;
    }
}

/* The farthest to the end, again and again. */
static void sort_heap(struct nearest *s)
{
    for (size_t last = s->n - 1; last > 0; last--) {
        size_t index = s->index[last];
        double distance2 = s->distance2[last];
        s->index[last] = s->index[0];
        s->distance2[last] = s->distance2[0];
        settle(s, 0, last, index, distance2);
    }
}

/* The same by a histogram of the distances, which on a surface is even, and what it leaves by
 * insertion.  False: they are too many, or many are about equally far. */
static bool sort_evenly(struct nearest *s)
{
    size_t begin[ON_STACK + 1] = {0}, index[ON_STACK], n = s->n;
    double d2[ON_STACK], scale = (double)n / s->distance2[0];
    unsigned char part[ON_STACK];
    if (n > ON_STACK || !(s->distance2[0] > 0) || !isfinite(scale))
        return false;
    for (size_t i = 0; i < n; i++) {
        size_t at = (size_t)(s->distance2[i] * scale);
        part[i] = (unsigned char)(at < n ? at : n - 1);
        if (++begin[part[i] + 1] > CROWD)
            return false;
    }
    for (size_t i = 0; i < n; i++)
        begin[i + 1] += begin[i];
    for (size_t i = 0; i < n; i++) {
        size_t at = begin[part[i]]++;
        index[at] = s->index[i];
        d2[at] = s->distance2[i];
    }
    for (size_t i = 0; i < n; i++) {
        size_t at = i;
        for (; at > 0 && (s->distance2[at - 1] > d2[i] ||
                          (s->distance2[at - 1] == d2[i] && s->index[at - 1] > index[i]));
             at--) {
            s->index[at] = s->index[at - 1];
            s->distance2[at] = s->distance2[at - 1];
        }
        s->index[at] = index[i];
        s->distance2[at] = d2[i];
    }
    return true;
}

size_t kdtree_nearest(const struct kdtree *tree, struct vec3 q, size_t k, size_t *index,
                      double *distance2)
{
    double stack[ON_STACK], *own = NULL;

    if (k > tree->n)
        k = tree->n;
    if (k == 0)
        return 0;
    if (!distance2)
        distance2 = k <= ON_STACK ? stack : (own = mem_alloc(k, sizeof *own));
    struct nearest s = {tree, {q.x, q.y, q.z}, {0, 0, 0}, k, 0, index, distance2};
    search_nearest(&s, 0, tree->n, 0);
    if (!sort_evenly(&s))
        sort_heap(&s);
    free(own);
    return k;
}

static void search_within(const struct kdtree *tree, const double q[3], double radius, size_t from,
                          size_t to, struct sizes *found)
{
    double radius2 = square(radius);

    while (to - from > KD_LEAF) {
        size_t middle = from + (to - from) / 2;
        int axis = tree->axis[middle];
        double beyond = tree->point[middle].c[axis] - q[axis];

        if (kd_distance2(tree->point[middle].c, q) <= radius2)
            *array_push(found) = tree->point[middle].index;
        if (square(beyond) <= radius2)
            search_within(tree, q, radius, middle + 1, to, found);
        if (beyond >= 0 || square(beyond) <= radius2)
            to = middle;
        else
            from = middle + 1;
    }
    for (size_t i = from; i < to; i++) {
        if (kd_distance2(tree->point[i].c, q) <= radius2)
            *array_push(found) = tree->point[i].index;
    }
}

void kdtree_within(const struct kdtree *tree, struct vec3 q, double radius, struct sizes *found)
{
    double c[3] = {q.x, q.y, q.z};

    if (tree->n > 0 && radius >= 0)
        search_within(tree, c, radius, 0, tree->n, found);
}
