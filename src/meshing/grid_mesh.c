/* grid_mesh - see grid_mesh.h. */
#include "meshing/grid_mesh.h"

#include <stdlib.h>

#include "meshing/reposition.h"

bool grid_mesh_facet(const struct vec3 p[3], const struct holes *holes,
                     struct grid_mesh_count *count)
{
    const double nothing = 1e-12; /* against the squares of the edges */
    struct vec3 a = vec_sub(p[1], p[0]), b = vec_sub(p[2], p[0]);
    struct vec3 cross = vec_cross(a, b);
    double edges2 = vec_dot(a, a) + vec_dot(b, b);
    if (vec_length(cross) <= nothing * edges2) {
        count->no_area++;
        return false;
    }
    if (holes && cross.z < -nothing * edges2) {
        count->folded++;
        return false;
    }
    if (holes && holes_bridged(holes, p[0], p[1], p[2])) {
        count->bridges++;
        return false;
    }
    return true;
}

/* Adds a facet of three nodes when it is one; the corners are node numbers for now. */
static void add_facet(const size_t *chosen, const struct vec3 *point, const struct holes *holes,
                      const size_t node[3], struct mesh *mesh, struct grid_mesh_count *count)
{
    struct vec3 p[3];
    for (int i = 0; i < 3; i++) {
        if (chosen[node[i]] == NO_POINT)
            return;
        p[i] = point[chosen[node[i]]];
    }
    if (grid_mesh_facet(p, holes, count))
        *array_push(&mesh->face) = (struct face){{(int)node[0], (int)node[1], (int)node[2]}};
}

static void add_row(const struct grid *grid, const size_t *chosen, const struct vec3 *point,
                    const struct holes *holes, size_t row, struct mesh *mesh,
                    struct grid_mesh_count *count)
{
    size_t columns = (size_t)grid->columns;
    size_t low = row * columns, high = low + columns;
    for (size_t i = 0; i + 1 < columns; i++) {
        size_t up[3] = {low + i, low + i + 1, high + i};
        add_facet(chosen, point, holes, up, mesh, count);
    }
    for (size_t i = 0; i + 1 < columns; i++) {
        size_t down[3] = {low + i + 1, high + i + 1, high + i};
        add_facet(chosen, point, holes, down, mesh, count);
    }
}

/* The vertices, and their numbers in place of the nodes' in the facets. */
static void number_vertices(const struct grid *grid, const size_t *chosen, const struct vec3 *point,
                            bool alone_too, struct mesh *mesh, struct grid_mesh_count *count)
{
    size_t nodes = grid_nodes(grid);
    unsigned char *used = mem_alloc(nodes, 1);
    int *number = mem_alloc(nodes, sizeof *number);
    size_t vertices = mesh->vertex.n;
    for (size_t f = 0; f < mesh->face.n; f++)
        for (int i = 0; i < 3; i++)
            used[mesh->face.item[f].v[i]] = 1;
    for (size_t i = 0; i < nodes; i++)
        vertices += chosen[i] != NO_POINT && (used[i] || alone_too);
    array_reserve(&mesh->vertex, vertices);
    array_reserve(&mesh->row, vertices);
    array_reserve(&mesh->col, vertices);
    for (size_t i = 0; i < nodes; i++) {
        if (chosen[i] == NO_POINT)
            continue;
        count->alone += !used[i];
        if (!used[i] && !alone_too)
            continue;
        number[i] = (int)mesh->vertex.n;
        *array_push(&mesh->vertex) = point[chosen[i]];
        *array_push(&mesh->row) = (int)(i / (size_t)grid->columns);
        *array_push(&mesh->col) = (int)(i % (size_t)grid->columns);
    }
    for (size_t f = 0; f < mesh->face.n; f++)
        for (int i = 0; i < 3; i++)
            mesh->face.item[f].v[i] = number[mesh->face.item[f].v[i]];
    free(number);
    free(used);
}

struct grid_mesh_count grid_mesh_make(const struct grid *grid, const size_t *chosen,
                                      const struct vec3 *point, const struct holes *holes,
                                      struct mesh *mesh)
{
    struct grid_mesh_count count = {0, 0, 0, 0};
    for (size_t row = 0; row + 1 < (size_t)grid->rows; row++)
        add_row(grid, chosen, point, holes, row, mesh, &count);
    number_vertices(grid, chosen, point, holes == NULL, mesh, &count);
    return count;
}
