/* reposition - see reposition.h. */
#include "meshing/reposition.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

/* What a node has: how near its point is, in steps of 1e-9 t^2, and which it is. */
struct choice {
    int64_t nearness;
    size_t point;
};

static const double STEPS = 1e9;

/* A point as it looks from a node, in units of t. */
struct view {
    bool upper, middle;
};

static struct view view_from(const struct grid *g, int column, int row, struct vec3 p)
{
    const double rounding = 1e-9;
    struct vec3 node = grid_node(g, column, row);
    double dx = (p.x - node.x) / g->t, dy = (p.y - node.y) / g->t;
    return (struct view){dy >= -rounding, fabs(dy) >= sqrt(3) * fabs(dx) - rounding};
}

/* Both are equally near to the node: does `a` come before `b`? */
static bool comes_first(const struct grid *g, const struct vec3 *point, int column, int row,
                        size_t a, size_t b)
{
    struct vec3 p = plan_extent_turn(&g->plan_extent, point[a]);
    struct vec3 q = plan_extent_turn(&g->plan_extent, point[b]);
    struct view from_p = view_from(g, column, row, p), from_q = view_from(g, column, row, q);
    if (from_p.upper != from_q.upper)
        return from_p.upper;
    if (from_p.middle != from_q.middle)
        return from_p.middle;
    if (p.x != q.x)
        return p.x > q.x;
    if (p.z != q.z)
        return p.z > q.z;
    if (p.y != q.y)
        return p.y > q.y;
    return a < b;
}

static void compete_for_node(const struct grid *g, struct choice *choice, const struct vec3 *point,
                             size_t index, int column, int row, double distance2)
{
    int64_t nearness = (int64_t)(distance2 * STEPS + 0.5);
    struct choice *c = &choice[(size_t)row * (size_t)g->columns + (size_t)column];
    if (nearness > c->nearness)
        return;
    if (nearness == c->nearness && !comes_first(g, point, column, row, index, c->point))
        return;
    *c = (struct choice){nearness, index};
}

/* Where a point lies: the lower left node of its rhombus and what is left over, 0 to 1. */
struct place {
    int column, row;
    double right, up; /* along e1 and e2 */
};

static int whole_part(double x, int most)
{
    int i = (int)x;
    return i > most ? most : i;
}

static struct place place_of(const struct grid *g, struct vec3 point)
{
    struct vec3 p = plan_extent_turn(&g->plan_extent, point);
    double v = (p.y - g->y) / (g->t * GRID_SLANT), u = (p.x - g->x) / g->t - 0.5 * v;
    u = u > 0 ? u : 0;
    int column = whole_part(u, g->columns - 2), row = whole_part(v, g->rows - 2);
    return (struct place){column, row, u - column, v - row};
}

/* |a e1 + b e2|^2 in units of t^2. */
static double oblique_length2(double a, double b)
{
    return a * a + a * b + b * b;
}

/* The nearest node is a corner of the rhombus; of equally near ones the lower, then left one. */
static void compete_nearest(const struct grid *g, struct choice *choice, const struct vec3 *point,
                            size_t index)
{
    static const double further = 1e-9;
    struct place at = place_of(g, point[index]);
    double least = oblique_length2(at.right, at.up);
    int column = at.column, row = at.row;
    for (int corner = 1; corner < 4; corner++) {
        int right = corner & 1, up = corner >> 1;
        double d2 = oblique_length2(at.right - right, at.up - up);
        if (d2 < least - further) {
            least = d2;
            column = at.column + right;
            row = at.row + up;
        }
    }
    compete_for_node(g, choice, point, index, column, row, least);
}

/* Nodes nearer than t are corners of the rhombus, or of one of the rhombi around it. */
static void compete_circle(const struct grid *g, struct choice *choice, const struct vec3 *point,
                           size_t index)
{
    static const double inside = 1 - 1e-9;
    struct place at = place_of(g, point[index]);
    for (int up = -1; up <= 2; up++)
        for (int right = -1; right <= 2; right++) {
            int column = at.column + right, row = at.row + up;
            double d2 = oblique_length2(at.right - right, at.up - up);
            if (d2 < inside && column >= 0 && column < g->columns && row >= 0 && row < g->rows)
                compete_for_node(g, choice, point, index, column, row, d2);
        }
}

/* The six nodes around one, those within the grid; how many. */
static int nodes_around(const struct grid *g, int column, int row, size_t around[6])
{
    static const int RIGHT[6] = {1, 0, -1, -1, 0, 1}, UP[6] = {0, 1, 1, 0, -1, -1};
    int n = 0;
    for (int k = 0; k < 6; k++) {
        int i = column + RIGHT[k], j = row + UP[k];
        if (i >= 0 && i < g->columns && j >= 0 && j < g->rows)
            around[n++] = (size_t)j * (size_t)g->columns + (size_t)i;
    }
    return n;
}

/* Marks the empty nodes inside the cloud: all but one of those around have a point; how many. */
static size_t mark_empty(const struct grid *g, const struct choice *choice, bool *empty)
{
    size_t n = 0, around[6];
    for (int row = 0; row < g->rows; row++)
        for (int column = 0; column < g->columns; column++) {
            size_t node = (size_t)row * (size_t)g->columns + (size_t)column;
            int full = 0;
            for (int k = nodes_around(g, column, row, around); k-- > 0;)
                full += choice[around[k]].point != NO_POINT;
            empty[node] = choice[node].point == NO_POINT && full >= 5;
            n += empty[node];
        }
    return n;
}

/* Lets a point that no node has taken compete for the empty ones nearer than 0.7 t: from further
 * off facets might fold. */
static void compete_empty(const struct grid *g, const bool *empty, struct choice *choice,
                          const struct vec3 *point, size_t index)
{
    const double within = 0.49; /* t^2 */
    struct place at = place_of(g, point[index]);
    for (int up = -1; up <= 2; up++)
        for (int right = -1; right <= 2; right++) {
            int column = at.column + right, row = at.row + up;
            if (column < 0 || column >= g->columns || row < 0 || row >= g->rows)
                continue;
            double d2 = oblique_length2(at.right - right, at.up - up);
            if (d2 < within && empty[(size_t)row * (size_t)g->columns + (size_t)column])
                compete_for_node(g, choice, point, index, column, row, d2);
        }
}

/* A point that two empty nodes took is left to the first. */
static void fill_empty(const struct grid *g, struct choice *choice, const struct vec3 *point,
                       size_t n)
{
    size_t nodes = grid_nodes(g);
    bool *empty = mem_alloc(nodes, sizeof *empty), *taken = mem_alloc(n, sizeof *taken);
    if (mark_empty(g, choice, empty) > 0) {
        for (size_t i = 0; i < nodes; i++)
            if (choice[i].point != NO_POINT)
                taken[choice[i].point] = true;
        for (size_t i = 0; i < n; i++)
            if (!taken[i])
                compete_empty(g, empty, choice, point, i);
        for (size_t i = 0; i < nodes; i++) {
            if (!empty[i] || choice[i].point == NO_POINT)
                continue;
            if (taken[choice[i].point])
                choice[i].point = NO_POINT;
            else
                taken[choice[i].point] = true;
        }
    }
    free(taken);
    free(empty);
}

size_t *reposition(const struct grid *grid, const struct vec3 *point, size_t n, enum reach reach)
{
    size_t nodes = grid_nodes(grid);
    struct choice *choice = mem_alloc(nodes, sizeof *choice);
    for (size_t i = 0; i < nodes; i++)
        choice[i] = (struct choice){INT64_MAX, NO_POINT};
    for (size_t i = 0; i < n; i++) {
        if (reach == REACH_CIRCLE)
            compete_circle(grid, choice, point, i);
        else
            compete_nearest(grid, choice, point, i);
    }
    if (reach == REACH_NEAREST)
        fill_empty(grid, choice, point, n);
    size_t *chosen = mem_alloc(nodes, sizeof *chosen);
    for (size_t i = 0; i < nodes; i++)
        chosen[i] = choice[i].point;
    free(choice);
    return chosen;
}
