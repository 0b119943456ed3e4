/* layer - see plot.h. */
#include "plot/plot.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/array.h"
#include "curve/flatten.h"
#include "io/cloud/cloud.h"
#include "io/mesh/meshfile.h"
#include "io/path/path.h"
#include "machine/machine_options.h"
#include "ncread/ncread.h"
#include "stream.h"
#include "svg.h"

enum {
    SEEN = 5000, /* parts of the extent: less is not seen */
    HALVINGS = 9 /* of a part of a curve of a program, at most */
};

/* The chord error that can't be seen, or what the options say if that is less. */
static double visible_chord(const struct layer_options *options, const struct box *box)
{
    double seen = box_diagonal(box) / SEEN;
    return fmax(options->chord > 0 ? fmin(options->chord, seen) : seen, 1e-6);
}

/* ---- a path as strokes: arcs and B-splines in pieces that deviate from them by no more than the
 * chord error */

/* A walk through the items of a path. */
struct path_walk {
    const struct path *path;
    const struct layer_options *options;
    struct layer *layer;
    double chord;
    struct pose at;
    bool moved; /* `at` holds */
    size_t pass, drawn[STROKES];
};

static double path_chord(const struct layer_options *options, const struct path *path)
{
    struct box box = box_empty();
    for (size_t i = 0; i < path->item.n; i++)
        if (path->item.item[i].kind <= PATH_SPLINE)
            box_add(&box, path->item.item[i].to.p);
    return visible_chord(options, &box);
}

/* A stroke from here on: it goes on with the one before where both are straight. */
static struct stroke *begin_stroke(struct path_walk *w, enum stroke_kind kind)
{
    struct layer *layer = w->layer;
    struct stroke *last = layer->stroke.n ? &layer->stroke.item[layer->stroke.n - 1] : NULL;
    bool straight = kind == STROKE_LINE || kind == STROKE_RAPID;
    if (last && straight && last->kind == kind && last->pass == w->pass &&
        last->to == layer->node.n && !(vec_distance(layer->node.item[last->to - 1], w->at.p) > 0))
        return last;
    struct stroke *stroke = array_push(&layer->stroke);
    *stroke = (struct stroke){kind, layer->node.n, layer->node.n, w->pass, w->drawn[kind]++, 0};
    if (kind != STROKE_POLES && kind != STROKE_SPLINE)
        *array_push(&layer->node) = w->at.p;
    return stroke;
}

static void end_stroke(struct path_walk *w, struct stroke *stroke)
{
    stroke->to = w->layer->node.n;
}

static void add_line(struct path_walk *w, const struct path_item *item)
{
    enum stroke_kind kind = item->rapid ? STROKE_RAPID : STROKE_LINE;
    if (item->rapid && w->options->cut)
        return;
    double length = vec_distance(w->at.p, item->to.p);
    struct stroke *stroke = begin_stroke(w, kind);
    *array_push(&w->layer->node) = item->to.p;
    end_stroke(w, stroke);
    w->layer->motions[kind]++;
    *(item->rapid ? &w->layer->rapid : &w->layer->cut) += length;
}

static void add_arc(struct path_walk *w, const struct path_item *item)
{
    const struct path_arc *arc = &w->path->arc.item[item->index];
    struct motion motion = motion_arc(w->at, item->to, arc->centre, arc->axis);
    double ratio = 1 - fmin(w->chord / arc->radius, 0.9);
    size_t pieces = (size_t)fmax(1, ceil(motion.sweep / (2 * acos(ratio))));
    struct stroke *stroke = begin_stroke(w, STROKE_ARC);
    for (size_t i = 1; i <= pieces; i++)
        *array_push(&w->layer->node) = motion_at(&motion, (double)i / (double)pieces).p;
    end_stroke(w, stroke);
    w->layer->motions[STROKE_ARC]++;
    w->layer->cut += motion_length(&motion);
}

static void add_path_poles(struct path_walk *w, const struct bspline *curve)
{
    struct stroke *stroke = begin_stroke(w, STROKE_POLES);
    for (size_t i = 0; i < curve->poles; i++)
        *array_push(&w->layer->node) = curve->pole[i];
    end_stroke(w, stroke);
}

static int add_spline(struct path_walk *w, const struct path_item *item, struct error *error)
{
    const struct bspline *curve = &w->path->spline.item[item->index].curve;
    struct motion motion = motion_spline(w->at, item->to, curve);
    struct flat flat = {0};
    bool good = flatten(curve, 0, w->at.a, w->chord, &flat);
    if (good) {
        struct stroke *stroke = begin_stroke(w, STROKE_SPLINE);
        for (size_t i = 0; i < flat.point.n; i++)
            *array_push(&w->layer->node) = flat.point.item[i];
        end_stroke(w, stroke);
        w->layer->motions[STROKE_SPLINE]++;
        w->layer->motions[STROKE_POLES] += curve->poles;
        w->layer->cut += motion_length(&motion);
        if (w->options->poles)
            add_path_poles(w, curve);
    }
    flat_free(&flat);
    return good ? 0
                : error_at(error, w->path->name, item->line,
                           "a B-spline that cannot be drawn, expected one of finite poles");
}

static int add_motion(struct path_walk *w, const struct path_item *item, struct error *error)
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

static int add_path(const struct path *path, const struct layer_options *options,
                    struct layer *layer, struct error *error)
{
    struct path_walk w = {
        .path = path, .options = options, .layer = layer, .chord = path_chord(options, path)};
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

/* ---- a program as strokes, as its control and the machine run it: what it cuts between two rapid
 * moves is a pass */

/* A walk through the pieces of a program. */
struct program_walk {
    const struct nc_motion *motion;
    const struct layer_options *options;
    struct layer *layer;
    double chord;
    size_t run;               /* of pieces at feed, after a rapid move */
    struct machine_time time; /* no share: speeds are not wanted */
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

/* True if the piece goes on with the stroke: straight after straight, span after span of a spline.
 */
static bool joins_stroke(const struct nc_piece *was, const struct nc_piece *piece)
{
    enum stroke_kind kind = kind_of(piece);
    if (!was || kind_of(was) != kind || kind == STROKE_ARC)
        return false;
    return kind != STROKE_SPLINE || (was->shape == SHAPE_SPLINE && piece->shape == SHAPE_SPLINE &&
                                     was->index == piece->index);
}

static struct vec3 tip_at(const struct program_walk *w, const struct nc_piece *piece, double s)
{
    return nc_motion_at(w->motion, piece, s).p;
}

/* Nodes after s0 up to s1, halved until the middle is no farther off than the chord error. */
static void add_nodes(struct program_walk *w, const struct nc_piece *piece, double s0,
                      struct vec3 from, double s1, struct vec3 to, int halvings)
{
    double s = (s0 + s1) / 2;
    struct vec3 middle = tip_at(w, piece, s);
    if (halvings > 0 && vec_distance(middle, vec_mix(from, to, 0.5)) > w->chord) {
        add_nodes(w, piece, s0, from, s, middle, halvings - 1);
        add_nodes(w, piece, s, middle, s1, to, halvings - 1);
        return;
    }
    *array_push(&w->layer->node) = to;
    *(piece->rapid ? &w->layer->rapid : &w->layer->cut) += vec_distance(from, to);
}

/* The piece's speed, in as many steps as there are colours. */
static int speed_of(const struct program_walk *w, const struct nc_piece *piece)
{
    if (!w->time.share)
        return 0;
    double share = (double)w->time.share[piece - w->motion->piece.item];
    return (int)lround(fmax(0, fmin(1, share)) * (STROKE_SPEEDS - 1));
}

static void add_piece(struct program_walk *w, const struct nc_piece *was,
                      const struct nc_piece *piece)
{
    struct layer *layer = w->layer;
    enum stroke_kind kind = kind_of(piece);
    if (!piece->rapid && (!was || was->rapid))
        w->run++;
    if (piece->rapid && w->options->cut)
        return;
    int speed = speed_of(w, piece);
    if (!joins_stroke(was, piece) || speed != speed_of(w, was)) {
        *array_push(&layer->stroke) =
            (struct stroke){kind, layer->node.n, layer->node.n, w->run, w->drawn[kind]++, speed};
        *array_push(&layer->node) = tip_at(w, piece, 0);
        if (kind != STROKE_SPLINE)
            layer->motions[kind]++;
    } else if (kind != STROKE_SPLINE) {
        layer->motions[kind]++;
    }
    bool straight = kind != STROKE_ARC && kind != STROKE_SPLINE && !piece->table;
    enum { PARTS = 4 }; /* so that an S is not taken for a straight line */
    struct vec3 from = tip_at(w, piece, 0);
    for (int i = straight ? PARTS : 1; i <= PARTS; i++) {
        struct vec3 to = tip_at(w, piece, (double)i / PARTS);
        add_nodes(w, piece, straight ? 0 : (i - 1.0) / PARTS, from, (double)i / PARTS, to,
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

static double program_chord(const struct layer_options *options, const struct nc_motion *motion)
{
    struct box box = box_empty();
    for (size_t i = 0; i < motion->piece.n; i++)
        box_add(&box, nc_motion_at(motion, &motion->piece.item[i], 1).p);
    return visible_chord(options, &box);
}

static void add_program_poles(struct layer *layer, const struct nc_motion *motion)
{
    for (size_t i = 0; i < motion->spline.n; i++) {
        const struct nc_motion_spline *spline = &motion->spline.item[i];
        size_t from = layer->node.n;
        for (size_t k = 0; k < spline->n; k++)
            *array_push(&layer->node) = spline->p[k];
        *array_push(&layer->stroke) = (struct stroke){STROKE_POLES, from, layer->node.n, 0, i, 0};
    }
}

static struct machine_time program_time(const struct nc_motion *motion,
                                        const struct machine *machine, bool tcp)
{
    struct axis_limits limits = ncread_limits(machine, tcp);
    struct machine_time_options options = ncread_time_options(machine);
    options.limits = &limits;
    return options.acceleration[0] > 0 ? machine_time_of(motion, &options)
                                       : (struct machine_time){0};
}

static void add_program(const struct nc_motion *motion, const struct layer_options *options,
                        struct machine_time time, struct layer *layer)
{
    struct program_walk w = {.motion = motion,
                             .options = options,
                             .layer = layer,
                             .time = time,
                             .chord = program_chord(options, motion)};
    for (size_t i = 0; i < motion->piece.n; i++)
        add_piece(&w, i ? &motion->piece.item[i - 1] : NULL, &motion->piece.item[i]);
    layer->cuts = w.run > 1 ? w.run : 0;
    layer->motions[STROKE_SPLINE] = motion->curves;
    layer->motions[STROKE_POLES] = motion->poles;
    if (options->poles)
        add_program_poles(layer, motion);
}

static int run_program(const char *file, const struct layer_options *options, struct layer *layer,
                       struct error *error)
{
    struct machine_options chosen = {.name = options->machine};
    struct ncread_head head = {.post = -1, .axis = -1};
    const char *missing;
    struct machine machine;
    if (ncread_head_of(file, &head, error) < 0 || stream_again(file, error) < 0)
        return -1;
    if (!machine_options_adopt(&chosen, head.control_file, head.machine_file, &missing))
        snprintf(layer->told, sizeof layer->told,
                 "the program's head says %s, and there is no such file here (-m)", missing);
    else if (options->machine && *head.machine_file &&
             strcasecmp(options->machine, head.machine_file) != 0)
        snprintf(layer->told, sizeof layer->told,
                 "the program's head says the machine %s, it is drawn on %.60s (-m)",
                 head.machine_file, options->machine);
    if (machine_options_read(&chosen, &machine, error) != 0)
        return -1;
    enum control_id control = ncread_tell(file, error);
    if (control == CONTROLS || stream_again(file, error) < 0)
        return -1;
    struct ncread_options run = {.dialect = ncread_of(control),
                                 .tcp = machine_has_tcp(&machine, control),
                                 .kinematics = ncread_kinematics(&machine)};
    run.words = machine.text.words;
    run.cutcom = machine.cutcom;
    run.tool = machine.tool;
    run.tools = machine.tools;
    ncread_wraps(&machine, &run.kinematics, run.wraps);
    struct nc_motion motion = {0};
    if (ncread_read(file, &run, &motion, error) < 0) {
        struct error found = *error;
        if (*layer->told)
            error_set(error, "%s; %s", found.text, layer->told);
        nc_motion_free(&motion);
        return -1;
    }
    struct machine_time time = {0};
    if (options->speed)
        time = program_time(&motion, &machine, run.tcp);
    add_program(&motion, options, time, layer);
    layer->speeds = time.share != NULL;
    machine_time_free(&time);
    nc_motion_free(&motion);
    return 0;
}

/* ---- what a stream holds, and the figures of its title */

/* Adds ` NUMBER what` to the figures, after a comma where something stands there. */
static void note_count(struct layer *layer, size_t number, const char *one, const char *more)
{
    size_t at = strlen(layer->figures);
    char text[SVG_COUNT];
    svg_count(text, number);
    snprintf(layer->figures + at, sizeof layer->figures - at, "%s%s %s", at ? ", " : "", text,
             number == 1 ? one : more);
}

static void note_text(struct layer *layer, const char *text)
{
    size_t at = strlen(layer->figures);
    snprintf(layer->figures + at, sizeof layer->figures - at, "%s%s", at ? ", " : "", text);
}

/* A length in mm, or m when it is long. */
static void note_length(struct layer *layer, double mm, const char *what)
{
    char text[80];
    snprintf(text, sizeof text, mm < 1000 ? "%.1f mm %s" : "%.2f m %s", mm < 1000 ? mm : mm / 1000,
             what);
    note_text(layer, text);
}

static void note_box(struct layer *layer)
{
    struct box box = layer_box(layer, 0);
    struct vec3 size = vec_sub(box.high, box.low);
    char text[120];
    snprintf(text, sizeof text, "%.1f \u00d7 %.1f \u00d7 %.1f mm", size.x, size.y, size.z);
    note_text(layer, text);
}

static int read_cloud(const char *file, const struct layer_options *options, struct layer *layer,
                      struct error *error)
{
    struct cloud_count count;
    if (cloud_read(file, 1, &layer->point, &count, error) < 0)
        return -1;
    for (size_t i = 0; i < layer->point.n; i++)
        layer->point.item[i] = vec_scale(options->unit, layer->point.item[i]);
    note_count(layer, layer->point.n, "point", "points");
    note_box(layer);
    return 0;
}

static size_t rows_of(const struct mesh *mesh)
{
    int last = -1;
    for (size_t i = 0; i < mesh->row.n; i++)
        if (mesh->row.item[i] > last)
            last = mesh->row.item[i];
    return (size_t)last + 1;
}

static int read_mesh(const char *file, const struct layer_options *options, struct layer *layer,
                     struct error *error)
{
    struct mesh *mesh = &layer->mesh;
    if (mesh_read(file, mesh, error) < 0)
        return -1;
    if (options->normals && mesh->normal.n == 0)
        mesh_normals_facet(mesh);
    for (size_t i = 0; options->normals && i < mesh->vertex.n; i++)
        *array_push(&layer->normal) = (struct tick){mesh->vertex.item[i], mesh->normal.item[i]};
    note_count(layer, mesh->vertex.n, "vertex", "vertices");
    note_count(layer, mesh->face.n, "facet", "facets");
    if (mesh->row.n)
        note_count(layer, rows_of(mesh), "row", "rows");
    if (mesh->origin.spacing > 0) {
        char text[60];
        snprintf(text, sizeof text, "grid of %g mm", mesh->origin.spacing);
        note_text(layer, text);
    }
    note_box(layer);
    return 0;
}

static void note_motions(struct layer *layer)
{
    if (layer->passes)
        note_count(layer, layer->passes, "pass", "passes");
    if (layer->cuts)
        note_count(layer, layer->cuts, "cut", "cuts");
    if (layer->motions[STROKE_LINE])
        note_count(layer, layer->motions[STROKE_LINE], "line", "lines");
    if (layer->motions[STROKE_ARC])
        note_count(layer, layer->motions[STROKE_ARC], "arc", "arcs");
    if (layer->motions[STROKE_SPLINE]) {
        note_count(layer, layer->motions[STROKE_SPLINE], "B-spline", "B-splines");
        size_t at = strlen(layer->figures);
        char text[SVG_COUNT];
        svg_count(text, layer->motions[STROKE_POLES]);
        if (layer->motions[STROKE_POLES])
            snprintf(layer->figures + at, sizeof layer->figures - at, " of %s control points",
                     text);
    }
    note_length(layer, layer->cut, "of cut");
}

static int read_path(const char *file, const struct layer_options *options, struct layer *layer,
                     struct error *error)
{
    struct path path = {0};
    if (path_read(file, &path, error) < 0)
        return -1;
    int status = add_path(&path, options, layer, error);
    path_free(&path);
    note_motions(layer);
    return status;
}

static int read_program(const char *file, const struct layer_options *options, struct layer *layer,
                        struct error *error)
{
    int status = run_program(file, options, layer, error);
    note_motions(layer);
    return status;
}

int layer_read(const char *file, const struct layer_options *options, struct layer *layer,
               struct error *error)
{
    enum stream_kind kind;
    const char *name;
    memset(layer, 0, sizeof *layer);
    if (stream_find(file, &kind, &name, error) < 0)
        return -1;
    layer->name = name;
    switch (kind) {
    case STREAM_MESH:
        return read_mesh(name, options, layer, error);
    case STREAM_PATH:
        return read_path(name, options, layer, error);
    case STREAM_PROGRAM:
        return read_program(name, options, layer, error);
    default:
        return read_cloud(name, options, layer, error);
    }
}
