/* point_grid_sort - see point_grid_sort.h. */
#include "point_grid_sort.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/parallel.h"
#include "math/pair.h"

/* Of many points: what each needs of the grid, and no jumps. */
struct cells {
    pair corner, width, last; /* the last column and row */
    uint32_t columns;
};

static struct cells cells_of(const struct point_grid *b)
{
    return (struct cells){.corner = {b->x, b->y},
                          .width = pair_both(b->cell),
                          .last = {(double)(b->columns - 1), (double)(b->rows - 1)},
                          .columns = (uint32_t)b->columns};
}

/* The same cell as by its column and row. */
static inline uint32_t cell_of(const struct cells *c, const struct vec3 *p)
{
    const pair none = {0, 0};
    pair at = (pair_at(&p->x) - c->corner) / c->width;
    at = pair_lesser(pair_greater(at, none), c->last);
    return (uint32_t)(int64_t)at[1] * c->columns + (uint32_t)(int64_t)at[0];
}

static inline bool comes_before(const struct vec3 *p, const struct vec3 *q)
{
    return p->x != q->x ? p->x < q->x : vec_compare(p, q) < 0;
}

/* Counts the points of each cell, of cell c in first[c + 1], as long as they are sorted by cells,
 * and in each by x, y, z.  False: they are not. */
static bool count_in_order(struct point_grid *b, const struct cells *cells)
{
    uint32_t before = 0;

    for (size_t i = 0; i < b->n; i++) {
        uint32_t c = cell_of(cells, &b->point[i]);
        if (c < before || (c == before && i > 0 && comes_before(&b->point[i], &b->point[i - 1])))
            return false;
        b->first[c + 1]++;
        before = c;
    }
    return true;
}

/* Points in hand, each on its way to its part; on which one has no bearing on another's. */
enum { IN_HAND = 32 };

struct hand {
    size_t n;
    struct vec3 point[IN_HAND];
    uint32_t part[IN_HAND];
};

/* Fills one part from next[part] to its end: its last points are taken in hand, and each that is in
 * hand is put where its own part has room, in exchange for what stands there, until all places
 * where points were taken are filled. */
static void fill_part(const struct point_grid *b, const struct cells *cells, int shift,
                      uint32_t from, uint32_t part, uint32_t end, uint32_t *next)
{
    struct hand hand = {.n = end - next[part] < IN_HAND ? end - next[part] : IN_HAND};
    uint32_t taken = end - (uint32_t)hand.n;

    memcpy(hand.point, b->point + taken, hand.n * sizeof *hand.point);
    while (hand.n > 0) {
        size_t left = 0;
        for (size_t i = 0; i < hand.n; i++)
            hand.part[i] = (cell_of(cells, &hand.point[i]) - from) >> shift;
        for (size_t i = 0; i < hand.n; i++) {
            uint32_t at = next[hand.part[i]]++;
            struct vec3 p = hand.point[i];
            hand.point[left] = b->point[at];
            b->point[at] = p;
            left += hand.part[i] != part || at < taken;
        }
        hand.n = left;
    }
}

/* Each point is put into its part, with no copy of the cloud (McIlroy, Bostic and McIlroy 1993,
 * American flag sort, here with several points in hand).  A part: 2^shift cells, from one that is
 * such a multiple on, counted from cell `from`.  next[]: of each part, where its next point goes;
 * end[]: where it ends. */
static void exchange(const struct point_grid *b, int shift, uint32_t from, size_t parts,
                     uint32_t *next, const uint32_t *end)
{
    const struct cells cells = cells_of(b);

    for (uint32_t c = 0; c < parts; c++)
        if (next[c] < end[c])
            fill_part(b, &cells, shift, from, c, end[c], next);
}

/* Parts of the cloud, 2^shift cells each: few, so that where each goes on stays near while a cloud
 * in no order is gone through, and small, so that what is done within one stays near, too. */
enum { PARTS = 256, AT_HAND = 1 << 17 /* points of a part of which there may be a copy */ };

struct sorting {
    struct point_grid *grid;
    int shift;
    size_t parts;
    uint32_t end[PARTS];
};

static void sort_into_parts(struct sorting *s)
{
    const struct point_grid *b = s->grid;
    const struct cells cells = cells_of(b);
    uint32_t next[PARTS] = {0}, from = 0;

    for (size_t i = 0; i < b->n; i++)
        next[cell_of(&cells, &b->point[i]) >> s->shift]++;
    for (size_t k = 0; k < s->parts; k++) {
        uint32_t n = next[k];
        next[k] = from;
        s->end[k] = from += n;
    }
    exchange(b, s->shift, 0, s->parts, next, s->end);
}

static void sort_cell(struct vec3 *p, size_t n)
{
    enum { FEW = 24 };
    if (n > FEW) {
        qsort(p, n, sizeof *p, vec_compare);
        return;
    }
    for (size_t i = 1; i < n; i++) {
        struct vec3 v = p[i];
        size_t k = i;
        for (; k > 0 && comes_before(&v, &p[k - 1]); k--)
            p[k] = p[k - 1];
        p[k] = v;
    }
}

/* Room for a part. */
struct copy {
    struct vec3 *point;
    uint32_t *cell, *next;
};

/* The points of one part by their cells, from a copy or, where there are very many, in exchange. */
static void sort_part(const struct sorting *s, size_t part, const struct copy *copy)
{
    const struct point_grid *b = s->grid;
    const struct cells all = cells_of(b);
    size_t cells = b->columns * b->rows, c0 = part << s->shift;
    size_t c1 = c0 + ((size_t)1 << s->shift) < cells ? c0 + ((size_t)1 << s->shift) : cells;
    uint32_t from = part > 0 ? s->end[part - 1] : 0, n = s->end[part] - from, *next = copy->next;
    struct vec3 *point = b->point + from;

    memset(next, 0, (c1 - c0) * sizeof *next);
    for (uint32_t i = 0; i < n; i++) {
        uint32_t c = cell_of(&all, &point[i]) - (uint32_t)c0;
        if (n <= AT_HAND)
            copy->cell[i] = c;
        next[c]++;
    }
    for (size_t c = c0; c < c1; c++) {
        uint32_t of_cell = next[c - c0];
        next[c - c0] = from;
        b->first[c + 1] = from += of_cell;
    }
    if (n <= AT_HAND) {
        memcpy(copy->point, point, n * sizeof *point);
        for (uint32_t i = 0; i < n; i++)
            b->point[next[copy->cell[i]]++] = copy->point[i];
    } else {
        exchange(b, 0, (uint32_t)c0, c1 - c0, next, b->first + c0 + 1);
    }
    for (size_t c = c0; c < c1; c++) {
        uint32_t begin = c > c0 ? b->first[c] : s->end[part] - n;
        sort_cell(b->point + begin, b->first[c + 1] - begin);
    }
}

static void sort_parts(void *context, size_t from, size_t to)
{
    const struct sorting *s = context;
    size_t most = 0;
    for (size_t k = from; k < to; k++) {
        size_t n = s->end[k] - (k > 0 ? s->end[k - 1] : 0);
        most = n > most && n <= AT_HAND ? n : most;
    }
    struct copy copy = {mem_alloc(most, sizeof *copy.point), mem_alloc(most, sizeof *copy.cell),
                        mem_alloc((size_t)1 << s->shift, sizeof *copy.next)};
    for (size_t k = from; k < to; k++)
        sort_part(s, k, &copy);
    free(copy.point);
    free(copy.cell);
    free(copy.next);
}

void point_grid_sort(struct point_grid *b, int threads)
{
    size_t cells = b->columns * b->rows;
    struct sorting s = {.grid = b};
    const struct cells all = cells_of(b);

    b->first = mem_alloc(cells + 1, sizeof *b->first);
    if (count_in_order(b, &all)) {
        for (size_t c = 0; c < cells; c++)
            b->first[c + 1] += b->first[c];
        return;
    }
    b->first[0] = 0;
    while ((cells - 1) >> s.shift >= PARTS)
        s.shift++;
    s.parts = ((cells - 1) >> s.shift) + 1;
    sort_into_parts(&s);
    parallel_for(threads, s.parts, sort_parts, &s);
}
