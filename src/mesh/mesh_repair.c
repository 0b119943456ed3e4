#include "mesh/mesh_repair.h"

#include <stdlib.h>

#include "crease_normals.h"
#include "mesh_clean.h"
#include "mesh/mesh_edges.h"
#include "mesh/mesh_weld.h"

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
static bool goes_up(const struct mesh *mesh, const struct mesh_edges *edges, int facet, int edge)
{
    for (int i = 0; i < 3; i++) {
        if (edges->of[facet][i] == edge)
            return mesh->face.item[facet].v[i] == edges->edge[edge].v[0];
    }
    return false;
}

/* The connected pieces: their facets one piece behind the other. */
struct pieces {
    struct ints facet;
    struct sizes end;
};

/* Finds the piece of a facet; `turned` says of each facet whether it lies against the first one. */
static void grow(const struct mesh *mesh, const struct mesh_edges *edges, int first, bool *seen,
                 bool *turned, struct pieces *pieces)
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
            bool same = goes_up(mesh, edges, f, edge) == goes_up(mesh, edges, g, edge);
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
            grow(mesh, edges, (int)f, seen, turned, pieces);
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

/* Vertex normals on the other side of their facets are turned, or, where they are no more than
 * crosswise, give way to the facets'. */
static size_t turn_normals(struct mesh *mesh)
{
    struct vec3 *sum = mem_alloc(mesh->vertex.n, sizeof *sum);
    size_t turned = 0;

    for (size_t f = 0; f < mesh->face.n; f++) {
        struct vec3 cross = mesh_face_cross(mesh, f);
        for (int i = 0; i < 3; i++) {
            int v = mesh->face.item[f].v[i];
            sum[v] = vec_add(sum[v], cross);
        }
    }
    for (size_t v = 0; v < mesh->vertex.n; v++) {
        struct vec3 mean = vec_unit(sum[v]), *normal = &mesh->normal.item[v];
        double agree = vec_dot(mean, *normal);
        turned += agree < 0;
        if (agree < 0)
            *normal = agree < -0.5 ? vec_scale(-1, *normal) : mean;
    }
    free(sum);
    return turned;
}

static void face_up(struct mesh *mesh, struct vec3 up, struct mesh_repair_report *report)
{
    struct mesh_edges edges = mesh_edges_find(mesh);
    struct pieces pieces = {0};
    size_t begin = 0;

    for (size_t e = 0; e < edges.n; e++)
        report->many += edges.edge[e].facet[0] < 0;
    report->flipped = orient(mesh, &edges, &pieces);
    report->sheets = pieces.end.n;
    for (size_t k = 0; k < pieces.end.n; begin = pieces.end.item[k++]) {
        size_t end = pieces.end.item[k];
        struct facing facing = facing_of(mesh, &edges, &pieces, begin, end, up);
        bool away = facing.closed ? facing.volume < 0 : facing.up < -LEANING * facing.area;
        report->closed += facing.closed;
        if (away && report->normals_made) {
            turn_piece(mesh, &pieces, begin, end);
            report->turned++;
        }
    }
    array_free(&pieces.facet);
    array_free(&pieces.end);
    mesh_edges_free(&edges);
}

struct mesh_repair_report mesh_repair(struct mesh *mesh, struct vec3 up)
{
    struct mesh_repair_report report = {.normals_made = mesh->normal.n != mesh->vertex.n};

    array_free(&mesh->row);
    array_free(&mesh->col);
    if (report.normals_made)
        report.welded = mesh_weld(mesh);
    report.no_area = mesh_clean_no_area(mesh);
    report.doubled = mesh_clean_doubled(mesh);
    if (mesh->face.n == 0)
        return report;
    face_up(mesh, up, &report);
    if (report.normals_made) {
        crease_normals(mesh);
    } else {
        face_with_normals(mesh, up, &report);
        report.normals = turn_normals(mesh);
    }
    return report;
}
