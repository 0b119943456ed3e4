/*
 * nchole_heidenhain - drilling cycles of the TNC 640 (User's Manual for Cycle Programming: 200 to
 * 207); see nchole.h.
 */
#include <math.h>
#include <string.h>

#include "post/nchole.h"
#include "ncwords.h"
#include "base/num.h"

enum { PARTS = 16, LINE = NUM_MAX + 60, CHIP_BREAKS = 99, FASTEST = 99999 };

/* One Q parameter of a cycle. */
struct part {
    int q;
    double value;
    const char *says;
};

/* The lines of a definition go on behind ~. */
static void define(struct nc_program *p, const char *name, int n, const struct part *part)
{
    char line[LINE];
    int digits = p->plan->ability.digits.linear;
    nc_code(&p->w, name);
    for (int i = 0; i < n; i++) {
        nc_code(&p->w, "~");
        size_t at = 4;
        memcpy(line, "    Q", 5);
        at += 1 + num_write(line + 5, part[i].q, 0);
        line[at++] = '=';
        if (num_round(part[i].value, digits) >= 0)
            line[at++] = '+';
        at += num_write_short(line + at, part[i].value, digits, false);
        memcpy(line + at, " ;", 2);
        memcpy(line + at + 2, part[i].says, strlen(part[i].says) + 1);
        nc_continue(&p->w, line);
    }
    nc_end(&p->w);
}

static void begin(struct nc_program *p, const struct nc_hole *hole)
{
    const struct path_cycle *c = hole->cycle;
    bool down = c->next > 0 && c->next < c->step;
    double next = down ? c->next : c->step, less = down ? c->step - c->next : 0;
    double above = hole->retract > hole->clear ? hole->retract : 0,
           gap = PATH_PECK_GAP / p->plan->ability.unit;
    const struct part clear = {200, hole->clear, "SET-UP CLEARANCE"},
                      depth = {201, -hole->depth, "DEPTH"},
                      feed = {206, hole->feed, "FEED RATE FOR PLNGNG"},
                      step = {202, nc_hole_steps(hole) ? c->step : hole->depth, "PLUNGING DEPTH"},
                      mouth = {203, hole->mouth.z, "SURFACE COORDINATE"},
                      second = {204, above, "2ND SET-UP CLEARANCE"},
                      dwell = {211, c->dwell, "DWELL TIME AT DEPTH"},
                      top = {210, 0, "DWELL TIME AT TOP"}, smaller = {212, less, "DECREMENT"},
                      least = {205, next, "MIN. PLUNGING DEPTH"},
                      out = {208, c->kind == CYCLE_BORE ? hole->feed : FASTEST,
                             "RETRACTION FEED RATE"},
                      back = {256, gap, "DIST FOR CHIP BRKNG"};
    if (c->kind == CYCLE_TAP)
        define(p, "CYCL DEF 207 RIGID TAPPING", 5,
               (struct part[]){
                   clear,
                   depth,
                   {239, nc_hole_pitch(p, hole) * (p->tooling.ccw ? -1 : 1), "THREAD PITCH"},
                   mouth,
                   second});
    else if (c->kind == CYCLE_BORE)
        define(p, "CYCL DEF 201 REAMING", 7,
               (struct part[]){clear, depth, feed, dwell, out, mouth, second});
    else if (c->kind == CYCLE_DRAG)
        define(p, "CYCL DEF 202 BORING", 9,
               (struct part[]){clear,
                               depth,
                               feed,
                               dwell,
                               out,
                               mouth,
                               second,
                               {214, 0, "DISENGAGING DIRECTN"},
                               {336, 0, "ANGLE OF SPINDLE"}});
    else if (nc_hole_steps(hole) && c->kind == CYCLE_DEEP)
        define(p, "CYCL DEF 205 UNIVERSAL PECKING", PARTS,
               (struct part[]){clear,
                               depth,
                               feed,
                               step,
                               mouth,
                               second,
                               smaller,
                               least,
                               {258, gap, "UPPER ADV STOP DIST"},
                               {259, gap, "LOWER ADV STOP DIST"},
                               {257, 0, "DEPTH FOR CHIP BRKNG"},
                               back,
                               dwell,
                               {379, 0, "STARTING POINT"},
                               {253, FASTEST, "F PRE-POSITIONING"},
                               out});
    else if (nc_hole_steps(hole))
        define(p, "CYCL DEF 203 UNIVERSAL DRILLING", 13,
               (struct part[]){clear,
                               depth,
                               feed,
                               step,
                               top,
                               mouth,
                               second,
                               smaller,
                               {213, CHIP_BREAKS, "NR OF BREAKS"},
                               least,
                               dwell,
                               out,
                               back});
    else
        define(p, "CYCL DEF 200 DRILLING", 8,
               (struct part[]){clear, depth, feed, step, top, mouth, second, dwell});
}

void nc_hole_heidenhain(struct nc_program *p, const struct nc_move *move)
{
    const struct nc_hole *hole = nc_hole_of(p, move);
    struct nc_writer *w = &p->w;
    if (!nc_hole_goes_on(p, move))
        begin(p, hole);
    nc_code(w, "L");
    nc_hole_place(p, hole);
    nc_code(w, "R0 FMAX M99");
    nc_end(w);
    nc_hole_done(p, move);
}

void nc_hole_heidenhain_end(struct nc_program *p)
{
    p->hole = NULL; /* M99 calls once: nothing is on */
}
