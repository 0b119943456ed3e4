/*
 * feature_test - is a crease sharp, or a rounded edge or a narrow rib that was taken for one?
 */
#ifndef CLOUDMILL_FEATURE_TEST_H
#define CLOUDMILL_FEATURE_TEST_H

#include <stdbool.h>

#include "feature.h"
#include "math/side_fit.h"

/*
 * Two sheets, as heights along `up`, meet at a place, in a crease that runs `along` (unit vectors).
 * A rounded edge leaves that line: the points nearest to the place, or those of a neighbourhood
 * that is long the way it runs (ridge_direction.h), are all on one side of the sheets, or a quadric
 * leaves much less of them, and the sheets more than noise does.  False also where there are too
 * few points.
 */
bool feature_test_sharp(const struct feature_cloud *cloud, const struct side_fit sheet[2],
                        struct vec3 up, struct vec3 at, struct vec3 along);

#endif
