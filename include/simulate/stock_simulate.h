/*
 * stock_simulate - a motion run over a stock: what each pass takes off and leaves, which moves
 * cut air, what rapid moves, shaft and holder run into.
 *
 * A pass is what is cut between two rapid moves.  Lengths in mm, volumes in mm^3.
 */
#ifndef CLOUDMILL_STOCK_SIMULATE_H
#define CLOUDMILL_STOCK_SIMULATE_H

#include "simulate/centre_path.h"
#include "simulate/holder_collision.h"
#include "simulate/stock_rest.h"

struct stock_simulate_pass {
    size_t first, last; /* pieces of the motion */
    double volume;
    double bite;         /* deepest that this pass took, along the normal of what it cut ... */
    size_t bite_piece;   /* ... in this piece ... */
    struct vec3 bite_at; /* ... here */
    size_t blocks, air;  /* blocks at feed, and those of them that took nothing */
    double length, air_length;  /* of the ball's path in them */
    struct stock_rest_sum left; /* after it */
};

struct stock_simulate {
    struct {
        size_t n, cap;
        struct stock_simulate_pass *item;
    } pass;
    double before, after; /* volume of the stock */
    double rapid;         /* how deep a rapid move goes into it, above the tolerance; 0: none */
    size_t rapid_piece;
    struct vec3 rapid_at;
    size_t rapids;                  /* rapid pieces that do */
    struct holder_collision holder; /* the tool above its ball */
};

struct stock_simulate_options {
    const struct nc_motion *motion;
    const struct centre_path *cut; /* its pieces at feed: centre_path_cut */
    double radius, flat, tolerance;
    const struct holder_collision_options *tool; /* above the ball, against this stock; NULL: not
                                                    looked at */
};

/* Cuts the stock; `rest` measures what is left on the part after each pass. */
void stock_simulate_run(const struct stock_simulate_options *options, struct stock *stock,
                        struct stock_rest *rest, struct stock_simulate *run);

void stock_simulate_free(struct stock_simulate *run);

#endif
