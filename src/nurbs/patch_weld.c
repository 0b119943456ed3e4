/* patch_weld - see patch_weld.h. */
#include "nurbs/patch_weld.h"

#include <stdint.h>
#include <stdlib.h>

#include "base/num.h"

/* Bits of a double, mixed into a hash (the finalizer of MurmurHash3). */
static uint64_t mix(uint64_t hash, double x)
{
    union {
        double number;
        uint64_t bits;
    } of = {.number = x + 0.0}; /* -0 is 0 */
    hash ^= of.bits;
    hash ^= hash >> 33;
    hash *= UINT64_C(0xff51afd7ed558ccd);
    hash ^= hash >> 33;
    hash *= UINT64_C(0xc4ceb9fe1a85ec53);
    return hash ^ hash >> 33;
}

static bool is_same(struct vec3 a, struct vec3 b)
{
    return vec_distance(a, b) <= 0;
}

/* A table of the places seen, by hash, with open addresses; twice as many as there can be. */
struct table {
    size_t *place; /* from 1 */
    size_t mask;
};

static struct table table_of(size_t n)
{
    struct table t = {.mask = 1};
    while (t.mask < 2 * n + 2)
        t.mask *= 2;
    t.place = mem_alloc(t.mask, sizeof *t.place);
    t.mask--;
    return t;
}

/* The first vertex at the point of vertex v, of the same body: v itself if there is none. */
static size_t first_at(const struct table *t, const struct patch_mesh *q,
                       const struct patches *patches, size_t v)
{
    const struct patch_mesh_vertex *at = &q->vertex.item[v];
    const struct patch *of = &patches->item[at->sheet];
    uint64_t body = (uint64_t)of->body + ((uint64_t)of->group << 32);
    uint64_t hash = mix(mix(mix(body, at->point.x), at->point.y), at->point.z);
    size_t i = (size_t)hash & t->mask;
    for (; t->place[i] > 0; i = (i + 1) & t->mask) {
        const struct patch_mesh_vertex *there = &q->vertex.item[t->place[i] - 1];
        if (is_same(there->point, at->point) && patch_may_join(&patches->item[there->sheet], of))
            return t->place[i] - 1;
    }
    t->place[i] = v + 1;
    return v;
}

size_t patch_mesh_weld(struct patch_mesh *q, const struct patches *patches)
{
    struct table seen = table_of(q->vertex.n);
    size_t welded = 0;
    for (size_t i = 0; i < q->vertex.n; i++) {
        struct vec3 *p = &q->vertex.item[i].point;
        *p = vec(num_round(p->x, PATCH_MESH_DIGITS), num_round(p->y, PATCH_MESH_DIGITS),
                 num_round(p->z, PATCH_MESH_DIGITS));
    }
    for (size_t i = 0; i < q->vertex.n; i++) {
        size_t first = first_at(&seen, q, patches, i);
        if (q->vertex.item[first].place == q->vertex.item[i].place)
            continue;
        patch_mesh_unite(q, first, i);
        welded++;
    }
    free(seen.place);
    return welded;
}
