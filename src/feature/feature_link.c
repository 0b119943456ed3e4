/* feature_link - see feature_steps.h. */
#include "feature_steps.h"

#include <stdbool.h>
#include <stdlib.h>

#include "base/array.h"

enum { FARTHEST = 6 };

/* How far the ends of an edge may be off the sheets of a crease that goes on over it, by its
 * length. */
static const double OFF = 0.15;

/* A way from facet to facet, and what the edges on it would get. */
struct continuation {
    int n, edge[FARTHEST];
    struct feature found[FARTHEST];
};

static double side_of(const struct feature *f, struct vec3 across, struct vec3 p)
{
    return vec_dot(vec_sub(p, f->place[0]), across);
}

/* Across a feature, between the two sheets, unit: from the side of its end 1 to that of its end 0.
 */
static struct vec3 across_of(const struct feature *f)
{
    struct vec3 up = f->kind == FEATURE_WALL ? vec(0, 0, 1) : vec_add(f->normal[0], f->normal[1]);
    struct vec3 across = vec_unit(vec_cross(f->along, up));

    /* at a crease the foot of end 0 is on its side; the upper end of a wall lies on the other side
     * of it */
    if (f->kind == FEATURE_WALL) {
        bool upper = f->place[0].z > f->place[1].z;
        return (vec_dot(across, f->wall) > 0) == upper ? vec_scale(-1, across) : across;
    }
    return vec_dot(vec_sub(f->foot[0], f->foot[1]), across) < 0 ? vec_scale(-1, across) : across;
}

/* The same height over the sheet of one side as its feature has there. */
static struct vec3 on_sheet(const struct feature *f, int i, struct vec3 p)
{
    double upright = f->kind == FEATURE_WALL ? f->normal[i].z : 1;
    struct vec3 way = f->kind == FEATURE_WALL ? vec(0, 0, 1) : f->normal[i];
    double above = vec_dot(vec_sub(p, f->place[i]), f->normal[i]);

    return vec_along(p, -above / fmax(upright, 0.1), way);
}

/* Where a feature that goes straight on crosses an edge: false when it does not. */
static bool continue_over(const struct mesh *mesh, const struct mesh_edge *edge,
                          const struct feature *f, struct feature *next)
{
    const double rim = 0.001; /* not over a vertex */
    struct vec3 across = across_of(f);
    struct vec3 a = mesh->vertex.item[edge->v[0]], b = mesh->vertex.item[edge->v[1]];
    double from = side_of(f, across, a), to = side_of(f, across, b), s = from / (from - to);

    if (!(s > rim && s < 1 - rim))
        return false;
    bool swap = from < 0; /* end 0 of the edge is on the side of the feature's end 1 */
    double length = vec_distance(a, b);
    *next = *f;
    for (int i = 0; i < 2; i++) {
        int k = swap ? 1 - i : i;
        next->normal[i] = next->end[i] = f->normal[k];
        next->place[i] = on_sheet(f, k, vec_mix(a, b, s));
        next->foot[i] = on_sheet(f, k, i == 0 ? a : b);
        if (f->kind == FEATURE_CREASE && vec_distance(next->foot[i], i == 0 ? a : b) > OFF * length)
            return false;
    }
    if (f->kind == FEATURE_CREASE) { /* the line of both sheets */
        struct vec3 off = vec_sub(vec_mix(a, b, s), f->place[0]);
        struct vec3 at = vec_along(f->place[0], vec_dot(off, f->along), f->along);
        next->place[0] = next->place[1] = at;
    }
    next->known = 0;
    return true;
}

/* Has the facet an edge on the border, or one next to it: then it has a corner there? */
static bool at_border(const struct mesh_edges *edges, int facet, bool look_beyond)
{
    for (int i = 0; i < 3; i++) {
        int beyond = mesh_edge_beyond(edges, edges->of[facet][i], facet);
        if (beyond < 0 || (look_beyond && at_border(edges, beyond, false)))
            return true;
    }
    return false;
}

/* Follows a feature from the facet that it ends in. */
static bool follow_feature(const struct mesh *mesh, const struct mesh_edges *edges,
                           const struct feature *feature, int facet, int edge,
                           struct continuation *way)
{
    struct feature at = feature[edge];

    way->n = 0;
    for (bool joined = false; !joined;) {
        int next = -1;
        for (int i = 0; i < 3 && next < 0; i++) {
            int e = edges->of[facet][i];
            if (e != edge && way->n < FARTHEST &&
                continue_over(mesh, &edges->edge[e], &at, &way->found[way->n]))
                next = e;
        }
        if (next < 0) /* through a corner: there it may end */
            return way->n > 0 && at_border(edges, facet, true);
        if (edges->edge[next].facet[0] < 0)
            return false;
        at = way->found[way->n];
        way->edge[way->n++] = edge = next;
        facet = mesh_edge_beyond(edges, edge, facet);
        joined = facet < 0;
        for (int i = 0; i < 3 && facet >= 0; i++)
            joined = joined || feature[edges->of[facet][i]].kind == at.kind;
    }
    return true;
}

void feature_link_close(const struct mesh *mesh, const struct mesh_edges *edges,
                        struct feature *feature)
{
    for (size_t f = 0; f < mesh->face.n; f++) {
        int crossed = 0, edge = -1;
        struct continuation way;
        for (int i = 0; i < 3; i++) {
            int e = edges->of[f][i];
            crossed += feature[e].kind != FEATURE_NONE;
            edge = feature[e].kind != FEATURE_NONE ? e : edge;
        }
        if (crossed != 1 || !follow_feature(mesh, edges, feature, (int)f, edge, &way))
            continue;
        for (int i = 0; i < way.n; i++)
            feature[way.edge[i]] = way.found[i];
    }
}

size_t feature_link_longest(const struct mesh_edges *edges, const struct feature *feature)
{
    unsigned char *seen = mem_alloc(edges->n, 1);
    struct ints open = {0};
    size_t longest = 0;

    for (size_t e = 0; e < edges->n; e++) {
        size_t length = 0;
        if (feature[e].kind != FEATURE_NONE && !seen[e])
            *array_push(&open) = (int)e;
        seen[e] = 1;
        while (open.n > 0) {
            const struct mesh_edge *edge = &edges->edge[open.item[--open.n]];
            length++;
            for (int i = 0; i < 6; i++) {
                int facet = edge->facet[i / 3], next = facet < 0 ? -1 : edges->of[facet][i % 3];
                if (next < 0 || seen[next] || feature[next].kind == FEATURE_NONE)
                    continue;
                seen[next] = 1;
                *array_push(&open) = next;
            }
        }
        longest = length > longest ? length : longest;
    }
    free(seen);
    array_free(&open);
    return longest;
}
