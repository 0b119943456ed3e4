/*
 * rounding - heights of a scan that were rounded to steps coarse against what its points are apart,
 * as those of a terrain to whole metres.
 *
 * Between two steps such points lie on level planes, and on a slope on few planes more, exactly: as
 * on a part of many small stairs, whose edges nobody would have meant.  A rounded height may be
 * anywhere within half a step; put anywhere there it is as if with noise of another kind, which
 * what looks at scans knows (as "dither" that is added to a signal, to part what rounding does to
 * it from the signal: Schuchman, Dither signals and their effect on quantization noise, 1964).
 */
#ifndef CLOUDMILL_ROUNDING_H
#define CLOUDMILL_ROUNDING_H

#include <stdbool.h>
#include <stddef.h>

#include "math/vec.h"

/* The step that z of all n points was rounded to, mm, if it is 0.04 to 0.3 of the spacing of the
 * points, and most of the steps over the height of the scan are there; else 0.  Up to a tenth of
 * it points may be off, as by their decimals. */
double rounding_step(const struct vec3 *point, size_t n, double spacing);

/* What smooth surfaces leave of the points, one standard deviation, mm, is as much as rounding to
 * such steps leaves: where it is less the points are where they were, as of a slope on a grid that
 * climbs by a step from one to the next. */
bool rounding_left(double step, double sigma);

/* The points with z moved by up to half a step, evenly, the same way at each place: they are off
 * where they were before they were rounded by 0.41 of a step, one standard deviation. */
void rounding_spread(double step, const struct vec3 *point, size_t n, struct vec3 *spread);

#endif
