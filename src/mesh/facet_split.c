/* facet_split - see facet_split.h. */
#include "mesh/facet_split.h"

#include <stdlib.h>

#include "math/elementary.h"
#include "math/box_tree.h"

static const double FLAT = 1e-9; /* mm2: twice the area of a facet that is none from above */

static struct vec3 corner(const struct facet_split *w, int facet, int i)
{
    return w->mesh->vertex.item[w->mesh->face.item[facet].v[i % 3]];
}

bool facet_split_over(const struct facet_split *w, int facet, struct vec3 p)
{
    for (int i = 0; i < 3; i++)
        if (vec_orient_xy(corner(w, facet, i), corner(w, facet, i + 1), p) < -FLAT)
            return false;
    return vec_orient_xy(corner(w, facet, 0), corner(w, facet, 1), corner(w, facet, 2)) > FLAT;
}

static double off_facet(const struct facet_split *w, int facet, struct vec3 p)
{
    struct facet f = {{corner(w, facet, 0), corner(w, facet, 1), corner(w, facet, 2)}};

    return vec_distance(facet_nearest(&f, p), p);
}

void facet_split_put(struct facet_split *w, int facet, int i)
{
    w->next[i] = w->first.item[facet];
    w->first.item[facet] = i;
}

/* The points over a facet, off its list. */
static void take_points(struct facet_split *w, int facet, struct ints *points)
{
    for (int i = w->first.item[facet]; i != FACET_SPLIT_NONE; i = w->next[i])
        *array_push(points) = i;
    w->first.item[facet] = FACET_SPLIT_NONE;
}

/* How far point i is off a facet or those beside it, mm. */
static double distance_off(const struct facet_split *w, int facet, int i)
{
    double off = off_facet(w, facet, w->point[i]);

    for (int k = 0; k < 3 && off > w->within[i]; k++) {
        int beside = w->beyond.item[3 * facet + k];
        if (beside != FACET_SPLIT_NONE)
            off = fmin(off, off_facet(w, beside, w->point[i]));
    }
    return off;
}

double facet_split_worst(const struct facet_split *w, int facet, int *at)
{
    double worst = 0;

    for (int i = w->first.item[facet]; i != FACET_SPLIT_NONE; i = w->next[i]) {
        double out = distance_off(w, facet, i) - w->within[i];
        if (out > worst) {
            worst = out;
            *at = i;
        }
    }
    return worst;
}

/* Where an edge of a facet led to `from` it leads to `to`. */
static void relink_facet(struct facet_split *w, int facet, int from, int to)
{
    for (int k = 0; facet != FACET_SPLIT_NONE && k < 3; k++)
        if (w->beyond.item[3 * facet + k] == from)
            w->beyond.item[3 * facet + k] = to;
}

static void set_facet(struct facet_split *w, int facet, const int v[3], const int beyond[3])
{
    for (int k = 0; k < 3; k++) {
        w->mesh->face.item[facet].v[k] = v[k];
        w->beyond.item[3 * facet + k] = beyond[k];
    }
}

static int add_facet(struct facet_split *w)
{
    *array_push(&w->mesh->face) = (struct face){{0, 0, 0}};
    *array_push(&w->first) = FACET_SPLIT_NONE;
    for (int k = 0; k < 3; k++)
        *array_push(&w->beyond) = FACET_SPLIT_NONE;
    return (int)w->mesh->face.n - 1;
}

/* An edge along a row, a crease or a wall. */
static bool edge_is_fixed(const struct facet_split *w, int a, int b)
{
    const int *row = w->mesh->row.item;

    return row[a] == row[b] && (row[a] >= 0 || (a < w->old && b < w->old));
}

/* Is d inside the circle through a, b and c, seen from above? */
static bool in_circle(struct vec3 a, struct vec3 b, struct vec3 c, struct vec3 d)
{
    double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y;
    double cx = c.x - d.x, cy = c.y - d.y;

    return (ax * ax + ay * ay) * (bx * cy - by * cx) - (bx * bx + by * by) * (ax * cy - ay * cx) +
               (cx * cx + cy * cy) * (ax * by - ay * bx) >
           0;
}

/* Spreads points over the facets, each to the first that it is over. */
static void distribute_points(struct facet_split *w, const struct ints *points, const int *facet,
                              int facets)
{
    for (size_t k = 0; k < points->n; k++) {
        int i = points->item[k], to = facet[facets - 1];
        for (int f = 0; f < facets; f++)
            if (facet_split_over(w, facet[f], w->point[i])) {
                to = facet[f];
                break;
            }
        facet_split_put(w, to, i);
    }
}

/* How far the points over facets f and g would be out of two others at worst. */
static double worst_of_both(const struct facet_split *w, int f, int g, const struct facet other[2])
{
    double worst = 0;

    for (int side = 0; side < 2; side++)
        for (int i = w->first.item[side ? g : f]; i != FACET_SPLIT_NONE; i = w->next[i]) {
            struct vec3 p = w->point[i];
            double off = fmin(vec_distance(facet_nearest(&other[0], p), p),
                              vec_distance(facet_nearest(&other[1], p), p));
            worst = fmax(worst, off - w->within[i]);
        }
    return worst;
}

/* Turns the edge of facet f opposite to the new vertex, which is its corner 0, and edge k of facet
 * g beyond it: the two have the new vertex in common then. */
static void turn_edge(struct facet_split *w, int f, int g, int k)
{
    const int *v = w->mesh->face.item[f].v;
    int p = v[0], a = v[1], b = v[2], d = w->mesh->face.item[g].v[(k + 2) % 3];
    const int *mine = &w->beyond.item[3 * f], *its = &w->beyond.item[3 * g];
    int over_a = mine[0], over_b = mine[2];
    int beside_a = its[(k + 1) % 3], beside_b = its[(k + 2) % 3];
    struct ints points = {0};

    take_points(w, f, &points);
    take_points(w, g, &points);
    set_facet(w, f, (int[3]){p, a, d}, (int[3]){over_a, beside_a, g});
    set_facet(w, g, (int[3]){p, d, b}, (int[3]){f, beside_b, over_b});
    relink_facet(w, beside_a, g, f);
    relink_facet(w, over_b, f, g);
    distribute_points(w, &points, (int[2]){f, g}, 2);
    array_free(&points);
}

/* Is it better to turn it?  Rounder from above, and no point comes farther out. */
static bool better_turned(const struct facet_split *w, int f, int g, int k)
{
    struct vec3 p = corner(w, f, 0), a = corner(w, f, 1), b = corner(w, f, 2);
    struct vec3 d = corner(w, g, k + 2);
    struct facet now[2] = {{{p, a, b}}, {{b, a, d}}}, then[2] = {{{p, a, d}}, {{p, d, b}}};

    if (!(vec_orient_xy(p, a, d) > FLAT) || !(vec_orient_xy(p, d, b) > FLAT) ||
        !(vec_orient_xy(b, a, d) > FLAT))
        return false;
    if (vec_orient_xy(p, a, b) <= FLAT) /* the new vertex is on the edge */
        return true;
    return in_circle(p, a, b, d) &&
           worst_of_both(w, f, g, then) <= worst_of_both(w, f, g, now) + 1e-12;
}

/* The edge opposite to the new vertex, which is corner 0 of facet f, and those beyond it. */
static void turn_opposite(struct facet_split *w, int f)
{
    int g = w->beyond.item[3 * f + 1], k = 0;
    const int *v = w->mesh->face.item[f].v;

    *array_push(&w->todo) = f;
    if (g == FACET_SPLIT_NONE || edge_is_fixed(w, v[1], v[2]))
        return;
    while (k < 2 && w->beyond.item[3 * g + k] != f)
        k++;
    if (!better_turned(w, f, g, k))
        return;
    turn_edge(w, f, g, k);
    turn_opposite(w, f);
    turn_opposite(w, g);
}

static void add_vertex(struct facet_split *w, int facet, struct vec3 p)
{
    struct mesh *mesh = w->mesh;
    const int *v = mesh->face.item[facet].v;
    double kmax = 0;

    for (int i = 0; i < 3 && mesh->kmax.n > 0; i++)
        kmax = fmax(kmax, mesh->kmax.item[v[i]]);
    if (mesh->kmax.n > 0)
        *array_push(&mesh->kmax) = kmax;
    *array_push(&mesh->vertex) = p;
    *array_push(&mesh->row) = FACET_SPLIT_NONE;
    *array_push(&mesh->col) = FACET_SPLIT_NONE;
}

void facet_split_at(struct facet_split *w, int facet, int i)
{
    struct ints points = {0};
    struct face old = w->mesh->face.item[facet];
    int p = (int)w->mesh->vertex.n, f[3] = {facet, add_facet(w), add_facet(w)}, beyond[3];

    for (int k = 0; k < 3; k++)
        beyond[k] = w->beyond.item[3 * facet + k];
    add_vertex(w, facet, w->point[i]);
    take_points(w, facet, &points);
    for (int k = 0; k < 3; k++) {
        set_facet(w, f[k], (int[3]){p, old.v[k], old.v[(k + 1) % 3]},
                  (int[3]){f[(k + 2) % 3], beyond[k], f[(k + 1) % 3]});
        relink_facet(w, beyond[k], facet, f[k]);
    }
    for (size_t k = 0; k < points.n; k++)
        if (points.item[k] == i)
            points.item[k] = points.item[--points.n];
    distribute_points(w, &points, f, 3);
    array_free(&points);
    for (int k = 0; k < 3; k++)
        turn_opposite(w, f[k]);
}

bool facet_split_apart(const struct facet_split *w, int facet, struct vec3 p)
{
    const double apart = 1e-4, steep = 0.0874886635259240; /* cotangent of 85 degrees */

    for (int k = 0; k < 3; k++) {
        struct vec3 c = corner(w, facet, k);
        if (hypot(p.x - c.x, p.y - c.y) < fmax(apart, steep * fabs(p.z - c.z)))
            return false;
    }
    return true;
}
