#include "scan.h"

#include <stdlib.h>

#include "cloud.h"
#include "kdtree.h"

static struct vec3 place(const double m[4][4], struct vec3 p)
{
    return vec(m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z + m[0][3],
               m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z + m[1][3],
               m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z + m[2][3]);
}

/* How many vertices have no point of the scan within `near`. */
static size_t far_vertices(const struct mesh *mesh, const struct vec3s *points, double near)
{
    struct kdtree *tree = kdtree_new(points->item, points->n);
    size_t far = 0;

    for (size_t v = 0; v < mesh->vertex.n; v++) {
        size_t nearest;
        double distance2;
        if (kdtree_nearest(tree, mesh->vertex.item[v], 1, &nearest, &distance2) == 0 ||
            distance2 > near * near)
            far++;
    }
    kdtree_free(tree);
    return far;
}

int scan_read(const struct cli_list *files, const struct mesh *mesh, double near,
              struct vec3s *points, struct error *error)
{
    size_t before = points->n;

    for (size_t f = 0; f < files->n; f++) {
        struct cloud_count count = {0};
        size_t from = points->n;
        if (cloud_read(files->item[f], points, &count, error) != 0)
            return -1;
        if (points->n == from)
            return error_set(error, "%s: found no points", files->item[f]);
        if (count.not_finite > 0)
            say("%s: %zu rows without finite numbers left out, the first in line %zu",
                files->item[f], count.not_finite, count.first_not_finite);
        for (size_t i = from; mesh->origin.placed && i < points->n; i++)
            points->item[i] = place(mesh->origin.place, points->item[i]);
    }
    if (mesh->origin.placed)
        say("the scan to guard is placed as the mesh was");
    note("guarded by %zu points of the scan", points->n - before);

    size_t far = far_vertices(mesh, points, near);
    if (2 * far > mesh->vertex.n)
        return error_set(error,
                         "%s: found %zu of %zu mesh vertices further than %.3g mm from the scan, "
                         "expected the scan that the mesh was made from",
                         files->item[0], far, mesh->vertex.n, near);
    return 0;
}
