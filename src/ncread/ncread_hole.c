/* ncread_hole - see ncread_hole.h. */
#include "ncread_hole.h"

#include <stdlib.h>
#include <string.h>

#include "ncread_state.h"
#include "math/elementary.h"
#include "base/num.h"

enum { ARGUMENTS = 20, STEPS_MOST = 10000 };

static int go_straight(struct ncread *c, double x, double y, double z, bool rapid,
                       struct error *error)
{
    struct ncread_place to = c->here;
    const double at[] = {x, y, z};
    bool moves = false;
    for (int i = 0; i < 3; i++) {
        to.known[i] = true;
        to.at[i] = at[i];
        moves = moves || at[i] < c->here.at[i] || at[i] > c->here.at[i];
    }
    if (!moves)
        return 0;
    return ncread_go(c, &to, ncread_piece(c, &to), rapid, error);
}

/* At this feed, or at the one that is on where the cycle says none. */
static int go_at_feed(struct ncread *c, double feed, double x, double y, double z,
                      struct error *error)
{
    double on = c->feed;
    c->feed = feed > 0 ? feed : on;
    int result = go_straight(c, x, y, z, false, error);
    c->feed = on;
    return result;
}

int ncread_hole_down(struct ncread *c, const struct ncread_place *at, struct error *error)
{
    const struct ncread_hole *h = &c->hole;
    double x = at->at[0], y = at->at[1];
    /* LinuxCNC's kinematics has no word to leave it by; upright it makes no difference */
    if (c->tcp && !(c->options->dialect == &ncread_linuxcnc && ncread_upright(c)))
        return ncread_error(c, error, "a drilling cycle under tool centre point control");
    if (!c->here.known[0] || !c->here.known[1] || !c->here.known[2])
        return ncread_error(c, error, "a drilling cycle from a place that is not known");
    if (!(h->bottom < h->clear && h->clear <= h->level + 1e-9))
        return ncread_error(c, error, "a drilling cycle whose heights are not in order");
    if (c->here.at[2] < h->clear - 1e-9)
        return ncread_error(c, error, "a drilling cycle from below its clear height");
    if (go_straight(c, x, y, c->here.at[2], true, error) < 0 ||
        go_straight(c, x, y, h->clear, true, error) < 0 ||
        go_at_feed(c, h->feed, x, y, h->bottom, error) < 0)
        return -1;
    c->motion->dwell += h->dwell / 60;
    if (h->slow && go_at_feed(c, h->back, x, y, h->clear, error) < 0)
        return -1;
    return go_straight(c, x, y, h->level, true, error);
}

bool ncread_hole_dwell(struct ncread *c, double unit)
{
    bool dwell = false;
    double seconds = 0;
    for (size_t i = 0; i < c->words.n; i++) {
        const struct ncread_word *w = &c->words.item[i];
        if (w->kind != WORD_ADDRESS)
            continue;
        dwell = dwell || (w->name[0] == 'G' && w->value[0] == 4);
        if (strchr("XFPK", w->name[0]))
            seconds = w->value[0] * (w->name[0] == 'P' ? unit : 1);
    }
    if (dwell)
        c->motion->dwell += seconds / 60;
    return dwell;
}

/* ---- Fanuc and LinuxCNC */
bool ncread_hole_code(struct ncread *c, int code)
{
    static const int slow[] = {740, 840, 850, 890}, fast[] = {730, 810, 820, 830, 860};
    struct ncread_hole *h = &c->hole;
    bool is_slow = false, is_fast = false;
    for (size_t i = 0; i < sizeof slow / sizeof *slow; i++)
        is_slow = is_slow || code == slow[i];
    for (size_t i = 0; i < sizeof fast / sizeof *fast; i++)
        is_fast = is_fast || code == fast[i];
    if (code == 980 || code == 990) {
        h->high = code == 980;
        return true;
    }
    if (code == 800 || (code >= 0 && code <= 30)) { /* G0 to G3 cancel it too */
        h->on = false;
        return code == 800;
    }
    if (!is_slow && !is_fast)
        return false;
    if (!h->on) {
        h->level = c->here.at[2];
        h->pause = 0;
    }
    h->on = true;
    h->slow = is_slow;
    h->waits = code == 740 || code == 820 || code == 840 || code == 860 || code == 890;
    return true;
}

/*
 * Z and R of a block, NULL: it has none, under G91 counted from where the cycle began and from R.
 * Heights once set stay when G90 or G91 changes between holes; LinuxCNC counts its words anew, from
 * where the tool is.
 */
static int set_heights(struct ncread *c, const struct ncread_word *z, const struct ncread_word *r,
                       struct error *error)
{
    struct ncread_hole *h = &c->hole;
    bool by = !c->absolute, anew = c->options->dialect == &ncread_linuxcnc;
    if (!z && !r && !anew)
        return 0;
    if (h->by != by && !(z && r))
        return ncread_error(c, error, "a drilling cycle without its Z and R after G90 or G91");
    h->by = by;
    if (z)
        h->z = z->value[0];
    if (r)
        h->r = r->value[0];
    h->clear = by ? (anew ? c->here.at[2] : h->level) + h->r : h->r;
    h->bottom = by ? h->clear + h->z : h->z;
    return 0;
}

int ncread_hole_block(struct ncread *c, struct ncread_place *to, double unit, struct error *error)
{
    struct ncread_hole *h = &c->hole;
    const struct ncread_word *z = ncread_word_find(&c->words, "Z");
    const struct ncread_word *r = ncread_word_find(&c->words, "R");
    const struct ncread_word *p = ncread_word_find(&c->words, "P");
    double level = h->level;
    if (c->plane != 17 || !c->said)
        return ncread_error(c, error, "a drilling cycle outside G17, or before G90 or G91");
    if (set_heights(c, z, r, error) < 0)
        return -1;
    if (p)
        h->pause = p->value[0] * unit;
    h->dwell = h->waits ? h->pause : 0;
    if (!h->high)
        h->level = h->clear;
    int result = ncread_hole_down(c, to, error);
    h->level = level;
    return result;
}

/* ---- Siemens */

/* The numbers in the brackets of a call; NAN: left out.  How many. */
static int read_arguments(const char *s, double value[ARGUMENTS])
{
    int n = 0;
    for (int i = 0; i < ARGUMENTS; i++)
        value[i] = NAN;
    if (!s)
        return 0;
    for (s++; n < ARGUMENTS; s++) {
        num_read(&s, &value[n++]);
        if (*s != ',')
            break;
    }
    return n;
}

/* What is said and above zero, else `other`. */
static double or_else(double value, double other)
{
    return value > 0 ? value : other;
}

/* Steps to this depth, each shorter than the one before by `less` down to `least`. */
static double step_count(double depth, double first, double less, double least)
{
    int n = 1;
    double step = first, at = first;
    while (step > 0 && at < depth - 1e-9 && n < STEPS_MOST) {
        n++;
        step = fmax(step - or_else(less, 0), fmin(or_else(least, 0), first));
        at += step;
    }
    return n;
}

/* CYCLE83 waits at the bottom, at the end of each step, and above each but the first. */
static double deep_dwell(const double *v)
{
    double depth = v[1] - v[3], first = isnan(v[5]) ? v[6] : v[1] - v[5];
    double between = step_count(depth, first, v[7], v[13]) - 1, each = or_else(v[8], 0);
    double above = v[11] > 0 ? or_else(v[9], 0) : 0;
    return between * (each + above) + or_else(v[15], each);
}

int ncread_hole_call(struct ncread *c, const char *name, struct error *error)
{
    double v[ARGUMENTS];
    const char *call = strstr(c->text, name);
    struct ncread_hole *h = &c->hole;
    int n = read_arguments(call ? strchr(call, '(') : NULL, v);
    if (!strstr(c->text, "MCALL "))
        return ncread_error(c, error, "a drilling cycle without MCALL");
    if (n < 4 || isnan(v[0]) || isnan(v[1]) || isnan(v[2]) || isnan(v[3]))
        return ncread_error(c, error, "a drilling cycle without its four heights");
    h->on = true;
    h->level = v[0];
    h->clear = v[1] + v[2];
    h->bottom = v[3];
    h->slow = name[6] == '4' || name[6] == '5';
    h->dwell = name[6] == '3' ? deep_dwell(v) : name[6] == '1' ? 0 : or_else(v[5], 0);
    h->feed = name[6] == '4' ? fabs(v[8]) * v[10] : name[6] == '5' ? or_else(v[6], 0) : 0;
    h->back = name[6] == '5' ? or_else(v[7], 0) : h->feed;
    if (name[6] == '3' && isnan(v[5]) && !(v[6] > 0))
        return ncread_error(c, error, "CYCLE83 without its first step");
    if (name[6] == '4' && (isnan(v[8]) || v[8] == 0 || !(v[10] > 0)))
        return ncread_error(c, error, "CYCLE84 without its pitch or speed");
    return 0;
}

/* ---- Heidenhain */
void ncread_hole_define(struct ncread *c, const char *number)
{
    long n = strtol(number, NULL, 10);
    if (n < 200 || n > 207)
        return;
    c->hole.cycle = (int)n;
    for (int i = 0; i < NCREAD_Q; i++)
        c->hole.q[i] = NAN;
}

int ncread_hole_parameter(struct ncread *c, const char *line, struct error *error)
{
    const char *s = line + strspn(line, " ");
    char *end;
    double value;
    long q = *s == 'Q' ? strtol(s + 1, &end, 10) : -1;
    c->hole.lines++;
    if (q < 200 || q >= NCREAD_Q || *end != '=')
        return ncread_error(c, error, "a continuation line without a Q parameter");
    s = end + 1;
    if (!num_read(&s, &value))
        return ncread_error(c, error, "a Q parameter without a number");
    c->hole.q[q] = value;
    return 0;
}

int ncread_hole_m99(struct ncread *c, const struct ncread_place *to, struct error *error)
{
    struct ncread_hole *h = &c->hole;
    const double *q = h->q;
    if (!h->cycle || isnan(q[200]) || isnan(q[201]) || isnan(q[203]) || isnan(q[204]))
        return ncread_error(c, error, "M99 without a cycle and its heights");
    h->clear = q[203] + q[200];
    h->bottom = q[203] + q[201];
    h->level = q[204] > q[200] ? q[203] + q[204] : h->clear;
    h->slow = h->cycle == 201 || h->cycle == 207;
    h->feed = h->cycle == 207 ? fabs(q[239]) * c->speed : q[206];
    h->back = h->cycle == 201 ? or_else(q[208], h->feed) : h->feed;
    double above =
        step_count(-q[201], q[202], q[212], q[205]) - 1; /* as often the tool is drawn up */
    h->dwell = or_else(q[211], 0) + floor(above / (or_else(q[213], 0) + 1)) * or_else(q[210], 0);
    return ncread_hole_down(c, to, error);
}
