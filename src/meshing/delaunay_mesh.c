/*
 * delaunay_mesh - see delaunay_mesh.h.  All points; then the border of few of them, the points over
 * each facet, and the one farthest off, again and again.
 */
#include "meshing/delaunay_mesh.h"

#include <stdlib.h>

#include "delaunay_border.h"
#include "delaunay_thin.h"

/* The triangles that are surface, as facets of their corners. */
static void take_facets(const struct delaunay *d, const bool *surface, const struct vec3 *point,
                        struct mesh *mesh)
{
    int *number = mem_alloc((size_t)d->n, sizeof *number);

    for (size_t t = 0; t < d->t.n; t++)
        for (int k = 0; k < 3 && surface[t]; k++)
            number[d->t.item[t].v[k]] = 1;
    for (int i = 0; i < d->n; i++)
        if (number[i] > 0) {
            number[i] = (int)mesh->vertex.n;
            *array_push(&mesh->vertex) = point[i];
        }
    for (size_t t = 0; t < d->t.n; t++)
        if (surface[t]) {
            const int *v = d->t.item[t].v;
            *array_push(&mesh->face) = (struct face){{number[v[0]], number[v[1]], number[v[2]]}};
        }
    free(number);
}

static void mesh_of_all(const struct delaunay *d, const struct vec3 *point, double gap,
                        struct mesh *mesh)
{
    bool *surface = mem_alloc(d->t.n, sizeof *surface);

    for (size_t t = 0; t < d->t.n; t++)
        surface[t] = delaunay_is_surface(d, (int)t, gap);
    take_facets(d, surface, point, mesh);
    free(surface);
}

void delaunay_mesh_make(const struct vec3 *point, size_t n,
                        const struct delaunay_mesh_options *options, struct mesh *mesh)
{
    struct delaunay all = delaunay_new(point, n);

    delaunay_insert_all(&all);
    if (!(options->error > 0) && (options->keep == 0 || options->keep >= n)) {
        mesh_of_all(&all, point, options->gap, mesh);
        delaunay_free(&all);
        return;
    }
    struct scan_border border = delaunay_border(&all, options->gap);
    delaunay_free(&all);
    struct delaunay few = delaunay_new(point, n);
    bool *surface = delaunay_thin(&few, point, &border, options);
    take_facets(&few, surface, point, mesh);
    free(surface);
    scan_border_free(&border);
    delaunay_free(&few);
}
