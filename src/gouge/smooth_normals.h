/*
 * smooth_normals - the normals of a row's contacts, averaged along it: where a surface has details
 * that are smaller than the ball, it goes to and fro across the row with each normal by itself, and
 * rests on the same in a straight row.
 *
 * Each becomes the mean over `half` mm of the row before and after it, and that twice; less where
 * an end is nearer, so that on a surface that bends evenly all stay as they are.
 */
#ifndef CLOUDMILL_SMOOTH_NORMALS_H
#define CLOUDMILL_SMOOTH_NORMALS_H

#include "curve/run.h"

/* Of the points `contact` and `normal` alone are looked at, and `normal` is changed: unit, and less
 * than a right angle off what it was. */
void smooth_normals(struct run *run, double half);

#endif
