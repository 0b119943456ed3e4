/* crest_mesh - see feature.h: crest_mesh_keep. */
#include <stdbool.h>
#include <stdlib.h>

#include "base/parallel.h"
#include "feature/feature.h"
#include "feature_steps.h"

enum { LOOKS = 3 };

static const double TURN = 0.99452189536827333; /* cos 6 degrees between normals */
static const double OFF = 0.10452846326765347;  /* sin 6 degrees between an edge and the surface */
static const double LONG = 4.5;                 /* mean spacings */
static const double CLOSE = 0.25;               /* mean spacings: the corner opposite lies on it */

struct search {
    struct mesh *mesh;
    const struct crest_mesh_options *options;
    struct vec3 *point; /* of the cloud, which get sorted */
    size_t points;
    struct point_grid scan; /* these, once they are needed */
    struct feature_cloud cloud;
    struct crest_edges at; /* the edges that are looked at, and what is over them */
    size_t first, last;    /* vertices of creases and walls, and those from there on are new */
    size_t most, looked;   /* edges that may be looked at in all; that were */
    size_t widest;         /* facets that the mesh had, in the look when it had most */
    bool all;              /* edges may cut off a crest, wherever they are */
    bool bound;            /* there were more */
    size_t fresh; /* those from there on are of the last look: other edges were looked at */
};

/* ---- which edges */

/* On a small mesh all may. */
static bool may_cross(const struct search *s, int v, int w)
{
    const struct vec3 *n = s->mesh->normal.item, *p = s->mesh->vertex.item;
    struct vec3 way = vec_sub(p[w], p[v]);
    double length = vec_length(way);

    return s->all || vec_dot(n[v], n[w]) < TURN || length > LONG * s->cloud.spacing ||
           fabs(vec_dot(way, n[v])) > OFF * length || fabs(vec_dot(way, n[w])) > OFF * length;
}

/* The facets with such a side: edges are made of these alone, for smooth ground has none. */
static void choose_facets(struct search *s)
{
    s->at.face.n = s->at.facet.n = 0;
    for (size_t f = 0; f < s->mesh->face.n; f++) {
        const int *v = s->mesh->face.item[f].v;
        if (!may_cross(s, v[0], v[1]) && !may_cross(s, v[1], v[2]) && !may_cross(s, v[2], v[0]))
            continue;
        *array_push(&s->at.face) = s->mesh->face.item[f];
        *array_push(&s->at.facet) = f;
    }
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

/* The corner opposite the edge in a facet beside it. */
static int corner_opposite(const struct search *s, const struct mesh_edge *e, int facet)
{
    const int *v = s->at.face.item[facet].v;

    return v[0] ^ v[1] ^ v[2] ^ e->v[0] ^ e->v[1];
}

/* The corner opposite, on one side, lies so close to the edge that a point put on the edge may come
 * to lie beyond it, and fold the facet over: it is on the crest by now. */
static bool is_taken(const struct search *s, const struct mesh_edge *e)
{
    const struct vec3 *p = s->mesh->vertex.item;
    double close = CLOSE * s->cloud.spacing;

    for (int i = 0; i < 2 && e->facet[i] >= 0; i++) {
        struct vec3 at = p[corner_opposite(s, e, e->facet[i])];
        if (vec_distance(at, vec_segment_nearest(p[e->v[0]], p[e->v[1]], at)) < close)
            return true;
    }
    return false;
}

static void choose_edges(struct search *s)
{
    s->at.edge.n = 0;
    for (size_t e = 0; e < s->at.edges->n; e++) {
        const struct mesh_edge *edge = &s->at.edges->edge[e];
        s->at.of[e] = -1;
        if (!is_free(s, edge) || !may_cross(s, edge->v[0], edge->v[1]) || is_taken(s, edge))
            continue;
        s->at.of[e] = (int)s->at.edge.n;
        *array_push(&s->at.edge) = e;
    }
}

/* ---- what is over them */

/* The normal of the neighbourhood of an edge: the mean of those of its ends and of the corners
 * opposite. */
static struct vec3 normal_about(const struct search *s, const struct mesh_edge *e)
{
    const struct vec3 *normal = s->mesh->normal.item;
    struct vec3 sum = vec_add(normal[e->v[0]], normal[e->v[1]]);

    for (int i = 0; i < 2 && e->facet[i] >= 0; i++)
        sum = vec_add(sum, normal[corner_opposite(s, e, e->facet[i])]);
    return vec_unit(sum);
}

static void find_crests(void *context, size_t from, size_t to)
{
    const struct search *s = context;
    const struct vec3 *p = s->mesh->vertex.item;

    for (size_t i = from; i < to; i++) {
        const struct mesh_edge *e = &s->at.edges->edge[s->at.edge.item[i]];
        s->at.crest[i] = crest_find(&s->cloud, p[e->v[0]], p[e->v[1]], normal_about(s, e));
    }
}

/* The points are sorted when it is needed. */
static void sort_points(struct search *s)
{
    struct error error;

    if (!s->scan.first && point_grid_make(s->point, s->points, s->options->spacing,
                                          s->options->threads, &s->scan, &error) < 0)
        s->scan = (struct point_grid){.n = 0};
}

/* Finds the crests over the edges that were chosen, and puts them into the mesh; returns how many
 * edges got one. */
static size_t look_at_edges(struct search *s)
{
    sort_points(s);
    s->at.crest = mem_alloc(s->at.edge.n, sizeof *s->at.crest);
    parallel_for(s->options->threads, s->at.edge.n, find_crests, s);
    size_t found = crest_insert(s->mesh, &s->at);
    free(s->at.crest);
    return found;
}

/* Looks once at the edges of the vertices from `fresh` on. */
static size_t search_once(struct search *s, size_t fresh)
{
    size_t facets = s->mesh->face.n, found = 0;

    s->fresh = fresh;
    s->widest = facets > s->widest ? facets : s->widest;
    s->all = effort_covers(EFFORT_CREST_FACETS, s->options->effort, facets);
    choose_facets(s);
    if (s->at.face.n == 0)
        return 0;
    struct mesh part = {.vertex = s->mesh->vertex, .face = s->at.face};
    struct mesh_edges edges = mesh_edges_find(&part);
    s->at.edges = &edges;
    s->at.of = mem_alloc(edges.n, sizeof *s->at.of);
    choose_edges(s);
    s->looked += s->at.edge.n;
    s->bound = s->looked > s->most;
    if (s->at.edge.n > 0 && !s->bound)
        found = look_at_edges(s);
    free(s->at.of);
    mesh_edges_free(&edges);
    s->at.edges = NULL;
    return found;
}

struct crests crest_mesh_keep(struct mesh *mesh, size_t first, struct vec3 *point, size_t n,
                              const struct crest_mesh_options *options)
{
    bool large = !effort_covers(EFFORT_CREST_POINTS, options->effort, n);
    struct crests all = {.bound = large ? EFFORT_CRESTS_LARGE : EFFORT_CRESTS};
    struct search s = {.mesh = mesh,
                       .options = options,
                       .point = point,
                       .points = n,
                       .cloud = {.spacing = options->spacing, .noise = options->noise},
                       .first = first,
                       .last = mesh->vertex.n,
                       .most = effort_most(all.bound, options->effort)};
    size_t fresh = 0, found = 1;

    s.cloud.scan = &s.scan;
    if (options->sorted)
        s.scan = *options->sorted;
    /* the edges between new points may cut off the crest where one is missing */
    for (int i = 0; i < LOOKS && found > 0; i++) {
        size_t next = mesh->vertex.n;
        found = search_once(&s, fresh);
        all.found += found;
        fresh = next;
    }
    all.facets = s.widest;
    all.wanted = s.bound ? s.looked : 0;
    if (!options->sorted)
        point_grid_free(&s.scan);
    array_free(&s.at.edge);
    array_free(&s.at.face);
    array_free(&s.at.facet);
    return all;
}
