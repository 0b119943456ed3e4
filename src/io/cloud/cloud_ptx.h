/*
 * cloud_ptx - PTX, the grid of a terrestrial scanner, one scan or several behind each other:
 *
 *     columns                      each a whole number alone on its line
 *     rows
 *     x y z                        four lines: scanner's place and axes
 *     m11 m12 m13 m14              four lines: [x y z 1] times this matrix is the point
 *     x y z intensity [r g b]      columns * rows cells; 0 0 0: nothing was measured
 */
#ifndef CLOUDMILL_CLOUD_PTX_H
#define CLOUDMILL_CLOUD_PTX_H

#include "cloud_source.h"

int cloud_ptx_read(struct cloud_source *source, struct error *error);

#endif
