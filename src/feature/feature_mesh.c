/* feature_mesh - see feature.h. */
#include "feature/feature.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/effort.h"
#include "feature_steps.h"
#include "base/parallel.h"
#include "math/quadric.h"

enum { NEAR = 30, MOST = 200, LOOKS = 4 };

/* So many edges in a chain are a wall; on a large mesh (EFFORT_WALLS) fewer are roughness. */
enum { CHAIN = 6, CHAIN_LARGE = 24 };

static const double TURN = 0.99452189536827333; /* cos 6 degrees between normals */
static const double OFF = 0.10452846326765347;  /* sin 6 degrees between an edge and the surface */
static const double FACING = 0.2;               /* z of a normal that is seen from above */
static const double NOISY = 0.01;               /* spacings: less noise does not matter */

struct search {
    struct mesh *mesh;
    struct mesh_edges found;
    const struct mesh_edges *edges;
    struct point_grid scan; /* what is on no wall */
    bool sorted;            /* by the caller, who frees it */
    struct kdtree *walls;   /* of the cloud; NULL: it has no walls */
    struct feature_cloud cloud;
    unsigned char *rough;  /* vertices where one quadric does not fit */
    unsigned char *active; /* look only at the edges of these vertices */
    bool walls_only;
    struct feature *feature;
};

/* The normals at the ends of an edge differ, or it leaves one of the surfaces that they are of. */
static bool surface_turns(const struct mesh *mesh, const int v[2])
{
    struct vec3 m = mesh->normal.item[v[0]], n = mesh->normal.item[v[1]];
    struct vec3 way = vec_unit(vec_sub(mesh->vertex.item[v[1]], mesh->vertex.item[v[0]]));

    return vec_dot(m, n) < TURN || fabs(vec_dot(way, m)) > OFF || fabs(vec_dot(way, n)) > OFF;
}

/* At a crease a quadric leaves much more than the noise. */
static bool is_rough(const struct search *s, size_t vertex)
{
    size_t k = feature_reach(&s->cloud) / 2;
    struct vec3 near[MOST], at = s->mesh->vertex.item[vertex];
    struct quadric q;
    size_t n = feature_near(&s->cloud, at, k < NEAR ? NEAR : k, near);

    if (quadric_fit(near, n, at, s->mesh->normal.item[vertex], &q) < 0)
        return true;
    return quadric_rms(&q, near, n) > 1.1 * s->cloud.noise + 0.004 * s->cloud.spacing;
}

static void test_vertices(void *context, size_t from, size_t to)
{
    const struct search *s = context;

    for (size_t v = from; v < to; v++)
        if (s->rough[v])
            s->rough[v] = is_rough(s, v);
}

/* Both sides of it face up. */
static bool faces_up(const struct feature *f)
{
    bool up = true;

    for (int i = 0; i < 2; i++)
        up = up && f->normal[i].z > FACING && f->end[i].z > FACING;
    return up;
}

/* Where there is none and none was, nothing is written, so that no memory is used. */
static void put_feature(struct feature *f, const struct feature *found)
{
    if (found->kind != FEATURE_NONE)
        *f = *found;
    else if (f->kind != FEATURE_NONE)
        f->kind = FEATURE_NONE;
}

static void classify_edges(void *context, size_t from, size_t to)
{
    const struct search *s = context;
    const struct mesh *m = s->mesh;

    for (size_t e = from; e < to; e++) {
        const struct mesh_edge *edge = &s->edges->edge[e];
        struct feature *f = &s->feature[e];
        int v = edge->v[0], w = edge->v[1];
        struct vec3 a = m->vertex.item[v], b = m->vertex.item[w];
        if (edge->facet[0] < 0 || (!s->active[v] && !s->active[w]))
            continue;
        struct feature found = {.kind = FEATURE_NONE};
        if (feature_steep(&s->cloud, a, b))
            found = feature_wall(&s->cloud, a, b);
        bool rough = s->rough[v] || s->rough[w];
        if (found.kind == FEATURE_NONE && !s->walls_only && rough && surface_turns(m, edge->v))
            found = feature_crease(&s->cloud, a, b, m->normal.item[v], m->normal.item[w]);
        if (found.kind != FEATURE_NONE && !faces_up(&found))
            found.kind = FEATURE_NONE;
        put_feature(f, &found);
    }
}

/* Edges that may cross a crease: on a rough scan of millions of points nearly all. */
static size_t count_doubtful(const struct search *s)
{
    size_t found = 0;
    for (size_t e = 0; e < s->edges->n; e++) {
        const struct mesh_edge *edge = &s->edges->edge[e];
        found += edge->facet[0] >= 0 && (s->rough[edge->v[0]] || s->rough[edge->v[1]]) &&
                 surface_turns(s->mesh, edge->v);
    }
    return found;
}

static struct feature_relocate relocation_of(const struct search *s)
{
    return (struct feature_relocate){s->mesh, s->edges, s->feature, s->cloud.spacing,
                                     s->cloud.noise};
}

static struct feature_mesh count_features(const struct search *s)
{
    struct feature_mesh found = {0};

    for (size_t e = 0; e < s->edges->n; e++) {
        found.creases += s->feature[e].kind == FEATURE_CREASE;
        found.walls += s->feature[e].kind == FEATURE_WALL;
    }
    return found;
}

/* Creases where the cloud has no points, as those that go on over a gap: nothing tells of them. */
static void drop_unseen(void *context, size_t from, size_t to)
{
    const struct search *s = context;

    for (size_t e = from; e < to; e++) {
        struct feature *f = &s->feature[e];
        if (f->kind == FEATURE_CREASE && !feature_has_points(&s->cloud, f->place[0]))
            f->kind = FEATURE_NONE;
    }
}

/* Looks at the edges, and again at those about what was found, for there normals are better known
 * and vertices stand off by then. */
static struct feature_mesh find_features(struct search *s, int threads)
{
    struct feature_mesh found = {0};

    for (int i = 0; i < LOOKS; i++) {
        parallel_for(threads, s->edges->n, classify_edges, s);
        feature_link_close(s->mesh, s->edges, s->feature);
        parallel_for(threads, s->edges->n, drop_unseen, s);
        found = count_features(s);
        if (found.creases + found.walls == 0)
            break;
        struct feature_relocate relocation = relocation_of(s);
        if (i + 1 < LOOKS) {
            feature_relocate_places(&relocation, s->active);
            for (size_t v = 0; v < s->mesh->vertex.n; v++)
                s->rough[v] |= s->active[v];
        }
        feature_relocate_normals(&relocation);
    }
    return found;
}

/* Only where normals turn can a crease be. */
static void mark_turns(struct search *s)
{
    const struct faces *face = &s->mesh->face;

    for (size_t f = 0; f < face->n; f++)
        for (int i = 0; i < 3; i++) {
            const int v[2] = {face->item[f].v[i], face->item[f].v[(i + 1) % 3]};
            if (surface_turns(s->mesh, v))
                s->rough[v[0]] = s->rough[v[1]] = 1;
        }
}

/* Does a side of a facet turn beside a rough vertex?  Elsewhere there is nothing to look for, and
 * no list of edges need be made. */
static bool is_doubtful(const struct search *s)
{
    const struct faces *face = &s->mesh->face;

    for (size_t f = 0; f < face->n; f++)
        for (int i = 0; i < 3; i++) {
            const int v[2] = {face->item[f].v[i], face->item[f].v[(i + 1) % 3]};
            if ((s->rough[v[0]] || s->rough[v[1]]) && surface_turns(s->mesh, v))
                return true;
        }
    return false;
}

/* Vertices whose edges are looked at. */
static void mark_active(const struct search *s, const struct feature_zone *zone)
{
    const struct vec3s *vertex = &s->mesh->vertex;

    for (size_t v = 0; v < vertex->n; v++)
        s->active[v] = !zone || feature_zone_near(zone, vertex->item[v].x, vertex->item[v].y);
}

/* Vertices and normals. */
static void copy_places(const struct mesh *from, struct mesh *to)
{
    size_t n = from->vertex.n;

    array_reserve(&to->vertex, n);
    array_reserve(&to->normal, n);
    memcpy(to->vertex.item, from->vertex.item, n * sizeof *to->vertex.item);
    memcpy(to->normal.item, from->normal.item, n * sizeof *to->normal.item);
    to->vertex.n = to->normal.n = n;
}

/* Cuts the mesh open along those features that bring it closer to the points; `before` is where
 * its vertices were. */
static struct feature_mesh keep_better(struct search *s, const struct mesh *before, size_t n,
                                       const struct vec3 *points, int threads)
{
    struct mesh *m = s->mesh, trial = {0}, whole = *before;
    double reach = 3 * s->cloud.spacing;

    copy_places(m, &trial);
    for (size_t f = 0; f < m->face.n; f++)
        *array_push(&trial.face) = m->face.item[f];
    whole.face = m->face;
    feature_cut(&trial, s->edges, s->feature);
    feature_accept(&whole, &trial, points, n, reach, s->cloud.noise, threads, s->feature,
                   s->edges->n);
    mesh_free(&trial);
    struct feature_relocate relocation = relocation_of(s);
    feature_relocate_back(&relocation, before);
    feature_cut(m, s->edges, s->feature);
    return count_features(s);
}

/* In the middle of each feature, and a third of its edge along it to either side. */
static void add_places(const struct search *s, struct vec3s *place)
{
    for (size_t e = 0; e < s->edges->n; e++) {
        const struct feature *f = &s->feature[e];
        const int *v = s->edges->edge[e].v;
        const struct vec3 *at = s->mesh->vertex.item;
        double length = vec_distance(at[v[0]], at[v[1]]);
        for (int i = -1; i <= 1 && f->kind != FEATURE_NONE; i++)
            *array_push(place) =
                vec_along(vec_mix(f->place[0], f->place[1], 0.5), i * length / 3, f->along);
    }
}

/* The search on a mesh, whose edges are not known yet. */
static void search_begin(struct search *s, struct mesh *mesh, const struct feature_scan *scan,
                         int threads)
{
    size_t n = scan->n - scan->flat;
    struct error error;

    *s =
        (struct search){.mesh = mesh,
                        .walls = n > 0 ? kdtree_new_by(scan->point + scan->flat, n, threads) : NULL,
                        .rough = mem_alloc(mesh->vertex.n, 1),
                        .active = mem_alloc(mesh->vertex.n, 1)};

    s->sorted = scan->sorted != NULL;
    if (s->sorted)
        s->scan = *scan->sorted;
    else if (point_grid_make(scan->point, scan->flat, scan->spacing, threads, &s->scan, &error) < 0)
        s->scan = (struct point_grid){.n = 0}; /* all of them are on walls */
    s->cloud = (struct feature_cloud){&s->scan, s->walls, scan->point + scan->flat, scan->spacing,
                                      scan->noise};
}

static void search_edges(struct search *s)
{
    s->found = mesh_edges_find(s->mesh);
    s->edges = &s->found;
    s->feature = mem_alloc(s->found.n, sizeof *s->feature);
}

static void search_end(struct search *s)
{
    mesh_edges_free(&s->found);
    free(s->rough);
    free(s->active);
    free(s->feature);
    if (!s->sorted)
        point_grid_free(&s->scan);
    if (s->walls)
        kdtree_free(s->walls);
}

static void find_walls(void *context, size_t from, size_t to)
{
    const struct search *s = context;
    const struct vec3 *at = s->mesh->vertex.item;

    for (size_t e = from; e < to; e++) {
        const int *v = s->edges->edge[e].v;
        if (s->edges->edge[e].facet[0] < 0 || !feature_steep(&s->cloud, at[v[0]], at[v[1]]))
            continue;
        struct feature found = feature_wall(&s->cloud, at[v[0]], at[v[1]]);
        put_feature(&s->feature[e], &found);
    }
}

/* Looks at all edges for walls, once; no chain of them that is long enough: none. */
static struct feature_walls look_for_walls(struct search *s, double effort, int threads)
{
    struct feature_walls walls = {.found = 0};

    parallel_for(threads, s->edges->n, find_walls, s);
    size_t longest = feature_link_longest(s->edges, s->feature);
    if (effort_covers(EFFORT_WALLS, effort, s->edges->n) || longest >= CHAIN_LARGE)
        walls.found = longest >= CHAIN ? count_features(s).walls : 0;
    else if (longest >= CHAIN)
        walls.edges = s->edges->n;
    return walls;
}

struct feature_walls feature_mesh_walls(const struct mesh *mesh, const struct feature_scan *scan,
                                        double effort, int threads)
{
    struct feature_walls walls = {.found = 0};

    if (scan->flat >= scan->n || mesh->face.n == 0)
        return walls;
    struct mesh same = *mesh; /* which stays as it is */
    struct search s;
    search_begin(&s, &same, scan, threads);
    search_edges(&s);
    walls = look_for_walls(&s, effort, threads);
    search_end(&s);
    return walls;
}

/* Lines closed, and the mesh cut open where that is better. */
static size_t cut_walls(struct search *s, const struct feature_scan *scan, int threads)
{
    struct mesh before = {0};

    copy_places(s->mesh, &before);
    for (size_t e = 0; e < s->edges->n; e++)
        if (s->feature[e].kind != FEATURE_NONE && !faces_up(&s->feature[e]))
            s->feature[e].kind = FEATURE_NONE;
    feature_link_close(s->mesh, s->edges, s->feature);
    struct feature_relocate relocation = relocation_of(s);
    feature_relocate_normals(&relocation);
    size_t kept = keep_better(s, &before, scan->n, scan->point, threads).walls;
    array_free(&before.vertex);
    array_free(&before.normal);
    return kept;
}

struct feature_walls feature_mesh_try_walls(struct mesh *mesh, const struct feature_scan *scan,
                                            double effort, int threads)
{
    struct feature_walls walls = {.found = 0};

    if (scan->flat >= scan->n || mesh->face.n == 0)
        return walls;
    struct search s;
    search_begin(&s, mesh, scan, threads);
    search_edges(&s);
    walls = look_for_walls(&s, effort, threads);
    if (walls.found > 0)
        walls.found = cut_walls(&s, scan, threads);
    search_end(&s);
    return walls;
}

struct feature_mesh feature_mesh_keep(struct mesh *mesh, const struct feature_scan *scan,
                                      double effort, int threads)
{
    struct search s;
    struct mesh before = {0};
    struct feature_mesh found = {0};

    search_begin(&s, mesh, scan, threads);
    mark_turns(&s);
    parallel_for(threads, mesh->vertex.n, test_vertices, &s);
    if (!s.walls && !is_doubtful(&s)) {
        search_end(&s);
        return found;
    }
    search_edges(&s);
    copy_places(mesh, &before);
    mark_active(&s, scan->zone);
    size_t doubtful = count_doubtful(&s);
    s.walls_only = !effort_covers(EFFORT_CREASES, effort, doubtful);
    if ((!s.walls_only && doubtful > 0) || s.walls)
        found = find_features(&s, threads);
    struct feature_relocate relocation = relocation_of(&s);
    if (found.creases + found.walls > 0 && scan->noise > NOISY * scan->spacing)
        feature_relocate_feet(&relocation);
    if (found.creases + found.walls > 0)
        found = keep_better(&s, &before, scan->n, scan->point, threads);
    else
        feature_relocate_back(&relocation, &before);
    add_places(&s, &found.place);
    found.doubtful = doubtful;
    array_free(&before.vertex);
    array_free(&before.normal);
    search_end(&s);
    return found;
}
