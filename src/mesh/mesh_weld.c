/* mesh_weld - see mesh_weld.h. */
#include "mesh/mesh_weld.h"

#include <stdlib.h>

struct place {
    struct vec3 p;
    size_t vertex;
};

static int compare_numbers(double a, double b)
{
    return (a > b) - (a < b);
}

static int compare_positions(struct vec3 a, struct vec3 b)
{
    if (a.x != b.x)
        return compare_numbers(a.x, b.x);
    return a.y != b.y ? compare_numbers(a.y, b.y) : compare_numbers(a.z, b.z);
}

static int compare_places(const void *pa, const void *pb)
{
    const struct place *a = pa, *b = pb;
    int order = compare_positions(a->p, b->p);

    return order != 0 ? order : (a->vertex > b->vertex) - (a->vertex < b->vertex);
}

size_t *mesh_first_at_place(const struct mesh *mesh)
{
    struct place *place = mem_alloc(mesh->vertex.n, sizeof *place);
    size_t *first = mem_alloc(mesh->vertex.n, sizeof *first);

    for (size_t v = 0; v < mesh->vertex.n; v++)
        place[v] = (struct place){mesh->vertex.item[v], v};
    qsort(place, mesh->vertex.n, sizeof *place, compare_places);
    for (size_t i = 0, begin = 0; i < mesh->vertex.n; i++) {
        if (compare_positions(place[i].p, place[begin].p) != 0)
            begin = i;
        first[place[i].vertex] = place[begin].vertex;
    }
    free(place);
    return first;
}

size_t mesh_weld(struct mesh *mesh)
{
    size_t welded = 0;
    size_t *first = mesh_first_at_place(mesh);
    int *number = mem_alloc(mesh->vertex.n, sizeof *number);
    struct vec3s vertex = {0};

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
