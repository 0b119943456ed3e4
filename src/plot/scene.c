/* scene - see scene.h. */
#include "plot/scene.h"

#include <stdlib.h>
#include <string.h>

#include "pane.h"

void layer_free(struct layer *layer)
{
    array_free(&layer->point);
    mesh_free(&layer->mesh);
    array_free(&layer->node);
    array_free(&layer->stroke);
    array_free(&layer->joint);
    array_free(&layer->normal);
    array_free(&layer->axis);
    memset(layer, 0, sizeof *layer);
}

void scene_free(struct scene *scene)
{
    for (size_t i = 0; i < scene->n; i++)
        layer_free(&scene->item[i]);
    array_free(&scene->mark);
    array_free(scene);
}

static void add_points(struct box *box, const struct view *view, const struct vec3s *points)
{
    for (size_t i = 0; i < points->n; i++)
        box_add(box, view_point(view, points->item[i]));
}

static void add_ticks(struct box *box, const struct view *view, const struct ticks *ticks,
                      double length)
{
    for (size_t i = 0; i < ticks->n; i++) {
        const struct tick *t = &ticks->item[i];
        box_add(box, view_point(view, vec_along(t->from, length, t->direction)));
    }
}

static void add_strokes(struct box *box, const struct view *view, const struct layer *layer,
                        bool rapid)
{
    for (size_t i = 0; i < layer->stroke.n; i++) {
        const struct stroke *s = &layer->stroke.item[i];
        for (size_t k = s->from; k < s->to && (s->kind == STROKE_RAPID) == rapid; k++)
            box_add(box, view_point(view, layer->node.item[k]));
    }
}

static struct box box_in(const struct layer *layer, const struct view *view, double tick)
{
    struct box box = box_empty();
    add_points(&box, view, &layer->point);
    add_points(&box, view, &layer->mesh.vertex);
    add_strokes(&box, view, layer, false);
    add_ticks(&box, view, &layer->normal, tick);
    add_ticks(&box, view, &layer->axis, tick);
    if (box.low.x > box.high.x)
        add_strokes(&box, view, layer, true);
    return box;
}

struct box layer_box(const struct layer *layer, double tick)
{
    struct view plan = view_from(VIEW_PLAN);
    return box_in(layer, &plan, tick);
}

/* The part of `want` that is not much larger than `box`. */
static struct box some_of(struct box box, const struct box *want)
{
    double most = 0.07 * box_diagonal(&box);
    struct vec3 room = vec(most, most, 0);
    struct box part = {vec_sub(box.low, room), vec_add(box.high, room)};
    part.low = vec(fmax(part.low.x, want->low.x), fmax(part.low.y, want->low.y), 0);
    part.high = vec(fmin(part.high.x, want->high.x), fmin(part.high.y, want->high.y), 0);
    if (part.low.x <= part.high.x && part.low.y <= part.high.y)
        box_join(&box, &part);
    return box;
}

struct box scene_box(const struct scene *scene, const struct view *view, double tick)
{
    struct box box = box_empty(), rapid = box_empty();
    for (size_t i = 0; i < scene->n; i++) {
        struct box one = box_in(&scene->item[i], view, tick);
        box_join(&box, &one);
        add_strokes(&rapid, view, &scene->item[i], true);
    }
    return some_of(box, &rapid);
}
