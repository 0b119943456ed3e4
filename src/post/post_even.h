/*
 * post_even - a path whose cuts nowhere go off an even course and back in one block each.
 *
 * That is what a digit or a sign that is wrong in one block looks like, and who reads the program
 * back cannot tell it from one.  So where a path does so by itself, as a link may between two short
 * runs, or an axis that must lean far at one place, one of the two goes in halves.
 */
#ifndef CLOUDMILL_POST_EVEN_H
#define CLOUDMILL_POST_EVEN_H

#include "io/path/path.h"

/* Halves lines and arcs of the path, and spans of its B-splines; the way stays as it is.  How many.
 * None of a path without a ledger: there it may well be a wrong digit. */
size_t post_even(struct path *path);

#endif
