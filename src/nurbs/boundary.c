/* boundary - see boundary.h. */
#include "boundary.h"

#include <stdlib.h>

struct between {
    size_t low, high, edge;
};

static int compare(const void *p, const void *q)
{
    const struct between *a = p, *b = q;
    if (a->low != b->low)
        return a->low < b->low ? -1 : 1;
    if (a->high != b->high)
        return a->high < b->high ? -1 : 1;
    return a->edge < b->edge ? -1 : a->edge > b->edge;
}

static int compare_sizes(const void *p, const void *q)
{
    const size_t *a = p, *b = q;
    return *a < *b ? -1 : *a > *b;
}

static void find_edges(const struct patch_mesh *q, struct sizes *edge)
{
    struct between *all = mem_alloc(q->edge.n + 1, sizeof *all);
    size_t n = 0;
    for (size_t i = 0; i < q->edge.n; i++) {
        size_t a = q->vertex.item[q->edge.item[i].from].place;
        size_t b = q->vertex.item[q->edge.item[i].to].place;
        if (a != b)
            all[n++] = (struct between){a < b ? a : b, a < b ? b : a, i};
    }
    if (n > 0)
        qsort(all, n, sizeof *all, compare);
    for (size_t i = 0, k; i < n; i += k) {
        for (k = 1; i + k < n && all[i + k].low == all[i].low && all[i + k].high == all[i].high;)
            k++;
        if (k == 1)
            *array_push(edge) = all[i].edge;
    }
    if (edge->n > 0)
        qsort(edge->item, edge->n, sizeof *edge->item, compare_sizes);
    free(all);
}

void boundary_find(const struct patch_mesh *q, struct boundary *b)
{
    bool *seen = mem_alloc(q->vertex.n + 1, sizeof *seen);
    struct vec3s point = {0};
    *b = (struct boundary){0};
    find_edges(q, &b->edge);
    for (size_t i = 0; i < b->edge.n; i++) {
        const struct patch_mesh_edge *e = &q->edge.item[b->edge.item[i]];
        seen[e->from] = seen[e->to] = true;
    }
    for (size_t i = 0; i < q->vertex.n; i++)
        if (seen[i]) {
            *array_push(&b->vertex) = i;
            *array_push(&point) = q->vertex.item[i].point;
        }
    b->tree = kdtree_new(point.item, point.n);
    array_free(&point);
    free(seen);
}

void boundary_free(struct boundary *b)
{
    array_free(&b->edge);
    array_free(&b->vertex);
    kdtree_free(b->tree);
    b->tree = NULL;
}
