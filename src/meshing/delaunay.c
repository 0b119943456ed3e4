/* delaunay - see delaunay.h. */
#include "delaunay.h"

#include <stdint.h>
#include <stdlib.h>

#include "delaunay_order.h"
#include "math/elementary.h"
#include "math/predicates.h"

static int next_of(int i)
{
    return i == 2 ? 0 : i + 1;
}

static struct uv corner(const struct delaunay *d, const struct delaunay_triangle *t, int i)
{
    return d->at[t->v[i]];
}

static int add_triangle(struct delaunay *d)
{
    *array_push(&d->t) = (struct delaunay_triangle){.locked = 0};
    return (int)d->t.n - 1;
}

static void set_triangle(struct delaunay *d, int t, struct delaunay_triangle to)
{
    d->t.item[t] = to;
    for (int i = 0; i < 3; i++)
        d->triangle[to.v[i]] = t;
    if (d->record)
        *array_push(&d->changed) = t;
}

/* Where a triangle had `from` beside it, it has `to`. */
static void relink(struct delaunay *d, int t, int from, int to)
{
    if (t == DELAUNAY_NONE)
        return;
    int *beside = d->t.item[t].beside;
    beside[beside[0] == from ? 0 : beside[1] == from ? 1 : 2] = to;
}

struct delaunay delaunay_new(const struct vec3 *point, size_t n)
{
    struct delaunay d = {.n = (int)n,
                         .at = mem_alloc(n + 3, sizeof *d.at),
                         .triangle = mem_alloc(n + 3, sizeof *d.triangle)};
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};

    for (size_t i = 0; i < n; i++) {
        d.at[i] = (struct uv){point[i].x, point[i].y};
        d.triangle[i] = DELAUNAY_NONE;
        low[0] = fmin(low[0], point[i].x);
        low[1] = fmin(low[1], point[i].y);
        high[0] = fmax(high[0], point[i].x);
        high[1] = fmax(high[1], point[i].y);
    }
    double x = (low[0] + high[0]) / 2, y = (low[1] + high[1]) / 2;
    double far = DELAUNAY_FAR * fmax(fmax(high[0] - low[0], high[1] - low[1]), 1e-6);
    d.at[n] = (struct uv){x - 2 * far, y - far};
    d.at[n + 1] = (struct uv){x + 2 * far, y - far};
    d.at[n + 2] = (struct uv){x, y + 2 * far};
    int first = add_triangle(&d), a = (int)n;
    set_triangle(&d, first,
                 (struct delaunay_triangle){
                     {a, a + 1, a + 2}, {DELAUNAY_NONE, DELAUNAY_NONE, DELAUNAY_NONE}, 0});
    return d;
}

void delaunay_free(struct delaunay *d)
{
    free(d->at);
    free(d->triangle);
    array_free(&d->t);
    array_free(&d->changed);
    array_free(&d->stack);
}

int delaunay_locate(struct delaunay *d, struct uv p)
{
    int t = d->last, from = DELAUNAY_NONE;

    for (int step = 0;; step = next_of(step)) { /* not always the same edge first: no circles */
        const struct delaunay_triangle *at = &d->t.item[t];
        int to = DELAUNAY_NONE;
        for (int i = 0, k = step; i < 3 && to == DELAUNAY_NONE; i++, k = next_of(k))
            if (at->beside[k] != from && at->beside[k] != DELAUNAY_NONE &&
                orient2d(corner(d, at, k), corner(d, at, next_of(k)), p) < 0)
                to = at->beside[k];
        if (to == DELAUNAY_NONE)
            return d->last = t;
        from = t;
        t = to;
    }
}

/* The bit of edge i of a triangle as bit k of another one. */
static unsigned char bit_as(const struct delaunay_triangle *t, int i, int k)
{
    return (unsigned char)((t->locked >> i & 1) << k);
}

/* The edge from corner 1 of triangle t, whose corner 0 is new, gives way to the other diagonal.
 * `split`: the new point lies on it, and takes over its lock. */
static int turn_edge(struct delaunay *d, int t, bool split)
{
    struct delaunay_triangle mine = d->t.item[t], its = d->t.item[mine.beside[1]];
    int u = mine.beside[1], k = its.beside[0] == t ? 0 : its.beside[1] == t ? 1 : 2;
    int after = next_of(k), before = next_of(after), far = its.v[before];
    unsigned char both = split && (mine.locked & 2) ? 1 : 0;

    set_triangle(d, t,
                 (struct delaunay_triangle){
                     {mine.v[0], mine.v[1], far},
                     {mine.beside[0], its.beside[after], u},
                     (unsigned char)(bit_as(&mine, 0, 0) | bit_as(&its, after, 1) | both)});
    set_triangle(d, u,
                 (struct delaunay_triangle){
                     {mine.v[0], far, mine.v[2]},
                     {t, its.beside[before], mine.beside[2]},
                     (unsigned char)(bit_as(&its, before, 1) | bit_as(&mine, 2, 2) | both << 2)});
    relink(d, its.beside[after], u, t);
    relink(d, mine.beside[2], t, u);
    return u;
}

/* Locks the edges of the new point that are its own side of a locked edge that it split. */
static void lock_other_sides(struct delaunay *d, int t, int u)
{
    delaunay_lock(d, t, 0);
    delaunay_lock(d, u, 2);
}

/* Turns edges opposite to the new point, corner 0 of the triangles on the stack. */
static void turn_edges(struct delaunay *d)
{
    while (d->stack.n > 0) {
        int t = d->stack.item[--d->stack.n];
        const struct delaunay_triangle *mine = &d->t.item[t];
        int beyond = mine->beside[1];
        if (beyond == DELAUNAY_NONE)
            continue;
        const struct delaunay_triangle *its = &d->t.item[beyond];
        int k = its->beside[0] == t ? 0 : its->beside[1] == t ? 1 : 2;
        struct uv p = corner(d, mine, 0), a = corner(d, mine, 1), b = corner(d, mine, 2);
        bool split = orient2d(p, a, b) == 0, locked = mine->locked & 2;
        if (!split && (locked || incircle(p, a, b, corner(d, its, (k + 2) % 3)) <= 0))
            continue;
        int u = turn_edge(d, t, split);
        if (split && locked)
            lock_other_sides(d, t, u);
        *array_push(&d->stack) = t;
        *array_push(&d->stack) = u;
    }
}

bool delaunay_insert_in(struct delaunay *d, int t, int i)
{
    struct delaunay_triangle old = d->t.item[t];
    int f[3] = {t, 0, 0};

    for (int k = 0; k < 3; k++)
        if (d->at[old.v[k]].u == d->at[i].u && d->at[old.v[k]].v == d->at[i].v)
            return false;
    f[1] = add_triangle(d);
    f[2] = add_triangle(d);
    for (int k = 0; k < 3; k++) {
        set_triangle(d, f[k],
                     (struct delaunay_triangle){{i, old.v[k], old.v[next_of(k)]},
                                                {f[(k + 2) % 3], old.beside[k], f[next_of(k)]},
                                                bit_as(&old, k, 1)});
        relink(d, old.beside[k], t, f[k]);
        *array_push(&d->stack) = f[k];
    }
    turn_edges(d);
    d->last = d->triangle[i];
    return true;
}

bool delaunay_insert(struct delaunay *d, int i)
{
    return delaunay_insert_in(d, delaunay_locate(d, d->at[i]), i);
}

void delaunay_insert_all(struct delaunay *d)
{
    int *order = delaunay_order(d->at, (size_t)d->n);

    array_reserve(&d->t, 2 * (size_t)d->n + 8);
    for (int k = 0; k < d->n; k++)
        delaunay_insert(d, order[k]);
    free(order);
}

/* From triangle t on about point a, one way (side 2) or the other (side 0), the one with the edge
 * to b. */
static int turn_about(const struct delaunay *d, int t, int a, int b, int side, int *edge)
{
    int first = t;

    do {
        const struct delaunay_triangle *at = &d->t.item[t];
        *edge = at->v[0] == a ? 0 : at->v[1] == a ? 1 : 2;
        if (at->v[next_of(*edge)] == b)
            return t;
        t = at->beside[(*edge + side) % 3];
    } while (t != first && t != DELAUNAY_NONE);
    return DELAUNAY_NONE;
}

int delaunay_edge(const struct delaunay *d, int a, int b, int *edge)
{
    int first = d->triangle[a], t = turn_about(d, first, a, b, 2, edge);

    if (t == DELAUNAY_NONE && a >= d->n) /* beyond the far points there is nothing */
        t = turn_about(d, first, a, b, 0, edge);
    return t;
}

void delaunay_lock(struct delaunay *d, int t, int edge)
{
    int beside = d->t.item[t].beside[edge];

    d->t.item[t].locked |= (unsigned char)(1 << edge);
    if (beside != DELAUNAY_NONE) {
        const int *back = d->t.item[beside].beside;
        d->t.item[beside].locked |= (unsigned char)(1 << (back[0] == t ? 0 : back[1] == t ? 1 : 2));
    }
}

bool delaunay_is_near(const struct delaunay *d, int triangle)
{
    const int *v = d->t.item[triangle].v;

    return v[0] < d->n && v[1] < d->n && v[2] < d->n;
}

double delaunay_diameter(const struct delaunay *d, int triangle)
{
    const struct delaunay_triangle *t = &d->t.item[triangle];
    double product = 1, area2;

    for (int i = 0; i < 3; i++) {
        struct uv a = corner(d, t, i), b = corner(d, t, next_of(i));
        product *= hypot(b.u - a.u, b.v - a.v);
    }
    struct uv a = corner(d, t, 0), b = corner(d, t, 1), c = corner(d, t, 2);
    area2 = (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
    return area2 > 0 ? product / area2 : HUGE_VAL;
}

/* The edge of the triangle about a that the way to b leaves by, and turns it if both sides together
 * are convex; goes on along the way else.  False: none could be turned. */
static bool turn_across(struct delaunay *d, int a, int b)
{
    int edge, t = d->triangle[a];

    for (int first = t;;) { /* where b lies between the sides of the triangle at a */
        const struct delaunay_triangle *at = &d->t.item[t];
        edge = at->v[0] == a ? 0 : at->v[1] == a ? 1 : 2;
        if (orient2d(d->at[a], corner(d, at, next_of(edge)), d->at[b]) >= 0 &&
            orient2d(corner(d, at, (edge + 2) % 3), d->at[a], d->at[b]) >= 0)
            break;
        t = at->beside[(edge + 2) % 3];
        if (t == first || t == DELAUNAY_NONE)
            return false;
    }
    struct delaunay_triangle mine = d->t.item[t];
    struct delaunay_triangle turned = {.locked = 0};
    for (int i = 0; i < 3; i++) { /* a to the front */
        int k = (edge + i) % 3;
        turned.v[i] = mine.v[k];
        turned.beside[i] = mine.beside[k];
        turned.locked |= bit_as(&mine, k, i);
    }
    if (turned.beside[1] == DELAUNAY_NONE || (turned.locked & 2))
        return false;
    const struct delaunay_triangle *its = &d->t.item[turned.beside[1]];
    int k = its->beside[0] == t ? 0 : its->beside[1] == t ? 1 : 2;
    struct uv far = corner(d, its, (k + 2) % 3);
    if (orient2d(d->at[a], d->at[turned.v[1]], far) <= 0 ||
        orient2d(d->at[a], far, d->at[turned.v[2]]) <= 0)
        return false;
    d->t.item[t] = turned;
    turn_edge(d, t, false);
    return true;
}

bool delaunay_force(struct delaunay *d, int a, int b)
{
    enum { TURNS = 100 };
    int edge;

    for (int turn = 0; turn < TURNS; turn++) {
        if (delaunay_edge(d, a, b, &edge) != DELAUNAY_NONE)
            return true;
        if (!turn_across(d, a, b) && !turn_across(d, b, a))
            return false;
    }
    return false;
}
