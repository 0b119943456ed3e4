/*
 * svg - a picture as SVG text: its frame, groups, texts and compact paths.
 *
 * Lengths in the picture's own units, y downwards, as CSS pixels.  A path is written in whole
 * tenths (a group scales it down), each step relative to the one before, so that what is written
 * adds up to the place that was meant.
 */
#ifndef CLOUDMILL_SVG_H
#define CLOUDMILL_SVG_H

#include <stdbool.h>
#include <stddef.h>

#include "base/out.h"

enum { SVG_COUNT = 32 }; /* room for svg_count */

struct svg {
    struct out *out;
    long x, y;           /* where the pen is, tenths */
    long from_x, from_y; /* where the subpath began */
    char last;           /* command written last */
    size_t column;       /* characters in the line */
};

/* The frame: size, a title and a description for those who cannot see it, a white ground. */
void svg_begin(struct svg *svg, struct out *out, double width, double height, const char *title,
               const char *description);
void svg_end(struct svg *svg);

/* A group with these attributes (`stroke="#000"`), as they stand. */
void svg_group(struct svg *svg, const char *attributes);
void svg_group_end(struct svg *svg);

/* One path; its attributes as they stand.  Lengths among them are tenths. */
void svg_path(struct svg *svg, const char *attributes);
void svg_move(struct svg *svg, double x, double y);
void svg_line(struct svg *svg, double x, double y);
void svg_dot(struct svg *svg, double x, double y); /* a piece of no length: round caps show it */
void svg_close(struct svg *svg);
void svg_path_end(struct svg *svg);

/* A line of text from x on ("start"), about it ("middle") or up to it ("end"); escaped. */
void svg_text(struct svg *svg, double x, double y, const char *anchor, double size, bool bold,
              const char *text);

/* About as wide as svg_text will be (fonts differ). */
double svg_text_width(double size, bool bold, const char *text);

/* 17036 as 17,036. */
void svg_count(char text[SVG_COUNT], size_t number);

#endif
