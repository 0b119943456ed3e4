/* skin - see skin.h. */
#include "nurbs/skin.h"

#include <stdlib.h>

#include "skin_loops.h"
#include "skin_sides.h"

static size_t place_of(const struct patch_mesh *q, int vertex)
{
    return q->vertex.item[vertex].place;
}

static struct vec3 point_of(const struct patch_mesh *q, size_t place)
{
    return q->vertex.item[place].point;
}

static size_t root(size_t *parent, size_t i)
{
    while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
    return i;
}

static void unite(size_t *parent, size_t a, size_t b)
{
    a = root(parent, a);
    b = root(parent, b);
    parent[a > b ? a : b] = a > b ? b : a;
}

static int compare_bodies(const void *p, const void *q)
{
    const struct skin_body *a = p, *b = q;

    if (a->area < b->area || a->area > b->area)
        return a->area > b->area ? -1 : 1;
    return (a->facets < b->facets) - (a->facets > b->facets);
}

/* Area, and volume against the point `from`, of a facet as it is turned. */
static void add_facet(const struct patch_mesh *q, size_t facet, struct vec3 from,
                      struct skin_body *body)
{
    const int *v = q->face.item[facet].v;
    struct vec3 a = vec_sub(point_of(q, place_of(q, v[0])), from);
    struct vec3 b = vec_sub(point_of(q, place_of(q, v[1])), from);
    struct vec3 c = vec_sub(point_of(q, place_of(q, v[2])), from);
    struct vec3 cross = vec_scale(0.5, vec_cross(vec_sub(b, a), vec_sub(c, a)));

    body->facets++;
    body->area += vec_length(cross);
    body->volume += (q->flipped[q->sheet.item[facet]] ? -1 : 1) * vec_dot(a, cross) / 3;
}

/* A body for each set of facets that hang together; its number, from 1, in body[] by facet. */
static void find_bodies(const struct patch_mesh *q, size_t *parent, size_t *body, struct skin *skin)
{
    struct vec3 from = q->vertex.n > 0 ? q->vertex.item[0].point : vec(0, 0, 0);

    for (size_t f = 0; f < q->face.n; f++) {
        if (!skin_facet_counts(q, f))
            continue;
        size_t first = root(parent, f);
        if (body[first] == 0) {
            *array_push(&skin->body) = (struct skin_body){0};
            body[first] = skin->body.n;
        }
        body[f] = body[first];
        add_facet(q, f, from, &skin->body.item[body[f] - 1]);
    }
}

/* The number of a facet's corner at a place. */
static size_t corner_at(const struct patch_mesh *q, size_t facet, size_t place)
{
    const int *v = q->face.item[facet].v;
    int k = 0;

    while (k < 2 && place_of(q, v[k]) != place)
        k++;
    return 3 * facet + (size_t)k;
}

/* Counts the fans of facets about places, of each body: those that hang together by the edges at
 * the place.  Where a skin touches itself at a point, one place has several fans and is several
 * points of the surface; Euler's formula counts these. */
static void count_fans(const struct patch_mesh *q, const struct skin_side *side, size_t n,
                       const size_t *body, struct skin *skin)
{
    size_t *parent = mem_alloc(3 * q->face.n + 1, sizeof *parent);

    for (size_t i = 0; i < 3 * q->face.n; i++)
        parent[i] = i;
    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        for (size_t j = 1; j < k; j++) {
            size_t a = side[i].facet, b = side[i + j].facet;
            unite(parent, corner_at(q, a, side[i].low), corner_at(q, b, side[i].low));
            unite(parent, corner_at(q, a, side[i].high), corner_at(q, b, side[i].high));
        }
    }
    for (size_t c = 0; c < 3 * q->face.n; c++)
        if (body[c / 3] > 0)
            skin->body.item[body[c / 3] - 1].fans += root(parent, c) == c;
    free(parent);
}

/* Do as many of the facets along an edge go there as go back? */
static bool is_even(const struct skin_side *side, size_t n)
{
    size_t forwards = 0;
    for (size_t i = 0; i < n; i++)
        forwards += side[i].forward;
    return 2 * forwards == n;
}

bool skin_body_closed(const struct skin_body *body)
{
    return body->open == 0 && body->uneven == 0 && body->unlike == 0;
}

/* The largest body first, and the body that each sheet is a part of. */
static void sort_bodies(const struct patch_mesh *q, const size_t *body, struct skin *skin)
{
    enum { NONE = -1, SEVERAL = -2 };
    int *new_number = mem_alloc(skin->body.n + 1, sizeof *new_number);

    for (size_t i = 0; i < skin->body.n; i++)
        skin->body.item[i].number = i;
    if (skin->body.n > 1)
        qsort(skin->body.item, skin->body.n, sizeof *skin->body.item, compare_bodies);
    for (size_t i = 0; i < skin->body.n; i++)
        new_number[skin->body.item[i].number] = (int)i;
    skin->body_of = mem_alloc(q->sheets + 1, sizeof *skin->body_of);
    for (size_t i = 0; i < q->sheets; i++)
        skin->body_of[i] = NONE;
    for (size_t f = 0; f < q->face.n; f++) {
        int *of = &skin->body_of[q->sheet.item[f]],
            b = body[f] > 0 ? new_number[body[f] - 1] : NONE;
        if (b >= 0 && *of != b)
            *of = *of == NONE ? b : SEVERAL;
    }
    for (size_t f = 0; f < q->face.n; f++)
        if (body[f] > 0 && skin->body_of[q->sheet.item[f]] == SEVERAL)
            skin->body.item[new_number[body[f] - 1]].shared = true;
    free(new_number);
}

static void count_open(const struct patch_mesh *q, const struct skin_sides *open, struct skin *skin)
{
    skin->open_on = mem_alloc(q->sheets + 1, sizeof *skin->open_on);
    for (size_t i = 0; i < open->n; i++)
        skin->open_on[q->sheet.item[open->item[i].facet]]++;
}

struct skin skin_of(const struct patch_mesh *q)
{
    struct skin skin = {.open = 0};
    struct skin_sides open = {0};
    size_t n, *parent = mem_alloc(q->face.n + 1, sizeof *parent);
    size_t *body = mem_alloc(q->face.n + 1, sizeof *body);
    struct skin_side *side = skin_sides_find(q, &n);

    for (size_t f = 0; f < q->face.n; f++)
        parent[f] = f;
    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        for (size_t j = 1; j < k; j++)
            unite(parent, side[i].facet, side[i + j].facet);
    }
    find_bodies(q, parent, body, &skin);
    count_fans(q, side, n, body, &skin);
    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        struct skin_body *b = &skin.body.item[body[side[i].facet] - 1];
        b->edges++;
        b->open += k == 1;
        b->many += k > 2;
        b->uneven += k > 2 && !is_even(&side[i], k);
        b->unlike += k == 2 && side[i].forward == side[i + 1].forward;
        if (k == 1)
            *array_push(&open) = side[i];
    }
    for (size_t i = 0; i < skin.body.n; i++) {
        struct skin_body *b = &skin.body.item[i];
        skin.open += b->open;
        skin.many += b->many;
        skin.unlike += b->unlike;
        /* Euler: points - edges + facets = 2 - 2 genus */
        b->genus = (2 - ((long)b->fans - (long)b->edges + (long)b->facets)) / 2;
    }
    skin.loop = skin_loops_find(q, &open);
    count_open(q, &open, &skin);
    sort_bodies(q, body, &skin);
    array_free(&open);
    free(side);
    free(parent);
    free(body);
    return skin;
}

void skin_free(struct skin *skin)
{
    array_free(&skin->loop);
    array_free(&skin->body);
    free(skin->body_of);
    free(skin->open_on);
    skin->body_of = NULL;
    skin->open_on = NULL;
}
