#include "stage/mesh_for_rows.h"

#include <string.h>

#include "io/mesh/ply.h"

int mesh_for_rows_read(const char *file, const struct normal_estimator *normals, struct mesh *mesh,
                       struct error *error)
{
    struct error why;
    struct normals_options options = {.silent = false};

    if (ply_read(file, mesh, error) != 0)
        return -1;
    if (normals->estimate(mesh, &options, &why) != 0)
        return error_at(error, file, 0, "%s", why.text);
    for (size_t v = 0; v < mesh->vertex.n; v++) {
        if (vec_length(mesh->normal.item[v]) < 0.5)
            return error_at(error, file, 0,
                            "vertex %zu: found a normal of no length, expected a "
                            "unit vector",
                            v);
    }
    return 0;
}

double mesh_for_rows_top(const struct mesh *mesh)
{
    double top = -HUGE_VAL;

    for (size_t v = 0; v < mesh->vertex.n; v++)
        top = fmax(top, mesh->vertex.item[v].z);
    return top;
}

const char *mesh_for_rows_name(const struct mesh *mesh)
{
    const char *source = mesh->origin.source;

    if (!source)
        return "PART";
    const char *slash = strrchr(source, '/');
    return slash ? slash + 1 : source;
}
