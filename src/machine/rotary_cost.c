/* rotary_cost - see rotary_cost.h. */
#include "machine/rotary_cost.h"

#include <math.h>

static const double STEP = 5 * PI / 180;
static const double UPRIGHT = 1e-6; /* radians: an axis that leans less has no direction */

double rotary_travel(struct vec3 from, struct vec3 to)
{
    double lean0 = atan2(hypot(from.x, from.y), from.z), lean1 = atan2(hypot(to.x, to.y), to.z);

    if (lean0 < UPRIGHT || lean1 < UPRIGHT)
        return fabs(lean1 - lean0);
    /* the angle between the directions, exact where it is small */
    double turn = atan2(fabs(from.x * to.y - from.y * to.x), from.x * to.x + from.y * to.y);
    return fmin(fabs(lean1 - lean0) + turn, lean0 + lean1 + PI - turn);
}

static int lean_steps(double least, double most)
{
    return most > least ? (int)ceil((most - least) / STEP - 1e-9) : 0;
}

int rotary_leans(double least, double most)
{
    return ROTARY_LEAN_DIRECTIONS * (1 + lean_steps(least, most));
}

struct tool_axis_options rotary_lean(double least, double most, int i)
{
    int n = lean_steps(least, most), step = i / ROTARY_LEAN_DIRECTIONS;
    double part = n > 0 ? (double)step / n : 0, off = least + part * (most - least);
    double direction = 2 * PI * (i % ROTARY_LEAN_DIRECTIONS) / ROTARY_LEAN_DIRECTIONS;

    return (struct tool_axis_options){.kind = AXIS_LEAN,
                                      .lead = atan(tan(off) * cos(direction)),
                                      .tilt = atan(tan(off) * sin(direction))};
}
