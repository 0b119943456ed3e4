/* box_tree - see box_tree.h. */
#include "math/box_tree.h"

#include <stdint.h>
#include <stdlib.h>

#include "base/array.h"

enum { LEAF = 4, DEPTH = 64 };

/* Nodes [2 i + 1], [2 i + 2] are the halves of node i; a leaf has no more than LEAF items. */
struct box_tree {
    size_t n;
    size_t *item;    /* in the order of the leaves */
    struct box *box; /* of each node */
};

/* An item while the tree is made. */
struct entry {
    struct vec3 middle;
    size_t item;
};

/* Orders [from, to) so that entry k is where sorting would put it (Hoare's selection). */
static void select_entry(struct entry *e, size_t from, size_t to, size_t k, int axis)
{
    while (to - from > 1) {
        double pivot = vec_coordinate(e[from + (to - from) / 2].middle, axis);
        size_t i = from, j = to - 1;
        for (;;) {
            while (vec_coordinate(e[i].middle, axis) < pivot)
                i++;
            while (vec_coordinate(e[j].middle, axis) > pivot)
                j--;
            if (i >= j)
                break;
            struct entry swap = e[i];
            e[i++] = e[j];
            e[j--] = swap;
        }
        size_t cut = i > from ? i : from + 1; /* the pivot itself was the first */
        if (k < cut)
            to = cut;
        else
            from = cut;
    }
}

static void build(struct box_tree *tree, const struct box *box, struct entry *e, size_t node,
                  size_t from, size_t to)
{
    tree->box[node] = box_empty();
    if (to - from <= LEAF) {
        for (size_t i = from; i < to; i++) {
            tree->item[i] = e[i].item;
            box_join(&tree->box[node], &box[e[i].item]);
        }
        return;
    }
    struct box middles = box_empty();
    for (size_t i = from; i < to; i++)
        box_add(&middles, e[i].middle);
    struct vec3 size = vec_sub(middles.high, middles.low);
    int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    size_t half = from + (to - from) / 2;
    select_entry(e, from, to, half, axis);
    build(tree, box, e, 2 * node + 1, from, half);
    build(tree, box, e, 2 * node + 2, half, to);
    box_join(&tree->box[node], &tree->box[2 * node + 1]);
    box_join(&tree->box[node], &tree->box[2 * node + 2]);
}

struct box_tree *box_tree_new(const struct box *box, size_t n)
{
    struct box_tree *tree = mem_alloc(1, sizeof *tree);
    struct entry *entry = mem_alloc(n, sizeof *entry);
    size_t nodes = 1;
    for (size_t most = n; most > LEAF; most -= most / 2)
        nodes = 2 * nodes + 1;
    tree->n = n;
    tree->item = mem_alloc(n, sizeof *tree->item);
    tree->box = mem_alloc(nodes, sizeof *tree->box);
    for (size_t i = 0; i < n; i++)
        entry[i] = (struct entry){vec_mix(box[i].low, box[i].high, 0.5), i};
    build(tree, box, entry, 0, 0, n);
    free(entry);
    return tree;
}

void box_tree_free(struct box_tree *tree)
{
    if (!tree)
        return;
    free(tree->item);
    free(tree->box);
    free(tree);
}

/* Items [from, to) of a node, and how far its box is from the point, squared. */
struct span {
    size_t node, from, to;
    double d2;
};

static struct span half_of(const struct box_tree *tree, struct span s, bool second, struct vec3 p)
{
    size_t half = s.from + (s.to - s.from) / 2, node = 2 * s.node + (second ? 2 : 1);
    double d2 = box_distance2(&tree->box[node], p);
    return second ? (struct span){node, half, s.to, d2} : (struct span){node, s.from, half, d2};
}

double box_tree_nearest(const struct box_tree *tree, const void *items,
                        box_tree_distance2 *distance2, struct vec3 p, double within,
                        size_t *nearest)
{
    struct span stack[DEPTH] = {{0, 0, tree->n, 0}};
    double best = within * within;
    size_t found = tree->n;
    if (*nearest < tree->n) {
        double d2 = distance2(items, *nearest, p);
        found = d2 < best ? *nearest : found;
        best = d2 < best ? d2 : best;
    }
    for (size_t n = 1; n > 0;) {
        struct span s = stack[--n];
        if (s.d2 > best)
            continue;
        if (s.to - s.from > LEAF) {
            struct span first = half_of(tree, s, false, p), second = half_of(tree, s, true, p);
            bool swap = first.d2 < second.d2;
            stack[n++] = swap ? second : first; /* the nearer one is searched first */
            stack[n++] = swap ? first : second;
            continue;
        }
        for (size_t i = s.from; i < s.to; i++) {
            size_t item = tree->item[i];
            double d2 = distance2(items, item, p);
            /* of two as near the first, whatever the order in which they are found */
            if (d2 < best || (d2 == best && item < found && found < tree->n)) {
                best = d2;
                found = item;
            }
        }
    }
    if (found < tree->n)
        *nearest = found;
    return found < tree->n ? sqrt(best) : within;
}

bool box_tree_each(const struct box_tree *tree, struct vec3 p, double reach, box_tree_visit *visit,
                   void *context)
{
    struct span stack[DEPTH] = {{0, 0, tree->n, 0}};
    for (size_t n = 1; n > 0;) {
        struct span s = stack[--n];
        if (s.d2 > reach * reach)
            continue;
        if (s.to - s.from > LEAF) {
            stack[n++] = half_of(tree, s, false, p);
            stack[n++] = half_of(tree, s, true, p);
            continue;
        }
        for (size_t i = s.from; i < s.to; i++)
            if (visit(context, tree->item[i]))
                return true;
    }
    return false;
}

static double distance2_of(struct vec3 a, struct vec3 b)
{
    struct vec3 d = vec_sub(a, b);

    return vec_dot(d, d);
}

struct vec3 facet_nearest(const struct facet *facet, struct vec3 p)
{
    const struct vec3 *c = facet->corner;
    struct vec3 u = vec_sub(c[1], c[0]), v = vec_sub(c[2], c[0]), w = vec_sub(p, c[0]);
    double uu = vec_dot(u, u), uv = vec_dot(u, v), vv = vec_dot(v, v);
    double det = uu * vv - uv * uv;
    if (det > 1e-14 * uu * vv) { /* else it is a straight piece or a point */
        double a = vv * vec_dot(u, w) - uv * vec_dot(v, w);
        double b = uu * vec_dot(v, w) - uv * vec_dot(u, w);
        if (a >= 0 && b >= 0) {
            a /= det;
            b /= det;
            if (a + b <= 1)
                return vec_along(vec_along(c[0], a, u), b, v);
        }
    }
    struct vec3 best = vec_segment_nearest(c[0], c[1], p);
    double best2 = distance2_of(best, p);
    for (int k = 1; k < 3; k++) {
        struct vec3 q = vec_segment_nearest(c[k], c[(k + 1) % 3], p);
        double d2 = distance2_of(q, p);
        if (d2 < best2 && sqrt(d2) < sqrt(best2)) { /* at the same distance the first one stays */
            best = q;
            best2 = d2;
        }
    }
    return best;
}

struct box_tree *facets_tree(const struct facets *facets)
{
    struct box *box = mem_alloc(facets->n, sizeof *box);
    for (size_t i = 0; i < facets->n; i++) {
        box[i] = box_empty();
        for (int k = 0; k < 3; k++)
            box_add(&box[i], facets->item[i].corner[k]);
    }
    struct box_tree *tree = box_tree_new(box, facets->n);
    free(box);
    return tree;
}

static double facet_distance2(const void *items, size_t item, struct vec3 p)
{
    const struct facets *facets = items;
    return distance2_of(facet_nearest(&facets->item[item], p), p);
}

double facets_distance(const struct box_tree *tree, const struct facets *facets, struct vec3 p)
{
    size_t nearest = SIZE_MAX;
    return box_tree_nearest(tree, facets, facet_distance2, p, HUGE_VAL, &nearest);
}
