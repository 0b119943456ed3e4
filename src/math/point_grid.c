/* point_grid - a counting sort, then each cell by value; see point_grid.h. */
#include "math/point_grid.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/array.h"
#include "base/parallel.h"
#include "math/pair.h"

static const double CELLS_WIDE = 3; /* a cell, in spacings */

static double coordinate(struct vec3 p, int axis)
{
    return axis == 0 ? p.x : p.y;
}

/* The box of the points seen from above. */
static void range_of(const struct vec3 *point, size_t n, pair *low, pair *high)
{
    *low = *high = pair_at(&point[0].x);
    for (size_t i = 1; i < n; i++) {
        pair at = pair_at(&point[i].x);
        *low = pair_lesser(at, *low);
        *high = pair_greater(at, *high);
    }
}

/* The range without the few points far out: a histogram of it, cut from both ends as long as that
 * takes no more than a five hundredth of the points, and again while it gets much narrower. */
static void core_of(const struct vec3 *point, size_t n, int axis, double *low, double *high)
{
    enum { BINS = 256, ROUNDS = 8, PART = 500 };
    for (int round = 0; round<ROUNDS && * high> * low; round++) {
        size_t bin[BINS] = {0}, cut[2] = {0, 0};
        double width = (*high - *low) / BINS;
        for (size_t i = 0; i < n; i++) {
            double v = (coordinate(point[i], axis) - *low) / width;
            bin[v > 0 ? (v < BINS - 1 ? (size_t)v : BINS - 1) : 0]++;
        }
        size_t from = 0, to = BINS;
        while (from < to && (cut[0] += bin[from]) <= n / PART)
            from++;
        while (to > from && (cut[1] += bin[to - 1]) <= n / PART)
            to--;
        *high = *low + width * (double)to;
        *low += width * (double)from;
        if (to - from > BINS / 2)
            break;
    }
}

/* Cells over the box of the points; over their core where the box is mostly empty. */
static void lay_out(struct point_grid *b, double spacing)
{
    double most = fmin((double)b->n + 64, UINT32_MAX);
    pair low, high;
    range_of(b->point, b->n, &low, &high);
    double x1 = high[0], y1 = high[1];
    b->x = low[0];
    b->y = low[1];
    b->cell = CELLS_WIDE * spacing;
    if ((floor((x1 - b->x) / b->cell) + 1) * (floor((y1 - b->y) / b->cell) + 1) > most) {
        core_of(b->point, b->n, 0, &b->x, &x1);
        core_of(b->point, b->n, 1, &b->y, &y1);
    }
    double columns, rows;
    while ((columns = floor((x1 - b->x) / b->cell) + 1) *
               (rows = floor((y1 - b->y) / b->cell) + 1) >
           most)
        b->cell *= 2;
    b->columns = (size_t)columns;
    b->rows = (size_t)rows;
}

static size_t cell_from(double from, double cell, double v, size_t cells)
{
    double c = (v - from) / cell;
    if (!(c > 0))
        return 0;
    return c < (double)(cells - 1) ? (size_t)c : cells - 1;
}

size_t point_grid_column(const struct point_grid *b, double x)
{
    return cell_from(b->x, b->cell, x, b->columns);
}

size_t point_grid_row(const struct point_grid *b, double y)
{
    return cell_from(b->y, b->cell, y, b->rows);
}

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

static void sort_into_cells(struct point_grid *b, int threads)
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

int point_grid_make(struct vec3 *point, size_t n, double spacing, int threads,
                    struct point_grid *point_grid, struct error *error)
{
    if (n == 0 || n > UINT32_MAX)
        return error_set(error, "found %zu points, expected 1 to %lu", n,
                         (unsigned long)UINT32_MAX);
    *point_grid = (struct point_grid){.point = point, .n = n};
    lay_out(point_grid, spacing);
    sort_into_cells(point_grid, threads);
    return 0;
}

double point_grid_spacing(const struct point_grid *b)
{
    return b->cell / CELLS_WIDE;
}

void point_grid_free(struct point_grid *point_grid)
{
    free(point_grid->first);
    point_grid->first = NULL;
}

static bool has_any(const unsigned char *out, size_t n)
{
    enum { BLOCK = 64 };
    unsigned char any = 0;
    for (size_t i = 0; i < n && !any; i += BLOCK)
        for (size_t k = i; k < n && k < i + BLOCK; k++)
            any |= out[k];
    return any != 0;
}

void point_grid_remove(struct point_grid *b, const unsigned char *out)
{
    size_t cells = b->columns * b->rows, kept = 0;
    if (!has_any(out, b->n))
        return;
    for (size_t c = 0; c < cells; c++) {
        size_t from = b->first[c], to = b->first[c + 1];
        b->first[c] = (uint32_t)kept;
        for (size_t i = from; i < to; i++)
            if (!out[i])
                b->point[kept++] = b->point[i];
    }
    b->first[cells] = (uint32_t)kept;
    b->n = kept;
}

void point_grid_over(const struct point_grid *k, struct vec3 a, struct vec3 b, struct vec3 c,
                     double border, struct sizes *found)
{
    size_t c0 = point_grid_column(k, fmin(a.x, fmin(b.x, c.x)));
    size_t c1 = point_grid_column(k, fmax(a.x, fmax(b.x, c.x)));
    size_t r0 = point_grid_row(k, fmin(a.y, fmin(b.y, c.y)));
    size_t r1 = point_grid_row(k, fmax(a.y, fmax(b.y, c.y)));

    for (size_t r = r0; r <= r1; r++)
        for (size_t i = k->first[r * k->columns + c0]; i < k->first[r * k->columns + c1 + 1]; i++)
            if (vec_orient_xy(a, b, k->point[i]) >= -border &&
                vec_orient_xy(b, c, k->point[i]) >= -border &&
                vec_orient_xy(c, a, k->point[i]) >= -border)
                *array_push(found) = i;
}

void point_grid_within(const struct point_grid *b, struct vec3 q, double radius,
                       struct sizes *found)
{
    if (b->n == 0)
        return;
    size_t left = point_grid_column(b, q.x - radius), right = point_grid_column(b, q.x + radius);
    size_t low = point_grid_row(b, q.y - radius), high = point_grid_row(b, q.y + radius);

    for (size_t row = low; row <= high; row++)
        for (uint32_t i = b->first[row * b->columns + left];
             i < b->first[row * b->columns + right + 1]; i++) {
            struct vec3 d = vec_sub(b->point[i], q);
            if (vec_dot(d, d) <= radius * radius)
                *array_push(found) = i;
        }
}

/* ---- the nearest points
 *
 * Few points about a place are looked at all at once, and ordered by a histogram of their
 * distances: on a surface that fills it evenly.  A heap takes over where that does not serve. */

/* Points looked at at once, and wanted of them; parts of their distance; so many in one part are
 * not distinguished. */
enum { AT_ONCE = 2048, WANTED = 1024, BINS = 128, CROWD = 48, RINGS = 9 };

static const double ROUNDING = 1e-9; /* of a cell */

/* Cells up to `ring` columns and rows about a place. */
struct around {
    size_t column, row, left, right, low, high;
    double beyond; /* how near a point in no such cell can be: what lies beyond the border of all
                      cells was sorted into those at the border */
};

static struct around cells_around(const struct point_grid *b, struct vec3 q, size_t ring)
{
    struct around a = {.column = point_grid_column(b, q.x), .row = point_grid_row(b, q.y)};
    a.left = a.column > ring ? a.column - ring : 0;
    a.low = a.row > ring ? a.row - ring : 0;
    a.right = b->columns - 1 - a.column > ring ? a.column + ring : b->columns - 1;
    a.high = b->rows - 1 - a.row > ring ? a.row + ring : b->rows - 1;
    a.beyond = INFINITY;
    if (a.left > 0)
        a.beyond = fmin(a.beyond, q.x - (b->x + b->cell * (double)a.left));
    if (a.right + 1 < b->columns)
        a.beyond = fmin(a.beyond, b->x + b->cell * (double)(a.right + 1) - q.x);
    if (a.low > 0)
        a.beyond = fmin(a.beyond, q.y - (b->y + b->cell * (double)a.low));
    if (a.high + 1 < b->rows)
        a.beyond = fmin(a.beyond, b->y + b->cell * (double)(a.high + 1) - q.y);
    a.beyond -= ROUNDING * b->cell;
    return a;
}

/* The points of a row of cells, from one column to another. */
static uint32_t row_begin(const struct point_grid *b, const struct around *a, size_t row)
{
    return b->first[row * b->columns + a->left];
}

static uint32_t row_end(const struct point_grid *b, const struct around *a, size_t row)
{
    return b->first[row * b->columns + a->right + 1];
}

struct some {
    size_t n;
    uint32_t index[AT_ONCE];
    double distance2[AT_ONCE];
};

/* All points nearer than `within2`, in their order. */
static void gather(const struct point_grid *b, struct vec3 q, const struct around *a,
                   double within2, struct some *some)
{
    size_t n = 0;
    const pair at = {q.x, q.y};
    for (size_t row = a->low; row <= a->high; row++) {
        uint32_t i = row_begin(b, a, row), end = row_end(b, a, row);
        for (const struct vec3 *p = b->point + i; i < end; i++, p++) {
            pair d = pair_at(&p->x) - at, squares = d * d;
            double z = p->z - q.z, d2 = squares[0] + squares[1] + z * z;
            some->index[n] = i;
            some->distance2[n] = d2;
            n += d2 < within2;
        }
    }
    some->n = n;
}

/* The analyser does not see that the first n of these lists are set. */
/* NOLINTBEGIN(clang-analyzer-core.*) */

/* The nearest of them, in order. */
struct sorted {
    size_t n;
    uint32_t index[WANTED + CROWD];
    double distance2[WANTED + CROWD];
};

/* Puts a point after those before it that are no farther. */
static void insert(struct sorted *s, size_t at)
{
    uint32_t index = s->index[at];
    double distance2 = s->distance2[at];
    for (; at > 0 && s->distance2[at - 1] > distance2; at--) {
        s->index[at] = s->index[at - 1];
        s->distance2[at] = s->distance2[at - 1];
    }
    s->index[at] = index;
    s->distance2[at] = distance2;
}

/* The first k of them by distance; false: too many are about equally far. */
static bool sort_out(const struct some *some, double within2, size_t k, uint32_t *index,
                     double *distance2)
{
    uint32_t begin[BINS + 1] = {0}, last = 0;
    unsigned char bin[AT_ONCE];
    struct sorted sorted;
    double scale = BINS / within2;
    for (size_t i = 0; i < some->n; i++) { /* an int is had of a double at once, a size_t is not */
        int at = (int)(some->distance2[i] * scale);
        bin[i] = (unsigned char)(at < BINS ? at : BINS - 1);
        begin[bin[i] + 1]++;
    }
    for (uint32_t from = 0; from < k; last++) {
        if (begin[last + 1] > CROWD)
            return false;
        from = begin[last + 1] += from;
    }
    sorted.n = begin[last];
    for (size_t i = 0; i < some->n; i++) {
        if (bin[i] < last) {
            size_t at = begin[bin[i]]++;
            sorted.index[at] = some->index[i];
            sorted.distance2[at] = some->distance2[i];
        }
    }
    for (size_t i = 1; i < sorted.n; i++)
        insert(&sorted, i);
    for (size_t i = 0; i < k; i++) {
        index[i] = sorted.index[i];
        distance2[i] = sorted.distance2[i];
    }
    return true;
}
/* NOLINTEND(clang-analyzer-core.*) */

/* False: where there are too many points at once, or too few. */
static bool near_at_once(const struct point_grid *b, struct vec3 q, size_t k, uint32_t *index,
                         double *distance2)
{
    struct some some;
    for (size_t ring = 1; ring < RINGS; ring++) {
        struct around a = cells_around(b, q, ring);
        size_t n = 0;
        for (size_t row = a.low; row <= a.high; row++)
            n += row_end(b, &a, row) - row_begin(b, &a, row);
        if (n >= AT_ONCE || a.beyond == INFINITY)
            return false;
        if (n < 2 * k)
            continue;
        gather(b, q, &a, a.beyond * a.beyond, &some);
        if (some.n >= k)
            return sort_out(&some, a.beyond * a.beyond, k, index, distance2);
    }
    return false;
}

/* The nearest points so far: a heap with the farthest of them on top. */
struct heap {
    size_t n, k;
    uint32_t *index;
    double *distance2;
};

/* Of two equally far points the later one in the array is the farther. */
static int is_farther(const struct heap *h, size_t a, size_t b)
{
    if (h->distance2[a] != h->distance2[b])
        return h->distance2[a] > h->distance2[b];
    return h->index[a] > h->index[b];
}

/* Puts a point where `at` is free, among the first n, its children nearer. */
static void sift_down(struct heap *h, size_t at, size_t n, uint32_t index, double distance2)
{
    for (size_t child; (child = 2 * at + 1) < n; at = child) {
        child += child + 1 < n && is_farther(h, child + 1, child);
        if (h->distance2[child] < distance2 ||
            (h->distance2[child] == distance2 && h->index[child] < index))
            break;
        h->index[at] = h->index[child];
        h->distance2[at] = h->distance2[child];
    }
    h->index[at] = index;
    h->distance2[at] = distance2;
}

static void offer_cells(const struct point_grid *b, struct vec3 q, size_t row, size_t from,
                        size_t to, struct heap *h)
{
    const uint32_t *first = b->first + row * b->columns;
    for (uint32_t i = first[from]; i < first[to + 1]; i++) {
        struct vec3 d = vec_sub(b->point[i], q);
        double d2 = vec_dot(d, d);
        if (h->n < h->k) {
            h->index[h->n] = i;
            h->distance2[h->n++] = d2;
            if (h->n == h->k)
                for (size_t at = h->k / 2; at-- > 0;)
                    sift_down(h, at, h->k, h->index[at], h->distance2[at]);
        } else if (d2 < h->distance2[0] || (d2 == h->distance2[0] && i < h->index[0])) {
            sift_down(h, 0, h->k, i, d2);
        }
    }
}

/* Nearest first: the farthest to the end, again and again. */
static void sort_heap(struct heap *h)
{
    if (h->n < h->k)
        for (size_t at = h->n / 2; at-- > 0;)
            sift_down(h, at, h->n, h->index[at], h->distance2[at]);
    for (size_t last = h->n; last-- > 1;) {
        uint32_t index = h->index[last];
        double distance2 = h->distance2[last];
        h->index[last] = h->index[0];
        h->distance2[last] = h->distance2[0];
        sift_down(h, 0, last, index, distance2);
    }
}

/* The cells whose column or row is `ring` away; how near a point beyond them can be. */
static double offer_ring(const struct point_grid *b, struct vec3 q, size_t ring, struct heap *h)
{
    struct around a = cells_around(b, q, ring);
    for (size_t r = a.low; r <= a.high; r++) {
        if (r + ring == a.row || r == a.row + ring) {
            offer_cells(b, q, r, a.left, a.right, h);
            continue;
        }
        if (a.column >= ring)
            offer_cells(b, q, r, a.left, a.left, h);
        if (a.column + ring < b->columns)
            offer_cells(b, q, r, a.right, a.right, h);
    }
    return a.beyond;
}

size_t point_grid_nearest(const struct point_grid *point_grid, struct vec3 q, size_t k,
                          uint32_t *index, double *distance2)
{
    struct heap h = {0, k < point_grid->n ? k : point_grid->n, index, distance2};
    if (h.k == 0 || (k <= WANTED && near_at_once(point_grid, q, k, index, distance2)))
        return h.k;
    for (size_t ring = 0;; ring++) {
        double beyond = offer_ring(point_grid, q, ring, &h);
        if (beyond == INFINITY || (h.n == h.k && beyond > 0 && h.distance2[0] < beyond * beyond))
            break;
    }
    sort_heap(&h);
    return h.n;
}

size_t point_grid_near(const struct point_grid *point_grid, struct vec3 q, size_t k,
                       struct vec3 *near)
{
    uint32_t index[POINT_GRID_NEAR];
    double distance2[POINT_GRID_NEAR];
    size_t n = point_grid_nearest(point_grid, q, k < POINT_GRID_NEAR ? k : POINT_GRID_NEAR, index,
                                  distance2);

    for (size_t i = 0; i < n; i++)
        near[i] = point_grid->point[index[i]];
    return n;
}
