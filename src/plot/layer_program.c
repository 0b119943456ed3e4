/* layer_program - an NC program as strokes, as the control runs it; see layer.h. */
#include <stdlib.h>

#include "machine/machine_options.h"
#include "plot/layer.h"
#include "ncread/ncread.h"
#include "stream.h"

enum { HALVINGS = 9 };

/* What is known on the way through the pieces. */
struct walk {
    const struct nc_motion *motion;
    const struct layer_options *options;
    struct layer *layer;
    double chord;
    size_t run; /* of pieces at feed, behind a rapid move */
    size_t drawn[STROKES];
};

static enum stroke_kind kind_of(const struct nc_piece *piece)
{
    if (piece->rapid)
        return STROKE_RAPID;
    switch (piece->shape) {
    case SHAPE_ARC:
        return STROKE_ARC;
    case SHAPE_POLYNOMIAL:
    case SHAPE_SPLINE:
        return STROKE_SPLINE;
    default:
        return STROKE_LINE;
    }
}

/* The stroke goes on: straight piece behind straight piece, span behind span of one spline. */
static bool goes_on(const struct nc_piece *was, const struct nc_piece *piece)
{
    enum stroke_kind kind = kind_of(piece);
    if (!was || kind_of(was) != kind || kind == STROKE_ARC)
        return false;
    return kind != STROKE_SPLINE || (was->shape == SHAPE_SPLINE && piece->shape == SHAPE_SPLINE &&
                                     was->index == piece->index);
}

static struct vec3 tip(const struct walk *w, const struct nc_piece *piece, double s)
{
    return nc_motion_at(w->motion, piece, s).p;
}

/* Nodes behind s0 up to s1, halved until the middle is no farther off than the chord error. */
static void bend(struct walk *w, const struct nc_piece *piece, double s0, struct vec3 from,
                 double s1, struct vec3 to, int halvings)
{
    double s = (s0 + s1) / 2;
    struct vec3 middle = tip(w, piece, s);
    if (halvings > 0 && vec_distance(middle, vec_mix(from, to, 0.5)) > w->chord) {
        bend(w, piece, s0, from, s, middle, halvings - 1);
        bend(w, piece, s, middle, s1, to, halvings - 1);
        return;
    }
    *array_push(&w->layer->node) = to;
    *(piece->rapid ? &w->layer->rapid : &w->layer->cut) += vec_distance(from, to);
}

static void add_piece(struct walk *w, const struct nc_piece *was, const struct nc_piece *piece)
{
    struct layer *layer = w->layer;
    enum stroke_kind kind = kind_of(piece);
    if (!piece->rapid && (!was || was->rapid))
        w->run++;
    if (piece->rapid && w->options->cut)
        return;
    if (!goes_on(was, piece)) {
        *array_push(&layer->stroke) =
            (struct stroke){kind, layer->node.n, layer->node.n, w->run, w->drawn[kind]++};
        *array_push(&layer->node) = tip(w, piece, 0);
        if (kind != STROKE_SPLINE)
            layer->motions[kind]++;
    } else if (kind != STROKE_SPLINE) {
        layer->motions[kind]++;
    }
    bool straight = kind != STROKE_ARC && kind != STROKE_SPLINE && !piece->table;
    enum { PARTS = 4 }; /* so that an S is not taken for a straight line */
    struct vec3 from = tip(w, piece, 0);
    for (int i = straight ? PARTS : 1; i <= PARTS; i++) {
        struct vec3 to = tip(w, piece, (double)i / PARTS);
        bend(w, piece, straight ? 0 : (i - 1.0) / PARTS, from, (double)i / PARTS, to,
             straight ? 0 : HALVINGS);
        from = to;
    }
    layer->stroke.item[layer->stroke.n - 1].to = layer->node.n;
    if (!piece->rapid) {
        struct nc_motion_pose pose = nc_motion_at(w->motion, piece, 1);
        *array_push(&layer->joint) = pose.p;
        if (w->options->axes)
            *array_push(&layer->axis) = (struct tick){pose.p, pose.a};
    }
}

static double chord_of(const struct layer_options *options, const struct nc_motion *motion)
{
    struct box box = box_empty();
    for (size_t i = 0; i < motion->piece.n; i++)
        box_add(&box, nc_motion_at(motion, &motion->piece.item[i], 1).p);
    return layer_chord(options, &box);
}

static void add_poles(struct layer *layer, const struct nc_motion *motion)
{
    for (size_t i = 0; i < motion->spline.n; i++) {
        const struct nc_motion_spline *spline = &motion->spline.item[i];
        size_t from = layer->node.n;
        for (size_t k = 0; k < spline->n; k++)
            *array_push(&layer->node) = spline->p[k];
        *array_push(&layer->stroke) = (struct stroke){STROKE_POLES, from, layer->node.n, 0, i};
    }
}

static void add_course(const struct nc_motion *motion, const struct layer_options *options,
                       struct layer *layer)
{
    struct walk w = {
        .motion = motion, .options = options, .layer = layer, .chord = chord_of(options, motion)};
    for (size_t i = 0; i < motion->piece.n; i++)
        add_piece(&w, i ? &motion->piece.item[i - 1] : NULL, &motion->piece.item[i]);
    layer->passes = w.run > 1 ? w.run : 0;
    layer->motions[STROKE_SPLINE] = motion->curves;
    layer->motions[STROKE_POLES] = motion->poles;
    if (options->poles)
        add_poles(layer, motion);
}

int layer_program(const char *file, const struct layer_options *options, struct layer *layer,
                  struct error *error)
{
    const struct machine_options chosen = {.name = options->machine};
    struct machine machine;
    if (machine_options_read(&chosen, &machine, error) != 0)
        return -1;
    enum control_id control = ncread_tell(file, error);
    if (control == CONTROLS || stream_again(file, error) < 0)
        return -1;
    struct ncread_options run = {.dialect = ncread_of(control),
                                 .tcp = machine_has_tcp(&machine, control),
                                 .kinematics = ncread_kinematics(&machine)};
    struct nc_motion motion = {0};
    if (ncread_read(file, &run, &motion, error) < 0) {
        nc_motion_free(&motion);
        return -1;
    }
    add_course(&motion, options, layer);
    nc_motion_free(&motion);
    return 0;
}
