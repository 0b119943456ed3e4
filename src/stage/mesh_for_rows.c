#include "stage/mesh_for_rows.h"

#include <string.h>

#include "base/cli.h"
#include "io/mesh/ply.h"

static int set_normals(enum mesh_for_rows_normals normals, struct mesh *mesh, struct error *error)
{
    bool none = mesh->normal.n == 0;

    if (normals == ROW_NORMALS_CENTRAL)
        return mesh_normals_central(mesh, error);
    if (none && normals == ROW_NORMALS_MESH)
        say("the mesh has no normals: taking the mean of the facets'");
    if (none || normals == ROW_NORMALS_FACET)
        mesh_normals_facet(mesh);
    if (normals == ROW_NORMALS_GOURAUD)
        mesh_normals_gouraud(mesh);
    return 0;
}

int mesh_for_rows_read(const char *file, enum mesh_for_rows_normals normals, struct mesh *mesh,
                       struct error *error)
{
    struct error why;

    if (ply_read(file, mesh, error) != 0)
        return -1;
    if (set_normals(normals, mesh, &why) != 0)
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
