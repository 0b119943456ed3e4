/*
 * fanuc - the dialect of the Fanuc 30i family (design/5-controls.md; B-64484EN, Fanuc's manual of
 * the 30i, for G43.4, G43.5 and G06.2).
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "post/dialect.h"
#include "post/nchead.h"
#include "post/nchole.h"
#include "nctemplate.h"
#include "ncwords.h"

static const char *const vector_address[] = {"I", "J", "K"};

static const char home[] = "G91 G28 Z0.|G90";

static int check_name(const char *name, struct error *error)
{
    size_t n = strlen(name);
    if (n && n <= 8 && strspn(name, "0123456789") == n && strspn(name, "0") < n)
        return 0;
    return error_set(error, "option --program: found `%.40s`, expected a number of 1 to 8 digits",
                     name);
}

/* O0001(TITLE) */
static void program_number(struct nc_program *p)
{
    char name[16], line[32] = "O";
    snprintf(name, sizeof name, "%ld",
             (p->name ? atol(p->name) : 1) + (p->parts ? (long)p->part - 1 : 0));
    size_t n = strlen(name), zeros = n < 4 ? 4 - n : 0;
    memset(line + 1, '0', zeros);
    memcpy(line + 1 + zeros, name, n + 1);
    nc_line(&p->w, line);
}

/* Tool length compensation, of the kind that the program needs; the rotary axes stand already. */
static void compensate(struct nc_program *p, const struct nc_move *first)
{
    struct nc_writer *w = &p->w;
    if (!p->plan->ability.tcp) {
        int digits = p->plan->ability.digits.linear;
        nc_modal(w, NC_X, "X", first->p.x, digits);
        nc_modal(w, NC_Y, "Y", first->p.y, digits);
        nc_end(w);
        nc_code(w, "G43");
        nc_count(w, "H", p->tooling.offset);
        nc_modal(w, NC_Z, "Z", first->p.z, digits);
        nc_end(w);
    } else {
        nc_template(p, p->machine->blocks.tcp_on,
                    p->plan->ability.mode == INTERPOLATE_VECTOR ? "G43.5 H{offset}"
                                                                : "G43.4 H{offset}");
        w->motion = NULL;
    }
}

static void start(struct nc_program *p)
{
    struct nc_writer *w = &p->w;
    p->cutcom_offset = true;
    nc_line(w, "%");
    program_number(p);
    nc_head(p, "Fanuc");
    nc_code(w, p->plan->ability.unit > 1 ? "G90 G17 G20 G40 G49 G80 G94"
                                         : "G90 G17 G21 G40 G49 G80 G94");
    nc_offset(p, "G54");
    nc_end(w);
    w->plane = 17;
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
    if (p->plane)
        nc_template(p, p->machine->blocks.plane_on, "G68.2 X0. Y0. Z0. I{i} J{j} K{k}|G53.1");
    nc_motion(w, "G0");
    nc_rotary(p, first->q);
    if (p->machine->chain.n)
        nc_end(w);
    compensate(p, first);
    nc_coolant(p);
    if (p->machine->smooth)
        nc_template(p, p->machine->blocks.smooth_on, "G05.1 Q1 R{level}");
}

static void line(struct nc_program *p, const struct nc_move *move)
{
    nc_straight(p, move, vector_address);
}

/* G02.4: a block with a point on the way, the rotary axes half way, and one with the end. */
static void arc_in_space(struct nc_program *p, const struct nc_move *move)
{
    const struct nc_arc *a = &p->plan->arc.item[move->index];
    struct nc_writer *w = &p->w;
    double half[ROTARY_MAX];
    for (int i = 0; i < ROTARY_MAX; i++)
        half[i] = (RADIANS(w->value[i ? NC_Q1 : NC_Q0]) + move->q[i]) / 2;
    w->motion = NULL;
    nc_motion(w, "G02.4");
    nc_forget(w, NC_X, NC_Z);
    nc_place(p, a->middle);
    nc_rotary(p, half);
    nc_feed(p, move);
    nc_end(w);
    nc_forget(w, NC_X, NC_Z);
    nc_place(p, move->p);
    nc_rotary(p, move->q);
    nc_end(w);
}

static void arc(struct nc_program *p, const struct nc_move *move)
{
    if (!p->plan->arc.item[move->index].plane) {
        arc_in_space(p, move);
        return;
    }
    nc_plane_arc(p, move, vector_address);
    nc_feed(p, move);
    nc_end(&p->w);
}

/* G06.2: a knot and a pole in each block, all axes in each; the last knots in blocks of their
 * own.  The first pole is where the tool stands. */
static void spline(struct nc_program *p, const struct nc_move *move)
{
    const struct nc_spline *s = &p->plan->spline.item[move->index];
    const struct machine_digits *digits = &p->plan->ability.digits;
    struct nc_writer *w = &p->w;
    const struct bspline *b = &s->curve;
    size_t order = (size_t)b->degree + 1;
    w->motion = NULL; /* G06.2 again where one spline follows another: it begins the next */
    nc_motion(w, "G06.2");
    nc_count(w, "P", (double)order);
    for (size_t i = 0; i < b->poles + order; i++) {
        nc_number(w, "K", b->knot[i], digits->knot);
        if (i < b->poles) {
            const double q[] = {RADIANS(s->angle[0][i]), RADIANS(s->angle[1][i])};
            nc_forget(w, NC_X, s->turns ? NC_Q1 : NC_Z);
            nc_place(p, b->pole[i]);
            if (s->turns)
                nc_rotary(p, q);
        }
        if (i == 0)
            nc_feed(p, move);
        nc_end(w);
    }
}

static void hole(struct nc_program *p, const struct nc_move *move)
{
    nc_hole_g(p, move, false);
}

static void dwell(struct nc_program *p, double seconds)
{
    nc_code(&p->w, "G4");
    nc_number(&p->w, "X", seconds, 3);
    nc_end(&p->w);
}

/* Home, without what was switched on for the tool. */
static void leave(struct nc_program *p)
{
    nc_cutcom_off(p);
    nc_minutes(p);
    if (p->machine->smooth)
        nc_template(p, p->machine->blocks.smooth_off, "G05.1 Q0");
    nc_template(p, p->plan->ability.tcp ? p->machine->blocks.tcp_off : "", "G49");
    if (p->plane)
        nc_template(p, p->machine->blocks.plane_off, "G69");
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
    nc_block(w, "M30");
    nc_line(w, "%");
}

const struct dialect dialect_fanuc = {
    .name = "fanuc",
    .style = {.open = "(", .close = ")", .capitals = true, .point = true},
    .digits = {.linear = 3, .angle = 3, .vector = 6, .knot = 3, .feed = 1},
    .vectors_doubtful = true,
    .plane = true,
    .plane_euler = true,
    .arcs = NC_ARCS_CENTRE,
    .arcs_vectors = NC_ARCS_RADIUS,
    .arcs_space = NC_ARCS_BOTH,
    .splines = NC_SPLINES_ROTARY,
    .splines_vectors = NC_SPLINES_NONE,
    .steps_alike = true,
    .check_name = check_name,
    .start = start,
    .load = load,
    .take = take,
    .line = line,
    .arc = arc,
    .spline = spline,
    .hole = hole,
    .hole_end = nc_hole_g_end,
    .dwell = dwell,
    .leave = leave,
    .finish = finish,
};
