/* skin_slits - see skin_slits.h. */
#include "skin_slits.h"

#include <stdlib.h>

#include "base/num.h"
#include "math/elementary.h"
#include "skin_folds.h"
#include "skin_sides.h"

/* Corners of a loop that is looked at: a longer one is no slit, but a border. */
enum { CORNERS_MAX = 2000, NONE = -1 };

static struct vec3 point_of(const struct patch_mesh *q, int vertex)
{
    return q->vertex.item[q->vertex.item[vertex].place].point;
}

/* An open edge in the direction that a facet on its open side has it: 2 i of rims.item[i]; 2 i + 1
 * is the same edge the other way. */
struct rim {
    int end[2]; /* vertices, of the facet that is there */
    int sheet;
    int next[2]; /* of those that have an end at the same place: 2 i or 2 i + 1, or NONE */
    bool used;
};

/* An edge that filling has added, as the place at one of its ends sees it. */
struct added_edge {
    size_t to;   /* the place at the other end */
    int earlier; /* the one added there before, from 1, or 0 */
};

struct added_edges {
    size_t n, cap;
    struct added_edge *item;
};

struct rims {
    size_t n, cap;
    struct rim *item;
    struct skin_side *side; /* of all facets ... */
    size_t sides;           /* ... so many */
    struct added_edges added;
    int *last_added; /* of each place: the last edge added there, from 1 */
};

static int rim_from(const struct rims *rims, int way)
{
    return rims->item[way / 2].end[way % 2];
}

static int rim_to(const struct rims *rims, int way)
{
    return rims->item[way / 2].end[1 - way % 2];
}

/* The side among those of one edge whose facet has no other on its other side: of an odd number of
 * facets, one of those that are one more.  So the open edges of a skin form loops, whatever meets
 * along them and however it is turned.  NULL: they are in pairs. */
static const struct skin_side *odd_side(const struct skin_side *side, size_t k)
{
    size_t forwards = 0;

    for (size_t a = 0; a < k; a++)
        forwards += side[a].forward;
    for (size_t a = 0; a < k && k % 2 == 1; a++)
        if (side[a].forward == (2 * forwards > k))
            return &side[a];
    return NULL;
}

static void find_rims(const struct patch_mesh *q, struct rims *rims, int *first)
{
    size_t n;
    struct skin_side *side = skin_sides_find(q, &n);

    rims->side = side;
    rims->sides = n;
    for (size_t i = 0; i < q->vertex.n; i++)
        first[i] = NONE;
    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        const struct skin_side *odd = odd_side(&side[i], k);
        if (!odd)
            continue;
        const int *v = q->face.item[odd->facet].v;
        int a = v[odd->corner], b = v[(odd->corner + 1) % 3];
        int sheet = q->sheet.item[odd->facet];
        bool flip = q->flipped[sheet];
        struct rim r = {.end = {flip ? a : b, flip ? b : a}, .sheet = sheet};
        for (int e = 0; e < 2; e++) {
            size_t place = q->vertex.item[r.end[e]].place;
            r.next[e] = first[place];
            first[place] = 2 * (int)rims->n + e;
        }
        *array_push(rims) = r;
    }
}

static int compare_places(const void *p, const void *q)
{
    const struct skin_side *a = p, *b = q;

    if (a->low != b->low)
        return a->low < b->low ? -1 : 1;
    return (a->high > b->high) - (a->high < b->high);
}

/* Is there an edge between the two vertices' places? */
static bool is_edge(const struct patch_mesh *q, const struct rims *rims, int v, int w)
{
    size_t a = q->vertex.item[v].place, b = q->vertex.item[w].place;
    struct skin_side key = {.low = a < b ? a : b, .high = a < b ? b : a};

    for (int i = rims->last_added[a]; i > 0; i = rims->added.item[i - 1].earlier)
        if (rims->added.item[i - 1].to == b)
            return true;
    return rims->sides > 0 &&
           bsearch(&key, rims->side, rims->sides, sizeof key, compare_places) != NULL;
}

static void add_edge(const struct patch_mesh *q, struct rims *rims, int v, int w)
{
    const size_t end[2] = {q->vertex.item[v].place, q->vertex.item[w].place};
    for (int e = 0; e < 2; e++) {
        *array_push(&rims->added) = (struct added_edge){end[1 - e], rims->last_added[end[e]]};
        rims->last_added[end[e]] = (int)rims->added.n;
    }
}

/* In gaps: a loop so short round is a slit whatever its shape: it is hardly wider. */
static const double SMALL = 4;

/* mm: longer than any diagonal. */
static const double LAST = 1e12;

/* How far corner i of the loop is from its sides that do not end at it. */
static double corner_distance(const struct patch_mesh *q, const struct rims *rims, const int *loop,
                              size_t n, size_t i)
{
    struct vec3 p = point_of(q, rim_from(rims, loop[i]));
    double least = HUGE_VAL;

    for (size_t k = 1; k + 1 < n; k++) {
        int way = loop[(i + k) % n];
        struct vec3 a = point_of(q, rim_from(rims, way)), b = point_of(q, rim_to(rims, way));
        least = fmin(least, vec_segment_distance(a, b, p));
    }
    return least;
}

/* Is corner i the tip of a needle: the nearer of its neighbours within the gap of its other side?
 */
static bool is_tip(const struct patch_mesh *q, const struct rims *rims, const int *loop, size_t n,
                   size_t i, double gap)
{
    struct vec3 p = point_of(q, rim_from(rims, loop[i]));
    struct vec3 next = point_of(q, rim_to(rims, loop[i]));
    struct vec3 last = point_of(q, rim_from(rims, loop[(i + n - 1) % n]));

    return vec_distance(p, next) < vec_distance(p, last)
               ? vec_segment_distance(p, last, next) <= gap
               : vec_segment_distance(p, next, last) <= gap;
}

/* How wide the loop is: how far a corner is, at most, from the sides that do not end at it, tips
 * excepted. */
static double loop_width(const struct patch_mesh *q, const struct rims *rims, const int *loop,
                         size_t n, double gap)
{
    double around = 0, widest = 0;

    for (size_t i = 0; i < n; i++) {
        around +=
            vec_distance(point_of(q, rim_from(rims, loop[i])), point_of(q, rim_to(rims, loop[i])));
    }
    if (around <= SMALL * gap)
        return around / SMALL;
    for (size_t i = 0; i < n && widest <= gap; i++)
        if (!is_tip(q, rims, loop, n, i, gap))
            widest = fmax(widest, corner_distance(q, rims, loop, n, i));
    return widest;
}

/* A loop that is being filled: the corners that are left, and how its facets are turned. */
struct filling {
    struct patch_mesh *q;
    struct rims *rims;
    int *corner;
    size_t n;
    int sheet;
    bool flip;
};

static void add_facet(const struct filling *f, int a, int b, int c)
{
    *array_push(&f->q->face) = (struct face){{a, f->flip ? c : b, f->flip ? b : c}};
    *array_push(&f->q->sheet) = f->sheet;
}

/* The ear with the shortest third side, by its tip; to avoid: a third side that is an edge already,
 * and *has whether there is one that is none. */
static size_t best_ear(const struct filling *f, bool avoid, bool *has)
{
    size_t best = 0, n = f->n;
    double least = HUGE_VAL;
    const int *v = f->corner;
    for (size_t i = 0; i < n; i++) {
        double d = vec_distance(point_of(f->q, v[i]), point_of(f->q, v[(i + 2) % n]));
        d += avoid && n > 3 && is_edge(f->q, f->rims, v[i], v[(i + 2) % n]) ? LAST : 0;
        if (d < least) {
            least = d;
            best = (i + 1) % n;
        }
    }
    *has = least < LAST;
    return best;
}

/* Cuts the ear off. */
static void cut_ear(struct filling *f, size_t tip)
{
    int a = f->corner[(tip + f->n - 1) % f->n], c = f->corner[(tip + 1) % f->n];
    add_facet(f, a, f->corner[tip], c);
    if (f->n > 3)
        add_edge(f->q, f->rims, a, c);
    for (size_t i = tip; i + 1 < f->n; i++)
        f->corner[i] = f->corner[i + 1];
    f->n--;
}

/* The facets from a vertex in the middle to each side; false if on the printed digits it is at a
 * corner. */
static bool fill_from_middle(struct filling *f)
{
    struct vec3 sum = vec(0, 0, 0);
    for (size_t i = 0; i < f->n; i++)
        sum = vec_add(sum, point_of(f->q, f->corner[i]));
    sum = vec_scale(1 / (double)f->n, sum);
    struct patch_mesh_vertex v = f->q->vertex.item[f->corner[0]];
    v.point = vec(num_round(sum.x, PATCH_MESH_DIGITS), num_round(sum.y, PATCH_MESH_DIGITS),
                  num_round(sum.z, PATCH_MESH_DIGITS));
    for (size_t i = 0; i < f->n; i++)
        if (vec_distance(v.point, point_of(f->q, f->corner[i])) <= 0)
            return false;
    v.place = v.next = f->q->vertex.n;
    *array_push(&f->q->vertex) = v;
    for (size_t i = 0; i < f->n; i++)
        add_facet(f, f->corner[i], f->corner[(i + 1) % f->n], (int)v.place);
    return true;
}

/* Fills the loop, ear by ear, the one with the shortest third side first. */
static size_t fill_loop(struct patch_mesh *q, struct rims *rims, const int *loop, size_t n,
                        bool avoid)
{
    int sheet = rims->item[loop[0] / 2].sheet;
    struct filling f = {q, rims, mem_alloc(n, sizeof *f.corner), n, sheet, false};
    size_t before = q->face.n, against = 0;

    for (size_t i = 0; i < n; i++) {
        f.corner[i] = rim_from(rims, loop[i]);
        against += (size_t)(loop[i] % 2);
    }
    f.flip = q->flipped[sheet] != (2 * against > n);
    while (f.n > 2) {
        bool has;
        size_t tip = best_ear(&f, avoid, &has);
        if (!has && fill_from_middle(&f))
            break;
        cut_ear(&f, tip);
    }
    free(f.corner);
    return q->face.n - before;
}

struct walk {
    struct patch_mesh *q;
    struct rims rims;
    int *first; /* of each place: an open edge that begins there */
    int *at;    /* of each place: where it is on the trail, from 1 */
    struct ints trail;
    struct skin_slits_options how;
    struct skin_close_count *count;
};

/* Between borders of several surfaces?  Wider than the gap only such a loop is a slit: one in a
 * single surface is a slot that its trimming says. */
static bool is_between(const struct walk *w, const int *loop, size_t n)
{
    bool between = !w->how.between;

    for (size_t i = 1; i < n; i++)
        between = between || w->rims.item[loop[i] / 2].sheet != w->rims.item[loop[0] / 2].sheet;
    return between;
}

/* The trail's end, from `from` on, is a loop. */
static void take_loop(struct walk *w, size_t from)
{
    size_t n = w->trail.n - from;
    const int *loop = w->trail.item + from;

    double width = n > 2 && n <= CORNERS_MAX && is_between(w, loop, n)
                       ? loop_width(w->q, &w->rims, loop, n, w->how.gap)
                       : HUGE_VAL;
    if (width <= w->how.gap) {
        w->count->width = fmax(w->count->width, width);
        w->count->facets += fill_loop(w->q, &w->rims, loop, n, w->how.avoid);
        w->count->filled++;
    }
    for (size_t i = from; i < w->trail.n; i++)
        w->at[w->q->vertex.item[rim_from(&w->rims, loop[i - from])].place] = 0;
    w->trail.n = from;
}

/* Follows open edges from one on; where the trail meets itself a loop is taken off. */
static void walk_from(struct walk *w, int way)
{
    while (way != NONE) {
        size_t from = w->q->vertex.item[rim_from(&w->rims, way)].place;
        size_t to = w->q->vertex.item[rim_to(&w->rims, way)].place;
        w->rims.item[way / 2].used = true;
        *array_push(&w->trail) = way;
        w->at[from] = (int)w->trail.n;
        if (w->at[to] > 0)
            take_loop(w, (size_t)w->at[to] - 1);
        for (way = w->first[to]; way != NONE && w->rims.item[way / 2].used;)
            way = w->rims.item[way / 2].next[way % 2];
    }
    for (size_t i = 0; i < w->trail.n; i++) /* it ends nowhere */
        w->at[w->q->vertex.item[rim_from(&w->rims, w->trail.item[i])].place] = 0;
    w->trail.n = 0;
}

void skin_fill_slits(struct patch_mesh *q, const struct skin_slits_options *how,
                     struct skin_close_count *count)
{
    size_t vertices = q->vertex.n;
    struct walk w = {.q = q, .how = *how, .count = count};
    w.first = mem_alloc(vertices + 1, sizeof *w.first);
    w.at = mem_alloc(vertices + 1, sizeof *w.at);
    w.rims.last_added = mem_alloc(vertices + 1, sizeof *w.rims.last_added);
    find_rims(q, &w.rims, w.first);
    for (size_t i = 0; i < w.rims.n; i++)
        if (!w.rims.item[i].used)
            walk_from(&w, 2 * (int)i);
    free(w.rims.side);
    free(w.rims.last_added);
    array_free(&w.rims.added);
    array_free(&w.rims);
    array_free(&w.trail);
    free(w.first);
    free(w.at);
    count->folded += skin_drop_folds(q, how->gap);
    skin_turn_slivers(q, how->gap);
}
