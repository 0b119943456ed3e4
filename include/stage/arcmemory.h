/*
 * arcmemory - what became of the smooth parts of a run when it was fitted, for the same run with
 * some of its points moved.
 */
#ifndef CLOUDMILL_ARCMEMORY_H
#define CLOUDMILL_ARCMEMORY_H

#include "stage/arcprint.h"

struct arcmemory_part {
    struct reference reference;
    struct pieces pieces;
    struct printeds printed; /* none: taken out */
    struct deviation worst;
};

/* Starts as all zero; owns its parts. */
struct arcmemory {
    size_t n, cap;
    struct arcmemory_part *item;
};

/* Takes out what became of a part with these very points: its pieces in the place of those in
 * `pieces` and `printed`.  False when there was none. */
bool arcmemory_take(struct arcmemory *memory, const struct reference *reference,
                    struct pieces *pieces, struct printeds *printed, struct deviation *worst);

/* The part that begins and ends where the reference does; NULL: none. */
const struct arcmemory_part *arcmemory_like(const struct arcmemory *memory,
                                            const struct reference *reference);

void arcmemory_free(struct arcmemory *memory);

#endif
