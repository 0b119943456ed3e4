/* skin_close - see skin_close.h. */
#include "nurbs/skin_close.h"

#include <stdlib.h>

#include "skin_folds.h"
#include "skin_region.h"
#include "skin_sides.h"
#include "skin_slits.h"

enum { NONE = -1 };

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
        if (skin_edge_sound(&side[i], k))
            continue;
        int own = q->sheet.item[side[i].facet];
        bad.between = bad.between || (bad.all > 0 && own != sheet);
        sheet = own;
        bad.all++;
        bad.tangled += k > 1;
        for (size_t a = i; a < i + k && k > 1; a++) {
            near[side[i].low] = near[side[i].high] = around;
            out[side[a].facet] = out[side[a].facet] || skin_facet_width(q, side[a].facet) <= gap;
        }
    }
    for (size_t i = 0; i < n && around; i++) {
        size_t f = side[i].facet;
        out[f] =
            out[f] || ((near[side[i].low] || near[side[i].high]) && skin_facet_width(q, f) <= gap);
    }
    free(near);
    free(side);
    return bad;
}

/* A skin's vertices and facets, to be put back. */
struct snapshot {
    struct patch_mesh_vertices vertex;
    struct faces face;
    struct ints sheet;
};

static struct snapshot snapshot_of(const struct patch_mesh *q)
{
    struct snapshot s = {.vertex = {0}};
    for (size_t i = 0; i < q->vertex.n; i++)
        *array_push(&s.vertex) = q->vertex.item[i];
    for (size_t f = 0; f < q->face.n; f++) {
        *array_push(&s.face) = q->face.item[f];
        *array_push(&s.sheet) = q->sheet.item[f];
    }
    return s;
}

/* Changes the two for each other. */
static void swap_snapshot(struct patch_mesh *q, struct snapshot *s)
{
    struct snapshot now = {q->vertex, q->face, q->sheet};
    q->vertex = s->vertex;
    q->face = s->face;
    q->sheet = s->sheet;
    *s = now;
}

static void snapshot_free(struct snapshot *s)
{
    array_free(&s->vertex);
    array_free(&s->face);
    array_free(&s->sheet);
}

/* What is tried, and what came of it. */
struct closing {
    struct patch_mesh *q;
    double least, most; /* mm: the gap as asked for; between surfaces up to this width */
    struct skin_close_count count;
};

/* Fills what is open and no wider than the gap; wider than that asked for only between surfaces. */
static void fill(struct closing *c, double gap, bool avoid)
{
    struct skin_slits_options how = {.gap = gap, .between = gap > c->least, .avoid = avoid};
    skin_fill_slits(c->q, &how, &c->count);
}

/* Makes the ends of tangled edges no longer than the gap one place: two borders that run to and fro
 * over each other have each a vertex where there should be one. */
static size_t contract(struct closing *c, double gap)
{
    struct patch_mesh *q = c->q;
    size_t n, contracted = 0;
    struct skin_side *side = skin_sides_find(q, &n);
    bool *touched = mem_alloc(q->vertex.n + 1, sizeof *touched);

    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        size_t a = side[i].low, b = side[i].high;
        double length = vec_distance(q->vertex.item[a].point, q->vertex.item[b].point);
        if (k == 1 || skin_edge_sound(&side[i], k) || length > gap || touched[a] || touched[b])
            continue;
        for (size_t j = i; j < i + k; j++) /* one at a time about a place */
            for (int m = 0; m < 3; m++)
                touched[q->vertex.item[q->face.item[side[j].facet].v[m]].place] = true;
        patch_mesh_unite(q, a, b);
        c->count.width = fmax(c->count.width, length);
        contracted++;
    }
    free(side);
    free(touched);
    return contracted;
}

/* What one try does. */
struct way {
    bool contract;      /* ends of short edges become one; else slivers are taken out: */
    bool around, avoid; /* also those beside; no second edge between two places */
    double gap;         /* mm */
};

/* Does it; false: it does nothing.  *idle: nothing is tangled and nothing was filled, so that of
 * the ways of this width none will. */
static bool go(struct closing *c, const struct way *way, bool *idle)
{
    struct patch_mesh *q = c->q;
    size_t facets = q->face.n, filled = c->count.facets;
    if (way->contract) {
        if (contract(c, way->gap) == 0)
            return false;
        fill(c, c->least, true);
        return true;
    }
    bool *out = mem_alloc(facets + 1, sizeof *out);
    struct unsound before = mark_tangled(q, way->gap, way->around, out);
    skin_drop_facets(q, out);
    free(out);
    bool wider = way->gap > c->least && way->gap <= c->most;
    bool does = q->face.n != facets || (wider && (before.tangled > 0 || before.between));
    if (does)
        fill(c, way->gap, way->avoid);
    *idle = before.tangled == 0 && c->count.facets == filled;
    return does;
}

/* One try.  True: the skin has fewer edges that are not sound; else it is as before.  *bad: how
 * many it has. */
static bool try_way(struct closing *c, const struct way *way, size_t *bad, bool *idle)
{
    size_t before = skin_count_unsound(c->q);
    struct skin_close_count count = c->count;
    struct snapshot snapshot = snapshot_of(c->q);

    *bad = before;
    if (go(c, way, idle))
        *bad = skin_count_unsound(c->q);
    if (*bad >= before) {
        swap_snapshot(c->q, &snapshot);
        c->count = count;
    }
    snapshot_free(&snapshot);
    return *bad < before;
}

/* Between borders nearer to each other than the gap slivers may lie over each other.  Without them
 * there is a slit, whose filling knows both its sides; what does not become better stays.  Of the
 * ways to take out and to fill the first that helps is taken, till none does. */
static void untangle(struct closing *c)
{
    enum { TRIES = 60, AROUND = 1, REPEAT = 2, WIDTHS = 4, WAYS = 16, CONTRACT = -1 };
    size_t bad = 1;

    for (int i = 0, number = CONTRACT; i < TRIES && number < WAYS && bad > 0; i++) {
        bool idle = false;
        struct way way = {.contract = number == CONTRACT, .gap = c->least};
        if (!way.contract)
            way = (struct way){false, (number & AROUND) != 0, (number & REPEAT) == 0,
                               c->least * (1 << number / WIDTHS)};
        number = try_way(c, &way, &bad, &idle) ? CONTRACT : number + 1;
        for (; idle && number % WIDTHS > 0; number++)
            i++;
    }
}

struct skin_close_count skin_close(struct patch_mesh *q, double gap, double most)
{
    enum { ROUNDS = 4 };
    struct skin_region region;
    struct closing c = {.least = gap, .most = most};
    size_t before = 1, changes = 0;

    for (int i = 0; i < ROUNDS && before != changes && skin_region_find(q, &region); i++) {
        before = changes;
        c.q = &region.mesh;
        c.count.folded += skin_drop_folds(&region.mesh, gap);
        fill(&c, gap, true);
        untangle(&c);
        changes = c.count.folded + c.count.facets;
        skin_region_put(q, &region);
        skin_region_free(&region);
    }
    skin_drop_crumbs(q, gap);
    return c.count;
}
