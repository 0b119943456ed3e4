/*
 * holder_collision - the tool above its ball, flute, shank and holder, followed along a motion:
 * where does it run into the part, or into the stock as it is then?  Lengths in mm.
 *
 * The stack is looked at where it stands; as far as it is clear, so far it may move before it has
 * to be looked at again.  Where it is not clear the piece is halved until the depth is known well
 * enough (constants in the .c); a piece that is known to hit is looked at only for what is deeper
 * than all before it.
 */
#ifndef CLOUDMILL_HOLDER_COLLISION_H
#define CLOUDMILL_HOLDER_COLLISION_H

#include <stdbool.h>

#include "math/height_pyramid.h"
#include "math/kdtree.h"
#include "simulate/nc_motion.h"
#include "simulate/stock.h"
#include "simulate/tool_shape.h"

/* What they may run into: points of the part, or the surface of a stock. */
struct collision_body {
    struct kdtree *tree;           /* of the points of a part */
    struct stock *stock;           /* or a stock, whose changes it follows, ... */
    struct height_pyramid heights; /* ... and its heights */
    struct vec3 hint;              /* what was nearest the last time */
    bool hinted;
};

/* A search: where the tool is, and what was found so far. */
struct holder_search {
    const struct tool_shape *tool;
    struct vec3 centre, axis; /* of the ball; up the tool */
    double distance;          /* to the nearest place; on entry: what is no nearer is ignored */
    double enough;            /* a place nearer than this ends the search */
    struct vec3 at;           /* that place, if the distance got smaller */
};

/* The points are not needed any more after it. */
struct collision_body collision_body_points(const struct vec3 *point, size_t n);

/* The surface of the stock: tops of its columns, and the walls between them. */
struct collision_body collision_body_stock(struct stock *stock);

void collision_body_free(struct collision_body *body);

/* What of it is nearest to the tool where it stands; below zero it is inside. */
void collision_body_nearest(struct collision_body *body, struct holder_search *search);

struct holder_collision_options {
    const struct nc_motion *motion;
    const struct tool_shape *tool;
    struct collision_body *body;
    double radius;    /* of the ball */
    double tolerance; /* no collision up to this depth */
};

/* What was found up to a piece; all zero before the first. */
struct holder_collision {
    double depth; /* the deepest, above the tolerance; 0: clear */
    size_t piece; /* there */
    struct vec3 at;
    double height; /* of `at`, above the ball's centre up the tool */
    double width;  /* radius of the tool at that height */
    size_t pieces; /* that are deeper than the tolerance */
    /* between one piece and the next */
    double budget; /* how far the stack may move before it has to be looked at */
    bool known;    /* `last` holds */
    struct nc_motion_pose last;
};

/* Follows one piece; pieces come in their order, those between may be left out. */
void holder_collision_piece(const struct holder_collision_options *options,
                            struct holder_collision *found, size_t piece);

/* All pieces of the motion against points, by several threads (as of parallel_for). */
struct holder_collision holder_collision_all(const struct holder_collision_options *options,
                                             int threads);

#endif
