/*
 * trim_grid - the polygons are followed from cell to cell (trim_traverse) on a lattice of whole
 * numbers, where no corner ever lies on a line, and what lies where is decided without rounding.
 * What is left of each cell then is trim_clip's to say.
 */
#include "nurbs/trim_grid.h"

#include <stdlib.h>

#include "trim_traverse.h"
#include "math/earclip.h"

static int compare_chains(const void *p, const void *q)
{
    const struct trim_chain *a = p, *b = q;
    if (a->cell != b->cell)
        return a->cell < b->cell ? -1 : 1;
    return a->first < b->first ? -1 : a->first > b->first;
}

/* The vertex at a corner of a cell, 0 to 3 from the lower left, counter-clockwise. */
static int corner_of(const struct trim_traverse *c, size_t cell, int corner)
{
    size_t column = cell % (c->u.n - 1) + (corner == 1 || corner == 2 ? 1 : 0);
    size_t row = cell / (c->u.n - 1) + (corner >= 2 ? 1 : 0);
    return (int)(row * c->u.n + column);
}

static bool corner_inside(const struct trim_traverse *c, const int *inside, size_t column,
                          size_t row)
{
    return inside[row * c->u.n + column] > 0;
}

static void add_cell(struct trim_traverse *c, size_t cell)
{
    int a = corner_of(c, cell, 0), b = corner_of(c, cell, 1);
    int d = corner_of(c, cell, 2), e = corner_of(c, cell, 3);
    *array_push(&c->mesh->face) = (struct face){{a, b, d}};
    *array_push(&c->mesh->face) = (struct face){{a, d, e}};
}

/* One polygon of a cell as triangles; its corners are scaled to the cell, so that the shape of an
 * ear means something. */
static void add_polygon(struct trim_traverse *c, size_t cell, const int *id, size_t n,
                        struct uvs *at)
{
    size_t column = cell % (c->u.n - 1), row = cell / (c->u.n - 1);
    double u = c->u_line[column], v = c->v_line[row];
    at->n = 0;
    for (size_t i = 0; i < n; i++) {
        struct uv p = c->mesh->at.item[id[i]];
        *array_push(at) = (struct uv){(p.u - u) / (c->u_line[column + 1] - u),
                                      (p.v - v) / (c->v_line[row + 1] - v)};
    }
    earclip(at->item, id, n, &c->mesh->face);
}

/* The chains of one cell. */
static void cut_cell(struct trim_traverse *c, struct trim_chain *chain, size_t n, const int *inside,
                     struct polygons *p, struct uvs *at)
{
    size_t cell = chain[0].cell, column = cell % (c->u.n - 1), row = cell / (c->u.n - 1);
    const int corner[4] = {corner_of(c, cell, 0), corner_of(c, cell, 1), corner_of(c, cell, 2),
                           corner_of(c, cell, 3)};
    if (trim_clip(chain, n, c->id.item, corner, p)) {
        for (size_t i = 0, from = 0; i < p->end.n; from = p->end.item[i++])
            add_polygon(c, cell, p->id.item + from, p->end.item[i] - from, at);
        return;
    }
    c->mesh->unclear++;
    if (corner_inside(c, inside, column, row) && corner_inside(c, inside, column + 1, row) &&
        corner_inside(c, inside, column, row + 1) && corner_inside(c, inside, column + 1, row + 1))
        add_cell(c, cell);
}

/* How many loops go round each node, from the left; a hole takes one off. */
static int *count_inside(const struct trim_traverse *c)
{
    int *inside = mem_alloc(c->u.n * c->v.n, sizeof *inside);
    for (size_t row = 0; row < c->v.n; row++) {
        int sum = c->open ? 1 : 0;
        for (size_t column = 0; column < c->u.n; column++) {
            sum += c->turn[row * (c->u.n + 1) + column];
            inside[row * c->u.n + column] = sum;
        }
    }
    return inside;
}

static void cut_cells(struct trim_traverse *c)
{
    struct polygons polygons = {0};
    struct uvs at_cell = {0};
    int *inside = count_inside(c);
    size_t columns = c->u.n - 1, at = 0;
    if (c->chain.n > 0)
        qsort(c->chain.item, c->chain.n, sizeof *c->chain.item, compare_chains);
    for (size_t cell = 0; cell < columns * (c->v.n - 1); cell++) {
        if (!c->crossed[cell]) {
            if (corner_inside(c, inside, cell % columns, cell / columns))
                add_cell(c, cell);
            continue;
        }
        size_t n = 0;
        while (at + n < c->chain.n && c->chain.item[at + n].cell == cell)
            n++;
        cut_cell(c, &c->chain.item[at], n, inside, &polygons, &at_cell);
        at += n;
    }
    polygons_free(&polygons);
    array_free(&at_cell);
    free(inside);
}

/* A loop between two lines in both directions would be a hole inside a cell, or alone in it: a line
 * through its middle. */
static void mesh_for_rows_lone_loops(struct doubles *u, const struct doubles *v,
                                     const struct uv_polygon *loops)
{
    for (size_t i = 0; i < loops->n; i++) {
        const struct uvs *loop = &loops->item[i];
        struct uv low = loop->item[0], high = low;
        for (size_t k = 1; k < loop->n; k++) {
            low.u = fmin(low.u, loop->item[k].u);
            low.v = fmin(low.v, loop->item[k].v);
            high.u = fmax(high.u, loop->item[k].u);
            high.v = fmax(high.v, loop->item[k].v);
        }
        double near_u = 1e-6 * (u->item[u->n - 1] - u->item[0]);
        double near_v = 1e-6 * (v->item[v->n - 1] - v->item[0]);
        bool crossed = false;
        for (size_t k = 0; k < u->n; k++)
            crossed = crossed || (u->item[k] > low.u + near_u && u->item[k] < high.u - near_u);
        for (size_t k = 0; k < v->n; k++)
            crossed = crossed || (v->item[k] > low.v + near_v && v->item[k] < high.v - near_v);
        double middle = low.u + (high.u - low.u) / 2;
        if (crossed || high.u - low.u < 4 * near_u || middle <= u->item[0] ||
            middle >= u->item[u->n - 1])
            continue;
        array_push(u);
        size_t k = u->n - 1;
        for (; k > 0 && u->item[k - 1] > middle; k--)
            u->item[k] = u->item[k - 1];
        u->item[k] = middle;
    }
}

void trim_grid(struct doubles *u, const struct doubles *v, const struct uv_polygon *loops,
               bool open, struct uvmesh *mesh)
{
    *mesh = (struct uvmesh){0};
    mesh_for_rows_lone_loops(u, v, loops);
    struct trim_traverse c = {.u = trim_snap_new(u),
                              .v = trim_snap_new(v),
                              .u_line = u->item,
                              .v_line = v->item,
                              .mesh = mesh,
                              .open = open};
    c.turn = mem_alloc(v->n * (u->n + 1), sizeof *c.turn);
    c.crossed = mem_alloc((u->n - 1) * (v->n - 1), sizeof *c.crossed);
    for (size_t row = 0; row < v->n; row++)
        for (size_t column = 0; column < u->n; column++)
            *array_push(&mesh->at) = (struct uv){u->item[column], v->item[row]};
    trim_traverse_loops(&c, loops);
    cut_cells(&c);
    trim_snap_free(&c.u);
    trim_snap_free(&c.v);
    free(c.turn);
    free(c.crossed);
    array_free(&c.id);
    array_free(&c.chain);
}

void uvmesh_free(struct uvmesh *mesh)
{
    array_free(&mesh->at);
    array_free(&mesh->face);
}
