/* believed - see believed.h. */
#include "cloud/believed.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "cloud/outliers.h"
#include "cloud/plan_extent.h"
#include "rounding.h"

/* Of the places looked at: where no more are of two sheets, these tell nothing of the noise. */
static const double FEW = 0.02;

static size_t count_beneath(const unsigned char *out, size_t n)
{
    size_t found = 0;

    for (size_t i = 0; i < n; i++)
        found += out[i] == OUTLIERS_BENEATH;
    return found;
}

struct believed believed_in_grid(const struct point_grid *point_grid,
                                 const struct believed_options *options, unsigned char *out)
{
    struct believed b = {.noise = noise_measure(point_grid, options->threads)};
    bool measured = options->noise < 0;
    double sigma = measured ? b.noise.sigma : options->noise;

    if (measured && !b.noise.alike && sigma >= NOISE_NONE * point_grid->cell)
        b.outliers = outliers_floating(point_grid, sigma, options->threads, out);
    else if (measured || sigma > 0)
        b.outliers = outliers_isolated(point_grid, sigma, options->threads, out);
    b.beneath = count_beneath(out, point_grid->n);
    b.sheets = sheets_find(point_grid, out, options->threads);
    bool sheets = (double)b.sheets.places > FEW * (double)b.sheets.looked;
    if (sheets)
        b.apart = b.sheets.distance / 2;
    if (!measured)
        b.sigma = options->noise;
    else if (!sheets)
        b.sigma = b.noise.alike ? b.noise.sigma : b.noise.even;
    return b;
}

void believed_keep_beneath(unsigned char *out, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (out[i] == OUTLIERS_BENEATH)
            out[i] = 0;
}

/* The points of that mark, in order. */
static struct vec3s gather_marked(const struct point_grid *point_grid, const unsigned char *out,
                                  unsigned char mark)
{
    struct vec3s found = {0};

    for (size_t i = 0; i < point_grid->n; i++)
        if (out[i] == mark)
            *array_push(&found) = point_grid->point[i];
    if (found.n > 0)
        qsort(found.item, found.n, sizeof *found.item, vec_compare);
    return found;
}

/* Marks in out[] the points, in any order, that are marked so in the grid's order. */
static void mark_alike(const struct point_grid *point_grid, const unsigned char *of_grid,
                       unsigned char mark, const struct vec3 *point, size_t n, unsigned char *out)
{
    struct vec3s marked = gather_marked(point_grid, of_grid, mark);

    for (size_t i = 0; marked.n > 0 && i < n; i++)
        if (bsearch(&point[i], marked.item, marked.n, sizeof *marked.item, vec_compare))
            out[i] = mark;
    array_free(&marked);
}

int believed_find(const struct vec3 *point, size_t n, const struct believed_options *options,
                  unsigned char *out, struct believed *believed, struct error *error)
{
    struct plan_extent f = plan_extent_of(point, n, 0);
    double spacing = plan_extent_spacing(&f, point, n);
    struct vec3 *copy = mem_alloc(n, sizeof *copy);
    struct point_grid point_grid;

    memset(out, 0, n);
    *believed = (struct believed){.sigma = 0};
    if (n > 0) /* then there may be no array */
        memcpy(copy, point, n * sizeof *copy);
    if (point_grid_make(copy, n, spacing > 0 ? spacing : 1, options->threads, &point_grid, error) <
        0) {
        free(copy);
        return -1;
    }
    outliers_twice(&point_grid, out);
    point_grid_remove(&point_grid, out);
    unsigned char *of_grid = mem_alloc(point_grid.n + 1, 1);
    memset(of_grid, 0, point_grid.n);
    memset(out, 0, n);
    *believed = believed_in_grid(&point_grid, options, of_grid);
    mark_alike(&point_grid, of_grid, OUTLIERS_OUT, point, n, out);
    mark_alike(&point_grid, of_grid, OUTLIERS_BENEATH, point, n, out);
    free(of_grid);
    point_grid_free(&point_grid);
    free(copy);
    return 0;
}

/* What believed_find finds of points in any order. */
static struct believed look_at(const struct vec3 *point, size_t n, int threads)
{
    const struct believed_options options = {.noise = -1, .threads = threads};
    unsigned char *out = mem_alloc(n, 1);
    struct believed believed;
    struct error error;

    if (believed_find(point, n, &options, out, &believed, &error) != 0)
        believed = (struct believed){.sigma = 0};
    free(out);
    return believed;
}

double believed_unround(struct vec3 *point, size_t n, double noise, int threads)
{
    struct plan_extent extent = plan_extent_of(point, n, 0);
    double step = rounding_step(point, n, plan_extent_spacing(&extent, point, n));

    if (!(step > 0) || noise == 0 || !rounding_left(step, look_at(point, n, threads).noise.sigma))
        return 0;
    struct vec3 *spread = mem_alloc(n, sizeof *spread);
    rounding_spread(step, point, n, spread);
    bool spreads = look_at(spread, n, threads).sigma > 0;
    if (spreads)
        memcpy(point, spread, n * sizeof *spread);
    free(spread);
    return spreads ? step : 0;
}
