/*
 * kdtree - see kdtree.h.
 *
 * The tree is balanced and lies in the order of its points: the node of the range [from, to) is the
 * point in its middle; what stands before it is not above it along the node's axis, what stands
 * after it is not below.  So the tree needs no pointers: only the points in that order, where each
 * came from, the axis of each node, and the box around each node's points.  Ranges of up to KD_LEAF
 * points have no nodes under them.
 *
 * In this file, in this order: the tree is built; nearest points and neighbourhoods; the point
 * nearest to a segment, or lowest; a visit; a ball that leaves the points.
 */
#include "math/kdtree.h"

#include <stdint.h>
#include <stdlib.h>

#include "math/elementary.h"
#include "base/parallel.h"

enum { KD_LEAF = 12 };

struct kd_point {
    double c[3];
    size_t index; /* in the array that the tree was made from */
};

/* Around the points of a node. */
struct kd_box {
    double low[3], high[3];
};

struct kdtree {
    size_t n;
    struct kd_point *point;
    unsigned char *axis; /* of the node whose point stands here */
    struct kd_box *box;  /* the root's is number 1, those under number i are 2 i and 2 i + 1 */
};

/* How far the range from `first` to `last` is from a box along one axis, mm; 0 where they meet. */
static inline double kd_gap(const struct kd_box *box, int axis, double first, double last)
{
    double under = box->low[axis] - last, over = first - box->high[axis];
    double gap = under > over ? under : over;

    return 0.5 * (gap + fabs(gap)); /* without a jump that no one foretells */
}

/* How far a place is from a box, squared, mm^2; 0 inside. */
static inline double kd_gap2(const struct kd_box *box, const double at[3])
{
    double x = kd_gap(box, 0, at[0], at[0]), y = kd_gap(box, 1, at[1], at[1]);
    double z = kd_gap(box, 2, at[2], at[2]);

    return x * x + y * y + z * z;
}

static inline double kd_distance2(const double a[3], const double b[3])
{
    double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];

    return x * x + y * y + z * z;
}

static double square(double x)
{
    return x * x;
}

/* ---- the tree is built */

enum { SOME = 200 };

/* Nodes with lower numbers hand their halves to two threads, where that many points are worth it.
 */
enum { TOP = 8, WORTH = 50000 };

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

struct kdtree *kdtree_new_by(const struct vec3 *point, size_t n, int threads)
{
    struct kdtree *tree = mem_alloc(1, sizeof *tree);

    tree->n = n;
    tree->point = mem_alloc(n, sizeof *tree->point);
    tree->axis = mem_alloc(n, 1);
    tree->box = mem_alloc(boxes_for(n), sizeof *tree->box);
    for (size_t i = 0; i < n; i++)
        tree->point[i] = (struct kd_point){{point[i].x, point[i].y, point[i].z}, i};
    build((struct branch){tree, 0, n, 1, threads});
    return tree;
}

struct kdtree *kdtree_new(const struct vec3 *point, size_t n)
{
    return kdtree_new_by(point, n, 1);
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

enum { ON_STACK = 256 };

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

/* ---- the point nearest to a segment, or lowest
 *
 * Points of a surface lie thin in the cells of the planes between the nodes, and a ball that
 * touches it reaches into all cells under it: these searches go by the boxes around the points
 * instead. */

/* The nearest point to a segment so far. */
struct beside {
    const struct kdtree *tree;
    struct vec3 a, along; /* from one end to the other */
    double length2;
    double low[3], high[3]; /* the segment's box */
    double best, best2;
    size_t index;      /* as in the caller's array */
    struct vec3 place; /* of that point */
};

static double distance2_beside(const struct beside *s, struct vec3 p)
{
    struct vec3 d = vec_sub(p, s->a);
    double at = s->length2 > 0 ? vec_dot(d, s->along) / s->length2 : 0;
    struct vec3 off = vec_along(d, -(at < 0 ? 0 : at > 1 ? 1 : at), s->along);

    return vec_dot(off, off);
}

static void offer_beside(struct beside *s, const struct kd_point *p)
{
    double d2 = distance2_beside(s, vec(p->c[0], p->c[1], p->c[2]));

    if (d2 < s->best2 || (d2 == s->best2 && p->index < s->index)) {
        s->best2 = d2;
        s->best = sqrt(d2);
        s->index = p->index;
        s->place = vec(p->c[0], p->c[1], p->c[2]);
    }
}

/* No point in the box is nearer than this: the gap to the segment's own box, or to the ball around
 * the box. */
static double bound2(const struct beside *s, const struct kd_box *box)
{
    double x = kd_gap(box, 0, s->low[0], s->high[0]), y = kd_gap(box, 1, s->low[1], s->high[1]);
    double z = kd_gap(box, 2, s->low[2], s->high[2]), gap2 = x * x + y * y + z * z;

    if (s->length2 == 0 || gap2 > s->best2)
        return gap2;
    struct vec3 low = vec(box->low[0], box->low[1], box->low[2]);
    struct vec3 half = vec_scale(0.5, vec_sub(vec(box->high[0], box->high[1], box->high[2]), low));
    double beyond = sqrt(distance2_beside(s, vec_add(low, half))) - sqrt(vec_dot(half, half));
    return beyond > 0 && beyond * beyond > gap2 ? beyond * beyond : gap2;
}

static void search_beside(struct beside *s, size_t from, size_t to, size_t number)
{
    if (to - from <= KD_LEAF) {
        for (size_t i = from; i < to; i++)
            offer_beside(s, &s->tree->point[i]);
        return;
    }
    size_t middle = from + (to - from) / 2;
    double first = bound2(s, &s->tree->box[2 * number]);
    double second = bound2(s, &s->tree->box[2 * number + 1]);
    bool left = first <= second;

    offer_beside(s, &s->tree->point[middle]);
    for (int turn = 0; turn < 2; turn++, left = !left) {
        if ((left ? first : second) * (1 - 1e-12) > s->best2)
            continue;
        if (left)
            search_beside(s, from, middle, 2 * number);
        else
            search_beside(s, middle + 1, to, 2 * number + 1);
    }
}

static struct beside beside_of(const struct kdtree *tree, struct vec3 a, struct vec3 b,
                               double within)
{
    struct beside s = {.tree = tree,
                       .a = a,
                       .along = vec_sub(b, a),
                       .low = {fmin(a.x, b.x), fmin(a.y, b.y), fmin(a.z, b.z)},
                       .high = {fmax(a.x, b.x), fmax(a.y, b.y), fmax(a.z, b.z)},
                       .best = within,
                       .best2 = square(within),
                       .index = SIZE_MAX};

    s.length2 = vec_dot(s.along, s.along);
    return s;
}

double kdtree_nearest_segment(const struct kdtree *tree, struct vec3 a, struct vec3 b,
                              double within, size_t *index)
{
    struct beside s = beside_of(tree, a, b, within);

    if (tree->n > 0)
        search_beside(&s, 0, tree->n, 1);
    if (s.index == SIZE_MAX)
        return within;
    *index = s.index;
    return s.best;
}

double kdtree_nearest_place(const struct kdtree *tree, struct vec3 p, double within,
                            struct vec3 *place)
{
    struct beside s = beside_of(tree, p, p, within);

    if (tree->n > 0)
        search_beside(&s, 0, tree->n, 1);
    if (s.index == SIZE_MAX)
        return within;
    *place = s.place;
    return s.best;
}

double kdtree_nearest_among(const struct vec3 *point, size_t n, struct vec3 a, struct vec3 b,
                            double within)
{
    struct beside s = beside_of(NULL, a, b, within);

    for (size_t i = 0; i < n; i++) {
        double d2 = distance2_beside(&s, point[i]);
        s.best2 = d2 < s.best2 ? d2 : s.best2;
    }
    return s.best2 < square(within) ? sqrt(s.best2) : within;
}

static void collect_beside(const struct beside *s, size_t from, size_t to, size_t number,
                           struct vec3s *found)
{
    if (bound2(s, &s->tree->box[number]) * (1 - 1e-12) > s->best2)
        return;
    size_t middle = from + (to - from) / 2;
    bool leaf = to - from <= KD_LEAF;

    if (!leaf)
        collect_beside(s, from, middle, 2 * number, found);
    for (size_t i = leaf ? from : middle; i < (leaf ? to : middle + 1); i++) {
        struct vec3 p = vec(s->tree->point[i].c[0], s->tree->point[i].c[1], s->tree->point[i].c[2]);
        if (distance2_beside(s, p) <= s->best2)
            *array_push(found) = p;
    }
    if (!leaf)
        collect_beside(s, middle + 1, to, 2 * number + 1, found);
}

void kdtree_beside(const struct kdtree *tree, struct vec3 a, struct vec3 b, double within,
                   struct vec3s *found)
{
    struct beside s = beside_of(tree, a, b, within);

    if (tree->n > 0)
        collect_beside(&s, 0, tree->n, 1, found);
}

/* Is a point nearer than s->best? */
static bool any_beside(const struct beside *s, size_t from, size_t to, size_t number)
{
    if (to - from <= KD_LEAF) {
        for (size_t i = from; i < to; i++) {
            const double *c = s->tree->point[i].c;
            if (distance2_beside(s, vec(c[0], c[1], c[2])) < s->best2)
                return true;
        }
        return false;
    }
    size_t middle = from + (to - from) / 2;
    const double *c = s->tree->point[middle].c;
    double first = bound2(s, &s->tree->box[2 * number]) * (1 - 1e-12);
    double second = bound2(s, &s->tree->box[2 * number + 1]) * (1 - 1e-12);
    bool left = first <= second;

    if (distance2_beside(s, vec(c[0], c[1], c[2])) < s->best2)
        return true;
    for (int turn = 0; turn < 2; turn++, left = !left) {
        if ((left ? first : second) >= s->best2)
            continue;
        if (left ? any_beside(s, from, middle, 2 * number)
                 : any_beside(s, middle + 1, to, 2 * number + 1))
            return true;
    }
    return false;
}

bool kdtree_any_beside(const struct kdtree *tree, struct vec3 a, struct vec3 b, double within)
{
    struct beside s = beside_of(tree, a, b, within);

    return within > 0 && tree->n > 0 && any_beside(&s, 0, tree->n, 1);
}

/* The lowest value so far. */
struct lowest {
    const struct kdtree *tree;
    double (*value)(const void *context, struct vec3 p);
    const void *context;
    double best;
    size_t index; /* as in the caller's array */
};

static void offer_lowest(struct lowest *s, const struct kd_point *p)
{
    double value = s->value(s->context, vec(p->c[0], p->c[1], p->c[2]));

    if (value < s->best || (value == s->best && p->index < s->index)) {
        s->best = value;
        s->index = p->index;
    }
}

/* No point in the box has a lower value. */
static double lower_bound(const struct lowest *s, const struct kd_box *box)
{
    double half2 = 0, middle[3];

    for (int d = 0; d < 3; d++) {
        middle[d] = (box->low[d] + box->high[d]) / 2;
        half2 += square(box->high[d] - box->low[d]) / 4;
    }
    return s->value(s->context, vec(middle[0], middle[1], middle[2])) - sqrt(half2) * (1 + 1e-12);
}

static void search_lowest(struct lowest *s, size_t from, size_t to, size_t number)
{
    if (to - from <= KD_LEAF) {
        for (size_t i = from; i < to; i++)
            offer_lowest(s, &s->tree->point[i]);
        return;
    }
    size_t middle = from + (to - from) / 2;
    double first = lower_bound(s, &s->tree->box[2 * number]);
    double second = lower_bound(s, &s->tree->box[2 * number + 1]);
    bool left = first <= second;

    offer_lowest(s, &s->tree->point[middle]);
    for (int turn = 0; turn < 2; turn++, left = !left) {
        if ((left ? first : second) > s->best)
            continue;
        if (left)
            search_lowest(s, from, middle, 2 * number);
        else
            search_lowest(s, middle + 1, to, 2 * number + 1);
    }
}

double kdtree_lowest(const struct kdtree *tree, double (*value)(const void *context, struct vec3 p),
                     const void *context, double below, size_t *index)
{
    struct lowest s = {tree, value, context, below, SIZE_MAX};

    if (tree->n > 0)
        search_lowest(&s, 0, tree->n, 1);
    if (s.index != SIZE_MAX)
        *index = s.index;
    return s.best;
}

static bool any_lower(const struct lowest *s, size_t from, size_t to, size_t number)
{
    if (to - from <= KD_LEAF) {
        for (size_t i = from; i < to; i++) {
            const double *c = s->tree->point[i].c;
            if (s->value(s->context, vec(c[0], c[1], c[2])) < s->best)
                return true;
        }
        return false;
    }
    size_t middle = from + (to - from) / 2;
    const double *c = s->tree->point[middle].c;
    double first = lower_bound(s, &s->tree->box[2 * number]);
    double second = lower_bound(s, &s->tree->box[2 * number + 1]);
    bool left = first <= second;

    if (s->value(s->context, vec(c[0], c[1], c[2])) < s->best)
        return true;
    for (int turn = 0; turn < 2; turn++, left = !left) {
        if ((left ? first : second) >= s->best)
            continue;
        if (left ? any_lower(s, from, middle, 2 * number)
                 : any_lower(s, middle + 1, to, 2 * number + 1))
            return true;
    }
    return false;
}

bool kdtree_any_lower(const struct kdtree *tree,
                      double (*value)(const void *context, struct vec3 p), const void *context,
                      double below)
{
    struct lowest s = {tree, value, context, below, SIZE_MAX};

    return tree->n > 0 && any_lower(&s, 0, tree->n, 1);
}

/* ---- a visit */

static void visit_node(const struct kdtree *tree, const double from[3],
                       const struct kdtree_visitor *v, size_t first, size_t last, size_t number,
                       int depth)
{
    const struct kd_box *box = &tree->box[number];
    struct vec3 low = vec(box->low[0], box->low[1], box->low[2]);
    struct vec3 half = vec_scale(0.5, vec_sub(vec(box->high[0], box->high[1], box->high[2]), low));
    size_t middle = first + (last - first) / 2;

    if (!v->box(v->context, depth, vec_add(low, half), half))
        return;
    if (last - first <= KD_LEAF) {
        for (size_t i = first; i < last; i++) {
            const double *c = tree->point[i].c;
            v->point(v->context, depth, vec(c[0], c[1], c[2]));
        }
        return;
    }
    const double *c = tree->point[middle].c;
    v->point(v->context, depth, vec(c[0], c[1], c[2]));
    bool left = kd_gap2(&tree->box[2 * number], from) <= kd_gap2(&tree->box[2 * number + 1], from);
    for (int turn = 0; turn < 2; turn++, left = !left) {
        if (left)
            visit_node(tree, from, v, first, middle, 2 * number, depth + 1);
        else
            visit_node(tree, from, v, middle + 1, last, 2 * number + 1, depth + 1);
    }
}

void kdtree_visit(const struct kdtree *tree, struct vec3 from, const struct kdtree_visitor *visitor)
{
    const double c[3] = {from.x, from.y, from.z};

    if (tree->n > 0)
        visit_node(tree, c, visitor, 0, tree->n, 1, 0);
}

/* ---- a ball that leaves the points */

/* What may be left of a gouge: far below any tolerance, far above rounding. */
static const double SLACK = 1e-6;

/* A ball on its way up from c, `h` so far. */
struct leaving {
    const struct kdtree *tree;
    struct vec3 c, up;
    double radius, inside2; /* of its centre: what is nearer has to be left */
    double h, limit;
    double at[3];             /* its centre */
    struct kdtree_touch last; /* the point left last */
};

/*
 * A point p keeps the centre c + h * up out of an interval of h: those with |c + h up - p| < R. Its
 * upper end, a root of a quadratic.
 */
static double height_of_leaving(const double p[3], struct vec3 c, struct vec3 up, double radius)
{
    struct vec3 d = vec_sub(vec(p[0], p[1], p[2]), c);
    double along = vec_dot(d, up);
    double across2 = vec_dot(d, d) - along * along, under2 = radius * radius - across2;

    return along + sqrt(under2 > 0 ? under2 : 0);
}

static void rise_to(struct leaving *l, double h)
{
    struct vec3 at = vec_along(l->c, h, l->up);

    l->h = h;
    l->at[0] = at.x;
    l->at[1] = at.y;
    l->at[2] = at.z;
}

static void meet_point(struct leaving *l, const struct kd_point *p)
{
    if (kd_distance2(p->c, l->at) < l->inside2) {
        rise_to(l, fmax(l->h, height_of_leaving(p->c, l->c, l->up, l->radius)));
        l->last = (struct kdtree_touch){1, {{p->c[0], p->c[1], p->c[2]}}};
    }
}

static void leave(struct leaving *l, size_t from, size_t to, size_t number)
{
    if (to - from <= KD_LEAF) {
        for (size_t i = from; i < to; i++)
            if (kd_distance2(l->tree->point[i].c, l->at) < l->inside2)
                meet_point(l, &l->tree->point[i]);
        return;
    }
    size_t middle = from + (to - from) / 2;
    const struct kd_box *half = &l->tree->box[2 * number];
    double first = kd_gap2(&half[0], l->at), second = kd_gap2(&half[1], l->at);
    bool left = first <= second;

    if ((left ? first : second) < l->inside2) {
        if (left)
            leave(l, from, middle, 2 * number);
        else
            leave(l, middle + 1, to, 2 * number + 1);
    }
    meet_point(l, &l->tree->point[middle]);
    /* It may have risen since. */
    if (l->h > l->limit || kd_gap2(&half[left], l->at) >= l->inside2)
        return;
    if (left)
        leave(l, middle + 1, to, 2 * number + 1);
    else
        leave(l, from, middle, 2 * number);
}

static struct leaving leaving_from(const struct kdtree *tree, struct vec3 c, struct vec3 up,
                                   double radius, double limit)
{
    double inside = radius - SLACK;

    return (struct leaving){
        tree, c, up, radius, inside > 0 ? inside * inside : 0, 0, limit, {c.x, c.y, c.z}, {.n = 0}};
}

/* One after the other, and the first again: it may be in the way once more. */
static void leave_these(struct leaving *l, const struct kdtree_touch *these)
{
    for (size_t i = 0; these->n > 0 && i <= these->n; i++) {
        struct vec3 p = these->p[i < these->n ? i : 0];
        meet_point(l, &(struct kd_point){{p.x, p.y, p.z}, 0});
    }
}

double kdtree_leave_these(const struct kdtree_touch *these, struct vec3 c, struct vec3 up,
                          double radius)
{
    struct leaving l = leaving_from(NULL, c, up, radius, HUGE_VAL);

    leave_these(&l, these);
    return l.h;
}

double kdtree_leave(const struct kdtree *tree, struct vec3 c, struct vec3 up, double radius,
                    double limit, struct kdtree_touch *touch)
{
    struct leaving l = leaving_from(tree, c, up, radius, limit);
    double before;

    if (tree->n == 0)
        return 0;
    if (touch)
        leave_these(&l, touch);
    /* What is left by one point may lie in another's interval again. */
    do {
        before = l.h;
        leave(&l, 0, tree->n, 1);
    } while (l.h > before && l.h <= limit);
    if (touch)
        *touch = l.last;
    return l.h;
}

/* How far an upright line through c passes by a box, squared. */
static double beside2(const struct kd_box *box, struct vec3 c)
{
    double left = box->low[0] - c.x, right = c.x - box->high[0];
    double front = box->low[1] - c.y, back = c.y - box->high[1];
    double x = left > right ? left : right, y = front > back ? front : back;

    return (x > 0 ? x * x : 0) + (y > 0 ? y * y : 0);
}

/* The last point that a ball leaves on its way up from c. */
struct last {
    const struct kdtree *tree;
    struct vec3 c, up;
    double radius, inside;
    bool upright;
    double h;
};

/* How far the line up through c passes by a box, at least. */
static double line_distance(const struct last *l, const struct kd_box *box)
{
    struct vec3 half =
        vec(box->high[0] - box->low[0], box->high[1] - box->low[1], box->high[2] - box->low[2]);
    struct vec3 middle = vec_along(vec(box->low[0], box->low[1], box->low[2]), 0.5, half);

    if (l->upright)
        return sqrt(beside2(box, l->c));
    return vec_length(vec_reject(vec_sub(middle, l->c), l->up)) - vec_length(half) / 2;
}

/* No point in the box is left later than this. */
static double latest_leaving(const struct last *l, const struct kd_box *box)
{
    struct vec3 far =
        vec(l->up.x > 0 ? box->high[0] : box->low[0], l->up.y > 0 ? box->high[1] : box->low[1],
            l->up.z > 0 ? box->high[2] : box->low[2]);
    double across = fmax(0, line_distance(l, box));

    if (across * (1 - 1e-12) >= l->inside)
        return -INFINITY;
    return vec_dot(vec_sub(far, l->c), l->up) + sqrt(l->radius * l->radius - across * across) +
           1e-12 * l->radius;
}

static void meet_last(struct last *l, const struct kd_point *p)
{
    struct vec3 d = vec_sub(vec(p->c[0], p->c[1], p->c[2]), l->c);

    if (vec_length(vec_reject(d, l->up)) < l->inside)
        l->h = fmax(l->h, height_of_leaving(p->c, l->c, l->up, l->radius));
}

static void find_last(struct last *l, size_t from, size_t to, size_t number)
{
    if (to - from <= KD_LEAF) {
        for (size_t i = from; i < to; i++)
            meet_last(l, &l->tree->point[i]);
        return;
    }
    size_t middle = from + (to - from) / 2;
    const struct kd_box *half = &l->tree->box[2 * number];
    double first = latest_leaving(l, &half[0]), second = latest_leaving(l, &half[1]);
    bool left = first >= second;

    meet_last(l, &l->tree->point[middle]);
    for (int turn = 0; turn < 2; turn++, left = !left) {
        if ((left ? first : second) <= l->h)
            continue;
        if (left)
            find_last(l, from, middle, 2 * number);
        else
            find_last(l, middle + 1, to, 2 * number + 1);
    }
}

double kdtree_rise(const struct kdtree *tree, struct vec3 c, struct vec3 up, double radius)
{
    struct last l = {tree, c, up, radius, radius - SLACK, up.x == 0 && up.y == 0, 0};

    if (tree->n > 0 && l.inside > 0)
        find_last(&l, 0, tree->n, 1);
    return l.h;
}

/* A column with its foot at c, upright. */
struct column {
    const struct kdtree *tree;
    struct vec3 c;
    double radius2;
};

static bool stands_in(const struct column *l, const struct kd_box *box)
{
    return box->high[2] > l->c.z && beside2(box, l->c) < l->radius2;
}

static bool is_above(const struct column *l, const struct kd_point *p)
{
    double x = p->c[0] - l->c.x, y = p->c[1] - l->c.y;

    return p->c[2] > l->c.z && x * x + y * y < l->radius2;
}

static bool any_above(const struct column *l, size_t from, size_t to, size_t number)
{
    if (to - from <= KD_LEAF) {
        for (size_t i = from; i < to; i++)
            if (is_above(l, &l->tree->point[i]))
                return true;
        return false;
    }
    size_t middle = from + (to - from) / 2;
    const struct kd_box *half = &l->tree->box[2 * number];

    return is_above(l, &l->tree->point[middle]) ||
           (stands_in(l, &half[0]) && any_above(l, from, middle, 2 * number)) ||
           (stands_in(l, &half[1]) && any_above(l, middle + 1, to, 2 * number + 1));
}

bool kdtree_any_above(const struct kdtree *tree, struct vec3 c, double radius)
{
    struct column column = {tree, c, radius * radius};

    return radius > 0 && tree->n > 0 && any_above(&column, 0, tree->n, 1);
}
