/* mesh_join - see mesh_join.h. */
#include "meshing/mesh_join.h"

static int rows_of(const struct mesh *mesh)
{
    int last = -1;

    for (size_t v = 0; v < mesh->row.n; v++)
        last = mesh->row.item[v] > last ? mesh->row.item[v] : last;
    return last + 1;
}

void mesh_join_add(struct mesh *to, const struct mesh *mesh, const struct segment *part)
{
    int row = rows_of(to), first = (int)to->vertex.n;

    *array_push(&to->origin.part) = (struct mesh_part){row, part->along, part->up};
    for (size_t v = 0; v < mesh->vertex.n; v++) {
        int own = mesh->row.item[v];
        *array_push(&to->vertex) = segment_out(part, mesh->vertex.item[v]);
        *array_push(&to->normal) = segment_out(part, mesh->normal.item[v]);
        *array_push(&to->row) = own < 0 ? own : row + own;
        *array_push(&to->col) = mesh->col.item[v];
        if (mesh->kmax.n > 0)
            *array_push(&to->kmax) = mesh->kmax.item[v];
    }
    for (size_t f = 0; f < mesh->face.n; f++) {
        const int *v = mesh->face.item[f].v;
        *array_push(&to->face) = (struct face){{first + v[0], first + v[1], first + v[2]}};
    }
}

/* The first vertex whose row is in part k or a later one: the parts follow each other. */
static int first_of(const struct mesh *mesh, size_t k)
{
    int v = 0, n = (int)mesh->vertex.n;

    if (k >= mesh->origin.part.n)
        return n;
    while (v < n && mesh->row.item[v] < mesh->origin.part.item[k].row)
        v++;
    return v;
}

struct mesh mesh_join_of(const struct mesh *mesh, size_t k)
{
    struct mesh part = {.origin.ledger = NAN};
    int first = first_of(mesh, k), end = first_of(mesh, k + 1);

    for (int v = first; v < end; v++) {
        *array_push(&part.vertex) = mesh->vertex.item[v];
        *array_push(&part.normal) = mesh->normal.item[v];
        if (mesh->kmax.n > 0)
            *array_push(&part.kmax) = mesh->kmax.item[v];
    }
    for (size_t f = 0; f < mesh->face.n; f++) {
        const int *v = mesh->face.item[f].v;
        if (v[0] >= first && v[0] < end)
            *array_push(&part.face) = (struct face){{v[0] - first, v[1] - first, v[2] - first}};
    }
    return part;
}
