/* mesh_distance - see mesh_distance.h. */
#include "mesh/mesh_distance.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/box_tree.h"
#include "base/parallel.h"

struct job {
    const struct facets *facets;
    const struct box_tree *tree;
    const struct vec3 *point;
    double *distance;
};

static void measure(void *context, size_t from, size_t to)
{
    const struct job *job = context;

    for (size_t i = from; i < to; i++)
        job->distance[i] = facets_distance(job->tree, job->facets, job->point[i]);
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
    struct job job = {&facets, tree, point, distance};
    parallel_for(threads, n, measure, &job);
    box_tree_free(tree);
    array_free(&facets);
}
