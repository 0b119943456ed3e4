/*
 * aside - work done by another thread, one piece after the other, while the one that asks for it
 * goes on: a file's next block is read while the last one is worked on.
 */
#ifndef CLOUDMILL_ASIDE_H
#define CLOUDMILL_ASIDE_H

#include <stdbool.h>

struct aside;

/* `threads` as in parallel.h: with one, or where no other can be had, work is done when it is asked
 * for. */
struct aside *aside_begin(int threads);

/* Waits for the work asked for before, and has work(context) done. */
void aside_do(struct aside *aside, void (*work)(void *context), void *context);

/* The same without waiting: done after what is in hand.  False, and nothing is asked for, if a
 * piece waits already. */
bool aside_add(struct aside *aside, void (*work)(void *context), void *context);

/* A piece waits: aside_add would have no room. */
bool aside_is_full(struct aside *aside);

/* Forgets the piece that waits, and returns its context (NULL: none waits); the one in hand goes
 * on. */
void *aside_drop(struct aside *aside);

/* Returns when what was asked for is done. */
void aside_wait(struct aside *aside);

/* The same, and the end of it. */
void aside_end(struct aside *aside);

#endif
