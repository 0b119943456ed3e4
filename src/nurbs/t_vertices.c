/* t_vertices - see t_vertices.h. */
#include "t_vertices.h"

#include <stdlib.h>

static const struct patch_mesh_vertex *vertex(const struct meeting *m, size_t i)
{
    return &m->patch_mesh->vertex.item[i];
}

bool t_vertices_beside(const struct patches *patches, const struct patch_mesh_vertex *a,
                       const struct patch_mesh_vertex *b)
{
    if (!patch_mesh_same_piece(a, b))
        return false;
    const struct nurbs *s = &patches->item[a->sheet].surface;
    return fabs(a->at.u - b->at.u) < 0.5 * (s->u.to - s->u.from) &&
           fabs(a->at.v - b->at.v) < 0.5 * (s->v.to - s->v.from);
}

static int compare_guests(const void *p, const void *q)
{
    const struct t_vertex *a = p, *b = q;
    if (a->t < b->t || a->t > b->t)
        return a->t < b->t ? -1 : 1;
    return a->vertex < b->vertex ? -1 : a->vertex > b->vertex;
}

static bool place_is_beside(const struct meeting *m, size_t i, const struct patch_mesh_vertex *of)
{
    size_t k = i;
    do {
        if (t_vertices_beside(m->patches, vertex(m, k), of))
            return true;
        k = vertex(m, k)->next;
    } while (k != i);
    return false;
}

static struct uv uv_mix(struct uv a, struct uv b, double t)
{
    return (struct uv){a.u + t * (b.u - a.u), a.v + t * (b.v - a.v)};
}

static bool is_there(const struct meeting *m, const struct t_vertices *guests, size_t place)
{
    for (size_t i = 0; i < guests->n; i++)
        if (vertex(m, guests->item[i].vertex)->place == place)
            return true;
    return false;
}

void t_vertices_find(const struct meeting *m, const struct nurbs *part,
                     const struct patch_mesh_edge *e, struct t_vertices *guests)
{
    const struct patch_mesh_vertex *a = vertex(m, e->from), *b = vertex(m, e->to);
    struct vec3 d = vec_sub(b->point, a->point), middle = vec_mix(a->point, b->point, 0.5);
    struct sizes found = {0};
    double length = vec_length(d), bulge = -1;
    guests->n = 0;
    kdtree_within(m->border->tree, middle, length / 2 + m->gap, &found);
    for (size_t k = 0; k < found.n; k++) {
        size_t i = m->border->vertex.item[found.item[k]];
        const struct patch_mesh_vertex *p = vertex(m, i);
        if (p->place == a->place || p->place == b->place || place_is_beside(m, i, a) ||
            is_there(m, guests, p->place))
            continue;
        if (bulge < 0)
            bulge = vec_distance(middle, nurbs_point(part, uv_mix(a->at, b->at, 0.5)));
        struct vec3 r = vec_sub(p->point, a->point);
        double t = vec_dot(r, d) / (length * length);
        double off = vec_length(vec_along(r, -t, d));
        if (!(t > 1e-6 && t < 1 - 1e-6) || off > 1.5 * bulge + m->slack + m->gap)
            continue;
        struct uv at = nurbs_foot(part, p->point, uv_mix(a->at, b->at, t));
        if (vec_distance(nurbs_point(part, at), p->point) <= m->gap)
            *array_push(guests) = (struct t_vertex){t, i, at};
    }
    if (guests->n > 1)
        qsort(guests->item, guests->n, sizeof *guests->item, compare_guests);
    array_free(&found);
}
