/*
 * point_grid_nearest - see point_grid.h: the points of a grid nearest to a place.
 *
 * Few points about a place are looked at all at once, and ordered by a histogram of their
 * distances: on a surface that fills it evenly.  With two parts for each point most parts hold one
 * or none, and are in order already.  A heap takes over where that does not serve.
 */
#include "math/point_grid.h"

#include <stdbool.h>
#include <string.h>

#include "math/elementary.h"
#include "math/pair.h"

/* Points looked at at once, and wanted of them; parts of their distance, for each of the points and
 * at most; so many in one part are not distinguished. */
enum { AT_ONCE = 2048, WANTED = 1024, BY_POINT = 2, BINS = 2048, CROWD = 48, RINGS = 9 };

/* So many points of one cell are not gone through one by one. */
enum { MANY = 256 };

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

/* The nearest of them, in order, and room for one more. */
struct sorted {
    size_t n;
    uint32_t index[WANTED + CROWD + 1];
    double distance2[WANTED + CROWD + 1];
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
    uint32_t begin[BINS + 1], last = 0;
    uint16_t bin[AT_ONCE];
    struct sorted sorted;
    int bins = BY_POINT * (int)some->n < BINS ? BY_POINT * (int)some->n : BINS;
    double scale = bins / within2;
    memset(begin, 0, ((size_t)bins + 1) * sizeof *begin);
    for (size_t i = 0; i < some->n; i++) { /* an int is had of a double at once, a size_t is not */
        int at = (int)(some->distance2[i] * scale);
        bin[i] = (uint16_t)(at < bins ? at : bins - 1);
        begin[bin[i] + 1]++;
    }
    for (uint32_t from = 0; from < k; last++) {
        if (begin[last + 1] > CROWD)
            return false;
        from = begin[last + 1] += from;
    }
    sorted.n = begin[last];
    for (size_t i = 0; i < some->n; i++) { /* the others to the place behind them: no jumps */
        uint32_t in = bin[i] < last ? bin[i] : last;
        size_t at = begin[in];
        begin[in] += bin[i] < last;
        sorted.index[at] = some->index[i];
        sorted.distance2[at] = some->distance2[i];
    }
    for (size_t i = 1; i < sorted.n; i++)
        insert(&sorted, i);
    memcpy(index, sorted.index, k * sizeof *index);
    memcpy(distance2, sorted.distance2, k * sizeof *distance2);
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

static void offer_points(const struct point_grid *b, struct vec3 q, uint32_t from, uint32_t to,
                         struct heap *h)
{
    for (uint32_t i = from; i < to; i++) {
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

static double outside(double x, double low, double high)
{
    return x < low ? low - x : x > high ? x - high : 0;
}

/* How near points of a cell can be, squared: sorted by x, y, z as they are, those from one to
 * another lie between the two by x, those of one x by y, and those of one y by z. */
static double nearest_of(const struct point_grid *b, struct vec3 q, uint32_t from, uint32_t to)
{
    struct vec3 low = b->point[from], high = b->point[to - 1];
    bool one_x = !(low.x < high.x), one_y = one_x && !(low.y < high.y);
    struct vec3 d = {outside(q.x, low.x, high.x), one_x ? outside(q.y, low.y, high.y) : 0,
                     one_y ? outside(q.z, low.z, high.z) : 0};

    return vec_dot(d, d);
}

/* Points of one cell: of many, as on an upright line, the nearer half first. */
static void offer_part(const struct point_grid *b, struct vec3 q, uint32_t from, uint32_t to,
                       struct heap *h)
{
    if (to - from <= MANY) {
        offer_points(b, q, from, to, h);
        return;
    }
    uint32_t middle = from + (to - from) / 2;
    double low = nearest_of(b, q, from, middle), high = nearest_of(b, q, middle, to);
    for (int i = 0; i < 2; i++)
        if ((i == 0) == (low <= high)) {
            if (h->n < h->k || low <= h->distance2[0])
                offer_part(b, q, from, middle, h);
        } else if (h->n < h->k || high <= h->distance2[0]) {
            offer_part(b, q, middle, to, h);
        }
}

static void offer_cells(const struct point_grid *b, struct vec3 q, size_t row, size_t from,
                        size_t to, struct heap *h)
{
    const uint32_t *first = b->first + row * b->columns;
    if (first[to + 1] - first[from] <= MANY) {
        offer_points(b, q, first[from], first[to + 1], h);
        return;
    }
    for (size_t cell = from; cell <= to; cell++)
        offer_part(b, q, first[cell], first[cell + 1], h);
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
