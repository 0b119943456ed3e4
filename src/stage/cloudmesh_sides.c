/*
 * cloudmesh_sides - facets of a projection that face the other side of the cloud: where it folds
 * under itself a grid joins points of both.
 */
#include "cloudmesh_steps.h"

#include <stdlib.h>

#include "cloud/segment.h"
#include "math/kdtree.h"
#include "mesh/mesh_clip.h"

/* Points about a facet; for a vertex so many are enough to tell sides, and for all as many. */
enum { ABOUT = 8, ENOUGH = 3, MOST = 60000 };

/* The normals of points are of one side where their mean is so long; cosine of a facet that faces
 * the other one, at most; part of the mesh from where on nobody knows which side is meant. */
static const double ALIKE = 0.7, AGAINST = -0.4, MUCH = 0.5;

/* Cosine, seen from above: 45 degrees. */
static const double FLAT = 0.7;

struct sides {
    struct kdtree *tree;
    const struct vec3 *normal;
    double flat; /* cosine: a facet that faces up so much is not asked */
};

static bool faces_against(const struct sides *sides, const struct mesh *mesh, size_t face)
{
    struct vec3 cross = mesh_face_cross(mesh, face);
    if (cross.z > sides->flat * vec_length(cross))
        return false;
    const int *v = mesh->face.item[face].v;
    struct vec3 centre =
        vec_scale(1.0 / 3, vec_add(vec_add(mesh->vertex.item[v[0]], mesh->vertex.item[v[1]]),
                                   mesh->vertex.item[v[2]]));
    struct vec3 sum = {0, 0, 0};
    size_t near[ABOUT], n = kdtree_nearest(sides->tree, centre, ABOUT, near, NULL);

    for (size_t i = 0; i < n; i++)
        sum = vec_add(sum, sides->normal[near[i]]);
    double length = vec_length(sum);
    return length > ALIKE * (double)n && vec_dot(sum, cross) < AGAINST * length * vec_length(cross);
}

/* Marks those facets; which part of the mesh's area they are. */
static double mark_turned(const struct sides *sides, const struct mesh *mesh, bool *turned)
{
    double area = 0;

    for (size_t f = 0; f < mesh->face.n; f++) {
        turned[f] = faces_against(sides, mesh, f);
        area += turned[f] ? vec_length(mesh_face_cross(mesh, f)) / 2 : 0;
    }
    return area > 0 ? area / mesh_area(mesh) : 0;
}

/* Some of the points, enough to tell sides. */
static struct vec3s some_of(const struct vec3s *points, const struct mesh *mesh)
{
    size_t enough = ENOUGH * mesh->vertex.n < MOST ? ENOUGH * mesh->vertex.n : MOST;
    size_t every = points->n / (enough + 1) + 1;
    struct vec3s some = {0};

    for (size_t i = 0; i < points->n; i += every)
        *array_push(&some) = points->item[i];
    return some;
}

size_t cloudmesh_drop_turned(const struct vec3s *points, struct vec3 outside, double steep,
                             int threads, struct mesh *mesh, double *part)
{
    size_t before = mesh->face.n;

    *part = 0;
    if (mesh_steep_part(mesh, vec(0, 0, 1)) < steep)
        return 0;
    struct vec3s some = some_of(points, mesh);
    struct vec3 *normal = mem_alloc(some.n + 1, sizeof *normal);
    struct sides sides = {kdtree_new_by(some.item, some.n, threads), normal, steep > 0 ? FLAT : 1};
    bool *turned = mem_alloc(mesh->face.n + 1, sizeof *turned);
    if (some.n > SEGMENTS_LEAST) {
        segments_normals(some.item, some.n, outside, threads, normal);
        *part = mark_turned(&sides, mesh, turned);
        if (*part < MUCH)
            mesh_clip_marked(mesh, turned);
        if (mesh->face.n < before)
            mesh_clip_unused(mesh);
    }
    kdtree_free(sides.tree);
    array_free(&some);
    free(turned);
    free(normal);
    return before - mesh->face.n;
}
