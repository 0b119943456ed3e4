/* toolpath_tell - what came of a path; see toolpath.h. */
#include "base/cli.h"
#include "stage/toolpath.h"

/* What does not hold, and where. */
static void complain(const struct toolpath *t)
{
    const struct gouge_strip_report *r = &t->report;
    struct vec3 at = r->miss_at;

    if (r->missed > 0)
        say("the ball can't reach %zu points with a lift of at most %g mm and passes over them, in "
            "pass %zu by %.3f mm at %.3f %.3f %.3f",
            r->missed, t->lift.limit, t->missed_pass, r->miss, at.x, at.y, at.z);
    at = t->stands_at;
    if (t->standing > 0)
        say("the ball does not fit at %zu points and leaves material standing there, in pass %zu "
            "%.3f mm at %.3f %.3f %.3f",
            t->standing, t->stands_pass, t->stands, at.x, at.y, at.z);
    if ((r->missed > 0 || t->standing > 0) && !t->rule.avoid)
        say("that is what a smaller ball has to take; --avoid accepts it");
    at = t->blocked_at;
    if (t->blocked > 0)
        say("pass %zu: the ball touches the part on %zu ways to or from the clearance plane, the "
            "first at %.3f %.3f %.3f",
            t->blocked_pass, t->blocked, at.x, at.y, at.z);
    at = t->held_at;
    if (t->held > 0)
        say("shank or holder touches at %zu points whatever the axis is leaned within the limit: "
            "left out, the first in pass %zu at %.3f %.3f %.3f",
            t->held, t->held_pass, at.x, at.y, at.z);
    if (t->shank > 0)
        say("at %zu points the normal is more than 90 degrees off the axis: not the ball touches "
            "there, but the shank",
            t->shank);
}

int toolpath_conclude(const struct toolpath *t)
{
    const struct gouge_strip_report *r = &t->report;

    note("%zu points in %zu passes, %zu links with the tool down, %zu over the clearance plane",
         r->points, t->pass, t->low, t->high);
    note("%zu points lifted, at most by %.4f mm at %.3f %.3f %.3f", r->lifted, r->highest,
         r->highest_at.x, r->highest_at.y, r->highest_at.z);
    if (t->rule.holder.n > 0)
        note("axes leaned by at most %.2f degrees for shank and holder", DEGREES(t->leaned));
    if (t->lift.between)
        note("straight lines within %g mm of the lifted path", t->lift.tolerance);
    else
        note("straight lines up to %.4f mm off the smooth path", t->chord);
    complain(t);
    bool left = (r->missed > 0 || t->standing > 0) && !t->rule.avoid;
    left = left || (t->held > 0 && !t->rule.skip);
    return left || t->blocked > 0 || t->shank > 0 ? EXIT_UNMET : EXIT_DONE;
}
