/* mesh_clean - see mesh_clean.h. */
#include "mesh_clean.h"

#include <stdbool.h>
#include <stdlib.h>

#include "base/array.h"

/* Below this part of its longest edge's square, twice a facet's area is rounding. */
static const double AREA_OF_NOTHING = 1e-12;

static bool has_area(const struct mesh *mesh, size_t facet)
{
    const int *v = mesh->face.item[facet].v;
    double longest = 0;

    for (int i = 0; i < 3; i++) {
        struct vec3 side = vec_sub(mesh->vertex.item[v[(i + 1) % 3]], mesh->vertex.item[v[i]]);
        longest = fmax(longest, vec_dot(side, side));
    }
    return vec_length(mesh_face_cross(mesh, facet)) > AREA_OF_NOTHING * longest;
}

/* Leaves out the facets that are marked. */
static void leave_out(struct mesh *mesh, const bool *out)
{
    size_t n = 0;

    for (size_t f = 0; f < mesh->face.n; f++) {
        if (!out[f])
            mesh->face.item[n++] = mesh->face.item[f];
    }
    mesh->face.n = n;
}

size_t mesh_clean_no_area(struct mesh *mesh)
{
    bool *out = mem_alloc(mesh->face.n, sizeof *out);
    size_t before = mesh->face.n;

    for (size_t f = 0; f < mesh->face.n; f++)
        out[f] = !has_area(mesh, f);
    leave_out(mesh, out);
    free(out);
    return before - mesh->face.n;
}

/* A facet by its vertices in rising order. */
struct corners {
    int v[3];
    size_t facet;
};

static struct corners corners_of(const struct mesh *mesh, size_t facet)
{
    const int *v = mesh->face.item[facet].v;
    int low = v[0] < v[1] ? v[0] : v[1], high = v[0] < v[1] ? v[1] : v[0];

    if (v[2] < low)
        return (struct corners){{v[2], low, high}, facet};
    if (v[2] < high)
        return (struct corners){{low, v[2], high}, facet};
    return (struct corners){{low, high, v[2]}, facet};
}

static int compare_vertices(const struct corners *a, const struct corners *b)
{
    for (int i = 0; i < 3; i++) {
        if (a->v[i] != b->v[i])
            return a->v[i] < b->v[i] ? -1 : 1;
    }
    return 0;
}

static int compare_corners(const void *pa, const void *pb)
{
    const struct corners *a = pa, *b = pb;
    int order = compare_vertices(a, b);

    return order != 0 ? order : (a->facet > b->facet) - (a->facet < b->facet);
}

size_t mesh_clean_doubled(struct mesh *mesh)
{
    size_t n = mesh->face.n;
    struct corners *corners = mem_alloc(n, sizeof *corners);
    bool *out = mem_alloc(n, sizeof *out);

    for (size_t f = 0; f < n; f++)
        corners[f] = corners_of(mesh, f);
    qsort(corners, n, sizeof *corners, compare_corners);
    for (size_t i = 1; i < n; i++)
        out[corners[i].facet] = compare_vertices(&corners[i - 1], &corners[i]) == 0;
    leave_out(mesh, out);
    free(corners);
    free(out);
    return n - mesh->face.n;
}
