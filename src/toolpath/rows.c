/* rows - see rows.h. */
#include "toolpath/rows.h"

#include <stdbool.h>
#include <stdlib.h>

/* Degrees: the direction that the mesh states against that of its rows. */
static const double AGREE = 5;

struct place {
    int row, col, vertex;
};

struct places {
    size_t n, cap;
    struct place *item;
};

/* An edge along a row, the smaller vertex first. */
struct edge {
    int a, b;
};

struct edges {
    size_t n, cap;
    struct edge *item;
};

static int compare(int a, int b)
{
    return (a > b) - (a < b);
}

static int compare_places(const void *pa, const void *pb)
{
    const struct place *a = pa, *b = pb;

    if (a->row != b->row)
        return compare(a->row, b->row);
    return a->col != b->col ? compare(a->col, b->col) : compare(a->vertex, b->vertex);
}

static int compare_edges(const void *pa, const void *pb)
{
    const struct edge *a = pa, *b = pb;

    return a->a != b->a ? compare(a->a, b->a) : compare(a->b, b->b);
}

static struct edge edge_between(int a, int b)
{
    return a < b ? (struct edge){a, b} : (struct edge){b, a};
}

static struct edges find_edges(const struct mesh *mesh)
{
    struct edges edges = {0};

    for (size_t f = 0; f < mesh->face.n; f++) {
        const int *v = mesh->face.item[f].v;
        for (int i = 0; i < 3; i++) {
            int a = v[i], b = v[(i + 1) % 3];
            if (mesh->row.item[a] == mesh->row.item[b])
                *array_push(&edges) = edge_between(a, b);
        }
    }
    if (edges.n > 0)
        qsort(edges.item, edges.n, sizeof *edges.item, compare_edges);
    return edges;
}

/* The vertices of rows that belong to facets, in the order of the rows. */
static struct places find_places(const struct mesh *mesh)
{
    struct places places = {0};
    bool *used = mem_alloc(mesh->vertex.n, sizeof *used);

    for (size_t f = 0; f < mesh->face.n; f++) {
        for (int i = 0; i < 3; i++) {
            int v = mesh->face.item[f].v[i];
            if (!used[v] && mesh->row.item[v] >= 0)
                *array_push(&places) = (struct place){mesh->row.item[v], mesh->col.item[v], v};
            used[v] = true;
        }
    }
    if (places.n > 0)
        qsort(places.item, places.n, sizeof *places.item, compare_places);
    free(used);
    return places;
}

/* True if the strip goes on to place p from the one before: along the edge of a facet, or at the
 * same point with the normal of the other side of a crease. */
static bool is_joined(const struct mesh *mesh, const struct place *p, const struct edges *edges)
{
    const struct vec3 *at = mesh->vertex.item;
    struct edge back = edge_between(p[-1].vertex, p->vertex);

    if (p[-1].row == p->row && vec_distance(at[p[-1].vertex], at[p->vertex]) < 1e-9)
        return true;
    return edges->n > 0 && bsearch(&back, edges->item, edges->n, sizeof back, compare_edges);
}

static void find_strips(const struct mesh *mesh, const struct places *places,
                        const struct edges *edges, struct rows *rows)
{
    for (size_t i = 0; i < places->n; i++) {
        const struct place *p = &places->item[i];
        if (i == 0 || !is_joined(mesh, p, edges))
            *array_push(&rows->strip) = (struct strip){.row = p->row, .from = i, .to = i};
        *array_push(&rows->node) = (size_t)p->vertex;
        rows->strip.item[rows->strip.n - 1].to = i + 1;
    }
}

/* The sum of all strips from end to end, flat, or x when there is no way to tell. */
static struct vec3 direction_of_strips(const struct mesh *mesh, const struct rows *rows)
{
    struct vec3 sum = vec(0, 0, 0);

    for (size_t s = 0; s < rows->strip.n; s++) {
        const struct strip *strip = &rows->strip.item[s];
        struct vec3 first = mesh->vertex.item[rows->node.item[strip->from]];
        struct vec3 last = mesh->vertex.item[rows->node.item[strip->to - 1]];
        sum = vec_add(sum, vec_sub(last, first));
    }
    sum.z = 0;
    return vec_length(sum) > 0 ? vec_unit(sum) : vec(1, 0, 0);
}

static struct vec3 choose_direction(const struct mesh *mesh, const struct rows *rows)
{
    struct vec3 found = direction_of_strips(mesh, rows);
    double angle = RADIANS(mesh->origin.direction);

    if (!isfinite(angle))
        return found;
    struct vec3 said = vec(cos(angle), sin(angle), 0);
    double agree = vec_dot(said, found);
    if (fabs(agree) < cos(RADIANS(AGREE)))
        return found;
    return agree > 0 ? said : vec_scale(-1, said);
}

/* How far the nodes move to the left of `along` from row to row: a straight line through
 * (row, place) by least squares; 0 when there is but one row. */
static double step_to_left(const struct mesh *mesh, const struct rows *rows)
{
    struct vec3 left = vec_cross(vec(0, 0, 1), rows->along);
    double n = (double)rows->node.n, r = 0, s = 0, rr = 0, rs = 0;

    for (size_t i = 0; i < rows->node.n; i++) {
        size_t v = rows->node.item[i];
        r += mesh->row.item[v] / n;
        s += vec_dot(left, mesh->vertex.item[v]) / n;
    }
    for (size_t i = 0; i < rows->node.n; i++) {
        size_t v = rows->node.item[i];
        double row = mesh->row.item[v] - r;
        rr += row * row;
        rs += row * (vec_dot(left, mesh->vertex.item[v]) - s);
    }
    return rr > 0 ? rs / rr : 0;
}

/* Vertices between the rows, of creases and walls. */
static size_t count_between(const struct mesh *mesh)
{
    size_t n = 0;

    for (size_t v = 0; v < mesh->row.n; v++)
        n += mesh->row.item[v] < 0;
    return n;
}

/* The part that a row belongs to; NULL: the mesh has none. */
static const struct mesh_part *part_of_row(const struct mesh *mesh, int row)
{
    const struct mesh_parts *part = &mesh->origin.part;
    const struct mesh_part *found = NULL;

    for (size_t i = 0; i < part->n && (i == 0 || part->item[i].row <= row); i++)
        found = &part->item[i];
    return found;
}

static void find_directions(const struct mesh *mesh, struct rows *rows)
{
    const double slant = 0.86602540378443865; /* of the grid: sin 60 */

    rows->along = choose_direction(mesh, rows);
    double step = step_to_left(mesh, rows);
    rows->side = vec_scale(step < 0 ? -1 : 1, vec_cross(vec(0, 0, 1), rows->along));
    rows->distance = fabs(step) > 0 ? fabs(step) : mesh->origin.spacing;
    if (mesh->origin.part.n > 0 && mesh->origin.spacing > 0)
        rows->distance = slant * mesh->origin.spacing;
    for (size_t i = 0; i < rows->strip.n; i++) {
        struct strip *s = &rows->strip.item[i];
        const struct mesh_part *part = part_of_row(mesh, s->row);
        s->along = part ? part->along : rows->along;
        s->up = part ? part->up : vec(0, 0, 1);
        s->side = part ? vec_cross(part->up, part->along) : rows->side;
    }
}

int rows_find(const struct mesh *mesh, struct rows *rows, struct error *error)
{
    if (mesh->row.n != mesh->vertex.n || mesh->col.n != mesh->vertex.n)
        return error_set(error,
                         "found a mesh without rows, expected row and col of each vertex: use "
                         "planecut");
    if (mesh->face.n == 0)
        return error_set(error, "found a mesh without facets, expected some");

    *rows = (struct rows){0};
    struct places places = find_places(mesh);
    struct edges edges = find_edges(mesh);
    find_strips(mesh, &places, &edges, rows);
    array_free(&places);
    array_free(&edges);

    rows->loose = mesh->vertex.n - rows->node.n - count_between(mesh);
    find_directions(mesh, rows);
    return 0;
}

void rows_free(struct rows *rows)
{
    array_free(&rows->node);
    array_free(&rows->strip);
}
