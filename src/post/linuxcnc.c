/*
 * linuxcnc - the dialect of LinuxCNC (its manual: G-Code Overview, G-Codes; design/5-controls.md).
 *
 * Stock LinuxCNC has no word for tool-centre-point control.  A machine has it when its kinematics
 * does it always (xyzac-trt-kins), and then X Y Z are the tip all the time; else ncpost solves the
 * kinematics and feeds are inverse time.  G5.2 knows X and Y alone: no splines.
 */
#include <string.h>

#include "post/dialect.h"
#include "post/nchead.h"
#include "post/nchole.h"
#include "nctemplate.h"
#include "ncwords.h"

static const char *const no_address[] = {"I", "J", "K"};

static const char home[] = "G53 G0 Z0.";

static int check_name(const char *name, struct error *error)
{
    if (*name && strlen(name) <= 60 && !strpbrk(name, "()"))
        return 0;
    return error_set(error,
                     "option --program: found `%.40s`, expected 1 to 60 characters and no brackets",
                     name);
}

/* Within the tolerance, or exactly: without a word the control rounds corners as it likes. */
static void smoothing(struct nc_program *p)
{
    if (p->machine->smooth)
        nc_template(p, p->machine->blocks.smooth_on, "G64 P{tolerance} Q{tolerance}");
    else
        nc_block(&p->w, "G61");
}

/* Tool length, and the first place: above it before down to it. */
static void compensate(struct nc_program *p, const struct nc_move *first)
{
    struct nc_writer *w = &p->w;
    int digits = p->plan->ability.digits.linear;
    nc_template(p, p->plan->ability.tcp ? p->machine->blocks.tcp_on : "", "");
    nc_motion(w, "G0");
    nc_modal(w, NC_X, "X", first->p.x, digits);
    nc_modal(w, NC_Y, "Y", first->p.y, digits);
    nc_end(w);
    nc_code(w, "G43");
    if (p->tooling.number)
        nc_count(w, "H", p->tooling.offset);
    nc_modal(w, NC_Z, "Z", first->p.z, digits);
    nc_end(w);
}

static void start(struct nc_program *p)
{
    struct nc_writer *w = &p->w;
    p->cutcom_offset = true;
    nc_line(w, "%");
    if (p->name)
        nc_comment(w, "%s", p->name);
    nc_head(p, "LinuxCNC");
    nc_code(w, p->plan->ability.unit > 1 ? "G90 G91.1 G17 G20 G40 G49 G80 G94"
                                         : "G90 G91.1 G17 G21 G40 G49 G80 G94");
    nc_offset(p, "G54");
    nc_end(w);
    w->plane = 17;
    smoothing(p);
    nc_template(p, p->machine->blocks.start, "");
    nc_home(p, home);
}

static void load(struct nc_program *p)
{
    if (p->tooling.number)
        nc_template(p, p->machine->blocks.tool_change, "T{tool} M6");
    nc_spindle(p);
}

/* The rotary axes to the first place. */
static void take(struct nc_program *p)
{
    struct nc_writer *w = &p->w;
    const struct nc_move *first = nc_first_move(p);
    if (p->machine->chain.n) {
        nc_motion(w, "G0");
        nc_rotary(p, first->q);
        nc_end(w);
    }
    compensate(p, first);
    nc_coolant(p);
}

static void line(struct nc_program *p, const struct nc_move *move)
{
    nc_straight(p, move, no_address);
}

static void arc(struct nc_program *p, const struct nc_move *move)
{
    nc_plane_arc(p, move, no_address);
    nc_feed(p, move);
    nc_end(&p->w);
}

static void hole(struct nc_program *p, const struct nc_move *move)
{
    nc_hole_g(p, move, true);
}

static void dwell(struct nc_program *p, double seconds)
{
    nc_code(&p->w, "G4");
    nc_number(&p->w, "P", seconds, 3);
    nc_end(&p->w);
}

/* Home, without what was switched on for the tool. */
static void leave(struct nc_program *p)
{
    struct nc_writer *w = &p->w;
    nc_cutcom_off(p);
    nc_minutes(p);
    if (p->plan->ability.tcp)
        nc_template(p, p->machine->blocks.tcp_off, "");
    nc_block(w, "G49");
    nc_home(p, home);
}

static void finish(struct nc_program *p)
{
    struct nc_writer *w = &p->w;
    nc_rotary_home(p);
    if (w->plane != 17)
        nc_block(w, "G17");
    nc_block(w, "M9");
    nc_block(w, "M5");
    nc_template(p, p->machine->blocks.end, "");
    nc_block(w, "M2");
    nc_line(w, "%");
}

const struct dialect dialect_linuxcnc = {
    .name = "linuxcnc",
    .style = {.open = "(", .close = ")", .capitals = true, .point = true, .most = 99999},
    .digits = {.linear = 4, .angle = 4, .vector = 6, .knot = 3, .feed = 2},
    .vectors_never = true,
    .tcp_of_machine = true,
    .arcs = NC_ARCS_CENTRE,
    .splines = NC_SPLINES_NONE,
    .steps_alike = true,
    .check_name = check_name,
    .start = start,
    .load = load,
    .take = take,
    .line = line,
    .arc = arc,
    .hole = hole,
    .hole_end = nc_hole_g_end,
    .dwell = dwell,
    .leave = leave,
    .finish = finish,
};
