/*
 * linuxcnc - the dialect of LinuxCNC (its manual: G-Code Overview, G-Codes): the common
 * G-code (gcode.h) with its own words.
 *
 * Stock LinuxCNC has no word for tool-centre-point control.  A machine has it when its kinematics
 * does it always (xyzac-trt-kins), and then X Y Z are the tip all the time; else ncpost solves the
 * kinematics and feeds are inverse time.  G5.2 knows X and Y alone: no splines.
 */
#include <ctype.h>
#include <string.h>

#include "gcode.h"

static int check_name(const char *name, struct error *error)
{
    if (*name && strlen(name) <= 60 && !strpbrk(name, "()"))
        return 0;
    return error_set(error,
                     "option --program: found `%.40s`, expected 1 to 60 characters and no brackets",
                     name);
}

/* It stands in a comment. */
static void name(const struct nc_program *p, char *text)
{
    size_t n = 0;
    for (const char *s = p->name ? p->name : ""; *s && n + 1 < NC_NAME_MAX; s++)
        text[n++] = (char)toupper((unsigned char)*s);
    text[n] = '\0';
}

static const struct gcode words = {
    .dwell_seconds = true,
    .level_at_feed = true,
};

const struct dialect dialect_linuxcnc = {
    .gcode = &words,
    .digits = {.linear = 4, .angle = 4, .vector = 6, .knot = 3, .feed = 2},
    .vectors_never = true,
    .arcs = NC_ARCS_CENTRE,
    .splines = NC_SPLINES_NONE,
    .steps_alike = true,
    .check_name = check_name,
    .name = name,
    .line = gcode_line,
    .arc = gcode_arc,
    .hole = gcode_hole,
    .hole_end = gcode_hole_end,
};
