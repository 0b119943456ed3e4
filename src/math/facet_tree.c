/* facet_tree - see facet_tree.h. */
#include "math/facet_tree.h"

#include <stdbool.h>
#include <stdlib.h>

#include "base/array.h"
#include "math/box.h"

enum { LEAF = 6, DEPTH = 64 };

/* Nodes [2 i + 1], [2 i + 2] are the halves of node i; a leaf has no more than LEAF facets. */
struct facet_tree {
    const struct facets *facets;
    struct box *box;
    size_t nodes;
};

static struct vec3 middle(const struct facet *f)
{
    return vec_scale(1.0 / 3, vec_add(f->corner[0], vec_add(f->corner[1], f->corner[2])));
}

static double along(struct vec3 p, int axis)
{
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/* Orders [from, to) so that facet k is where sorting would put it (Hoare's selection). */
static void select_facet(struct facet *f, size_t from, size_t to, size_t k, int axis)
{
    while (to - from > 1) {
        double pivot = along(middle(&f[from + (to - from) / 2]), axis);
        size_t i = from, j = to - 1;
        for (;;) {
            while (along(middle(&f[i]), axis) < pivot)
                i++;
            while (along(middle(&f[j]), axis) > pivot)
                j--;
            if (i >= j)
                break;
            struct facet swap = f[i];
            f[i++] = f[j];
            f[j--] = swap;
        }
        size_t cut = i > from ? i : from + 1; /* none is before the pivot but the first */
        if (k < cut)
            to = cut;
        else
            from = cut;
    }
}

static void build(struct facet_tree *tree, size_t node, struct facet *f, size_t from, size_t to)
{
    struct box box = box_empty(), middles = box_empty();
    for (size_t i = from; i < to; i++) {
        for (int k = 0; k < 3; k++)
            box_add(&box, f[i].corner[k]);
        box_add(&middles, middle(&f[i]));
    }
    tree->box[node] = box;
    if (to - from <= LEAF)
        return;
    struct vec3 size = vec_sub(middles.high, middles.low);
    int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    size_t half = from + (to - from) / 2;
    select_facet(f, from, to, half, axis);
    build(tree, 2 * node + 1, f, from, half);
    build(tree, 2 * node + 2, f, half, to);
}

struct facet_tree *facet_tree_new(struct facets *facets)
{
    struct facet_tree *tree = mem_alloc(1, sizeof *tree);
    tree->facets = facets;
    tree->nodes = 1;
    for (size_t most = facets->n; most > LEAF; most -= most / 2)
        tree->nodes = 2 * tree->nodes + 1;
    tree->box = mem_alloc(tree->nodes, sizeof *tree->box);
    build(tree, 0, facets->item, 0, facets->n);
    return tree;
}

void facet_tree_free(struct facet_tree *tree)
{
    if (!tree)
        return;
    free(tree->box);
    free(tree);
}

struct vec3 facet_nearest(const struct facet *facet, struct vec3 p)
{
    const struct vec3 *c = facet->corner;
    struct vec3 u = vec_sub(c[1], c[0]), v = vec_sub(c[2], c[0]), w = vec_sub(p, c[0]);
    double uu = vec_dot(u, u), uv = vec_dot(u, v), vv = vec_dot(v, v);
    double det = uu * vv - uv * uv;
    if (det > 1e-14 * uu * vv) { /* else it is a straight piece or a point */
        double a = (vv * vec_dot(u, w) - uv * vec_dot(v, w)) / det;
        double b = (uu * vec_dot(v, w) - uv * vec_dot(u, w)) / det;
        if (a >= 0 && b >= 0 && a + b <= 1)
            return vec_along(vec_along(c[0], a, u), b, v);
    }
    struct vec3 best = vec_nearest(c[0], c[1], p);
    for (int k = 1; k < 3; k++) {
        struct vec3 q = vec_nearest(c[k], c[(k + 1) % 3], p);
        if (vec_distance(q, p) < vec_distance(best, p))
            best = q;
    }
    return best;
}

/* Facets [from, to) that lie in a node. */
struct span {
    size_t node, from, to;
};

/* The half of a node. */
static struct span half_of(struct span s, bool second)
{
    size_t half = s.from + (s.to - s.from) / 2;
    return second ? (struct span){2 * s.node + 2, half, s.to}
                  : (struct span){2 * s.node + 1, s.from, half};
}

double facet_tree_distance(const struct facet_tree *tree, struct vec3 p)
{
    struct span stack[DEPTH] = {{0, 0, tree->facets->n}};
    double best = HUGE_VAL;
    for (size_t n = 1; n > 0;) {
        struct span s = stack[--n];
        if (s.to == s.from || box_distance2(&tree->box[s.node], p) >= best * best)
            continue;
        if (s.to - s.from > LEAF) {
            struct span first = half_of(s, false), second = half_of(s, true);
            bool swap = box_distance2(&tree->box[first.node], p) <
                        box_distance2(&tree->box[second.node], p);
            stack[n++] = swap ? second : first; /* the nearer one is looked at first */
            stack[n++] = swap ? first : second;
            continue;
        }
        for (size_t i = s.from; i < s.to; i++)
            best = fmin(best, vec_distance(facet_nearest(&tree->facets->item[i], p), p));
    }
    return best;
}
