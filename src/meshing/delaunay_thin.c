/* delaunay_thin - see delaunay_thin.h. */
#include "delaunay_thin.h"

#include <stdlib.h>

#include "delaunay_border.h"
#include "math/elementary.h"
#include "math/box_tree.h"
#include "math/predicates.h"

/* ---- the border */

/* Which points of each loop stay; how many. */
static size_t thin_border(const struct scan_border *border, const struct vec3 *point,
                          double tolerance, bool **keep)
{
    size_t kept = 0;

    for (size_t k = 0; k < border->n; k++) {
        scan_border_thin(&border->item[k], point, tolerance, keep[k]);
        for (size_t i = 0; i < border->item[k].n; i++)
            kept += keep[k][i];
    }
    return kept;
}

/* The next point of a loop that stays, from `i` on, up to n for the first. */
static size_t next_kept(const struct ints *loop, const bool *keep, size_t i)
{
    for (i++; i < loop->n && !keep[i]; i++)
        ;
    return i;
}

static int first_kept(const struct ints *loop, const bool *keep)
{
    return loop->item[keep[0] ? 0 : next_kept(loop, keep, 0)];
}

static void put_in(struct delaunay *d, const struct ints *loop, bool *keep, size_t i)
{
    keep[i] = true;
    if (d->triangle[loop->item[i]] == DELAUNAY_NONE)
        delaunay_insert(d, loop->item[i]);
}

/* Lines that are no edge of the triangulation get a point of the border more.  True: some did. */
static bool refine_loop(struct delaunay *d, const struct ints *loop, const struct vec3 *point,
                        bool *keep)
{
    bool refined = false;
    double off;
    int edge;

    for (size_t i = 0, to; i < loop->n; i = to) {
        to = next_kept(loop, keep, i);
        int end = to < loop->n ? loop->item[to] : first_kept(loop, keep);
        if (to - i < 2 || delaunay_edge(d, loop->item[i], end, &edge) != DELAUNAY_NONE)
            continue;
        put_in(d, loop, keep, scan_border_farthest(loop, point, i, to, &off));
        refined = true;
    }
    return refined;
}

/* The lines between kept points as edges of the triangulation. */
static void put_border_in(struct delaunay *d, const struct vec3 *point,
                          const struct scan_border *border, bool **keep)
{
    bool refined = true;

    for (size_t k = 0; k < border->n; k++)
        for (size_t i = 0; i < border->item[k].n; i++)
            if (keep[k][i])
                put_in(d, &border->item[k], keep[k], i);
    while (refined) {
        refined = false;
        for (size_t k = 0; k < border->n; k++)
            refined |= refine_loop(d, &border->item[k], point, keep[k]);
    }
}

/* Locks the edges of the border and marks the triangles beside them: 1 surface, 2 none. */
static void lock_border(struct delaunay *d, const struct scan_border *border, bool **keep,
                        unsigned char *side)
{
    for (int turn = 0; turn < 2; turn++) /* forced edges first: they turn others */
        for (size_t k = 0; k < border->n; k++) {
            const struct ints *loop = &border->item[k];
            for (size_t i = 0, to; i < loop->n; i = to) {
                to = next_kept(loop, keep[k], i);
                int edge, a = loop->item[i], t;
                int b = to < loop->n ? loop->item[to] : first_kept(loop, keep[k]);
                if (turn == 0 && !delaunay_force(d, a, b))
                    continue;
                t = delaunay_edge(d, a, b, &edge);
                if (t == DELAUNAY_NONE)
                    continue;
                delaunay_lock(d, t, edge);
                int beyond = d->t.item[t].beside[edge];
                if (turn == 1)
                    side[t] = 1;
                if (turn == 1 && beyond != DELAUNAY_NONE && side[beyond] == 0)
                    side[beyond] = 2;
            }
        }
}

/* Spreads what the triangles beside the border are to all others, up to locked edges. */
static void spread_sides(const struct delaunay *d, unsigned char *side)
{
    struct ints todo = {0};

    for (int t = 0; t < (int)d->t.n; t++) {
        if (side[t] == 0 && !delaunay_is_near(d, t))
            side[t] = 2;
        if (side[t] > 0)
            *array_push(&todo) = t;
    }
    for (size_t next = 0; next < todo.n; next++) {
        const struct delaunay_triangle *t = &d->t.item[todo.item[next]];
        for (int k = 0; k < 3; k++)
            if (!(t->locked >> k & 1) && t->beside[k] != DELAUNAY_NONE && side[t->beside[k]] == 0) {
                side[t->beside[k]] = side[todo.item[next]];
                *array_push(&todo) = t->beside[k];
            }
    }
    array_free(&todo);
}

/* ---- the points over the triangles */

struct candidate {
    double off; /* mm */
    int triangle;
    int turn; /* of the triangle when it was found */
};

/* What is known of a triangle. */
struct over {
    int first; /* of the points over it, NONE: there is none */
    int worst; /* the one farthest off */
    int turn;  /* how often it has changed */
    bool surface;
};

struct thinning {
    struct delaunay *d;
    const struct vec3 *point;
    int *next; /* of each point: the next one over the same triangle */
    struct {
        size_t n, cap;
        struct over *item;
    } over;
    struct {
        size_t n, cap;
        struct candidate *item;
    } heap;           /* the farthest off first */
    struct ints pool; /* points to be put over triangles anew */
};

static bool is_before(const struct candidate *a, const struct candidate *b)
{
    if (a->off > b->off || a->off < b->off)
        return a->off > b->off;
    return a->triangle < b->triangle;
}

static void heap_push(struct thinning *w, struct candidate c)
{
    size_t i = w->heap.n;

    for (*array_push(&w->heap) = c; i > 0; i = (i - 1) / 2) {
        struct candidate *up = &w->heap.item[(i - 1) / 2];
        if (!is_before(&c, up))
            break;
        w->heap.item[i] = *up;
        *up = c;
    }
}

static struct candidate heap_pop(struct thinning *w)
{
    struct candidate top = w->heap.item[0], last = w->heap.item[--w->heap.n];
    size_t i = 0;

    for (size_t k; (k = 2 * i + 1) < w->heap.n; i = k) {
        if (k + 1 < w->heap.n && is_before(&w->heap.item[k + 1], &w->heap.item[k]))
            k++;
        if (!is_before(&w->heap.item[k], &last))
            break;
        w->heap.item[i] = w->heap.item[k];
    }
    w->heap.item[i] = last;
    return top;
}

/* Is a point on a locked edge of a triangle, or at one of its corners? */
static bool is_on_border(const struct delaunay *d, const struct delaunay_triangle *t, int i)
{
    struct uv p = d->at[i];

    for (int k = 0; k < 3; k++) {
        struct uv a = d->at[t->v[k]], b = d->at[t->v[(k + 1) % 3]];
        if ((t->locked >> k & 1) && orient2d(a, b, p) == 0)
            return true;
        if (!(a.u < p.u || a.u > p.u || a.v < p.v || a.v > p.v))
            return true;
    }
    return false;
}

/* The point over a triangle that is farthest off, to the heap. */
static void find_worst(struct thinning *w, int triangle)
{
    const struct delaunay_triangle *t = &w->d->t.item[triangle];
    struct over *over = &w->over.item[triangle];
    double worst = 0;

    over->turn++;
    if (!over->surface)
        return;
    struct facet facet = {{w->point[t->v[0]], w->point[t->v[1]], w->point[t->v[2]]}};
    for (int i = over->first; i != DELAUNAY_NONE; i = w->next[i]) {
        double off = vec_distance(facet_nearest(&facet, w->point[i]), w->point[i]);
        if (off > worst && !is_on_border(w->d, t, i)) {
            worst = off;
            over->worst = i;
        }
    }
    if (worst > 0)
        heap_push(w, (struct candidate){worst, triangle, over->turn});
}

static void put_over(struct thinning *w, int triangle, int i)
{
    w->next[i] = w->over.item[triangle].first;
    w->over.item[triangle].first = i;
}

/* Points are over new triangles. */
static void spread_pool(struct thinning *w)
{
    for (size_t k = 0; k < w->pool.n; k++) {
        int i = w->pool.item[k];
        put_over(w, delaunay_locate(w->d, w->d->at[i]), i);
    }
    w->pool.n = 0;
}

/* The worst point over a triangle becomes a vertex. */
static void add_worst(struct thinning *w, int triangle)
{
    struct delaunay *d = w->d;
    int new = w->over.item[triangle].worst;

    d->changed.n = 0;
    delaunay_insert_in(d, triangle, new);
    while (w->over.n < d->t.n)
        *array_push(&w->over) = (struct over){DELAUNAY_NONE, DELAUNAY_NONE, 0, true};
    for (size_t k = 0; k < d->changed.n; k++) {
        struct over *over = &w->over.item[d->changed.item[k]];
        for (int i = over->first; i != DELAUNAY_NONE; i = w->next[i])
            if (i != new)
                *array_push(&w->pool) = i;
        over->first = DELAUNAY_NONE;
    }
    spread_pool(w);
    for (size_t k = 0; k < d->changed.n; k++) { /* those that are there twice count once */
        int t = d->changed.item[k];
        bool again = false;
        for (size_t j = 0; j < k && !again; j++)
            again = d->changed.item[j] == t;
        if (!again)
            find_worst(w, t);
    }
}

static void put_points_over(struct thinning *w, const unsigned char *side)
{
    struct delaunay *d = w->d;

    for (size_t t = 0; t < d->t.n; t++)
        *array_push(&w->over) = (struct over){DELAUNAY_NONE, DELAUNAY_NONE, 0, side[t] == 1};
    for (int i = 0; i < d->n; i++)
        if (d->triangle[i] == DELAUNAY_NONE)
            put_over(w, delaunay_locate(d, d->at[i]), i);
    for (size_t t = 0; t < d->t.n; t++)
        find_worst(w, (int)t);
}

/* ---- both */

static size_t count_corners(const struct delaunay *d)
{
    size_t corners = 0;

    for (int i = 0; i < d->n; i++)
        corners += d->triangle[i] != DELAUNAY_NONE;
    return corners;
}

/* The border by the error or, without one, by half the count. */
static void make_border(struct delaunay *d, const struct vec3 *point,
                        const struct scan_border *border,
                        const struct delaunay_mesh_options *options, bool **keep)
{
    const double part = 0.25; /* points just beyond a line bulge over its border's own lines */
    double tolerance = options->error > 0 ? part * options->error : options->gap / 64;
    size_t kept = thin_border(border, point, tolerance, keep);

    for (; options->keep > 0 && 2 * kept > options->keep && tolerance < 1e3 * options->gap;
         tolerance *= 1.5)
        kept = thin_border(border, point, tolerance, keep);
    put_border_in(d, point, border, keep);
}

bool *delaunay_thin(struct delaunay *d, const struct vec3 *point, const struct scan_border *border,
                    const struct delaunay_mesh_options *options)
{
    struct thinning w = {.d = d, .point = point, .next = mem_alloc((size_t)d->n, sizeof *w.next)};
    bool **keep = mem_alloc(border->n + 1, sizeof *keep);

    for (size_t k = 0; k < border->n; k++)
        keep[k] = mem_alloc(border->item[k].n, sizeof **keep);
    make_border(d, point, border, options, keep);
    unsigned char *side = mem_alloc(d->t.n, 1);
    lock_border(d, border, keep, side);
    spread_sides(d, side);
    d->record = true;
    put_points_over(&w, side);
    size_t corners = count_corners(d);
    while (w.heap.n > 0 && w.heap.item[0].off > options->error &&
           (options->keep == 0 || corners < options->keep)) {
        struct candidate c = heap_pop(&w);
        if (w.over.item[c.triangle].turn == c.turn) {
            add_worst(&w, c.triangle);
            corners++;
        }
    }
    bool *surface = mem_alloc(d->t.n, sizeof *surface);
    for (size_t t = 0; t < d->t.n; t++)
        surface[t] = w.over.item[t].surface;
    for (size_t k = 0; k < border->n; k++)
        free(keep[k]);
    free(keep);
    free(side);
    free(w.next);
    array_free(&w.over);
    array_free(&w.heap);
    array_free(&w.pool);
    return surface;
}
