/*
 * sheet - a whole picture: title and figures, views at one scale, captions, legend, scale bar.
 */
#ifndef CLOUDMILL_SHEET_H
#define CLOUDMILL_SHEET_H

#include "plot/pane.h"

enum sheet_views { SHEET_BOTH, SHEET_PLAN, SHEET_ISO, SHEET_FRONT, SHEET_SIDE, SHEET_ALL };

enum { REMARK = 300 };

struct remarks {
    size_t n, cap;
    struct remark {
        char text[REMARK];
    } * item;
};

struct sheet_options {
    const char *title;
    enum sheet_views views; /* BOTH: plan and isometric */
    double width;           /* px, at most */
    bool by_pass, by_layer, joints;
    const struct remarks *remarks; /* further lines of figures, NULL: none */
};

/* Writes the scene, which has something to draw, as SVG. */
void sheet_write(struct out *out, const struct scene *scene, const struct sheet_options *options);

/* The length of a scale bar, 1, 2 or 5 times a power of ten, at most `most` mm. */
double sheet_bar(double most);

#endif
