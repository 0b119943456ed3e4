/*
 * parallel - the same work on every element of an array, by several threads.
 */
#ifndef CLOUDMILL_PARALLEL_H
#define CLOUDMILL_PARALLEL_H

#include <stddef.h>

/*
 * Calls work(context, from, to) for pieces of 0..n-1 that cover each index once, on up to
 * `threads` threads (0: as many as there are processors).  Their order is arbitrary: work on an
 * element must not depend on another element, so that the result does not depend on the number
 * of threads.  Returns when all is done.
 */
void parallel_for(int threads, size_t n, void (*work)(void *context, size_t from, size_t to),
                  void *context);

/* The same for a tool's long work: `what` and the percentage done are shown on a terminal. */
void parallel_shown(const char *what, int threads, size_t n,
                    void (*work)(void *context, size_t from, size_t to), void *context);

#endif
