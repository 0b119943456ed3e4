/* feature - see feature.h; feature_crease.c and feature_wall.c are the rest of it. */
#include "feature.h"

enum { FEWEST = 72 };

/* How wide a neighbourhood is against the noise. */
static const double WIDE = 40;

size_t feature_reach(const struct feature_cloud *cloud)
{
    double reach = WIDE * cloud->noise / cloud->spacing;

    return (size_t)fmin(fmax(PI * reach * reach, FEWEST), FEATURE_MOST);
}
