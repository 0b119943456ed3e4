/* brink - see brink.h. */
#include "brink.h"

#include <stdlib.h>

#include "cubic.h"
#include "kdtree.h"
#include "meshedges.h"
#include "quadric.h"

enum { NEAR = 40, FEWER = 24 };

/* Of the spacing: how far beside the mesh rows may go, and from point to point. */
static const double BESIDE = 1.5, STEP = 0.25;

/* Radians that the points about a place may leave open beyond a half turn: the last row of a grid
 * is straight. */
static const double OPEN = 0.005;

static const double STEEP = 0.01; /* sine squared of surface against plane */
static const double TIGHT = 0.05; /* of the ball's curvature: as much as none is left */

struct brink {
    struct vec3s point; /* of the scan, near the border of the mesh */
    struct kdtree *points;
    struct kdtree *border; /* its vertices there */
    double beside, step, radius, sure;
};

static struct kdtree *border_of(const struct mesh *mesh)
{
    struct mesh_edges edges = mesh_edges_find(mesh);
    struct vec3s vertex = {0};

    for (size_t e = 0; e < edges.n; e++) {
        if (edges.edge[e].facet[1] != EDGE_BORDER)
            continue;
        *array_push(&vertex) = mesh->vertex.item[edges.edge[e].v[0]];
        *array_push(&vertex) = mesh->vertex.item[edges.edge[e].v[1]];
    }
    struct kdtree *tree = kdtree_new(vertex.item, vertex.n);
    mesh_edges_free(&edges);
    array_free(&vertex);
    return tree;
}

static bool near_border(const struct brink *b, struct vec3 p, double within)
{
    return kdtree_any_beside(b->border, p, p, within);
}

struct brink *brink_new(const struct brink_rule *rule, const struct mesh *mesh)
{
    struct brink *b = mem_alloc(1, sizeof *b);

    b->border = border_of(mesh);
    b->beside = BESIDE * rule->spacing;
    b->step = STEP * rule->spacing;
    for (size_t i = 0; i < rule->scan->n; i++) {
        struct vec3 p = rule->scan->item[i];
        if (near_border(b, p, b->beside + rule->spacing))
            *array_push(&b->point) = p;
    }
    b->radius = rule->radius;
    b->sure = rule->sure;
    b->points = kdtree_new(b->point.item, b->point.n);
    return b;
}

void brink_free(struct brink *b)
{
    if (!b)
        return;
    kdtree_free(b->points);
    kdtree_free(b->border);
    array_free(&b->point);
    free(b);
}

static int compare_doubles(const void *pa, const void *pb)
{
    const double *a = pa, *b = pb;

    return (*a > *b) - (*a < *b);
}

/* Seen along the normal, are there points to all sides of the place? */
static bool surrounded(const struct vec3 *near, const struct contact *c)
{
    struct vec3 u = vec_perpendicular(c->n), v = vec_cross(c->n, u);
    double angle[NEAR];

    for (int i = 0; i < NEAR; i++) {
        struct vec3 d = vec_sub(near[i], c->p);
        angle[i] = atan2(vec_dot(d, v), vec_dot(d, u));
    }
    qsort(angle, NEAR, sizeof *angle, compare_doubles);
    double widest = angle[0] + 2 * PI - angle[NEAR - 1];
    for (int i = 0; i + 1 < NEAR; i++)
        widest = fmax(widest, angle[i + 1] - angle[i]);
    return widest <= PI + OPEN;
}

/* How far the ball may be off on a surface: by what one through fewer of the points differs. */
static double unsure(const struct brink *b, const struct vec3 *near, const struct quadric *q)
{
    struct vec3 normal = quadric_normal(q);
    struct quadric other;

    if (cubic_fit(near, NULL, FEWER, q->origin, normal, &other) < 0)
        return HUGE_VAL;
    double e = vec_distance(quadric_normal(&other), normal);
    double fits = fmax(1 / b->radius - quadric_curvature(q), TIGHT / b->radius);
    return fmax(vec_distance(quadric_foot(&other), quadric_foot(q)), e * e / (2 * fits));
}

/* Moves a contact within its plane onto the surface through the points; -1: no surface there. */
static int settle(const struct brink *b, const struct vec3 *near, const struct brink_plane *plane,
                  struct contact *c)
{
    struct quadric q;

    for (int turn = 0; turn < 3; turn++) {
        if (cubic_fit(near, NULL, NEAR, c->p, c->n, &q) < 0)
            return -1;
        struct vec3 normal = quadric_normal(&q), level = vec_reject(normal, plane->normal);
        double level2 = vec_dot(level, level);
        double off = vec_dot(vec_sub(quadric_foot(&q), c->p), normal);
        if (level2 < STEEP || vec_dot(normal, c->n) < 0.5)
            return -1;
        c->p = vec_along(c->p, off / level2, level);
        c->p = vec_along(c->p, plane->height - vec_dot(c->p, plane->normal), plane->normal);
        c->n = normal;
    }
    return unsure(b, near, &q) <= b->sure ? 0 : -1;
}

bool brink_put(const struct brink *b, const struct brink_plane *plane, struct contact *c)
{
    const double far = 0.5; /* of the reach: nearer points there are in the midst of some */
    size_t index[NEAR];
    double distance2[NEAR];
    struct vec3 near[NEAR];
    struct contact on = *c;

    if (kdtree_nearest(b->points, c->p, NEAR, index, distance2) < NEAR ||
        distance2[0] > far * far * distance2[NEAR - 1])
        return false;
    for (int i = 0; i < NEAR; i++)
        near[i] = b->point.item[index[i]];
    if (settle(b, near, plane, &on) < 0 || vec_distance(on.p, c->p) > b->step ||
        !surrounded(near, &on))
        return false;
    *c = on;
    return true;
}

double brink_step(const struct brink *b)
{
    return b->step;
}

bool brink_beside(const struct brink *b, struct vec3 p)
{
    return near_border(b, p, b->beside);
}
