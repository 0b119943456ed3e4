/* guard_mesh - see guard_mesh.h. */
#include "gouge/guard_mesh.h"

#include <stdlib.h>
#include <string.h>

#include "base/parallel.h"
#include "curve/edge_curve.h"
#include "mesh/mesh_weld.h"

/* A facet further than this off a vertex's normal spans a step, not a smooth surface. */
static const double SMOOTH = 0.8660254037844386; /* cos 30 degrees */

/* A curved triangle: control points of a cubic Bezier triangle, named after their corners. */
struct patch {
    struct vec3 corner[3];
    struct vec3 edge[3][2]; /* edge[i]: from corner i to the next, nearer to i first */
    struct vec3 middle;
    bool flat;
    bool shared[3]; /* the edge is sampled with the patch on its other side */
    double below;   /* the facet counts where it is further than this above; HUGE_VAL: nowhere */
    struct vec3 normal[3];
};

static struct patch patch_of(const struct vec3 *p, const struct vec3 *normal, bool flat)
{
    struct patch patch = {.flat = flat};
    struct vec3 corners = vec(0, 0, 0), edges = vec(0, 0, 0);

    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        patch.corner[i] = p[i];
        patch.edge[i][0] = flat ? vec_mix(p[i], p[j], 1 / 3.0) : edge_handle(p[i], normal[i], p[j]);
        patch.edge[i][1] = flat ? vec_mix(p[j], p[i], 1 / 3.0) : edge_handle(p[j], normal[j], p[i]);
        corners = vec_add(corners, p[i]);
        edges = vec_add(edges, vec_add(patch.edge[i][0], patch.edge[i][1]));
    }
    /* E + (E - V) / 2: the patch holds a quadratic surface exactly. */
    patch.middle = vec_along(vec_scale(0.25, edges), -1 / 6.0, corners);
    return patch;
}

/* The point with barycentric coordinates b[0..2]. */
static struct vec3 patch_at(const struct patch *patch, const double b[3])
{
    struct vec3 sum = vec_scale(6 * b[0] * b[1] * b[2], patch->middle);

    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        sum = vec_along(sum, b[i] * b[i] * b[i], patch->corner[i]);
        sum = vec_along(sum, 3 * b[i] * b[i] * b[j], patch->edge[i][0]);
        sum = vec_along(sum, 3 * b[i] * b[j] * b[j], patch->edge[i][1]);
    }
    return sum;
}

/* The same, or the place on the facet, or `below` it, where that is above. */
static struct vec3 upper_at(const struct patch *patch, const double b[3])
{
    struct vec3 curved = patch_at(patch, b), flat = vec(0, 0, 0), up = vec(0, 0, 0);

    for (int i = 0; i < 3; i++) {
        flat = vec_along(flat, b[i], patch->corner[i]);
        up = vec_along(up, b[i], patch->normal[i]);
    }
    flat = vec_along(flat, -patch->below, vec_unit(up));
    return vec_dot(vec_sub(flat, curved), up) > 0 ? flat : curved;
}

/* How a patch is sampled: on a triangular raster; a slender one on rows along its longest edge,
 * each with points of its own number. */
struct raster {
    int cells;   /* along the longest edge */
    int rows;    /* 0: as many as cells */
    int longest; /* edge from this corner on */
    double length, spacing;
};

static struct raster raster_of(const struct patch *patch, double spacing)
{
    const double most = 100000, slender = 0.25;
    struct raster r = {.spacing = spacing};

    for (int i = 0; i < 3; i++) {
        double length = vec_distance(patch->corner[i], patch->corner[(i + 1) % 3]);
        if (length > r.length) {
            r.length = length;
            r.longest = i;
        }
    }
    r.cells = (int)fmin(ceil(r.length / spacing), most);
    double height = vec_line_distance(patch->corner[r.longest], patch->corner[(r.longest + 1) % 3],
                                      patch->corner[(r.longest + 2) % 3]);
    if (height < slender * r.length)
        r.rows = (int)fmax(1, fmin(ceil(height / spacing), most));
    return r;
}

/* Cells of one row of a slender patch, of those from 0 on its longest edge. */
static int cells_of_row(const struct raster *r, int row)
{
    double length = r->length * (1 - (double)row / r->rows);

    return (int)fmax(1, fmin(ceil(length / r->spacing), r->cells));
}

static double raster_count(const struct raster *r)
{
    double sum = 0;

    if (r->rows == 0)
        return (r->cells + 1.0) * (r->cells + 2.0) / 2 - 3;
    for (int i = 0; i < r->rows; i++)
        sum += cells_of_row(r, i) + 1.0;
    return sum - 2;
}

/* The place with these barycentric coordinates, unless another patch has it. */
static void sample_at(const struct patch *patch, const double b[3], struct vec3s *points)
{
    for (int i = 0; i < 3; i++) {
        if (b[i] <= 0 && patch->shared[(i + 1) % 3])
            return;
    }
    *array_push(points) = patch->below < HUGE_VAL ? upper_at(patch, b) : patch_at(patch, b);
}

static void sample_rows(const struct patch *patch, const struct raster *r, struct vec3s *points)
{
    for (int i = 0; i < r->rows; i++) {
        int cells = cells_of_row(r, i);
        double up = (double)i / r->rows;
        for (int j = i == 0; j <= cells - (i == 0); j++) {
            double b[3], along = (double)j / cells;
            b[r->longest] = (1 - up) * (1 - along);
            b[(r->longest + 1) % 3] = (1 - up) * along;
            b[(r->longest + 2) % 3] = up;
            sample_at(patch, b, points);
        }
    }
}

/* All points of the patch but its corners and shared edges, no further apart than the raster says.
 */
static void patch_sample(const struct patch *patch, const struct raster *r, struct vec3s *points)
{
    int cells = r->cells;

    if (r->rows > 0) {
        sample_rows(patch, r, points);
        return;
    }
    for (int i = 0; i <= cells; i++) {
        for (int j = 0; j <= cells - i; j++) {
            int k = cells - i - j;
            if (i == cells || j == cells || k == cells)
                continue;
            double b[3] = {(double)i / cells, (double)j / cells, (double)k / cells};
            sample_at(patch, b, points);
        }
    }
}

static bool is_flat(const struct mesh *mesh, size_t facet)
{
    struct vec3 across = vec_unit(mesh_face_cross(mesh, facet));
    bool flat = false;

    for (int i = 0; i < 3; i++)
        flat = flat || vec_dot(mesh->normal.item[mesh->face.item[facet].v[i]], across) < SMOOTH;
    return flat;
}

static struct patch patch_of_facet(const struct mesh *mesh, size_t facet, enum guard_facets facets)
{
    struct vec3 p[3], normal[3];

    for (int i = 0; i < 3; i++) {
        int v = mesh->face.item[facet].v[i];
        p[i] = mesh->vertex.item[v];
        normal[i] = mesh->normal.item[v];
    }
    return patch_of(p, normal, facets == GUARD_FLAT || is_flat(mesh, facet));
}

/* The raster of a facet's patch, for which its corners are enough. */
static struct raster raster_of_facet(const struct mesh *mesh, size_t facet, double spacing)
{
    struct patch patch = {.edge = {{{0}}}};

    for (int i = 0; i < 3; i++)
        patch.corner[i] = mesh->vertex.item[mesh->face.item[facet].v[i]];
    return raster_of(&patch, spacing);
}

/* Which edges of a facet have points along them, a bit each: of a slender one, which has rows along
 * its longest, that alone, and of one that is sampled flat, whose edges are its own, none.  And
 * whether it has points beside its corners at all. */
enum { POINTS = 8 };

static unsigned char marks_of(const struct mesh *mesh, size_t facet, const struct raster *raster)
{
    int edges = is_flat(mesh, facet) ? 0 : raster->rows == 0 ? 7 : 1 << raster->longest;

    return (unsigned char)(edges + (raster_count(raster) > 0 ? POINTS : 0));
}

enum { PIECE = 4096 }; /* facets that one thread takes */

/* What the threads share. */
struct sampling {
    const struct mesh *mesh;
    double spacing;
    enum guard_facets facets;
    unsigned char *mark; /* [facet] */
    double *count;       /* [piece] of points beside the corners */
    const struct mesh_edges *edges;
    struct vec3s *points; /* [piece] */
};

static size_t end_of_piece(const struct sampling *s, size_t piece)
{
    size_t end = (piece + 1) * PIECE;

    return end < s->mesh->face.n ? end : s->mesh->face.n;
}

static void mark_pieces(void *context, size_t from, size_t to)
{
    const struct sampling *s = context;

    for (size_t k = from; k < to; k++) {
        s->count[k] = 0;
        for (size_t f = k * PIECE; f < end_of_piece(s, k); f++) {
            struct raster raster = raster_of_facet(s->mesh, f, s->spacing);
            s->mark[f] = marks_of(s->mesh, f, &raster);
            s->count[k] += raster_count(&raster);
        }
    }
}

/* How many points the facets have beside their corners: whole numbers, in whatever order. */
static double mark_all(struct sampling *s, size_t pieces, int threads)
{
    double sum = 0;

    parallel_for(threads, pieces, mark_pieces, s);
    for (size_t k = 0; k < pieces; k++)
        sum += s->count[k];
    return sum;
}

/* The facet beyond the edge has points along it. */
static bool has_points_along(const struct sampling *s, int facet, int edge)
{
    for (int i = 0; i < 3; i++)
        if (s->edges->of[facet][i] == edge && s->mark[facet] & 1 << i)
            return true;
    return false;
}

static void sample_facet(const struct sampling *s, size_t f, struct vec3s *points)
{
    static const double below[] = {[GUARD_CURVED] = HUGE_VAL,
                                   [GUARD_NEAR] = GUARD_OFF,
                                   [GUARD_UPPER] = 0,
                                   [GUARD_FLAT] = HUGE_VAL};
    struct patch patch = patch_of_facet(s->mesh, f, s->facets);
    patch.below = patch.flat ? HUGE_VAL : below[s->facets];
    for (int i = 0; i < 3; i++)
        patch.normal[i] = s->mesh->normal.item[s->mesh->face.item[f].v[i]];
    struct raster raster = raster_of(&patch, s->spacing);

    for (int i = 0; i < 3; i++) {
        int edge = s->edges->of[f][i], beyond = mesh_edge_beyond(s->edges, edge, (int)f);
        patch.shared[i] =
            !patch.flat && beyond >= 0 && beyond < (int)f && has_points_along(s, beyond, edge);
    }
    patch_sample(&patch, &raster, points);
}

static void sample_pieces(void *context, size_t from, size_t to)
{
    const struct sampling *s = context;

    for (size_t k = from; k < to; k++)
        for (size_t f = k * PIECE; f < end_of_piece(s, k); f++)
            if (s->mark[f] & POINTS)
                sample_facet(s, f, &s->points[k]);
}

static void add_corners(const struct mesh *mesh, struct vec3s *points)
{
    bool *used = mem_alloc(mesh->vertex.n, sizeof *used);

    for (size_t f = 0; f < mesh->face.n; f++)
        for (int i = 0; i < 3; i++)
            used[mesh->face.item[f].v[i]] = true;
    for (size_t v = 0; v < mesh->vertex.n; v++)
        if (used[v])
            *array_push(points) = mesh->vertex.item[v];
    free(used);
}

/* What the threads share that put the points of the pieces one after the other. */
struct joining {
    const struct vec3s *piece;
    const size_t *first; /* of each piece */
    struct vec3 *to;
};

static void join_some(void *context, size_t from, size_t to)
{
    const struct joining *j = context;

    for (size_t k = from; k < to; k++)
        if (j->piece[k].n > 0)
            memcpy(j->to + j->first[k], j->piece[k].item, j->piece[k].n * sizeof *j->piece[k].item);
}

/* The points of all pieces; there is room for `more` after them. */
static void join_pieces(struct vec3s *piece, size_t n, size_t more, int threads,
                        struct vec3s *points)
{
    size_t *first = mem_alloc(n + 1, sizeof *first), sum = points->n;

    for (size_t k = 0; k < n; k++) {
        first[k] = sum;
        sum += piece[k].n;
    }
    array_reserve(points, sum + more);
    struct joining joining = {piece, first, points->item};
    parallel_for(threads, n, join_some, &joining);
    points->n = sum;
    for (size_t k = 0; k < n; k++)
        array_free(&piece[k]);
    free(first);
}

double guard_points_of_mesh(const struct mesh *mesh, const struct mesh_edges *edges,
                            const struct guard_mesh_options *options, struct vec3s *points)
{
    size_t pieces = (mesh->face.n + PIECE - 1) / PIECE;
    int threads = options->threads;
    double most = options->most;
    struct sampling s = {.mesh = mesh, .spacing = options->spacing, .facets = options->facets};

    s.mark = mem_alloc(mesh->face.n + 1, sizeof *s.mark);
    s.count = mem_alloc(pieces + 1, sizeof *s.count);
    s.points = mem_alloc(pieces + 1, sizeof *s.points);
    double count = mark_all(&s, pieces, threads);
    /* A few points a facet are left, however far apart. */
    for (int i = 0; i < 20 && count > most; i++) {
        s.spacing *= 1.05 * sqrt(count / most);
        count = mark_all(&s, pieces, threads);
    }
    if (count > 0) {
        struct mesh_edges found = {0};
        if (!edges)
            found = mesh_edges_find(mesh);
        s.edges = edges ? edges : &found;
        parallel_for(threads, pieces, sample_pieces, &s);
        mesh_edges_free(&found);
    }
    join_pieces(s.points, pieces, mesh->vertex.n, threads, points);
    add_corners(mesh, points);
    free(s.mark);
    free(s.count);
    free(s.points);
    return s.spacing;
}

/* ---- the sharp edges of a mesh */

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

/* The two facets meet at the edge by its place alone, each with vertices of its own. */
static bool share_no_edge(const struct mesh *mesh, const struct side *a, const struct side *b)
{
    const int *v = mesh->face.item[a->facet].v, *w = mesh->face.item[b->facet].v;
    int from = v[a->i], to = v[(a->i + 1) % 3];

    return from != w[(b->i + 1) % 3] || to != w[b->i];
}

/* The corner of b off the edge lies below the plane of a. */
static bool is_convex_from(const struct mesh *mesh, const struct side *a, const struct side *b)
{
    const struct vec3 *p = mesh->vertex.item;
    struct vec3 up = mesh_face_cross(mesh, a->facet);
    struct vec3 beyond = p[mesh->face.item[b->facet].v[(b->i + 2) % 3]];

    return vec_dot(up, vec_sub(beyond, p[a->end[0]])) < 0;
}

/* The points of the scan about a place of the edge lie on the planes of its two facets. */
static bool is_borne_out(const struct mesh *mesh, const struct side *a, const struct side *b,
                         const struct point_grid *scan, struct vec3 at)
{
    enum { NEAR = 8, MOST = 6 }; /* MOST: others may be on a third flank */
    const double off = 0.05;     /* of their spacing, for flanks are curved */
    struct vec3 normal[2] = {vec_unit(mesh_face_cross(mesh, a->facet)),
                             vec_unit(mesh_face_cross(mesh, b->facet))};
    uint32_t index[NEAR];
    double distance2[NEAR];
    size_t n = point_grid_nearest(scan, at, NEAR, index, distance2), on = 0;

    for (size_t k = 0; k < n; k++) {
        struct vec3 to = vec_sub(scan->point[index[k]], at);
        double h = fmin(fabs(vec_dot(normal[0], to)), fabs(vec_dot(normal[1], to)));
        on += h <= off * sqrt(PI * distance2[n - 1] / (double)n);
    }
    return on >= MOST;
}

void guard_points_of_edges(const struct mesh *mesh, double spacing, const struct point_grid *scan,
                           struct vec3s *to)
{
    struct sides sides = find_sides(mesh);

    for (size_t k = 0, end; k < sides.n; k = end) {
        const struct side *a = &sides.item[k], *b = a + 1;
        for (end = k + 1; end < sides.n && same_ends(a, &sides.item[end]);)
            end++;
        if (end != k + 2 || !share_no_edge(mesh, a, b) || !is_convex_from(mesh, a, b) ||
            !is_convex_from(mesh, b, a))
            continue;
        struct vec3 p = mesh->vertex.item[a->end[0]], q = mesh->vertex.item[a->end[1]];
        double parts = ceil(vec_distance(p, q) / spacing);
        for (double i = 0; i <= parts; i++) {
            struct vec3 at = vec_mix(p, q, i / fmax(parts, 1));
            if (!scan || is_borne_out(mesh, a, b, scan, at))
                *array_push(to) = at;
        }
    }
    array_free(&sides);
}
