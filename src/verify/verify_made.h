/*
 * verify_made - what the first cut of a program is made with: tool, spindle, coolant and work
 * offset, against its path and what its head says.
 */
#ifndef CLOUDMILL_VERIFY_MADE_H
#define CLOUDMILL_VERIFY_MADE_H

#include "verify/verify.h"

void verify_made(struct verdict *v);

#endif
