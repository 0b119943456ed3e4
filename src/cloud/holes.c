/*
 * holes - every point marks the cells within half the gap of it; what is left are the middles of
 * holes, which unmark all about them but a rim; a facet bridges a hole when it has an unmarked
 * cell; see holes.h.  A cell is a bit, so that a whole cloud's marks grow into discs 64 cells at a
 * time.
 */
#include "cloud/holes.h"

#include <stdlib.h>

#include "base/array.h"
#include "cloud/plan_extent.h"

enum { CELLS_A_GAP = 12, REACH = CELLS_A_GAP / 2, WORD = 64 };

static const double MOST_CELLS = 2e9;

/* The raster with a border of REACH cells around the points, so that no disc falls outside. */
int holes_begin(const struct plan_extent *f, double gap, double rim, struct holes *h,
                struct error *error)
{
    double cell = gap / CELLS_A_GAP;
    double columns = floor((f->xmax - f->xmin) / cell) + 2 + 2 * REACH;
    double rows = floor((f->ymax - f->ymin) / cell) + 2 + 2 * REACH;
    if (!(columns * rows <= MOST_CELLS))
        return error_set(error,
                         "a largest gap of %g mm is too small for points that reach over "
                         "%g x %g mm, expected more than %.2g mm",
                         gap, f->xmax - f->xmin, f->ymax - f->ymin,
                         gap * sqrt(columns * rows / MOST_CELLS));
    size_t words = (size_t)columns / WORD + 1;
    *h = (struct holes){
        fmin(rim, gap / 2), cell, f->xmin, f->ymin, (size_t)rows, words, 0, NULL, NULL};
    h->reach = (int)floor((gap / 2 - rim) / cell);
    h->taken = mem_alloc(h->rows * h->words, sizeof *h->taken);
    return 0;
}

/* Cells from the lowest leftmost point, so that rounding puts no point into the border; a place on
 * a facet may lie before it by rounding. */
static size_t cells_from(double from, double x, double a_cell)
{
    double cells = (x - from) * a_cell;
    return REACH + (cells > 0 ? (size_t)cells : 0);
}

void holes_add(struct holes *h, const struct vec3 *point, size_t n)
{
    double a_cell = 1 / h->cell;
    for (size_t i = 0; i < n; i++) {
        size_t column = cells_from(h->x, point[i].x, a_cell);
        size_t row = cells_from(h->y, point[i].y, a_cell);
        h->taken[row * h->words + column / WORD] |= (uint64_t)1 << column % WORD;
    }
}

/* Adds a row to another, each mark grown by `width` cells to both sides. */
static void add_grown(uint64_t *to, const uint64_t *from, size_t words, int width)
{
    for (size_t i = 0; i < words; i++) {
        uint64_t before = i > 0 ? from[i - 1] : 0, behind = i + 1 < words ? from[i + 1] : 0;
        uint64_t grown = from[i];
        for (int k = 1; k <= width; k++)
            grown |= from[i] << k | from[i] >> k | before >> (WORD - k) | behind << (WORD - k);
        to[i] |= grown;
    }
}

/* The cells within `reach` cells of a hole's middle, where a disc as wide as the gap is empty, lose
 * their mark: all of the hole but its rim. */
static void open_holes(struct holes *h, int reach)
{
    size_t words = h->words;
    uint64_t *open = mem_alloc(h->rows * words, sizeof *open);
    uint64_t *empty = mem_alloc(words, sizeof *empty);

    for (size_t row = REACH; row < h->rows - REACH; row++) {
        uint64_t any = 0;
        for (size_t i = 0; i < words; i++)
            any |= empty[i] = ~h->near[row * words + i];
        for (int away = -reach; any && away <= reach; away++)
            add_grown(open + (size_t)((long)row + away) * words, empty, words,
                      (int)sqrt(reach * reach - away * away));
    }
    for (size_t i = 0; i < h->rows * words; i++)
        h->near[i] &= ~open[i];
    free(empty);
    free(open);
}

void holes_end(struct holes *holes)
{
    size_t words = holes->words;

    holes->near = mem_alloc(holes->rows * words, sizeof *holes->near);
    for (size_t row = REACH; row < holes->rows - REACH; row++)
        for (int k = 0; k <= 2 * REACH; k++) {
            int away = k - REACH, width = (int)sqrt(REACH * REACH - away * away);
            add_grown(holes->near + (row - REACH + (size_t)k) * words, holes->taken + row * words,
                      words, width);
        }
    free(holes->taken);
    holes->taken = NULL;
    if (holes->reach > 0)
        open_holes(holes, holes->reach);
}

int holes_find(const struct vec3 *point, size_t n, double gap, double rim, struct holes *holes,
               struct error *error)
{
    struct plan_extent f = plan_extent_of(point, n, 0);
    if (holes_begin(&f, gap, rim, holes, error) < 0)
        return -1;
    holes_add(holes, point, n);
    holes_end(holes);
    return 0;
}

void holes_free(struct holes *holes)
{
    free(holes->near);
    free(holes->taken);
    holes->near = holes->taken = NULL;
}

static double distance2(struct vec3 a, struct vec3 b)
{
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/* Has a box of places no unmarked cell?  One wider than a word is not looked at. */
static bool all_marked(const struct holes *h, double x0, double x1, double y0, double y1)
{
    double a_cell = 1 / h->cell;
    size_t left = cells_from(h->x, x0, a_cell), right = cells_from(h->x, x1, a_cell);
    size_t low = cells_from(h->y, y0, a_cell), high = cells_from(h->y, y1, a_cell);
    size_t word = left / WORD, shift = left % WORD, wide = right - left + 1;
    if (wide >= WORD)
        return false;
    uint64_t mask = ((uint64_t)1 << wide) - 1, lower = mask << shift;
    uint64_t upper = shift > 0 ? mask >> (WORD - shift) : 0;
    for (size_t row = low; row <= high; row++) {
        const uint64_t *near = h->near + row * h->words + word;
        if ((near[0] & lower) != lower || (upper && (near[1] & upper) != upper))
            return false;
    }
    return true;
}

static double least_of(double a, double b, double c)
{
    double d = a < b ? a : b;
    return d < c ? d : c;
}

bool holes_bridged(const struct holes *holes, struct vec3 a, struct vec3 b, struct vec3 c)
{
    double longest2 = fmax(distance2(a, b), fmax(distance2(b, c), distance2(c, a)));
    if (longest2 <= 3 * holes->rim * holes->rim) /* no place in it is so far from a corner */
        return false;
    double a_cell = 1 / holes->cell, digits = 1e-6 * holes->cell; /* more than places round by */
    if (all_marked(holes, least_of(a.x, b.x, c.x) - digits, -least_of(-a.x, -b.x, -c.x) + digits,
                   least_of(a.y, b.y, c.y) - digits, -least_of(-a.y, -b.y, -c.y) + digits))
        return false;
    int steps = (int)ceil(sqrt(longest2) * a_cell);
    for (int i = 0; i <= steps; i++)
        for (int j = 0; i + j <= steps; j++) {
            double s = (double)i / steps, t = (double)j / steps;
            double x = a.x + s * (b.x - a.x) + t * (c.x - a.x);
            double y = a.y + s * (b.y - a.y) + t * (c.y - a.y);
            size_t column = cells_from(holes->x, x, a_cell), row = cells_from(holes->y, y, a_cell);
            if (!(holes->near[row * holes->words + column / WORD] >> column % WORD & 1))
                return true;
        }
    return false;
}
