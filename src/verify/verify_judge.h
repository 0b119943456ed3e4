/*
 * verify_judge - what is wrong with a program, by what was measured of it: the findings of a
 * verdict.
 */
#ifndef CLOUDMILL_VERIFY_JUDGE_H
#define CLOUDMILL_VERIFY_JUDGE_H

#include "verify/verify.h"

#define ROUNDED 0.001 /* mm: what places and radii printed may be off */

/* How many points of all may be left. */
size_t verify_may_be_left(const struct verdict *v);

/* Adds them; all else of the verdict is known already. */
void verify_judge(struct verdict *v);

#endif
