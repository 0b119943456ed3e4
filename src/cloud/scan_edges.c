/* scan_edges - see scan_edges.h. */
#include "cloud/scan_edges.h"

#include <stdlib.h>

#include "cloud/noise.h"
#include "rounding.h"

/* mm: a flank is certain whose points are no farther off it on average, and no wall hangs from one
 * that is not, however much may be cut off: a larger tolerance would find more walls. */
static const double SURE = 0.002;

/* Spacings: by so little noise, as of coordinates rounded, edges are looked for as without it, too;
 * noises that the points of a certain flank are off it then, on average. */
static const double FAINT = 0.01, UNEVEN = 1.7;

/* Spacings: smooth surfaces leave more where shapes are as small as points are apart. */
static const double ROUGH = 0.06;

/* What edges would not be resolved if a little of what is left by smooth surfaces were noise: where
 * no surface is certain as the points are, as of a knurl of five points a side with noise, no edge
 * is seen at all.  Rough ground has few such points either way. */
static void suspect_edges(struct edge_points_options edges, struct edge_gaps *gaps)
{
    const double little = 0.02, certain = 0.1, many = 0.005; /* spacings; of the points */
    double n = (double)edges.point_grid->n;
    struct edge_gaps suspected;
    struct vec3s none = {0};

    if ((double)gaps->certain > certain * n)
        return;
    edges.noise = little * point_grid_spacing(edges.point_grid);
    edges.fill = false;
    edge_points(&edges, &none, &suspected);
    array_free(&none);
    if ((double)suspected.unknown > many * n)
        *gaps = suspected;
}

/* Of the points where they are, or spread. */
static struct scan_edges find_edges(const struct scan_edges_options *o,
                                    const struct point_grid *scan)
{
    bool faint = o->noise > 0 && o->noise < FAINT * point_grid_spacing(scan);
    bool twice = o->edged || faint;
    double sink = fmin(o->sink, SURE);
    struct edge_points_options edges = {.point_grid = scan,
                                        .noise = twice ? 0 : o->noise,
                                        .along = sqrt(8 * o->radius * o->sink),
                                        .sink = faint ? fmax(sink, UNEVEN * o->noise) : sink,
                                        /* flanks of few points are as rough as these */
                                        .fill = o->fill,
                                        .threads = o->threads,
                                        .near = scan == o->scan ? o->near : NULL};
    struct scan_edges found = {.edges = 0};

    found.edges = edge_points(&edges, &found.point, &found.gaps);
    if (twice) {
        struct edge_gaps walls;
        edges.noise = o->noise;
        edges.sink = sink;
        edges.met = o->edged;
        found.edges += edge_points(&edges, &found.point, &walls);
        if (walls.n > found.gaps.n)
            found.gaps = walls;
    }
    if (o->rough > ROUGH * point_grid_spacing(scan))
        suspect_edges(edges, &found.gaps);
    return found;
}

static size_t unresolved(const struct scan_edges *found)
{
    return found->gaps.n + found->gaps.unknown;
}

/* The same where heights that were rounded stay as they are, and found in them spread, too: what is
 * there is in both, and what rounding makes of a slope or of a flat in one of them, so that the one
 * that resolves more is right. */
static struct scan_edges find_rounded(const struct scan_edges_options *o, double step)
{
    struct scan_edges found = find_edges(o, o->scan);
    struct point_grid spread = *o->scan;

    if (unresolved(&found) == 0)
        return found;
    spread.point = mem_alloc(spread.n, sizeof *spread.point);
    rounding_spread(step, o->scan->point, spread.n, spread.point);
    struct scan_edges other = find_edges(o, &spread);
    free(spread.point);
    bool better = unresolved(&other) < unresolved(&found);
    array_free(better ? &found.point : &other.point);
    return better ? other : found;
}

struct scan_edges scan_edges_find(const struct scan_edges_options *o)
{
    const struct point_grid *scan = o->scan;
    double step = rounding_step(scan->point, scan->n, point_grid_spacing(scan));
    bool rounded = step > 0 && rounding_left(step, noise_sigma(scan, o->threads));

    return rounded ? find_rounded(o, step) : find_edges(o, scan);
}
