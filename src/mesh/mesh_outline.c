/* mesh_outline - see mesh_outline.h. */
#include "mesh/mesh_outline.h"

#include <stdlib.h>

#include "math/box.h"
#include "math/elementary.h"
#include "mesh/mesh_edges.h"

/* Sides of facets that are the border, in the direction of their facets. */
struct sides {
    int *first; /* of each vertex: one of those that begin there, or -1 */
    int *next;  /* another one, or -1 */
    int *to;    /* the vertex where it ends */
};

static void sides_free(struct sides *s)
{
    free(s->first);
    free(s->next);
    free(s->to);
}

/* False: an edge of more than two facets. */
static bool border_of(const struct mesh *mesh, struct sides *s)
{
    struct mesh_edges edges = mesh_edges_find(mesh);
    bool simple = true;
    int n = 0;

    *s = (struct sides){mem_alloc(mesh->vertex.n + 1, sizeof(int)),
                        mem_alloc(edges.n + 1, sizeof(int)), mem_alloc(edges.n + 1, sizeof(int))};
    for (size_t v = 0; v < mesh->vertex.n; v++)
        s->first[v] = -1;
    for (size_t f = 0; f < mesh->face.n; f++)
        for (int i = 0; i < 3; i++) {
            const int *v = mesh->face.item[f].v, beyond = edges.edge[edges.of[f][i]].facet[1];
            simple = simple && beyond != EDGE_MANY;
            if (beyond != EDGE_BORDER)
                continue;
            s->to[n] = v[(i + 1) % 3];
            s->next[n] = s->first[v[i]];
            s->first[v[i]] = n++;
        }
    mesh_edges_free(&edges);
    return simple;
}

/* A loop from vertex v along sides that are not taken yet.  False: it does not close. */
static bool take_loop(const struct mesh *mesh, struct sides *s, int v, struct vec3s *loop)
{
    int at = v;

    loop->n = 0;
    do {
        int side = s->first[at];
        if (side < 0)
            return false;
        *array_push(loop) = mesh->vertex.item[at];
        s->first[at] = s->next[side];
        at = s->to[side];
    } while (at != v);
    return true;
}

static double distance_xy(struct vec3 p, struct vec3 a, struct vec3 b)
{
    p.z = a.z = b.z = 0;
    return vec_distance(vec_segment_nearest(a, b, p), p);
}

/* The corners of a loop that are left. */
static void add_polygon(const struct vec3s *loop, double within, struct region_polygons *outline)
{
    enum { MOST = 500 }; /* corners in a row that are looked at */
    const struct vec3 *p = loop->item;
    size_t first = outline->corner.n;

    *array_push(&outline->from) = (int)first;
    for (size_t i = 0, to; i < loop->n; i = to) {
        bool near = true;
        *array_push(&outline->corner) = vec(p[i].x, p[i].y, 0);
        for (to = i + 1; near && to < loop->n && to < i + MOST; to += near)
            for (size_t k = i + 1; near && k <= to; k++)
                near = distance_xy(p[k], p[i], p[(to + 1) % loop->n]) <= within;
    }
    if (outline->corner.n < first + 3) {
        outline->corner.n = first;
        outline->from.n--;
    }
}

/* Twice the area that it goes round, counter-clockwise. */
static double area_of(const struct vec3s *loop)
{
    double area = 0;

    for (size_t i = 0; i < loop->n; i++) {
        struct vec3 a = loop->item[i], b = loop->item[(i + 1) % loop->n];
        area += a.x * b.y - b.x * a.y;
    }
    return area;
}

bool mesh_outline_find(const struct mesh *mesh, double within, double narrow,
                       struct region_polygons *outline)
{
    struct sides sides;
    struct vec3s loop = {0};
    bool good = border_of(mesh, &sides);

    for (int v = 0; good && v < (int)mesh->vertex.n; v += sides.first[v] < 0) {
        if (sides.first[v] < 0)
            continue;
        good = take_loop(mesh, &sides, v, &loop);
        const struct box box = box_around(loop.item, loop.n);
        double size = fmin(box.high.x - box.low.x, box.high.y - box.low.y);
        if (good && size > (area_of(&loop) > 0 ? narrow : within))
            add_polygon(&loop, within, outline);
    }
    sides_free(&sides);
    array_free(&loop);
    if (!good)
        region_polygons_free(outline);
    return good;
}
