/* gcode - see gcode.h. */
#include "gcode.h"

#include <math.h>

#include "post_head.h"
#include "post_hole.h"
#include "post_statement.h"
#include "post_words.h"

static const char *const vector_address[] = {"I", "J", "K"};

/* ---- blocks of ISO 6983 */

void gcode_minutes(struct nc_program *p)
{
    if (p->w.inverse)
        nc_block(&p->w, "G94");
    p->w.inverse = false;
}

void gcode_rotary_home(struct nc_program *p)
{
    const double zero[ROTARY_MAX] = {0};
    int n = p->plane ? p->turned : p->machine->chain.n;
    if (!n)
        return;
    nc_forget(&p->w, NC_Q0, NC_Q1);
    nc_motion(&p->w, "G0");
    nc_rotary_axes(p, n, zero);
    nc_end(&p->w);
}

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

void gcode_cutcom_off(struct nc_program *p)
{
    if (nc_cutcom_end(p))
        nc_block(&p->w, g_cutcom[CUTCOM_OFF]);
}

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
            nc_template(p, p->machine->blocks.tap, "");
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

/* ---- a program */

void gcode_start(struct nc_program *p)
{
    const struct gcode *g = dialect_of(p->control)->gcode;
    struct nc_writer *w = &p->w;
    nc_line(w, "%");
    g->name(p);
    nc_head(p);
    nc_code(w, p->plan->ability.unit > 1 ? g->modal_inch : g->modal_mm);
    nc_offset(p, "G54");
    nc_end(w);
    w->plane = 17;
    if (g->modes)
        g->modes(p);
    nc_template(p, p->machine->blocks.safe, g->safe);
    nc_template(p, p->machine->blocks.start, "");
    nc_home(p, g->home);
}

void gcode_load(struct nc_program *p)
{
    if (p->tooling.number)
        nc_template(p, p->machine->blocks.tool_change, "T{tool} M6");
    nc_spindle(p);
}

/* X Y at rapid, at the height where the tool is. */
static void go_across(struct nc_program *p, struct vec3 to)
{
    int digits = p->plan->ability.digits.linear;
    nc_motion(&p->w, "G0");
    nc_modal(&p->w, NC_X, "X", to.x, digits);
    nc_modal(&p->w, NC_Y, "Y", to.y, digits);
    nc_end(&p->w);
}

/* The tool's length, and the first place: above it before down to it. */
static void compensate_length(struct nc_program *p, const struct nc_move *first)
{
    const struct gcode *g = dialect_of(p->control)->gcode;
    int digits = p->plan->ability.digits.linear;
    struct nc_writer *w = &p->w;
    go_across(p, first->p);
    nc_code(w, "G43");
    if (p->tooling.number || !g->tool_at_hand)
        nc_count(w, "H", p->tooling.offset);
    nc_modal(w, NC_Z, "Z", first->p.z, digits);
    nc_end(w);
}

/* Where no word of the control switches it on, the machine's kinematics does it always. */
static void compensate_radius(struct nc_program *p, const struct nc_move *first)
{
    const struct gcode *g = dialect_of(p->control)->gcode;
    bool tcp = p->plan->ability.tcp, vectors = p->plan->ability.mode == INTERPOLATE_VECTOR;
    const char *usual = vectors ? g->tcp_vectors : g->tcp_rotary;
    if (tcp)
        nc_template(p, p->machine->blocks.tcp_on, usual ? usual : "");
    if (!tcp || !usual) {
        compensate_length(p, first);
        return;
    }
    p->w.motion = NULL;
    go_across(p, first->p);
    nc_motion(&p->w, "G0");
    nc_modal(&p->w, NC_Z, "Z", first->p.z, p->plan->ability.digits.linear);
    nc_end(&p->w);
}

/*
 * From home to the first place, which is above the work: the rotary axes where nothing is near, X
 * and Y, then down.  With the rotary axes at zero until then X Y Z are those of the work, and no
 * way of the tool depends on where it started.
 */
void gcode_engage(struct nc_program *p)
{
    const struct gcode *g = dialect_of(p->control)->gcode;
    const struct nc_move *first = nc_first_move(p);
    if (p->plane) {
        go_across(p, nc_above_plane(p, first));
        nc_template(p, p->machine->blocks.plane_on, g->plane_on);
        nc_forget(&p->w, NC_X, NC_Z);
        p->w.motion = NULL;
    }
    if (p->machine->chain.n) {
        nc_motion(&p->w, "G0");
        nc_rotary_start(p, first);
        nc_end(&p->w);
    }
    compensate_radius(p, first);
    if (nc_zero_first(p)) {
        nc_motion(&p->w, "G0");
        nc_axis(p, first, vector_address);
        nc_end(&p->w);
    }
    nc_coolant(p);
    if (p->machine->smooth && g->smooth_on)
        nc_template(p, p->machine->blocks.smooth_on, g->smooth_on);
}

void gcode_line(struct nc_program *p, const struct nc_move *move)
{
    gcode_straight(p, move, vector_address);
}

void gcode_dwell(struct nc_program *p, double seconds)
{
    nc_code(&p->w, "G4");
    nc_number(&p->w, dialect_of(p->control)->gcode->dwell, seconds, 3);
    nc_end(&p->w);
}

/* G49, which ends the tool-centre-point control that a word has switched on too, by the key
 * length.off of the machine; true: it is to stand in the block that goes home. */
static bool leave_length(struct nc_program *p, const char *own)
{
    const struct gcode *g = dialect_of(p->control)->gcode;
    const struct machine *m = p->machine;
    if (*own || p->plane || !g->length_moves || m->length_off == LENGTH_OFF_ALONE) {
        nc_template(p, own, "G49");
        return false;
    }
    if (m->length_off == LENGTH_OFF_HOME)
        return true;
    nc_motion(&p->w, "G0");
    nc_code(&p->w, "G49");
    nc_number(&p->w, "Z", m->length_z / p->plan->ability.unit, p->plan->ability.digits.linear);
    nc_end(&p->w);
    return false;
}

void gcode_disengage(struct nc_program *p)
{
    const struct gcode *g = dialect_of(p->control)->gcode;
    const char *own = p->plan->ability.tcp ? p->machine->blocks.tcp_off : "";
    gcode_cutcom_off(p);
    gcode_minutes(p);
    if (p->machine->smooth && g->smooth_off)
        nc_template(p, p->machine->blocks.smooth_off, g->smooth_off);
    if (!g->tcp_rotary) {
        nc_template(p, own, "");
        own = "";
    }
    if (leave_length(p, own))
        nc_code(&p->w, "G49"); /* the block goes on */
    if (p->plane)
        nc_template(p, p->machine->blocks.plane_off, g->plane_off);
    nc_home(p, g->home);
}

void gcode_finish(struct nc_program *p)
{
    struct nc_writer *w = &p->w;
    gcode_rotary_home(p);
    if (w->plane != 17)
        nc_block(w, "G17");
    nc_block(w, "M9");
    nc_block(w, "M5");
    nc_template(p, p->machine->blocks.end, "");
    nc_block(w, dialect_of(p->control)->gcode->end);
    nc_line(w, "%");
}
