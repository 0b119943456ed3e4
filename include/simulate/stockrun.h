/*
 * stockrun - a course run over a stock: what each pass takes off and leaves, which moves cut air,
 * what rapid moves, shank and holder run into.
 *
 * A pass is what is cut between two rapid moves.  Lengths in mm, volumes in mm^3.
 */
#ifndef CLOUDMILL_STOCKRUN_H
#define CLOUDMILL_STOCKRUN_H

#include "simulate/ballpath.h"
#include "simulate/holderway.h"
#include "simulate/stockleft.h"

struct stockrun_pass {
    size_t first, last; /* pieces of the course */
    double volume;
    double bite;         /* deepest that this pass took, along the normal of what it cut ... */
    size_t bite_piece;   /* ... in this piece ... */
    struct vec3 bite_at; /* ... here */
    size_t blocks, air;  /* blocks at feed, and those of them that took nothing */
    double length, air_length; /* of the ball's way in them */
    struct stockleft_sum left; /* behind it */
};

struct stockrun {
    struct {
        size_t n, cap;
        struct stockrun_pass *item;
    } pass;
    double before, after; /* volume of the stock */
    double rapid;         /* how deep a rapid move goes into it, above the tolerance; 0: none */
    size_t rapid_piece;
    struct vec3 rapid_at;
    size_t rapids; /* rapid pieces that do */
};

struct stockrun_setup {
    const struct course *course;
    const struct ball_path *cut; /* its pieces at feed: ballpath_cut */
    double radius, flat, tolerance;
    struct holderway *way; /* shank and holder against this stock; NULL: not looked at */
    bool rapids_alone;     /* `way` follows rapid moves only */
};

/* Cuts the stock; `left` asks the points of the part after each pass. */
void stockrun_run(const struct stockrun_setup *setup, struct stock *stock, struct stockleft *left,
                  struct stockrun *run);

void stockrun_free(struct stockrun *run);

#endif
