/* cloud_options - see cloud_options.h. */
#include "stage/cloud_options.h"

const char *const unit_name[] = {"mm", "cm", "m", "um", "inch", "in"};

static const double SMALL = 1, LARGE = 3000; /* mm */

void say_unlikely_size(const char *name, double longest)
{
    if (longest < SMALL || longest > LARGE)
        say("%s: the part is %.3g mm long, expected %g to %g: is the unit right? (-u)", name,
            longest, SMALL, LARGE);
}
