/* trim_grid - see trim_grid.h. */
#include "trim_grid.h"

#include <stdlib.h>

#include "math/elementary.h"
#include "math/earclip.h"

/* The grid, and what following the polygons adds to it. */
struct trim_traverse {
    struct trim_snap u, v;
    const double *u_line, *v_line;
    struct uvmesh *mesh;      /* its vertices: the nodes, row by row, then those of the polygons */
    struct ints id;           /* vertices of all chains */
    struct trim_chains chain; /* the inside is on their left */
    int *turn;     /* [line of v][column + 1]: loops that cross it upwards less those downwards */
    bool *crossed; /* [cell] a chain runs through it */
    bool open;     /* the border of the grid bounds the inside too */
};

/* Steps over the whole grid, and how near to a line a place is taken to lie on it. */
enum { STEPS = 1 << 28, NEAR = 240 };

struct trim_snap trim_snap_new(const struct doubles *x)
{
    struct trim_snap a = {.from = x->item[0], .width = x->item[x->n - 1] - x->item[0], .n = x->n};
    a.line = mem_alloc(a.n, sizeof *a.line);
    for (size_t i = 0; i < a.n; i++)
        a.line[i] = 2 * (int64_t)floor((x->item[i] - a.from) / a.width * STEPS + 0.5);
    return a;
}

size_t trim_snap_below(const struct trim_snap *a, int64_t x)
{
    size_t low = 0, high = a->n;
    while (low < high) {
        size_t mid = low + (high - low) / 2;
        if (a->line[mid] < x)
            low = mid + 1;
        else
            high = mid;
    }
    return low;
}

int64_t trim_snap_place(const struct trim_snap *a, double x, double inwards)
{
    double part = fmin(fmax((x - a->from) / a->width, -0.01), 1.01);
    int64_t at = 2 * (int64_t)floor(part * STEPS) + 1;
    size_t above = trim_snap_below(a, at);
    for (size_t i = above > 0 ? above - 1 : 0; i < a->n && i <= above; i++) {
        if (llabs(a->line[i] - at) > NEAR)
            continue;
        if (i == 0)
            return a->line[i] - 1;
        if (i + 1 == a->n)
            return a->line[i] + 1;
        return a->line[i] + (inwards > 0 ? 1 : -1);
    }
    return at;
}

void trim_snap_free(struct trim_snap *a)
{
    free(a->line);
    *a = (struct trim_snap){0};
}

struct snapped_point {
    int64_t u, v;
};

/* The next corner of the loop from i on, `step` at a time, that is not within rounding of i. */
static struct uv corner_beside(const struct trim_traverse *c, const struct uvs *loop, size_t i,
                               size_t step)
{
    struct uv here = loop->item[i], other = here;
    for (size_t k = 0; k + 1 < loop->n; k++) {
        i = (i + step) % loop->n;
        other = loop->item[i];
        if (fabs(other.u - here.u) > NEAR * c->u.width / STEPS ||
            fabs(other.v - here.v) > NEAR * c->v.width / STEPS)
            break;
    }
    return other;
}

/* The loop's corners in order, snapped, without repetitions; `at` gets the exact ones. */
static size_t snap_loop(const struct trim_traverse *c, const struct uvs *loop, bool backwards,
                        struct snapped_point *point, struct uv *at)
{
    size_t n = loop->n, count = 0;
    for (size_t i = 0; i < n; i++) {
        size_t k = backwards ? n - 1 - i : i;
        struct uv here = loop->item[k];
        struct uv before = corner_beside(c, loop, k, backwards ? 1 : n - 1);
        struct uv after = corner_beside(c, loop, k, backwards ? n - 1 : 1);
        struct snapped_point p = {trim_snap_place(&c->u, here.u, before.v - after.v),
                                  trim_snap_place(&c->v, here.v, after.u - before.u)};
        if (count > 0 && point[count - 1].u == p.u && point[count - 1].v == p.v)
            continue;
        point[count] = p;
        at[count++] = here;
    }
    while (count > 1 && point[count - 1].u == point[0].u && point[count - 1].v == point[0].v)
        count--;
    return count;
}

static int add_vertex(struct trim_traverse *c, struct uv at)
{
    double u1 = c->u.from + c->u.width, v1 = c->v.from + c->v.width;
    at.u = fmin(fmax(at.u, c->u.from), u1);
    at.v = fmin(fmax(at.v, c->v.from), v1);
    *array_push(&c->mesh->at) = at;
    return (int)c->mesh->at.n - 1;
}

/* Where the traversal is: the cell (as counts of lines below, so that 0 is outside) and the chain
 * so far. */
struct walk {
    size_t column, row;
    struct trim_chain chain;
};

static bool in_grid(const struct trim_traverse *c, size_t column, size_t row)
{
    return column > 0 && column < c->u.n && row > 0 && row < c->v.n;
}

/* The next line that the segment from a to b crosses in one direction, and how far along it is, as
 * the numerator of a fraction. */
static bool next_line(const struct trim_snap *x, size_t below, int64_t a, int64_t b,
                      int64_t *numerator, size_t *line)
{
    if (b > a && below < x->n && x->line[below] < b) {
        *line = below;
        *numerator = x->line[below] - a;
        return true;
    }
    if (b < a && below > 0 && x->line[below - 1] > b) {
        *line = below - 1;
        *numerator = a - x->line[below - 1];
        return true;
    }
    return false;
}

/* How far along its side, counter-clockwise round the cell. */
static double along_side(int side, double x)
{
    return side < 2 ? x : -x;
}

/* Goes over a line: the chain ends there and the next one begins with the same vertex. */
static void cross_line(struct trim_traverse *c, struct walk *w, int side, int vertex, double along)
{
    static const int opposite[] = {2, 3, 0, 1};
    *array_push(&c->id) = vertex;
    w->chain.n++;
    w->chain.side_out = side;
    w->chain.out = along_side(side, along);
    if (in_grid(c, w->column, w->row)) {
        w->chain.cell = (w->row - 1) * (c->u.n - 1) + w->column - 1;
        c->crossed[w->chain.cell] = true;
        *array_push(&c->chain) = w->chain;
    }
    w->column += side == 1 ? 1 : 0;
    w->column -= side == 3 ? 1 : 0;
    w->row += side == 2 ? 1 : 0;
    w->row -= side == 0 ? 1 : 0;
    w->chain = (struct trim_chain){.first = c->id.n, .n = 1, .side_in = opposite[side]};
    w->chain.in = along_side(opposite[side], along);
    *array_push(&c->id) = vertex;
}

/* The vertex where a segment crosses a line.  An end of the segment that was snapped off that line
 * is the vertex itself. */
static int crossing(struct trim_traverse *c, int64_t done, int64_t whole, struct uv at,
                    const int id[2])
{
    return done == 1 ? id[0] : done == whole - 1 ? id[1] : add_vertex(c, at);
}

/* Goes along a segment, given by the snapped and the exact places and the vertices of its ends,
 * over one line after the other; returns how many. */
static size_t cross_lines(struct trim_traverse *c, struct walk *w, const struct snapped_point p[2],
                          const struct uv at[2], const int id[2])
{
    size_t crossings = 0;
    int64_t du = llabs(p[1].u - p[0].u), dv = llabs(p[1].v - p[0].v);
    for (;; crossings++) {
        int64_t nu, nv;
        size_t line_u, line_v;
        bool over_u = next_line(&c->u, w->column, p[0].u, p[1].u, &nu, &line_u);
        bool over_v = next_line(&c->v, w->row, p[0].v, p[1].v, &nv, &line_v);
        if (!over_u && !over_v)
            return crossings;
        if (over_u && over_v)
            over_u = nu * dv <= nv * du;
        double t = over_u ? (double)nu / (double)du : (double)nv / (double)dv;
        struct uv place = {at[0].u + t * (at[1].u - at[0].u), at[0].v + t * (at[1].v - at[0].v)};
        if (over_u) {
            place.u = c->u_line[line_u];
            double along = (double)p[0].v + t * (double)(p[1].v - p[0].v);
            cross_line(c, w, p[1].u > p[0].u ? 1 : 3, crossing(c, nu, du, place, id), along);
        } else {
            bool up = p[1].v > p[0].v;
            place.v = c->v_line[line_v];
            double along = (double)p[0].u + t * (double)(p[1].u - p[0].u);
            c->turn[line_v * (c->u.n + 1) + w->column] += up ? -1 : 1;
            cross_line(c, w, up ? 2 : 0, crossing(c, nv, dv, place, id), along);
        }
    }
}

/* Follows one loop.  What comes before its first crossing belongs to its last chain. */
static void traverse_loop(struct trim_traverse *c, const struct snapped_point *point,
                          const struct uv *at, size_t n)
{
    struct walk w = {.column = trim_snap_below(&c->u, point[0].u),
                     .row = trim_snap_below(&c->v, point[0].v)};
    size_t first_chain = c->chain.n, begin = c->id.n;
    struct trim_chain opening = {0};
    bool begun = false;
    int first_id = (int)c->mesh->at.n;
    for (size_t i = 0; i < n; i++)
        add_vertex(c, at[i]);
    w.chain = (struct trim_chain){.first = begin};
    for (size_t i = 0; i < n; i++) {
        struct snapped_point p[2] = {point[i], point[(i + 1) % n]};
        struct uv place[2] = {at[i], at[(i + 1) % n]};
        int id[2] = {first_id + (int)i, first_id + (int)((i + 1) % n)};
        *array_push(&c->id) = id[0];
        w.chain.n++;
        size_t before = c->chain.n;
        bool outside = !in_grid(c, w.column, w.row);
        if (cross_lines(c, &w, p, place, id) > 0 && !begun) {
            begun = true;
            if (!outside) {
                opening = c->chain.item[before];
                c->chain.item[before].n = 0;
            }
        }
    }
    if (!begun || opening.n == 0)
        return;
    struct trim_chain whole = w.chain;
    whole.cell = opening.cell;
    whole.side_out = opening.side_out;
    whole.out = opening.out;
    for (size_t i = 0; i < opening.n; i++) {
        int id = c->id.item[opening.first + i];
        *array_push(&c->id) = id;
    }
    whole.n += opening.n;
    for (size_t i = first_chain; i < c->chain.n; i++)
        if (c->chain.item[i].n == 0)
            c->chain.item[i] = whole;
}

/*
 * Follows all loops: every corner, and every place where a side crosses a line of the grid, gets a
 * vertex, which the cells on both sides of the line share.
 */
static void traverse_loops(struct trim_traverse *c, const struct uv_polygon *loops)
{
    for (size_t i = 0; i < loops->n; i++) {
        const struct uvs *loop = &loops->item[i];
        struct snapped_point *point = mem_alloc(loop->n, sizeof *point);
        struct uv *at = mem_alloc(loop->n, sizeof *at);
        size_t n = snap_loop(c, loop, uv_polygon_backwards(loops, i, c->open), point, at);
        if (n >= 3)
            traverse_loop(c, point, at, n);
        free(point);
        free(at);
    }
}

/* An end of a chain on the border of its cell. */
struct end {
    int side;
    double along;
    bool enters;
    size_t chain;
};

static int compare_ends(const void *p, const void *q)
{
    const struct end *a = p, *b = q;
    if (a->side != b->side)
        return a->side < b->side ? -1 : 1;
    if (a->along < b->along || a->along > b->along)
        return a->along < b->along ? -1 : 1;
    return a->chain < b->chain ? -1 : a->chain > b->chain;
}

static void add_corner(struct polygons *p, size_t first, int id)
{
    if (p->id.n == first || p->id.item[p->id.n - 1] != id)
        *array_push(&p->id) = id;
}

/* Follows one polygon from a chain on: along the chain, along the border of the cell to the next
 * chain that enters, and so on. */
static bool round_polygon(struct trim_chain *chain, const int *id, const struct end *end,
                          size_t ends, const int corner[4], size_t start, struct polygons *p)
{
    size_t now = start, first = p->id.n;
    do {
        struct trim_chain *k = &chain[now];
        k->used = true;
        for (size_t i = 0; i < k->n; i++)
            add_corner(p, first, id[k->first + i]);
        size_t e = 0;
        while (end[e].chain != now || end[e].enters)
            e++;
        size_t next = (e + 1) % ends;
        if (!end[next].enters)
            return false;
        int side = end[e].side;
        bool wraps = next <= e;
        while (wraps || side != end[next].side) {
            side = (side + 1) % 4;
            add_corner(p, first, corner[side]);
            wraps = wraps && side != 0;
        }
        now = end[next].chain;
    } while (!chain[now].used);
    if (p->id.n > first + 1 && p->id.item[first] == p->id.item[p->id.n - 1])
        p->id.n--;
    *array_push(&p->end) = p->id.n;
    return now == start;
}

bool trim_clip(struct trim_chain *chain, size_t n, const int *id, const int corner[4],
               struct polygons *polygons)
{
    struct end *end = mem_alloc(2 * n, sizeof *end);
    bool sound = true;
    polygons->id.n = polygons->end.n = 0;
    for (size_t i = 0; i < n; i++) {
        end[2 * i] = (struct end){chain[i].side_in, chain[i].in, true, i};
        end[2 * i + 1] = (struct end){chain[i].side_out, chain[i].out, false, i};
    }
    qsort(end, 2 * n, sizeof *end, compare_ends);
    for (size_t i = 0; i < n && sound; i++)
        if (!chain[i].used)
            sound = round_polygon(chain, id, end, 2 * n, corner, i, polygons);
    free(end);
    return sound;
}

void polygons_free(struct polygons *polygons)
{
    array_free(&polygons->id);
    array_free(&polygons->end);
}

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

/* Triangulates one polygon of a cell, scaled to the unit square so that ears are judged by their
 * shape. */
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

/* Triangulates the inside of a cell with these chains. */
static void clip_cell(struct trim_traverse *c, struct trim_chain *chain, size_t n,
                      const int *inside, struct polygons *p, struct uvs *at)
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

/* How many loops go round each node, summed up from the left; a hole takes one off. */
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

static void clip_cells(struct trim_traverse *c)
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
        clip_cell(c, &c->chain.item[at], n, inside, &polygons, &at_cell);
        at += n;
    }
    polygons_free(&polygons);
    array_free(&at_cell);
    free(inside);
}

/* A loop that no line crosses would lie inside a cell: it gets a line through its middle. */
static void add_line_through_lone_loops(struct doubles *u, const struct doubles *v,
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
    add_line_through_lone_loops(u, v, loops);
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
    traverse_loops(&c, loops);
    clip_cells(&c);
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
