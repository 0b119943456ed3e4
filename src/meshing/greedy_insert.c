/* greedy_insert - see greedy_insert.h. */
#include "meshing/greedy_insert.h"

#include <stdlib.h>

#include "math/elementary.h"
#include "math/kdtree.h"
#include "mesh/mesh_edges.h"
#include "mesh/mesh_distance.h"
#include "mesh/facet_split.h"

/* Takes a point off the list of its facet. */
static void remove_from_list(struct facet_split *w, int facet, int i)
{
    int *link = &w->first.item[facet];

    while (*link != i)
        link = &w->next[*link];
    *link = w->next[i];
}

/* Facets get their worst points until none is out; all again, for what is beside them changes. */
static void insert_all(struct facet_split *w)
{
    size_t before;

    do {
        before = w->mesh->vertex.n;
        w->todo.n = 0;
        for (int f = 0; f < (int)w->mesh->face.n; f++)
            *array_push(&w->todo) = f;
        for (size_t next = 0; next < w->todo.n; next++) {
            int facet = w->todo.item[next], i = FACET_SPLIT_NONE;
            while (facet_split_worst(w, facet, &i) > 0 && !facet_split_apart(w, facet, w->point[i]))
                remove_from_list(w, facet, i);
            if (facet_split_worst(w, facet, &i) > 0)
                facet_split_at(w, facet, i);
        }
    } while (w->mesh->vertex.n > before);
}

/* The facets beyond the edges. */
static void find_beyond(struct facet_split *w)
{
    struct mesh_edges edges = mesh_edges_find(w->mesh);

    for (size_t f = 0; f < w->mesh->face.n; f++)
        for (int k = 0; k < 3; k++) {
            int beyond = mesh_edge_beyond(&edges, edges.of[f][k], (int)f);
            *array_push(&w->beyond) = beyond < 0 ? FACET_SPLIT_NONE : beyond;
        }
    mesh_edges_free(&edges);
}

/* Puts each point over the first facet that it is above or below. */
static void find_points(struct facet_split *w, size_t n)
{
    struct vec3 *flat = mem_alloc(n, sizeof *flat);
    bool *done = mem_alloc(n, sizeof *done);
    struct sizes near = {0};

    for (size_t i = 0; i < n; i++) {
        flat[i] = vec(w->point[i].x, w->point[i].y, 0);
        done[i] = false;
    }
    struct kdtree *tree = kdtree_new(flat, n);
    for (int f = 0; f < (int)w->mesh->face.n; f++) {
        const int *v = w->mesh->face.item[f].v;
        struct vec3 middle = vec(0, 0, 0);
        double reach = 0;
        for (int k = 0; k < 3; k++)
            middle = vec_along(middle, 1 / 3.0, w->mesh->vertex.item[v[k]]);
        for (int k = 0; k < 3; k++) {
            struct vec3 d = vec_sub(w->mesh->vertex.item[v[k]], middle);
            reach = fmax(reach, hypot(d.x, d.y));
        }
        middle.z = 0;
        near.n = 0;
        kdtree_within(tree, middle, reach * (1 + 1e-9), &near);
        *array_push(&w->first) = FACET_SPLIT_NONE;
        for (size_t k = 0; k < near.n; k++) {
            size_t i = near.item[k];
            if (done[i] || !facet_split_over(w, f, w->point[i]))
                continue;
            done[i] = true;
            facet_split_put(w, f, (int)i);
        }
    }
    array_free(&near);
    kdtree_free(tree);
    free(done);
    free(flat);
}

/* Points that an upright facet, of a wall, is near enough to are nobody's concern. */
static void drop_served(struct facet_split *w, size_t n, int threads)
{
    const double upright = 0.02; /* sine of the slope off upright */
    struct mesh walls = {.vertex = w->mesh->vertex};
    double *off = mem_alloc(n, sizeof *off);

    for (size_t f = 0; f < w->mesh->face.n; f++)
        if (fabs(vec_unit(mesh_face_cross(w->mesh, f)).z) < upright)
            *array_push(&walls.face) = w->mesh->face.item[f];
    for (size_t i = 0; i < n; i++)
        off[i] = HUGE_VAL;
    if (walls.face.n > 0)
        mesh_distance(&walls, w->point, n, threads, off);
    for (int f = 0; f < (int)w->mesh->face.n; f++)
        for (int i = w->first.item[f], next; i != FACET_SPLIT_NONE; i = next) {
            next = w->next[i];
            if (off[i] <= w->within[i])
                remove_from_list(w, f, i);
        }
    array_free(&walls.face);
    free(off);
}

/* Normals of the new vertices: the facets' by their areas. */
static void find_normals(struct facet_split *w)
{
    struct mesh *mesh = w->mesh;

    for (int v = w->old; v < (int)mesh->vertex.n; v++)
        *array_push(&mesh->normal) = vec(0, 0, 0);
    for (size_t f = 0; f < mesh->face.n; f++)
        for (int k = 0; k < 3; k++) {
            struct vec3 *normal = &mesh->normal.item[mesh->face.item[f].v[k]];
            if (mesh->face.item[f].v[k] >= w->old)
                *normal = vec_add(*normal, mesh_face_cross(mesh, f));
        }
    for (int v = w->old; v < (int)mesh->vertex.n; v++) {
        struct vec3 normal = vec_unit(mesh->normal.item[v]);
        mesh->normal.item[v] = normal.z > 0 ? normal : vec(0, 0, 1);
    }
}

size_t greedy_insert(struct mesh *mesh, const struct vec3 *point, const double *within, size_t n,
                     int threads)
{
    struct facet_split w = {
        .mesh = mesh, .old = (int)mesh->vertex.n, .point = point, .within = within};

    if (n == 0)
        return 0;
    w.next = mem_alloc(n, sizeof *w.next);
    find_beyond(&w);
    find_points(&w, n);
    drop_served(&w, n, threads);
    insert_all(&w);
    find_normals(&w);
    array_free(&w.beyond);
    array_free(&w.first);
    array_free(&w.todo);
    free(w.next);
    return mesh->vertex.n - (size_t)w.old;
}
