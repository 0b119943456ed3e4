/* trim_traverse - see trim_traverse.h. */
#include "trim_traverse.h"

#include <stdlib.h>

struct trim_snap_point {
    int64_t u, v;
};

/* The loop's corners in order, on the lattice, without repetitions; `at` gets them as they are. */
static size_t loop_on_lattice(const struct trim_traverse *c, const struct uvs *loop, bool backwards,
                              struct trim_snap_point *point, struct uv *at)
{
    size_t n = loop->n, count = 0;
    for (size_t i = 0; i < n; i++) {
        struct uv before = loop->item[backwards ? (n - i) % n : (i + n - 1) % n];
        struct uv here = loop->item[backwards ? n - 1 - i : i];
        struct uv behind = loop->item[backwards ? (2 * n - 2 - i) % n : (i + 1) % n];
        struct trim_snap_point p = {trim_snap_place(&c->u, here.u, before.v - behind.v),
                                    trim_snap_place(&c->v, here.v, behind.u - before.u)};
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

/* The walker: which cell it is in (lines below it, so that 0 is outside), and its chain so far. */
struct walk {
    size_t column, row;
    struct trim_chain chain;
};

static bool in_grid(const struct trim_traverse *c, size_t column, size_t row)
{
    return column > 0 && column < c->u.n && row > 0 && row < c->v.n;
}

/* The next line that the way from a to b crosses in one direction: how far along, as a fraction. */
static bool next_line(const struct trim_lattice *x, size_t below, int64_t a, int64_t b,
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

/* Over a line: the chain ends there and the next one begins with the same vertex. */
static void cross(struct trim_traverse *c, struct walk *w, int side, int vertex, double along)
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

/* The vertex where the way goes over a line: a corner that was moved off that line by one step
 * stands for it itself. */
static int crossing(struct trim_traverse *c, int64_t done, int64_t whole, struct uv at,
                    const int id[2])
{
    return done == 1 ? id[0] : done == whole - 1 ? id[1] : add_vertex(c, at);
}

/* From a to b, line after line; the places on the lattice, as they are, and their vertices. Returns
 * how many. */
static size_t follow(struct trim_traverse *c, struct walk *w, const struct trim_snap_point p[2],
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
            cross(c, w, p[1].u > p[0].u ? 1 : 3, crossing(c, nu, du, place, id), along);
        } else {
            bool up = p[1].v > p[0].v;
            place.v = c->v_line[line_v];
            double along = (double)p[0].u + t * (double)(p[1].u - p[0].u);
            c->turn[line_v * (c->u.n + 1) + w->column] += up ? -1 : 1;
            cross(c, w, up ? 2 : 0, crossing(c, nv, dv, place, id), along);
        }
    }
}

static void trace_loop(struct trim_traverse *c, const struct trim_snap_point *point,
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
        struct trim_snap_point p[2] = {point[i], point[(i + 1) % n]};
        struct uv place[2] = {at[i], at[(i + 1) % n]};
        int id[2] = {first_id + (int)i, first_id + (int)((i + 1) % n)};
        *array_push(&c->id) = id[0];
        w.chain.n++;
        size_t before = c->chain.n;
        bool outside = !in_grid(c, w.column, w.row);
        if (follow(c, &w, p, place, id) > 0 && !begun) {
            begun = true;
            if (!outside) { /* what came before the first line belongs to the last chain */
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

void trim_traverse_loops(struct trim_traverse *c, const struct uv_polygon *loops)
{
    for (size_t i = 0; i < loops->n; i++) {
        const struct uvs *loop = &loops->item[i];
        struct trim_snap_point *point = mem_alloc(loop->n, sizeof *point);
        struct uv *at = mem_alloc(loop->n, sizeof *at);
        size_t n = loop_on_lattice(c, loop, uv_polygon_backwards(loops, i, c->open), point, at);
        if (n >= 3)
            trace_loop(c, point, at, n);
        free(point);
        free(at);
    }
}
