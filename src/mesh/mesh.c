/* mesh - see mesh.h. */
#include "mesh/mesh.h"

#include <stdlib.h>
#include <string.h>

/* Below this part of its longest edge's square, twice a facet's area is rounding, no direction. */
static const double AREA_OF_NOTHING = 1e-12;

void mesh_free(struct mesh *mesh)
{
    array_free(&mesh->vertex);
    array_free(&mesh->normal);
    array_free(&mesh->row);
    array_free(&mesh->col);
    array_free(&mesh->kmax);
    array_free(&mesh->face);
    array_free(&mesh->surface);
    free(mesh->origin.unit);
    free(mesh->origin.source);
    free(mesh->origin.maker);
    mesh->origin.unit = mesh->origin.source = mesh->origin.maker = NULL;
    for (size_t i = 0; i < mesh->origin.surface.n; i++)
        free(mesh->origin.surface.item[i].name);
    array_free(&mesh->origin.surface);
    array_free(&mesh->origin.part);
    scan_sources_free(&mesh->origin.scan);
    scan_sources_free(&mesh->origin.itself);
    unmets_free(&mesh->origin.unmet);
}

struct vec3 mesh_face_cross(const struct mesh *mesh, size_t face)
{
    const int *v = mesh->face.item[face].v;
    const struct vec3 *p = mesh->vertex.item;
    return vec_cross(vec_sub(p[v[1]], p[v[0]]), vec_sub(p[v[2]], p[v[0]]));
}

double mesh_area(const struct mesh *mesh)
{
    double sum = 0;
    for (size_t i = 0; i < mesh->face.n; i++)
        sum += vec_length(mesh_face_cross(mesh, i)) / 2;
    return sum;
}

bool mesh_triangle_normal(const struct vec3 p[3], struct vec3 *normal)
{
    double longest = 0;
    for (int i = 0; i < 3; i++) {
        struct vec3 edge = vec_sub(p[(i + 1) % 3], p[i]);
        longest = larger(vec_dot(edge, edge), longest);
    }
    struct vec3 cross = vec_cross(vec_sub(p[1], p[0]), vec_sub(p[2], p[0]));
    double area = vec_length(cross);
    if (!(area > AREA_OF_NOTHING * longest))
        return false;
    *normal = vec_scale(1 / area, cross);
    return true;
}

/* The same of a facet. */
static bool face_normal(const struct mesh *mesh, size_t face, struct vec3 *normal)
{
    const int *v = mesh->face.item[face].v;
    const struct vec3 *p = mesh->vertex.item;
    const struct vec3 corner[3] = {p[v[0]], p[v[1]], p[v[2]]};
    return mesh_triangle_normal(corner, normal);
}

struct vec3 mesh_mean_direction(struct vec3 sum)
{
    double length = vec_length(sum);
    return length > 1e-9 ? vec_scale(1 / length, sum) : vec(0, 0, 1);
}

/* Room for one normal for each vertex, all zero. */
static void normals_clear(struct mesh *mesh)
{
    array_reserve(&mesh->normal, mesh->vertex.n);
    mesh->normal.n = mesh->vertex.n;
    for (size_t i = 0; i < mesh->normal.n; i++)
        mesh->normal.item[i] = vec(0, 0, 0);
}

struct vec3 mesh_facing(const struct mesh *mesh)
{
    struct vec3 sum = {0, 0, 0};
    double area = 0;

    for (size_t f = 0; f < mesh->face.n; f++) {
        struct vec3 cross = mesh_face_cross(mesh, f);
        sum = vec_add(sum, cross);
        area += vec_length(cross);
    }
    return area > 0 ? vec_scale(1 / area, sum) : sum;
}

double mesh_steep_part(const struct mesh *mesh, struct vec3 up)
{
    const double cosine = 0.34202014332566873; /* 70 degrees */
    double all = 0, steep = 0;

    for (size_t f = 0; f < mesh->face.n; f++) {
        struct vec3 cross = mesh_face_cross(mesh, f);
        double area = vec_length(cross);
        all += area;
        steep += vec_dot(cross, up) < cosine * area ? area : 0;
    }
    return all > 0 ? steep / all : 0;
}

void mesh_normals_facet(struct mesh *mesh)
{
    normals_clear(mesh);
    struct vec3 *sum = mesh->normal.item;
    for (size_t f = 0; f < mesh->face.n; f++) {
        struct vec3 n;
        if (!face_normal(mesh, f, &n))
            continue;
        for (int i = 0; i < 3; i++) {
            int v = mesh->face.item[f].v[i];
            sum[v] = vec_add(sum[v], n);
        }
    }
    for (size_t i = 0; i < mesh->normal.n; i++)
        sum[i] = mesh_mean_direction(sum[i]);
}

/* The ends of the edges at each vertex, one for each facet that has the edge: those at vertex i
 * are item[start[i]] to item[start[i + 1] - 1]. */
static int *edge_ends(const struct mesh *mesh, size_t *start)
{
    const struct faces *face = &mesh->face;
    for (size_t f = 0; f < face->n; f++)
        for (int i = 0; i < 3; i++)
            start[face->item[f].v[i]] += 2;
    size_t total = 0;
    for (size_t i = 0; i <= mesh->vertex.n; i++) {
        size_t here = start[i];
        start[i] = total;
        total += here;
    }
    int *end = mem_alloc(total, sizeof *end);
    size_t *next = mem_alloc(mesh->vertex.n, sizeof *next);
    for (size_t f = 0; f < face->n; f++)
        for (int i = 0; i < 3; i++) {
            const int *v = face->item[f].v;
            size_t at = start[v[i]] + next[v[i]];
            end[at] = v[(i + 1) % 3];
            end[at + 1] = v[(i + 2) % 3];
            next[v[i]] += 2;
        }
    free(next);
    return end;
}

size_t mesh_normals_turn(struct mesh *mesh)
{
    struct vec3 *sum = mem_alloc(mesh->vertex.n, sizeof *sum);
    size_t turned = 0;

    for (size_t f = 0; f < mesh->face.n; f++) {
        struct vec3 cross = mesh_face_cross(mesh, f);
        for (int i = 0; i < 3; i++) {
            int v = mesh->face.item[f].v[i];
            sum[v] = vec_add(sum[v], cross);
        }
    }
    for (size_t v = 0; v < mesh->vertex.n; v++) {
        struct vec3 mean = vec_unit(sum[v]), *normal = &mesh->normal.item[v];
        double agree = vec_dot(mean, *normal);
        turned += agree < 0;
        if (agree < 0)
            *normal = agree < -0.5 ? vec_scale(-1, *normal) : mean;
    }
    free(sum);
    return turned;
}

size_t mesh_normals_seen(struct mesh *mesh)
{
    size_t n = mesh->normal.n, down = 0;

    for (size_t v = 0; v < n; v++)
        down += mesh->normal.item[v].z < 0;
    if (down == 0)
        return 0;
    struct vec3 *own = mem_alloc(n, sizeof *own);
    memcpy(own, mesh->normal.item, n * sizeof *own);
    mesh_normals_facet(mesh);
    for (size_t v = 0; v < n; v++) {
        struct vec3 *normal = &mesh->normal.item[v];
        if (own[v].z >= 0)
            *normal = own[v];
        else if (!(normal->z > 0))
            *normal = vec(0, 0, 1);
    }
    free(own);
    return down;
}

void mesh_normals_gouraud(struct mesh *mesh)
{
    size_t n = mesh->vertex.n;
    size_t *start = mem_alloc(n + 1, sizeof *start);
    int *end = edge_ends(mesh, start);
    size_t *counted_for = mem_alloc(n, sizeof *counted_for); /* vertex + 1 that had it last */
    struct vec3s mean = {0};
    array_reserve(&mean, n);
    for (size_t i = 0; i < n; i++) {
        struct vec3 sum = vec(0, 0, 0);
        for (size_t k = start[i]; k < start[i + 1]; k++) {
            size_t neighbour = (size_t)end[k];
            if (neighbour == i || counted_for[neighbour] == i + 1)
                continue;
            counted_for[neighbour] = i + 1;
            sum = vec_add(sum, mesh->normal.item[neighbour]);
        }
        *array_push(&mean) = vec_length(sum) > 1e-9 ? vec_unit(sum) : mesh->normal.item[i];
    }
    array_free(&mesh->normal);
    mesh->normal = mean;
    free(counted_for);
    free(end);
    free(start);
}

/* A vertex by its place in the triangular grid. */
struct node {
    long long row, col;
    size_t vertex;
};

static int node_order(const void *a, const void *b)
{
    const struct node *p = a, *q = b;
    if (p->row != q->row)
        return p->row < q->row ? -1 : 1;
    if (p->col != q->col)
        return p->col < q->col ? -1 : 1;
    return (p->vertex > q->vertex) - (p->vertex < q->vertex);
}

/* The vertex at a row and column (the first of several), or NULL. */
static const struct vec3 *node_at(const struct mesh *mesh, const struct node *node, long long row,
                                  long long col)
{
    size_t from = 0, to = mesh->vertex.n;
    while (from < to) {
        size_t middle = from + (to - from) / 2;
        const struct node *m = &node[middle];
        if (m->row < row || (m->row == row && m->col < col))
            from = middle + 1;
        else
            to = middle;
    }
    if (from == mesh->vertex.n || node[from].row != row || node[from].col != col)
        return NULL;
    return &mesh->vertex.item[node[from].vertex];
}

/* The difference of the two neighbours one step (row, col) before and after a vertex, one-sided
 * where one of them is missing; false when both are. */
static bool difference(const struct mesh *mesh, const struct node *node, size_t vertex, int row,
                       int col, struct vec3 *d)
{
    long long r = mesh->row.item[vertex], c = mesh->col.item[vertex];
    const struct vec3 *here = &mesh->vertex.item[vertex];
    const struct vec3 *before = node_at(mesh, node, r - row, c - col);
    const struct vec3 *after = node_at(mesh, node, r + row, c + col);
    *d = vec_sub(after ? *after : *here, before ? *before : *here);
    return before || after;
}

int mesh_normals_central(struct mesh *mesh, struct error *error)
{
    size_t n = mesh->vertex.n;
    if (mesh->row.n != n || mesh->col.n != n || n == 0)
        return error_set(error, "a mesh without rows, expected rows and columns for central "
                                "differences");
    struct node *node = mem_alloc(n, sizeof *node);
    for (size_t i = 0; i < n; i++)
        node[i] = (struct node){mesh->row.item[i], mesh->col.item[i], i};
    qsort(node, n, sizeof *node, node_order);

    int status = 0;
    struct vec3s normal = {0};
    array_reserve(&normal, n);
    for (size_t i = 0; i < n && status == 0; i++) {
        struct vec3 along, across;
        bool known =
            difference(mesh, node, i, 0, 1, &along) &&
            (difference(mesh, node, i, 1, 0, &across) || difference(mesh, node, i, 1, -1, &across));
        if (!known)
            status = error_set(error,
                               "the vertex at row %d, column %d has no neighbour in its row "
                               "or column, expected a regular cloud for central differences",
                               mesh->row.item[i], mesh->col.item[i]);
        else
            *array_push(&normal) =
                mesh_mean_direction(vec_cross(vec_unit(along), vec_unit(across)));
    }
    free(node);
    if (status < 0) {
        array_free(&normal);
        return -1;
    }
    array_free(&mesh->normal);
    mesh->normal = normal;
    return 0;
}
