/* meshnear - see meshnear.h. */
#include "meshnear.h"

#include <stdlib.h>

#include "kdtree.h"
#include "parallel.h"

enum { NEAR = 24 };

struct job {
    const struct mesh *mesh;
    const struct kdtree *middles;
    const struct vec3 *point;
    double *distance;
};

static double from_edge(struct vec3 p, struct vec3 a, struct vec3 b)
{
    struct vec3 way = vec_sub(b, a);
    double length2 = vec_dot(way, way);
    double s = length2 > 0 ? vec_dot(vec_sub(p, a), way) / length2 : 0;

    return vec_distance(p, vec_along(a, fmin(fmax(s, 0), 1), way));
}

double meshnear_triangle(struct vec3 p, struct vec3 a, struct vec3 b, struct vec3 c)
{
    struct vec3 n = vec_unit(vec_cross(vec_sub(b, a), vec_sub(c, a)));
    const struct vec3 corner[] = {a, b, c, a};
    double nearest = HUGE_VAL;
    bool inside = vec_length(n) > 0;

    for (int i = 0; i < 3; i++) {
        struct vec3 inwards = vec_cross(n, vec_sub(corner[i + 1], corner[i]));
        inside = inside && vec_dot(vec_sub(p, corner[i]), inwards) >= 0;
        nearest = fmin(nearest, from_edge(p, corner[i], corner[i + 1]));
    }
    return inside ? fabs(vec_dot(vec_sub(p, a), n)) : nearest;
}

static void measure(void *context, size_t from, size_t to)
{
    const struct job *job = context;
    const struct vec3 *at = job->mesh->vertex.item;

    for (size_t i = from; i < to; i++) {
        size_t near[NEAR];
        size_t n = kdtree_nearest(job->middles, job->point[i], NEAR, near, NULL);
        job->distance[i] = HUGE_VAL;
        for (size_t k = 0; k < n; k++) {
            const int *v = job->mesh->face.item[near[k]].v;
            job->distance[i] =
                fmin(job->distance[i],
                     meshnear_triangle(job->point[i], at[v[0]], at[v[1]], at[v[2]]));
        }
    }
}

void meshnear(const struct mesh *mesh, const struct vec3 *point, size_t n, int threads,
              double *distance)
{
    struct vec3 *middle = mem_alloc(mesh->face.n, sizeof *middle);

    for (size_t f = 0; f < mesh->face.n; f++) {
        const int *v = mesh->face.item[f].v;
        const struct vec3 *at = mesh->vertex.item;
        middle[f] = vec_scale(1 / 3.0, vec_add(at[v[0]], vec_add(at[v[1]], at[v[2]])));
    }
    struct kdtree *tree = kdtree_new(middle, mesh->face.n);
    struct job job = {mesh, tree, point, distance};
    parallel_for(threads, n, measure, &job);
    kdtree_free(tree);
    free(middle);
}
