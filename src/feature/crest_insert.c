/* crest_insert - see feature_steps.h. */
#include <stdlib.h>

#include "feature_steps.h"
#include "math/earclip.h"

/* Corners that a facet may get: three, and the points of a crest on each side. */
enum { CORNERS = 3 * (CREST_MOST + 1) };

struct insertion {
    struct mesh *mesh;
    const struct crest_edges *at;
    int *vertex;       /* the first new one of each edge that was looked at */
    struct faces face; /* what comes of the facets */
};

static void add_vertices(struct insertion *s, size_t i)
{
    struct mesh *m = s->mesh;
    const int *v = s->at->edges->edge[s->at->edge.item[i]].v;
    const struct crest *c = &s->at->crest[i];
    bool rows = m->row.n > 0 && m->row.item[v[0]] == m->row.item[v[1]];

    s->vertex[i] = (int)m->vertex.n;
    for (int k = 0; k < c->n; k++) {
        *array_push(&m->vertex) = c->place[k];
        *array_push(&m->normal) = c->normal[k];
        if (m->kmax.n > 0)
            *array_push(&m->kmax) = c->kmax[k];
        if (m->row.n == 0)
            continue;
        int row = rows ? m->row.item[v[0]] : -1, col = rows ? m->col.item[v[0]] : -1;
        *array_push(&m->row) = row;
        *array_push(&m->col) = col;
    }
}

/* A facet and what its sides got, as a polygon: where no three of its corners lie on a line, for
 * its sides are bent inwards a little. */
struct polygon {
    size_t n;
    int corner[CORNERS];
    struct uv at[CORNERS];
    int tops;
    size_t top[3]; /* which corners are on crests */
};

static void add_side(const struct insertion *s, size_t facet, int i, struct polygon *p)
{
    const double inwards = 1e-3, height = 0.86602540378443865;
    const struct uv plane[3] = {{0, 0}, {1, 0}, {0.5, height}};
    struct uv a = plane[i], b = plane[(i + 1) % 3];
    int e = s->at->edges->of[facet][i], which = s->at->of[e];
    const struct crest *c = which < 0 ? NULL : &s->at->crest[which];
    bool forth = s->at->face.item[facet].v[i] == s->at->edges->edge[e].v[0];

    p->corner[p->n] = s->at->face.item[facet].v[i];
    p->at[p->n++] = a;
    for (int k = 0; c && k < c->n; k++) {
        int j = forth ? k : c->n - 1 - k;
        double t = forth ? c->part[j] : 1 - c->part[j], in = inwards * t * (1 - t);
        if (j == c->top && p->tops < 3)
            p->top[p->tops++] = p->n;
        p->corner[p->n] = s->vertex[which] + j;
        p->at[p->n++] = (struct uv){a.u + t * (b.u - a.u) - in * (b.v - a.v),
                                    a.v + t * (b.v - a.v) + in * (b.u - a.u)};
    }
}

/* The part of the polygon from one corner to another. */
static void cut_part(const struct polygon *p, size_t from, size_t to, struct faces *face)
{
    struct polygon part = {.n = 0};

    for (size_t i = from;; i = (i + 1) % p->n) {
        part.corner[part.n] = p->corner[i];
        part.at[part.n++] = p->at[i];
        if (i == to)
            break;
    }
    earclip(part.at, part.corner, part.n, face);
}

/* One of those with a side that was looked at.  Cut first from crest to crest, or from the one
 * crest to the corner opposite. */
static void split_facet(struct insertion *s, size_t facet)
{
    struct polygon p = {.n = 0};
    size_t side[3];

    for (int i = 0; i < 3; i++) {
        side[i] = p.n;
        add_side(s, facet, i, &p);
    }
    if (p.n == 3) {
        *array_push(&s->face) = s->at->face.item[facet];
        return;
    }
    if (p.tops == 1) {
        int on = p.top[0] > side[2] ? 2 : p.top[0] > side[1] ? 1 : 0;
        p.top[p.tops++] = side[(on + 2) % 3];
    }
    if (p.tops == 2) {
        cut_part(&p, p.top[0], p.top[1], &s->face);
        cut_part(&p, p.top[1], p.top[0], &s->face);
    } else {
        earclip(p.at, p.corner, p.n, &s->face);
    }
}

static void split_facets(struct insertion *s)
{
    const struct sizes *facet = &s->at->facet;

    for (size_t f = 0, next = 0; f < s->mesh->face.n; f++) {
        if (next < facet->n && facet->item[next] == f)
            split_facet(s, next++);
        else
            *array_push(&s->face) = s->mesh->face.item[f];
    }
    array_free(&s->mesh->face);
    s->mesh->face = s->face;
}

size_t crest_insert(struct mesh *mesh, const struct crest_edges *at)
{
    struct insertion s = {
        .mesh = mesh, .at = at, .vertex = mem_alloc(at->edge.n, sizeof *s.vertex)};
    size_t found = 0;

    for (size_t i = 0; i < at->edge.n; i++) {
        add_vertices(&s, i);
        found += at->crest[i].n > 0;
    }
    if (found > 0)
        split_facets(&s);
    free(s.vertex);
    return found;
}
