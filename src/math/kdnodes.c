/* kdnodes - see kdnodes.h. */
#include "kdnodes.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/parallel.h"

enum { SOME = 200 };

/* Nodes with lower numbers hand their halves to two threads, where that many points are worth it.
 */
enum { TOP = 8, WORTH = 50000 };

static void swap(struct kd_point *a, struct kd_point *b)
{
    struct kd_point t = *a;
    *a = *b;
    *b = t;
}

/* Brings the point that belongs at `middle` along the axis there, smaller ones before it. */
static void select_middle(struct kd_point *p, size_t from, size_t to, size_t middle, int axis)
{
    while (to - from > 1) {
        double a = p[from].c[axis], b = p[from + (to - from) / 2].c[axis], c = p[to - 1].c[axis];
        double pivot = a < b ? (b < c ? b : fmax(a, c)) : (a < c ? a : fmax(b, c));
        size_t i = from, j = to - 1;

        for (;;) {
            while (p[i].c[axis] < pivot)
                i++;
            while (p[j].c[axis] > pivot)
                j--;
            if (i >= j)
                break;
            swap(&p[i++], &p[j--]);
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

struct kdtree *kdnodes_build(const struct vec3 *point, size_t n, int threads)
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

void kdnodes_free(struct kdtree *tree)
{
    if (!tree)
        return;
    free(tree->point);
    free(tree->axis);
    free(tree->box);
    free(tree);
}
