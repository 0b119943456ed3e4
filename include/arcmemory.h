/*
 * arcmemory - what became of the smooth parts of a run when it was fitted, for the same run with
 * some of its points moved.
 */
#ifndef CLOUDMILL_ARCMEMORY_H
#define CLOUDMILL_ARCMEMORY_H

#include "arcprint.h"

struct arcmemory_part {
    struct trace trace;
    struct printeds printed; /* none: taken out */
    struct stray worst;
};

/* Starts as all zero; owns its parts. */
struct arcmemory {
    size_t n, cap;
    struct arcmemory_part *item;
};

/* Takes out what became of a part with these very points: its pieces in the place of those in
 * `printed`.  False when there was none. */
bool arcmemory_take(struct arcmemory *memory, const struct trace *trace, struct printeds *printed,
                    struct stray *worst);

void arcmemory_free(struct arcmemory *memory);

#endif
