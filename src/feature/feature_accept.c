/* feature_accept - see feature_steps.h. */
#include "feature_steps.h"

#include <stdlib.h>

#include "base/array.h"
#include "mesh/mesh_distance.h"

/* Of the noise's squares: so little says nothing. */
static const double SAME = 0.1;

/* Sums of squared distances, without the feature and with it. */
struct sums {
    double without, with, points;
};

static bool is_better(const struct sums *s, double noise)
{
    double same = SAME * s->points * noise * noise;

    return s->with < s->without + same;
}

/* The middles of the features that there are, and which these are. */
static struct vec3s places_of(const struct feature *feature, size_t n, struct sizes *which)
{
    struct vec3s place = {0};

    for (size_t i = 0; i < n; i++) {
        if (feature[i].kind == FEATURE_NONE)
            continue;
        *array_push(&place) = vec_mix(feature[i].place[0], feature[i].place[1], 0.5);
        *array_push(which) = i;
    }
    return place;
}

/* How far a point is from a feature: at a wall from the line down it. */
static double off_feature(const struct feature *f, struct vec3 p)
{
    return vec_segment_distance(f->place[0], f->place[1], p);
}

/* The points within reach of a feature, and the nearest one to each. */
static struct vec3s gather_points(const struct vec3 *point, size_t points,
                                  const struct feature *feature, const struct vec3s *place,
                                  const struct sizes *which, double reach, struct sizes *owner)
{
    struct vec3s near = {0};
    struct kdtree *tree = kdtree_new(place->item, place->n);
    double tallest = 0;

    for (size_t k = 0; k < which->n; k++) {
        const struct feature *f = &feature[which->item[k]];
        tallest = fmax(tallest, vec_distance(f->place[0], f->place[1]));
    }
    for (size_t i = 0; i < points; i++) {
        size_t k;
        double distance2, far = reach + tallest / 2;
        kdtree_nearest(tree, point[i], 1, &k, &distance2);
        if (distance2 > far * far || off_feature(&feature[which->item[k]], point[i]) > reach)
            continue;
        *array_push(&near) = point[i];
        *array_push(owner) = k;
    }
    kdtree_free(tree);
    return near;
}

static void add_distances(const struct mesh *without, const struct mesh *with,
                          const struct vec3s *near, const struct sizes *owner, int threads,
                          struct sums *sum)
{
    double *before = mem_alloc(near->n, sizeof *before), *after = mem_alloc(near->n, sizeof *after);

    mesh_distance(without, near->item, near->n, threads, before);
    mesh_distance(with, near->item, near->n, threads, after);
    for (size_t i = 0; i < near->n; i++) {
        sum[owner->item[i]].without += before[i] * before[i];
        sum[owner->item[i]].with += after[i] * after[i];
        sum[owner->item[i]].points++;
    }
    free(before);
    free(after);
}

void feature_accept(const struct mesh *without, const struct mesh *with, const struct vec3 *point,
                    size_t points, double reach, double noise, int threads, struct feature *feature,
                    size_t n)
{
    struct sizes which = {0}, owner = {0}, about = {0};
    struct vec3s place = places_of(feature, n, &which);

    if (place.n > 0) {
        struct vec3s near = gather_points(point, points, feature, &place, &which, reach, &owner);
        struct sums *sum = mem_alloc(place.n, sizeof *sum);
        struct kdtree *tree = kdtree_new(place.item, place.n);
        add_distances(without, with, &near, &owner, threads, sum);
        for (size_t k = 0; k < place.n; k++) {
            struct sums all = {0, 0, 0};
            about.n = 0;
            kdtree_within(tree, place.item[k], 4 * reach, &about);
            for (size_t i = 0; i < about.n; i++) {
                all.without += sum[about.item[i]].without;
                all.with += sum[about.item[i]].with;
                all.points += sum[about.item[i]].points;
            }
            if (!is_better(&all, noise))
                feature[which.item[k]].kind = FEATURE_NONE;
        }
        kdtree_free(tree);
        free(sum);
        array_free(&near);
    }
    array_free(&place);
    array_free(&which);
    array_free(&owner);
    array_free(&about);
}
