/* meshnear - see meshnear.h. */
#include "meshnear.h"

#include <stdlib.h>

#include "kdtree.h"
#include "parallel.h"

enum { NEAR = 24, DEPTH = 8 };

struct job {
    const struct mesh *mesh;
    const struct kdtree *middles;
    const size_t *of; /* the facet of each */
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
            const int *v = job->mesh->face.item[job->of[near[k]]].v;
            job->distance[i] =
                fmin(job->distance[i],
                     meshnear_triangle(job->point[i], at[v[0]], at[v[1]], at[v[2]]));
        }
    }
}

/* Middles of a facet's pieces, the longest edge halved until it is no longer than `length`. */
static void add_middles(struct vec3 a, struct vec3 b, struct vec3 c, double length, int depth,
                        size_t facet, struct vec3s *middle, struct sizes *of)
{
    double ab = vec_distance(a, b), bc = vec_distance(b, c), ca = vec_distance(c, a);

    if (depth == 0 || fmax(ab, fmax(bc, ca)) <= length) {
        *array_push(middle) = vec_scale(1 / 3.0, vec_add(a, vec_add(b, c)));
        *array_push(of) = facet;
    } else if (ab >= bc && ab >= ca) {
        struct vec3 half = vec_mix(a, b, 0.5);
        add_middles(a, half, c, length, depth - 1, facet, middle, of);
        add_middles(half, b, c, length, depth - 1, facet, middle, of);
    } else {
        add_middles(b, c, a, length, depth, facet, middle, of);
    }
}

/* The mean of the facets' shortest edges. */
static double short_edge(const struct mesh *mesh)
{
    double sum = 0;

    for (size_t f = 0; f < mesh->face.n; f++) {
        const int *v = mesh->face.item[f].v;
        const struct vec3 *at = mesh->vertex.item;
        sum += fmin(vec_distance(at[v[0]], at[v[1]]),
                    fmin(vec_distance(at[v[1]], at[v[2]]), vec_distance(at[v[2]], at[v[0]])));
    }
    return sum / (double)mesh->face.n;
}

void meshnear(const struct mesh *mesh, const struct vec3 *point, size_t n, int threads,
              double *distance)
{
    struct vec3s middle = {0};
    struct sizes of = {0};
    double length = 3 * short_edge(mesh);

    for (size_t f = 0; f < mesh->face.n; f++) {
        const int *v = mesh->face.item[f].v;
        const struct vec3 *at = mesh->vertex.item;
        add_middles(at[v[0]], at[v[1]], at[v[2]], length, DEPTH, f, &middle, &of);
    }
    struct kdtree *tree = kdtree_new(middle.item, middle.n);
    struct job job = {mesh, tree, of.item, point, distance};
    parallel_for(threads, n, measure, &job);
    kdtree_free(tree);
    array_free(&middle);
    array_free(&of);
}
