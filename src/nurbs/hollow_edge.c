/* hollow_edge - see hollow_edge.h. */
#include "nurbs/hollow_edge.h"

#include <stdlib.h>

#include "math/elementary.h"
#include "skin_sides.h"

/* The vertex of a facet at the lower or the higher place of its side. */
static const struct patch_mesh_vertex *end_of(const struct patch_mesh *q,
                                              const struct skin_side *side, bool high)
{
    const int *v = q->face.item[side->facet].v;
    const struct patch_mesh_vertex *first = &q->vertex.item[v[side->corner]];
    bool is_first = (first->place == side->high) == high;

    return is_first ? first : &q->vertex.item[v[(side->corner + 1) % 3]];
}

/* The normal there, outwards. */
static struct vec3 normal_at(const struct patch_mesh *q, const struct skin_side *side, bool high)
{
    return vec_scale(q->flipped[q->sheet.item[side->facet]] ? -1 : 1,
                     end_of(q, side, high)->normal);
}

/* How far the surface turns up there from one facet to the other, radians; below 0: down.  Along
 * the side, as it is turned, the facet is to the left. */
static double turn_at(const struct patch_mesh *q, const struct skin_side side[2], bool high)
{
    struct vec3 along =
        vec_unit(vec_sub(q->vertex.item[side[1].high].point, q->vertex.item[side[1].low].point));
    struct vec3 n = normal_at(q, &side[0], high), m = normal_at(q, &side[1], high);
    struct vec3 away = vec_scale(side[1].forward ? 1 : -1, vec_cross(m, along));

    return atan2(vec_dot(n, away), vec_dot(n, m));
}

static struct hollow_edge edge_of(const struct patch_mesh *q, const struct skin_side side[2])
{
    struct hollow_edge edge = {.angle = fmin(turn_at(q, side, false), turn_at(q, side, true))};

    edge.at = vec_mix(q->vertex.item[side->low].point, q->vertex.item[side->high].point, 0.5);
    for (int k = 0; k < 2; k++) {
        struct uv a = end_of(q, &side[k], false)->at, b = end_of(q, &side[k], true)->at;
        edge.uv[k] = (struct uv){(a.u + b.u) / 2, (a.v + b.v) / 2};
        edge.sheet[k] = q->sheet.item[side[k].facet];
    }
    return edge;
}

struct hollow_edge *hollow_edges_find(const struct patch_mesh *q, struct hollow_edge *sharpest)
{
    struct hollow_edge *within = mem_alloc(q->sheets + 1, sizeof *within);
    size_t n;
    struct skin_side *side = skin_sides_find(q, &n);

    *sharpest = (struct hollow_edge){.angle = 0};
    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        if (!skin_edge_sound(&side[i], k))
            continue;
        struct hollow_edge edge = edge_of(q, &side[i]);
        if (!(edge.angle > RADIANS(PATCH_MESH_SMOOTH)))
            continue;
        if (edge.sheet[0] == edge.sheet[1] && edge.angle > within[edge.sheet[0]].angle)
            within[edge.sheet[0]] = edge;
        if (edge.angle > sharpest->angle)
            *sharpest = edge;
    }
    free(side);
    return within;
}
