/*
 * nchole_siemens - drilling cycles of the Sinumerik (Programming Guide Cycles: CYCLE81 to CYCLE86);
 * see nchole.h.
 */
#include <math.h>
#include <string.h>

#include "post/nchole.h"
#include "ncwords.h"
#include "base/num.h"

enum { ARGUMENTS = 17, NAME_ROOM = 20 };

/* A call in one block; an argument that is not a number is left out. */
static void call(struct nc_program *p, const char *name, int n, const double argument[])
{
    char text[NAME_ROOM + ARGUMENTS * (NUM_MAX + 1)];
    size_t at = strlen(name);
    memcpy(text, name, at);
    for (int i = 0; i < n; i++) {
        text[at++] = i ? ',' : '(';
        if (!isnan(argument[i]))
            at += num_write_short(text + at, argument[i], p->plan->ability.digits.linear, false);
    }
    memcpy(text + at, ")", 2);
    nc_block(&p->w, text);
}

/* The cycle that is called at each place from here on: retract plane, mouth, safety distance,
 * bottom, and what is the kind's own. */
static void begin(struct nc_program *p, const struct nc_hole *hole)
{
    const struct path_cycle *c = hole->cycle;
    double top = nc_hole_level(hole), bottom = nc_hole_bottom(hole);
    double dwell = c->dwell > 0 ? c->dwell : (double)NAN, feed = hole->feed;
    double rpm = p->tooling.spindle, turns = p->tooling.ccw ? 4 : 3, none = NAN;
    double pitch = nc_hole_pitch(p, hole) * (p->tooling.ccw ? -1 : 1);
    double argument[ARGUMENTS] = {top, hole->mouth.z, hole->clear, bottom, none, dwell};
    if (c->kind == CYCLE_TAP) {
        memcpy(argument + 6, (double[]){turns, none, pitch, 0, rpm, rpm}, 6 * sizeof rpm);
        call(p, "MCALL CYCLE84", 12, argument);
    } else if (c->kind == CYCLE_BORE) {
        memcpy(argument + 6, (double[]){feed, feed}, 2 * sizeof rpm);
        call(p, "MCALL CYCLE85", 8, argument);
    } else if (c->kind == CYCLE_DRAG) {
        memcpy(argument + 6, (double[]){turns, 0, 0, 0, 0}, 5 * sizeof rpm);
        call(p, "MCALL CYCLE86", 11, argument);
    } else if (nc_hole_steps(hole)) {
        double next = c->next > 0 && c->next < c->step ? c->next : c->step;
        double gap = PATH_PECK_GAP / p->plan->ability.unit;
        const double deep[] = {none, c->step, c->step - next, 0,  0, 1, c->kind == CYCLE_DEEP, none,
                               next, gap,     dwell,          gap};
        memcpy(argument + 5, deep, sizeof deep);
        call(p, "MCALL CYCLE83", ARGUMENTS, argument);
    } else {
        call(p, c->dwell > 0 ? "MCALL CYCLE82" : "MCALL CYCLE81", c->dwell > 0 ? 6 : 4, argument);
    }
}

void nc_hole_siemens(struct nc_program *p, const struct nc_move *move)
{
    const struct nc_hole *hole = nc_hole_of(p, move);
    struct nc_writer *w = &p->w;
    if (!nc_hole_goes_on(p, move)) {
        if (p->hole)
            nc_hole_siemens_end(p);
        nc_feed(p, move);
        nc_end(w);
        begin(p, hole);
        nc_motion(w, "G0");
    }
    nc_hole_place(p, hole);
    nc_end(w);
    nc_hole_done(p, move);
}

void nc_hole_siemens_end(struct nc_program *p)
{
    nc_block(&p->w, "MCALL");
    p->hole = NULL;
    p->w.motion = NULL;
}
