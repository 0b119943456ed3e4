/* sew_match - see sew_steps.h: borders that run side by side are told from those that only touch or
 * cross. */
#include <stdlib.h>

#include "sew_steps.h"

/* In gaps: two borders that run side by side for less only touch. */
static const double RUN_LEAST = 10;

static int compare_boundary_pairs(const void *p, const void *q)
{
    const struct boundary_pair *a = p, *b = q;
    if (a->vertex != b->vertex)
        return a->vertex < b->vertex ? -1 : 1;
    return (a->sheet > b->sheet) - (a->sheet < b->sheet);
}

static void add_pair(struct boundary_match *c, size_t vertex, int sheet)
{
    *array_push(c) = (struct boundary_pair){.vertex = vertex, .sheet = sheet};
}

/* Pairs of vertices of two borders within the gap, and of all that share a place. */
static void add_pairs(const struct sewing *s, struct boundary_match *c)
{
    const struct patch_mesh_vertex *v = s->mesh->vertex.item;
    struct sizes found = {0};
    for (size_t k = 0; k < s->border.vertex.n; k++) {
        size_t i = s->border.vertex.item[k];
        for (size_t j = v[i].next; j != i; j = v[j].next)
            if (!sew_are_beside(s->patches, &v[i], &v[j]))
                add_pair(c, i, v[j].sheet);
        sew_find_near(s, v[i].point, s->gap, v[i].sheet, &found);
        for (size_t f = 0; f < found.n; f++) {
            size_t j = s->border.vertex.item[found.item[f]];
            if (j != i && !sew_are_beside(s->patches, &v[i], &v[j]))
                add_pair(c, i, v[j].sheet);
        }
    }
    array_free(&found);
}

/* Pairs of T-vertices and the sheets whose edges they lie on. */
static void add_t_vertex_pairs(const struct sewing *s, struct boundary_match *c)
{
    const struct patch_mesh *q = s->mesh;
    struct t_vertices on_edge = {0};
    struct nurbs part = {0};
    int sheet = -1, piece = -1;
    for (size_t i = 0; i < s->border.edge.n; i++) {
        const struct patch_mesh_edge *e = &q->edge.item[s->border.edge.item[i]];
        const struct patch_mesh_vertex *a = &q->vertex.item[e->from];
        if (a->sheet != sheet || a->piece != piece)
            part = tessellate_piece(&s->patches->item[a->sheet].surface, a->piece);
        sheet = a->sheet;
        piece = a->piece;
        sew_find_t_vertices(s, &part, e, &on_edge);
        for (size_t k = 0; k < on_edge.n; k++) {
            size_t first = on_edge.item[k].vertex, now = first;
            do
                add_pair(c, now, sheet);
            while ((now = q->vertex.item[now].next) != first);
        }
    }
    array_free(&on_edge);
}

static struct boundary_pair *find_pair(const struct boundary_match *c, size_t vertex, int sheet)
{
    struct boundary_pair key = {.vertex = vertex, .sheet = sheet};
    return c->n > 0 ? bsearch(&key, c->item, c->n, sizeof key, compare_boundary_pairs) : NULL;
}

static size_t run_of(struct boundary_match *c, size_t i)
{
    while (c->item[i].run != i)
        i = c->item[i].run = c->item[c->item[i].run].run;
    return i;
}

/* Where both ends of a border edge meet the same sheet, their pairs belong to one run. */
static void join_runs(const struct sewing *s, struct boundary_match *c)
{
    for (size_t k = 0; k < s->border.edge.n; k++) {
        const struct patch_mesh_edge *e = &s->mesh->edge.item[s->border.edge.item[k]];
        const struct patch_mesh_vertex *v = s->mesh->vertex.item;
        double length = vec_distance(v[e->from].point, v[e->to].point);
        struct boundary_pair key = {.vertex = e->from, .sheet = -1};
        size_t low = 0, high = c->n;
        while (low < high) {
            size_t middle = low + (high - low) / 2;
            if (compare_boundary_pairs(&c->item[middle], &key) < 0)
                low = middle + 1;
            else
                high = middle;
        }
        for (; low < c->n && c->item[low].vertex == e->from; low++) {
            struct boundary_pair *other = find_pair(c, e->to, c->item[low].sheet);
            if (!other)
                continue;
            size_t a = run_of(c, low), b = run_of(c, (size_t)(other - c->item));
            c->item[a].length += length;
            if (a != b) {
                c->item[a].length += c->item[b].length;
                c->item[b].run = a;
            }
        }
    }
}

void sew_match(const struct sewing *s, struct boundary_match *c)
{
    size_t kept = 0;
    *c = (struct boundary_match){0};
    add_pairs(s, c);
    add_t_vertex_pairs(s, c);
    if (c->n > 0)
        qsort(c->item, c->n, sizeof *c->item, compare_boundary_pairs);
    for (size_t i = 0; i < c->n; i++)
        if (i == 0 || compare_boundary_pairs(&c->item[i], &c->item[kept - 1]) != 0)
            c->item[kept++] = c->item[i];
    c->n = kept;
    for (size_t i = 0; i < c->n; i++)
        c->item[i].run = i;
    join_runs(s, c);
    for (size_t i = 0; i < c->n; i++)
        c->item[i].run = run_of(c, i);
}

bool sew_is_matched(const struct sewing *s, size_t vertex, int sheet)
{
    const struct boundary_pair *one = find_pair(&s->match, vertex, sheet);
    return one && s->match.item[one->run].length >= RUN_LEAST * s->gap;
}

void sew_keep_matched(const struct sewing *s, int sheet, struct t_vertices *on_edge)
{
    size_t kept = 0;
    for (size_t i = 0; i < on_edge->n; i++)
        if (sew_is_matched(s, on_edge->item[i].vertex, sheet))
            on_edge->item[kept++] = on_edge->item[i];
    on_edge->n = kept;
}
