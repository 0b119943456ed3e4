/*
 * panel - the test surface that is known exactly: a car's front panel, 74 x 54 x 15 mm, with a
 * crown, two lamp bulges and a wide recess; its smallest hollow radius is 8.8, so that a ball of
 * R 8 just fits.  The shape `panel` of the cloud generator, height by height.
 */
#ifndef TEST_PANEL_H
#define TEST_PANEL_H

#include "math/vec.h"

/* z of the surface over (x, y), which goes on beyond the border by the same formula. */
double panel_height(double x, double y);

/* Signed distance of a point to the surface, mm: above (on the side of +z) it is positive. */
double panel_distance(struct vec3 p);

#endif
