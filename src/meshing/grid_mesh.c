/* grid_mesh - see grid_mesh.h. */
#include "meshing/grid_mesh.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/parallel.h"
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

enum { POINTS_UP = 1, POINTS_DOWN = 2 };

/* Facets by rows of nodes, none of which needs another. */
struct facets {
    const struct grid *grid;
    const size_t *chosen;
    const struct vec3 *point;
    const struct holes *holes;
    unsigned char *mark; /* which facets there are to the right of each node */
    struct row_facets {
        struct grid_mesh_count count;
        size_t first, n; /* its place in the mesh */
    } * row;
    struct face *face;
};

/* The nodes of the facet that points up or down to the right of node i of a row. */
static struct face face_at(const struct facets *f, size_t row, size_t i, int mark)
{
    int columns = f->grid->columns, low = (int)row * columns + (int)i, high = low + columns;

    return mark == POINTS_UP ? (struct face){{low, low + 1, high}}
                             : (struct face){{low + 1, high + 1, high}};
}

static bool is_facet(const struct facets *f, struct face face, struct grid_mesh_count *count)
{
    struct vec3 p[3];
    for (int i = 0; i < 3; i++) {
        if (f->chosen[face.v[i]] == NO_POINT)
            return false;
        p[i] = f->point[f->chosen[face.v[i]]];
    }
    return grid_mesh_facet(p, f->holes, count);
}

static void find_facets(void *context, size_t from, size_t to)
{
    const struct facets *f = context;
    size_t columns = (size_t)f->grid->columns;

    for (size_t row = from; row < to; row++)
        for (int mark = POINTS_UP; mark <= POINTS_DOWN; mark++)
            for (size_t i = 0; i + 1 < columns; i++)
                if (is_facet(f, face_at(f, row, i, mark), &f->row[row].count)) {
                    f->mark[row * columns + i] |= (unsigned char)mark;
                    f->row[row].n++;
                }
}

static void put_facets(void *context, size_t from, size_t to)
{
    const struct facets *f = context;
    size_t columns = (size_t)f->grid->columns;

    for (size_t row = from; row < to; row++) {
        struct face *next = f->face + f->row[row].first;
        for (int mark = POINTS_UP; mark <= POINTS_DOWN; mark++)
            for (size_t i = 0; i + 1 < columns; i++)
                if (f->mark[row * columns + i] & mark)
                    *next++ = face_at(f, row, i, mark);
    }
}

/* The facets, whose corners are numbers of nodes for now. */
static struct grid_mesh_count add_facets(struct facets *f, int threads, struct mesh *mesh)
{
    size_t rows = f->grid->rows > 0 ? (size_t)f->grid->rows - 1 : 0;
    struct grid_mesh_count count = {0, 0, 0, 0};

    f->mark = mem_alloc(grid_nodes(f->grid), sizeof *f->mark);
    f->row = mem_alloc(rows, sizeof *f->row);
    parallel_for(threads, rows, find_facets, f);
    for (size_t row = 0; row < rows; row++) {
        count.bridges += f->row[row].count.bridges;
        count.folded += f->row[row].count.folded;
        count.no_area += f->row[row].count.no_area;
        f->row[row].first = mesh->face.n;
        mesh->face.n += f->row[row].n;
    }
    array_reserve(&mesh->face, mesh->face.n);
    f->face = mesh->face.item;
    parallel_for(threads, rows, put_facets, f);
    free(f->row);
    free(f->mark);
    return count;
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
                                      int threads, struct mesh *mesh)
{
    struct facets facets = {.grid = grid, .chosen = chosen, .point = point, .holes = holes};
    struct grid_mesh_count count = add_facets(&facets, threads, mesh);
    number_vertices(grid, chosen, point, holes == NULL, mesh, &count);
    return count;
}
