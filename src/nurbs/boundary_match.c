/* boundary_match - see boundary_match.h. */
#include "boundary_match.h"

#include <stdlib.h>

#include "nurbs/tessellate.h"

static const double RUN = 10; /* gaps */

static int compare(const void *p, const void *q)
{
    const struct boundary_pair *a = p, *b = q;
    if (a->vertex != b->vertex)
        return a->vertex < b->vertex ? -1 : 1;
    return (a->sheet > b->sheet) - (a->sheet < b->sheet);
}

static void add(struct boundary_match *c, size_t vertex, int sheet)
{
    *array_push(c) = (struct boundary_pair){.vertex = vertex, .sheet = sheet};
}

/* Vertices of two borders within the gap, and all that share a place. */
static void add_pairs(const struct meeting *m, struct boundary_match *c)
{
    const struct patch_mesh_vertex *v = m->patch_mesh->vertex.item;
    struct sizes found = {0};
    for (size_t k = 0; k < m->border->vertex.n; k++) {
        size_t i = m->border->vertex.item[k];
        for (size_t j = v[i].next; j != i; j = v[j].next)
            if (!t_vertices_beside(m->patches, &v[i], &v[j]))
                add(c, i, v[j].sheet);
        found.n = 0;
        kdtree_within(m->border->tree, v[i].point, m->gap, &found);
        for (size_t f = 0; f < found.n; f++) {
            size_t j = m->border->vertex.item[found.item[f]];
            if (j != i && !t_vertices_beside(m->patches, &v[i], &v[j]))
                add(c, i, v[j].sheet);
        }
    }
    array_free(&found);
}

static void add_guests(const struct meeting *m, struct boundary_match *c)
{
    const struct patch_mesh *q = m->patch_mesh;
    struct t_vertices guests = {0};
    struct nurbs part = {0};
    int sheet = -1, piece = -1;
    for (size_t i = 0; i < m->border->edge.n; i++) {
        const struct patch_mesh_edge *e = &q->edge.item[m->border->edge.item[i]];
        const struct patch_mesh_vertex *a = &q->vertex.item[e->from];
        if (a->sheet != sheet || a->piece != piece)
            part = tessellate_piece(&m->patches->item[a->sheet].surface, a->piece);
        sheet = a->sheet;
        piece = a->piece;
        t_vertices_find(m, &part, e, &guests);
        for (size_t k = 0; k < guests.n; k++) {
            size_t first = guests.item[k].vertex, now = first;
            do
                add(c, now, sheet);
            while ((now = q->vertex.item[now].next) != first);
        }
    }
    array_free(&guests);
}

static struct boundary_pair *find(const struct boundary_match *c, size_t vertex, int sheet)
{
    struct boundary_pair key = {.vertex = vertex, .sheet = sheet};
    return c->n > 0 ? bsearch(&key, c->item, c->n, sizeof key, compare) : NULL;
}

static size_t run_of(struct boundary_match *c, size_t i)
{
    while (c->item[i].run != i)
        i = c->item[i].run = c->item[c->item[i].run].run;
    return i;
}

/* An edge whose ends both have company of one sheet makes one run of theirs. */
static void join_runs(const struct meeting *m, struct boundary_match *c)
{
    for (size_t k = 0; k < m->border->edge.n; k++) {
        const struct patch_mesh_edge *e = &m->patch_mesh->edge.item[m->border->edge.item[k]];
        const struct patch_mesh_vertex *v = m->patch_mesh->vertex.item;
        double length = vec_distance(v[e->from].point, v[e->to].point);
        struct boundary_pair key = {.vertex = e->from, .sheet = -1};
        size_t low = 0, high = c->n;
        while (low < high) {
            size_t middle = low + (high - low) / 2;
            if (compare(&c->item[middle], &key) < 0)
                low = middle + 1;
            else
                high = middle;
        }
        for (; low < c->n && c->item[low].vertex == e->from; low++) {
            struct boundary_pair *other = find(c, e->to, c->item[low].sheet);
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

void boundary_match_find(const struct meeting *m, struct boundary_match *c)
{
    size_t kept = 0;
    *c = (struct boundary_match){.least = RUN * m->gap};
    add_pairs(m, c);
    add_guests(m, c);
    if (c->n > 0)
        qsort(c->item, c->n, sizeof *c->item, compare);
    for (size_t i = 0; i < c->n; i++)
        if (i == 0 || compare(&c->item[i], &c->item[kept - 1]) != 0)
            c->item[kept++] = c->item[i];
    c->n = kept;
    for (size_t i = 0; i < c->n; i++)
        c->item[i].run = i;
    join_runs(m, c);
    for (size_t i = 0; i < c->n; i++)
        c->item[i].run = run_of(c, i);
}

bool boundary_match_has(const struct boundary_match *c, size_t vertex, int sheet)
{
    const struct boundary_pair *one = find(c, vertex, sheet);
    return one && c->item[one->run].length >= c->least;
}

void boundary_match_keep(const struct boundary_match *c, int sheet, struct t_vertices *guests)
{
    size_t kept = 0;
    for (size_t i = 0; i < guests->n; i++)
        if (boundary_match_has(c, guests->item[i].vertex, sheet))
            guests->item[kept++] = guests->item[i];
    guests->n = kept;
}

void boundary_match_free(struct boundary_match *c)
{
    array_free(c);
}
