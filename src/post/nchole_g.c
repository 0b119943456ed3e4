/* nchole_g - drilling cycles of Fanuc and LinuxCNC; see nchole.h. */
#include <math.h>

#include "post/nchole.h"
#include "nctemplate.h"
#include "ncwords.h"

/* G73 steps, G74 and G84 taps (against the clock, with it), G76 none, G81 G82 (dwell) drill, G83
 * out of the hole behind each step, G85 G89 (dwell) out at feed, G86 with the spindle stopped. */
static const char *code(const struct nc_program *p, const struct path_cycle *c)
{
    switch (c->kind) {
    case CYCLE_DEEP:
        return c->step > 0 ? "G83" : "G81";
    case CYCLE_BREAK:
        return c->step > 0 ? "G73" : "G81";
    case CYCLE_TAP:
        return p->tooling.ccw ? "G74" : "G84";
    case CYCLE_BORE:
        return c->dwell > 0 ? "G89" : "G85";
    case CYCLE_DRAG:
        return "G86";
    case CYCLE_DRILL:
    case CYCLE_MANUAL: /* is written out */
        break;
    }
    return c->dwell > 0 ? "G82" : "G81";
}

/* G82 and G89 wait, and G86, whose P LinuxCNC wants in any case; G73 and G83 know no P. */
static bool dwells(const struct nc_hole *hole)
{
    return hole->cycle->kind == CYCLE_DRAG || (hole->cycle->dwell > 0 && !nc_hole_steps(hole));
}

/* LinuxCNC goes at feed as far as G98 says where the tool comes out at feed. */
static bool lifts(const struct nc_hole *hole, bool linuxcnc)
{
    return linuxcnc && nc_hole_slow(hole) && hole->retract > hole->clear;
}

/* Up at rapid by a block of its own. */
static void lift(struct nc_program *p, const struct nc_hole *hole)
{
    nc_hole_g_end(p);
    nc_motion(&p->w, "G0");
    nc_number(&p->w, "Z", nc_hole_level(hole), p->plan->ability.digits.linear);
    nc_end(&p->w);
}

void nc_hole_g(struct nc_program *p, const struct nc_move *move, bool seconds)
{
    const struct nc_hole *hole = nc_hole_of(p, move);
    const struct path_cycle *c = hole->cycle;
    int digits = p->plan->ability.digits.linear;
    struct nc_writer *w = &p->w;
    bool goes_on = nc_hole_goes_on(p, move);
    if (p->hole && !goes_on)
        nc_hole_g_end(p);
    if (w->plane != 17) {
        nc_block(w, "G17");
        w->plane = 17;
    }
    if (!goes_on) {
        if (c->kind == CYCLE_TAP)
            nc_template(p, p->machine->blocks.tap, "");
        nc_code(w, hole->retract > hole->clear && !lifts(hole, seconds) ? "G98" : "G99");
        nc_code(w, code(p, c));
    }
    nc_hole_place(p, hole);
    if (!goes_on) {
        nc_number(w, "Z", nc_hole_bottom(hole), digits);
        nc_number(w, "R", nc_hole_clear(hole), digits);
        if (nc_hole_steps(hole))
            nc_number(w, "Q", fmin(c->step, c->next > 0 ? c->next : c->step), digits);
        if (dwells(hole) && seconds)
            nc_number(w, "P", c->dwell, 3);
        else if (dwells(hole) && c->dwell > 0)
            nc_count(w, "P", round(1000 * c->dwell));
        nc_feed(p, move);
    }
    nc_end(w);
    nc_hole_done(p, move);
    if (lifts(hole, seconds))
        lift(p, hole);
}

void nc_hole_g_end(struct nc_program *p)
{
    nc_block(&p->w, "G80");
    p->hole = NULL;
    p->w.motion = NULL;
}
