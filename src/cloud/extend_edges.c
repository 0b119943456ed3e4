/* extend_edges - see segment_steps.h. */
#include "segment_steps.h"

#include <stdlib.h>

#include "math/side_fit.h"
#include "math/kdtree.h"

enum { FEWEST = 40, MOST = 400 };

struct edges {
    const struct extend_edges *cloud;
    const struct kdtree *tree;
    double spacing, length;
    size_t near; /* points that the surface is continued from, before those of other sides go */
};

/* Which way the part ends at a point: square to its normal and to the edge.  False: no edge. */
static bool find_edge(const struct extend_edges *c, size_t i, struct vec3 *way)
{
    const int fewest = 2;
    const double sharp = 0.76604444311897804; /* cos 40 degrees */
    struct vec3 sum = vec(0, 0, 0), normal = c->normal[i];
    int count = 0;

    for (size_t k = 0; k < CLOUD_NEAR; k++) {
        size_t j = c->neighbour[i * CLOUD_NEAR + k];
        struct vec3 turn = vec_sub(c->normal[j], normal);
        if (c->in[j] || vec_dot(c->normal[j], normal) > sharp ||
            vec_dot(turn, vec_sub(c->point[j], c->point[i])) <= 0)
            continue;
        sum = vec_add(sum, vec_unit(vec_reject(c->normal[j], normal)));
        count++;
    }
    *way = vec_unit(sum);
    return count >= fewest && vec_length(*way) > 0;
}

/* The surface about a point, on its side of all edges. */
static bool fit_side(const struct edges *e, size_t i, struct side_fit *f)
{
    const double alike = 0.9; /* cosine of 26 degrees */
    const struct extend_edges *c = e->cloud;
    size_t index[MOST], n = kdtree_nearest(e->tree, c->point[i], e->near, index, NULL), own = 0;
    struct vec3 near[MOST];

    for (size_t k = 0; k < n; k++)
        if (c->in[index[k]] && vec_dot(c->normal[index[k]], c->normal[i]) > alike)
            near[own++] = c->point[index[k]];
    if (side_fit_plane(near, own, c->point[i], c->normal[i], f) < 0)
        return false;
    side_fit_bend(near, own, f);
    return true;
}

/* The places beyond the edge beside a point. */
static void extend_at(const struct edges *e, size_t i, struct vec3s *place)
{
    const double clear = 0.95 * e->length;
    const struct extend_edges *c = e->cloud;
    struct vec3 way;
    struct side_fit f;

    if (!c->in[i] || !find_edge(c, i, &way) || !fit_side(e, i, &f))
        return;
    for (double off = e->spacing; off < e->length + e->spacing / 2; off += e->spacing) {
        struct vec3 at = side_fit_point(&f, vec_along(c->point[i], off, way));
        struct vec3 centre = vec_along(at, e->length, side_fit_normal(&f, at));
        size_t nearest;
        double distance2 = HUGE_VAL;
        kdtree_nearest(e->tree, centre, 1, &nearest, &distance2);
        if (distance2 > clear * clear)
            *array_push(place) = at;
    }
}

/* Of places nearer to each other than most of the spacing the first. */
static void drop_close(const struct vec3s *place, double spacing, struct vec3s *to)
{
    const double apart = 0.75;
    struct kdtree *tree = kdtree_new(place->item, place->n);
    bool *gone = mem_alloc(place->n + 1, sizeof *gone);
    struct sizes near = {0};

    for (size_t i = 0; i < place->n; i++)
        gone[i] = false;
    for (size_t i = 0; i < place->n; i++) {
        if (gone[i])
            continue;
        *array_push(to) = place->item[i];
        near.n = 0;
        kdtree_within(tree, place->item[i], apart * spacing, &near);
        for (size_t k = 0; k < near.n; k++)
            gone[near.item[k]] = true;
    }
    array_free(&near);
    free(gone);
    kdtree_free(tree);
}

void extend_edges_find(const struct extend_edges *cloud, double spacing, double length,
                       struct vec3s *beyond)
{
    double wide = 1.5 * length / spacing;
    struct kdtree *tree = kdtree_new(cloud->point, cloud->n);
    size_t near = (size_t)fmin(fmax(PI * wide * wide, FEWEST), MOST);
    struct edges e = {cloud, tree, spacing, length, near};
    struct vec3s place = {0};

    for (size_t i = 0; i < cloud->n; i++)
        extend_at(&e, i, &place);
    if (place.n > 0)
        drop_close(&place, spacing, beyond);
    array_free(&place);
    kdtree_free(tree);
}
