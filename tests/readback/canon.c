/*
 * canon - what LinuxCNC's own interpreter makes of a program: the canonical calls that
 * `rs274 -g` prints, one a line.
 *
 *     45 N140   ARC_FEED(20.9802, 0.0482, 19.9995, 10.0000, 1, 0.0000, 14.1154, 0.0000, 86.1097)
 *
 * X Y Z count from when the tool's length is on (the table gives it one).
 */
#include <stdlib.h>
#include <string.h>

#include "ncread/ncread_state.h"
#include "base/num.h"

enum { NUMBERS = 9 };

/* The numbers in brackets: how many. */
static int numbers(const char *s, double value[NUMBERS])
{
    int n = 0;
    for (s += strcspn(s, "(") + 1; n < NUMBERS && *s && *s != ')'; s += strspn(s, ", "))
        if (num_read(&s, &value[n]))
            n++;
        else
            s += strcspn(s, ",)");
    return n;
}

static int set(struct ncread *c, const double v[3], const double turn[3], struct ncread_place *to)
{
    static const char *const name[] = {"X", "Y", "Z", "A", "B", "C"};
    for (int i = 0; i < 6; i++)
        ncread_axis(c, name[i], i < 3 ? v[i] : turn[i - 3], to);
    ncread_turned(c, to);
    return 0;
}

static int go(struct ncread *c, const struct ncread_place *to, struct nc_piece piece, bool rapid,
              struct error *error)
{
    if (c->order) /* the length is on */
        return ncread_go(c, to, piece, rapid, error);
    c->here = *to;
    memset(c->here.known, 0, sizeof c->here.known);
    return rapid ? 0 : ncread_error(c, error, "cuts without the tool's length");
}

static int arc(struct ncread *c, const double v[NUMBERS], struct error *error)
{
    /* first and second axis of the plane, and the one across */
    int first = c->plane == 17 ? 0 : c->plane == 18 ? 2 : 1, second = (first + 1) % 3;
    int across = (first + 2) % 3;
    double end[3], centre[3];
    struct ncread_place to = c->here;
    end[first] = v[0];
    end[second] = v[1];
    end[across] = v[5];
    centre[first] = v[2];
    centre[second] = v[3];
    centre[across] = c->here.at[across];
    if (fabs(v[4]) != 1)
        return ncread_error(c, error, "an arc of more than one turn");
    set(c, end, v + 6, &to);
    struct nc_piece piece = ncread_piece(c, &to);
    if (ncread_arc(c, &piece, vec(centre[0], centre[1], centre[2]), v[4] > 0, error) < 0)
        return -1;
    return go(c, &to, piece, false, error);
}

static bool is(const char *s, const char *word)
{
    return strncmp(s, word, strlen(word)) == 0;
}

static int call(struct ncread *c, const char *s, struct error *error)
{
    double v[NUMBERS] = {0};
    int n = is(s, "COMMENT") || is(s, "MESSAGE") ? 0 : numbers(s, v);
    struct ncread_place to = c->here;
    if (is(s, "STRAIGHT_")) {
        if (n != 6)
            return ncread_error(c, error, "a straight move without six numbers");
        set(c, v, v + 3, &to);
        return go(c, &to, ncread_piece(c, &to), is(s, "STRAIGHT_TRAVERSE"), error);
    }
    if (is(s, "ARC_FEED"))
        return n == 9 ? arc(c, v, error) : ncread_error(c, error, "an arc without nine numbers");
    if (is(s, "SELECT_PLANE"))
        c->plane = strstr(s, "XY") ? 17 : strstr(s, "XZ") ? 18 : 19;
    else if (is(s, "USE_LENGTH_UNITS"))
        c->unit = strstr(s, "_MM)") ? 1 : INCH;
    else if (is(s, "SET_FEED_RATE"))
        c->feed = v[0];
    else if (is(s, "START_SPINDLE"))
        c->spindle = true;
    else if (is(s, "STOP_SPINDLE"))
        c->spindle = false;
    else if (is(s, "USE_TOOL_LENGTH_OFFSET")) {
        c->order = v[2] != 0;
        memset(c->here.known, 0, sizeof c->here.known);
    } else if (is(s, "PROGRAM_END"))
        c->ended = true;
    else if (is(s, "NURBS"))
        return ncread_error(c, error, "a curve that knows X and Y alone");
    return 0;
}

static int read_block(struct ncread *c, const char *line, struct error *error)
{
    const char *s = line + strspn(line, " ");
    s += strspn(s, "0123456789");
    s += strspn(s, " ");
    if (*s != 'N')
        return 0; /* talk of the interpreter */
    if (c->line == 1) {
        c->plane = 17;
        c->absolute = c->said = true;
        c->tcp = c->options->tcp;
    }
    c->motion->blocks++;
    c->block = s[1] == '.' ? -1 : strtol(s + 1, NULL, 10);
    s += strcspn(s, " ");
    return call(c, s + strspn(s, " "), error);
}

static int read_end(struct ncread *c, struct error *error)
{
    if (!c->ended || c->spindle || c->order)
        return ncread_error(c, error,
                            "ends without PROGRAM_END, with the spindle turning or with "
                            "the tool's length on");
    return 0;
}

const struct ncread_dialect canon = {"canon", NULL, read_block, read_end, false};
