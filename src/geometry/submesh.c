/* submesh - see submesh.h. */
#include "submesh.h"

static int rows_of(const struct mesh *mesh)
{
    int last = -1;

    for (size_t v = 0; v < mesh->row.n; v++)
        last = mesh->row.item[v] > last ? mesh->row.item[v] : last;
    return last + 1;
}

void submesh_add(struct mesh *to, const struct mesh *mesh, const struct subcloud *part)
{
    int row = rows_of(to), first = (int)to->vertex.n;

    *array_push(&to->origin.part) = (struct mesh_part){row, part->along, part->up};
    for (size_t v = 0; v < mesh->vertex.n; v++) {
        int own = mesh->row.item[v];
        *array_push(&to->vertex) = subcloud_out(part, mesh->vertex.item[v]);
        *array_push(&to->normal) = subcloud_out(part, mesh->normal.item[v]);
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
