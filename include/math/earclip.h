/*
 * earclip - a simple polygon as triangles.
 */
#ifndef CLOUDMILL_EARCLIP_H
#define CLOUDMILL_EARCLIP_H

#include "math/faces.h"
#include "math/uv.h"

/*
 * Appends the n - 2 triangles of a polygon whose corners run counter-clockwise, the best shaped ear
 * cut off first, but never so that the corners left lie on one line; `corner` says what each corner
 * is called in the faces.  A polygon that crosses itself by rounding is cut up all the same.
 */
void earclip(const struct uv *at, const int *corner, size_t n, struct faces *face);

#endif
