/* stream_bands - see stream_bands.h. */
#include "stream_bands.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "io/cloud/cloud_spool.h"

enum {
    FEW = 2,         /* bands, for which one look each costs no more */
    AT_ONCE = 32,    /* spools that are filled in one look: each is an open file */
    HAND_ON = 1 << 9 /* points of a band that wait for the next ones */
};

int stream_row(const struct grid *g, const struct vec3 *p)
{
    double y = g->plan_extent.cosine * p->y - g->plan_extent.sine * p->x;
    double v = (y - g->y) / (g->t * GRID_SLANT);

    return v > 0 ? (v < g->rows - 1 ? (int)v : g->rows - 1) : 0;
}

/* The rows from `first` on. */
static struct stream_band band_from(int first, int rows, const size_t *of_row, int about,
                                    size_t at_a_time)
{
    int end = rows - 1;
    struct stream_band b = {.first = first, .last = first};

    b.low = first > about ? first - about : 0;
    b.high = first + about < end ? first + about : end;
    for (int row = b.low; row <= b.high; row++)
        b.n += of_row[row];
    while (b.last < end) {
        size_t more = b.high < end ? of_row[b.high + 1] : 0;
        if (b.n + more > at_a_time)
            break;
        b.n += more;
        b.last++;
        b.high += b.high < end;
    }
    return b;
}

struct stream_bands stream_bands_of(const struct grid *grid, const size_t *of_row, int about,
                                    size_t at_a_time)
{
    struct stream_bands bands = {0};

    for (int row = 0; row < grid->rows; row = bands.item[bands.n - 1].last + 1)
        *array_push(&bands) = band_from(row, grid->rows, of_row, about, at_a_time);
    return bands;
}

static void forget(struct stream_band *b)
{
    cloud_spool_free(b->spool);
    b->spool = NULL;
}

void stream_bands_free(struct stream_bands *bands)
{
    for (size_t i = 0; i < bands->n; i++)
        forget(&bands->item[i]);
    array_free(bands);
}

/* ---- all points told apart */

/* Some bands, and points that wait for their spools. */
struct parting {
    const struct grid *grid;
    struct stream_band *band;
    size_t n;
    struct vec3s wait[AT_ONCE];
    uint8_t *first; /* of the bands that a row's points belong to; `n`: none */
};

static void part_block(void *context, const struct vec3 *point, size_t n)
{
    struct parting *p = context;

    for (size_t i = 0; i < n; i++) {
        int row = stream_row(p->grid, &point[i]);
        for (size_t k = p->first[row]; k < p->n && p->band[k].low <= row; k++) {
            *array_push_inline(&p->wait[k]) = point[i];
            if (p->wait[k].n < HAND_ON)
                continue;
            cloud_spool_add(p->band[k].spool, p->wait[k].item, p->wait[k].n);
            p->wait[k].n = 0;
        }
    }
}

static struct parting parting_of(struct stream_bands *bands, size_t from, const struct grid *grid)
{
    struct parting p = {grid, bands->item + from, bands->n - from, {{0}}, NULL};

    if (p.n > AT_ONCE)
        p.n = AT_ONCE;
    p.first = mem_alloc((size_t)grid->rows, sizeof *p.first);
    for (int row = 0, k = 0; row < grid->rows; row++) {
        while (k < (int)p.n && p.band[k].high < row)
            k++;
        p.first[row] = (uint8_t)k;
    }
    return p;
}

/* A spool for each; false where one of them cannot be had. */
static bool open_spools(struct parting *p)
{
    bool good = true;

    for (size_t k = 0; k < p->n && good; k++)
        good = (p->band[k].spool = cloud_spool_new()) != NULL;
    for (size_t k = 0; k < p->n && !good; k++)
        forget(&p->band[k]);
    return good;
}

/* What waits goes into the spools; false where one of them has no room. */
static bool close_spools(struct parting *p)
{
    bool good = true;

    for (size_t k = 0; k < p->n; k++) {
        cloud_spool_add(p->band[k].spool, p->wait[k].item, p->wait[k].n);
        cloud_spool_end(p->band[k].spool);
        good = good && cloud_spool_holds(p->band[k].spool);
        array_free(&p->wait[k]);
    }
    return good;
}

/* The points of the next bands, from `from` on, in spools, if there is room for them.  Those of the
 * last ones take the place of the cloud's own. */
static int set_aside(struct stream_bands *bands, size_t from, struct cloud_stream *stream,
                     struct error *error)
{
    struct parting p = parting_of(bands, from, &stream->nodes.grid);
    int status = 0;

    if (open_spools(&p)) {
        status = cloud_stream_look(stream, part_block, &p, error);
        if (close_spools(&p) && status == 0 && from + p.n == bands->n) {
            cloud_spool_free(stream->spool);
            stream->spool = NULL;
        }
    }
    free(p.first);
    return status;
}

/* ---- one band */

struct wanted {
    const struct grid *grid;
    const struct stream_band *band;
    struct vec3s *points;
};

static void take_block(void *context, const struct vec3 *point, size_t n)
{
    struct wanted *w = context;

    for (size_t i = 0; i < n; i++) {
        int row = stream_row(w->grid, &point[i]);
        if (row >= w->band->low && row <= w->band->high)
            *array_push(w->points) = point[i];
    }
}

static void take_all(void *context, const struct vec3 *point, size_t n)
{
    struct vec3s *points = context;

    array_reserve(points, points->n + n);
    memcpy(points->item + points->n, point, n * sizeof *point);
    points->n += n;
}

int stream_bands_points(struct stream_bands *bands, size_t k, struct cloud_stream *stream,
                        struct vec3s *points, struct error *error)
{
    struct stream_band *b = &bands->item[k];
    struct wanted wanted = {&stream->nodes.grid, b, points};
    size_t before = points->n;

    array_reserve(points, b->n);
    if (bands->n > FEW && k % AT_ONCE == 0 && set_aside(bands, k, stream, error) < 0)
        return -1;
    bool found = cloud_spool_holds(b->spool) && cloud_spool_look(b->spool, take_all, points);
    forget(b);
    if (found)
        return 0;
    points->n = before;
    return cloud_stream_look(stream, take_block, &wanted, error);
}
