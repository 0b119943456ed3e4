/*
 * fanuc - the dialect of the Fanuc 30i family (B-64484EN, Fanuc's manual of the 30i, for G43.4,
 * G43.5, G02.4 and G06.2): the common G-code (gcode.h), arcs in space and NURBS.
 */
#include <stdio.h>
#include <string.h>

#include "gcode.h"
#include "post_words.h"

static int check_name(const char *name, struct error *error)
{
    size_t n = strlen(name);
    if (n && n <= 8 && strspn(name, "0123456789") == n && strspn(name, "0") < n)
        return 0;
    return error_set(error, "option --program: found `%.40s`, expected a number of 1 to 8 digits",
                     name);
}

/* Its number. */
static void name(const struct nc_program *p, char *text)
{
    snprintf(text, NC_NAME_MAX, "%s", p->name ? p->name : "1");
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
    if (p->plan->arc.item[move->index].plane)
        gcode_arc(p, move);
    else
        arc_in_space(p, move);
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

static const struct gcode words = {};

const struct dialect dialect_fanuc = {
    .gcode = &words,
    .digits = {.linear = 3, .angle = 3, .vector = 6, .knot = 3, .feed = 1},
    .vectors_doubtful = true,
    .plane = true,
    .plane_angles = NC_PLANE_EULER,
    .arcs = NC_ARCS_CENTRE,
    .arcs_vectors = NC_ARCS_RADIUS,
    .arcs_space = NC_ARCS_BOTH,
    .splines = NC_SPLINES_ROTARY,
    .splines_vectors = NC_SPLINES_NONE,
    .steps_alike = true,
    .check_name = check_name,
    .name = name,
    .line = gcode_line,
    .arc = arc,
    .spline = spline,
    .hole = gcode_hole,
    .hole_end = gcode_hole_end,
};
