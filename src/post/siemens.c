/*
 * siemens - the dialect of the Sinumerik 840D sl and ONE (Siemens, Programming Manual Job Planning,
 * for TRAORI, ORIVECT, ORICURVE, CIP, POLY and BSPLINE).
 */
#include <ctype.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "math/elementary.h"
#include "base/num.h"
#include "dialect.h"
#include "gcode.h"
#include "post_hole.h"
#include "post_words.h"

enum { NAME_MAX_LENGTH = 24 };

static const char *const vector_address[] = {"A3=", "B3=", "C3="};

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

/* The name asked for, else what of PARTNO is allowed. */
static void name(const struct nc_program *p, char *text)
{
    const char *from = p->name ? p->name : p->path->head.partno;
    size_t n = 0;
    for (; from && *from && n < NAME_MAX_LENGTH; from++) {
        unsigned char c = (unsigned char)*from;
        bool good = c < 128 && isalnum(c) && (n > 1 || !isdigit(c));
        if (good || (n && text[n - 1] != '_'))
            text[n++] = good ? (char)toupper(c) : '_';
    }
    while (n && text[n - 1] == '_')
        n--;
    if (n < 2)
        n = (size_t)snprintf(text, NC_NAME_MAX, "PART");
    text[n] = '\0';
    if (p->parts)
        snprintf(text + n, NC_NAME_MAX - n, "_%zu", p->part);
}

static void line(struct nc_program *p, const struct nc_move *move)
{
    gcode_straight(p, move, vector_address);
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
    nc_axis(p, move, vector_address);
    nc_feed(p, move);
    nc_end(w);
}

/* ---- B-splines */

/* PO[X]=(end,a2,a3), to the power that the curve has. */
static void polynomial(struct nc_program *p, const char *axis, double end, const double factor[],
                       int n_factors, int digits)
{
    char word[(NC_POLY_DEGREE + 1) * NUM_MAX];
    size_t n = strlen(axis);
    memcpy(word, "PO[", 3);
    memcpy(word + 3, axis, n);
    memcpy(word + 3 + n, "]=(", 3);
    n += 6;
    n += num_write_short(word + n, end, p->plan->ability.digits.linear, false);
    for (int i = 0; i < n_factors; i++) {
        word[n++] = ',';
        n += num_write_short(word + n, factor[i], digits, false);
    }
    memcpy(word + n, ")", 2);
    nc_code(&p->w, word);
}

/* Those of X Y Z, or of XH YH ZH. */
static void three_polynomials(struct nc_program *p, const char *const axis[3], struct vec3 end,
                              const struct vec3 *factor, int n, int digits)
{
    const double to[] = {end.x, end.y, end.z};
    double f[3][NC_POLY_DEGREE - 1];
    for (int i = 0; i < n; i++) {
        f[0][i] = factor[i].x;
        f[1][i] = factor[i].y;
        f[2][i] = factor[i].z;
    }
    for (int k = 0; k < 3; k++)
        polynomial(p, axis[k], to[k], f[k], n, digits);
}

static void polynomials(struct nc_program *p, const struct nc_spline *s, const struct nc_span *n)
{
    static const char *const tip[] = {"X", "Y", "Z"}, *const head[] = {"XH", "YH", "ZH"};
    int factors = nc_poly_factors(s->degree);
    three_polynomials(p, tip, n->end, n->factor, factors, n->digits);
    if (s->turns)
        three_polynomials(p, head, n->head_end, n->head_factor, factors, n->digits);
    nc_number(&p->w, "PL=", n->h, 6);
}

static void head_words(struct nc_program *p, struct vec3 head)
{
    int digits = p->plan->ability.digits.linear;
    nc_number(&p->w, "XH=", head.x, digits);
    nc_number(&p->w, "YH=", head.y, digits);
    nc_number(&p->w, "ZH=", head.z, digits);
}

/* Of a block that only says again where the tool stands.  At the pole the last digits of its axis
 * may be half a turn, and a curve that is slow there would have it turn as slowly. */
static void standing_feed(struct nc_program *p, const struct nc_move *move)
{
    const struct machine *m = p->machine;
    const double slow = 100; /* mm/min: most curves are slower only beside the pole */
    struct nc_move fast = *move;

    for (int i = 0; i < m->chain.n && move->feed < slow / p->plan->ability.unit; i++)
        fast.feed = i == 0 ? m->rapid[m->letter[i]] : fmin(fast.feed, m->rapid[m->letter[i]]);
    nc_feed(p, &fast);
}

/* The move so many after this one turns the tool by a curve of its head. */
static bool is_head_curve(const struct nc_program *p, const struct nc_move *move, int after)
{
    ptrdiff_t at = move - p->plan->move.item + after;

    if (at < 0 || at >= (ptrdiff_t)p->plan->move.n || p->plan->move.item[at].kind != NC_SPLINE)
        return false;
    return p->plan->spline.item[p->plan->move.item[at].index].turns;
}

/* Where the tool stands already, with the head point as the second curve's start; it also keeps
 * two B-splines apart. */
static void begin_curve(struct nc_program *p, const struct nc_move *move)
{
    const struct nc_spline *s = &p->plan->spline.item[move->index];
    if (!s->turns && strcmp(p->w.motion, "BSPLINE") != 0)
        return;
    p->w.motion = NULL;
    nc_motion(&p->w, "G1");
    if (s->turns) {
        if (!is_head_curve(p, move, -1))
            nc_code(&p->w, "ORICURVE");
        head_words(p, s->head_start);
    }
    standing_feed(p, move);
    nc_end(&p->w);
}

/* Back to vectors. */
static void end_curve(struct nc_program *p, const struct nc_move *move)
{
    nc_forget(&p->w, NC_I, NC_K);
    if (is_head_curve(p, move, 1))
        return;
    nc_motion(&p->w, "G1");
    nc_code(&p->w, "ORIVECT");
    nc_axis(p, move, vector_address);
    standing_feed(p, move);
    nc_end(&p->w);
}

static void spline(struct nc_program *p, const struct nc_move *move)
{
    const struct nc_spline *s = &p->plan->spline.item[move->index];
    struct nc_writer *w = &p->w;
    begin_curve(p, move);
    for (size_t i = 0; i < s->span.n; i++) {
        nc_motion(w, "POLY");
        polynomials(p, s, &s->span.item[i]);
        nc_feed(p, move);
        nc_end(w);
    }
    for (size_t i = 1; s->form == NC_BSPLINE && i < s->curve.poles; i++) {
        if (nc_motion(w, "BSPLINE"))
            nc_code(w, "SD=3");
        nc_forget(w, NC_X, NC_Z);
        nc_place(p, s->curve.pole[i]);
        if (s->turns)
            head_words(p, s->curve.head[i]);
        nc_feed(p, move);
        nc_end(w);
    }
    nc_remember(w, NC_X, move->p.x);
    nc_remember(w, NC_Y, move->p.y);
    nc_remember(w, NC_Z, move->p.z);
    if (s->turns)
        end_curve(p, move);
}

/* ---- drilling cycles */

enum { ARGUMENTS = 17, NAME_ROOM = 20 };

/* A call in one block; an argument that is not a number is left out. */
static void call_cycle(struct nc_program *p, const char *name, int n, const double argument[])
{
    char text[NAME_ROOM + ARGUMENTS * (NUM_MAX + 1)];
    size_t at = strlen(name);
    memcpy(text, name, at);
    for (int i = 0; i < n; i++) {
        text[at++] = i ? ',' : '(';
        if (!isnan(argument[i]))
            at += num_write_short(text + at, argument[i], p->plan->ability.digits.linear, false);
    }
    memcpy(text + at, ")", 2);
    nc_block(&p->w, text);
}

/* The cycle that is called at each place from here on: retract plane, mouth, safety distance,
 * bottom, and what is the kind's own. */
static void begin_cycle(struct nc_program *p, const struct nc_hole *hole)
{
    const struct path_cycle *c = hole->cycle;
    double top = nc_hole_level(hole), bottom = nc_hole_bottom(hole);
    double dwell = c->dwell > 0 ? c->dwell : (double)NAN, feed = hole->feed;
    double rpm = p->tooling.spindle, turns = p->tooling.ccw ? 4 : 3, none = NAN;
    double pitch = nc_hole_pitch(p, hole) * (p->tooling.ccw ? -1 : 1);
    double argument[ARGUMENTS] = {top, hole->mouth.z, hole->clear, bottom, none, dwell};
    if (c->kind == CYCLE_TAP) {
        memcpy(argument + 6, (double[]){turns, none, pitch, 0, rpm, rpm}, 6 * sizeof rpm);
        call_cycle(p, "MCALL CYCLE84", 12, argument);
    } else if (c->kind == CYCLE_BORE) {
        memcpy(argument + 6, (double[]){feed, feed}, 2 * sizeof rpm);
        call_cycle(p, "MCALL CYCLE85", 8, argument);
    } else if (c->kind == CYCLE_DRAG) {
        memcpy(argument + 6, (double[]){turns, 0, 0, 0, 0}, 5 * sizeof rpm);
        call_cycle(p, "MCALL CYCLE86", 11, argument);
    } else if (nc_hole_steps(hole)) {
        double next = c->next > 0 && c->next < c->step ? c->next : c->step;
        double gap = PATH_PECK_GAP / p->plan->ability.unit;
        const double deep[] = {none, c->step, c->step - next, 0,  0, 1, c->kind == CYCLE_DEEP, none,
                               next, gap,     dwell,          gap};
        memcpy(argument + 5, deep, sizeof deep);
        call_cycle(p, "MCALL CYCLE83", ARGUMENTS, argument);
    } else {
        call_cycle(p, c->dwell > 0 ? "MCALL CYCLE82" : "MCALL CYCLE81", c->dwell > 0 ? 6 : 4,
                   argument);
    }
}

static void hole_end(struct nc_program *p)
{
    nc_block(&p->w, "MCALL");
    p->hole = NULL;
    p->w.motion = NULL;
}

static void hole(struct nc_program *p, const struct nc_move *move)
{
    const struct nc_hole *hole = nc_hole_of(p, move);
    struct nc_writer *w = &p->w;
    if (!nc_hole_goes_on(p, move)) {
        if (p->hole)
            hole_end(p);
        nc_feed(p, move);
        nc_end(w);
        begin_cycle(p, hole);
        nc_motion(w, "G0");
    }
    nc_hole_place(p, hole);
    nc_end(w);
    nc_hole_done(p, move);
}

/* ---- the dialect */

const struct dialect dialect_siemens = {
    .digits = {.linear = 5, .angle = 5, .vector = 8, .knot = 5, .feed = 2},
    .vectors = true,
    .tool_named = "=\"%s\"",
    .plane = true,
    .arcs = NC_ARCS_SPACE,
    .arcs_vectors = NC_ARCS_SPACE,
    .splines = NC_SPLINES_NONE,
    .splines_vectors = NC_SPLINES_HEAD,
    .check_name = check_name,
    .name = name,
    .line = line,
    .arc = arc,
    .spline = spline,
    .hole = hole,
    .hole_end = hole_end,
};
