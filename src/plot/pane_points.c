/* pane_points - clouds, joints, normals and axes; see pane.h. */
#include <stdio.h>
#include <stdlib.h>

#include "palette.h"
#include "plot/pane.h"

static double off_middle(const struct raster *r, struct vec3 p)
{
    double x = (p.x - r->left) / r->cell, y = (p.y - r->bottom) / r->cell;
    return hypot(x - floor(x) - 0.5, y - floor(y) - 0.5);
}

/* The points that are not hidden, one in each cell: the nearest to its middle, so that they stand
 * evenly. */
static struct raster occupied(const struct pane *pane, const struct vec3s *point, double cell,
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

static size_t level_of(const struct pane_options *style, struct vec3 p)
{
    double range = style->high.z - style->low.z;
    double s = range > 0 ? (p.z - style->low.z) / range : 0;
    return (size_t)fmin(floor(s * PALETTE_HEIGHTS), PALETTE_HEIGHTS - 1);
}

static void draw_points(const struct pane *pane, const struct layer *layer, size_t number,
                        double least, struct svg *svg)
{
    const struct pane_options *style = pane->style;
    size_t marks, limit = style->marks;
    double cell = least;
    struct raster r = occupied(pane, &layer->point, cell, &marks);
    while (marks > limit) {
        raster_free(&r);
        cell *= fmax(1.05, 0.95 * sqrt((double)marks / (double)limit));
        r = occupied(pane, &layer->point, cell, &marks);
    }
    double area = (pane->box.high.x - pane->box.low.x) * (pane->box.high.y - pane->box.low.y);
    double apart = sqrt(area / (double)(marks ? marks : 1)) * pane->scale;
    double width = fmin(fmax(0.75 * apart, 0.9), fmin(2 + 0.08 * apart, 5));
    for (size_t level = 0; level < (style->by_layer ? 1 : PALETTE_HEIGHTS); level++) {
        char ink[80];
        snprintf(ink, sizeof ink, "stroke=\"%s\" stroke-width=\"%.0f\"",
                 style->by_layer ? palette_cycle(number) : palette_height(level), 10 * width);
        svg_path(svg, ink);
        for (size_t i = 0; i < r.rows * r.columns; i++) {
            struct vec3 p = layer->point.item[r.owner[i]];
            if (isinf(r.depth[i]) || (!style->by_layer && level_of(style, p) != level))
                continue;
            struct vec3 at = pane_place(pane, view_point(&pane->view, p));
            svg_dot(svg, at.x, at.y);
        }
        svg_path_end(svg);
    }
    raster_free(&r);
}

void pane_points(struct pane *pane, const struct scene *scene, struct svg *svg)
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

/* As many as can be told apart, this far from one another, px. */
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
            view_point(&pane->view, vec_along(t->from, pane->style->tick, t->direction));
        if (!raster_visible(&pane->near, p, pane->slack) || !raster_point(&r, p, i))
            continue;
        struct vec3 from = pane_place(pane, p), to = pane_place(pane, q);
        svg_dot(svg, from.x, from.y);
        svg_line(svg, to.x, to.y);
    }
    svg_path_end(svg);
    raster_free(&r);
}

/* Dots at points that stand on strokes, as many as can be told apart. */
static void draw_dots(const struct pane *pane, const struct vec3s *joint, const char *ink,
                      struct svg *svg)
{
    size_t marks;
    struct raster r = occupied(pane, joint, 1.2 / pane->scale, &marks);
    svg_path(svg, ink);
    for (size_t i = 0; i < r.rows * r.columns; i++) {
        if (isinf(r.depth[i]))
            continue;
        struct vec3 at = pane_place(pane, view_point(&pane->view, joint->item[r.owner[i]]));
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

void pane_ticks(struct pane *pane, const struct scene *scene, struct svg *svg)
{
    svg_group(svg, "fill=\"none\" stroke-linecap=\"round\"");
    for (size_t i = 0; i < scene->n; i++) {
        const struct layer *layer = &scene->item[i];
        if (pane->style->joints && layer->joint.n)
            draw_dots(pane, &layer->joint, "stroke=\"#222\" stroke-width=\"20\"", svg);
        draw_poles(pane, layer, svg);
        if (layer->normal.n)
            draw_ticks(pane, &layer->normal, 8, "stroke=\"#009E73\" stroke-width=\"9\"", svg);
        if (layer->axis.n)
            draw_ticks(pane, &layer->axis, 8, "stroke=\"#444444\" stroke-width=\"8\"", svg);
    }
    svg_group_end(svg);
}
