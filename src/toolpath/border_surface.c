/* border_surface - see border_surface.h. */
#include "toolpath/border_surface.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/cubic.h"
#include "math/kdtree.h"
#include "mesh/mesh_edges.h"
#include "math/quadric.h"

enum { NEAR = 40, FEWER = 24 };

/* Of the spacing: how far beside the mesh rows may go, and from point to point. */
static const double BESIDE = 1.5, STEP = 0.25;

/* Of it too: a contact of the mesh so far off the points is not beyond them. */
static const double LITTLE = 0.2;

/* Radians that the points about a place may leave open beyond a half turn: the last row of a grid
 * is straight; and those about a place of the mesh, whose edges bend outward too. */
static const double OPEN = 0.005, OPEN_MESH = 0.1;

static const double STEEP = 0.01; /* sine squared of surface against plane */
static const double TIGHT = 0.05; /* of the ball's curvature: as much as none is left */

static const double MOVED = 1.001; /* steps: a contact is never moved so far */

struct border_surface {
    struct vec3s point; /* of the scan, near the border of the mesh: first those that are certain */
    struct kdtree *points, *all;
    struct kdtree *border; /* places along it */
    double beside, step, radius, sure;
};

static struct kdtree *border_places(const struct mesh *mesh, double spacing)
{
    struct mesh_edges edges = mesh_edges_find(mesh);
    struct vec3s place = {0};

    for (size_t e = 0; e < edges.n; e++) {
        if (edges.edge[e].facet[1] != EDGE_BORDER)
            continue;
        const struct vec3 *v = mesh->vertex.item;
        struct vec3 from = v[edges.edge[e].v[0]], to = v[edges.edge[e].v[1]];
        double n = fmax(1, ceil(vec_distance(from, to) / spacing));
        for (double i = 0; i <= n; i++)
            *array_push(&place) = vec_mix(from, to, i / n);
    }
    struct kdtree *tree = kdtree_new(place.item, place.n);
    mesh_edges_free(&edges);
    array_free(&place);
    return tree;
}

static bool near_border(const struct border_surface *b, struct vec3 p, double within)
{
    return kdtree_any_beside(b->border, p, p, within);
}

static void add_points(struct border_surface *b, const struct vec3s *scan, double spacing)
{
    for (size_t i = 0; i < scan->n; i++) {
        if (near_border(b, scan->item[i], b->beside + spacing))
            *array_push(&b->point) = scan->item[i];
    }
}

struct border_surface *border_surface_new(const struct border_surface_options *rule,
                                          const struct mesh *mesh)
{
    struct border_surface *b = mem_alloc(1, sizeof *b);

    b->border = border_places(mesh, rule->spacing);
    b->beside = BESIDE * rule->spacing;
    b->step = STEP * rule->spacing;
    b->radius = rule->radius;
    b->sure = rule->sure;
    add_points(b, rule->scan, rule->spacing);
    b->points = kdtree_new(b->point.item, b->point.n);
    add_points(b, rule->doubtful, rule->spacing);
    b->all = kdtree_new(b->point.item, b->point.n);
    return b;
}

void border_surface_free(struct border_surface *b)
{
    if (!b)
        return;
    kdtree_free(b->points);
    kdtree_free(b->all);
    kdtree_free(b->border);
    array_free(&b->point);
    free(b);
}

/* Eighths of a turn, in order. */
static unsigned eighth_of(double x, double y)
{
    unsigned half = y < 0 ? 4 : 0, steep = fabs(y) > fabs(x);

    return (x < 0) != (y < 0) ? half + 3 - steep : half + steep;
}

/* The most eighths in a row that hold none of the directions. */
static int empty_eighths(const double x[NEAR], const double y[NEAR])
{
    unsigned full = 0;
    int most = 0;

    for (int i = 0; i < NEAR; i++)
        full |= 1u << eighth_of(x[i], y[i]);
    for (int i = 0, row = 0; i < 16; i++) {
        row = full >> i % 8 & 1 ? 0 : row + 1;
        most = row > most ? row : most;
    }
    return most;
}

/* Seen along the normal, are there points to all sides of the place?  Of three or four eighths of a
 * turn without a point their directions tell. */
static bool is_surrounded(const struct vec3 *near, const struct contact *c, double open)
{
    struct vec3 u = vec_perpendicular(c->n), v = vec_cross(c->n, u);
    double angle[NEAR], x[NEAR], y[NEAR];

    for (int i = 0; i < NEAR; i++) {
        struct vec3 d = vec_sub(near[i], c->p);
        x[i] = vec_dot(d, u);
        y[i] = vec_dot(d, v);
    }
    int empty = empty_eighths(x, y);
    if (empty < 3 || empty > 4)
        return empty < 3;
    for (int i = 0; i < NEAR; i++)
        angle[i] = atan2(y[i], x[i]);
    doubles_sort(angle, NEAR);
    double widest = angle[0] + 2 * PI - angle[NEAR - 1];
    for (int i = 0; i + 1 < NEAR; i++)
        widest = fmax(widest, angle[i + 1] - angle[i]);
    return widest <= PI + open;
}

/* How far the ball may be off on a surface: by what one through fewer of the points differs. */
static double uncertainty(const struct border_surface *b, const struct vec3 *near,
                          const struct quadric *q)
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
static int fit_in_plane(const struct vec3 *near, const struct border_surface_plane *plane,
                        struct contact *c, struct quadric *q)
{
    for (int turn = 0; turn < 3; turn++) {
        if (cubic_fit(near, NULL, NEAR, c->p, c->n, q) < 0)
            return -1;
        struct vec3 normal = quadric_normal(q), level = vec_reject(normal, plane->normal);
        double level2 = vec_dot(level, level);
        double off = vec_dot(vec_sub(quadric_foot(q), c->p), normal);
        if (level2 < STEEP || vec_dot(normal, c->n) < 0.5)
            return -1;
        c->p = vec_along(c->p, off / level2, level);
        c->p = vec_along(c->p, plane->height - vec_dot(c->p, plane->normal), plane->normal);
        c->n = normal;
    }
    return 0;
}

/* The nearest points of a tree; false where these are too few. */
static bool nearest_points(const struct border_surface *b, const struct kdtree *tree, struct vec3 p,
                           struct vec3 near[NEAR], double distance2[NEAR])
{
    size_t index[NEAR];

    if (kdtree_nearest(tree, p, NEAR, index, distance2) < NEAR)
        return false;
    for (int i = 0; i < NEAR; i++)
        near[i] = b->point.item[index[i]];
    return true;
}

bool border_surface_within(const struct border_surface *b, const struct contact *c)
{
    double distance2[NEAR];
    struct vec3 near[NEAR];

    return !border_surface_beside(b, c->p) || !nearest_points(b, b->all, c->p, near, distance2) ||
           sqrt(distance2[0]) > b->step / STEP || sqrt(distance2[0]) < LITTLE * b->step / STEP ||
           is_surrounded(near, c, OPEN_MESH);
}

bool border_surface_move(const struct border_surface *b, const struct border_surface_plane *plane,
                         struct contact *c)
{
    const double far = 0.5; /* of the reach: nearer points there are in the midst of some */
    double distance2[NEAR];
    struct vec3 near[NEAR];
    struct contact on = *c;
    struct quadric q;

    if (!nearest_points(b, b->points, c->p, near, distance2) ||
        distance2[0] > far * far * distance2[NEAR - 1])
        return false;
    if (fit_in_plane(near, plane, &on, &q) < 0 || vec_distance(on.p, c->p) > b->step ||
        !is_surrounded(near, &on, OPEN) || !(uncertainty(b, near, &q) <= b->sure))
        return false;
    *c = on;
    return true;
}

double border_surface_step(const struct border_surface *b)
{
    return b->step;
}

bool border_surface_beside(const struct border_surface *b, struct vec3 p)
{
    return near_border(b, p, b->beside);
}

bool border_surface_may_be_beside(const struct border_surface *b, struct vec3 p)
{
    return near_border(b, p, b->beside + MOVED * b->step);
}
