/*
 * panel - one view of a scene on a picture, and how its parts are drawn.
 */
#ifndef CLOUDMILL_PANEL_H
#define CLOUDMILL_PANEL_H

#include "raster.h"
#include "scene.h"
#include "svg.h"

struct panel_style {
    bool by_pass;          /* strokes by their pass; else by their kind */
    bool by_layer;         /* all by its stream, to compare */
    bool joints;           /* where motions end */
    double tick;           /* length of normals and axes, mm */
    size_t marks;          /* at most about as many points, facets or ends of lines in a panel */
    struct vec3 low, high; /* of all clouds: heights by colour */
};

struct panel {
    struct view view;
    struct box box; /* of the scene in the view, mm */
    double x, y;    /* left upper corner, px */
    double scale;   /* px in a mm */
    const struct panel_style *style;
    struct raster near; /* what is nearest to the eye: hides what is behind */
    bool hides;         /* there is something in it */
    double slack;       /* what is less behind is not hidden, mm */
    size_t every;       /* of the passes each so many-th is drawn */
};

/* Draws the scene; sets `every`. */
void panel_draw(struct panel *panel, const struct scene *scene, struct svg *svg);

/* A projected point on the picture, px; its z stays, mm. */
struct vec3 panel_place(const struct panel *panel, struct vec3 projected);

/* The parts: facets, points, strokes of all layers, then what stands on them. */
void panel_facets(struct panel *panel, const struct scene *scene, struct svg *svg);
void panel_points(struct panel *panel, const struct scene *scene, struct svg *svg);
void panel_strokes(struct panel *panel, const struct scene *scene, struct svg *svg);
void panel_ticks(struct panel *panel, const struct scene *scene, struct svg *svg);
void panel_marks(struct panel *panel, const struct scene *scene, struct svg *svg);

/* The attributes of strokes of this kind, as panel and legend have them. */
enum { PANEL_INK = 160 };
void panel_ink(const struct panel_style *style, size_t layer, const struct stroke *stroke,
               char ink[PANEL_INK]);

#endif
