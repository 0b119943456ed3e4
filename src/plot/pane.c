/* pane - see pane.h. */
#include "pane.h"

#include <stdio.h>
#include <stdlib.h>

#include "decimate.h"
#include "palette.h"

static const double COARSEST = 4; /* px: a chain is never drawn off its places by more */

/* A projected point on the picture, px; its z stays, mm. */
static struct vec3 place_on_picture(const struct pane *pane, struct vec3 p)
{
    return vec(pane->x + (p.x - pane->box.low.x) * pane->scale,
               pane->y + (pane->box.high.y - p.y) * pane->scale, p.z);
}

/* ---- facets, with the light from the upper left
 *
 * What is partly hidden comes first, from the far to the near; what is not hidden anywhere lies
 * over it and not over its like, so that it is drawn shade by shade.  Facets that are more than can
 * be distinguished become cells of one shade. */

struct facet {
    struct vec3 p[3]; /* projected */
    double depth;
    size_t shade, layer, number;
    bool hidden; /* partly */
};

struct facets {
    size_t n, cap;
    struct facet *item;
};

static size_t shade_of(const struct vec3 p[3])
{
    struct vec3 n = vec_unit(vec_cross(vec_sub(p[1], p[0]), vec_sub(p[2], p[0])));
    if (n.z < 0)
        n = vec_scale(-1, n);
    struct vec3 light = vec_unit(vec(-1, 1.2, 1.6));
    double bright = fmax(0, (vec_dot(n, light) + 0.35) / 1.35); /* some light from all sides */
    return (size_t)floor(fmin(bright, 0.999) * PALETTE_SHADES);
}

static struct facet facet_of(const struct pane *pane, const struct mesh *mesh, size_t i)
{
    struct facet f = {.number = i};
    for (int k = 0; k < 3; k++)
        f.p[k] = view_point(&pane->view, mesh->vertex.item[mesh->face.item[i].v[k]]);
    f.depth = f.p[0].z + f.p[1].z + f.p[2].z;
    f.shade = shade_of(f.p);
    return f;
}

static void colour_of(const struct pane *pane, size_t layer, size_t shade, char ink[PALETTE_COLOUR])
{
    if (pane->options->by_layer)
        palette_tint(ink, layer, shade);
    else
        palette_shade(ink, shade);
}

static int by_depth(const void *a, const void *b)
{
    const struct facet *x = a, *y = b;
    if (x->depth < y->depth || x->depth > y->depth)
        return x->depth < y->depth ? -1 : 1;
    if (x->layer != y->layer)
        return x->layer < y->layer ? -1 : 1;
    return (x->number > y->number) - (x->number < y->number);
}

/* Which facets own a cell: they are seen. */
static bool *seen_facets(const struct pane *pane, size_t n)
{
    bool *seen = mem_alloc(n, sizeof *seen);
    for (size_t i = 0; i < pane->near.columns * pane->near.rows; i++)
        if (!isinf(pane->near.depth[i]) && pane->near.owner[i] < n)
            seen[pane->near.owner[i]] = true;
    return seen;
}

static void draw_facet(const struct pane *pane, const struct facet *f, struct svg *svg)
{
    for (int k = 0; k < 3; k++) {
        struct vec3 at = place_on_picture(pane, f->p[k]);
        if (k == 0)
            svg_move(svg, at.x, at.y);
        else
            svg_line(svg, at.x, at.y);
    }
    svg_close(svg);
}

static void begin_shade(const struct pane *pane, size_t layer, size_t shade, struct svg *svg)
{
    char fill[PALETTE_COLOUR], ink[40];
    colour_of(pane, layer, shade, fill);
    snprintf(ink, sizeof ink, "fill=\"%s\"", fill);
    svg_path(svg, ink);
}

/* One path for each row of facets of the same shade. */
static void draw_in_order(const struct pane *pane, const struct facets *facets, struct svg *svg)
{
    bool open = false;
    for (size_t i = 0; i < facets->n; i++) {
        const struct facet *f = &facets->item[i];
        bool same = i > 0 && f[-1].shade == f->shade && f[-1].layer == f->layer;
        if (!f->hidden)
            continue;
        if (!open || !same) {
            if (open)
                svg_path_end(svg);
            begin_shade(pane, f->layer, f->shade, svg);
            open = true;
        }
        draw_facet(pane, f, svg);
    }
    if (open)
        svg_path_end(svg);
}

static void draw_shade(const struct pane *pane, const struct facets *facets, size_t layer,
                       size_t shade, struct svg *svg)
{
    bool open = false;
    for (size_t i = 0; i < facets->n; i++) {
        const struct facet *f = &facets->item[i];
        if (f->hidden || f->layer != layer || f->shade != shade)
            continue;
        if (!open)
            begin_shade(pane, layer, shade, svg);
        open = true;
        draw_facet(pane, f, svg);
    }
    if (open)
        svg_path_end(svg);
}

static void draw_facets(const struct pane *pane, struct facets *facets, size_t layers, bool under,
                        struct svg *svg)
{
    double area = (pane->box.high.x - pane->box.low.x) * (pane->box.high.y - pane->box.low.y);
    double size = pane->scale * sqrt(area / (double)facets->n); /* of two facets, px */
    char ink[100];
    snprintf(ink, sizeof ink, "stroke=\"%s\" stroke-width=\"%s\" stroke-linejoin=\"round\"",
             under ? "#9BA8B5" : "#4A5866", size > 5 ? "4" : "1.5");
    svg_group(svg, ink);
    for (size_t i = 0; i < facets->n; i++) {
        struct facet *f = &facets->item[i];
        f->hidden = raster_hides(&pane->near, f->p[0], f->p[1], f->p[2], pane->near.cell);
    }
    if (facets->n > 0)
        qsort(facets->item, facets->n, sizeof *facets->item, by_depth);
    draw_in_order(pane, facets, svg);
    for (size_t layer = 0; layer < layers; layer++)
        for (size_t shade = 0; shade < PALETTE_SHADES; shade++)
            draw_shade(pane, facets, layer, shade, svg);
    svg_group_end(svg);
}

/* All facets of the scene that are seen, and the shade and layer of each facet. */
static struct facets collect_seen(const struct pane *pane, const struct scene *scene,
                                  const bool *seen)
{
    struct facets facets = {0};
    size_t number = 0;
    for (size_t layer = 0; layer < scene->n; layer++) {
        const struct mesh *mesh = &scene->item[layer].mesh;
        for (size_t i = 0; i < mesh->face.n; i++, number++) {
            if (!seen[number])
                continue;
            struct facet f = facet_of(pane, mesh, i);
            f.layer = layer;
            f.number = number;
            *array_push(&facets) = f;
        }
    }
    return facets;
}

/* The look_at of the middle of a cell: its shade and layer as one number, NONE where nothing is. */
static size_t look_at(const struct pane *pane, const size_t *look_of, double x, double y)
{
    size_t cell = raster_cell(&pane->near, x, y);
    return isinf(pane->near.depth[cell]) ? (size_t)-1 : look_of[pane->near.owner[cell]];
}

/* Runs of cells of one shade and layer, along a row. */
static void draw_row(const struct pane *pane, const size_t *look_of, size_t want, double cell,
                     double y, struct svg *svg)
{
    const struct box *b = &pane->box;
    double x = b->low.x + cell / 2;
    while (x < b->high.x) {
        if (look_at(pane, look_of, x, y) == want) {
            struct vec3 from = place_on_picture(pane, vec(x - cell / 2, y, 0));
            while (x < b->high.x && look_at(pane, look_of, x, y) == want)
                x += cell;
            struct vec3 to = place_on_picture(pane, vec(fmin(x - cell / 2, b->high.x), y, 0));
            svg_move(svg, from.x, from.y);
            svg_line(svg, to.x, to.y);
        }
        x += cell;
    }
}

static void draw_cells(const struct pane *pane, const struct facets *facets, size_t faces,
                       size_t layers, struct svg *svg)
{
    size_t *look_of = mem_alloc(faces, sizeof *look_of);
    for (size_t i = 0; i < facets->n; i++)
        look_of[facets->item[i].number] =
            facets->item[i].layer * PALETTE_SHADES + facets->item[i].shade;
    double cell = 1.5 / pane->scale; /* px */
    for (size_t want = 0; want < layers * PALETTE_SHADES; want++) {
        char fill[PALETTE_COLOUR], ink[120];
        colour_of(pane, want / PALETTE_SHADES, want % PALETTE_SHADES, fill);
        snprintf(ink, sizeof ink,
                 "fill=\"none\" stroke=\"%s\" stroke-width=\"17\" "
                 "shape-rendering=\"crispEdges\"",
                 fill);
        svg_path(svg, ink);
        double y = pane->box.high.y - cell / 2;
        while (y > pane->box.low.y) {
            draw_row(pane, look_of, want, cell, y, svg);
            y -= cell;
        }
        svg_path_end(svg);
    }
    free(look_of);
}

static void draw_scene_facets(struct pane *pane, const struct scene *scene, struct svg *svg)
{
    size_t faces = 0;
    bool under = false; /* a path: its strokes are to stand out */
    for (size_t i = 0; i < scene->n; i++) {
        faces += scene->item[i].mesh.face.n;
        under |= scene->item[i].stroke.n > 0;
    }
    if (faces == 0)
        return;
    bool *seen = seen_facets(pane, faces);
    struct facets facets = collect_seen(pane, scene, seen);
    if (facets.n <= pane->options->marks)
        draw_facets(pane, &facets, scene->n, under, svg);
    else
        draw_cells(pane, &facets, faces, scene->n, svg);
    array_free(&facets);
    free(seen);
}

/* ---- clouds, joints, normals and axes */

static double off_middle(const struct raster *r, struct vec3 p)
{
    double x = (p.x - r->left) / r->cell, y = (p.y - r->bottom) / r->cell;
    return hypot(x - floor(x) - 0.5, y - floor(y) - 0.5);
}

/* The points that are not hidden, one in each cell: the nearest to its middle, so that they stand
 * evenly. */
static struct raster occupied_cells(const struct pane *pane, const struct vec3s *point, double cell,
                                    size_t *marks)
{
    const struct box *b = &pane->box;
    struct raster r = raster_new(b->low.x, b->low.y, b->high.x, b->high.y, cell);
    *marks = 0;
    for (size_t i = 0; i < point->n; i++) {
        struct vec3 p = view_point(&pane->view, point->item[i]);
        if (raster_visible(&pane->near, p, pane->slack))
            *marks += raster_point(&r, vec(p.x, p.y, -off_middle(&r, p)), i);
    }
    return r;
}

static size_t level_of(const struct pane_options *options, struct vec3 p)
{
    double range = options->high.z - options->low.z;
    double s = range > 0 ? (p.z - options->low.z) / range : 0;
    return (size_t)fmin(floor(s * PALETTE_HEIGHTS), PALETTE_HEIGHTS - 1);
}

static void draw_points(const struct pane *pane, const struct layer *layer, size_t number,
                        double least, struct svg *svg)
{
    const struct pane_options *options = pane->options;
    size_t marks, limit = options->marks;
    double cell = least;
    struct raster r = occupied_cells(pane, &layer->point, cell, &marks);
    while (marks > limit) {
        raster_free(&r);
        cell *= fmax(1.05, 0.95 * sqrt((double)marks / (double)limit));
        r = occupied_cells(pane, &layer->point, cell, &marks);
    }
    double area = (pane->box.high.x - pane->box.low.x) * (pane->box.high.y - pane->box.low.y);
    double apart = sqrt(area / (double)(marks ? marks : 1)) * pane->scale;
    double width = fmin(fmax(0.75 * apart, 0.9), fmin(2 + 0.08 * apart, 5));
    for (size_t level = 0; level < (options->by_layer ? 1 : PALETTE_HEIGHTS); level++) {
        char ink[80];
        snprintf(ink, sizeof ink, "stroke=\"%s\" stroke-width=\"%.0f\"",
                 options->by_layer ? palette_cycle(number) : palette_height(level), 10 * width);
        svg_path(svg, ink);
        for (size_t i = 0; i < r.rows * r.columns; i++) {
            struct vec3 p = layer->point.item[r.owner[i]];
            if (isinf(r.depth[i]) || (!options->by_layer && level_of(options, p) != level))
                continue;
            struct vec3 at = place_on_picture(pane, view_point(&pane->view, p));
            svg_dot(svg, at.x, at.y);
        }
        svg_path_end(svg);
    }
    raster_free(&r);
}

static void draw_scene_points(struct pane *pane, const struct scene *scene, struct svg *svg)
{
    for (size_t i = 0; i < scene->n; i++) {
        const struct layer *layer = &scene->item[i];
        if (layer->point.n == 0)
            continue;
        svg_group(svg, "fill=\"none\" stroke-linecap=\"round\"");
        draw_points(pane, layer, i, 0.8 / pane->scale, svg);
        svg_group_end(svg);
    }
}

/* As many as can be distinguished, this far from one another, px. */
static void draw_ticks(const struct pane *pane, const struct ticks *ticks, double apart,
                       const char *ink, struct svg *svg)
{
    const struct box *b = &pane->box;
    struct raster r = raster_new(b->low.x, b->low.y, b->high.x, b->high.y, apart / pane->scale);
    svg_path(svg, ink);
    for (size_t i = 0; i < ticks->n; i++) {
        const struct tick *t = &ticks->item[i];
        struct vec3 p = view_point(&pane->view, t->from);
        struct vec3 q =
            view_point(&pane->view, vec_along(t->from, pane->options->tick, t->direction));
        if (!raster_visible(&pane->near, p, pane->slack) || !raster_point(&r, p, i))
            continue;
        struct vec3 from = place_on_picture(pane, p), to = place_on_picture(pane, q);
        svg_dot(svg, from.x, from.y);
        svg_line(svg, to.x, to.y);
    }
    svg_path_end(svg);
    raster_free(&r);
}

/* Dots at points that stand on strokes, as many as can be distinguished. */
static void draw_dots(const struct pane *pane, const struct vec3s *joint, const char *ink,
                      struct svg *svg)
{
    size_t marks;
    struct raster r = occupied_cells(pane, joint, 1.2 / pane->scale, &marks);
    svg_path(svg, ink);
    for (size_t i = 0; i < r.rows * r.columns; i++) {
        if (isinf(r.depth[i]))
            continue;
        struct vec3 at = place_on_picture(pane, view_point(&pane->view, joint->item[r.owner[i]]));
        svg_dot(svg, at.x, at.y);
    }
    svg_path_end(svg);
    raster_free(&r);
}

static void draw_poles(const struct pane *pane, const struct layer *layer, struct svg *svg)
{
    struct vec3s pole = {0};
    for (size_t i = 0; i < layer->stroke.n; i++) {
        const struct stroke *s = &layer->stroke.item[i];
        for (size_t k = s->from; s->kind == STROKE_POLES && k < s->to; k++)
            *array_push(&pole) = layer->node.item[k];
    }
    if (pole.n)
        draw_dots(pane, &pole, "stroke=\"#CC79A7\" stroke-width=\"45\"", svg);
    array_free(&pole);
}

static void draw_scene_ticks(struct pane *pane, const struct scene *scene, struct svg *svg)
{
    svg_group(svg, "fill=\"none\" stroke-linecap=\"round\"");
    for (size_t i = 0; i < scene->n; i++) {
        const struct layer *layer = &scene->item[i];
        if (pane->options->joints && layer->joint.n)
            draw_dots(pane, &layer->joint, "stroke=\"#222\" stroke-width=\"20\"", svg);
        draw_poles(pane, layer, svg);
        if (layer->normal.n)
            draw_ticks(pane, &layer->normal, 8, "stroke=\"#009E73\" stroke-width=\"9\"", svg);
        if (layer->axis.n)
            draw_ticks(pane, &layer->axis, 8, "stroke=\"#444444\" stroke-width=\"8\"", svg);
    }
    svg_group_end(svg);
}

/* ---- the motions of a path */

/* How finely they are drawn; none is left out. */
struct grain {
    double tolerance; /* px */
};

void pane_ink(const struct pane_options *options, size_t layer, const struct stroke *stroke,
              char ink[PANE_INK])
{
    static const char *const colour[STROKES][2] = {
        [STROKE_LINE] = {"#D55E00", "#D55E00"},   [STROKE_ARC] = {"#0072B2", "#56B4E9"},
        [STROKE_SPLINE] = {"#009E73", "#004D40"}, [STROKE_RAPID] = {"#999999", "#999999"},
        [STROKE_POLES] = {"#CC79A7", "#CC79A7"},
    };
    static const int width[STROKES] = {12, 15, 15, 9, 7};
    const char *by_kind = colour[stroke->kind][stroke->number % 2];
    bool moves = stroke->kind != STROKE_RAPID && stroke->kind != STROKE_POLES;
    const char *used = options->by_layer && moves ? (layer == 0 ? "#8FC9EE" : palette_cycle(layer))
                       : options->by_speed && moves ? palette_height((size_t)stroke->speed)
                       : options->by_pass && moves  ? palette_cycle(stroke->pass)
                                                    : by_kind;
    int w = options->by_layer && moves ? (layer == 0 ? 44 : 11) : width[stroke->kind];
    snprintf(ink, PANE_INK, "stroke=\"%s\" stroke-width=\"%d\"%s", used, w,
             stroke->kind == STROKE_RAPID ? " stroke-dasharray=\"50 35\"" : "");
}

/* Appends a chain that is seen, with few points, to `out`; or counts them when there is no svg. */
static size_t draw_chain(struct vec3s *chain, const struct grain *grain, struct svg *svg)
{
    struct vec3s few = {0};
    decimate_chain(chain->item, chain->n, grain->tolerance, &few);
    for (size_t i = 0; svg && i < few.n; i++) {
        if (i == 0)
            svg_move(svg, few.item[i].x, few.item[i].y);
        else
            svg_line(svg, few.item[i].x, few.item[i].y);
    }
    size_t n = few.n;
    array_free(&few);
    chain->n = 0;
    return n;
}

/* Rapid moves may leave the picture. */
static bool is_inside(const struct box *box, struct vec3 p)
{
    const double slack = 1e-9;
    return p.x >= box->low.x - slack && p.x <= box->high.x + slack && p.y >= box->low.y - slack &&
           p.y <= box->high.y + slack;
}

/* One stroke: cut where something hides it, looked at every 2 px. */
static size_t draw_stroke(const struct pane *pane, const struct layer *layer,
                          const struct stroke *stroke, const struct grain *grain,
                          struct vec3s *chain, struct svg *svg)
{
    size_t marks = 0;
    struct vec3 last = vec(0, 0, 0);
    for (size_t i = stroke->from; i < stroke->to; i++) {
        struct vec3 p = view_point(&pane->view, layer->node.item[i]);
        double apart = i > stroke->from ? hypot(p.x - last.x, p.y - last.y) * pane->scale : 0;
        bool hidden = pane->hides || stroke->kind == STROKE_RAPID;
        int steps = hidden ? (int)fmin(fmax(1, ceil(apart / 2)), 2000) : 1;
        for (int k = i > stroke->from ? 1 : steps; k <= steps; k++) {
            struct vec3 q = i > stroke->from ? vec_mix(last, p, (double)k / steps) : p;
            if (is_inside(&pane->box, q) && raster_visible(&pane->near, q, pane->slack))
                *array_push(chain) = place_on_picture(pane, q);
            else if (chain->n)
                marks += draw_chain(chain, grain, svg);
        }
        last = p;
    }
    return chain->n ? marks + draw_chain(chain, grain, svg) : marks;
}

/* A style: strokes of one look make one path. */
static size_t look_of_stroke(const struct pane_options *options, const struct stroke *s)
{
    size_t variant = options->by_speed  ? (size_t)s->speed
                     : options->by_pass ? s->pass % PALETTE_CYCLE
                                        : s->number % 2;
    return (size_t)s->kind * STROKE_SPEEDS + variant;
}

static size_t draw_look(const struct pane *pane, const struct scene *scene, size_t number,
                        size_t want, const struct grain *grain, struct svg *svg)
{
    const struct layer *layer = &scene->item[number];
    struct vec3s chain = {0};
    size_t marks = 0;
    bool open = false;
    for (size_t i = 0; i < layer->stroke.n; i++) {
        const struct stroke *stroke = &layer->stroke.item[i];
        if (look_of_stroke(pane->options, stroke) != want)
            continue;
        if (svg && !open) {
            char ink[PANE_INK];
            pane_ink(pane->options, number, stroke, ink);
            svg_path(svg, ink);
            open = true;
        }
        marks += draw_stroke(pane, layer, stroke, grain, &chain, svg);
    }
    if (open)
        svg_path_end(svg);
    array_free(&chain);
    return marks;
}

/* All of them, the rapid moves first, for the others lie over them. */
static size_t draw_strokes(const struct pane *pane, const struct scene *scene,
                           const struct grain *grain, struct svg *svg)
{
    static const enum stroke_kind order[] = {STROKE_RAPID, STROKE_POLES, STROKE_LINE, STROKE_ARC,
                                             STROKE_SPLINE};
    size_t marks = 0;
    for (size_t layer = 0; layer < scene->n; layer++)
        for (size_t k = 0; k < sizeof order / sizeof *order; k++)
            for (size_t i = 0; i < STROKE_SPEEDS; i++)
                marks +=
                    draw_look(pane, scene, layer, (size_t)order[k] * STROKE_SPEEDS + i, grain, svg);
    return marks;
}

static void draw_scene_strokes(struct pane *pane, const struct scene *scene, struct svg *svg)
{
    struct grain grain = {.tolerance = 0.1};
    size_t strokes = 0;
    for (size_t i = 0; i < scene->n; i++)
        strokes += scene->item[i].stroke.n;
    if (strokes == 0)
        return;
    while (draw_strokes(pane, scene, &grain, NULL) > 2 * pane->options->marks &&
           grain.tolerance < COARSEST)
        grain.tolerance *= 2;
    svg_group(svg, "fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\"");
    draw_strokes(pane, scene, &grain, svg);
    svg_group_end(svg);
}

/* ---- what hides what, and the order of drawing */

static void hide_by_mesh(struct pane *pane, const struct mesh *mesh, size_t first)
{
    for (size_t i = 0; i < mesh->face.n; i++) {
        struct vec3 p[3];
        for (int k = 0; k < 3; k++)
            p[k] = view_point(&pane->view, mesh->vertex.item[mesh->face.item[i].v[k]]);
        raster_triangle(&pane->near, p[0], p[1], p[2], first + i);
    }
}

/* Points hide what is behind as discs that reach to their neighbours. */
static void hide_by_cloud(struct pane *pane, const struct vec3s *point)
{
    struct box box = box_empty();
    for (size_t i = 0; i < point->n; i++)
        box_add(&box, view_point(&pane->view, point->item[i]));
    double area = (box.high.x - box.low.x) * (box.high.y - box.low.y);
    double radius = fmax(1.2 * sqrt(area / (double)point->n), 0.6 * pane->near.cell);
    for (size_t i = 0; i < point->n; i++)
        raster_disc(&pane->near, view_point(&pane->view, point->item[i]), radius, 0);
    pane->slack = fmax(pane->slack, 4 * radius);
}

/* Eight-sided rings, over all else. */
static void draw_scene_marks(struct pane *pane, const struct scene *scene, struct svg *svg)
{
    enum { RADIUS = 8, SIDES = 8 };
    if (scene->mark.n == 0)
        return;
    svg_path(svg, "fill=\"none\" stroke=\"#d00000\" stroke-width=\"20\"");
    for (size_t i = 0; i < scene->mark.n; i++) {
        struct vec3 p = place_on_picture(pane, view_point(&pane->view, scene->mark.item[i]));
        for (int k = 0; k < SIDES; k++) {
            double x = p.x + RADIUS * cos(2 * PI * k / SIDES);
            double y = p.y + RADIUS * sin(2 * PI * k / SIDES);
            if (k == 0)
                svg_move(svg, x, y);
            else
                svg_line(svg, x, y);
        }
        svg_close(svg);
    }
    svg_path_end(svg);
}

void pane_draw(struct pane *pane, const struct scene *scene, struct svg *svg)
{
    const struct box *b = &pane->box;
    pane->near = raster_new(b->low.x, b->low.y, b->high.x, b->high.y, 0.5 / pane->scale);
    pane->slack = 3 / pane->scale;
    size_t first = 0;
    for (size_t i = 0; i < scene->n; i++) {
        const struct layer *layer = &scene->item[i];
        hide_by_mesh(pane, &layer->mesh, first);
        first += layer->mesh.face.n;
        pane->hides |= layer->mesh.face.n > 0 || layer->point.n > 0;
        if (layer->point.n && !pane->options->by_layer)
            hide_by_cloud(pane, &layer->point);
    }
    draw_scene_facets(pane, scene, svg);
    draw_scene_points(pane, scene, svg);
    draw_scene_strokes(pane, scene, svg);
    draw_scene_ticks(pane, scene, svg);
    draw_scene_marks(pane, scene, svg);
    raster_free(&pane->near);
}
