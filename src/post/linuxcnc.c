/*
 * linuxcnc - the dialect of LinuxCNC (its manual: G-Code Overview, G-Codes): the common
 * G-code (gcode.h) with its own words.
 *
 * Stock LinuxCNC has no word for tool-centre-point control.  A machine has it when its kinematics
 * does it always (xyzac-trt-kins), and then X Y Z are the tip all the time; else ncpost solves the
 * kinematics and feeds are inverse time.  G5.2 knows X and Y alone: no splines.
 */
#include <string.h>

#include "gcode.h"
#include "post_words.h"

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

static void program_name(struct nc_program *p)
{
    if (p->name)
        nc_comment(&p->w, "%s", p->name);
}

static const struct gcode words = {
    .modal_mm = "G90 G91.1 G17 G21 G40 G49 G80 G94",
    .modal_inch = "G90 G91.1 G17 G20 G40 G49 G80 G94",
    .safe = "",
    .home = "G53 G0 Z0.",
    .end = "M2",
    .dwell = "P",
    .dwell_seconds = true,
    .level_at_feed = true,
    .tool_at_hand = true,
    .name = program_name,
    .modes = smoothing,
};

const struct dialect dialect_linuxcnc = {
    .gcode = &words,
    .style = {.open = "(", .close = ")", .capitals = true, .point = true, .most = 99999},
    .digits = {.linear = 4, .angle = 4, .vector = 6, .knot = 3, .feed = 2},
    .vectors_never = true,
    .arcs = NC_ARCS_CENTRE,
    .splines = NC_SPLINES_NONE,
    .steps_alike = true,
    .check_name = check_name,
    .start = gcode_start,
    .load = gcode_load,
    .engage = gcode_engage,
    .line = gcode_line,
    .arc = gcode_arc,
    .hole = gcode_hole,
    .hole_end = gcode_hole_end,
    .dwell = gcode_dwell,
    .disengage = gcode_disengage,
    .finish = gcode_finish,
};
