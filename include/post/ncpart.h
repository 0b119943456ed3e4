/*
 * ncpart - part of a plan as a program of its own, with a safe start and end: for programs that
 * are divided, and to start again from a pass.
 */
#ifndef CLOUDMILL_NCPART_H
#define CLOUDMILL_NCPART_H

#include "post/dialect.h"

/* How long a program may be; 0: no limit. */
struct nc_limit {
    size_t blocks, bytes;
};

/* 20000 blocks, 500k or 2M bytes. */
int nc_limit_read(const char *text, struct nc_limit *limit, struct error *error);

/*
 * The moves [from, to) of a plan as a plan.  What is before them that lasts (coolant, spindle) is
 * said again.  Where the tool is in the cut at either end, it comes from above and goes up along
 * its axis.  The part shares the plan's arcs and splines; free it by nc_part_free.  -1: it would
 * leave the travel on that way.
 */
int nc_part_make(struct nc_plan *part, const struct nc_program *whole, size_t from, size_t to,
                 struct error *error);

void nc_part_free(struct nc_plan *part);

/* The first move of a pass; the number of moves where there is none. */
size_t nc_part_pass(const struct nc_plan *plan, size_t pass);

/*
 * Where the parts end: ends[0] < ends[1] ... the last of them the number of moves.  Between two
 * rapids where that can be, else in the cut.  -1: not even one move has room.
 */
int nc_part_ends(struct sizes *ends, const struct dialect *dialect, const struct nc_program *whole,
                 struct nc_limit limit, struct error *error);

#endif
