/* Is there a wall between two vertices of a mesh; see feature_mesh.h. */
#include <stdlib.h>

#include "feature.h"
#include "feature_link.h"
#include "feature/feature_mesh.h"
#include "base/parallel.h"

/* Edges of a large mesh, and how many in a row are a wall; on a large one four times as many. */
enum { MANY = 200000, CHAIN = 6 };

struct search {
    const struct mesh *mesh;
    const struct mesh_edges *edges;
    struct feature_cloud cloud;
    struct feature *feature;
};

static void look_for_walls(void *context, size_t from, size_t to)
{
    const struct search *s = context;
    const struct vec3 *at = s->mesh->vertex.item;

    for (size_t e = from; e < to; e++) {
        const int *v = s->edges->edge[e].v;
        if (s->edges->edge[e].facet[0] >= 0 && feature_steep(&s->cloud, at[v[0]], at[v[1]]))
            s->feature[e] = feature_wall(&s->cloud, at[v[0]], at[v[1]]);
    }
}

static size_t count_walls(const struct search *s)
{
    size_t walls = 0;

    for (size_t e = 0; e < s->edges->n; e++)
        walls += s->feature[e].kind == FEATURE_WALL;
    return walls;
}

size_t feature_mesh_walls(const struct mesh *mesh, const struct vec3 *point, size_t n, size_t flat,
                          double spacing, double noise, int threads)
{
    if (flat >= n || mesh->face.n == 0)
        return 0;
    struct mesh_edges edges = mesh_edges_find(mesh);
    struct kdtree *tree = kdtree_new_by(point, flat, threads);
    struct kdtree *walls = kdtree_new_by(point + flat, n - flat, threads);
    struct search s = {.mesh = mesh,
                       .edges = &edges,
                       .cloud = {tree, point, walls, point + flat, spacing, noise},
                       .feature = mem_alloc(edges.n, sizeof *s.feature)};

    parallel_for(threads, edges.n, look_for_walls, &s);
    size_t chain = edges.n > MANY ? 4 * CHAIN : CHAIN;
    size_t found = feature_link_longest(&edges, s.feature) >= chain ? count_walls(&s) : 0;
    free(s.feature);
    kdtree_free(tree);
    kdtree_free(walls);
    mesh_edges_free(&edges);
    return found;
}
