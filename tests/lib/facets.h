/*
 * facets - small skins of one sheet, from places and facets, for the tests of skins.
 */
#ifndef CLOUDMILL_TEST_FACETS_H
#define CLOUDMILL_TEST_FACETS_H

#include <stdlib.h>

#include "base/array.h"
#include "nurbs/patch_mesh.h"

/* A vertex for each place; facets as they are given.  Free with patch_mesh_free(). */
static struct patch_mesh facets_skin(const struct vec3 *place, size_t n, const int (*corner)[3],
                                     size_t faces)
{
    struct patch_mesh q = {.sheets = 1, .flipped = mem_alloc(1, sizeof *q.flipped)};
    for (size_t i = 0; i < n; i++)
        *array_push(&q.vertex) =
            (struct patch_mesh_vertex){.point = place[i], .place = i, .next = i};
    for (size_t f = 0; f < faces; f++) {
        *array_push(&q.face) = (struct face){{corner[f][0], corner[f][1], corner[f][2]}};
        *array_push(&q.sheet) = 0;
    }
    return q;
}

/* A square of n by n cells of side `cell` in the plane z = 0, two facets each, seen from above
 * counter-clockwise. */
static inline struct patch_mesh facets_square(int n, double cell)
{
    struct patch_mesh q = facets_skin(NULL, 0, NULL, 0);
    for (int i = 0; i <= n; i++)
        for (int k = 0; k <= n; k++) {
            size_t v = q.vertex.n;
            *array_push(&q.vertex) = (struct patch_mesh_vertex){
                .point = vec(k * cell, i * cell, 0), .place = v, .next = v};
        }
    for (int i = 0; i < n; i++)
        for (int k = 0; k < n; k++) {
            int a = i * (n + 1) + k, b = a + 1, c = a + n + 1, d = c + 1;
            *array_push(&q.face) = (struct face){{a, b, d}};
            *array_push(&q.face) = (struct face){{a, d, c}};
            *array_push(&q.sheet) = 0;
            *array_push(&q.sheet) = 0;
        }
    return q;
}

#endif
