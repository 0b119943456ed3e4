/* mesh_repair - see mesh_repair.h. */
#include <stdbool.h>
#include <stdlib.h>

#include "mesh_repair_steps.h"
#include "base/array.h"
#include "base/parallel.h"
#include "curve/edge_curve.h"
#include "mesh/mesh_clip.h"
#include "mesh/mesh_edges.h"
#include "mesh/mesh_repair.h"
#include "mesh/mesh_weld.h"

/* Below this part of its longest edge's square, twice a facet's area is rounding. */
static const double AREA_OF_NOTHING = 1e-12;

static bool has_area(const struct mesh *mesh, size_t facet)
{
    const int *v = mesh->face.item[facet].v;
    double longest = 0;

    for (int i = 0; i < 3; i++) {
        struct vec3 side = vec_sub(mesh->vertex.item[v[(i + 1) % 3]], mesh->vertex.item[v[i]]);
        longest = fmax(longest, vec_dot(side, side));
    }
    return vec_length(mesh_face_cross(mesh, facet)) > AREA_OF_NOTHING * longest;
}

size_t mesh_clean_no_area(struct mesh *mesh)
{
    bool *out = mem_alloc(mesh->face.n, sizeof *out);
    size_t before = mesh->face.n;

    for (size_t f = 0; f < mesh->face.n; f++)
        out[f] = !has_area(mesh, f);
    mesh_clip_marked(mesh, out);
    free(out);
    return before - mesh->face.n;
}

/* A facet by its vertices in rising order. */
struct corners {
    int v[3], facet;
};

static struct corners corners_of(const struct mesh *mesh, size_t facet)
{
    const int *v = mesh->face.item[facet].v;
    int low = v[0] < v[1] ? v[0] : v[1], high = v[0] < v[1] ? v[1] : v[0];

    if (v[2] < low)
        return (struct corners){{v[2], low, high}, (int)facet};
    if (v[2] < high)
        return (struct corners){{low, v[2], high}, (int)facet};
    return (struct corners){{low, high, v[2]}, (int)facet};
}

static int compare_vertices(const struct corners *a, const struct corners *b)
{
    for (int i = 0; i < 3; i++) {
        if (a->v[i] != b->v[i])
            return a->v[i] < b->v[i] ? -1 : 1;
    }
    return 0;
}

static int compare_corners(const void *pa, const void *pb)
{
    const struct corners *a = pa, *b = pb;
    int order = compare_vertices(a, b);

    return order != 0 ? order : (a->facet > b->facet) - (a->facet < b->facet);
}

/* The corners of all facets in order: those with the same lowest vertex are few. */
static void sort_corners(const struct mesh *mesh, struct corners *sorted)
{
    size_t n = mesh->face.n, *first = mem_alloc(mesh->vertex.n + 2, sizeof *first);

    for (size_t f = 0; f < n; f++)
        first[corners_of(mesh, f).v[0] + 2]++;
    for (size_t v = 2; v < mesh->vertex.n + 2; v++)
        first[v] += first[v - 1];
    for (size_t f = 0; f < n; f++) {
        struct corners c = corners_of(mesh, f);
        sorted[first[c.v[0] + 1]++] = c;
    }
    for (size_t v = 0; v < mesh->vertex.n; v++)
        if (first[v + 1] - first[v] > 1)
            qsort(sorted + first[v], first[v + 1] - first[v], sizeof *sorted, compare_corners);
    free(first);
}

size_t mesh_clean_doubled(struct mesh *mesh)
{
    size_t n = mesh->face.n;
    struct corners *corners = mem_alloc(n, sizeof *corners);
    bool *out = mem_alloc(n, sizeof *out);

    sort_corners(mesh, corners);
    for (size_t i = 1; i < n; i++)
        out[corners[i].facet] = compare_vertices(&corners[i - 1], &corners[i]) == 0;
    mesh_clip_marked(mesh, out);
    free(corners);
    free(out);
    return n - mesh->face.n;
}

static const double SHARP = 0.8660254037844386; /* cos 30 degrees */

/* mm: a smooth surface through the corners of a facet may be so far off it.  Beyond that, without
 * normals, nothing says that the part is curved there, and who judges takes the facet as it is. */
static const double OFF_FACET = 0.01;

static const double ALIKE = 1e-6; /* radians: such facets are of one plane */
enum { ROUNDS = 3 };

/* Corners of facets, number 3 * facet + corner, joined to the same vertex: a forest of parents. */
static int root_of(int *parent, int corner)
{
    while (parent[corner] != corner) {
        parent[corner] = parent[parent[corner]];
        corner = parent[corner];
    }
    return corner;
}

/* The smaller number becomes the root, so that the vertices keep their order. */
static void join_corners_of(int *parent, int a, int b)
{
    a = root_of(parent, a);
    b = root_of(parent, b);
    if (a < b)
        parent[b] = a;
    else
        parent[a] = b;
}

static int corner_at(const struct mesh *mesh, int facet, int vertex)
{
    const int *v = mesh->face.item[facet].v;

    return 3 * facet + (v[0] == vertex ? 0 : v[1] == vertex ? 1 : 2);
}

/* unit[]: the facets' normals.  flat[]: those that a smooth surface would leave too far join what
 * is in their own plane alone. */
static int *join_corners(const struct mesh *mesh, const struct mesh_edges *edges,
                         const struct vec3 *unit, const bool *flat)
{
    int *parent = mem_alloc(3 * mesh->face.n, sizeof *parent);

    for (size_t i = 0; i < 3 * mesh->face.n; i++)
        parent[i] = (int)i;
    for (size_t e = 0; e < edges->n; e++) {
        const struct mesh_edge *edge = &edges->edge[e];
        int f = edge->facet[0], g = edge->facet[1];
        if (f < 0 || g < 0)
            continue;
        bool smooth = flat[f] || flat[g] ? vec_angle(unit[f], unit[g]) <= ALIKE
                                         : vec_dot(unit[f], unit[g]) >= SHARP;
        for (int i = 0; i < 2 && smooth; i++)
            join_corners_of(parent, corner_at(mesh, f, edge->v[i]), corner_at(mesh, g, edge->v[i]));
    }
    return parent;
}

/* What the threads share that measure facets. */
struct measuring {
    const struct mesh *mesh;
    struct vec3 *unit; /* [facet] its normal */
    double *angle;     /* [3 facet + corner] */
};

static double angle_at(const struct mesh *mesh, size_t facet, int corner)
{
    const int *v = mesh->face.item[facet].v;
    const struct vec3 *p = mesh->vertex.item;
    struct vec3 here = p[v[corner]];

    return vec_angle(vec_sub(p[v[(corner + 1) % 3]], here), vec_sub(p[v[(corner + 2) % 3]], here));
}

static void measure_facets(void *context, size_t from, size_t to)
{
    const struct measuring *m = context;

    for (size_t f = from; f < to; f++) {
        m->unit[f] = vec_unit(mesh_face_cross(m->mesh, f));
        for (int i = 0; i < 3; i++)
            m->angle[3 * f + (size_t)i] = angle_at(m->mesh, f, i);
    }
}

/* The corners of facets as vertices, and the normals of these. */
struct numbered {
    int *number; /* [3 facet + corner] */
    struct vec3s vertex, normal;
};

static struct numbered number_corners(const struct mesh *mesh, int *parent,
                                      const struct measuring *measured)
{
    struct numbered all = {.number = mem_alloc(3 * mesh->face.n, sizeof *all.number)};

    for (size_t f = 0; f < mesh->face.n; f++) {
        for (int i = 0; i < 3; i++) {
            int corner = 3 * (int)f + i, root = root_of(parent, corner);
            if (root == corner) {
                all.number[root] = (int)all.vertex.n;
                *array_push(&all.vertex) = mesh->vertex.item[mesh->face.item[f].v[i]];
                *array_push(&all.normal) = vec(0, 0, 0);
            }
            all.number[corner] = all.number[root];
            struct vec3 *sum = &all.normal.item[all.number[root]];
            *sum = vec_along(*sum, measured->angle[corner], measured->unit[f]);
        }
    }
    for (size_t v = 0; v < all.normal.n; v++) {
        struct vec3 *n = &all.normal.item[v];
        *n = vec_length(*n) > 0 ? vec_unit(*n) : vec(0, 0, 1);
    }
    return all;
}

static void numbered_free(struct numbered *all)
{
    free(all->number);
    array_free(&all->vertex);
    array_free(&all->normal);
}

/* How far a smooth surface is off the facet with these corners, at most, by its edges. */
static double bulge_of(const struct vec3 *vertex, const struct vec3 *normal, const int v[3])
{
    double most = 0;

    for (int i = 0; i < 3; i++) {
        int a = v[i], b = v[(i + 1) % 3];
        most = fmax(most, edge_bulge(vertex[a], normal[a], vertex[b], normal[b]));
    }
    return most;
}

bool mesh_is_coarse(const struct mesh *mesh)
{
    for (size_t f = 0; f < mesh->face.n; f++)
        if (bulge_of(mesh->vertex.item, mesh->normal.item, mesh->face.item[f].v) > OFF_FACET)
            return true;
    return false;
}

bool mesh_is_sharp(const struct mesh *mesh)
{
    const struct vec3 *normal = mesh->normal.item;
    const double alike = 0.999; /* cosine */
    size_t *first = mesh_first_at_place(mesh);
    bool sharp = false;

    for (size_t v = 0; v < mesh->normal.n; v++)
        sharp = sharp || vec_dot(normal[v], normal[first[v]]) < alike;
    free(first);
    return sharp;
}

/* Marks the facets that the normals would make leave their plane too far; true if there are any
 * more than before. */
static bool mark_flat(const struct mesh *mesh, const struct numbered *all, bool *flat)
{
    bool more = false;

    for (size_t f = 0; f < mesh->face.n; f++) {
        if (flat[f] ||
            bulge_of(all->vertex.item, all->normal.item, &all->number[3 * f]) <= OFF_FACET)
            continue;
        flat[f] = more = true;
    }
    return more;
}

/* With its edges, found before any facet was flipped or since. */
static void make_normals(struct mesh *mesh, const struct mesh_edges *edges, int threads)
{
    struct measuring measured = {mesh, mem_alloc(mesh->face.n, sizeof *measured.unit),
                                 mem_alloc(3 * mesh->face.n, sizeof *measured.angle)};
    bool *flat = mem_alloc(mesh->face.n + 1, sizeof *flat);
    struct numbered all = {.number = NULL};

    parallel_for(threads, mesh->face.n, measure_facets, &measured);
    for (int round = 0; round == 0 || (round < ROUNDS && mark_flat(mesh, &all, flat)); round++) {
        numbered_free(&all);
        int *parent = join_corners(mesh, edges, measured.unit, flat);
        all = number_corners(mesh, parent, &measured);
        free(parent);
    }
    for (size_t i = 0; i < 3 * mesh->face.n; i++)
        mesh->face.item[i / 3].v[i % 3] = all.number[i];
    free(measured.unit);
    free(measured.angle);
    free(flat);
    free(all.number);
    array_free(&mesh->row);
    array_free(&mesh->col);
    array_free(&mesh->kmax);
    array_free(&mesh->vertex);
    array_free(&mesh->normal);
    mesh->vertex = all.vertex;
    mesh->normal = all.normal;
}

void crease_normals(struct mesh *mesh)
{
    struct mesh_edges edges = mesh_edges_find(mesh);

    make_normals(mesh, &edges, 1);
    mesh_edges_free(&edges);
}

/* Of the area, what must be left when the facets' normals are added up to say where a piece faces.
 */
static const double LEANING = 0.1;

static void flip(struct mesh *mesh, size_t facet)
{
    int *v = mesh->face.item[facet].v, third = v[2];

    v[2] = v[1];
    v[1] = third;
}

/* True when a facet has an edge in the direction from the smaller to the larger vertex. */
static bool rises_along(const struct mesh *mesh, const struct mesh_edges *edges, int facet,
                        int edge)
{
    for (int i = 0; i < 3; i++) {
        if (edges->of[facet][i] == edge)
            return mesh->face.item[facet].v[i] == edges->edge[edge].v[0];
    }
    return false;
}

/* The connected pieces: their facets one piece after the other. */
struct pieces {
    struct ints facet;
    struct sizes end;
};

/* Finds the piece of a facet; `turned` says of each facet whether it lies against the first one. */
static void gather_piece(const struct mesh *mesh, const struct mesh_edges *edges, int first,
                         bool *seen, bool *turned, struct pieces *pieces)
{
    size_t at = pieces->facet.n;

    *array_push(&pieces->facet) = first;
    seen[first] = true;
    for (; at < pieces->facet.n; at++) {
        int f = pieces->facet.item[at];
        for (int i = 0; i < 3; i++) {
            int edge = edges->of[f][i], g = mesh_edge_beyond(edges, edge, f);
            if (g < 0 || seen[g])
                continue;
            bool same = rises_along(mesh, edges, f, edge) == rises_along(mesh, edges, g, edge);
            turned[g] = turned[f] != same;
            seen[g] = true;
            *array_push(&pieces->facet) = g;
        }
    }
    *array_push(&pieces->end) = at;
}

/* Turns the facets of each piece the way most of them are; returns how many were turned. */
static size_t orient(struct mesh *mesh, const struct mesh_edges *edges, struct pieces *pieces)
{
    bool *seen = mem_alloc(mesh->face.n, sizeof *seen);
    bool *turned = mem_alloc(mesh->face.n, sizeof *turned);
    size_t flipped = 0, begin = 0;

    for (size_t f = 0; f < mesh->face.n; f++) {
        if (!seen[f])
            gather_piece(mesh, edges, (int)f, seen, turned, pieces);
    }
    for (size_t k = 0; k < pieces->end.n; begin = pieces->end.item[k++]) {
        size_t end = pieces->end.item[k], against = 0;
        for (size_t i = begin; i < end; i++)
            against += turned[pieces->facet.item[i]];
        bool most = 2 * against > end - begin;
        for (size_t i = begin; i < end; i++) {
            if (turned[pieces->facet.item[i]] != most) {
                flip(mesh, (size_t)pieces->facet.item[i]);
                flipped++;
            }
        }
    }
    free(seen);
    free(turned);
    return flipped;
}

/* Sums over the facets of a piece. */
struct facing {
    bool closed;
    double volume; /* six times what it encloses */
    double area;   /* twice */
    double up;     /* of it, facing up */
};

static struct facing facing_of(const struct mesh *mesh, const struct mesh_edges *edges,
                               const struct pieces *pieces, size_t begin, size_t end,
                               struct vec3 up)
{
    struct facing sum = {.closed = true};
    struct vec3 origin = mesh->vertex.item[mesh->face.item[pieces->facet.item[begin]].v[0]];

    for (size_t i = begin; i < end; i++) {
        int f = pieces->facet.item[i];
        struct vec3 cross = mesh_face_cross(mesh, (size_t)f);
        sum.area += vec_length(cross);
        sum.up += vec_dot(cross, up);
        sum.volume += vec_dot(cross, vec_sub(mesh->vertex.item[mesh->face.item[f].v[0]], origin));
        for (int k = 0; k < 3; k++)
            sum.closed = sum.closed && mesh_edge_beyond(edges, edges->of[f][k], f) >= 0;
    }
    return sum;
}

static void turn_piece(struct mesh *mesh, const struct pieces *pieces, size_t begin, size_t end)
{
    for (size_t i = begin; i < end; i++)
        flip(mesh, (size_t)pieces->facet.item[i]);
}

/* A mesh that has normals faces as a whole where they say, or up. */
static void face_with_normals(struct mesh *mesh, struct vec3 up, struct mesh_repair_report *report)
{
    double area = 0, upwards = 0, agree = 0;

    for (size_t f = 0; f < mesh->face.n; f++) {
        struct vec3 cross = mesh_face_cross(mesh, f);
        area += vec_length(cross);
        for (int i = 0; i < 3; i++) {
            struct vec3 n = mesh->normal.item[mesh->face.item[f].v[i]];
            upwards += vec_dot(n, up) * vec_length(cross) / 3;
            agree += vec_dot(n, cross);
        }
    }
    bool down = upwards < -LEANING * area && report->closed < report->sheets;
    if (down) {
        report->turned = report->sheets;
        for (size_t v = 0; v < mesh->normal.n; v++)
            mesh->normal.item[v] = vec_scale(-1, mesh->normal.item[v]);
    }
    if ((agree < 0) != down) {
        report->flipped = mesh->face.n;
        for (size_t f = 0; f < mesh->face.n; f++)
            flip(mesh, f);
    }
}

static void face_up(struct mesh *mesh, const struct mesh_edges *edges, struct vec3 up,
                    struct mesh_repair_report *report)
{
    struct pieces pieces = {0};
    size_t begin = 0;

    for (size_t e = 0; e < edges->n; e++)
        report->many += edges->edge[e].facet[0] < 0;
    report->flipped = orient(mesh, edges, &pieces);
    report->sheets = pieces.end.n;
    for (size_t k = 0; k < pieces.end.n; begin = pieces.end.item[k++]) {
        size_t end = pieces.end.item[k];
        struct facing facing = facing_of(mesh, edges, &pieces, begin, end, up);
        bool away = facing.closed ? facing.volume < 0 : facing.up < -LEANING * facing.area;
        report->closed += facing.closed;
        if (away && report->normals_made) {
            turn_piece(mesh, &pieces, begin, end);
            report->turned++;
        }
    }
    array_free(&pieces.facet);
    array_free(&pieces.end);
}

struct mesh_repair_report mesh_repair(struct mesh *mesh, struct vec3 up, int threads)
{
    struct mesh_repair_report report = {.normals_made = mesh->normal.n != mesh->vertex.n};

    mesh->normals_made = report.normals_made;
    array_free(&mesh->row);
    array_free(&mesh->col);
    if (report.normals_made)
        report.welded = mesh_weld(mesh);
    report.no_area = mesh_clean_no_area(mesh);
    report.doubled = mesh_clean_doubled(mesh);
    if (mesh->face.n == 0)
        return report;
    struct mesh_edges edges = mesh_edges_find(mesh);
    face_up(mesh, &edges, up, &report);
    if (report.normals_made)
        make_normals(mesh, &edges, threads);
    mesh_edges_free(&edges);
    if (!report.normals_made) {
        face_with_normals(mesh, up, &report);
        report.normals = mesh_normals_turn(mesh);
    }
    return report;
}
