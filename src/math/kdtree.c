/* kdtree - see kdtree.h: the tree is built; nearest points and neighbourhoods. */
#include "math/kdtree.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/parallel.h"
#include "kdtree_parts.h"

enum { SOME = 200 };

/* Nodes with lower numbers hand their halves to two threads, where that many points are worth it.
 */
enum { TOP = 8, WORTH = 50000 };

enum { PART = 128 }; /* points that are told apart from a pivot at once */

static void swap_points(struct kd_point *a, struct kd_point *b)
{
    struct kd_point t = *a;
    *a = *b;
    *b = t;
}

/* Of three coordinates the middle one. */
static double middle_of(double a, double b, double c)
{
    return a < b ? (b < c ? b : fmax(a, c)) : (a < c ? a : fmax(b, c));
}

/* Points of a part that may have to go to the other side of a pivot: how far from where the part
 * begins, in the order of a look through it. */
struct strangers {
    size_t n, at; /* how many, and how many of them have gone */
    unsigned char by[PART];
};

/* Those that are not before the pivot in the part from p on, and those that are not after it in
 * the part from p down: found without a jump, for none is foreseen. */
static void find_strangers(struct strangers *s, const struct kd_point *p, int axis, double pivot)
{
    s->n = s->at = 0;
    for (int k = 0; k < PART; k++) {
        s->by[s->n] = (unsigned char)k;
        s->n += !(p[k].c[axis] < pivot);
    }
}

static void find_strangers_down(struct strangers *s, const struct kd_point *p, int axis,
                                double pivot)
{
    s->n = s->at = 0;
    for (int k = 0; k < PART; k++) {
        s->by[s->n] = (unsigned char)k;
        s->n += !(p[-k].c[axis] > pivot);
    }
}

/*
 * Hoare's partition of many points, [*i, *j], part by part (Edelkamp and Weiss 2016): the same
 * pairs change places in the same order as if they were looked for one by one, as far as both parts
 * do not meet; *i and *j are where that would go on.
 */
static void partition_parts(struct kd_point *p, size_t *i, size_t *j, int axis, double pivot)
{
    struct strangers left = {.n = 0}, right = {.n = 0};
    size_t from = *i, to = *j; /* where the parts begin */

    while (to - from >= 2 * PART) {
        if (left.at == left.n)
            find_strangers(&left, &p[from], axis, pivot);
        if (right.at == right.n)
            find_strangers_down(&right, &p[to], axis, pivot);
        while (left.at < left.n && right.at < right.n)
            swap_points(&p[from + left.by[left.at++]], &p[to - right.by[right.at++]]);
        from += left.at == left.n ? PART : 0;
        to -= right.at == right.n ? PART : 0;
    }
    *i = left.at < left.n ? from + left.by[left.at] : from;
    *j = right.at < right.n ? to - right.by[right.at] : to;
}

/*
 * Brings the point that belongs at `middle` along the axis there, smaller ones before it (Hoare's
 * selection).  The median of three as the pivot takes the square of the points' number for some
 * orders, those of grids on slivers among them: who has looked at MUCH times the points takes
 * pivots by chance, whose mean is 3.4 times them for any order (Knuth, 5.2.2, exercise 32).
 */
static void select_middle(struct kd_point *p, size_t from, size_t to, size_t middle, int axis)
{
    enum { MUCH = 8 };
    size_t left = MUCH * (to - from);
    uint64_t chance = 1;

    while (to - from > 1) {
        size_t n = to - from, some = from + n / 2;
        double pivot = middle_of(p[from].c[axis], p[some].c[axis], p[to - 1].c[axis]);
        size_t i = from, j = to - 1;

        if (left < n) {
            chance = chance * 6364136223846793005u + 1442695040888963407u;
            pivot = p[from + (size_t)(chance >> 33) % n].c[axis];
        }
        left -= left < n ? 0 : n;
        if (n > 4 * PART)
            partition_parts(p, &i, &j, axis, pivot);
        for (;;) {
            while (p[i].c[axis] < pivot)
                i++;
            while (p[j].c[axis] > pivot)
                j--;
            if (i >= j)
                break;
            swap_points(&p[i++], &p[j--]);
        }
        if (middle < i) {
            to = i;
        } else if (i > j) {
            from = i;
        } else { /* both stopped at a point equal to the pivot: it is where it belongs */
            if (middle == i)
                return;
            from = i + 1;
        }
    }
}

/* Around every so manyth of the points. */
static struct kd_box box_around(const struct kd_point *p, size_t from, size_t to, size_t step)
{
    struct kd_box box;

    for (int d = 0; d < 3; d++)
        box.low[d] = box.high[d] = p[from].c[d];
    for (size_t i = from + step; i < to; i += step) {
        for (int d = 0; d < 3; d++) {
            box.low[d] = p[i].c[d] < box.low[d] ? p[i].c[d] : box.low[d];
            box.high[d] = p[i].c[d] > box.high[d] ? p[i].c[d] : box.high[d];
        }
    }
    return box;
}

static int widest_axis(const struct kd_box *box)
{
    int widest = 0;

    for (int d = 1; d < 3; d++) {
        if (box->high[d] - box->low[d] > box->high[widest] - box->low[widest])
            widest = d;
    }
    return widest;
}

/* A node and those under it, for a thread to build. */
struct branch {
    struct kdtree *tree;
    size_t from, to, number;
    int threads;
};

static void build_two(void *context, size_t from, size_t to);

/* Around two boxes and the point between their points. */
static struct kd_box box_of_halves(const struct kd_box half[2], const struct kd_point *between)
{
    struct kd_box box;

    for (int d = 0; d < 3; d++) {
        double low = half[0].low[d] < half[1].low[d] ? half[0].low[d] : half[1].low[d];
        double high = half[0].high[d] > half[1].high[d] ? half[0].high[d] : half[1].high[d];
        box.low[d] = between->c[d] < low ? between->c[d] : low;
        box.high[d] = between->c[d] > high ? between->c[d] : high;
    }
    return box;
}

/* Both halves of a node are as long as each other, or the first is by one point longer: so the
 * numbers of all boxes stay below twice those of the deepest row that this goes down to.  Which way
 * the points reach farthest some of them tell. */
static void build(struct branch b)
{
    struct kdtree *tree = b.tree;
    size_t n = b.to - b.from, middle = b.from + n / 2;

    if (n <= KD_LEAF) {
        if (n > 0)
            tree->box[b.number] = box_around(tree->point, b.from, b.to, 1);
        return;
    }
    struct kd_box some = box_around(tree->point, b.from, b.to, n / SOME + 1);
    int axis = widest_axis(&some);
    select_middle(tree->point, b.from, b.to, middle, axis);
    tree->axis[middle] = (unsigned char)axis;
    struct branch half[2] = {{tree, b.from, middle, 2 * b.number, b.threads},
                             {tree, middle + 1, b.to, 2 * b.number + 1, b.threads}};
    if (b.threads != 1 && b.number < TOP && n > WORTH)
        parallel_for(b.threads, 2, build_two, half);
    else
        build_two(half, 0, 2);
    tree->box[b.number] = box_of_halves(&tree->box[2 * b.number], &tree->point[middle]);
}

static void build_two(void *context, size_t from, size_t to)
{
    const struct branch *half = context;

    for (size_t i = from; i < to; i++)
        build(half[i]);
}

/* One more than the largest number of a box. */
static size_t boxes_for(size_t n)
{
    size_t boxes = 2;

    for (; n > KD_LEAF; n /= 2)
        boxes *= 2;
    return boxes;
}

/* What the threads share that copy points. */
struct copying {
    const struct vec3 *from;
    struct kd_point *to;
    size_t n;
};

enum { PIECE = 1 << 14 }; /* points that one thread copies */

static void copy_pieces(void *context, size_t from, size_t to)
{
    const struct copying *c = context;

    for (size_t i = from * PIECE; i < to * PIECE && i < c->n; i++)
        c->to[i] = (struct kd_point){{c->from[i].x, c->from[i].y, c->from[i].z}, i};
}

struct kdtree *kdtree_new_by(const struct vec3 *point, size_t n, int threads)
{
    struct kdtree *tree = mem_alloc(1, sizeof *tree);

    tree->n = n;
    tree->point = mem_alloc(n, sizeof *tree->point);
    tree->axis = mem_alloc(n, 1);
    tree->box = mem_alloc(boxes_for(n), sizeof *tree->box);
    struct copying copying = {point, tree->point, n};
    parallel_for(threads, (n + PIECE - 1) / PIECE, copy_pieces, &copying);
    build((struct branch){tree, 0, n, 1, threads});
    return tree;
}

struct kdtree *kdtree_new(const struct vec3 *point, size_t n)
{
    return kdtree_new_by(point, n, 1);
}

size_t kdtree_points(const struct kdtree *tree)
{
    return tree->n;
}

void kdtree_free(struct kdtree *tree)
{
    if (!tree)
        return;
    free(tree->point);
    free(tree->axis);
    free(tree->box);
    free(tree);
}

/* ---- nearest points and neighbourhoods
 *
 * By the planes between the nodes: the distance to a node's cell is carried down and changed in one
 * coordinate at a time (Arya and Mount 1993). */

enum { ON_STACK = 1024 };

/* So many points about equally far are not sorted by insertion. */
enum { CROWD = 32 };

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
static void sift_down(struct nearest *s, size_t at, size_t n, size_t index, double distance2)
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

static void offer_point(struct nearest *s, const struct kd_point *p)
{
    double d2 = kd_distance2(p->c, s->q);

    if (s->n < s->k) {
        s->index[s->n] = p->index;
        s->distance2[s->n++] = d2;
        for (size_t at = s->n == s->k ? s->k / 2 : 0; at-- > 0;)
            sift_down(s, at, s->k, s->index[at], s->distance2[at]);
        return;
    }
    if (d2 < s->distance2[0] || (d2 == s->distance2[0] && p->index < s->index[0]))
        sift_down(s, 0, s->n, p->index, d2);
}

/* `box2` is the squared distance from q to the box of [from, to). */
static void search_nearest(struct nearest *s, size_t from, size_t to, double box2)
{
    if (to - from <= KD_LEAF) {
        for (size_t i = from; i < to; i++)
            offer_point(s, &s->tree->point[i]);
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
    offer_point(s, &s->tree->point[middle]);
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
        sift_down(s, 0, last, index, distance2);
    }
}

/* The same by a histogram of the distances, which on a surface is even, and what it leaves by
 * insertion.  False: they are too many, or many are about equally far. */
static bool sort_evenly(struct nearest *s)
{
    size_t index[ON_STACK], n = s->n;
    uint32_t begin[ON_STACK + 1];
    double d2[ON_STACK], scale = (double)n / s->distance2[0];
    uint16_t part[ON_STACK];
    if (n > ON_STACK || !(s->distance2[0] > 0) || !isfinite(scale))
        return false;
    memset(begin, 0, (n + 1) * sizeof *begin);
    for (size_t i = 0; i < n; i++) {
        size_t at = (size_t)(s->distance2[i] * scale);
        part[i] = (uint16_t)(at < n ? at : n - 1);
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
