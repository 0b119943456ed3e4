/* cloud_options - see cloud_options.h. */
#include "stage/cloud_options.h"

#include <math.h>

const char *const unit_name[] = {"mm", "cm", "m", "um", "inch", "in"};

static const double SMALL = 1, LARGE = 3000; /* mm */
static const double FAR = 3000;              /* mm, of the zero: beyond what usual axes travel */

bool size_is_likely(double longest)
{
    return longest >= SMALL && longest <= LARGE;
}

void say_unlikely_size(const char *name, double longest)
{
    if (!size_is_likely(longest))
        say("%s: the part is %.3g mm long, expected %g to %g: is the unit right? (-u)", name,
            longest, SMALL, LARGE);
}

/* How far the range from low to high stays away from 0. */
static double off_zero(double low, double high)
{
    return fmax(0, fmax(low, -high));
}

void say_far_away(const char *name, struct box box)
{
    double off = fmax(off_zero(box.low.x, box.high.x), off_zero(box.low.y, box.high.y));

    if (off > FAR)
        say("%s: lies %.4g mm from the zero of its coordinates, farther than machines travel: "
            "--origin moves it there",
            name, off);
}
