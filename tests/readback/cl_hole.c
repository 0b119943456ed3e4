/* Drilling cycles of a CL file as the motions that they stand for: see cl_state.h. */
#include <string.h>

#include "cl_state.h"

#define USUAL_CLEAR 1  /* mm above the mouth, where none is given */
#define PECK_GAP 0.254 /* mm above the last bottom, where a step begins: LinuxCNC's for G83 */

static const struct {
    const char *word;
    enum cl_hole_kind kind;
} kinds[] = {{"DRILL", HOLE_DRILL},  {"FACE", HOLE_DRILL},   {"CSINK", HOLE_DRILL},
             {"DEEP", HOLE_DEEP},    {"DEEP2", HOLE_DEEP},   {"PECK", HOLE_DEEP},
             {"BRKCHP", HOLE_BREAK}, {"TAP", HOLE_TAP},      {"BORE", HOLE_BORE},
             {"REAM", HOLE_BORE},    {"DRAG", HOLE_STOPPED}, {"MANUAL", HOLE_STOPPED}};

static int kind_of(const char *word)
{
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (strcmp(kinds[i].word, word) == 0)
            return (int)kinds[i].kind;
    return -1;
}

/* The number after one of two names; NAN: there is none. */
static double named(const struct cl_statement *t, const char *name, const char *other)
{
    double value;
    for (size_t i = 0; i < t->argument.n; i++) {
        const char *text = t->argument.item[i].text;
        if ((strcmp(text, name) == 0 || strcmp(text, other) == 0) &&
            cl_numbers(t, i + 1, 1, &value) == 1)
            return value;
    }
    return NAN;
}

static double or_else(double value, double otherwise)
{
    return isnan(value) ? otherwise : value;
}

/* Without any name: depth, feed, clearance, step; of a tap, when there are four, the clearance is
 * the last. */
static void take_unnamed(struct cl_state *s, double *depth, double *clear, double *step)
{
    double v[4];
    size_t n = cl_numbers(s->statement, 1, 4, v);
    size_t at = n == 4 && s->hole.kind == HOLE_TAP ? 3 : 2;
    if (n > 0)
        *depth = v[0];
    if (n > at)
        *clear = v[at];
    if (n > 3 && at == 2)
        *step = v[3];
}

static int begin_cycle(struct cl_state *s, int kind)
{
    const struct cl_statement *t = s->statement;
    struct cl_hole *h = &s->hole;
    double depth = named(t, "DEPTH", "FEDTO"), clear = named(t, "CLEAR", "CLEAR");
    double rapid = named(t, "RAPTO", "RAPTO"), step = named(t, "STEP", "INCR");
    double leave = named(t, "RTRCTO", "RETURN");
    size_t leaving = cl_find(t, "RTRCTO");
    *h = (struct cl_hole){.on = true, .kind = (enum cl_hole_kind)kind, .before = s->at};
    for (size_t i = 1; i < t->argument.n; i++)
        if (kind_of(t->argument.item[i].text) >= 0)
            h->kind = (enum cl_hole_kind)kind_of(t->argument.item[i].text);
    take_unnamed(s, &depth, &clear, &step);
    step = or_else(step, named(t, "1STPECK", "1STPECK"));
    bool automatic =
        leaving + 1 < t->argument.n && strcmp(t->argument.item[leaving + 1].text, "AUTO") == 0;
    h->home = s->known && (automatic || (s->creo && leave == 0));
    if (isnan(depth) || depth == 0)
        return cl_wrong(s, "CYCLE without its depth");
    h->depth = fabs(s->unit * depth);
    h->step = s->unit * or_else(step, 0);
    h->next = s->unit * or_else(named(t, "SUBPECK", "SUBPECK"), or_else(step, 0));
    for (size_t i = cl_find(t, "STEP") + 2; i < t->argument.n && t->argument.item[i].is_number; i++)
        h->next = fmin(h->next, s->unit * t->argument.item[i].number);
    bool further = s->creo && !isnan(clear) && !isnan(rapid); /* RAPTO is so much below CLEAR */
    h->clear = further ? s->unit * (clear - rapid)
                       : or_else(s->unit * rapid, or_else(s->unit * clear, USUAL_CLEAR));
    double least = h->clear < 0 ? USUAL_CLEAR : h->clear;
    double usual = fmax(least, or_else(s->unit * clear, least));
    h->retract = fmax(fmax(h->clear, 0), or_else(s->unit * leave, usual));
    return 0;
}

int cl_read_cycle(struct cl_state *s)
{
    const struct cl_statement *t = s->statement;
    const char *what = t->argument.n ? t->argument.item[0].text : "";
    if (kind_of(what) >= 0)
        return begin_cycle(s, kind_of(what));
    if (strcmp(what, "OFF") != 0 && strcmp(what, "INIT") != 0 && strcmp(what, "NOMORE") != 0)
        return cl_wrong(s, "CYCLE of a kind that is not known");
    s->hole.on = false;
    return 0;
}

/* To a height above the mouth; nothing where the tool is there. */
static void go_to_height(struct cl_state *s, struct vec3 mouth, struct vec3 axis, double height,
                         bool rapid)
{
    struct vec3 to = vec_along(mouth, height, axis);
    if (!s->known || vec_distance(to, s->at) > 0 || vec_distance(axis, s->axis) > 0)
        cl_straight(s, to, axis, rapid);
}

static void go_down(struct cl_state *s, struct vec3 mouth, struct vec3 axis)
{
    const struct cl_hole *h = &s->hole;
    bool steps = h->kind == HOLE_DEEP || h->kind == HOLE_BREAK;
    double step = steps ? h->step : 0, deep = 0;
    while (step > 0 && deep + step < h->depth - 1e-6) {
        double gap = fmin(step / 2, PECK_GAP);
        deep += step;
        go_to_height(s, mouth, axis, -deep, false);
        if (h->kind == HOLE_DEEP)
            go_to_height(s, mouth, axis, h->clear, true);
        go_to_height(s, mouth, axis, gap - deep, true);
        step = h->next;
    }
    go_to_height(s, mouth, axis, -h->depth, false);
}

int cl_drill(struct cl_state *s, struct vec3 mouth, struct vec3 axis)
{
    const struct cl_hole *h = &s->hole;
    double leave = h->retract, level;
    if (h->home) {
        double height = vec_dot(vec_sub(h->before, mouth), axis);
        leave = height > h->clear && height > 0 ? height : leave;
    }
    level = leave;
    if (s->known && vec_distance(s->axis, axis) < 1e-9) {
        double height = vec_dot(vec_sub(s->at, mouth), axis);
        if (height < level) /* up before it goes over */
            cl_straight(s, vec_along(s->at, level - height, axis), axis, true);
        level = fmax(level, height);
    }
    go_to_height(s, mouth, axis, level, true);
    go_to_height(s, mouth, axis, leave, true);
    go_to_height(s, mouth, axis, h->clear, true);
    go_down(s, mouth, axis);
    if (h->kind == HOLE_TAP || h->kind == HOLE_BORE)
        go_to_height(s, mouth, axis, h->clear, false);
    go_to_height(s, mouth, axis, leave, true);
    s->rapid = false;
    return 0;
}
