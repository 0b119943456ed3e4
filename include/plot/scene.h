/*
 * scene - what there is to draw: points, facets, strokes, and short lines such as normals.
 *
 * A scene has a layer for each stream.  Lengths in mm.
 */
#ifndef CLOUDMILL_SCENE_H
#define CLOUDMILL_SCENE_H

#include "math/box.h"
#include "mesh/mesh.h"
#include "math/vec.h"

enum stroke_kind { STROKE_LINE, STROKE_ARC, STROKE_SPLINE, STROKE_RAPID, STROKE_POLES, STROKES };

enum { STROKE_SPEEDS = 11 };

/* A chain of straight pieces through node[from] to node[to - 1] of its layer. */
struct stroke {
    enum stroke_kind kind;
    size_t from, to;
    size_t pass;   /* number of its pass, 0: none */
    size_t number; /* among those of its kind */
    int speed;     /* 0 to STROKE_SPEEDS - 1: mean speed by its feed */
};

/* A short line: a surface's normal, a tool's axis. */
struct tick {
    struct vec3 from, direction; /* unit */
};

struct ticks {
    size_t n, cap;
    struct tick *item;
};

struct layer {
    const char *name;   /* of the file */
    char figures[240];  /* what there is in it, for the title */
    char told[400];     /* what options and a program's head say differently; "": nothing */
    struct vec3s point; /* of a cloud */
    struct mesh mesh;   /* no facets: there is none */
    struct vec3s node;  /* of the strokes */
    struct {
        size_t n, cap;
        struct stroke *item;
    } stroke;
    struct vec3s joint; /* where motions end */
    struct ticks normal, axis;
    size_t passes, cuts;     /* of a path; of a program, from rapid to rapid */
    size_t motions[STROKES]; /* of each kind as programmed; of POLES: how many poles */
    double cut, rapid;       /* length, mm */
    bool speeds;             /* its strokes have speeds */
};

struct scene {
    size_t n, cap;
    struct layer *item;
    struct vec3s mark; /* places to be ringed */
};

void layer_free(struct layer *layer);
void scene_free(struct scene *scene);

/* The box of all that the layer shows but rapid moves, ticks of this length too; of rapid moves
 * when there is nothing else. */
struct box layer_box(const struct layer *layer, double tick);

#endif
