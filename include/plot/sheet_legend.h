/*
 * sheet_legend - the foot of a picture: a scale bar, what the colours and lines mean.
 */
#ifndef CLOUDMILL_SHEET_LEGEND_H
#define CLOUDMILL_SHEET_LEGEND_H

#include "plot/pane.h"

enum { LEGEND_ITEMS = 16 };

struct legend_item {
    char text[120];
    char ink[PANE_INK]; /* of its sample; empty: heights by colour */
    bool dot;           /* its sample is a dot, not a line */
    double x;           /* of the sample, from the left */
    size_t row;
};

struct legend {
    size_t n, rows;
    struct legend_item item[LEGEND_ITEMS];
    double bar, scale; /* mm; px in a mm */
};

/* What there is in the scene, in rows no wider than `width` px. */
struct legend legend_of(const struct scene *scene, const struct pane_options *style, double scale,
                        double width);
double legend_height(const struct legend *legend);
void legend_draw(const struct legend *legend, struct svg *svg, double x, double y);

/* The name of a file without its folder. */
const char *sheet_name(const char *file);

#endif
