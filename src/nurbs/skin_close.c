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

/* Marks the pairs of facets that are each other's back, or the same twice. */
static size_t mark_folds(const struct patch_mesh *q, const struct skin_side *side, size_t n,
                         bool *out)
{
    size_t folded = 0;

    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        for (size_t a = i; k > 1 && a < i + k; a++) {
            for (size_t b = a + 1; b < i + k && !out[side[a].facet]; b++) {
                if (out[side[b].facet] || third_place(q, &side[a]) != third_place(q, &side[b]))
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

/* ---- crumbs */

static size_t crumb_of(size_t *of, size_t f)
{
    while (of[f] != f)
        f = of[f] = of[of[f]];
    return f;
}

/* What hangs together by its sides. */
struct crumb {
    double area; /* mm^2 */
    struct vec3 low, high;
};

static void add_to_crumb(struct crumb *c, const struct patch_mesh *q, size_t facet)
{
    const int *v = q->face.item[facet].v;
    struct vec3 p[3];

    for (int k = 0; k < 3; k++) {
        p[k] = point_of(q, v[k]);
        if (c->area == 0 && k == 0)
            c->low = c->high = p[0];
        c->low = vec(fmin(c->low.x, p[k].x), fmin(c->low.y, p[k].y), fmin(c->low.z, p[k].z));
        c->high = vec(fmax(c->high.x, p[k].x), fmax(c->high.y, p[k].y), fmax(c->high.z, p[k].z));
    }
    c->area += vec_length(vec_cross(vec_sub(p[1], p[0]), vec_sub(p[2], p[0]))) / 2;
}

/* Drops what hangs together by its sides and is no wider, on the whole, than the gap: left over
 * between borders that were joined.  Where all is so small nothing is dropped. */
static void drop_crumbs(struct patch_mesh *q, double gap)
{
    size_t n, kept = 0;
    struct skin_side *side = skin_sides_find(q, &n);
    size_t *of = mem_alloc(q->face.n + 1, sizeof *of);
    struct crumb *crumb = mem_alloc(q->face.n + 1, sizeof *crumb);
    bool *out = mem_alloc(q->face.n + 1, sizeof *out);

    for (size_t f = 0; f < q->face.n; f++)
        of[f] = f;
    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        for (size_t a = i + 1; a < i + k; a++)
            of[crumb_of(of, side[a].facet)] = crumb_of(of, side[i].facet);
    }
    for (size_t f = 0; f < q->face.n; f++)
        add_to_crumb(&crumb[crumb_of(of, f)], q, f);
    for (size_t f = 0; f < q->face.n; f++) {
        const struct crumb *c = &crumb[crumb_of(of, f)];
        out[f] = c->area <= 2 * gap * vec_distance(c->low, c->high);
        kept += !out[f];
    }
    if (kept > 0)
        drop_marked(q, out);
    free(out);
    free(crumb);
    free(of);
    free(side);
}

/* ---- slivers that are turned round */

/* Counts the sides of each facet that its one neighbour has in the same direction, less the others.
 */
static void count_turned(const struct skin_side *side, size_t n, signed char *turned)
{
    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        int by = side[i].forward == side[i + (k > 1)].forward ? 1 : -1;
        for (size_t a = i; a < i + k && k == 2; a++)
            turned[side[a].facet] = (signed char)(turned[side[a].facet] + by);
    }
}

/* Where vertices became one place, a sliver between them may have been left upside down: it is
 * turned as most of its neighbours are. */
static void turn_slivers(struct patch_mesh *q, double gap)
{
    enum { ROUNDS = 20 };
    size_t n, changed = 1;

    for (int i = 0; i < ROUNDS && changed > 0; i++) {
        struct skin_side *side = skin_sides_find(q, &n);
        signed char *turned = mem_alloc(q->face.n + 1, sizeof *turned);
        bool *touched = mem_alloc(q->vertex.n + 1, sizeof *touched);
        changed = 0;
        count_turned(side, n, turned);
        for (size_t f = 0; f < q->face.n; f++) {
            int *v = q->face.item[f].v;
            size_t place[3];
            for (int k = 0; k < 3; k++)
                place[k] = q->vertex.item[v[k]].place;
            if (turned[f] <= 0 || touched[place[0]] || touched[place[1]] || touched[place[2]] ||
                !(width_of(q, f) <= gap))
                continue;
            for (int k = 0; k < 3; k++)
                touched[place[k]] = true; /* one at a time about a place */
            int other = v[1];
            v[1] = v[2];
            v[2] = other;
            changed++;
        }
        free(side);
        free(turned);
        free(touched);
    }
}

/* ---- slits */

/* An open edge in the direction that a facet on its open side has it: 2 i of rims.item[i]; 2 i + 1
 * is the same edge the other way. */
struct rim {
    int end[2]; /* vertices, of the facet that is there */
    int sheet;
    int next[2]; /* of those that have an end at the same place: 2 i or 2 i + 1, or NONE */
    bool used;
};

struct rims {
    size_t n, cap;
    struct rim *item;
    struct skin_side *side; /* of all facets ... */
    size_t sides;           /* ... so many */
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

    return rims->sides > 0 &&
           bsearch(&key, rims->side, rims->sides, sizeof key, compare_places) != NULL;
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

/* Fills the loop, ear by ear, the one with the shortest third side first; to avoid: a third
 * side that is an edge already only when there is no other. */
static size_t fill_loop(struct patch_mesh *q, const struct rims *rims, const int *loop, size_t n,
                        bool avoid)
{
    int *v = mem_alloc(n, sizeof *v), sheet = rims->item[loop[0] / 2].sheet;
    size_t facets = 0, against = 0;

    for (size_t i = 0; i < n; i++) {
        v[i] = rim_from(rims, loop[i]);
        against += (size_t)(loop[i] % 2);
    }
    bool flip = q->flipped[sheet] != (2 * against > n);
    for (; n > 2; n--) {
        size_t best = 0;
        double least = HUGE_VAL;
        for (size_t i = 0; i < n; i++) {
            double d = vec_distance(point_of(q, v[i]), point_of(q, v[(i + 2) % n]));
            d += avoid && n > 3 && is_edge(q, rims, v[i], v[(i + 2) % n]) ? LAST : 0;
            if (d < least) {
                least = d;
                best = (i + 1) % n;
            }
        }
        int a = v[(best + n - 1) % n], b = v[best], c = v[(best + 1) % n];
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
    double gap, least; /* mm: of now, and as asked for */
    double most;       /* mm: what is open between surfaces is filled up to this width */
    bool avoid;        /* no second edge between two places, where there is another way */
    struct skin_close_count count;
};

/* Between borders of several surfaces?  Wider than the gap only such a loop is a slit: one in a
 * single surface is a slot that its trimming says. */
static bool is_between(const struct walk *w, const int *loop, size_t n)
{
    bool between = w->gap <= w->least;

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
                       ? loop_width(w->q, &w->rims, loop, n, w->gap)
                       : HUGE_VAL;
    if (width <= w->gap) {
        w->count.width = fmax(w->count.width, width);
        w->count.facets += fill_loop(w->q, &w->rims, loop, n, w->avoid);
        w->count.filled++;
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

/* Closes the slits that there are. */
static void close_slits(struct walk *w)
{
    w->first = mem_alloc(w->q->vertex.n + 1, sizeof *w->first);
    w->at = mem_alloc(w->q->vertex.n + 1, sizeof *w->at);
    find_rims(w->q, &w->rims, w->first);
    for (size_t i = 0; i < w->rims.n; i++)
        if (!w->rims.item[i].used)
            walk_from(w, 2 * (int)i);
    free(w->rims.side);
    array_free(&w->rims);
    array_free(&w->trail);
    free(w->first);
    free(w->at);
    w->count.folded += drop_folds(w->q, w->gap);
    turn_slivers(w->q, w->gap);
}

/* ---- slivers that are taken out and filled anew */

/* Is it an edge of two facets turned alike? */
static bool is_sound(const struct skin_side *side, size_t k)
{
    return k == 2 && side[0].forward != side[1].forward;
}

/* Edges of a skin that are not sound. */
struct unsound {
    size_t all, tangled; /* more than two share it, or two that are turned differently; else open */
    bool between;        /* they are of several surfaces */
};

/* Marks the facets, if they are no wider than the gap, along edges that are tangled, and `around`:
 * all that have a corner of such an edge. */
static struct unsound mark_tangled(const struct patch_mesh *q, double gap, bool around, bool *out)
{
    struct unsound bad = {0};
    size_t n;
    int sheet = NONE;
    struct skin_side *side = skin_sides_find(q, &n);
    bool *near = mem_alloc(q->vertex.n + 1, sizeof *near);

    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        if (is_sound(&side[i], k))
            continue;
        int own = q->sheet.item[side[i].facet];
        bad.between = bad.between || (bad.all > 0 && own != sheet);
        sheet = own;
        bad.all++;
        bad.tangled += k > 1;
        for (size_t a = i; a < i + k && k > 1; a++) {
            near[side[i].low] = near[side[i].high] = around;
            out[side[a].facet] = out[side[a].facet] || width_of(q, side[a].facet) <= gap;
        }
    }
    for (size_t i = 0; i < n && around; i++) {
        size_t f = side[i].facet;
        out[f] = out[f] || ((near[side[i].low] || near[side[i].high]) && width_of(q, f) <= gap);
    }
    free(near);
    free(side);
    return bad;
}

static void copy_facets(const struct patch_mesh *from, struct faces *face, struct ints *sheet)
{
    face->n = sheet->n = 0;
    for (size_t f = 0; f < from->face.n; f++) {
        *array_push(face) = from->face.item[f];
        *array_push(sheet) = from->sheet.item[f];
    }
}

/* One try: takes out what is marked and fills what is open.  True: the skin has fewer edges that
 * are not sound; else it is as before.  *bad: how many it has; *idle: none is tangled and nothing
 * was filled, so that of the ways of this width none will. */
static bool refill(struct walk *w, bool around, size_t *bad, bool *idle)
{
    struct patch_mesh *q = w->q;
    struct skin_close_count count = w->count;
    struct faces face = {0};
    struct ints sheet = {0};
    bool *out = mem_alloc(q->face.n + 1, sizeof *out);
    struct unsound before = mark_tangled(q, w->gap, around, out);

    copy_facets(q, &face, &sheet);
    drop_marked(q, out);
    free(out);
    bool wider = w->gap > w->least && w->gap <= w->most;
    bool same = q->face.n == face.n && !(wider && (before.tangled > 0 || before.between));
    if (!same)
        close_slits(w);
    *idle = before.tangled == 0 && w->count.facets == count.facets;
    out = mem_alloc(q->face.n + 1, sizeof *out);
    *bad = same ? before.all : mark_tangled(q, w->gap, false, out).all;
    free(out);
    if (*bad >= before.all) {
        struct faces swap = q->face;
        struct ints swap_sheet = q->sheet;
        q->face = face;
        q->sheet = sheet;
        face = swap;
        sheet = swap_sheet;
        w->count = count;
    }
    array_free(&face);
    array_free(&sheet);
    return *bad < before.all;
}

/* Between borders nearer to each other than the gap slivers may lie over each other.  Without them
 * there is a slit, whose filling knows both its sides; what does not become better stays.  Of the
 * ways to take out and to fill the first that helps is taken, till none does. */
static void untangle(struct walk *w)
{
    enum { TRIES = 60, AROUND = 1, AVOID = 2, WIDTHS = 4, WAYS = 16 };
    double gap = w->gap;
    size_t bad = 1;
    bool idle = false;

    for (int i = 0, way = 0; i < TRIES && way < WAYS && bad > 0; i++) {
        w->avoid = (way & AVOID) != 0;
        w->gap = gap * (1 << way / WIDTHS);
        way = refill(w, (way & AROUND) != 0, &bad, &idle) ? 0 : way + 1;
        for (; idle && way % WIDTHS > 0; way++)
            i++;
    }
    w->gap = gap;
}

struct skin_close_count skin_close(struct patch_mesh *q, double gap, double most)
{
    struct walk w = {.q = q, .gap = gap, .least = gap, .most = most};

    w.count.folded = drop_folds(q, gap);
    close_slits(&w);
    untangle(&w);
    drop_crumbs(q, gap);
    return w.count;
}
