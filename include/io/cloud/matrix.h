/*
 * matrix - the file that places a cloud: a 4 x 4 matrix as registration programs write it.
 */
#ifndef CLOUDMILL_MATRIX_H
#define CLOUDMILL_MATRIX_H

#include "base/error.h"
#include "math/transform.h"

/*
 * Reads 16 numbers, row by row, separated by blanks, tabs, commas, semicolons or line ends; #
 * starts a comment.  The last row must be 0 0 0 1 and the matrix must not flatten space.  `file`
 * NULL or
 * "-" is standard input.
 */
int matrix_read(const char *file, struct transform *matrix, struct error *error);

#endif
