/* cloudmesh_base - see cloudmesh_base.h. */
#include "cloudmesh_base.h"

#include <stdlib.h>
#include <string.h>

#include "base/cli.h"
#include "base/effort.h"
#include "feature/feature.h"
#include "cloud/holes.h"
#include "mesh/mesh_distance.h"
#include "base/num.h"
#include "meshing/reposition.h"

double cloudmesh_three_spacings(double mean)
{
    double step = pow(10, floor(log10(3 * mean)) - 2);
    double digits = step >= 1 ? 0 : fmin(-floor(log10(step)), 9);
    return num_round(round(3 * mean / step) * step, (int)digits);
}

double cloudmesh_spacing(const struct cloudmesh_options *wish, const struct vec3 *point, size_t n)
{
    struct plan_extent f = plan_extent_of(point, n, wish->direction);
    return plan_extent_spacing(&f, point, n);
}

/* A point for each node; one on a wall only where there is no other. */
static size_t *choose(const struct cloudmesh_options *wish, const struct cloud_parts *parts,
                      const struct grid *grid, const struct vec3s *points)
{
    enum reach reach = wish->paper ? REACH_CIRCLE : REACH_NEAREST;
    size_t walls = points->n - parts->flat, nodes = grid_nodes(grid);
    size_t *chosen = reposition(grid, points->item, parts->flat, reach);
    if (walls == 0)
        return chosen;
    size_t *on_wall = reposition(grid, points->item + parts->flat, walls, reach);
    for (size_t i = 0; i < nodes; i++)
        if (chosen[i] == NO_POINT && on_wall[i] != NO_POINT)
            chosen[i] = parts->flat + on_wall[i];
    free(on_wall);
    return chosen;
}

int cloudmesh_by_grid(const struct cloudmesh_options *wish, const struct cloud_parts *parts,
                      const struct vec3s *points, struct mesh *mesh, struct cloudmesh *made,
                      struct error *error)
{
    const struct vec3 *point = points->item;
    struct holes holes = {0};
    struct plan_extent f = plan_extent_of(point, points->n, wish->direction);
    bool whole = wish->paper && wish->max_gap == 0;
    double t = wish->spacing;
    double gap = wish->max_gap > 0 ? wish->max_gap : 6 * parts->mean;
    double rim = fmax(t / 2, 1.5 * parts->mean);
    if (grid_make(&f, points->n, t, &made->grid, error) < 0 ||
        (!whole &&
         holes_find(point, points->n, gap, wish->paper ? gap / 2 : rim, &holes, error) < 0))
        return -1;
    size_t *chosen = choose(wish, parts, &made->grid, points);
    made->count = grid_mesh_make(&made->grid, chosen, point, whole ? NULL : &holes, mesh);
    free(chosen);
    holes_free(&holes);
    if (mesh->face.n == 0 && !wish->subdivide)
        return error_set(error,
                         "no three neighbouring nodes of a grid of spacing %g mm have points on an "
                         "area of %g x %g mm, expected another spacing (-t) or a wider area",
                         t, f.xmax - f.xmin, f.ymax - f.ymin);
    mesh->origin.spacing = t;
    mesh->origin.direction = wish->direction;
    return 0;
}

int cloudmesh_normals(const struct cloudmesh_options *wish, struct vec3 *point, size_t n,
                      double noise, int threads, struct mesh *mesh, struct error *error)
{
    struct normals_options options = {.point = point,
                                      .n = n,
                                      .spacing = cloudmesh_spacing(wish, point, n),
                                      .noise = noise,
                                      .neighbours = wish->neighbours,
                                      .effort = wish->effort,
                                      .threads = threads,
                                      .silent = wish->silent};

    return wish->normals->estimate(mesh, &options, error);
}

static struct feature_scan scan_of(const struct cloud_parts *parts, const struct vec3s *points,
                                   double noise)
{
    return (struct feature_scan){points->item, points->n, parts->flat, parts->mean, noise};
}

static void keep_features(const struct cloudmesh_options *wish, const struct feature_scan *scan,
                          int threads, struct mesh *mesh, struct cloudmesh *made)
{
    struct feature_mesh found = feature_mesh_keep(mesh, scan, wish->effort, threads);

    made->creases = found.creases;
    made->walls = found.walls;
    array_free(&made->edge);
    made->edge = found.place;
    if (!wish->silent)
        effort_say(EFFORT_CREASES, wish->effort, found.doubtful);
}

static void keep_crests(const struct cloudmesh_options *wish, const struct feature_scan *scan,
                        size_t first, int threads, struct mesh *mesh, struct cloudmesh *made)
{
    struct crest_mesh_options options = {scan->spacing, scan->noise, wish->effort, threads};
    struct crests crests = crest_mesh_keep(mesh, first, scan->point, scan->flat, &options);

    made->crests = crests.found;
    if (wish->silent)
        return;
    effort_say(EFFORT_CREST_EDGES, wish->effort, crests.edges);
    effort_say(crests.bound, wish->effort, crests.wanted);
}

void cloudmesh_edges(const struct cloudmesh_options *wish, const struct cloud_parts *parts,
                     const struct vec3s *points, double noise, int threads, struct mesh *mesh,
                     struct cloudmesh *made)
{
    struct feature_scan scan = scan_of(parts, points, fmax(noise, mesh->origin.noise));
    size_t first = mesh->vertex.n;

    if (!wish->smooth) {
        keep_features(wish, &scan, threads, mesh, made);
        keep_crests(wish, &scan, first, threads, mesh, made);
    }
    if (!wish->paper)
        mesh_normals_seen(mesh);
}

bool cloudmesh_has_walls(const struct cloudmesh_options *wish, const struct cloud_parts *parts,
                         const struct vec3s *points, double noise, int threads)
{
    struct cloudmesh_options grid = *wish;
    struct mesh mesh = {.origin.ledger = NAN};
    struct cloudmesh made;
    struct error error;
    struct feature_scan scan = scan_of(parts, points, noise);
    struct feature_walls walls = {.found = 0};

    if (!(grid.spacing > 0))
        grid.spacing = cloudmesh_three_spacings(parts->mean);
    if (cloudmesh_by_grid(&grid, parts, points, &mesh, &made, &error) == 0)
        walls = feature_mesh_walls(&mesh, &scan, wish->effort, threads);
    if (!wish->silent)
        effort_say(EFFORT_WALLS, wish->effort, walls.edges);
    mesh_free(&mesh);
    return walls.found > 0;
}

/* The sum of the squared distances of the points from the mesh, of every so many of them. */
static double off_points(const struct mesh *mesh, const struct vec3s *points, size_t most,
                         int threads)
{
    struct vec3s some = {0};
    double sum = 0;
    size_t step = most > 0 && points->n > most ? (points->n - 1) / most + 1 : 1;
    for (size_t i = 0; i < points->n; i += step)
        *array_push(&some) = points->item[i];
    double *distance = mem_alloc(some.n, sizeof *distance);
    mesh_distance(mesh, some.item, some.n, threads, distance);
    for (size_t i = 0; i < some.n; i++)
        sum += distance[i] * distance[i];
    free(distance);
    array_free(&some);
    return sum;
}

void cloudmesh_swap(struct mesh *other, struct cloudmesh *other_made, struct mesh *mesh,
                    struct cloudmesh *made)
{
    struct mesh swap = *mesh;
    struct cloudmesh swap_made = *made;
    *mesh = *other;
    *made = *other_made;
    *other = swap;
    *other_made = swap_made;
}

void cloudmesh_closer(const struct cloudmesh_options *wish, const struct vec3s *points, int threads,
                      struct mesh *other, struct cloudmesh *other_made, struct mesh *mesh,
                      struct cloudmesh *made)
{
    size_t most = effort_most(EFFORT_COMPARISON, wish->effort);

    if (!wish->silent)
        effort_say(EFFORT_COMPARISON, wish->effort, points->n);
    if (off_points(other, points, most, threads) < off_points(mesh, points, most, threads))
        cloudmesh_swap(other, other_made, mesh, made);
}

void cloudmesh_drop(struct mesh *mesh, struct cloudmesh *made)
{
    mesh_free(mesh);
    array_free(&made->edge);
}
