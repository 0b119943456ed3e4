/*
 * heidenhain - Klartext of the TNC 640 (Heidenhain, TNC 640 User's Manual for Conversational
 * Programming: FUNCTION TCPM, LN, CC and C, cycles 9 and 32).
 *
 * Rotary words turn evenly under PATHCTRL AXIS.  LN carries the tool axis as TX TY TZ; which of the
 * two ways the axis goes between them depends on the control's version, so blocks keep to both.
 * Arcs are given in the working plane alone, with the tool axis still.  There is no inverse time.
 */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/num.h"
#include "dialect.h"
#include "gcode.h"
#include "post_head.h"
#include "post_hole.h"
#include "post_statement.h"
#include "post_words.h"

enum { NAME_MAX_LENGTH = 24 };

static const char *const cutcom_word[] = {"R0", "RL", "RR"};
static const char *const vector_address[] = {"TX", "TY", "TZ"};

static const char home[] = "L Z+0 R0 FMAX M91";

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

/* BEGIN PGM NAME MM: the name asked for, else what of PARTNO is allowed. */
static void program_line(struct nc_program *p, const char *word)
{
    char name[NAME_MAX_LENGTH + 1] = "", line[NAME_MAX_LENGTH + 60];
    const char *from = p->name ? p->name : p->path->head.partno;
    size_t n = 0;
    for (; from && *from && n < NAME_MAX_LENGTH; from++) {
        bool good = allowed_in_names((unsigned char)*from);
        if (good || (n && name[n - 1] != '_'))
            name[n++] = good ? (char)toupper((unsigned char)*from) : '_';
    }
    while (n && name[n - 1] == '_')
        n--;
    name[n] = '\0';
    char part[24] = "";
    if (p->parts)
        snprintf(part, sizeof part, "_%zu", p->part);
    snprintf(line, sizeof line, "%s PGM %s%s %s", word, n ? name : "PART", part,
             p->plan->ability.unit > 1 ? "INCH" : "MM");
    nc_block(&p->w, line);
}

/* L A+0 C+0 R0 FMAX */
static void rotary_rapid(struct nc_program *p, const double q[])
{
    if (!p->machine->chain.n)
        return;
    nc_forget(&p->w, NC_Q0, NC_Q1);
    nc_code(&p->w, "L");
    nc_rotary(p, q);
    nc_code(&p->w, "R0 FMAX");
    nc_end(&p->w);
}

/* L X Y R0 FMAX, at the height where the tool is. */
static void go_across(struct nc_program *p, struct vec3 to)
{
    int digits = p->plan->ability.digits.linear;
    nc_code(&p->w, "L");
    nc_modal(&p->w, NC_X, "X", to.x, digits);
    nc_modal(&p->w, NC_Y, "Y", to.y, digits);
    nc_code(&p->w, "R0 FMAX");
    nc_end(&p->w);
}

static void call_tool(struct nc_program *p)
{
    if (*p->machine->blocks.tool_change) {
        nc_template(p, p->machine->blocks.tool_change, "");
        return;
    }
    nc_code(&p->w, "TOOL CALL");
    if (p->tooling.number)
        nc_count(&p->w, "", p->tooling.number);
    nc_code(&p->w, "Z");
    if (p->tooling.spindle > 0)
        nc_count(&p->w, "S", p->tooling.spindle);
    nc_end(&p->w);
}

static void start(struct nc_program *p)
{
    struct nc_writer *w = &p->w;
    program_line(p, "BEGIN");
    nc_head(p);
    nc_offset(p, "");
    nc_end(w);
    nc_template(p, p->machine->blocks.safe,
                !p->turned        ? ""
                : p->machine->tcp ? "FUNCTION RESET TCPM|PLANE RESET STAY"
                                  : "PLANE RESET STAY");
    nc_template(p, p->machine->blocks.start, "");
    nc_home(p, home);
}

static void load(struct nc_program *p)
{
    call_tool(p);
    if (p->tooling.spindle > 0)
        nc_block(&p->w, p->tooling.ccw ? "M4" : "M3");
}

/* The rotary axes where nothing is near. */
static void turn_at_home(struct nc_program *p, const struct nc_move *first)
{
    if (!p->machine->chain.n)
        return;
    nc_forget(&p->w, NC_Q0, NC_Q1);
    nc_code(&p->w, "L");
    nc_rotary_start(p, first);
    nc_code(&p->w, "R0 FMAX");
    nc_end(&p->w);
}

/* L C+90 R0 FMAX, where an axis is not there yet. */
static void turn_above(struct nc_program *p, const struct nc_move *first)
{
    nc_code(&p->w, "L");
    size_t bare = p->w.n;
    nc_rotary(p, first->q);
    if (p->w.n == bare)
        nc_drop(&p->w);
    else
        nc_code(&p->w, "R0 FMAX");
    nc_end(&p->w);
}

/* From home to the first place, as gcode_engage. */
static void engage(struct nc_program *p)
{
    const char *smooth = "CYCL DEF 32.0 TOLERANCE|CYCL DEF 32.1 T{tolerance}|"
                         "CYCL DEF 32.2 HSC-MODE:0 TA{orientation}";
    struct nc_writer *w = &p->w;
    const struct nc_move *first = nc_first_move(p);
    turn_at_home(p, first);
    if (p->plane) {
        go_across(p, nc_above_plane(p, first));
        nc_template(p, p->machine->blocks.plane_on, "PLANE SPATIAL SPA{a} SPB{b} SPC+0 TURN FMAX");
        nc_forget(w, NC_X, NC_Z);
    }
    if (p->plan->ability.tcp)
        nc_template(p, p->machine->blocks.tcp_on,
                    p->plan->ability.mode == INTERPOLATE_VECTOR
                        ? "FUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR"
                        : "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS");
    nc_coolant(p);
    if (p->machine->smooth)
        nc_template(p, p->machine->blocks.smooth_on, smooth);
    go_across(p, first->p);
    nc_code(w, "L");
    nc_modal(w, NC_Z, "Z", first->p.z, p->plan->ability.digits.linear);
    nc_code(w, "R0 FMAX");
    nc_end(w);
    if (nc_zero_first(p))
        turn_above(p, first);
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

static void dwell(struct nc_program *p, double seconds)
{
    nc_block(&p->w, "CYCL DEF 9.0 DWELL TIME");
    nc_code(&p->w, "CYCL DEF 9.1 DWELL");
    nc_number(&p->w, "", seconds, 3);
    nc_end(&p->w);
}

/* Home, without what was switched on for the tool. */
static void disengage(struct nc_program *p)
{
    nc_cutcom_end(p); /* by R0 of the way home */
    if (p->machine->smooth)
        nc_template(p, p->machine->blocks.smooth_off, "CYCL DEF 32.0 TOLERANCE|CYCL DEF 32.1");
    if (p->plan->ability.tcp)
        nc_template(p, p->machine->blocks.tcp_off, "FUNCTION RESET TCPM");
    if (p->plane)
        nc_template(p, p->machine->blocks.plane_off, "PLANE RESET TURN FMAX");
    nc_home(p, home);
}

static void finish(struct nc_program *p)
{
    const double zero[ROTARY_MAX] = {0};
    rotary_rapid(p, zero);
    nc_block(&p->w, "M9");
    nc_block(&p->w, "M5");
    nc_template(p, p->machine->blocks.end, "");
    nc_block(&p->w, "M30");
    program_line(p, "END");
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
    .style = {.open = "; ", .close = "", .sign = true, .count_all = true},
    .digits = {.linear = 4, .angle = 4, .vector = 7, .knot = 3, .feed = 1},
    .vectors_doubtful = true,
    .inverse_never = true,
    .plane = true,
    .arcs = NC_ARCS_FLAT,
    .arcs_vectors = NC_ARCS_FLAT,
    .splines = NC_SPLINES_NONE,
    .splines_vectors = NC_SPLINES_NONE,
    .check_name = check_name,
    .start = start,
    .load = load,
    .engage = engage,
    .line = line,
    .arc = arc,
    .hole = hole,
    .hole_end = hole_end,
    .speed = speed,
    .dwell = dwell,
    .disengage = disengage,
    .finish = finish,
};
