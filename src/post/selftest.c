/* selftest - see post.h. */
#include "post/post.h"

#include <stdio.h>

static const double height = 100, tilt = 15, feed = 500; /* mm, degrees, mm/min */

static void add_stop(struct path *path, struct vec3 axis, const char *what)
{
    struct pose at = {vec(0, 0, height), axis};
    char text[80];
    snprintf(text, sizeof text, "PPRINT %s", what);
    path_add_text(path, text);
    path_add_point(path, at, false);
    path_add_text(path, "STOP");
}

/* Which way a direction leans, seen on the work. */
static void say_lean(struct vec3 a, char text[60])
{
    bool x = fabs(a.x) > fabs(a.y);
    double most = x ? a.x : a.y;
    snprintf(text, 60, "The tool leans to %s of the work",
             x          ? most > 0 ? "X+" : "X-"
             : most > 0 ? "Y+"
                        : "Y-");
}

static bool within_travel(const struct machine *m, const double q[])
{
    for (int i = 0; i < m->chain.n; i++)
        if (q[i] < m->chain.rotary[i].min || q[i] > m->chain.rotary[i].max)
            return false;
    return true;
}

void post_selftest(struct path *path, const struct machine *machine)
{
    static const double turn[] = {0, 90};
    const struct vec3 up = {0, 0, 1};
    const struct pose above = {vec(0, 0, height + 50), up};
    path->name = "self-test";
    path->head.multax = true;
    path->head.clearance = path->head.chord = NAN;
    path->head.partno = mem_string("SELF TEST", 9);
    path_add_point(path, above, true);
    path_add_feed(path, feed);
    add_stop(path, machine->chain.tool, "The tip stands at X0 Y0 Z100 and must stay there");
    for (int side = 1; side >= -1; side -= 2)
        for (size_t k = 0; k < sizeof turn / sizeof *turn; k++) {
            double q[ROTARY_MAX] = {0};
            char text[60];
            q[machine->chain.n - 1 > 0] = RADIANS(side * tilt);
            if (machine->chain.n == 2)
                q[0] = RADIANS(turn[k]);
            if (!within_travel(machine, q) || (machine->chain.n < 2 && k > 0))
                continue;
            struct vec3 axis = chain_axis(&machine->chain, q);
            if (vec_angle(axis, up) < 0.01)
                continue;
            say_lean(axis, text);
            add_stop(path, axis, text);
        }
    add_stop(path, machine->chain.tool, "Upright again: the indicator must read as at the start");
    path_add_point(path, above, true);
}
