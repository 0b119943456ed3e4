/* coincident - see coincident.h. */
#include "nurbs/coincident.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/box.h"
#include "math/elementary.h"
#include "nurbs/patch_mesh.h"
#include "trim_loops.h"

/* Places of a surface that are looked at, and edges of its border. */
enum { PLACES = 40, EDGES = 8 };

/* Of the places: within the trimming of the other, where those beside its border may be judged
 * wrong; and of two areas of facets: how far they may differ. */
static const double MOST = 0.9, AREA = 0.01;

/* What is known of each sheet: its box, its area, mm^2. */
struct extent {
    struct box box;
    double area;
};

struct search {
    const struct patches *patches;
    const struct sheet *sheet;
    const struct extent *extent;
    double same, gap;
    struct patch_mesh mesh; /* for the borders ... */
    size_t *edge;           /* ... the first edge of each sheet's */
    int *twin;
};

static struct extent extent_of(const struct sheet *s)
{
    struct extent e = {.box = box_around(s->point.item, s->point.n)};
    const struct vec3 *p = s->point.item;

    for (size_t k = 0; k < s->face.n; k++) {
        const int *v = s->face.item[k].v;
        e.area += vec_length(vec_cross(vec_sub(p[v[1]], p[v[0]]), vec_sub(p[v[2]], p[v[0]]))) / 2;
    }
    return e;
}

static bool boxes_alike(const struct box *a, const struct box *b, double within)
{
    return vec_distance(a->low, b->low) <= within && vec_distance(a->high, b->high) <= within;
}

/* ---- one on the other */

/* The parameters of the vertex nearest to a point. */
static struct uv nearest_vertex(const struct sheet *s, struct vec3 p)
{
    size_t nearest = 0;

    for (size_t i = 1; i < s->point.n; i++)
        if (vec_distance(s->point.item[i], p) < vec_distance(s->point.item[nearest], p))
            nearest = i;
    return s->at.item[nearest];
}

/* Where a point lies on a surface; false: it is farther off than `same`.  The same surface has it
 * at the same parameters. */
static bool find_on(const struct search *s, size_t k, struct vec3 p, struct uv *at)
{
    const struct nurbs *f = &s->patches->item[k].surface;

    if (vec_distance(nurbs_point(f, *at), p) <= s->same)
        return true;
    *at = nurbs_foot(f, p, nearest_vertex(&s->sheet[k], p));
    return vec_distance(nurbs_point(f, *at), p) <= s->same;
}

/* The parameters of a facet's middle. */
static struct uv middle_of(const struct sheet *s, size_t facet)
{
    const int *v = s->face.item[facet].v;
    struct uv a = s->at.item[v[0]], b = s->at.item[v[1]], c = s->at.item[v[2]];

    return (struct uv){(a.u + b.u + c.u) / 3, (a.v + b.v + c.v) / 3};
}

/* Does all of surface a lie on surface b? */
static bool lies_on(const struct search *s, size_t a, size_t b)
{
    const struct sheet *sheet = &s->sheet[a];
    size_t n = sheet->face.n < PLACES ? sheet->face.n : PLACES, inside = 0, i = 0;
    struct uv_polygon loops;

    trim_loops(&s->patches->item[b], fmax(s->same, 1e-6), &loops);
    bool open = s->patches->item[b].open || loops.open || loops.n == 0;
    for (; i < n; i++) {
        struct uv at = middle_of(sheet, i * sheet->face.n / n);
        struct vec3 p = nurbs_point(&s->patches->item[a].surface, at);
        if (!find_on(s, b, p, &at))
            break;
        inside += uv_polygon_inside(&loops, open, at);
    }
    uv_polygon_free(&loops);
    return i == n && (double)inside >= MOST * (double)n;
}

static bool coincide(const struct search *s, size_t a, size_t b)
{
    const struct extent *e = &s->extent[a], *f = &s->extent[b];
    double off = s->sheet[a].error + s->sheet[b].error + s->same;

    return patch_may_join(&s->patches->item[a], &s->patches->item[b]) &&
           boxes_alike(&e->box, &f->box, 2 * off) &&
           fabs(e->area - f->area) <= AREA * fmax(e->area, f->area) && lies_on(s, a, b) &&
           lies_on(s, b, a);
}

/* ---- what is around them */

/* Has a surface a border edge at this place? */
static bool has_edge_at(const struct search *s, size_t sheet, struct vec3 place)
{
    const struct patch_mesh_vertex *v = s->mesh.vertex.item;

    if (box_distance2(&s->extent[sheet].box, place) > s->gap * s->gap)
        return false;
    for (size_t i = s->edge[sheet]; i < s->edge[sheet + 1]; i++) {
        const struct patch_mesh_edge *e = &s->mesh.edge.item[i];
        if (vec_segment_distance(v[e->from].point, v[e->to].point, place) <= s->gap)
            return true;
    }
    return false;
}

/* How many surfaces besides these two have one there, each with its twins as one. */
static size_t count_beside(const struct search *s, size_t a, size_t b, struct vec3 place)
{
    size_t beside = 0;

    for (size_t k = 0; k < s->patches->n; k++)
        beside += k != a && k != b && s->twin[k] < 0 && has_edge_at(s, k, place);
    return beside;
}

/* Two that coincide are walls of two bodies where each has a neighbour of its own. */
static bool are_walls(const struct search *s, size_t a, size_t b)
{
    const struct patch_mesh_vertex *v = s->mesh.vertex.item;
    size_t first = s->edge[b], edges = s->edge[b + 1] - first, between = 0;
    size_t n = edges < EDGES ? edges : EDGES;

    for (size_t i = 0; i < n; i++) {
        const struct patch_mesh_edge *e = &s->mesh.edge.item[first + i * edges / n];
        between += count_beside(s, a, b, vec_mix(v[e->from].point, v[e->to].point, 0.5)) > 1;
    }
    return n > 0 && 2 * between > n;
}

/* The borders of all surfaces: their edges stand together. */
static void find_edges(struct search *s)
{
    patch_mesh_make(s->sheet, s->patches->n, 0, &s->mesh);
    s->edge = mem_alloc(s->patches->n + 2, sizeof *s->edge);
    for (size_t i = 0; i < s->mesh.edge.n; i++)
        s->edge[s->mesh.vertex.item[s->mesh.edge.item[i].from].sheet + 1]++;
    for (size_t i = 0; i < s->patches->n; i++)
        s->edge[i + 1] += s->edge[i];
}

/* ---- all of them */

static int compare_low(const void *p, const void *q)
{
    const struct extent *a = *(const struct extent *const *)p,
                        *b = *(const struct extent *const *)q;

    if (a->box.low.x < b->box.low.x || a->box.low.x > b->box.low.x)
        return a->box.low.x < b->box.low.x ? -1 : 1;
    return (a > b) - (a < b);
}

/* Pairs are looked for among those whose boxes begin at one x; returns how many there are. */
static size_t find_twins(const struct search *s, size_t n)
{
    const struct extent **order = mem_alloc(n + 1, sizeof *order);
    double off = s->same;
    size_t found = 0;

    for (size_t i = 0; i < n; i++) {
        order[i] = &s->extent[i];
        off = fmax(off, 2 * s->sheet[i].error + s->same);
    }
    qsort(order, n, sizeof *order, compare_low);
    for (size_t i = 0; i < n; i++)
        for (size_t k = i; k-- > 0 && order[i]->box.low.x - order[k]->box.low.x <= 2 * off;) {
            size_t a = (size_t)(order[i] - s->extent), b = (size_t)(order[k] - s->extent);
            size_t first = a < b ? a : b, second = a < b ? b : a;
            if (s->sheet[a].face.n == 0 || s->sheet[b].face.n == 0 || s->twin[second] >= 0 ||
                s->twin[first] >= 0 || !coincide(s, first, second))
                continue;
            s->twin[second] = (int)first;
            found++;
        }
    free(order);
    return found;
}

/* Those that are no walls of two bodies. */
static void take_twins(struct search *s, size_t n, int *used)
{
    find_edges(s);
    for (size_t i = 0; i < n; i++)
        if (s->twin[i] >= 0 && !are_walls(s, (size_t)s->twin[i], i))
            used[i] = s->twin[i];
    patch_mesh_free(&s->mesh);
    free(s->edge);
}

int *coincident_find(const struct patches *patches, const struct sheet *sheet, double same,
                     double gap)
{
    size_t n = patches->n;
    struct extent *extent = mem_alloc(n + 1, sizeof *extent);
    int *used = mem_alloc(n + 1, sizeof *used);
    struct search s = {.patches = patches,
                       .sheet = sheet,
                       .extent = extent,
                       .same = same,
                       .gap = gap,
                       .twin = mem_alloc(n + 1, sizeof *s.twin)};

    for (size_t i = 0; i < n; i++) {
        extent[i] = extent_of(&sheet[i]);
        s.twin[i] = used[i] = -1;
    }
    if (find_twins(&s, n) > 0)
        take_twins(&s, n, used);
    free(s.twin);
    free(extent);
    return used;
}
