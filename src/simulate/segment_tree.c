/* segment_tree - see segment_tree.h. */
#include "segment_tree.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/box.h"

enum { LEAF = 8, DEPTH = 64, SECTORS = 16, GAP = 6 };

struct segment_tree {
    const struct centre_path *path;
    size_t leaves; /* a power of two; the boxes of the leaves stand behind those above them */
    struct box *box;
};

struct segment_tree *segment_tree_new(const struct centre_path *path)
{
    struct segment_tree *tree = mem_alloc(1, sizeof *tree);
    tree->path = path;
    tree->leaves = 1;
    while (tree->leaves * LEAF < path->n)
        tree->leaves *= 2;
    tree->box = mem_alloc(2 * tree->leaves, sizeof *tree->box);
    for (size_t i = 0; i < 2 * tree->leaves; i++)
        tree->box[i] = box_empty();
    for (size_t i = 0; i < path->n; i++) {
        struct box *box = &tree->box[tree->leaves + i / LEAF];
        box_add(box, path->item[i].a);
        box_add(box, path->item[i].b);
    }
    for (size_t i = tree->leaves - 1; i > 0; i--) {
        box_join(&tree->box[i], &tree->box[2 * i]);
        box_join(&tree->box[i], &tree->box[2 * i + 1]);
    }
    return tree;
}

void segment_tree_free(struct segment_tree *tree)
{
    if (!tree)
        return;
    free(tree->box);
    free(tree);
}

struct vec3 centre_segment_nearest(const struct centre_segment *segment, struct vec3 p)
{
    return vec_nearest(segment->a, segment->b, p);
}

static double distance2(const struct centre_segment *segment, struct vec3 p)
{
    struct vec3 d = vec_sub(p, centre_segment_nearest(segment, p));
    return vec_dot(d, d);
}

/* The segments of a leaf. */
static void look(const struct segment_tree *tree, size_t node, struct vec3 p, double *best,
                 size_t *nearest)
{
    size_t from = (node - tree->leaves) * LEAF;
    size_t to = from + LEAF < tree->path->n ? from + LEAF : tree->path->n;
    for (size_t i = from; i < to; i++) {
        double d2 = distance2(&tree->path->item[i], p);
        /* of two as near the first, whatever the way they were found */
        if (d2 < *best || (d2 == *best && i < *nearest)) {
            *best = d2;
            *nearest = i;
        }
    }
}

double segment_tree_nearest(const struct segment_tree *tree, struct vec3 p, double within,
                            size_t *nearest)
{
    struct waiting {
        size_t node;
        double d2;
    } stack[DEPTH] = {{1, 0}};
    double best = within * within;
    size_t n = 1, found = tree->path->n;
    if (*nearest < tree->path->n) {
        double d2 = distance2(&tree->path->item[*nearest], p);
        if (d2 < best) {
            best = d2;
            found = *nearest;
        }
    }
    while (n > 0) {
        struct waiting top = stack[--n];
        if (top.d2 > best)
            continue;
        if (top.node >= tree->leaves) {
            look(tree, top.node, p, &best, &found);
            continue;
        }
        struct waiting one = {2 * top.node, box_distance2(&tree->box[2 * top.node], p)};
        struct waiting two = {one.node + 1, box_distance2(&tree->box[one.node + 1], p)};
        bool swap = one.d2 < two.d2;
        stack[n++] = swap ? two : one;
        stack[n++] = swap ? one : two;
    }
    if (found < tree->path->n)
        *nearest = found;
    return found < tree->path->n ? sqrt(best) : within;
}

/* Which sixteenth of a turn, from 0, the direction (x, y) lies in. */
static int sector(double x, double y)
{
    const double eighth = 0.41421356237309503; /* tangent of 22.5 degrees */
    double across = fabs(x), up = fabs(y);
    int k = (up >= eighth * across) + (up >= across) + (eighth * up >= across);
    if (x < 0)
        k = SECTORS / 2 - 1 - k;
    return y < 0 ? SECTORS - 1 - k : k;
}

/* Marks the sectors around p that a segment passes through within reach. */
static unsigned sectors(const struct centre_segment *segment, struct vec3 p, struct vec3 n,
                        struct vec3 u, double reach)
{
    struct vec3 near = centre_segment_nearest(segment, p), v = vec_cross(n, u);
    double far2 = reach * reach - vec_dot(vec_sub(near, p), vec_sub(near, p));
    if (far2 < 0)
        return 0;
    double length = vec_distance(segment->a, segment->b), far = sqrt(far2);
    struct vec3 along = vec_unit(vec_sub(segment->b, segment->a));
    double at = vec_dot(vec_sub(near, segment->a), along);
    const struct vec3 place[3] = {vec_along(near, -fmin(far, at), along), near,
                                  vec_along(near, fmin(far, length - at), along)};
    unsigned marks = 0;
    for (int i = 0; i < 3; i++) {
        struct vec3 d = vec_sub(place[i], p);
        double x = vec_dot(d, u), y = vec_dot(d, v);
        if (x * x + y * y >= 1e-12)
            marks |= 1u << sector(x, y);
    }
    return marks;
}

/* No gap of sectors in a row; beside a straight border it would be a half turn. */
static bool around(unsigned marks)
{
    unsigned twice = marks | marks << SECTORS;
    const unsigned gap = (1u << GAP) - 1;
    for (int i = 0; i < SECTORS; i++)
        if (!(twice >> i & gap))
            return false;
    return true;
}

bool segment_tree_surrounds(const struct segment_tree *tree, struct vec3 p, struct vec3 n,
                            double reach)
{
    struct vec3 u = vec_unit(vec_reject(fabs(n.x) < 0.6 ? vec(1, 0, 0) : vec(0, 1, 0), n));
    size_t stack[DEPTH] = {1}, waiting = 1;
    unsigned marks = 0;
    while (waiting > 0 && !around(marks)) {
        size_t node = stack[--waiting];
        if (box_distance2(&tree->box[node], p) > reach * reach)
            continue;
        if (node < tree->leaves) {
            stack[waiting++] = 2 * node;
            stack[waiting++] = 2 * node + 1;
            continue;
        }
        size_t from = (node - tree->leaves) * LEAF;
        for (size_t i = from; i < from + LEAF && i < tree->path->n; i++)
            if (tree->path->item[i].on)
                marks |= sectors(&tree->path->item[i], p, n, u, reach);
    }
    return around(marks);
}
