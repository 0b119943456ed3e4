/* pane_strokes - the motions of a path; see pane.h. */
#include <stdio.h>
#include <stdlib.h>

#include "palette.h"
#include "plot/pane.h"
#include "decimate.h"

enum { PASSES = 160 }; /* more in a view would run together */

/* How finely they are drawn. */
struct grain {
    double tolerance; /* px */
    size_t every;     /* of the passes */
};

void pane_ink(const struct pane_options *style, size_t layer, const struct stroke *stroke,
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
    const char *used = style->by_layer && moves  ? (layer == 0 ? "#8FC9EE" : palette_cycle(layer))
                       : style->by_pass && moves ? palette_cycle(stroke->pass)
                                                 : by_kind;
    int w = style->by_layer && moves ? (layer == 0 ? 44 : 11) : width[stroke->kind];
    snprintf(ink, PANE_INK, "stroke=\"%s\" stroke-width=\"%d\"%s", used, w,
             stroke->kind == STROKE_RAPID ? " stroke-dasharray=\"50 35\"" : "");
}

static bool drawn(const struct stroke *stroke, const struct grain *grain)
{
    return stroke->pass % grain->every == (grain->every > 1 ? 1 : 0);
}

/* Appends a chain that is seen, with few points, to `out`; or counts them when there is no svg. */
static size_t put(struct vec3s *chain, const struct grain *grain, struct svg *svg)
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
static bool inside(const struct box *box, struct vec3 p)
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
        double steps =
            pane->hides || stroke->kind == STROKE_RAPID ? fmin(fmax(1, ceil(apart / 2)), 2000) : 1;
        for (double k = i > stroke->from ? 1 : steps; k <= steps; k++) {
            struct vec3 q = i > stroke->from ? vec_mix(last, p, k / steps) : p;
            if (inside(&pane->box, q) && raster_visible(&pane->near, q, pane->slack))
                *array_push(chain) = pane_place(pane, q);
            else if (chain->n)
                marks += put(chain, grain, svg);
        }
        last = p;
    }
    return chain->n ? marks + put(chain, grain, svg) : marks;
}

/* A style: strokes of one look make one path. */
static size_t style_of(const struct pane_options *style, const struct stroke *s)
{
    size_t variant = style->by_pass ? s->pass % PALETTE_CYCLE : s->number % 2;
    return (size_t)s->kind * PALETTE_CYCLE + variant;
}

static size_t draw_style(const struct pane *pane, const struct scene *scene, size_t number,
                         size_t want, const struct grain *grain, struct svg *svg)
{
    const struct layer *layer = &scene->item[number];
    struct vec3s chain = {0};
    size_t marks = 0;
    bool open = false;
    for (size_t i = 0; i < layer->stroke.n; i++) {
        const struct stroke *stroke = &layer->stroke.item[i];
        if (style_of(pane->style, stroke) != want || !drawn(stroke, grain))
            continue;
        if (svg && !open) {
            char ink[PANE_INK];
            pane_ink(pane->style, number, stroke, ink);
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
static size_t draw(const struct pane *pane, const struct scene *scene, const struct grain *grain,
                   struct svg *svg)
{
    static const enum stroke_kind order[] = {STROKE_RAPID, STROKE_POLES, STROKE_LINE, STROKE_ARC,
                                             STROKE_SPLINE};
    size_t marks = 0;
    for (size_t layer = 0; layer < scene->n; layer++)
        for (size_t k = 0; k < sizeof order / sizeof *order; k++)
            for (size_t i = 0; i < PALETTE_CYCLE; i++)
                marks += draw_style(pane, scene, layer, (size_t)order[k] * PALETTE_CYCLE + i, grain,
                                    svg);
    return marks;
}

void pane_strokes(struct pane *pane, const struct scene *scene, struct svg *svg)
{
    struct grain grain = {.tolerance = 0.1, .every = 1};
    size_t strokes = 0, passes = 0;
    for (size_t i = 0; i < scene->n; i++) {
        strokes += scene->item[i].stroke.n;
        passes = scene->item[i].passes > passes ? scene->item[i].passes : passes;
    }
    pane->every = 1;
    if (strokes == 0)
        return;
    while (passes / grain.every > PASSES)
        grain.every *= 2;
    while (draw(pane, scene, &grain, NULL) > 2 * pane->style->marks && grain.tolerance < 2) {
        if (grain.tolerance < 0.4 || passes / grain.every < 40)
            grain.tolerance *= 2;
        else
            grain.every *= 2;
    }
    pane->every = grain.every;
    svg_group(svg, "fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\"");
    draw(pane, scene, &grain, svg);
    svg_group_end(svg);
}
