/*
 * heidenhain - Klartext of the TNC 640 (Heidenhain, TNC 640 User's Manual for Conversational
 * Programming: FUNCTION TCPM, LN, CC and C, cycles 9 and 32).
 *
 * Rotary words turn evenly under PATHCTRL AXIS.  LN carries the tool axis as TX TY TZ; which of the
 * two ways the axis goes between them depends on the control's version, so blocks keep to both.
 * Arcs are given in the working plane alone, with the tool axis still.  There is no inverse time.
 */
#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "math/elementary.h"
#include "base/num.h"
#include "dialect.h"
#include "gcode.h"
#include "post_hole.h"
#include "post_statement.h"
#include "post_words.h"

enum { NAME_MAX_LENGTH = 24 };

static const char *const cutcom_word[] = {"R0", "RL", "RR"};
static const char *const vector_address[] = {"TX", "TY", "TZ"};

static bool allowed_in_names(unsigned char c)
{
    return c < 128 && (isalnum(c) || c == '_' || c == '-');
}

static int check_name(const char *name, struct error *error)
{
    size_t n = strlen(name);
    bool good = n >= 1 && n <= NAME_MAX_LENGTH;
    for (size_t i = 0; i < n; i++)
        good = good && allowed_in_names((unsigned char)name[i]);
    if (good)
        return 0;
    return error_set(error,
                     "option --program: found `%.40s`, expected 1 to %d letters, digits, _ and -",
                     name, NAME_MAX_LENGTH);
}

/* The name asked for, else what of PARTNO is allowed. */
static void name(const struct nc_program *p, char *text)
{
    const char *from = p->name ? p->name : p->path->head.partno;
    size_t n = 0;
    for (; from && *from && n < NAME_MAX_LENGTH; from++) {
        bool good = allowed_in_names((unsigned char)*from);
        if (good || (n && text[n - 1] != '_'))
            text[n++] = good ? (char)toupper((unsigned char)*from) : '_';
    }
    while (n && text[n - 1] == '_')
        n--;
    if (!n)
        n = (size_t)snprintf(text, NC_NAME_MAX, "PART");
    text[n] = '\0';
    if (p->parts)
        snprintf(text + n, NC_NAME_MAX - n, "_%zu", p->part);
}

/* L X Y Z A C F, or LN X Y Z TX TY TZ F; a block without a place or axis says nothing. */
static void line(struct nc_program *p, const struct nc_move *move)
{
    struct nc_writer *w = &p->w;
    bool vectors = p->plan->ability.mode == INTERPOLATE_VECTOR;
    const char *cutcom = nc_cutcom_word(p, move, cutcom_word);
    if (vectors)
        nc_forget(w, NC_X, NC_K);
    nc_code(w, vectors ? "LN" : "L");
    size_t bare = w->n;
    nc_place(p, move->p);
    nc_axis(p, move, vector_address);
    if (cutcom)
        nc_code(w, cutcom);
    if (w->n == bare)
        nc_drop(w);
    else if (move->kind == NC_RAPID)
        nc_code(w, "FMAX");
    else
        nc_feed(p, move);
    nc_end(w);
}

/* CC X Y, then C X Y DR+ */
static void arc(struct nc_program *p, const struct nc_move *move)
{
    const struct nc_arc *a = &p->plan->arc.item[move->index];
    int digits = p->plan->ability.digits.linear;
    struct nc_writer *w = &p->w;
    nc_code(w, "CC");
    nc_number(w, "X", w->value[NC_X] + a->centre.x, digits);
    nc_number(w, "Y", w->value[NC_Y] + a->centre.y, digits);
    nc_end(w);
    nc_code(w, "C");
    nc_forget(w, NC_X, NC_Y);
    nc_modal(w, NC_X, "X", move->p.x, digits);
    nc_modal(w, NC_Y, "Y", move->p.y, digits);
    nc_code(w, a->ccw ? "DR+" : "DR-");
    nc_feed(p, move);
    nc_end(w);
}

/* A speed is the tool call's to say. */
static void speed(struct nc_program *p, double rpm, bool ccw)
{
    nc_code(&p->w, "TOOL CALL");
    nc_count(&p->w, "S", rpm);
    nc_end(&p->w);
    nc_block(&p->w, ccw ? "M4" : "M3");
}

/* ---- drilling cycles */

enum { PARAMETERS = 16, LINE = NUM_MAX + 60, CHIP_BREAKS = 99, FASTEST = 99999 };

/* One Q parameter of a cycle. */
struct parameter {
    int q;
    double value;
    const char *says;
};

/* A definition goes on in the next line after ~. */
static void define_cycle(struct nc_program *p, const char *name, int n,
                         const struct parameter *parameter)
{
    char line[LINE];
    int digits = p->plan->ability.digits.linear;
    nc_code(&p->w, name);
    for (int i = 0; i < n; i++) {
        nc_code(&p->w, "~");
        size_t at = 4;
        memcpy(line, "    Q", 5);
        at += 1 + num_write(line + 5, parameter[i].q, 0);
        line[at++] = '=';
        if (num_round(parameter[i].value, digits) >= 0)
            line[at++] = '+';
        at += num_write_short(line + at, parameter[i].value, digits, false);
        memcpy(line + at, " ;", 2);
        memcpy(line + at + 2, parameter[i].says, strlen(parameter[i].says) + 1);
        nc_continue(&p->w, line);
    }
    nc_end(&p->w);
}

static void begin_cycle(struct nc_program *p, const struct nc_hole *hole)
{
    const struct path_cycle *c = hole->cycle;
    bool down = c->next > 0 && c->next < c->step;
    double next = down ? c->next : c->step, less = down ? c->step - c->next : 0;
    double above = hole->retract > hole->clear ? hole->retract : 0,
           gap = PATH_PECK_GAP / p->plan->ability.unit;
    const struct parameter clear = {200, hole->clear, "SET-UP CLEARANCE"},
                           depth = {201, -hole->depth, "DEPTH"},
                           feed = {206, hole->feed, "FEED RATE FOR PLNGNG"},
                           step = {202, nc_hole_steps(hole) ? c->step : hole->depth,
                                   "PLUNGING DEPTH"},
                           mouth = {203, hole->mouth.z, "SURFACE COORDINATE"},
                           second = {204, above, "2ND SET-UP CLEARANCE"},
                           dwell = {211, c->dwell, "DWELL TIME AT DEPTH"},
                           top = {210, 0, "DWELL TIME AT TOP"}, smaller = {212, less, "DECREMENT"},
                           least = {205, next, "MIN. PLUNGING DEPTH"},
                           out = {208, c->kind == CYCLE_BORE ? hole->feed : FASTEST,
                                  "RETRACTION FEED RATE"},
                           back = {256, gap, "DIST FOR CHIP BRKNG"};
    if (c->kind == CYCLE_TAP)
        define_cycle(p, "CYCL DEF 207 RIGID TAPPING", 5,
                     (struct parameter[]){
                         clear,
                         depth,
                         {239, nc_hole_pitch(p, hole) * (p->tooling.ccw ? -1 : 1), "THREAD PITCH"},
                         mouth,
                         second});
    else if (c->kind == CYCLE_BORE)
        define_cycle(p, "CYCL DEF 201 REAMING", 7,
                     (struct parameter[]){clear, depth, feed, dwell, out, mouth, second});
    else if (c->kind == CYCLE_DRAG)
        define_cycle(p, "CYCL DEF 202 BORING", 9,
                     (struct parameter[]){clear,
                                          depth,
                                          feed,
                                          dwell,
                                          out,
                                          mouth,
                                          second,
                                          {214, 0, "DISENGAGING DIRECTN"},
                                          {336, 0, "ANGLE OF SPINDLE"}});
    else if (nc_hole_steps(hole) && c->kind == CYCLE_DEEP)
        define_cycle(p, "CYCL DEF 205 UNIVERSAL PECKING", PARAMETERS,
                     (struct parameter[]){clear,
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
        define_cycle(p, "CYCL DEF 203 UNIVERSAL DRILLING", 13,
                     (struct parameter[]){clear,
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
        define_cycle(p, "CYCL DEF 200 DRILLING", 8,
                     (struct parameter[]){clear, depth, feed, step, top, mouth, second, dwell});
}

static void hole(struct nc_program *p, const struct nc_move *move)
{
    const struct nc_hole *hole = nc_hole_of(p, move);
    struct nc_writer *w = &p->w;
    if (!nc_hole_goes_on(p, move))
        begin_cycle(p, hole);
    nc_code(w, "L");
    nc_hole_place(p, hole);
    nc_code(w, "R0 FMAX M99");
    nc_end(w);
    nc_hole_done(p, move);
}

static void hole_end(struct nc_program *p)
{
    p->hole = NULL; /* M99 calls once: nothing is on */
}

/* ---- the dialect */

const struct dialect dialect_heidenhain = {
    .digits = {.linear = 4, .angle = 4, .vector = 7, .knot = 3, .feed = 1},
    .vectors_doubtful = true,
    .tool_named = "\"%s\"",
    .inverse_never = true,
    .plane = true,
    .plane_angles = NC_PLANE_SPATIAL,
    .arcs = NC_ARCS_FLAT,
    .arcs_vectors = NC_ARCS_FLAT,
    .splines = NC_SPLINES_NONE,
    .splines_vectors = NC_SPLINES_NONE,
    .check_name = check_name,
    .name = name,
    .line = line,
    .arc = arc,
    .hole = hole,
    .hole_end = hole_end,
    .speed = speed,
};
