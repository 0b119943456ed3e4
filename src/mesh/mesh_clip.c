/* mesh_clip - see mesh_clip.h. */
#include "mesh/mesh_clip.h"

#include <stdlib.h>

#include "mesh/mesh_edges.h"

enum { NONE = -1 };

/* One cut: what is kept has a value of 0 and above. */
struct clip {
    bool both; /* keep what is below, too: facets are split alone */
    struct mesh *mesh;
    struct mesh_edges edges;
    double *value;                /* of each vertex */
    int *on;                      /* of each edge: the vertex where the value is 0, or NONE */
    const struct vec3 *direction; /* of a plane ... */
    double at;                    /* ... and its height; NULL: the value is mixed */
};

static void add_vertex(struct mesh *mesh, struct vec3 p, struct vec3 normal, double kmax)
{
    bool has_kmax = mesh->kmax.n == mesh->vertex.n;

    *array_push(&mesh->vertex) = p;
    *array_push(&mesh->normal) = normal;
    if (has_kmax)
        *array_push(&mesh->kmax) = kmax;
}

/* The vertex on an edge with one end on either side. */
static int vertex_on(struct clip *c, int edge)
{
    struct mesh *mesh = c->mesh;
    const int *v = c->edges.edge[edge].v;

    if (c->on[edge] != NONE)
        return c->on[edge];
    bool rises = c->value[v[0]] < c->value[v[1]];
    int low = rises ? v[0] : v[1], high = rises ? v[1] : v[0];
    struct vec3 n = mesh->normal.item[low], m = mesh->normal.item[high];
    struct edge_curve curve = mesh_edge_curve(mesh, low, high);
    double s = c->value[low] / (c->value[low] - c->value[high]);
    if (c->direction)
        s = edge_curve_crossing(&curve, *c->direction, c->at);
    struct vec3 p = edge_curve_at(&curve, s);
    if (c->direction)
        p = vec_along(p, c->at - vec_dot(p, *c->direction), *c->direction);
    double kmax = 0;
    if (mesh->kmax.n == mesh->vertex.n)
        kmax = (1 - s) * mesh->kmax.item[low] + s * mesh->kmax.item[high];
    add_vertex(mesh, p, vec_unit(vec_mix(n, m, s)), kmax);
    return c->on[edge] = (int)mesh->vertex.n - 1;
}

/* The corners of what is kept of a facet, or of what is below: none, three or four. */
static int clip_facet(struct clip *c, size_t facet, bool below, int corner[4])
{
    struct face f = c->mesh->face.item[facet];
    int n = 0;

    for (int i = 0; i < 3; i++) {
        bool in = (c->value[f.v[i]] >= 0) != below;
        bool next_in = (c->value[f.v[(i + 1) % 3]] >= 0) != below;
        if (in)
            corner[n++] = f.v[i];
        if (in != next_in)
            corner[n++] = vertex_on(c, c->edges.of[facet][i]);
    }
    return n;
}

static void clip_all(struct clip *c)
{
    struct mesh *mesh = c->mesh;
    struct faces face = {0};
    struct ints surface = {0};
    bool surfaces = mesh->surface.n == mesh->face.n;
    int corner[4];

    c->edges = mesh_edges_find(mesh);
    c->on = mem_alloc(c->edges.n + 1, sizeof *c->on);
    for (size_t e = 0; e < c->edges.n; e++)
        c->on[e] = NONE;
    for (size_t k = 0; k < mesh->face.n * (c->both ? 2 : 1); k++) {
        size_t f = c->both ? k / 2 : k;
        int n = clip_facet(c, f, c->both && k % 2 == 1, corner);
        for (int i = 2; i < n; i++) {
            *array_push(&face) = (struct face){{corner[0], corner[i - 1], corner[i]}};
            if (surfaces)
                *array_push(&surface) = mesh->surface.item[f];
        }
    }
    array_free(&mesh->face);
    array_free(&mesh->surface);
    mesh->face = face;
    mesh->surface = surface;
    mesh_edges_free(&c->edges);
    free(c->on);
    free(c->value);
}

void mesh_clip_plane(struct mesh *mesh, struct vec3 direction, double at)
{
    struct clip c = {.mesh = mesh, .direction = &direction, .at = at};

    c.value = mem_alloc(mesh->vertex.n + 1, sizeof *c.value);
    for (size_t v = 0; v < mesh->vertex.n; v++)
        c.value[v] = vec_dot(mesh->vertex.item[v], direction) - at;
    clip_all(&c);
}

/* Some facet of the mesh is near a segment, seen along z. */
static bool is_near(const struct mesh *mesh, struct vec3 a, struct vec3 b)
{
    double x0 = fmin(a.x, b.x), x1 = fmax(a.x, b.x), y0 = fmin(a.y, b.y), y1 = fmax(a.y, b.y);
    for (size_t f = 0; f < mesh->face.n; f++) {
        const int *v = mesh->face.item[f].v;
        const struct vec3 *p = mesh->vertex.item;
        if (fmax(p[v[0]].x, fmax(p[v[1]].x, p[v[2]].x)) >= x0 &&
            fmin(p[v[0]].x, fmin(p[v[1]].x, p[v[2]].x)) <= x1 &&
            fmax(p[v[0]].y, fmax(p[v[1]].y, p[v[2]].y)) >= y0 &&
            fmin(p[v[0]].y, fmin(p[v[1]].y, p[v[2]].y)) <= y1)
            return true;
    }
    return false;
}

/* Splits all facets along the upright plane through a segment, which is moved by less than a
 * thousandth of a micrometre where a vertex would lie in it. */
static void split_along(struct mesh *mesh, struct vec3 a, struct vec3 b)
{
    const double aside = 1e-8;
    enum { TRIES = 50 };
    struct vec3 direction = vec_unit(vec(b.y - a.y, a.x - b.x, 0));
    struct clip c = {.mesh = mesh, .direction = &direction, .at = vec_dot(a, direction)};
    bool met = true;

    c.both = true;
    c.value = mem_alloc(mesh->vertex.n + 1, sizeof *c.value);
    for (int i = 0; met && i < TRIES; i++) {
        met = false;
        for (size_t v = 0; v < mesh->vertex.n; v++) {
            c.value[v] = vec_dot(mesh->vertex.item[v], direction) - c.at;
            met = met || fabs(c.value[v]) < aside;
        }
        if (met)
            c.at += 2.1 * aside;
    }
    clip_all(&c);
}

void mesh_clip_polygons(struct mesh *mesh, const struct region_polygons *polygons)
{
    bool surfaces = mesh->surface.n == mesh->face.n;
    size_t n = 0;

    for (size_t k = 0; k < polygons->from.n; k++) {
        size_t from = (size_t)polygons->from.item[k], end = region_polygons_end(polygons, k);
        for (size_t i = from; i < end; i++) {
            struct vec3 a = polygons->corner.item[i];
            struct vec3 b = polygons->corner.item[i + 1 < end ? i + 1 : from];
            if (vec_distance(a, b) > 0 && is_near(mesh, a, b))
                split_along(mesh, a, b);
        }
    }
    for (size_t f = 0; f < mesh->face.n; f++) {
        const int *v = mesh->face.item[f].v;
        const struct vec3 *p = mesh->vertex.item;
        struct vec3 middle = vec_scale(1.0 / 3, vec_add(p[v[0]], vec_add(p[v[1]], p[v[2]])));
        if (!region_polygons_hold(polygons, middle))
            continue;
        if (surfaces)
            mesh->surface.item[n] = mesh->surface.item[f];
        mesh->face.item[n++] = mesh->face.item[f];
    }
    mesh->face.n = n;
    if (surfaces)
        mesh->surface.n = n;
}

/* Where the cosine is on this side of a limit: `way` 1 not below, -1 not above. */
static void clip_cosine(struct mesh *mesh, struct vec3 up, double limit, double way)
{
    const double slack = 1e-9; /* of a cosine: level is level */
    struct clip c = {.mesh = mesh};

    c.value = mem_alloc(mesh->vertex.n + 1, sizeof *c.value);
    for (size_t v = 0; v < mesh->vertex.n; v++)
        c.value[v] = way * (vec_dot(mesh->normal.item[v], up) - limit) + slack;
    clip_all(&c);
}

void mesh_clip_steep(struct mesh *mesh, struct vec3 up, double least, double most)
{
    if (least > 0)
        clip_cosine(mesh, up, cos(least), -1);
    clip_cosine(mesh, up, cos(most), 1);
}

void mesh_clip_surfaces(struct mesh *mesh, const bool *keep)
{
    size_t n = 0;

    for (size_t f = 0; f < mesh->face.n; f++) {
        if (!keep[mesh->surface.item[f]])
            continue;
        mesh->surface.item[n] = mesh->surface.item[f];
        mesh->face.item[n++] = mesh->face.item[f];
    }
    mesh->face.n = mesh->surface.n = n;
}

void mesh_clip_marked(struct mesh *mesh, const bool *out)
{
    size_t n = 0;
    bool surfaces = mesh->surface.n == mesh->face.n;

    for (size_t f = 0; f < mesh->face.n; f++) {
        if (out[f])
            continue;
        if (surfaces)
            mesh->surface.item[n] = mesh->surface.item[f];
        mesh->face.item[n++] = mesh->face.item[f];
    }
    mesh->face.n = n;
    mesh->surface.n = surfaces ? n : 0;
}

void mesh_clip_unused(struct mesh *mesh)
{
    int *name = mem_alloc(mesh->vertex.n + 1, sizeof *name), n = 0;
    bool kmax = mesh->kmax.n == mesh->vertex.n, rows = mesh->row.n == mesh->vertex.n;

    for (size_t i = 0; i < 3 * mesh->face.n; i++)
        name[mesh->face.item[i / 3].v[i % 3]] = 1;
    for (size_t v = 0; v < mesh->vertex.n; v++) {
        if (name[v] == 0)
            continue;
        mesh->vertex.item[n] = mesh->vertex.item[v];
        mesh->normal.item[n] = mesh->normal.item[v];
        if (kmax)
            mesh->kmax.item[n] = mesh->kmax.item[v];
        if (rows) {
            mesh->row.item[n] = mesh->row.item[v];
            mesh->col.item[n] = mesh->col.item[v];
        }
        name[v] = n++;
    }
    for (size_t i = 0; i < 3 * mesh->face.n; i++)
        mesh->face.item[i / 3].v[i % 3] = name[mesh->face.item[i / 3].v[i % 3]];
    mesh->vertex.n = mesh->normal.n = (size_t)n;
    mesh->kmax.n = kmax ? (size_t)n : 0;
    mesh->row.n = mesh->col.n = rows ? (size_t)n : 0;
    free(name);
}

struct mesh mesh_clip_copy(const struct mesh *mesh)
{
    struct mesh copy = {.origin = {.ledger = NAN}};
    bool surfaces = mesh->surface.n == mesh->face.n, kmax = mesh->kmax.n == mesh->vertex.n;

    for (size_t v = 0; v < mesh->vertex.n; v++) {
        *array_push(&copy.vertex) = mesh->vertex.item[v];
        *array_push(&copy.normal) = mesh->normal.item[v];
        if (kmax)
            *array_push(&copy.kmax) = mesh->kmax.item[v];
    }
    for (size_t f = 0; f < mesh->face.n; f++) {
        *array_push(&copy.face) = mesh->face.item[f];
        if (surfaces)
            *array_push(&copy.surface) = mesh->surface.item[f];
    }
    return copy;
}
