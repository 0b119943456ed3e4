/* layer_path - a path as strokes; see layer.h. */
#include <stdlib.h>
#include <string.h>

#include "curve/flatten.h"
#include "plot/layer.h"

/* What is known on the way through the items. */
struct walk {
    const struct path *path;
    const struct layer_options *options;
    struct layer *layer;
    double chord;
    struct pose at;
    bool moved; /* `at` holds */
    size_t pass, drawn[STROKES];
};

static double chord_of(const struct layer_options *options, const struct path *path)
{
    struct box box = box_empty();
    for (size_t i = 0; i < path->item.n; i++)
        if (path->item.item[i].kind <= PATH_SPLINE)
            box_add(&box, path->item.item[i].to.p);
    return layer_chord(options, &box);
}

/* A stroke from here on: it goes on with the one before where both are straight. */
static struct stroke *begin(struct walk *w, enum stroke_kind kind)
{
    struct layer *layer = w->layer;
    struct stroke *last = layer->stroke.n ? &layer->stroke.item[layer->stroke.n - 1] : NULL;
    bool straight = kind == STROKE_LINE || kind == STROKE_RAPID;
    if (last && straight && last->kind == kind && last->pass == w->pass &&
        last->to == layer->node.n && !(vec_distance(layer->node.item[last->to - 1], w->at.p) > 0))
        return last;
    struct stroke *stroke = array_push(&layer->stroke);
    *stroke = (struct stroke){kind, layer->node.n, layer->node.n, w->pass, w->drawn[kind]++};
    if (kind != STROKE_POLES && kind != STROKE_SPLINE)
        *array_push(&layer->node) = w->at.p;
    return stroke;
}

static void end(struct walk *w, struct stroke *stroke)
{
    stroke->to = w->layer->node.n;
}

static void add_line(struct walk *w, const struct path_item *item)
{
    enum stroke_kind kind = item->rapid ? STROKE_RAPID : STROKE_LINE;
    if (item->rapid && w->options->cut)
        return;
    double length = vec_distance(w->at.p, item->to.p);
    struct stroke *stroke = begin(w, kind);
    *array_push(&w->layer->node) = item->to.p;
    end(w, stroke);
    w->layer->motions[kind]++;
    *(item->rapid ? &w->layer->rapid : &w->layer->cut) += length;
}

static void add_arc(struct walk *w, const struct path_item *item)
{
    const struct path_arc *arc = &w->path->arc.item[item->index];
    struct motion motion = motion_arc(w->at, item->to, arc->centre, arc->axis);
    double ratio = 1 - fmin(w->chord / arc->radius, 0.9);
    double pieces = fmax(1, ceil(motion.sweep / (2 * acos(ratio))));
    struct stroke *stroke = begin(w, STROKE_ARC);
    for (double i = 1; i <= pieces; i++)
        *array_push(&w->layer->node) = motion_at(&motion, i / pieces).p;
    end(w, stroke);
    w->layer->motions[STROKE_ARC]++;
    w->layer->cut += motion_length(&motion);
}

static void add_poles(struct walk *w, const struct bspline *curve)
{
    struct stroke *stroke = begin(w, STROKE_POLES);
    for (size_t i = 0; i < curve->poles; i++)
        *array_push(&w->layer->node) = curve->pole[i];
    end(w, stroke);
}

static int add_spline(struct walk *w, const struct path_item *item, struct error *error)
{
    const struct bspline *curve = &w->path->spline.item[item->index].curve;
    struct motion motion = motion_spline(w->at, item->to, curve);
    struct flat flat = {0};
    bool good = flatten(curve, 0, w->at.a, w->chord, &flat);
    if (good) {
        struct stroke *stroke = begin(w, STROKE_SPLINE);
        for (size_t i = 0; i < flat.point.n; i++)
            *array_push(&w->layer->node) = flat.point.item[i];
        end(w, stroke);
        w->layer->motions[STROKE_SPLINE]++;
        w->layer->motions[STROKE_POLES] += curve->poles;
        w->layer->cut += motion_length(&motion);
        if (w->options->poles)
            add_poles(w, curve);
    }
    flat_free(&flat);
    return good ? 0
                : error_at(error, w->path->name, item->line,
                           "a B-spline that cannot be drawn, expected one of finite poles");
}

static int add_motion(struct walk *w, const struct path_item *item, struct error *error)
{
    int status = 0;
    if (!w->moved && item->kind != PATH_SPLINE)
        w->at = item->to; /* where the tool comes from is not known */
    else if (item->kind == PATH_POINT)
        add_line(w, item);
    else if (item->kind == PATH_ARC)
        add_arc(w, item);
    else
        status = add_spline(w, item, error);
    if (!item->rapid) {
        *array_push(&w->layer->joint) = item->to.p;
        if (w->options->axes)
            *array_push(&w->layer->axis) = (struct tick){item->to.p, item->to.a};
    }
    if (w->options->normals && item->touches) {
        struct contact at = w->path->contact.item[item->contact];
        *array_push(&w->layer->normal) = (struct tick){at.p, at.n};
    }
    w->at = item->to;
    w->moved = true;
    return status;
}

int layer_path(const struct path *path, const struct layer_options *options, struct layer *layer,
               struct error *error)
{
    struct walk w = {
        .path = path, .options = options, .layer = layer, .chord = chord_of(options, path)};
    for (size_t i = 0; i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        if (item->kind == PATH_PASS) {
            w.pass = item->index;
            layer->passes++;
        } else if (item->kind <= PATH_SPLINE && add_motion(&w, item, error) < 0) {
            return -1;
        }
    }
    return 0;
}
