/*
 * verify_finding - what a verdict says of a program, a line each, `fault` or not.
 */
#ifndef CLOUDMILL_VERIFY_FINDING_H
#define CLOUDMILL_VERIFY_FINDING_H

#include "verify/verify.h"

/* About a place: the line begins with the block that the piece is from. */
void finding_add(struct verdict *v, bool fault, size_t piece, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* About the program as a whole. */
void finding_remark(struct verdict *v, bool fault, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
