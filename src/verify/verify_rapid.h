/*
 * verify_rapid - what is wrong with the rapid moves of a program, and with its end.
 */
#ifndef CLOUDMILL_VERIFY_RAPID_H
#define CLOUDMILL_VERIFY_RAPID_H

#include "verify/verify.h"

/* Adds what there is to say; without points of the part only of their length in all. */
void verify_rapid(struct verdict *v);

#endif
