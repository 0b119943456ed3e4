/* sew_border - see sew_steps.h: the edges that one triangle alone has, and border vertices that lie
 * on a border edge of another patch. */
#include <stdlib.h>

#include "sew_steps.h"

struct place_edge {
    size_t low, high, edge;
};

static int compare_place_edges(const void *p, const void *q)
{
    const struct place_edge *a = p, *b = q;
    if (a->low != b->low)
        return a->low < b->low ? -1 : 1;
    if (a->high != b->high)
        return a->high < b->high ? -1 : 1;
    return a->edge < b->edge ? -1 : a->edge > b->edge;
}

static int compare_sizes(const void *p, const void *q)
{
    const size_t *a = p, *b = q;
    return *a < *b ? -1 : *a > *b;
}

/* The edges between two places that occur once. */
static void find_open_edges(const struct patch_mesh *q, struct sizes *edge)
{
    struct place_edge *all = mem_alloc(q->edge.n + 1, sizeof *all);
    size_t n = 0;
    for (size_t i = 0; i < q->edge.n; i++) {
        size_t a = q->vertex.item[q->edge.item[i].from].place;
        size_t b = q->vertex.item[q->edge.item[i].to].place;
        if (a != b)
            all[n++] = (struct place_edge){a < b ? a : b, a < b ? b : a, i};
    }
    if (n > 0)
        qsort(all, n, sizeof *all, compare_place_edges);
    for (size_t i = 0, k; i < n; i += k) {
        for (k = 1; i + k < n && all[i + k].low == all[i].low && all[i + k].high == all[i].high;)
            k++;
        if (k == 1)
            *array_push(edge) = all[i].edge;
    }
    if (edge->n > 0)
        qsort(edge->item, edge->n, sizeof *edge->item, compare_sizes);
    free(all);
}

void sew_find_border(const struct patch_mesh *q, struct boundary *b)
{
    bool *seen = mem_alloc(q->vertex.n + 1, sizeof *seen);
    struct vec3s point = {0};
    *b = (struct boundary){0};
    find_open_edges(q, &b->edge);
    for (size_t i = 0; i < b->edge.n; i++) {
        const struct patch_mesh_edge *e = &q->edge.item[b->edge.item[i]];
        seen[e->from] = seen[e->to] = true;
    }
    for (size_t i = 0; i < q->vertex.n; i++)
        if (seen[i]) {
            *array_push(&b->vertex) = i;
            *array_push(&point) = q->vertex.item[i].point;
        }
    b->tree = kdtree_new(point.item, point.n);
    array_free(&point);
    free(seen);
}

void sew_free_border(struct boundary *b)
{
    array_free(&b->edge);
    array_free(&b->vertex);
    kdtree_free(b->tree);
    b->tree = NULL;
}

bool sew_are_beside(const struct patches *patches, const struct patch_mesh_vertex *a,
                    const struct patch_mesh_vertex *b)
{
    if (!patch_mesh_same_piece(a, b))
        return false;
    const struct nurbs *s = &patches->item[a->sheet].surface;
    return fabs(a->at.u - b->at.u) < 0.5 * (s->u.to - s->u.from) &&
           fabs(a->at.v - b->at.v) < 0.5 * (s->v.to - s->v.from);
}

static int compare_t_vertices(const void *p, const void *q)
{
    const struct t_vertex *a = p, *b = q;
    if (a->t < b->t || a->t > b->t)
        return a->t < b->t ? -1 : 1;
    return a->vertex < b->vertex ? -1 : a->vertex > b->vertex;
}

static bool is_place_beside(const struct sewing *s, size_t i, const struct patch_mesh_vertex *of)
{
    size_t k = i;
    do {
        if (sew_are_beside(s->patches, sew_vertex(s, k), of))
            return true;
        k = sew_vertex(s, k)->next;
    } while (k != i);
    return false;
}

static bool has_place(const struct sewing *s, const struct t_vertices *on_edge, size_t place)
{
    for (size_t i = 0; i < on_edge->n; i++)
        if (sew_vertex(s, on_edge->item[i].vertex)->place == place)
            return true;
    return false;
}

/* Does an open edge lead from the place to one of these? */
static bool joins_end(const struct sewing *s, size_t place, size_t a, size_t b)
{
    return s->next[place] == a || s->next[place] == b || s->last[place] == a || s->last[place] == b;
}

void sew_find_near(const struct sewing *s, struct vec3 p, double far, int sheet,
                   struct sizes *found)
{
    size_t kept = 0;
    found->n = 0;
    kdtree_within(s->border.tree, p, far, found);
    for (size_t k = 0; k < found->n; k++) {
        int other = sew_vertex(s, s->border.vertex.item[found->item[k]])->sheet;
        if (patch_may_join(&s->patches->item[other], &s->patches->item[sheet]))
            found->item[kept++] = found->item[k];
    }
    found->n = kept;
}

/* How far the surface is off the chord of an edge: however unevenly the parameters run along it. */
static double bulge_of(const struct nurbs *part, const struct patch_mesh_vertex *a,
                       const struct patch_mesh_vertex *b)
{
    double most = 0;
    for (int i = 1; i < 4; i++) {
        struct vec3 on = nurbs_point(part, sew_uv_between(a->at, b->at, i / 4.0));
        most = fmax(most, vec_segment_distance(a->point, b->point, on));
    }
    return most;
}

void sew_find_t_vertices(const struct sewing *s, const struct nurbs *part,
                         const struct patch_mesh_edge *e, struct t_vertices *on_edge)
{
    const struct patch_mesh_vertex *a = sew_vertex(s, e->from), *b = sew_vertex(s, e->to);
    struct vec3 d = vec_sub(b->point, a->point), middle = vec_mix(a->point, b->point, 0.5);
    struct sizes found = {0};
    double length = vec_length(d), bulge = -1;
    on_edge->n = 0;
    sew_find_near(s, middle, length / 2 + s->gap, a->sheet, &found);
    for (size_t k = 0; k < found.n; k++) {
        size_t i = s->border.vertex.item[found.item[k]];
        const struct patch_mesh_vertex *p = sew_vertex(s, i);
        if (p->place == a->place || p->place == b->place || is_place_beside(s, i, a) ||
            has_place(s, on_edge, p->place) ||
            (s->slits && !joins_end(s, p->place, a->place, b->place)))
            continue;
        if (bulge < 0)
            bulge = bulge_of(part, a, b);
        struct vec3 r = vec_sub(p->point, a->point);
        double t = vec_dot(r, d) / (length * length);
        double off = vec_length(vec_along(r, -t, d));
        if (!(t > 1e-6 && t < 1 - 1e-6) || off > 1.5 * bulge + s->slack + s->gap)
            continue;
        struct uv at = nurbs_foot(part, p->point, sew_uv_between(a->at, b->at, t));
        if (vec_distance(nurbs_point(part, at), p->point) <= s->off_surface)
            *array_push(on_edge) = (struct t_vertex){t, i, at};
    }
    if (on_edge->n > 1)
        qsort(on_edge->item, on_edge->n, sizeof *on_edge->item, compare_t_vertices);
    array_free(&found);
}
