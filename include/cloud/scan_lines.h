/*
 * scan_lines - is a scan on lines, as of a laser: points much closer along them than from one to
 * the next?  Then the nearest points of a place are on two or three lines, through which a surface
 * goes whatever is between.
 */
#ifndef CLOUDMILL_SCAN_LINES_H
#define CLOUDMILL_SCAN_LINES_H

#include <stdbool.h>

#include "math/point_grid.h"

/* The nearest of most points are on a line. */
bool scan_lines_found(const struct point_grid *point_grid);

#endif
