/* pane - what hides what, and the order of drawing; see pane.h. */
#include "plot/pane.h"

#include <stdlib.h>

struct vec3 pane_place(const struct pane *pane, struct vec3 p)
{
    return vec(pane->x + (p.x - pane->box.low.x) * pane->scale,
               pane->y + (pane->box.high.y - p.y) * pane->scale, p.z);
}

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
void pane_marks(struct pane *pane, const struct scene *scene, struct svg *svg)
{
    enum { RADIUS = 8, SIDES = 8 };
    if (scene->mark.n == 0)
        return;
    svg_path(svg, "fill=\"none\" stroke=\"#d00000\" stroke-width=\"20\"");
    for (size_t i = 0; i < scene->mark.n; i++) {
        struct vec3 p = pane_place(pane, view_point(&pane->view, scene->mark.item[i]));
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
        if (layer->point.n && !pane->style->by_layer)
            hide_by_cloud(pane, &layer->point);
    }
    pane_facets(pane, scene, svg);
    pane_points(pane, scene, svg);
    pane_strokes(pane, scene, svg);
    pane_ticks(pane, scene, svg);
    pane_marks(pane, scene, svg);
    raster_free(&pane->near);
}
