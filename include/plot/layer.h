/*
 * layer - a stream of any kind as a layer of a scene, with the figures that its title tells.
 */
#ifndef CLOUDMILL_LAYER_H
#define CLOUDMILL_LAYER_H

#include "math/box.h"
#include "base/error.h"
#include "io/path/path.h"
#include "plot/scene.h"

struct layer_options {
    double unit;         /* mm in a unit of a cloud */
    bool poles;          /* of B-splines */
    bool normals;        /* of a mesh, of contact points */
    bool axes;           /* of the tool */
    bool cut;            /* no rapid moves */
    double chord;        /* mm: curves in pieces no further off than this; 0: as can be seen */
    const char *machine; /* that a program is for (machine.h), NULL: the default one */
};

/* Reads the file (NULL or "-": standard input), whatever it holds. */
int layer_read(const char *file, const struct layer_options *options, struct layer *layer,
               struct error *error);

/* The chord error that can't be seen: 1/5000 of the extent, or what the options say if that is
 * less. */
double layer_chord(const struct layer_options *options, const struct box *box);

/* A path: arcs and B-splines in pieces that stray from them by no more than that. */
int layer_path(const struct path *path, const struct layer_options *options, struct layer *layer,
               struct error *error);

/* An NC program, as its control and the machine run it (ncread.h): what it cuts between two rapid
 * moves is a pass. */
int layer_program(const char *file, const struct layer_options *options, struct layer *layer,
                  struct error *error);

#endif
