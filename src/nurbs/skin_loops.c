/* skin_loops - see skin_loops.h. */
#include "skin_loops.h"

#include <stdlib.h>

#include "math/box_tree.h"

/* The open edges of each sheet in a tree of its own, and a tree of the sheets that have any: the
 * edges of one's own sheet, which are always the nearest, need not be looked through. */
struct borders {
    size_t n;
    size_t *number;         /* [sheet] which of them is its, from 1 */
    struct facets *edge;    /* [n] of one sheet each, as straight pieces */
    struct box_tree **tree; /* [n] */
    struct box_tree *sheets;
    size_t own; /* the one that does not count */
};

static struct vec3 point_of(const struct patch_mesh *q, size_t place)
{
    return q->vertex.item[place].point;
}

static void borders_make(const struct patch_mesh *q, const struct skin_sides *open,
                         struct borders *b)
{
    *b = (struct borders){.number = mem_alloc(q->sheets + 1, sizeof *b->number)};
    for (size_t i = 0; i < open->n; i++) {
        size_t *number = &b->number[q->sheet.item[open->item[i].facet]];
        *number = *number == 0 ? ++b->n : *number;
    }
    b->edge = mem_alloc(b->n + 1, sizeof *b->edge);
    b->tree = mem_alloc(b->n + 1, sizeof(struct box_tree *));
    struct box *box = mem_alloc(b->n + 1, sizeof *box);
    for (size_t i = 0; i < open->n; i++) {
        const struct skin_side *s = &open->item[i];
        struct vec3 low = point_of(q, s->low), high = point_of(q, s->high);
        struct facets *of = &b->edge[b->number[q->sheet.item[s->facet]] - 1];
        *array_push(of) = (struct facet){{low, high, high}};
    }
    for (size_t k = 0; k < b->n; k++) {
        box[k] = box_empty();
        for (size_t i = 0; i < b->edge[k].n; i++)
            for (int c = 0; c < 2; c++)
                box_add(&box[k], b->edge[k].item[i].corner[c]);
        b->tree[k] = facets_tree(&b->edge[k]);
    }
    b->sheets = box_tree_new(box, b->n);
    free(box);
}

static void borders_free(struct borders *b)
{
    for (size_t k = 0; k < b->n; k++) {
        box_tree_free(b->tree[k]);
        array_free(&b->edge[k]);
    }
    box_tree_free(b->sheets);
    free(b->tree);
    free(b->edge);
    free(b->number);
}

static double sheet_distance2(const void *items, size_t item, struct vec3 p)
{
    const struct borders *b = items;
    double d = item == b->own ? HUGE_VAL : facets_distance(b->tree[item], &b->edge[item], p);
    return d * d;
}

/* How far a place is from the open edges of other sheets than its own. */
static double gap_at(struct borders *b, size_t own, struct vec3 p)
{
    size_t nearest = b->n;
    b->own = own;
    return box_tree_nearest(b->sheets, b, sheet_distance2, p, HUGE_VAL, &nearest);
}

static size_t root(size_t *parent, size_t i)
{
    while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
    return i;
}

static int compare_loops(const void *p, const void *q)
{
    const struct skin_loop *a = p, *b = q;

    if (a->length < b->length || a->length > b->length)
        return a->length > b->length ? -1 : 1;
    return (a->sheet > b->sheet) - (a->sheet < b->sheet);
}

/* The loop of each open edge, in of[]. */
static void number_loops(const struct patch_mesh *q, const struct skin_sides *open, size_t *of,
                         struct skin_loops *loops)
{
    size_t *parent = mem_alloc(q->vertex.n + 1, sizeof *parent);
    size_t *loop = mem_alloc(q->vertex.n + 1, sizeof *loop); /* from 1 */

    for (size_t i = 0; i < q->vertex.n; i++)
        parent[i] = i;
    for (size_t i = 0; i < open->n; i++) {
        size_t a = root(parent, open->item[i].low), b = root(parent, open->item[i].high);
        parent[a > b ? a : b] = a > b ? b : a;
    }
    for (size_t i = 0; i < open->n; i++) {
        size_t *number = &loop[root(parent, open->item[i].low)];
        if (*number == 0) {
            *array_push(loops) = (struct skin_loop){.at = point_of(q, open->item[i].low)};
            *number = loops->n;
        }
        of[i] = *number - 1;
    }
    free(parent);
    free(loop);
}

/* Takes the edges into their loops. */
static void measure(const struct patch_mesh *q, const struct skin_sides *open, const size_t *of,
                    struct borders *b, struct skin_loops *loops)
{
    struct doubles longest = {0};

    for (size_t i = 0; i < loops->n; i++)
        *array_push(&longest) = 0;
    for (size_t i = 0; i < open->n; i++) {
        const struct skin_side *s = &open->item[i];
        int sheet = q->sheet.item[s->facet];
        struct vec3 low = point_of(q, s->low), high = point_of(q, s->high);
        struct vec3 middle = vec_mix(low, high, 0.5);
        struct skin_loop *l = &loops->item[of[i]];
        double length = vec_distance(low, high);
        l->edges++;
        l->length += length;
        if (length > longest.item[of[i]]) {
            longest.item[of[i]] = length;
            l->sheet = sheet;
        }
        double gap = gap_at(b, b->number[sheet] - 1, middle);
        if (gap > l->gap) {
            l->gap = gap;
            l->at = middle;
        }
    }
    array_free(&longest);
}

struct skin_loops skin_loops_find(const struct patch_mesh *q, const struct skin_sides *open)
{
    struct skin_loops loops = {0};
    struct borders b;
    size_t *of = mem_alloc(open->n + 1, sizeof *of);

    number_loops(q, open, of, &loops);
    borders_make(q, open, &b);
    measure(q, open, of, &b, &loops);
    if (loops.n > 1)
        qsort(loops.item, loops.n, sizeof *loops.item, compare_loops);
    borders_free(&b);
    free(of);
    return loops;
}
