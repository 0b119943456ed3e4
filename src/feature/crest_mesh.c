/* crest_mesh - see crest_mesh.h. */
#include "feature/crest_mesh.h"

#include <stdlib.h>

#include "crest.h"
#include "math/earclip.h"
#include "mesh/mesh_edges.h"
#include "base/parallel.h"

enum { LOOKS = 3, CORNERS = 3 * (CREST_MOST + 1) };

static const double TURN = 0.99452189536827333; /* cos 6 degrees between normals */
static const double OFF = 0.10452846326765347;  /* sin 6 degrees between an edge and the surface */
static const double LONG = 4.5;                 /* mean spacings */

struct search {
    struct mesh *mesh;
    const struct mesh_edges *edges;
    struct feature_cloud cloud;
    size_t first, last;  /* vertices of creases and walls, and those from there on are new */
    size_t most, looked; /* edges that may be looked at in all; that were */
    size_t widest;       /* edges that the mesh had, in the look when it had most */
    bool all;            /* edges may cut off a crest, wherever they are */
    bool bound;          /* there were more */
    size_t fresh;        /* those from there on are of the last look: other edges were looked at */
    struct sizes edge;   /* to be looked at */
    struct crest *crest; /* of each of those */
    int *of;             /* which one each edge of the mesh is, -1: none */
    int *vertex;         /* the first new one of each */
    struct faces face;   /* what comes of the facets */
};

/* On a small mesh all may. */
static bool may_cross(const struct search *s, const struct mesh_edge *e)
{
    const struct vec3 *n = s->mesh->normal.item, *p = s->mesh->vertex.item;

    struct vec3 way = vec_sub(p[e->v[1]], p[e->v[0]]);
    double length = vec_length(way);

    return s->all || vec_dot(n[e->v[0]], n[e->v[1]]) < TURN || length > LONG * s->cloud.spacing ||
           fabs(vec_dot(way, n[e->v[0]])) > OFF * length ||
           fabs(vec_dot(way, n[e->v[1]])) > OFF * length;
}

/* Neither of a crease or wall, nor put into a row that has points between its own by now. */
static bool is_free(const struct search *s, const struct mesh_edge *e)
{
    const struct ints *row = &s->mesh->row;
    bool along = row->n > 0 && row->item[e->v[0]] >= 0 && row->item[e->v[0]] == row->item[e->v[1]];

    for (int i = 0; i < 2; i++) {
        size_t v = (size_t)e->v[i];
        if (v >= s->first && (v < s->last || along))
            return false;
    }
    return e->facet[0] >= 0 && (size_t)e->v[1] >= s->fresh;
}

static void choose_edges(struct search *s)
{
    for (size_t e = 0; e < s->edges->n; e++) {
        const struct mesh_edge *edge = &s->edges->edge[e];
        s->of[e] = -1;
        if (!is_free(s, edge) || !may_cross(s, edge))
            continue;
        s->of[e] = (int)s->edge.n;
        *array_push(&s->edge) = e;
    }
}

static void look(void *context, size_t from, size_t to)
{
    const struct search *s = context;
    const struct vec3 *at = s->mesh->vertex.item;

    for (size_t i = from; i < to; i++) {
        const int *v = s->edges->edge[s->edge.item[i]].v;
        s->crest[i] = crest_find(&s->cloud, at[v[0]], at[v[1]]);
    }
}

static void add_vertices(struct search *s, size_t i)
{
    struct mesh *m = s->mesh;
    const int *v = s->edges->edge[s->edge.item[i]].v;
    const struct crest *c = &s->crest[i];
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

static void add_side(const struct search *s, size_t facet, int i, struct polygon *p)
{
    const double inwards = 1e-3, height = 0.86602540378443865;
    const struct uv plane[3] = {{0, 0}, {1, 0}, {0.5, height}};
    struct uv a = plane[i], b = plane[(i + 1) % 3];
    int e = s->edges->of[facet][i], which = s->of[e];
    const struct crest *c = which < 0 ? NULL : &s->crest[which];
    bool forth = s->mesh->face.item[facet].v[i] == s->edges->edge[e].v[0];

    p->corner[p->n] = s->mesh->face.item[facet].v[i];
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

/* Cut first from crest to crest, or from the one crest to the corner opposite. */
static void split_facet(struct search *s, size_t facet)
{
    struct polygon p = {.n = 0};
    size_t side[3];

    for (int i = 0; i < 3; i++) {
        side[i] = p.n;
        add_side(s, facet, i, &p);
    }
    if (p.n == 3) {
        *array_push(&s->face) = s->mesh->face.item[facet];
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

static size_t put_in(struct search *s)
{
    size_t found = 0;

    for (size_t i = 0; i < s->edge.n; i++) {
        add_vertices(s, i);
        found += s->crest[i].n > 0;
    }
    for (size_t f = 0; f < s->mesh->face.n && found > 0; f++)
        split_facet(s, f);
    if (found > 0) {
        array_free(&s->mesh->face);
        s->mesh->face = s->face;
        s->face = (struct faces){0};
    }
    return found;
}

/* Looks once at the edges of the vertices from `fresh` on.  The tree is made when it is needed. */
static size_t look_once(struct search *s, size_t fresh, size_t n, struct kdtree **tree,
                        const struct crest_mesh_options *options)
{
    struct mesh_edges edges = mesh_edges_find(s->mesh);
    size_t found = 0;

    s->edges = &edges;
    s->widest = edges.n > s->widest ? edges.n : s->widest;
    s->all = effort_covers(EFFORT_CREST_EDGES, options->effort, edges.n);
    s->of = mem_alloc(edges.n, sizeof *s->of);
    s->fresh = fresh;
    s->edge.n = s->face.n = 0;
    choose_edges(s);
    s->looked += s->edge.n;
    s->bound = s->looked > s->most;
    if (s->edge.n > 0 && !s->bound) {
        *tree = *tree ? *tree : kdtree_new_by(s->cloud.point, n, options->threads);
        s->cloud.tree = *tree;
        s->crest = mem_alloc(s->edge.n, sizeof *s->crest);
        s->vertex = mem_alloc(s->edge.n, sizeof *s->vertex);
        parallel_for(options->threads, s->edge.n, look, s);
        found = put_in(s);
        free(s->crest);
        free(s->vertex);
    }
    free(s->of);
    mesh_edges_free(&edges);
    return found;
}

struct crests crest_mesh_keep(struct mesh *mesh, size_t first, const struct vec3 *point, size_t n,
                              const struct crest_mesh_options *options)
{
    bool large = !effort_covers(EFFORT_CREST_POINTS, options->effort, n);
    struct crests all = {.bound = large ? EFFORT_CRESTS_LARGE : EFFORT_CRESTS};
    struct search s = {
        .mesh = mesh,
        .cloud = {.point = point, .spacing = options->spacing, .noise = options->noise},
        .first = first,
        .last = mesh->vertex.n,
        .most = effort_most(all.bound, options->effort)};
    struct kdtree *tree = NULL;
    size_t fresh = 0, found = 1;

    /* the edges between new points may cut off the crest where one is missing */
    for (int i = 0; i < LOOKS && found > 0; i++) {
        size_t next = mesh->vertex.n;
        found = look_once(&s, fresh, n, &tree, options);
        all.found += found;
        fresh = next;
    }
    all.edges = s.widest;
    all.wanted = s.bound ? s.looked : 0;
    if (tree)
        kdtree_free(tree);
    array_free(&s.edge);
    return all;
}
