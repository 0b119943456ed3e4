#include "crease_normals.h"

#include <stdlib.h>

#include "mesh/mesh_edges.h"

static const double SHARP = 0.8660254037844386; /* cos 30 degrees */

/* Corners of facets, number 3 * facet + corner, joined to the same vertex: a forest of parents. */
static int root_of(int *parent, int corner)
{
    while (parent[corner] != corner) {
        parent[corner] = parent[parent[corner]];
        corner = parent[corner];
    }
    return corner;
}

/* The smaller number becomes the root, so that the vertices keep their order. */
static void join(int *parent, int a, int b)
{
    a = root_of(parent, a);
    b = root_of(parent, b);
    if (a < b)
        parent[b] = a;
    else
        parent[a] = b;
}

static int corner_at(const struct mesh *mesh, int facet, int vertex)
{
    const int *v = mesh->face.item[facet].v;

    return 3 * facet + (v[0] == vertex ? 0 : v[1] == vertex ? 1 : 2);
}

static int *join_corners(const struct mesh *mesh)
{
    struct mesh_edges edges = mesh_edges_find(mesh);
    int *parent = mem_alloc(3 * mesh->face.n, sizeof *parent);

    for (size_t i = 0; i < 3 * mesh->face.n; i++)
        parent[i] = (int)i;
    for (size_t e = 0; e < edges.n; e++) {
        const struct mesh_edge *edge = &edges.edge[e];
        int f = edge->facet[0], g = edge->facet[1];
        if (f < 0 || g < 0)
            continue;
        struct vec3 a = vec_unit(mesh_face_cross(mesh, (size_t)f));
        struct vec3 b = vec_unit(mesh_face_cross(mesh, (size_t)g));
        for (int i = 0; i < 2 && vec_dot(a, b) >= SHARP; i++)
            join(parent, corner_at(mesh, f, edge->v[i]), corner_at(mesh, g, edge->v[i]));
    }
    mesh_edges_free(&edges);
    return parent;
}

/* The facet's normal, as long as its angle at a corner. */
static struct vec3 weighted_normal(const struct mesh *mesh, size_t facet, int corner)
{
    const int *v = mesh->face.item[facet].v;
    const struct vec3 *p = mesh->vertex.item;
    struct vec3 here = p[v[corner]];
    double angle =
        vec_angle(vec_sub(p[v[(corner + 1) % 3]], here), vec_sub(p[v[(corner + 2) % 3]], here));

    return vec_scale(angle, vec_unit(mesh_face_cross(mesh, facet)));
}

void crease_normals(struct mesh *mesh)
{
    int *parent = join_corners(mesh);
    int *number = mem_alloc(3 * mesh->face.n, sizeof *number);
    struct vec3s vertex = {0}, normal = {0};

    for (size_t f = 0; f < mesh->face.n; f++) {
        for (int i = 0; i < 3; i++) {
            int corner = 3 * (int)f + i, root = root_of(parent, corner);
            if (root == corner) {
                number[root] = (int)vertex.n;
                *array_push(&vertex) = mesh->vertex.item[mesh->face.item[f].v[i]];
                *array_push(&normal) = vec(0, 0, 0);
            }
            struct vec3 *sum = &normal.item[number[root]];
            *sum = vec_add(*sum, weighted_normal(mesh, f, i));
        }
    }
    for (size_t i = 0; i < 3 * mesh->face.n; i++)
        mesh->face.item[i / 3].v[i % 3] = number[root_of(parent, (int)i)];
    for (size_t v = 0; v < normal.n; v++)
        normal.item[v] = vec_length(normal.item[v]) > 0 ? vec_unit(normal.item[v]) : vec(0, 0, 1);
    free(parent);
    free(number);
    array_free(&mesh->row);
    array_free(&mesh->col);
    array_free(&mesh->kmax);
    array_free(&mesh->vertex);
    array_free(&mesh->normal);
    mesh->vertex = vertex;
    mesh->normal = normal;
}
