#include "gouge/convex_edges.h"

#include <stdlib.h>

#include "mesh/mesh_weld.h"

/* The edge of a facet from its corner i on, by the first vertices at its ends, the smaller first.
 */
struct side {
    size_t end[2];
    size_t facet;
    int i;
};

struct sides {
    size_t n, cap;
    struct side *item;
};

static int compare_sides(const void *pa, const void *pb)
{
    const struct side *a = pa, *b = pb;

    for (int k = 0; k < 2; k++)
        if (a->end[k] != b->end[k])
            return a->end[k] < b->end[k] ? -1 : 1;
    return (a->facet > b->facet) - (a->facet < b->facet);
}

static bool same_ends(const struct side *a, const struct side *b)
{
    return a->end[0] == b->end[0] && a->end[1] == b->end[1];
}

/* Those with an end where several vertices are, in order. */
static struct sides find_sides(const struct mesh *mesh)
{
    struct sides sides = {0};
    size_t *first = mesh_first_at_place(mesh), n = mesh->vertex.n;
    bool *shared = mem_alloc(n, sizeof *shared);

    for (size_t v = 0; v < n; v++)
        shared[v] = false;
    for (size_t v = 0; v < n; v++)
        shared[first[v]] = shared[first[v]] || first[v] != v;
    for (size_t f = 0; f < mesh->face.n; f++)
        for (int i = 0; i < 3; i++) {
            const int *v = mesh->face.item[f].v;
            size_t a = first[v[i]], b = first[v[(i + 1) % 3]];
            if (shared[a] || shared[b])
                *array_push(&sides) = (struct side){{a < b ? a : b, a < b ? b : a}, f, i};
        }
    free(first);
    free(shared);
    if (sides.n > 0)
        qsort(sides.item, sides.n, sizeof *sides.item, compare_sides);
    return sides;
}

/* The two facets have no edge in common but by its place. */
static bool apart(const struct mesh *mesh, const struct side *a, const struct side *b)
{
    const int *v = mesh->face.item[a->facet].v, *w = mesh->face.item[b->facet].v;
    int from = v[a->i], to = v[(a->i + 1) % 3];

    return from != w[(b->i + 1) % 3] || to != w[b->i];
}

/* The corner of b off the edge lies below the plane of a. */
static bool falls_off(const struct mesh *mesh, const struct side *a, const struct side *b)
{
    const struct vec3 *p = mesh->vertex.item;
    struct vec3 up = mesh_face_cross(mesh, a->facet);
    struct vec3 beyond = p[mesh->face.item[b->facet].v[(b->i + 2) % 3]];

    return vec_dot(up, vec_sub(beyond, p[a->end[0]])) < 0;
}

void convex_edges_sample(const struct mesh *mesh, double spacing, struct vec3s *to)
{
    struct sides sides = find_sides(mesh);

    for (size_t k = 0, end; k < sides.n; k = end) {
        const struct side *a = &sides.item[k], *b = a + 1;
        for (end = k + 1; end < sides.n && same_ends(a, &sides.item[end]);)
            end++;
        if (end != k + 2 || !apart(mesh, a, b) || !falls_off(mesh, a, b) || !falls_off(mesh, b, a))
            continue;
        struct vec3 p = mesh->vertex.item[a->end[0]], q = mesh->vertex.item[a->end[1]];
        double parts = ceil(vec_distance(p, q) / spacing);
        for (double i = 0; i <= parts; i++)
            *array_push(to) = vec_mix(p, q, i / fmax(parts, 1));
    }
    array_free(&sides);
}
