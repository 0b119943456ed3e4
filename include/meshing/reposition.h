/*
 * reposition - nodal point reposition: which point of the cloud each node of the grid takes
 * (paper 1, 3.2.2).
 *
 * The node takes the point nearest to it, seen from above.  Among points equally near (their
 * squared distances are the same within 1e-9 t^2) the paper's criteria decide, made a total order
 * so that the order of the points in the file does not matter:
 *   A  above the node, or level with it, before below
 *   B  in the middle one of the three triangles of that side before the outer two
 *   C  larger x,
 *
 * then larger z, larger y, and the smaller index.
 */
#ifndef CLOUDMILL_REPOSITION_H
#define CLOUDMILL_REPOSITION_H

#include <stdbool.h>
#include <stdint.h>

#include "base/array.h"
#include "base/error.h"
#include "meshing/grid.h"

enum reach {
    REACH_NEAREST, /* a point competes for its nearest node only: no two nodes share a point; a node
                      inside the cloud (at least five full ones around it) that is left empty takes
                      the nearest point that no other node has and that is nearer than 0.7 t */
    REACH_CIRCLE   /* for every node that it is nearer to than t: the paper's circle */
};

#define NO_POINT ((size_t)-1)

/* The index of the point for each node, NO_POINT where there is none: chosen[row * columns +
 * column].  Free with free().  `threads` as in parallel.h: they share points that are sorted by
 * rows, as those of a point grid are. */
size_t *reposition(const struct grid *grid, const struct vec3 *point, size_t n, enum reach reach,
                   int threads);

/*
 * The same of points that come in blocks, in the same order each time: all of them to
 * reposition_add; then, where reposition_empty finds nodes to be filled, all of them again to
 * reposition_fill, and reposition_settle.  Of each row only the nodes are kept that the box of the
 * points has room for.
 */
struct node_choice {
    uint32_t nearness; /* of its point, in steps of 1e-9 t^2 */
    uint32_t point;    /* its number, NO_CHOICE: there is none */
    struct vec3 at;
};

#define NO_CHOICE UINT32_MAX

struct reposition {
    struct grid grid;
    enum reach reach;
    int width;                  /* nodes kept of each row */
    int *first;                 /* of each row, the first column that is kept */
    size_t n;                   /* points so far */
    struct node_choice *choice; /* of node `column` of `row`: reposition_node */
    unsigned char *empty;       /* nodes to be filled, and those beside them */
};

/* -1: 2^32 points or more. */
int reposition_begin(const struct grid *grid, size_t n, enum reach reach,
                     struct reposition *reposition, struct error *error);
void reposition_add(struct reposition *reposition, const struct vec3 *point, size_t n);
bool reposition_empty(struct reposition *reposition);
void reposition_fill(struct reposition *reposition, const struct vec3 *point, size_t n);
void reposition_settle(struct reposition *reposition);
void reposition_free(struct reposition *reposition);

/* Puts what a node has elsewhere, once all nodes have theirs. */
void reposition_move(struct reposition *reposition, int column, int row, struct vec3 to);

/* The choice of a node, NULL: outside, or without a point. */
const struct node_choice *reposition_node(const struct reposition *reposition, int column, int row);

#endif
