/* skin_region - see skin_region.h. */
#include "skin_region.h"

#include <stdlib.h>

#include "skin_sides.h"

/* So many rings of facets about an edge that is not sound; and how far off the apex is, in sizes of
 * the region. */
enum { RINGS = 4, FAR = 100 };

static size_t place_of(const struct patch_mesh *q, int vertex)
{
    return q->vertex.item[vertex].place;
}

static size_t third_place(const struct patch_mesh *q, const struct skin_side *s)
{
    return place_of(q, q->face.item[s->facet].v[(s->corner + 2) % 3]);
}

/* Marks the places of edges that are not sound; returns how many edges these are. */
static size_t mark_unsound(const struct patch_mesh *q, const struct skin_side *side, size_t n,
                           bool *near)
{
    size_t unsound = 0;
    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        if (skin_edge_sound(&side[i], k) &&
            third_place(q, &side[i]) != third_place(q, &side[i + 1]))
            continue;
        near[side[i].low] = near[side[i].high] = true;
        unsound++;
    }
    return unsound;
}

/* Takes in all facets with a corner at a marked place. */
static void take_in(const struct patch_mesh *q, const bool *near, bool *inside)
{
    for (size_t f = 0; f < q->face.n; f++) {
        const int *v = q->face.item[f].v;
        inside[f] =
            inside[f] ||
            ((near[place_of(q, v[0])] || near[place_of(q, v[1])] || near[place_of(q, v[2])]) &&
             skin_facet_counts(q, f));
    }
}

static void mark_corners(const struct patch_mesh *q, const bool *inside, bool *near)
{
    for (size_t f = 0; f < q->face.n; f++)
        for (int k = 0; k < 3 && inside[f]; k++)
            near[place_of(q, q->face.item[f].v[k])] = true;
}

/* Is the edge one of the border: of its two facets one is inside? */
static bool is_border(const struct skin_side *side, size_t k, const bool *inside)
{
    return k == 2 && inside[side[0].facet] != inside[side[1].facet];
}

/* Where the border meets itself at a place, the facets about it are taken in, so that it does
 * nowhere. */
static void round_off(const struct patch_mesh *q, const struct skin_side *side, size_t n,
                      bool *inside)
{
    unsigned char *ends = mem_alloc(q->vertex.n + 1, sizeof *ends);
    bool *pinched = mem_alloc(q->vertex.n + 1, sizeof *pinched);
    bool is_pinched = true;
    while (is_pinched) {
        is_pinched = false;
        for (size_t i = 0; i < q->vertex.n; i++)
            ends[i] = 0;
        for (size_t i = 0, k; i < n; i += k) {
            k = skin_sides_same(side, n, i);
            const size_t end[2] = {side[i].low, side[i].high};
            for (int e = 0; e < 2 && is_border(&side[i], k, inside); e++) {
                ends[end[e]] = (unsigned char)(ends[end[e]] < 3 ? ends[end[e]] + 1 : 3);
                is_pinched = is_pinched || ends[end[e]] > 2;
                pinched[end[e]] = pinched[end[e]] || ends[end[e]] > 2;
            }
        }
        if (is_pinched)
            take_in(q, pinched, inside);
    }
    free(ends);
    free(pinched);
}

/* Copies of the vertices that facets inside have, and of those that are their places. */
static void copy_vertices(const struct patch_mesh *q, struct skin_region *r, int *number)
{
    struct sizes taken = {0};
    for (size_t f = 0; f < q->face.n; f++)
        for (int k = 0; k < 3 && r->inside[f]; k++) {
            int v = q->face.item[f].v[k];
            const size_t both[2] = {place_of(q, v), (size_t)v};
            for (int i = 0; i < 2; i++) {
                if (number[both[i]] > 0)
                    continue;
                *array_push(&taken) = both[i];
                number[both[i]] = (int)taken.n; /* from 1 */
            }
        }
    for (size_t i = 0; i < taken.n; i++) {
        struct patch_mesh_vertex *v = array_push(&r->mesh.vertex);
        *v = q->vertex.item[taken.item[i]];
        v->place = v->next = i;
    }
    for (size_t i = 0; i < taken.n; i++)
        patch_mesh_unite(&r->mesh, i, (size_t)number[q->vertex.item[taken.item[i]].place] - 1);
    r->vertex = taken.item;
    r->vertices = taken.n;
}

/* Far from all others. */
static struct vec3 apex_of(const struct patch_mesh *region)
{
    double size = 1;
    struct vec3 first = region->vertex.item[0].point;
    for (size_t i = 0; i < region->vertex.n; i++)
        size = fmax(size, vec_distance(first, region->vertex.item[i].point));
    return vec_add(first, vec(FAR * size, FAR * size, FAR * size));
}

/* The facets inside, and one from each edge of the border to the apex, turned as the facet beyond
 * that edge is. */
static void copy_facets(const struct patch_mesh *q, const struct skin_side *side, size_t n,
                        const int *number, struct skin_region *r)
{
    struct patch_mesh *to = &r->mesh;
    int apex = (int)to->vertex.n;
    *array_push(&to->vertex) = (struct patch_mesh_vertex){
        .point = apex_of(to), .sheet = -1, .place = (size_t)apex, .next = (size_t)apex};
    for (size_t f = 0; f < q->face.n; f++) {
        if (!r->inside[f])
            continue;
        const int *v = q->face.item[f].v;
        *array_push(&to->face) =
            (struct face){{number[v[0]] - 1, number[v[1]] - 1, number[v[2]] - 1}};
        *array_push(&to->sheet) = q->sheet.item[f];
    }
    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        if (!is_border(&side[i], k, r->inside))
            continue;
        const struct skin_side *in = &side[i + (r->inside[side[i].facet] ? 0 : 1)];
        const int *v = q->face.item[in->facet].v;
        int a = number[v[in->corner]] - 1, b = number[v[(in->corner + 1) % 3]] - 1;
        *array_push(&to->face) = (struct face){{b, a, apex}};
        *array_push(&to->sheet) = q->sheet.item[in->facet];
    }
}

bool skin_region_find(const struct patch_mesh *q, struct skin_region *r)
{
    size_t n;
    struct skin_side *side = skin_sides_find(q, &n);
    bool *near = mem_alloc(q->vertex.n + 1, sizeof *near);
    size_t unsound = mark_unsound(q, side, n, near);
    *r = (struct skin_region){.mesh = {.sheets = q->sheets, .flipped = q->flipped}};
    if (unsound > 0) {
        int *number = mem_alloc(q->vertex.n + 1, sizeof *number);
        r->inside = mem_alloc(q->face.n + 1, sizeof *r->inside);
        for (int i = 0; i < RINGS; i++) {
            take_in(q, near, r->inside);
            mark_corners(q, r->inside, near);
        }
        round_off(q, side, n, r->inside);
        copy_vertices(q, r, number);
        copy_facets(q, side, n, number, r);
        free(number);
    }
    free(near);
    free(side);
    return unsound > 0;
}

/* The number in the skin of a vertex that is not the apex; those that were added come from `first`
 * on. */
static size_t number_of(const struct skin_region *r, size_t first, size_t v)
{
    return v < r->vertices ? r->vertex[v] : first + v - r->vertices - 1;
}

void skin_region_put(struct patch_mesh *q, const struct skin_region *r)
{
    const struct patch_mesh *from = &r->mesh;
    size_t kept = 0, first = q->vertex.n, apex = r->vertices;
    for (size_t f = 0; f < q->face.n; f++) {
        if (r->inside[f])
            continue;
        q->face.item[kept] = q->face.item[f];
        q->sheet.item[kept++] = q->sheet.item[f];
    }
    q->face.n = q->sheet.n = kept;
    for (size_t i = apex + 1; i < from->vertex.n; i++) {
        struct patch_mesh_vertex v = from->vertex.item[i];
        v.place = v.next = q->vertex.n;
        *array_push(&q->vertex) = v;
    }
    for (size_t i = 0; i < from->vertex.n; i++)
        if (i != apex && from->vertex.item[i].place != i)
            patch_mesh_unite(q, number_of(r, first, i),
                             number_of(r, first, from->vertex.item[i].place));
    for (size_t f = 0; f < from->face.n; f++) {
        struct face face = from->face.item[f];
        bool is_beyond = false;
        for (int k = 0; k < 3; k++) {
            size_t v = (size_t)face.v[k];
            is_beyond = is_beyond || v == apex;
            face.v[k] = (int)number_of(r, first, v);
        }
        if (is_beyond)
            continue;
        *array_push(&q->face) = face;
        *array_push(&q->sheet) = from->sheet.item[f];
    }
}

void skin_region_free(struct skin_region *r)
{
    array_free(&r->mesh.vertex);
    array_free(&r->mesh.face);
    array_free(&r->mesh.sheet);
    free(r->vertex);
    free(r->inside);
    *r = (struct skin_region){.inside = NULL};
}
