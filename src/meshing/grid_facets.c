/* grid_facets - see grid_facets.h. */
#include "meshing/grid_facets.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"

enum { POINTS_UP = 1, POINTS_DOWN = 2, VERTEX = 4 };

/* The corners of the facet that points up or down, to the right of node (0, 0). */
static const int CORNER[2][3][2] = {{{0, 0}, {1, 0}, {0, 1}}, {{1, 0}, {1, 1}, {0, 1}}};

static unsigned char *mark_of(const struct grid_facets *f, int column, int row)
{
    const struct reposition *r = f->nodes;
    int at = row >= 0 && row < r->grid.rows ? column - r->first[row] : -1;
    bool kept = at >= 0 && at < r->width;
    return kept ? &f->mark[(size_t)row * (size_t)r->width + (size_t)at] : NULL;
}

/* The points of a facet; false: one of its nodes has none. */
static bool corners_of(const struct grid_facets *f, int column, int row, int down,
                       struct vec3 corner[3])
{
    for (int i = 0; i < 3; i++) {
        const int *by = CORNER[down][i];
        const struct node_choice *c = reposition_node(f->nodes, column + by[0], row + by[1]);
        if (!c)
            return false;
        corner[i] = c->at;
    }
    return true;
}

static void find_in_row(struct grid_facets *f, const struct holes *holes, int row, int down,
                        double area[2])
{
    const double cosine = 0.34202014332566873; /* 70 degrees, as mesh_steep_part */
    int first = f->nodes->first[row], last = first + f->nodes->width;
    struct vec3 p[3];

    for (int column = first; column < last && column + 1 < f->nodes->grid.columns; column++) {
        if (!corners_of(f, column, row, down, p) || !grid_mesh_facet(p, holes, &f->count))
            continue;
        *mark_of(f, column, row) |= down ? POINTS_DOWN : POINTS_UP;
        for (int i = 0; i < 3; i++)
            *mark_of(f, column + CORNER[down][i][0], row + CORNER[down][i][1]) |= VERTEX;
        struct vec3 cross = vec_cross(vec_sub(p[1], p[0]), vec_sub(p[2], p[0]));
        double size = vec_length(cross);
        area[0] += size;
        area[1] += cross.z < cosine * size ? size : 0;
        f->facets++;
    }
}

struct grid_facets grid_facets_find(const struct reposition *nodes, const struct holes *holes)
{
    size_t kept = (size_t)nodes->grid.rows * (size_t)nodes->width;
    struct grid_facets f = {.nodes = nodes, .mark = mem_alloc(kept, 1)};
    double area[2] = {0, 0};

    for (int row = 0; row + 1 < nodes->grid.rows; row++)
        for (int down = 0; down < 2; down++)
            find_in_row(&f, holes, row, down, area);
    f.steep = area[0] > 0 ? area[1] / area[0] : 0;
    for (size_t i = 0; i < kept; i++) {
        f.vertices += (f.mark[i] & VERTEX) != 0;
        f.count.alone += nodes->choice[i].point != NO_CHOICE && !(f.mark[i] & VERTEX);
    }
    return f;
}

void grid_facets_free(struct grid_facets *facets)
{
    free(facets->mark);
    facets->mark = NULL;
}

/* Adds the normals of the facets between a row and the next to the sums of their corners, which are
 * by column from the first one kept: sum[0] of this row, sum[1] of the next. */
static void add_normals(const struct grid_facets *f, int row, struct vec3 *const sum[2])
{
    const struct reposition *r = f->nodes;
    const struct node_choice *choice = r->choice + (size_t)row * (size_t)r->width;
    const unsigned char *mark = f->mark + (size_t)row * (size_t)r->width;
    const int shift[2] = {0, r->first[row] - r->first[row + 1]};
    struct vec3 p[3], normal;

    for (int down = 0; down < 2; down++)
        for (int k = 0; k < r->width; k++) {
            int at[3];
            if (!(mark[k] & (down ? POINTS_DOWN : POINTS_UP)))
                continue;
            for (int i = 0; i < 3; i++) {
                const int *by = CORNER[down][i];
                at[i] = k + by[0] + shift[by[1]];
                p[i] = choice[by[1] * r->width + at[i]].at;
            }
            if (!mesh_triangle_normal(p, &normal))
                continue;
            for (int i = 0; i < 3; i++)
                sum[CORNER[down][i][1]][at[i]] = vec_add(sum[CORNER[down][i][1]][at[i]], normal);
        }
}

void grid_facets_vertices(const struct grid_facets *f,
                          void (*take)(void *context, struct vec3 at, struct vec3 normal, int row,
                                       int column),
                          void *context)
{
    size_t width = (size_t)f->nodes->width;
    struct vec3 *sum[2] = {mem_alloc(width, sizeof *sum[0]), mem_alloc(width, sizeof *sum[1])};

    for (int row = 0; row < f->nodes->grid.rows; row++) {
        if (row + 1 < f->nodes->grid.rows)
            add_normals(f, row, sum);
        for (size_t k = 0, node = (size_t)row * width; k < width; k++, node++) {
            if (!(f->mark[node] & VERTEX))
                continue;
            struct vec3 normal = mesh_mean_direction(sum[0][k]);
            take(context, f->nodes->choice[node].at, normal.z < 0 ? vec(0, 0, 1) : normal, row,
                 f->nodes->first[row] + (int)k);
        }
        struct vec3 *done = sum[0];
        sum[0] = sum[1];
        sum[1] = done;
        memset(done, 0, width * sizeof *done);
    }
    free(sum[0]);
    free(sum[1]);
}

/* The numbers of a row's vertices, by column from the first one kept; returns the next number. */
static int number_row(const struct grid_facets *f, int row, int next, int *number)
{
    for (int k = 0; k < f->nodes->width; k++) {
        number[k] = next;
        next += (f->mark[(size_t)row * (size_t)f->nodes->width + (size_t)k] & VERTEX) != 0;
    }
    return next;
}

static void faces_in_row(const struct grid_facets *f, int row, int down, int *const number[2],
                         void (*take)(void *context, const int corner[3]), void *context)
{
    int first[2] = {f->nodes->first[row], f->nodes->first[row + 1]};

    for (int k = 0; k < f->nodes->width; k++) {
        int corner[3];
        if (!(f->mark[(size_t)row * (size_t)f->nodes->width + (size_t)k] &
              (down ? POINTS_DOWN : POINTS_UP)))
            continue;
        for (int i = 0; i < 3; i++) {
            const int *by = CORNER[down][i];
            corner[i] = number[by[1]][first[0] + k + by[0] - first[by[1]]];
        }
        take(context, corner);
    }
}

void grid_facets_faces(const struct grid_facets *f,
                       void (*take)(void *context, const int corner[3]), void *context)
{
    size_t width = (size_t)f->nodes->width;
    int *number[2] = {mem_alloc(width, sizeof(int)), mem_alloc(width, sizeof(int))};
    int next = number_row(f, 0, 0, number[1]);

    for (int row = 0; row + 1 < f->nodes->grid.rows; row++) {
        int *low = number[1];
        number[1] = number[0];
        number[0] = low;
        next = number_row(f, row + 1, next, number[1]);
        for (int down = 0; down < 2; down++)
            faces_in_row(f, row, down, number, take, context);
    }
    free(number[0]);
    free(number[1]);
}

void grid_facets_numbered(const struct grid_facets *f, const size_t *number, size_t n, int *row,
                          int *column)
{
    size_t width = (size_t)f->nodes->width, nodes = width * (size_t)f->nodes->grid.rows;

    for (size_t node = 0, vertex = 0, i = 0; node < nodes && i < n; node++) {
        if (!(f->mark[node] & VERTEX) || vertex++ != number[i])
            continue;
        row[i] = (int)(node / width);
        column[i] = f->nodes->first[row[i]] + (int)(node % width);
        i++;
    }
}

struct vec3 grid_facets_vertex(const struct grid_facets *f, size_t number)
{
    int row = 0, column = 0;

    grid_facets_numbered(f, &number, 1, &row, &column);
    const struct node_choice *c = reposition_node(f->nodes, column, row);
    return c ? c->at : vec(0, 0, 0);
}

/* The vertices of a row from one column to another; number[] of each, counted from column0. */
static void part_of_row(const struct grid_facets *f, int row, int column0, int column1, int *number,
                        struct mesh *mesh)
{
    for (int column = column0; column <= column1; column++) {
        const unsigned char *mark = mark_of(f, column, row);
        number[column - column0] = (int)mesh->vertex.n;
        if (!mark || !(*mark & VERTEX))
            continue;
        *array_push(&mesh->vertex) = reposition_node(f->nodes, column, row)->at;
        *array_push(&mesh->row) = row;
        *array_push(&mesh->col) = column;
    }
}

static void faces_of_part(const struct grid_facets *f, int row, int down, int column0, int column1,
                          int *const number[2], struct mesh *mesh)
{
    for (int column = column0; column < column1; column++) {
        const unsigned char *mark = mark_of(f, column, row);
        struct face face;
        if (!mark || !(*mark & (down ? POINTS_DOWN : POINTS_UP)))
            continue;
        for (int i = 0; i < 3; i++)
            face.v[i] = number[CORNER[down][i][1]][column + CORNER[down][i][0] - column0];
        *array_push(&mesh->face) = face;
    }
}

void grid_facets_part(const struct grid_facets *f, int row0, int row1, int column0, int column1,
                      struct mesh *mesh)
{
    size_t width = (size_t)(column1 - column0) + 1;
    int *number[2] = {mem_alloc(width, sizeof(int)), mem_alloc(width, sizeof(int))};

    part_of_row(f, row0, column0, column1, number[1], mesh);
    for (int row = row0; row < row1; row++) {
        int *low = number[1];
        number[1] = number[0];
        number[0] = low;
        part_of_row(f, row + 1, column0, column1, number[1], mesh);
        for (int down = 0; down < 2; down++)
            faces_of_part(f, row, down, column0, column1, number, mesh);
    }
    free(number[0]);
    free(number[1]);
}
