/* mesh_edges - see mesh_edges.h. */
#include "mesh/mesh_edges.h"

#include <stdlib.h>

/* A facet's side, at the smaller of its vertices. */
struct side {
    int other, facet, place;
};

/* How many sides begin before each vertex: start[vertices + 1]. */
static size_t *count_sides(const struct mesh *mesh)
{
    size_t *start = mem_alloc(mesh->vertex.n + 1, sizeof *start), total = 0;

    for (size_t f = 0; f < mesh->face.n; f++) {
        const int *v = mesh->face.item[f].v;
        for (int i = 0; i < 3; i++)
            start[v[i] < v[(i + 1) % 3] ? v[i] : v[(i + 1) % 3]]++;
    }
    for (size_t v = 0; v <= mesh->vertex.n; v++) {
        size_t here = start[v];
        start[v] = total;
        total += here;
    }
    return start;
}

/* Puts a side where it belongs among those of its vertex, by the other vertex, then as they come.
 */
static void insert(struct side *side, size_t n, struct side new)
{
    for (; n > 0 && side[n - 1].other > new.other; n--)
        side[n] = side[n - 1];
    side[n] = new;
}

static struct side *sort_sides(const struct mesh *mesh, const size_t *start)
{
    struct side *side = mem_alloc(3 * mesh->face.n, sizeof *side);
    size_t *n = mem_alloc(mesh->vertex.n, sizeof *n);

    for (size_t f = 0; f < mesh->face.n; f++) {
        const int *v = mesh->face.item[f].v;
        for (int i = 0; i < 3; i++) {
            int a = v[i], b = v[(i + 1) % 3], low = a < b ? a : b;
            insert(side + start[low], n[low]++, (struct side){a < b ? b : a, (int)f, i});
        }
    }
    free(n);
    return side;
}

struct mesh_edges mesh_edges_find(const struct mesh *mesh)
{
    size_t *start = count_sides(mesh);
    struct side *side = sort_sides(mesh, start);
    struct mesh_edges e = {0, mem_alloc(3 * mesh->face.n, sizeof *e.edge),
                           mem_alloc(mesh->face.n, sizeof *e.of)};

    for (size_t v = 0; v < mesh->vertex.n; v++) {
        for (size_t i = start[v], next; i < start[v + 1]; i = next) {
            const struct side *s = &side[i];
            for (next = i; next < start[v + 1] && side[next].other == s->other; next++)
                e.of[side[next].facet][side[next].place] = (int)e.n;
            struct mesh_edge edge = {{(int)v, s->other}, {s->facet, EDGE_BORDER}};
            if (next - i == 2)
                edge.facet[1] = s[1].facet;
            if (next - i > 2)
                edge.facet[0] = edge.facet[1] = EDGE_MANY;
            e.edge[e.n++] = edge;
        }
    }
    free(side);
    free(start);
    return e;
}

void mesh_edges_free(struct mesh_edges *edges)
{
    free(edges->edge);
    free(edges->of);
    *edges = (struct mesh_edges){0};
}

int mesh_edge_beyond(const struct mesh_edges *edges, int edge, int facet)
{
    const int *f = edges->edge[edge].facet;

    if (f[0] < 0 || f[1] < 0)
        return f[1];
    return f[0] == facet ? f[1] : f[0];
}

struct edge_curve mesh_edge_curve(const struct mesh *mesh, int from, int to)
{
    const double most = 0.5; /* of the spacing */
    struct vec3 p = mesh->vertex.item[from], q = mesh->vertex.item[to];
    struct vec3 pn = mesh->normal.item[from], qn = mesh->normal.item[to];
    double spacing = mesh->origin.spacing;

    if (spacing > 0 && edge_bulge(p, pn, q, qn) > most * spacing)
        return edge_chord(p, q);
    return edge_curve(p, pn, q, qn);
}
