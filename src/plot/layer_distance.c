/* layer_distance - see plot/plot.h. */
#include "plot/plot.h"

#include <stdlib.h>

#include "math/box_tree.h"
#include "base/parallel.h"

static const double FINE = 1e-3; /* of the extent of what is cut */

static void add_facet(struct facets *facets, struct vec3 a, struct vec3 b, struct vec3 c)
{
    *array_push(facets) = (struct facet){{a, b, c}};
}

static bool cuts(const struct stroke *stroke)
{
    return stroke->kind != STROKE_RAPID && stroke->kind != STROKE_POLES;
}

static struct facets facets_of(const struct layer *layer)
{
    struct facets facets = {0};
    const struct vec3 *v = layer->mesh.vertex.item, *node = layer->node.item;
    for (size_t i = 0; i < layer->point.n; i++)
        add_facet(&facets, layer->point.item[i], layer->point.item[i], layer->point.item[i]);
    for (size_t i = 0; i < layer->mesh.face.n; i++) {
        const struct face *f = &layer->mesh.face.item[i];
        add_facet(&facets, v[f->v[0]], v[f->v[1]], v[f->v[2]]);
    }
    for (size_t i = 0; i < layer->stroke.n; i++) {
        const struct stroke *s = &layer->stroke.item[i];
        for (size_t k = s->from + 1; k < s->to && cuts(s); k++)
            add_facet(&facets, node[k - 1], node[k], node[k]);
    }
    return facets;
}

static struct vec3s places_of(const struct layer *layer)
{
    struct vec3s places = {0};
    struct box box = layer_box(layer, 0);
    double fine = FINE * box_diagonal(&box);
    for (size_t i = 0; i < layer->point.n; i++)
        *array_push(&places) = layer->point.item[i];
    for (size_t i = 0; i < layer->mesh.vertex.n; i++)
        *array_push(&places) = layer->mesh.vertex.item[i];
    for (size_t i = 0; i < layer->stroke.n; i++) {
        const struct stroke *s = &layer->stroke.item[i];
        for (size_t k = s->from; k < s->to && cuts(s); k++) {
            struct vec3 to = layer->node.item[k], from = k > s->from ? layer->node.item[k - 1] : to;
            double steps = fine > 0 ? ceil(vec_distance(from, to) / fine) : 1;
            for (size_t step = 1; (double)step < steps; step++)
                *array_push(&places) = vec_mix(from, to, (double)step / steps);
            *array_push(&places) = to;
        }
    }
    return places;
}

struct search {
    const struct facets *facets;
    const struct box_tree *tree;
    const struct vec3s *places;
    double *distance;
};

static void measure(void *context, size_t from, size_t to)
{
    struct search *s = context;
    for (size_t i = from; i < to; i++)
        s->distance[i] = facets_distance(s->tree, s->facets, s->places->item[i]);
}

struct layer_distance layer_distance_of(const struct layer *from, const struct layer *to,
                                        int threads)
{
    struct layer_distance d = {0};
    struct facets facets = facets_of(to);
    struct vec3s places = places_of(from);
    if (facets.n > 0 && places.n > 0) {
        struct box_tree *tree = facets_tree(&facets);
        struct search s = {&facets, tree, &places, mem_alloc(places.n, sizeof(double))};
        parallel_for(threads, places.n, measure, &s);
        double sum = 0;
        for (size_t i = 0; i < places.n; i++) {
            sum += s.distance[i] * s.distance[i];
            if (i == 0 || s.distance[i] > d.worst) {
                d.worst = s.distance[i];
                d.at = places.item[i];
            }
        }
        d.n = places.n;
        d.rms = sqrt(sum / (double)d.n);
        doubles_sort(s.distance, d.n);
        d.most95 = s.distance[(d.n - 1) * 95 / 100];
        free(s.distance);
        box_tree_free(tree);
    }
    array_free(&places);
    array_free(&facets);
    return d;
}
