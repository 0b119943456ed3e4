/* panel - what hides what, and the order of drawing; see panel.h. */
#include "panel.h"

#include <stdlib.h>

struct vec3 panel_place(const struct panel *panel, struct vec3 p)
{
    return vec(panel->x + (p.x - panel->box.low.x) * panel->scale,
               panel->y + (panel->box.high.y - p.y) * panel->scale, p.z);
}

static void hide_by_mesh(struct panel *panel, const struct mesh *mesh, size_t first)
{
    for (size_t i = 0; i < mesh->face.n; i++) {
        struct vec3 p[3];
        for (int k = 0; k < 3; k++)
            p[k] = view_point(&panel->view, mesh->vertex.item[mesh->face.item[i].v[k]]);
        raster_triangle(&panel->near, p[0], p[1], p[2], first + i);
    }
}

/* Points hide what is behind as discs that reach to their neighbours. */
static void hide_by_cloud(struct panel *panel, const struct vec3s *point)
{
    struct box box = box_empty();
    for (size_t i = 0; i < point->n; i++)
        box_add(&box, view_point(&panel->view, point->item[i]));
    double area = (box.high.x - box.low.x) * (box.high.y - box.low.y);
    double radius = fmax(1.2 * sqrt(area / (double)point->n), 0.6 * panel->near.cell);
    for (size_t i = 0; i < point->n; i++)
        raster_disc(&panel->near, view_point(&panel->view, point->item[i]), radius, 0);
    panel->slack = fmax(panel->slack, 4 * radius);
}

/* Eight-sided rings, over all else. */
void panel_marks(struct panel *panel, const struct scene *scene, struct svg *svg)
{
    enum { RADIUS = 8, SIDES = 8 };
    if (scene->mark.n == 0)
        return;
    svg_path(svg, "fill=\"none\" stroke=\"#d00000\" stroke-width=\"20\"");
    for (size_t i = 0; i < scene->mark.n; i++) {
        struct vec3 p = panel_place(panel, view_point(&panel->view, scene->mark.item[i]));
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

void panel_draw(struct panel *panel, const struct scene *scene, struct svg *svg)
{
    const struct box *b = &panel->box;
    panel->near = raster_new(b->low.x, b->low.y, b->high.x, b->high.y, 0.5 / panel->scale);
    panel->slack = 3 / panel->scale;
    size_t first = 0;
    for (size_t i = 0; i < scene->n; i++) {
        const struct layer *layer = &scene->item[i];
        hide_by_mesh(panel, &layer->mesh, first);
        first += layer->mesh.face.n;
        panel->hides |= layer->mesh.face.n > 0 || layer->point.n > 0;
        if (layer->point.n && !panel->style->by_layer)
            hide_by_cloud(panel, &layer->point);
    }
    panel_facets(panel, scene, svg);
    panel_points(panel, scene, svg);
    panel_strokes(panel, scene, svg);
    panel_ticks(panel, scene, svg);
    panel_marks(panel, scene, svg);
    raster_free(&panel->near);
}
