/*
 * post_program - a plan written by the dialect of its control, move by move: tools and planes are
 * changed on the way, drilling cycles ended.
 */
#ifndef CLOUDMILL_POST_PROGRAM_H
#define CLOUDMILL_POST_PROGRAM_H

#include "dialect.h"

/* The start of the program, up to its first motion; what follows its last one. */
void post_program_start(struct nc_program *p);
void post_program_finish(struct nc_program *p);

/* One move of the program. */
void post_program_move(struct nc_program *p, const struct nc_move *move);

/* The whole program. */
void post_program_write(struct nc_program *p);

#endif
