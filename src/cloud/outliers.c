/* outliers - see outliers.h. */
#include "cloud/outliers.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/parallel.h"
#include "cloud/noise.h"
#include "math/quadric.h"
#include "outliers_kept.h"

/* Points that a cell's quadric is fitted to; how often it is fitted again; so many off their own
 * surface are of several. */
enum { NEAR = OUTLIERS_NEAR, CLUMP = OUTLIERS_CLUMP, MOST_BLOCK = 512, REFITS = 3, FEW = 4 };

/* Cells go two by two; the fewest points of such a block that tell of its surface. */
enum { TWO = 2, FEWEST_BLOCK = 20 };

static const double TUKEY = 4.685; /* in standard deviations */

struct search {
    const struct point_grid *point_grid;
    double sigma, spacing;
    unsigned char *out;
    bool *under;   /* the surface of its neighbours, point by point */
    bool floating; /* only what is apart from the rest */
    double *top;   /* of each cell, once it is asked for */
};

size_t outliers_twice(const struct point_grid *b, unsigned char *out)
{
    size_t found = 0;
    for (size_t i = 1; i < b->n; i++) {
        const struct vec3 *p = &b->point[i];
        if (p->x == p[-1].x && p->y == p[-1].y && p->z == p[-1].z) {
            out[i] = 1;
            found++;
        }
    }
    return found;
}

/* Distances of n points from the quadric into off[]; returns their spread, from the median. */
static double spread_about(const struct quadric *q, const struct vec3 *point, size_t n, double *off)
{
    double sorted[MOST_BLOCK];
    for (size_t i = 0; i < n; i++)
        off[i] = sorted[i] = fabs(quadric_off(q, point[i]));
    return noise_of_distances(sorted, n);
}

/* Refits without what stands out; `q` is a first fit.  Returns the spread of the points. */
static double refit_robustly(const struct vec3 *point, size_t n, double sigma, struct quadric *q,
                             double *off)
{
    double weight[MOST_BLOCK], spread = spread_about(q, point, n, off);
    for (int i = 0; i < REFITS; i++) {
        double far = TUKEY * fmax(spread, sigma);
        struct quadric next;
        for (size_t k = 0; k < n; k++) {
            double r = off[k] / far;
            weight[k] = r < 1 ? (1 - r * r) * (1 - r * r) : 0;
        }
        if (!(far > 0) ||
            quadric_fit_weighted(point, weight, n, q->origin, quadric_normal(q), &next) < 0)
            break;
        *q = next;
        spread = spread_about(q, point, n, off);
    }
    return spread;
}

/* Distance to the eighth nearest neighbour of a point of the cloud. */
static double clump_radius(const struct point_grid *b, struct vec3 p)
{
    uint32_t index[CLUMP + 1];
    double distance2[CLUMP + 1];
    size_t n = point_grid_nearest(b, p, CLUMP + 1, index, distance2);
    return sqrt(distance2[n - 1]);
}

/* Beside a dense surface a sparse one is no clump: more of the neighbours than make one are as far
 * from theirs. */
static bool is_sparse_surface(const struct point_grid *b, const uint32_t *near, double reach)
{
    int wider = 0;
    for (int i = 0; wider <= CLUMP && i < NEAR; i++)
        wider += clump_radius(b, b->point[near[i]]) >= reach;
    return wider > CLUMP;
}

/* On a surface the last of the neighbours is 1.7 times as far as number CLUMP; from a place apart
 * both are about equally far. */
static bool is_isolated(const struct search *s, const struct outliers_hood *hood)
{
    const double much = OUTLIERS_ISOLATED, apart = 1.5, far = OUTLIERS_FAR;
    const struct point_grid *b = s->point_grid;
    double reach = sqrt(hood->distance2[CLUMP]);
    if (reach > far * s->spacing)
        return true;
    if (hood->distance2[NEAR] > apart * apart * hood->distance2[CLUMP])
        return false;
    /* By the middle one of their reaches. */
    int wider = 0, closer = 0;
    for (int i = 0; wider < CLUMP / 2 && closer <= CLUMP / 2; i++) {
        bool far_less = reach > much * clump_radius(b, b->point[hood->index[CLUMP + i]]);
        closer += far_less;
        wider += !far_less;
    }
    return closer > CLUMP / 2 && !is_sparse_surface(b, hood->index, reach / much);
}

/* How many of the neighbours are off their own surface by more than that: where several are, there
 * are several surfaces, as at the root of a blade, and nothing is told by one more point off. */
static size_t stand_out(const double *off, double least)
{
    size_t n = 0;

    for (size_t k = 0; k < NEAR; k++)
        n += off[k] > least;
    return n;
}

/* The origin is on the side of the surface that the tool comes from; of an upright one on any. */
static bool is_over(struct quadric *q)
{
    const double upright = 0.2; /* the normal's rise: 11 degrees */

    quadric_face_up(q);
    return q->c[0] < 0 || quadric_normal(q).z < upright;
}

/* Beside it another neighbour stands over the surface, too, by more than `least` and no less than a
 * part of its height: it is the top of a spike or a cone. */
static bool is_top(const struct quadric *q, const struct vec3 *point, double spacing, double least)
{
    const double beside = OUTLIERS_BESIDE * spacing, part = 0.25, side = q->c[0] < 0 ? 1 : -1;

    least = fmax(least, part * quadric_distance(q));
    for (size_t k = 0; k < NEAR; k++) {
        struct vec3 p = quadric_local(q, point[k]);
        if (hypot(p.x, p.y) < beside && side * quadric_off(q, point[k]) > least)
            return true;
    }
    return false;
}

static bool is_outlier(const struct search *s, size_t i)
{
    const double spreads = OUTLIERS_SPREADS;
    const struct vec3 p = s->point_grid->point[i];
    struct outliers_hood hood;
    struct quadric q;
    double off[NEAR];

    if (!outliers_hood_find(s->point_grid, i, &hood))
        return false;
    if (is_isolated(s, &hood))
        return true;
    if (s->floating)
        return false;
    double least = outliers_least(&hood, s->sigma);
    struct vec3 across = plane_normal(hood.point, NEAR);
    if (quadric_fit(hood.point, NEAR, p, across, &q) < 0 ||
        quadric_distance(&q) < least / 3 || /* for most: more turns would change nothing */
        quadric_settle(hood.point, NEAR, p, across, &q) < 0 || quadric_distance(&q) < least)
        return false;
    double spread = refit_robustly(hood.point, NEAR, s->sigma, &q, off);
    if (stand_out(off, fmax(least, spreads * spread)) >= FEW)
        return false;
    s->under[i] = !is_over(&q);
    if (!s->under[i]) {
        if (is_top(&q, hood.point, hood.spacing, fmax(least, spreads / 2 * spread)))
            return false;
        least = fmax(least, OUTLIERS_OVER * hood.spacing);
    }
    return quadric_distance(&q) > fmax(least, spreads * spread) * sqrt(1 + q.variance);
}

/* The points of a cell and every third of the eight around it, its own first; of very many only
 * some.  Returns how many; *own: how many of the cell. */
static size_t gather_block(const struct point_grid *b, size_t row, size_t column,
                           struct vec3 *point, size_t *own)
{
    size_t n = 0;
    for (int k = 0; k < 9; k++) {
        static const int side[9][2] = {{0, 0}, {-1, -1}, {0, -1}, {1, -1}, {-1, 0},
                                       {1, 0}, {-1, 1},  {0, 1},  {1, 1}};
        size_t c = column + (size_t)side[k][0], r = row + (size_t)side[k][1];
        if (c >= b->columns || r >= b->rows)
            continue;
        const uint32_t *first = &b->first[r * b->columns + c];
        size_t step = (first[1] - first[0]) / (MOST_BLOCK / 9) + (k == 0 ? 1 : 3);
        for (size_t i = first[0]; i < first[1]; i += step)
            point[n++] = b->point[i];
        if (k == 0)
            *own = n;
    }
    return n;
}

/* Are the points of a cell on one smooth surface with those around, but for a few?  Then `q` is
 * that. */
static bool fit_block(const struct search *s, size_t row, size_t column, double least,
                      struct quadric *q)
{
    struct vec3 point[MOST_BLOCK];
    double off[MOST_BLOCK], most = 0;
    size_t own = 0, n = gather_block(s->point_grid, row, column, point, &own);
    if (quadric_fit(point, n, point[0], vec(0, 0, 1), q) < 0)
        return false;
    for (size_t i = 0; i < own; i++)
        most = fmax(most, fabs(quadric_off(q, point[i])));
    return most <= least || refit_robustly(point, n, s->sigma, q, off) <= least;
}

/* Another point of the cell is no farther from point i than the cell is wide.  The surface of a few
 * points may be so bent that it takes in one high above them. */
static bool has_neighbour_in_cell(const struct point_grid *b, size_t cell, size_t i)
{
    for (size_t k = b->first[cell]; k < b->first[cell + 1]; k++) {
        struct vec3 d = vec_sub(b->point[k], b->point[i]);
        if (k != i && vec_dot(d, d) <= b->cell * b->cell)
            return true;
    }
    return false;
}

/* How far a point may be off a surface without being looked at. */
static double unsuspected(const struct search *s)
{
    const double sigmas = 5, spacings = 0.08;
    return fmax(sigmas * s->sigma, spacings * s->spacing);
}

/* The points of a cell that are to be looked at. */
static void mark_cell(const struct search *s, size_t cell)
{
    const struct point_grid *b = s->point_grid;
    const double least = unsuspected(s);
    struct quadric q;
    if (b->first[cell] == b->first[cell + 1])
        return;
    bool smooth = fit_block(s, cell / b->columns, cell % b->columns, least, &q);
    for (size_t i = b->first[cell]; i < b->first[cell + 1]; i++)
        if (!smooth || fabs(quadric_off(&q, b->point[i])) > least ||
            !has_neighbour_in_cell(b, cell, i))
            s->out[i] |= is_outlier(s, i);
}

/* Two by two cells. */
struct block {
    size_t row, column, cell[TWO * TWO], n;
};

static size_t blocks_across(size_t cells)
{
    return (cells + TWO - 1) / TWO;
}

static struct block block_of(const struct point_grid *b, size_t index)
{
    size_t across = blocks_across(b->columns);
    struct block k = {.row = TWO * (index / across), .column = TWO * (index % across)};
    for (size_t r = k.row; r < k.row + TWO && r < b->rows; r++)
        for (size_t c = k.column; c < k.column + TWO && c < b->columns; c++)
            k.cell[k.n++] = r * b->columns + c;
    return k;
}

/* One quadric takes in all points of a block, and so many that it tells something. */
static bool is_smooth_block(const struct search *s, const struct block *k)
{
    const struct point_grid *b = s->point_grid;
    const double least = unsuspected(s);
    struct vec3 point[MOST_BLOCK];
    struct quadric q;
    size_t n = 0;
    for (size_t c = 0; c < k->n; c++)
        for (size_t i = b->first[k->cell[c]]; i < b->first[k->cell[c] + 1]; i++) {
            if (n == MOST_BLOCK)
                return false;
            point[n++] = b->point[i];
        }
    if (n < FEWEST_BLOCK || quadric_fit(point, n, point[0], vec(0, 0, 1), &q) < 0)
        return false;
    double off[MOST_BLOCK];
    quadric_off_all(&q, point, n, off);
    for (size_t i = 0; i < n; i++)
        if (fabs(off[i]) > least)
            return false;
    return true;
}

static void mark_isolated(void *context, size_t from, size_t to)
{
    const struct search *s = context;
    const struct point_grid *b = s->point_grid;
    for (size_t index = from; index < to; index++) {
        struct block k = block_of(b, index);
        bool smooth = is_smooth_block(s, &k);
        for (size_t c = 0; c < k.n; c++) {
            size_t cell = k.cell[c];
            if (!smooth)
                mark_cell(s, cell);
            for (size_t i = b->first[cell]; smooth && i < b->first[cell + 1]; i++)
                if (!has_neighbour_in_cell(b, cell, i))
                    s->out[i] |= is_outlier(s, i);
        }
    }
}

static size_t count_marked(const unsigned char *out, size_t n)
{
    size_t found = 0;
    for (size_t i = 0; i < n; i++)
        found += out[i] != 0;
    return found;
}

static size_t mark_and_keep(const struct point_grid *b, double sigma, int threads, bool floating,
                            unsigned char *out)
{
    unsigned char *own = mem_alloc(b->n + 1, 1);
    bool *under = mem_alloc(b->n + 1, sizeof *under);
    size_t found = 0;

    memset(own, 0, b->n);
    memset(under, 0, b->n * sizeof *under);
    struct search s = {b, sigma, point_grid_spacing(b), own, under, floating, NULL};
    parallel_for(threads, blocks_across(b->columns) * blocks_across(b->rows), mark_isolated, &s);
    outliers_keep(b, sigma, own);
    for (size_t i = 0; i < b->n; i++) {
        if (!own[i] || out[i])
            continue;
        found++;
        out[i] = under[i] || outliers_is_beneath(b, own, i) ? OUTLIERS_BENEATH : OUTLIERS_OUT;
    }
    free(under);
    free(own);
    return found;
}

size_t outliers_isolated(const struct point_grid *b, double sigma, int threads, unsigned char *out)
{
    return mark_and_keep(b, sigma, threads, false, out);
}

size_t outliers_floating(const struct point_grid *b, double sigma, int threads, unsigned char *out)
{
    return mark_and_keep(b, sigma, threads, true, out);
}

/* The last of the points up to `end` that are in one place seen from above, as sorted by x, y, z:
 * the highest.  There may be very many. */
static size_t top_of_place(const struct point_grid *b, size_t i, size_t end)
{
    struct vec3 at = b->point[i];
    size_t step = 1;

    for (; step > 0 && i + 1 < end; step = step / 2) {
        while (i + step < end && !(b->point[i + step].x > at.x) && !(b->point[i + step].y > at.y)) {
            i += step;
            step *= 2;
        }
    }
    return i;
}

/* Marks the eighths of the turn in which a point of the cell stands steeply above p.  All eight, so
 * that the bottom of a wall or in a corner of a pocket is not under anything. */
static unsigned eighths_above(const struct point_grid *b, size_t cell, struct vec3 p,
                              double nearest)
{
    const double steep = OUTLIERS_ROOF;
    unsigned above = 0;
    for (size_t i = b->first[cell], end = b->first[cell + 1]; i < end; i++) {
        i = top_of_place(b, i, end);
        struct vec3 d = vec_sub(b->point[i], p);
        double away2 = d.x * d.x + d.y * d.y;
        if (d.z > 0 && away2 > nearest * nearest && d.z * d.z > steep * steep * away2)
            above |= 1u << ((d.x > 0) + 2 * (d.y > 0) + 4 * (fabs(d.x) > fabs(d.y)));
    }
    return above;
}

static void find_tops(void *context, size_t from, size_t to)
{
    const struct search *s = context;
    const struct point_grid *b = s->point_grid;
    for (size_t cell = from; cell < to; cell++) {
        double top = -INFINITY;
        for (size_t i = b->first[cell]; i < b->first[cell + 1]; i++)
            top = fmax(top, b->point[i].z);
        s->top[cell] = top;
    }
}

static void mark_under_roof(void *context, size_t from, size_t to)
{
    const struct search *s = context;
    const struct point_grid *b = s->point_grid;
    for (size_t cell = from; cell < to; cell++) {
        size_t row = cell / b->columns, column = cell % b->columns;
        double top = -INFINITY;
        size_t r0 = row > 0 ? row - 1 : 0, r1 = row + 1 < b->rows ? row + 1 : row;
        size_t c0 = column > 0 ? column - 1 : 0, c1 = column + 1 < b->columns ? column + 1 : column;
        for (size_t r = r0; r <= r1; r++)
            for (size_t c = c0; c <= c1; c++)
                top = fmax(top, s->top[r * b->columns + c]);
        for (size_t i = b->first[cell]; i < b->first[cell + 1]; i++) {
            unsigned above = 0;
            if (top - b->point[i].z < b->cell)
                continue;
            for (size_t r = r0; r <= r1; r++)
                for (size_t c = c0; c <= c1; c++)
                    above |= eighths_above(b, r * b->columns + c, b->point[i], s->spacing / 2);
            if (above == 0xFF && !s->out[i])
                s->out[i] = OUTLIERS_OUT;
        }
    }
}

size_t outliers_under_roof(const struct point_grid *b, int threads, unsigned char *out)
{
    size_t before = count_marked(out, b->n);
    struct search s = {.point_grid = b,
                       .spacing = point_grid_spacing(b),
                       .out = out,
                       .top = mem_alloc(b->columns * b->rows, sizeof *s.top)};
    parallel_for(threads, b->columns * b->rows, find_tops, &s);
    parallel_for(threads, b->columns * b->rows, mark_under_roof, &s);
    free(s.top);
    return count_marked(out, b->n) - before;
}
