/*
 * pane - one view of a scene on a picture, and how its parts are drawn.
 */
#ifndef CLOUDMILL_PANE_H
#define CLOUDMILL_PANE_H

#include "math/box.h"
#include "plot/scene.h"
#include "raster.h"
#include "svg.h"
#include "view.h"

struct pane_options {
    bool by_pass;          /* strokes by their pass; else by their kind */
    bool by_speed;         /* by their speed */
    bool by_layer;         /* all by its stream, to compare */
    bool joints;           /* where motions end */
    double tick;           /* length of normals and axes, mm */
    size_t marks;          /* at most about as many points, facets or ends of lines in a pane */
    struct vec3 low, high; /* of all clouds: heights by colour */
};

struct pane {
    struct view view;
    struct box box; /* of the scene in the view, mm */
    double x, y;    /* left upper corner, px */
    double scale;   /* px in a mm */
    const struct pane_options *options;
    struct raster near; /* what is nearest to the eye: hides what is behind it */
    bool hides;         /* there is something in it */
    double slack;       /* what is less far behind is not hidden, mm */
};

/* Draws the scene. */
void pane_draw(struct pane *pane, const struct scene *scene, struct svg *svg);

/* The attributes of strokes of this kind, as pane and legend have them. */
enum { PANE_INK = 160 };
void pane_ink(const struct pane_options *options, size_t layer, const struct stroke *stroke,
              char ink[PANE_INK]);

/* The box of all layers as they stand in a view, with some room for rapid moves that leave it. */
struct box scene_box(const struct scene *scene, const struct view *view, double tick);

#endif
