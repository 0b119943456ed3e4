/* ncread_home - see ncread_home.h. */
#include "ncread_home.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/num.h"
#include "ncread_state.h"

/* Without tool centre point control X Y Z of the control are not the tip's. */
static bool is_turned(const struct ncread *c)
{
    return c->options->tcp && !ncread_upright(c);
}

/* A move that nothing follows: where the ball was last is where it begins, or Z is said. */
static void add_blind(struct ncread *c, bool z_said, double z)
{
    double unit = c->unit > 0 ? c->unit : 1;
    *array_push(&c->motion->blind) = (struct nc_blind){.line = c->line,
                                                       .block = (int)c->block,
                                                       .pieces = c->motion->piece.n,
                                                       .z_said = z_said,
                                                       .nose = z_said && ncread_nose(c),
                                                       .turned = is_turned(c) && !c->tcp,
                                                       .z = z_said ? unit * z : 0};
}

/* Before anything is known of Z: others than ncpost may rest on the operator. */
static void remark_early(struct ncread *c)
{
    if (!c->home.early)
        ncread_watch_unasked(c, c->line, c->block,
                             "X, Y or a rotary axis goes at rapid before Z is home or known", 0);
    c->home.early = true;
}

static void remark_stray(struct ncread *c, bool aligned)
{
    if (!c->home.strayed && aligned)
        ncread_watch_remark(c, c->line, c->block,
                            "a rapid move to a place of the work without the tool's length, which "
                            "was on before");
    else if (!c->home.strayed)
        ncread_watch_remark(c, c->line, c->block,
                            "a rapid move to a place of the work without tool centre point "
                            "control, the rotary axes not at zero");
    c->home.strayed = true;
}

/* X, Y or a rotary axis goes where nothing follows it.  A program of ncpost has Z at home then. */
static void leave(struct ncread *c, bool with_z)
{
    if (c->home.high || c->home.raised)
        return;
    if (c->motion->piece.n > 0 && (with_z || !ncread_ours(c)))
        add_blind(c, false, 0);
    else if (!with_z)
        remark_early(c);
}

static bool names_beside(const struct ncread *c)
{
    return c->home.xy || c->home.turn;
}

/* The name of an axis, or of none. */
static void name_axis(struct ncread *c, char letter)
{
    c->home.z = c->home.z || letter == 'Z';
    c->home.xy = c->home.xy || letter == 'X' || letter == 'Y';
    c->home.turn = c->home.turn || letter == 'A' || letter == 'B' || letter == 'C';
}

/* A tool is changed where the machine wants it; of a program of ncpost it is said where. */
static void change_tool(struct ncread *c)
{
    c->home.called = true;
    c->home.high = c->home.high || !ncread_ours(c);
}

/* The machine file's own way home has this letter with this number. */
static bool in_own(const struct ncread *c, char letter, double value)
{
    const char *own = c->options->home;
    for (const char *s = own ? strchr(own, letter) : NULL; s; s = strchr(s + 1, letter)) {
        const char *number = s + 1 + (s[1] == '=');
        double said = 0;
        if (num_read(&number, &said) && said == value)
            return true;
    }
    return false;
}

/* Z of the machine is its zero, the top of its travel, or as in the machine file's own way home. */
static bool is_high(const struct ncread *c, double z)
{
    double mm = z * (c->unit > 0 ? c->unit : 1);
    return z == 0 || fabs(mm - c->options->z_top) < 0.001 || in_own(c, 'Z', z);
}

/* A reference point by its number: ncpost goes to that of the machine file alone. */
static void check_number(struct ncread *c)
{
    const struct ncread_word *p = ncread_word_find(&c->words, "P");
    char text[80];
    if (!p || !ncread_ours(c) || in_own(c, 'P', p->value[0]))
        return;
    snprintf(text, sizeof text, "goes to reference point P%.6g, which is not home", p->value[0]);
    ncread_watch_remark(c, c->line, c->block, text);
}

/* A place of the machine that may be below the part: nothing is known of Z after it. */
static void remark_low(struct ncread *c, double z)
{
    char text[120];
    c->home.high = c->home.raised = false;
    if (!c->home.low)
        snprintf(text, sizeof text,
                 "Z goes to %.4g of the machine, which is not known to be above the part", z);
    if (!c->home.low)
        ncread_watch_unasked(c, c->line, c->block, text, 0);
    c->home.low = true;
}

/* To a place of the machine: G28 and G30 take all axes there, where none is named. */
static void go_home(struct ncread *c, bool all, bool top)
{
    bool z = c->home.z || all || top;
    if (names_beside(c) || all)
        leave(c, z);
    c->home.high = c->home.high || z;
}

/* All of them by a bare G28 or G30, which moves none on some controls: ncpost names Z. */
static void go_home_bare(struct ncread *c)
{
    const char *own = c->options->home;
    if (ncread_ours(c) && (!own || strchr(own, 'Z')))
        ncread_watch_remark(c, c->line, c->block,
                            "goes home without an axis: a control may move none, or all at once");
    go_home(c, true, false);
}

/* The same by coordinates of the machine, Z to this one. */
static void go_in_machine(struct ncread *c, double z)
{
    bool low = c->home.z && !is_high(c, z);
    go_home(c, false, false);
    if (low)
        remark_low(c, z);
}

void ncread_home_words(struct ncread *c)
{
    bool machine = c->machine_frame, back = false, top = false;
    double z = 0;
    c->home.z = c->home.xy = c->home.turn = false;
    for (size_t i = 0; i < c->words.n; i++) {
        const struct ncread_word *w = &c->words.item[i];
        bool one = w->kind == WORD_ADDRESS && !w->name[1];
        enum ncread_meaning meaning = one ? ncread_meaning_of_word(c, w) : MEANS_NOTHING_KNOWN;
        int tenths = one ? (int)lround(10 * w->value[0]) : 0;
        top = top || meaning == MEANS_HOME;
        if (one && *w->name == 'G' && meaning == MEANS_NOTHING_KNOWN) {
            back = back || tenths == 280 || tenths == 300;
            machine = machine || tenths == 530;
        } else if (one && *w->name == 'M' && tenths == 60) {
            change_tool(c);
        }
        machine = machine || (w->kind == WORD_NAME && strcmp(w->name, "SUPA") == 0);
        if (!w->name[1] && !c->setting)
            name_axis(c, *w->name);
        if (strcmp(w->name, "Z") == 0)
            z = w->value[0];
    }
    if (back || top)
        check_number(c);
    if (machine && !back && !top)
        go_in_machine(c, z);
    else if (back && !c->home.z && !names_beside(c))
        go_home_bare(c);
    else if (machine || back || top)
        go_home(c, false, top);
}

void ncread_home_text(struct ncread *c, int n, const char *const word[])
{
    bool machine = false;
    double z = 0;
    c->home.z = c->home.xy = c->home.turn = false;
    if (n > 1 && strcmp(word[0], "TOOL") == 0 && strcmp(word[1], "CALL") == 0)
        change_tool(c);
    if (n == 0 || strcmp(word[0], "L") != 0)
        return;
    for (int i = 1; i < n; i++) {
        const char *w = word[i];
        machine = machine || strcmp(w, "M91") == 0;
        name_axis(c, *w == 'I' ? w[1] : *w);
        if (*w == 'Z')
            z = strtod(w + 1, NULL);
        else if (*w == 'I' && w[1] == 'Z') /* by so much, from wherever it is */
            z = HUGE_VAL;
    }
    if (machine)
        go_in_machine(c, z);
}

/* Z alone, to above where the tip was seen last: without the tool's length it is no less. */
static bool rises(const struct ncread *c, const struct ncread_place *to)
{
    return c->motion->piece.n > 0 && c->home.z && !names_beside(c) && to->at[2] > c->here.at[2];
}

void ncread_home_go(struct ncread *c, const struct ncread_place *to, bool rapid, bool tracked)
{
    bool blind = rapid && !tracked, cut = c->motion->piece.n > 0, up = rises(c, to);
    bool aligned = ncread_nose(c) && !is_turned(c); /* X and Y go where the tip goes */
    bool astray = c->home.z ? cut && !up : cut && c->home.xy && !c->home.high && !aligned;
    if (blind && astray)
        remark_stray(c, aligned || c->tcp);
    else if (blind && c->home.z)
        add_blind(c, true, to->at[2]);
    else if (rapid && !c->home.z && names_beside(c) && (!tracked || !c->here.known[2]))
        leave(c, false);
    if (c->home.z) {
        c->home.high = false;
        c->home.raised = blind && up;
    }
}
