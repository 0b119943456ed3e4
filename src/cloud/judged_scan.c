/* judged_scan - see judged_scan.h. */
#include "cloud/judged_scan.h"

#include <stdlib.h>

#include "base/parallel.h"
#include "cloud/outliers.h"
#include "cloud/rim_points.h"
#include "cloud/roof.h"
#include "cloud/scan_edges.h"
#include "cloud/settle.h"
#include "cloud/steep_facets.h"

struct settling {
    const struct point_grid *grid;
    double sigma;
    struct vec3 *to;
};

static void settle_points(void *context, size_t from, size_t to)
{
    const struct settling *s = context;

    for (size_t i = from; i < to; i++)
        s->to[i] = settle_point(s->grid, s->sigma, s->grid->point[i]);
}

static void settle_all(struct point_grid *grid, double sigma, int threads)
{
    struct settling s = {grid, sigma, mem_alloc(grid->n, sizeof *s.to)};

    parallel_for(threads, grid->n, settle_points, &s);
    for (size_t i = 0; i < grid->n; i++)
        grid->point[i] = s.to[i];
    free(s.to);
}

void judged_scan_settle(struct point_grid *scan, double radius, double noise, int threads,
                        unsigned char *under, struct vec3s *curtain)
{
    outliers_under_roof(scan, threads, under);
    roof_curtain_asked(scan, threads, curtain);
    if (noise > 0)
        settle_all(scan, noise, threads);
    rim_points_asked(scan, radius, noise, threads, curtain);
    steep_facets_asked(scan, radius, noise, threads, curtain);
}

/* mm: how deep a ball may sink in between places on edges, as of a path of the usual tolerance. */
static const double SINK = 0.002;

void judged_scan_unseen(const struct point_grid *scan, double radius, double noise, int threads,
                        struct vec3s *place)
{
    const struct scan_edges_options options = {.scan = scan,
                                               .radius = radius,
                                               .sink = SINK,
                                               .noise = noise,
                                               .fill = true,
                                               .threads = threads};
    struct scan_edges found = scan_edges_find(&options);

    vec3s_add(place, found.point.item, found.point.n);
    array_free(&found.point);
}
