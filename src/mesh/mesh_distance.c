/* mesh_distance - see mesh_distance.h. */
#include "mesh/mesh_distance.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/facet_tree.h"
#include "base/parallel.h"

struct job {
    const struct facet_tree *tree;
    const struct vec3 *point;
    double *distance;
};

static void measure(void *context, size_t from, size_t to)
{
    const struct job *job = context;

    for (size_t i = from; i < to; i++)
        job->distance[i] = facet_tree_distance(job->tree, job->point[i]);
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
    struct facet_tree *tree = facet_tree_new(&facets);
    struct job job = {tree, point, distance};
    parallel_for(threads, n, measure, &job);
    facet_tree_free(tree);
    array_free(&facets);
}
