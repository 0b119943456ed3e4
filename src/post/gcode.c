/* gcode - see gcode.h. */
#include "gcode.h"

#include "post_hole.h"
#include "post_statement.h"
#include "post_template.h"
#include "post_words.h"
#include "math/elementary.h"

static const char *const vector_address[] = {"I", "J", "K"};

/* ---- blocks of ISO 6983 */

static void select_plane(struct nc_writer *w, int number)
{
    if (w->plane != number)
        nc_code(w, number == 17 ? "G17" : number == 18 ? "G18" : "G19");
    w->plane = number;
}

void gcode_arc(struct nc_program *p, const struct nc_move *move)
{
    const struct nc_arc *a = &p->plan->arc.item[move->index];
    int digits = p->plan->ability.digits.linear;
    struct nc_writer *w = &p->w;
    select_plane(w, a->plane);
    nc_motion(w, a->ccw ? "G3" : "G2");
    if (a->full) /* the end is named though it is where the tool stands */
        nc_forget(w, a->plane == 19 ? NC_Y : NC_X, a->plane == 17 ? NC_Y : NC_Z);
    nc_place(p, move->p);
    nc_axis(p, move, vector_address);
    if (a->radius != 0)
        nc_number(w, "R", a->radius, digits);
    if (a->radius == 0 && a->plane != 19)
        nc_number(w, "I", a->centre.x, digits);
    if (a->radius == 0 && a->plane != 18)
        nc_number(w, "J", a->centre.y, digits);
    if (a->radius == 0 && a->plane != 17)
        nc_number(w, "K", a->centre.z, digits);
    nc_feed(p, move);
    nc_end(w);
}

static const char *const g_cutcom[] = {"G40", "G41", "G42"};

void gcode_straight(struct nc_program *p, const struct nc_move *move, const char *const address[3])
{
    bool inverse = p->plan->ability.feeds == NC_FEEDS_INVERSE && move->kind != NC_RAPID;
    struct nc_writer *w = &p->w;
    if (inverse && !w->inverse) {
        nc_code(w, "G93");
        w->inverse = true;
    }
    nc_motion(w, move->kind == NC_RAPID ? "G0" : "G1");
    const char *cutcom = nc_cutcom_word(p, move, g_cutcom);
    if (cutcom)
        nc_code(w, cutcom);
    if (cutcom && p->cutcom.on && dialect_of(p->control)->gcode) /* by number in a table of tools */
        nc_count(w, "D", p->tooling.number ? p->tooling.number : 1);
    nc_place(p, move->p);
    nc_axis(p, move, address);
    nc_feed(p, move);
    nc_end(w);
}

/* ---- drilling cycles */

/* G73 steps, G74 and G84 taps (against the clock, with it), G76 none, G81 G82 (dwell) drill, G83
 * out of the hole after each step, G85 G89 (dwell) out at feed, G86 with the spindle stopped. */
static const char *cycle_code(const struct nc_program *p, const struct path_cycle *c)
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

/* G82 and G89 wait, and G86, which may want its P in any case; G73 and G83 know no P. */
static bool hole_dwells(const struct nc_hole *hole)
{
    return hole->cycle->kind == CYCLE_DRAG || (hole->cycle->dwell > 0 && !nc_hole_steps(hole));
}

/* A rapid of its own leads from the hole up to the level of G98. */
static bool needs_rapid_to_level(const struct gcode *g, const struct nc_hole *hole)
{
    return g->level_at_feed && nc_hole_slow(hole) && hole->retract > hole->clear;
}

/* Up at rapid by a block of its own. */
static void rapid_to_level(struct nc_program *p, const struct nc_hole *hole)
{
    gcode_hole_end(p);
    nc_motion(&p->w, "G0");
    nc_number(&p->w, "Z", nc_hole_level(hole), p->plan->ability.digits.linear);
    nc_end(&p->w);
}

void gcode_hole(struct nc_program *p, const struct nc_move *move)
{
    const struct gcode *g = dialect_of(p->control)->gcode;
    const struct nc_hole *hole = nc_hole_of(p, move);
    const struct path_cycle *c = hole->cycle;
    int digits = p->plan->ability.digits.linear;
    struct nc_writer *w = &p->w;
    bool goes_on = nc_hole_goes_on(p, move);
    if (p->hole && !goes_on)
        gcode_hole_end(p);
    if (w->plane != 17) {
        nc_block(w, "G17");
        w->plane = 17;
    }
    if (!goes_on) {
        if (c->kind == CYCLE_TAP)
            nc_template(p, p->machine->blocks.tap);
        nc_code(w, hole->retract > hole->clear && !needs_rapid_to_level(g, hole) ? "G98" : "G99");
        nc_code(w, cycle_code(p, c));
    }
    nc_hole_place(p, hole);
    if (!goes_on) {
        nc_number(w, "Z", nc_hole_bottom(hole), digits);
        nc_number(w, "R", nc_hole_clear(hole), digits);
        if (nc_hole_steps(hole))
            nc_number(w, "Q", fmin(c->step, c->next > 0 ? c->next : c->step), digits);
        if (hole_dwells(hole) && g->dwell_seconds)
            nc_number(w, "P", c->dwell, 3);
        else if (hole_dwells(hole) && c->dwell > 0)
            nc_count(w, "P", round(1000 * c->dwell));
        nc_feed(p, move);
    }
    nc_end(w);
    nc_hole_done(p, move);
    if (needs_rapid_to_level(g, hole))
        rapid_to_level(p, hole);
}

void gcode_hole_end(struct nc_program *p)
{
    nc_block(&p->w, "G80");
    p->hole = NULL;
    p->w.motion = NULL;
}

void gcode_line(struct nc_program *p, const struct nc_move *move)
{
    gcode_straight(p, move, vector_address);
}
