/* mesh_distance - see mesh_distance.h. */
#include <stdlib.h>

#include "mesh/mesh_distance.h"
#include "base/array.h"
#include "math/box_tree.h"
#include "base/parallel.h"
#include "math/point_grid.h"

struct query {
    const struct facets *facets;
    const struct box_tree *tree;
    const struct vec3 *point;
    double *distance;
};

static void measure_points(void *context, size_t from, size_t to)
{
    const struct query *q = context;

    for (size_t i = from; i < to; i++)
        q->distance[i] = facets_distance(q->tree, q->facets, q->point[i]);
}

void mesh_distance(const struct mesh *mesh, const struct vec3 *point, size_t n, int threads,
                   double *distance)
{
    const struct vec3 *at = mesh->vertex.item;
    struct facets facets = {0};

    for (size_t f = 0; f < mesh->face.n; f++) {
        const int *v = mesh->face.item[f].v;
        *array_push(&facets) = (struct facet){{at[v[0]], at[v[1]], at[v[2]]}};
    }
    struct box_tree *tree = facets_tree(&facets);
    struct query q = {&facets, tree, point, distance};
    parallel_for(threads, n, measure_points, &q);
    box_tree_free(tree);
    array_free(&facets);
}

int mesh_coverage(const struct mesh *mesh, const struct vec3 *point, size_t n, double spacing,
                  struct vec3s *covered, struct error *error)
{
    const double border = 1e-9 * spacing * spacing; /* points on a border belong to it */
    const struct vec3 *at = mesh->vertex.item;
    struct vec3s sorted = {0};
    struct sizes found = {0};
    struct point_grid point_grid;

    if (n == 0)
        return 0;
    for (size_t i = 0; i < n; i++)
        *array_push(&sorted) = point[i];
    if (point_grid_make(sorted.item, n, spacing, 1, &point_grid, error) < 0) {
        array_free(&sorted);
        return -1;
    }
    unsigned char *over = mem_alloc(n, 1);
    for (size_t f = 0; f < mesh->face.n; f++) {
        const int *v = mesh->face.item[f].v;
        found.n = 0;
        if (vec_orient_xy(at[v[0]], at[v[1]], at[v[2]]) > 0)
            point_grid_over(&point_grid, at[v[0]], at[v[1]], at[v[2]], border, &found);
        for (size_t k = 0; k < found.n; k++)
            over[found.item[k]] = 1;
    }
    for (size_t i = 0; i < n; i++)
        if (over[i])
            *array_push(covered) = point_grid.point[i];
    array_free(&found);
    free(over);
    point_grid_free(&point_grid);
    array_free(&sorted);
    return 0;
}
