/* scannormals - see scannormals.h. */
#include "scannormals.h"

#include <stdlib.h>
#include <string.h>

#include "kdtree.h"
#include "parallel.h"
#include "quadric.h"

enum { MOST_TIMES = 32, TURNS = 4 };

struct job {
    struct mesh *mesh;
    const struct kdtree *tree;
    const struct vec3 *point;
    size_t neighbours;
    double *distance; /* of each vertex from its quadric; negative: it has none */
};

/* Refits in the frame of the normal just found, until that stands still: on a slope the frame of
 * the facets would fit heights above a skew plane. */
static int fit_turned(const struct vec3 *near, size_t n, struct vec3 origin, struct vec3 guess,
                      struct quadric *q)
{
    const double still = 1e-4; /* radians */
    for (int i = 0; i < TURNS; i++) {
        if (quadric_fit(near, n, origin, guess, q) < 0)
            return -1;
        struct vec3 normal = quadric_normal(q);
        if (vec_distance(normal, guess) < still)
            return 0;
        guess = normal;
    }
    return 0;
}

/* From the facets' normal and, where that is steep, from straight up too: slivers between scan
 * lines and facets across a step have normals that mean nothing.  The better fit counts. */
static int fit_best(const struct vec3 *near, size_t n, struct vec3 origin, struct vec3 guess,
                    struct quadric *q)
{
    const double steep = cos(PI / 4);
    struct quadric other;
    int fitted = fit_turned(near, n, origin, guess, q);
    if (guess.z >= steep || fit_turned(near, n, origin, vec(0, 0, 1), &other) < 0)
        return fitted;
    if (fitted < 0 || quadric_rms(&other, near, n) < quadric_rms(q, near, n))
        *q = other;
    return 0;
}

/* What the points leave of their freedom: rms of their distances, for 6 of n fixed by the fit. */
static double spread(const struct quadric *q, const struct vec3 *near, size_t n)
{
    return quadric_rms(q, near, n) * sqrt((double)n / fmax((double)n - 6, 1));
}

/* Noise spreads the nearer half about its quadric as much as the whole; where it is spread much
 * less, the surface bends too much for one quadric over the whole, and the half counts. */
static void fit_half(const struct vec3 *near, size_t n, struct vec3 origin, struct quadric *q)
{
    const double much = 0.5;
    const size_t fewest = 12;
    struct quadric half;
    if (n / 2 >= fewest && fit_turned(near, n / 2, origin, quadric_normal(q), &half) == 0 &&
        spread(&half, near, n / 2) < much * spread(q, near, n))
        *q = half;
}

static int fit_at(const struct job *job, struct vec3 vertex, struct vec3 guess, struct sizes *index,
                  struct vec3s *near, struct quadric *q)
{
    for (size_t k = job->neighbours; k <= MOST_TIMES * job->neighbours; k *= 2) {
        array_reserve(index, k);
        array_reserve(near, k);
        size_t n = kdtree_nearest(job->tree, vertex, k, index->item, NULL);
        for (size_t i = 0; i < n; i++)
            near->item[i] = job->point[index->item[i]];
        if (fit_best(near->item, n, vertex, guess, q) == 0) {
            if (k == job->neighbours)
                fit_half(near->item, n, vertex, q);
            return 0;
        }
        if (n < k)
            break;
    }
    return -1;
}

static void fit_vertices(void *context, size_t from, size_t to)
{
    const struct job *job = context;
    struct mesh *mesh = job->mesh;
    struct sizes index = {0};
    struct vec3s near = {0};
    for (size_t i = from; i < to; i++) {
        struct quadric q;
        struct vec3 up = mesh->normal.item[i];
        job->distance[i] = -1;
        mesh->kmax.item[i] = 0;
        if (fit_at(job, mesh->vertex.item[i], up, &index, &near, &q) < 0)
            continue;
        mesh->normal.item[i] = quadric_normal(&q);
        mesh->kmax.item[i] = quadric_curvature(&q);
        job->distance[i] = quadric_distance(&q);
    }
    array_free(&index);
    array_free(&near);
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Three standard deviations of what is normally distributed, from the median of its size. */
static double three_sigma(double *distance, size_t n)
{
    static const double sigma_of_median = 1.4826;
    if (n == 0)
        return 0;
    qsort(distance, n, sizeof *distance, by_size);
    return 3 * sigma_of_median * distance[n / 2];
}

/* Gathers the distances that are there (not below 0) to the front of the array. */
static struct scannormals sum_up(double *distance, size_t n)
{
    struct scannormals s = {0};
    double sum2 = 0;
    for (size_t i = 0; i < n; i++) {
        if (distance[i] < 0) {
            s.thin++;
            continue;
        }
        sum2 += distance[i] * distance[i];
        if (distance[i] > s.worst) {
            s.worst = distance[i];
            s.at = i;
        }
        distance[s.fitted++] = distance[i];
    }
    s.rms = s.fitted > 0 ? sqrt(sum2 / (double)s.fitted) : 0;
    s.noise = three_sigma(distance, s.fitted);
    return s;
}

static int by_value(const void *a, const void *b)
{
    const struct vec3 *p = a, *q = b;
    if (p->x != q->x)
        return p->x < q->x ? -1 : 1;
    if (p->y != q->y)
        return p->y < q->y ? -1 : 1;
    return (p->z > q->z) - (p->z < q->z);
}

struct scannormals scannormals_quadric(struct mesh *mesh, const struct vec3 *point, size_t n,
                                       int neighbours, int threads)
{
    size_t vertices = mesh->vertex.n;
    /* of equally near points the tree gives the one with the smaller index: so let the index
     * follow from the values */
    struct vec3 *sorted = mem_alloc(n, sizeof *sorted);
    memcpy(sorted, point, n * sizeof *sorted);
    qsort(sorted, n, sizeof *sorted, by_value);
    struct kdtree *tree = kdtree_new(sorted, n);
    struct job job = {mesh, tree, sorted, (size_t)neighbours,
                      mem_alloc(vertices, sizeof *job.distance)};
    mesh_normals_facet(mesh);
    array_reserve(&mesh->kmax, vertices);
    mesh->kmax.n = vertices;
    parallel_for(threads, vertices, fit_vertices, &job);
    struct scannormals result = sum_up(job.distance, vertices);
    free(job.distance);
    kdtree_free(tree);
    free(sorted);
    return result;
}
