/* skin_sides - see skin_sides.h. */
#include "skin_sides.h"

#include <stdlib.h>

static size_t place_of(const struct patch_mesh *q, int vertex)
{
    return q->vertex.item[vertex].place;
}

bool skin_facet_counts(const struct patch_mesh *q, size_t facet)
{
    const int *v = q->face.item[facet].v;
    size_t a = place_of(q, v[0]), b = place_of(q, v[1]), c = place_of(q, v[2]);

    return a != b && b != c && c != a;
}

static int compare_sides(const void *p, const void *q)
{
    const struct skin_side *a = p, *b = q;

    if (a->high != b->high)
        return a->high < b->high ? -1 : 1;
    return (a->facet > b->facet) - (a->facet < b->facet);
}

/* The few sides of one place, by insertion: no call for each comparison. */
static void sort_sides(struct skin_side *side, size_t n)
{
    enum { FEW = 24 };

    if (n > FEW) {
        qsort(side, n, sizeof *side, compare_sides);
        return;
    }
    for (size_t i = 1; i < n; i++) {
        struct skin_side s = side[i];
        size_t k = i;
        for (; k > 0 && compare_sides(&side[k - 1], &s) > 0; k--)
            side[k] = side[k - 1];
        side[k] = s;
    }
}

/* A counting sort by the lower place; the sides of one place are compared. */
struct skin_side *skin_sides_find(const struct patch_mesh *q, size_t *n)
{
    size_t *from = mem_alloc(q->vertex.n + 2, sizeof *from);
    struct skin_side *side = mem_alloc(3 * q->face.n + 1, sizeof *side);

    for (int round = 0; round < 2; round++) {
        for (size_t f = 0; f < q->face.n; f++) {
            bool flip = q->flipped[q->sheet.item[f]];
            for (int k = 0; k < 3 && skin_facet_counts(q, f); k++) {
                size_t a = place_of(q, q->face.item[f].v[k]);
                size_t b = place_of(q, q->face.item[f].v[(k + 1) % 3]);
                size_t low = a < b ? a : b, high = a < b ? b : a;
                if (round == 0)
                    from[low + 2]++;
                else
                    side[from[low + 1]++] = (struct skin_side){low, high, f, (a < b) != flip, k};
            }
        }
        for (size_t i = 0; round == 0 && i < q->vertex.n; i++)
            from[i + 2] += from[i + 1];
    }
    for (size_t i = 0; i < q->vertex.n; i++)
        if (from[i + 1] > from[i])
            sort_sides(side + from[i], from[i + 1] - from[i]);
    *n = from[q->vertex.n];
    free(from);
    return side;
}

size_t skin_sides_same(const struct skin_side *side, size_t n, size_t i)
{
    size_t k = 1;

    while (i + k < n && side[i + k].low == side[i].low && side[i + k].high == side[i].high)
        k++;
    return k;
}

bool skin_edge_sound(const struct skin_side *side, size_t k)
{
    return k == 2 && side[0].forward != side[1].forward;
}

size_t skin_count_unsound(const struct patch_mesh *mesh)
{
    size_t n, unsound = 0;
    struct skin_side *side = skin_sides_find(mesh, &n);
    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        unsound += !skin_edge_sound(&side[i], k);
    }
    free(side);
    return unsound;
}
