/* mesh_weld - see mesh_weld.h. */
#include "mesh/mesh_weld.h"

#include <stdlib.h>

#include "mesh/scan_source.h"

static bool same_place(struct vec3 a, struct vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* By open addressing in a table of twice the size (Knuth, 6.4, algorithm L). */
size_t *mesh_first_at_place(const struct mesh *mesh)
{
    const struct vec3 *p = mesh->vertex.item;
    size_t n = mesh->vertex.n, slots = 2, *first = mem_alloc(n, sizeof *first);

    while (slots < 2 * n)
        slots *= 2;
    int *held = mem_alloc(slots, sizeof *held); /* one more than a vertex; 0: none */
    for (size_t v = 0; v < n; v++) {
        size_t at = scan_source_hash(&p[v], 1) >> 1 & (slots - 1); /* its last bit is always 1 */
        while (held[at] > 0 && !same_place(p[held[at] - 1], p[v]))
            at = (at + 1) & (slots - 1);
        if (held[at] == 0)
            held[at] = (int)v + 1;
        first[v] = (size_t)held[at] - 1;
    }
    free(held);
    return first;
}

size_t mesh_weld(struct mesh *mesh)
{
    size_t welded = 0;
    size_t *first = mesh_first_at_place(mesh);
    int *number = mem_alloc(mesh->vertex.n, sizeof *number);
    struct vec3s vertex = {0};

    array_reserve(&vertex, mesh->vertex.n);
    for (size_t v = 0; v < mesh->vertex.n; v++) {
        number[v] = -1;
        welded += first[v] != v;
    }
    for (size_t f = 0; f < mesh->face.n; f++) {
        for (int i = 0; i < 3; i++) {
            int *v = &mesh->face.item[f].v[i];
            size_t at = first[*v];
            if (number[at] < 0) {
                number[at] = (int)vertex.n;
                *array_push(&vertex) = mesh->vertex.item[at];
            }
            *v = number[at];
        }
    }
    free(first);
    free(number);
    array_free(&mesh->vertex);
    array_free(&mesh->normal);
    array_free(&mesh->row);
    array_free(&mesh->col);
    array_free(&mesh->kmax);
    mesh->vertex = vertex;
    return welded;
}
