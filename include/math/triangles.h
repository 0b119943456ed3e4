/*
 * triangles - a lattice of equilateral triangles: places a pitch apart in rows sin 60 degrees of it
 * apart, each row half a pitch on from the one before.
 */
#ifndef CLOUDMILL_TRIANGLES_H
#define CLOUDMILL_TRIANGLES_H

/* Of the pitch: how far rows are apart. */
#define TRIANGLES_ROW 0.8660254037844386

/* Rows, and places of a row, to either side of the origin that hold all places within `reach` of
 * it: the lattice is skewed, so that it takes more of both than pitches. */
static inline double triangles_rings(double reach, double pitch)
{
    return reach / (pitch * TRIANGLES_ROW);
}

/* Place i of row j, from the origin. */
static inline void triangles_at(double pitch, int i, int j, double *u, double *v)
{
    *u = pitch * (i + j / 2.0);
    *v = pitch * j * TRIANGLES_ROW;
}

#endif
