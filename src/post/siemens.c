/*
 * siemens - the dialect of the Sinumerik 840D sl and ONE (design/5-controls.md; Siemens,
 * Programming Manual Job Planning, for TRAORI, ORIVECT, ORICURVE, CIP, POLY and BSPLINE).
 */
#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "post/dialect.h"
#include "post/nchead.h"
#include "post/nchole.h"
#include "nctemplate.h"
#include "ncwords.h"
#include "base/num.h"
#include "siemens_curve.h"

enum { NAME_MAX_LENGTH = 24 };

static const char home[] = "SUPA G0 Z0 D0";

static int check_name(const char *name, struct error *error)
{
    size_t n = strlen(name);
    bool good = n >= 2 && n <= NAME_MAX_LENGTH;
    for (size_t i = 0; i < n; i++) {
        unsigned char c = (unsigned char)name[i];
        good = good && c < 128 && (isalnum(c) || c == '_') && (i > 1 || !isdigit(c));
    }
    if (good)
        return 0;
    return error_set(error,
                     "option --program: found `%.40s`, expected 2 to %d letters, digits and _, the "
                     "first two no digits",
                     name, NAME_MAX_LENGTH);
}

/* %_N_NAME_MPF: the name asked for, else what of PARTNO is allowed. */
static void program_name(struct nc_program *p)
{
    char name[NAME_MAX_LENGTH + 1] = "", line[NAME_MAX_LENGTH + 40];
    const char *from = p->name ? p->name : p->path->head.partno;
    size_t n = 0;
    for (; from && *from && n < NAME_MAX_LENGTH; from++) {
        unsigned char c = (unsigned char)*from;
        bool good = c < 128 && isalnum(c) && (n > 1 || !isdigit(c));
        if (good || (n && name[n - 1] != '_'))
            name[n++] = good ? (char)toupper(c) : '_';
    }
    while (n && name[n - 1] == '_')
        n--;
    name[n] = '\0';
    char part[24] = "";
    if (p->parts)
        snprintf(part, sizeof part, "_%zu", p->part);
    snprintf(line, sizeof line, "%%_N_%s%s_MPF", n >= 2 ? name : "PART", part);
    nc_line(&p->w, line);
}

static void transform(struct nc_program *p, const struct nc_move *first)
{
    struct nc_writer *w = &p->w;
    if (!p->plan->ability.tcp) {
        int digits = p->plan->ability.digits.linear;
        nc_modal(w, NC_X, "X", first->p.x, digits);
        nc_modal(w, NC_Y, "Y", first->p.y, digits);
        nc_end(w);
        return;
    }
    nc_template(p, p->machine->blocks.tcp_on, "TRAORI");
    nc_offset(p, "G54");
    nc_end(w);
    nc_code(w, p->plan->ability.mode == INTERPOLATE_VECTOR ? "ORIWKS ORIVECT" : "ORIWKS ORIAXES");
    if (siemens_turning_curves(p->plan))
        nc_code(w, "UPATH");
    nc_end(w);
    w->motion = NULL;
}

static void start(struct nc_program *p)
{
    struct nc_writer *w = &p->w;
    program_name(p);
    nc_head(p, "Siemens");
    nc_code(w, p->plan->ability.unit > 1 ? "G90 G17 G700 G40 G94" : "G90 G17 G71 G40 G94");
    nc_offset(p, "G54");
    nc_end(w);
    nc_template(p, p->machine->blocks.start, "");
    nc_home(p, home);
}

static void load(struct nc_program *p)
{
    if (p->tooling.number)
        nc_template(p, p->machine->blocks.tool_change, "T{tool} D1 M6");
    nc_spindle(p);
}

/* The tool's length, off on the way home; the rotary axes to the first place. */
static void take(struct nc_program *p)
{
    struct nc_writer *w = &p->w;
    const struct nc_move *first = nc_first_move(p);
    if (!p->tooling.number || p->same_tool)
        nc_block(w, "D1");
    if (p->plane)
        nc_template(p, p->machine->blocks.plane_on,
                    "CYCLE800(0,\"\",100000,57,0,0,0,{a},{b},0,0,0,0,1,0,1)");
    nc_motion(w, "G0");
    nc_rotary(p, first->q);
    if (p->machine->chain.n)
        nc_end(w);
    transform(p, first);
    nc_coolant(p);
    if (p->machine->smooth)
        nc_template(p, p->machine->blocks.smooth_on, "CYCLE832({tolerance},11,{orientation})");
    if (p->plan->spline.n)
        nc_block(&p->w, "COMPOF"); /* what CYCLE832 may have switched on is for straight blocks */
}

static void line(struct nc_program *p, const struct nc_move *move)
{
    nc_straight(p, move, siemens_vector);
}

/* CIP with the point on the way: I1 J1 K1, absolute. */
static void arc(struct nc_program *p, const struct nc_move *move)
{
    static const char *const address[] = {"I1=AC(", "J1=AC(", "K1=AC("};
    const struct nc_arc *a = &p->plan->arc.item[move->index];
    const double middle[] = {a->middle.x, a->middle.y, a->middle.z};
    struct nc_writer *w = &p->w;
    nc_motion(w, "CIP");
    nc_place(p, move->p);
    for (int i = 0; i < 3; i++) {
        char word[NUM_MAX + 16];
        size_t n = strlen(address[i]);
        memcpy(word, address[i], n);
        n += num_write_short(word + n, middle[i], p->plan->ability.digits.linear, false);
        memcpy(word + n, ")", 2);
        nc_code(w, word);
    }
    nc_axis(p, move, siemens_vector);
    nc_feed(p, move);
    nc_end(w);
}

static void dwell(struct nc_program *p, double seconds)
{
    nc_code(&p->w, "G4");
    nc_number(&p->w, "F", seconds, 3);
    nc_end(&p->w);
}

/* Home, without what was switched on for the tool. */
static void leave(struct nc_program *p)
{
    nc_cutcom_off(p);
    nc_minutes(p);
    if (p->machine->smooth)
        nc_template(p, p->machine->blocks.smooth_off, "CYCLE832(0,0,1)");
    if (p->plan->ability.tcp)
        nc_template(p, p->machine->blocks.tcp_off, "TRAFOOF");
    if (p->plane)
        nc_template(p, p->machine->blocks.plane_off, "CYCLE800()");
    nc_home(p, home);
}

static void finish(struct nc_program *p)
{
    struct nc_writer *w = &p->w;
    nc_rotary_home(p);
    nc_block(w, "M9");
    nc_block(w, "M5");
    nc_template(p, p->machine->blocks.end, "");
    nc_block(w, "M30");
}

const struct dialect dialect_siemens = {
    .name = "siemens",
    .style = {.open = "; ", .close = ""},
    .digits = {.linear = 5, .angle = 5, .vector = 8, .knot = 5, .feed = 2},
    .vectors = true,
    .plane = true,
    .arcs = NC_ARCS_SPACE,
    .arcs_vectors = NC_ARCS_SPACE,
    .splines = NC_SPLINES_NONE,
    .splines_vectors = NC_SPLINES_HEAD,
    .check_name = check_name,
    .start = start,
    .load = load,
    .take = take,
    .line = line,
    .arc = arc,
    .spline = siemens_curve,
    .hole = nc_hole_siemens,
    .hole_end = nc_hole_siemens_end,
    .dwell = dwell,
    .leave = leave,
    .finish = finish,
};
