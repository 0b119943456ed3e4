/* skin_close - see skin_close.h. */
#include "nurbs/skin_close.h"

#include <stdlib.h>

#include "skin_sides.h"

/* Corners of a loop that is looked at: a longer one is no slit, but a border. */
enum { CORNERS_MAX = 2000, NONE = -1 };

static struct vec3 point_of(const struct patch_mesh *q, int vertex)
{
    return q->vertex.item[q->vertex.item[vertex].place].point;
}

/* ---- folds */

/* The third corner of a side's facet, by its place. */
static size_t third_place(const struct patch_mesh *q, const struct skin_side *s)
{
    return q->vertex.item[q->face.item[s->facet].v[(s->corner + 2) % 3]].place;
}

/* Marks the pairs of facets that are each other's back. */
static size_t mark_folds(const struct patch_mesh *q, const struct skin_side *side, size_t n,
                         bool *out)
{
    size_t folded = 0;

    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        for (size_t a = i; k > 1 && a < i + k; a++) {
            for (size_t b = a + 1; b < i + k && !out[side[a].facet]; b++) {
                if (out[side[b].facet] || side[a].forward == side[b].forward ||
                    third_place(q, &side[a]) != third_place(q, &side[b]))
                    continue;
                out[side[a].facet] = out[side[b].facet] = true;
                folded++;
            }
        }
    }
    return folded;
}

static void drop_marked(struct patch_mesh *q, const bool *out)
{
    size_t kept = 0;

    for (size_t f = 0; f < q->face.n; f++) {
        if (out[f])
            continue;
        q->face.item[kept] = q->face.item[f];
        q->sheet.item[kept++] = q->sheet.item[f];
    }
    q->face.n = q->sheet.n = kept;
}

/* ---- slivers that lie on their neighbours */

/* Width of a facet, mm: its height over its longest side. */
static double width_of(const struct patch_mesh *q, size_t facet)
{
    const int *v = q->face.item[facet].v;
    struct vec3 a = point_of(q, v[0]), b = point_of(q, v[1]), c = point_of(q, v[2]);
    double longest = fmax(vec_distance(a, b), fmax(vec_distance(b, c), vec_distance(c, a)));
    double twice = vec_length(vec_cross(vec_sub(b, a), vec_sub(c, a)));

    return longest > 0 ? twice / longest : 0;
}

/* Marks slivers with a side that three facets have, without which more sides have two. */
static size_t mark_surplus(const struct patch_mesh *q, const struct skin_side *side, size_t n,
                           double gap, bool *out)
{
    signed char *gain = mem_alloc(q->face.n + 1, sizeof *gain);
    bool *touched = mem_alloc(q->vertex.n + 1, sizeof *touched);
    bool *many = mem_alloc(q->face.n + 1, sizeof *many);
    size_t surplus = 0;

    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        int one = k == 2 ? -1 : (int)(k % 2);
        for (size_t a = i; a < i + k; a++) {
            gain[side[a].facet] = (signed char)(gain[side[a].facet] + one);
            many[side[a].facet] = many[side[a].facet] || (k > 1 && k % 2 == 1);
        }
    }
    for (size_t f = 0; f < q->face.n; f++) {
        const int *v = q->face.item[f].v;
        bool free_of = true;
        if (gain[f] <= 0 || !many[f] || out[f] || !(width_of(q, f) <= gap))
            continue;
        for (int k = 0; k < 3; k++)
            free_of = free_of && !touched[q->vertex.item[v[k]].place];
        for (int k = 0; k < 3 && free_of; k++)
            touched[q->vertex.item[v[k]].place] = true; /* one at a time about a place */
        out[f] = free_of;
        surplus += free_of;
    }
    free(gain);
    free(many);
    free(touched);
    return surplus;
}

static size_t drop_folds(struct patch_mesh *q, double gap)
{
    enum { ROUNDS = 20 };
    size_t n, folded = 0;

    for (int i = 0; i < ROUNDS; i++) {
        struct skin_side *side = skin_sides_find(q, &n);
        bool *out = mem_alloc(q->face.n + 1, sizeof *out);
        size_t found = mark_folds(q, side, n, out);
        found += found == 0 ? mark_surplus(q, side, n, gap, out) : 0;
        drop_marked(q, out);
        folded += found;
        free(out);
        free(side);
        if (found == 0)
            break;
    }
    return folded;
}

/* ---- slits */

/* An open edge in the direction that a facet on its open side has it. */
struct rim {
    int from, to; /* vertices, of the facet that is there */
    int sheet;
    int next; /* of those that begin at the same place, or NONE */
    bool used;
};

struct rims {
    size_t n, cap;
    struct rim *item;
};

static void find_rims(const struct patch_mesh *q, struct rims *rims, int *first)
{
    size_t n;
    struct skin_side *side = skin_sides_find(q, &n);

    for (size_t i = 0; i < q->vertex.n; i++)
        first[i] = NONE;
    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        if (k > 1)
            continue;
        const int *v = q->face.item[side[i].facet].v;
        int a = v[side[i].corner], b = v[(side[i].corner + 1) % 3];
        int sheet = q->sheet.item[side[i].facet];
        struct rim r = {.from = b, .to = a, .sheet = sheet};
        if (q->flipped[sheet])
            r = (struct rim){.from = a, .to = b, .sheet = sheet};
        size_t place = q->vertex.item[r.from].place;
        r.next = first[place];
        first[place] = (int)rims->n;
        *array_push(rims) = r;
    }
    free(side);
}

/* Is every corner of the loop within the gap of a side that does not end at it? */
static bool is_narrow(const struct patch_mesh *q, const struct rims *rims, const int *loop,
                      size_t n, double gap)
{
    for (size_t i = 0; i < n; i++) {
        struct vec3 p = point_of(q, rims->item[loop[i]].from);
        double least = HUGE_VAL;
        for (size_t k = 1; k + 1 < n && !(least <= gap); k++) {
            const struct rim *r = &rims->item[loop[(i + k) % n]];
            least = fmin(least, vec_segment_distance(point_of(q, r->from), point_of(q, r->to), p));
        }
        if (!(least <= gap))
            return false;
    }
    return n > 2;
}

/* Fills the loop, ear by ear, the one with the shortest third side first. */
static size_t fill_loop(struct patch_mesh *q, const struct rims *rims, const int *loop, size_t n)
{
    int *v = mem_alloc(n, sizeof *v), sheet = rims->item[loop[0]].sheet;
    size_t facets = 0;

    for (size_t i = 0; i < n; i++)
        v[i] = rims->item[loop[i]].from;
    for (; n > 2; n--) {
        size_t best = 0;
        double least = HUGE_VAL;
        for (size_t i = 0; i < n; i++) {
            double d = vec_distance(point_of(q, v[i]), point_of(q, v[(i + 2) % n]));
            if (d < least) {
                least = d;
                best = (i + 1) % n;
            }
        }
        int a = v[(best + n - 1) % n], b = v[best], c = v[(best + 1) % n];
        bool flip = q->flipped[sheet];
        *array_push(&q->face) = (struct face){{a, flip ? c : b, flip ? b : c}};
        *array_push(&q->sheet) = sheet;
        facets++;
        for (size_t i = best; i + 1 < n; i++)
            v[i] = v[i + 1];
    }
    free(v);
    return facets;
}

struct walk {
    struct patch_mesh *q;
    struct rims rims;
    int *first; /* of each place: an open edge that begins there */
    int *at;    /* of each place: where it is on the trail, from 1 */
    struct ints trail;
    double gap;
    struct skin_close_count count;
};

/* The trail's end, from `from` on, is a loop. */
static void take_loop(struct walk *w, size_t from)
{
    size_t n = w->trail.n - from;
    const int *loop = w->trail.item + from;

    if (n <= CORNERS_MAX && is_narrow(w->q, &w->rims, loop, n, w->gap)) {
        w->count.facets += fill_loop(w->q, &w->rims, loop, n);
        w->count.filled++;
    }
    for (size_t i = from; i < w->trail.n; i++)
        w->at[w->q->vertex.item[w->rims.item[loop[i - from]].from].place] = 0;
    w->trail.n = from;
}

/* Follows open edges from one on; where the trail meets itself a loop is taken off. */
static void walk_from(struct walk *w, int rim)
{
    while (rim != NONE) {
        struct rim *r = &w->rims.item[rim];
        size_t from = w->q->vertex.item[r->from].place, to = w->q->vertex.item[r->to].place;
        r->used = true;
        *array_push(&w->trail) = rim;
        w->at[from] = (int)w->trail.n;
        if (w->at[to] > 0)
            take_loop(w, (size_t)w->at[to] - 1);
        for (rim = w->first[to]; rim != NONE && w->rims.item[rim].used;)
            rim = w->rims.item[rim].next;
    }
    for (size_t i = 0; i < w->trail.n; i++) /* it ends nowhere */
        w->at[w->q->vertex.item[w->rims.item[w->trail.item[i]].from].place] = 0;
    w->trail.n = 0;
}

struct skin_close_count skin_close(struct patch_mesh *q, double gap)
{
    struct walk w = {.q = q, .gap = gap};

    w.count.folded = drop_folds(q, gap);
    w.first = mem_alloc(q->vertex.n + 1, sizeof *w.first);
    w.at = mem_alloc(q->vertex.n + 1, sizeof *w.at);
    find_rims(q, &w.rims, w.first);
    for (size_t i = 0; i < w.rims.n; i++)
        if (!w.rims.item[i].used)
            walk_from(&w, (int)i);
    w.count.folded += drop_folds(q, gap);
    array_free(&w.rims);
    array_free(&w.trail);
    free(w.first);
    free(w.at);
    return w.count;
}
