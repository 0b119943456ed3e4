/*
 * post_head - what stands in a program's head for people: tool, what X Y Z are, the ledger of the
 * tolerance, length and time.
 */
#ifndef CLOUDMILL_POST_HEAD_H
#define CLOUDMILL_POST_HEAD_H

#include "dialect.h"

/* Comments at the start of the program. */
void nc_head(struct nc_program *p);

/* Sum of the ledger with ncpost's own share, mm. */
double nc_ledger_sum(const struct path *path, const struct nc_plan *plan);

#endif
