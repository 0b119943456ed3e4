/*
 * course - what a tool does, as a list of pieces that can be evaluated anywhere.
 *
 * Both sides of a comparison end up here: the path stream (cl.h) and the program as the control
 * would run it (control.h).  Everything is evaluated by formulas of this file alone, so that no
 * mistake of the suite's own arcs and splines is made twice.  Lengths in mm, rotary axes in
 * degrees.
 */
#ifndef READBACK_COURSE_H
#define READBACK_COURSE_H

#include <stdbool.h>
#include <stddef.h>

#include "path.h"

/* Which rotary words there are: the first named is the master, the other the slave. */
enum rotary { ROTARY_AC, ROTARY_BC };

/*
 * The tool axis in the frame of the work, from rotary words in the ISO sense (tool against work):
 * A/C: (sin C sin A, -cos C sin A, cos A); B/C: (sin B cos C, sin B sin C, cos B).
 */
struct vec3 rotary_axis(enum rotary rotary, double master, double slave);

/* A machine's X Y Z of the tip, with the table turned, in the frame of the work: C is the table,
 * carried by A or B, and both axes meet in the zero point. */
struct vec3 rotary_work(enum rotary rotary, double master, double slave, struct vec3 machine);

enum shape {
    SHAPE_LINE,
    SHAPE_ARC,  /* about `normal`, its radius and height changing evenly where they change */
    SHAPE_CUBIC, /* polynomial of the third degree in s */
    SHAPE_SPLINE /* part of a rational B-spline */
};

/* What the second channel q of a piece holds, and how the axis follows from it. */
enum swing {
    SWING_GREAT,  /* the axis: on the great circle, in proportion to s */
    SWING_ROTARY, /* master and slave in degrees (x, y), each in proportion to s */
    SWING_HEAD    /* a second point on the tool axis */
};

struct nurbs {
    int order;
    size_t n;          /* poles */
    double *knot;      /* n + order */
    struct vec3 *p, *q; /* poles of both channels; q NULL: it does not change */
    double *weight;    /* NULL: all 1 */
};

struct piece {
    enum shape shape;
    enum swing swing;
    bool rapid;
    bool table;       /* p is a machine's without tool centre point control: rotary_work */
    size_t line;      /* of the program or stream */
    long block;       /* its N number, -1: none */
    struct vec3 p[2], q[2]; /* both channels at the start and the end */
    struct vec3 centre, normal; /* ARC */
    double angle;               /* ARC: by the right-hand rule, radians */
    struct vec3 pc[3], qc[3];   /* CUBIC: coefficients of s, s^2, s^3 */
    bool q_cubic;               /* CUBIC: qc holds; else q is linear */
    size_t spline;              /* SPLINE: element of course.spline ... */
    double u[2];                /* ... from, to */
    bool touches;               /* a contact point was given for its end */
};

struct course {
    const char *name; /* of the file */
    enum rotary rotary;
    enum path_track track;
    struct { size_t n, cap; struct piece *item; } piece;
    struct { size_t n, cap; struct nurbs *item; } spline;
    size_t blocks;  /* lines with something in them */
    size_t passes;  /* the path stream's */
    size_t lines, arcs, curves, poles; /* as programmed: straight moves, and so on */
};

void course_free(struct course *m);

/* Where the tool is at s from 0 to 1 of a piece. */
struct pose course_at(const struct course *m, const struct piece *piece, double s);

/* Adds a piece for each knot span of the spline, which the course takes over. */
void course_add_spline(struct course *m, struct nurbs spline, const struct piece *as);

/* A text like `N120 (line 14)` for messages, at least 40 characters. */
void course_place(const struct piece *piece, char *text, size_t size);

#endif
