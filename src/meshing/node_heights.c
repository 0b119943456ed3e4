/* node_heights - see node_heights.h. */
#include "meshing/node_heights.h"

#include <stdlib.h>

#include "base/parallel.h"
#include "math/cubic.h"
#include "math/moment_fit.h"
#include "math/quadric.h"

enum { NEAR = 30, FEWER = 14, AROUND = 12, TURNS = 6, AROUND_NODE = 36 };

static const double CERTAIN = 0.06;  /* of the spacing */
static const double WIDEST = 3.25;   /* radians that the points around a node may leave open */
static const double STEEPEST = 0.4;  /* z of a unit normal */
static const double FARTHEST = 0.75; /* of the grid's spacing: no vertex is moved farther */

static const double SURROUNDED = 0.25; /* lean of the points about a node, at most */
static const double EXPLAINED = 1.4;   /* sigmas of the noise that a cubic may leave ... */
static const double FINE = 0.02;       /* ... or so much of the spacing */

struct moving {
    struct mesh *mesh;
    const struct grid *grid;
    const struct point_grid *scan;
    const struct node_heights_options *options;
    bool *moved;
    double *certain; /* of each vertex, NULL: not asked for */
};

/* Seen from above, are there points on all sides of the place? */
static bool is_surrounded(const struct vec3 *near, struct vec3 place)
{
    double angle[AROUND], widest;

    for (int i = 0; i < AROUND; i++)
        angle[i] = atan2(near[i].y - place.y, near[i].x - place.x);
    doubles_sort(angle, AROUND);
    widest = angle[0] + 2 * PI - angle[AROUND - 1];
    for (int i = 0; i + 1 < AROUND; i++)
        widest = fmax(widest, angle[i + 1] - angle[i]);
    return widest < WIDEST;
}

/* Where the upright line through `place` meets the surface, up or down from its foot; false where
 * it does not, or where the surface is too steep. */
static bool meet_upright(const struct quadric *q, struct vec3 *place)
{
    struct vec3 n = quadric_normal(q), p = quadric_foot(q);

    if (fabs(n.z) < STEEPEST)
        return false;
    for (int turn = 0; turn < TURNS; turn++) {
        double dx = place->x - p.x, dy = place->y - p.y;
        struct vec3 before = p;
        struct vec3 on = vec_add(p, vec(dx, dy, -(n.x * dx + n.y * dy) / n.z));
        struct vec3 local = quadric_local(q, on);
        p = quadric_at(q, local.x, local.y);
        if (p.x == before.x && p.y == before.y &&
            p.z == before.z) /* nor would it move in the next turn */
            break;
    }
    if (!(hypot(place->x - p.x, place->y - p.y) <= 1e-6)) /* or it went off without an end */
        return false;
    *place = vec(place->x, place->y, p.z);
    return true;
}

/* How far two surfaces over a node may be apart, along their normal. */
static double agreement(const struct moving *m)
{
    return fmax(m->options->noise, CERTAIN * m->options->spacing);
}

/* The first round: one cubic explains the points around, and a quadric through the same agrees.
 * Then the vertex's normal and curvature are known too. */
static bool place_by_moments(const struct moving *m, size_t v, struct vec3 guess,
                             struct vec3 *place)
{
    const struct mesh *mesh = m->mesh;
    double spacing = m->options->spacing, within = agreement(m);
    double radius = moment_fit_radius(AROUND_NODE, spacing, mesh->normal.item[v]);
    struct vec3 at = guess, other = guess;
    struct moment_fit fit;

    if (moment_fit_ball(m->scan, guess, mesh->normal.item[v], radius, &fit) < 0 ||
        fit.lean > SURROUNDED ||
        fit.cubic_spread > fmax(EXPLAINED * m->options->noise, FINE * spacing) ||
        !meet_upright(&fit.cubic, &at) || !meet_upright(&fit.quadric, &other) ||
        fabs(at.z - other.z) * fabs(quadric_normal(&fit.cubic).z) > within ||
        fabs(quadric_off(&fit.cubic, mesh->vertex.item[v])) > 3 * within)
        return false;
    *place = at;
    if (m->certain) {
        const struct quadric *q = moment_fit_better(&fit);
        mesh->normal.item[v] = quadric_normal_at(q, at);
        mesh->kmax.item[v] = quadric_curvature(q);
        m->certain[v] = moment_fit_spread(&fit) * sqrt(q->variance);
    }
    return true;
}

/* The second: the same from the nearest points, of which fewer must agree. */
static bool place_by_nearest(const struct moving *m, struct vec3 vertex, struct vec3 normal,
                             struct vec3 guess, struct vec3 *place)
{
    uint32_t index[NEAR];
    double distance2[NEAR];
    struct vec3 near[NEAR];
    struct quadric wide, narrow;

    if (point_grid_nearest(m->scan, guess, NEAR, index, distance2) < NEAR)
        return false;
    for (int i = 0; i < NEAR; i++)
        near[i] = m->scan->point[index[i]];
    if (!is_surrounded(near, guess) || cubic_fit(near, NULL, NEAR, guess, normal, &wide) < 0 ||
        quadric_fit(near, FEWER, guess, normal, &narrow) < 0)
        return false;
    struct vec3 at = guess, other = guess;
    double within = agreement(m);
    if (!meet_upright(&wide, &at) || !meet_upright(&narrow, &other) ||
        fabs(at.z - other.z) * fabs(quadric_normal(&wide).z) > within ||
        fabs(quadric_off(&wide, vertex)) > 3 * within)
        return false;
    *place = at;
    return true;
}

/* The place on the surface of the scan over or under a node near to a vertex. */
static bool place_at_node(const struct moving *m, size_t v, struct vec3 *place)
{
    struct vec3 vertex = m->mesh->vertex.item[v], normal = m->mesh->normal.item[v];
    struct vec3 guess = vec(place->x, place->y, vertex.z);

    if (fabs(normal.z) > STEEPEST)
        guess.z -= (normal.x * (guess.x - vertex.x) + normal.y * (guess.y - vertex.y)) / normal.z;
    return place_by_moments(m, v, guess, place) ||
           place_by_nearest(m, vertex, normal, guess, place);
}

static void move_vertices(void *context, size_t from, size_t to)
{
    const struct moving *m = context;
    const struct mesh *mesh = m->mesh;
    const struct plan_extent *extent = &m->grid->plan_extent;

    for (size_t v = from; v < to; v++) {
        struct vec3 vertex = mesh->vertex.item[v], node;
        if (m->certain)
            m->certain[v] = -1;
        if (mesh->row.item[v] < 0)
            continue;
        node =
            plan_extent_turn_back(extent, grid_node(m->grid, mesh->col.item[v], mesh->row.item[v]));
        m->moved[v] = hypot(node.x - vertex.x, node.y - vertex.y) < FARTHEST * m->grid->t &&
                      place_at_node(m, v, &node);
        if (m->moved[v])
            mesh->vertex.item[v] = node;
    }
}

size_t node_heights(struct mesh *mesh, const struct grid *grid, const struct point_grid *scan,
                    const struct node_heights_options *options, double *certain)
{
    size_t n = mesh->vertex.n, moved = 0;
    struct moving m = {mesh, grid, scan, options, mem_alloc(n + 1, sizeof *m.moved), certain};

    mesh_normals_facet(mesh);
    if (certain) {
        array_reserve(&mesh->kmax, n);
        mesh->kmax.n = n;
    }
    parallel_for(options->threads, n, move_vertices, &m);
    for (size_t v = 0; v < n; v++)
        moved += m.moved[v];
    free(m.moved);
    return moved;
}
