/*
 * trimcut - the polygons are followed from cell to cell on a lattice of whole numbers, where the
 * lines are even and the polygons' corners odd: no corner ever lies on a line, and what lies where
 * is decided without rounding.  Inside a cell the pieces of the polygons and of the cell's own
 * border are joined to closed polygons (Weiler and Atherton 1977).
 */
#include "trimcut.h"

#include <stdint.h>
#include <stdlib.h>

#include "earclip.h"

/* Steps of the lattice over the whole grid (even), and how near to a line a corner is taken to lie
 * on it. */
enum { STEPS = 1 << 28, NEAR = 32 };

struct lattice_point {
    int64_t u, v;
};

struct axis {
    double from, width;
    size_t n;      /* lines */
    int64_t *line; /* on the lattice, even */
};

/* A piece of a polygon inside one cell: vertices first..first + n - 1 of the list of ids. */
struct chain {
    size_t cell, first, n;
    int side_in, side_out; /* bottom, right, top, left: 0 to 3 */
    double in, out;        /* how far along the side, counter-clockwise */
    bool used;
};

struct chains {
    size_t n, cap;
    struct chain *item;
};

struct cut {
    struct axis u, v;
    const double *u_line, *v_line;
    struct uvmesh *mesh;
    struct ints id; /* vertices of all chains */
    struct chains chain;
    int *turn;     /* [line of v][column + 1]: loops crossing it upwards less those downwards */
    bool *crossed; /* [cell] */
    bool open;
};

static struct axis axis_of(const struct doubles *x)
{
    struct axis a = {.from = x->item[0], .width = x->item[x->n - 1] - x->item[0], .n = x->n};
    a.line = mem_alloc(a.n, sizeof *a.line);
    for (size_t i = 0; i < a.n; i++)
        a.line[i] = 2 * (int64_t)floor((x->item[i] - a.from) / a.width * STEPS + 0.5);
    return a;
}

/* How many lines lie below x: the column of x is one less. */
static size_t lines_below(const struct axis *a, int64_t x)
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

/* A corner's place on the lattice, odd.  On the border of the grid it goes outside, on a line
 * within to the side `inwards` of the polygon, so that it leaves no sliver. */
static int64_t place_on(const struct axis *a, double x, double inwards)
{
    double part = fmin(fmax((x - a->from) / a->width, -0.01), 1.01);
    int64_t at = 2 * (int64_t)floor(part * STEPS) + 1;
    size_t above = lines_below(a, at);
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

static double loop_area(const struct uvs *loop)
{
    double area = 0;
    struct uv o = loop->item[0];
    for (size_t i = 0, k = loop->n - 1; i < loop->n; k = i++) {
        struct uv a = loop->item[k], b = loop->item[i];
        area += (a.u - o.u) * (b.v - o.v) - (b.u - o.u) * (a.v - o.v);
    }
    return area / 2;
}

/* Does the loop go round the place?  Crossings of the ray to the right. */
static bool goes_round(const struct uvs *loop, struct uv p)
{
    bool inside = false;
    for (size_t i = 0, k = loop->n - 1; i < loop->n; k = i++) {
        struct uv a = loop->item[k], b = loop->item[i];
        if ((a.v > p.v) != (b.v > p.v) && p.u < a.u + (p.v - a.v) / (b.v - a.v) * (b.u - a.u))
            inside = !inside;
    }
    return inside;
}

bool trimcut_inside(const struct uvloops *loops, bool open, struct uv at)
{
    bool inside = open;
    for (size_t i = 0; i < loops->n; i++)
        if (goes_round(&loops->item[i], at))
            inside = !inside;
    return inside;
}

/* The inside shall lie to the left of each loop: one that runs the other way is taken backwards. */
static bool is_backwards(const struct uvloops *loops, size_t index, bool open)
{
    const struct uvs *loop = &loops->item[index];
    bool hole = open;
    for (size_t i = 0; i < loops->n; i++)
        if (i != index && goes_round(&loops->item[i], loop->item[0]))
            hole = !hole;
    return (loop_area(loop) > 0) == hole;
}

/* The loop's corners in order, on the lattice, without repetitions; `at` gets them as they are. */
static size_t loop_on_lattice(const struct cut *c, const struct uvs *loop, bool backwards,
                              struct lattice_point *point, struct uv *at)
{
    size_t n = loop->n, count = 0;
    for (size_t i = 0; i < n; i++) {
        struct uv before = loop->item[backwards ? (n - i) % n : (i + n - 1) % n];
        struct uv here = loop->item[backwards ? n - 1 - i : i];
        struct uv behind = loop->item[backwards ? (2 * n - 2 - i) % n : (i + 1) % n];
        struct lattice_point p = {place_on(&c->u, here.u, before.v - behind.v),
                                  place_on(&c->v, here.v, behind.u - before.u)};
        if (count > 0 && point[count - 1].u == p.u && point[count - 1].v == p.v)
            continue;
        point[count] = p;
        at[count++] = here;
    }
    while (count > 1 && point[count - 1].u == point[0].u && point[count - 1].v == point[0].v)
        count--;
    return count;
}

static int add_vertex(struct cut *c, struct uv at)
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
    struct chain chain;
};

static bool in_grid(const struct cut *c, size_t column, size_t row)
{
    return column > 0 && column < c->u.n && row > 0 && row < c->v.n;
}

/* The next line that the way from a to b crosses in one direction: how far along, as a fraction. */
static bool next_line(const struct axis *x, size_t below, int64_t a, int64_t b, int64_t *numerator,
                      size_t *line)
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
static void cross(struct cut *c, struct walk *w, int side, int vertex, double along)
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
    w->chain = (struct chain){.first = c->id.n, .n = 1, .side_in = opposite[side]};
    w->chain.in = along_side(opposite[side], along);
    *array_push(&c->id) = vertex;
}

/* The vertex where the way goes over a line: a corner that was moved off that line by one step
 * stands for it itself. */
static int crossing(struct cut *c, int64_t done, int64_t whole, struct uv at, const int id[2])
{
    return done == 1 ? id[0] : done == whole - 1 ? id[1] : add_vertex(c, at);
}

/* From a to b, line after line; the places on the lattice, as they are, and their vertices. Returns
 * how many. */
static size_t follow(struct cut *c, struct walk *w, const struct lattice_point p[2],
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

static void trace_loop(struct cut *c, const struct lattice_point *point, const struct uv *at,
                       size_t n)
{
    struct walk w = {.column = lines_below(&c->u, point[0].u),
                     .row = lines_below(&c->v, point[0].v)};
    size_t first_chain = c->chain.n, begin = c->id.n;
    struct chain opening = {0};
    bool begun = false;
    int first_id = (int)c->mesh->at.n;
    for (size_t i = 0; i < n; i++)
        add_vertex(c, at[i]);
    w.chain = (struct chain){.first = begin};
    for (size_t i = 0; i < n; i++) {
        struct lattice_point p[2] = {point[i], point[(i + 1) % n]};
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
    struct chain whole = w.chain;
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

static void trace_loops(struct cut *c, const struct uvloops *loops)
{
    for (size_t i = 0; i < loops->n; i++) {
        const struct uvs *loop = &loops->item[i];
        struct lattice_point *point = mem_alloc(loop->n, sizeof *point);
        struct uv *at = mem_alloc(loop->n, sizeof *at);
        size_t n = loop_on_lattice(c, loop, is_backwards(loops, i, c->open), point, at);
        if (n >= 3)
            trace_loop(c, point, at, n);
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

static int compare_chains(const void *p, const void *q)
{
    const struct chain *a = p, *b = q;
    if (a->cell != b->cell)
        return a->cell < b->cell ? -1 : 1;
    return a->first < b->first ? -1 : a->first > b->first;
}

struct polygon {
    struct ints id;
    struct uvs at;
};

/* The vertex at a corner of a cell, 0 to 3 from the lower left, counter-clockwise. */
static int corner_of(const struct cut *c, size_t cell, int corner)
{
    size_t column = cell % (c->u.n - 1) + (corner == 1 || corner == 2 ? 1 : 0);
    size_t row = cell / (c->u.n - 1) + (corner >= 2 ? 1 : 0);
    return (int)(row * c->u.n + column);
}

/* Its corners are scaled to the cell, so that the shape of an ear means something. */
static void add_corner(const struct cut *c, size_t cell, struct polygon *p, int id)
{
    size_t column = cell % (c->u.n - 1), row = cell / (c->u.n - 1);
    struct uv at = c->mesh->at.item[id];
    double u = c->u_line[column], v = c->v_line[row];
    if (p->id.n > 0 && p->id.item[p->id.n - 1] == id)
        return;
    *array_push(&p->id) = id;
    *array_push(&p->at) = (struct uv){(at.u - u) / (c->u_line[column + 1] - u),
                                      (at.v - v) / (c->v_line[row + 1] - v)};
}

/* Round one polygon from a chain on: along it, along the border to the next that enters, and so on.
 * False when the ends do not go in and out by turns. */
static bool round_polygon(struct cut *c, struct chain *chain, const struct end *end, size_t ends,
                          size_t start, struct polygon *p)
{
    size_t cell = chain[0].cell, now = start;
    p->id.n = p->at.n = 0;
    do {
        struct chain *k = &chain[now];
        k->used = true;
        for (size_t i = 0; i < k->n; i++)
            add_corner(c, cell, p, c->id.item[k->first + i]);
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
            add_corner(c, cell, p, corner_of(c, cell, side));
            wraps = wraps && side != 0;
        }
        now = end[next].chain;
    } while (!chain[now].used);
    return now == start;
}

static bool corner_inside(const struct cut *c, const int *inside, size_t column, size_t row)
{
    return inside[row * c->u.n + column] > 0;
}

static void add_cell(struct cut *c, size_t cell)
{
    int a = corner_of(c, cell, 0), b = corner_of(c, cell, 1);
    int d = corner_of(c, cell, 2), e = corner_of(c, cell, 3);
    *array_push(&c->mesh->face) = (struct face){{a, b, d}};
    *array_push(&c->mesh->face) = (struct face){{a, d, e}};
}

/* The chains of one cell. */
static void cut_cell(struct cut *c, struct chain *chain, size_t n, const int *inside,
                     struct polygon *p)
{
    struct end *end = mem_alloc(2 * n, sizeof *end);
    size_t cell = chain[0].cell, before = c->mesh->face.n;
    bool sound = true;
    for (size_t i = 0; i < n; i++) {
        end[2 * i] = (struct end){chain[i].side_in, chain[i].in, true, i};
        end[2 * i + 1] = (struct end){chain[i].side_out, chain[i].out, false, i};
    }
    qsort(end, 2 * n, sizeof *end, compare_ends);
    for (size_t i = 0; i < n && sound; i++) {
        if (chain[i].used)
            continue;
        sound = round_polygon(c, chain, end, 2 * n, i, p);
        if (sound && p->id.n > 1 && p->id.item[0] == p->id.item[p->id.n - 1])
            p->id.n--;
        if (sound)
            earclip(p->at.item, p->id.item, p->id.n, &c->mesh->face);
    }
    free(end);
    if (sound)
        return;
    c->mesh->face.n = before;
    c->mesh->unclear++;
    size_t column = cell % (c->u.n - 1), row = cell / (c->u.n - 1);
    if (corner_inside(c, inside, column, row) && corner_inside(c, inside, column + 1, row) &&
        corner_inside(c, inside, column, row + 1) && corner_inside(c, inside, column + 1, row + 1))
        add_cell(c, cell);
}

/* How many loops go round each node, from the left; a hole takes one off. */
static int *count_inside(const struct cut *c)
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

static void cut_cells(struct cut *c)
{
    struct polygon polygon = {0};
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
        cut_cell(c, &c->chain.item[at], n, inside, &polygon);
        at += n;
    }
    array_free(&polygon.id);
    array_free(&polygon.at);
    free(inside);
}

/* A loop between two lines in both directions would be a hole inside a cell, or alone in it: a line
 * through its middle. */
static void part_lone_loops(struct doubles *u, const struct doubles *v, const struct uvloops *loops)
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

void trimcut(struct doubles *u, const struct doubles *v, const struct uvloops *loops, bool open,
             struct uvmesh *mesh)
{
    *mesh = (struct uvmesh){0};
    part_lone_loops(u, v, loops);
    struct cut c = {.u = axis_of(u),
                    .v = axis_of(v),
                    .u_line = u->item,
                    .v_line = v->item,
                    .mesh = mesh,
                    .open = open};
    c.turn = mem_alloc(v->n * (u->n + 1), sizeof *c.turn);
    c.crossed = mem_alloc((u->n - 1) * (v->n - 1), sizeof *c.crossed);
    for (size_t row = 0; row < v->n; row++)
        for (size_t column = 0; column < u->n; column++)
            *array_push(&mesh->at) = (struct uv){u->item[column], v->item[row]};
    trace_loops(&c, loops);
    cut_cells(&c);
    free(c.u.line);
    free(c.v.line);
    free(c.turn);
    free(c.crossed);
    array_free(&c.id);
    array_free(&c.chain);
}

void uvloops_free(struct uvloops *loops)
{
    for (size_t i = 0; i < loops->n; i++)
        array_free(&loops->item[i]);
    array_free(loops);
}

void uvmesh_free(struct uvmesh *mesh)
{
    array_free(&mesh->at);
    array_free(&mesh->face);
}
