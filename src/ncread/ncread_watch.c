/* ncread_watch - see ncread_watch.h. */
#include <ctype.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ncread_state.h"

enum watched { WORK_OFFSET, TOOL, EDGE, LENGTH, COOLANT, SPEED, SENSE, PALLET };

static void set_value(struct ncread *c, enum watched what, double value)
{
    struct ncread_watch *w = &c->watch;
    if (!w->cuts) {
        w->known[what] = true;
        w->value[what] = value;
        return;
    }
    w->changed[what] = !w->known[what] || w->value[what] != value;
    w->now[what] = value;
    w->line[what] = c->line;
    w->block[what] = c->block;
}

/* The work offset, as words say it: those before the first cut are remembered. */
static void set_offset(struct ncread *c, double value, const char *words)
{
    if (!c->watch.cuts)
        snprintf(c->watch.work, sizeof c->watch.work, "%s", words);
    set_value(c, WORK_OFFSET, value);
}

/* The text of a block from its first word on, as far as it goes. */
static void set_offset_text(struct ncread *c)
{
    char words[sizeof c->watch.work];
    const char *s = c->text + strspn(c->text, " 0123456789");
    size_t n = strcspn(s, ";\r\n");
    snprintf(words, sizeof words, "%.*s", (int)(n < sizeof words ? n : sizeof words - 1), s);
    set_offset(c, (double)c->line, words);
}

/* The first name in quotes as a number below zero, others as others (FNV-1a). */
static double named(const char *text)
{
    uint32_t hash = 2166136261u;
    const char *s = strchr(text, '"');
    for (s = s ? s + 1 : ""; *s && *s != '"'; s++)
        hash = (hash ^ (unsigned char)*s) * 16777619u;
    return -1.0 - hash;
}

/* The length of a tool goes on in this block: H is its number. */
static bool takes_length(const struct ncread *c)
{
    for (size_t i = 0; i < c->words.n; i++) {
        const struct ncread_word *w = &c->words.item[i];
        enum ncread_meaning meaning = ncread_meaning_of_word(c, w);
        if (meaning == MEANS_LENGTH || meaning == MEANS_TCP || meaning == MEANS_TCP_VECTORS ||
            (strcmp(w->name, "G") == 0 && w->value[0] >= 43 && w->value[0] < 44))
            return true;
    }
    return false;
}

/* Fanuc and its like then take H0, which is none, or that of a program before. */
static void watch_number(struct ncread *c)
{
    bool known = c->watch.known[LENGTH] || c->watch.changed[LENGTH] ||
                 ncread_word_find(&c->words, "D"); /* by which others count lengths */
    bool asks = false;
    for (size_t i = 0; i < c->words.n; i++) {
        const struct ncread_word *w = &c->words.item[i];
        enum ncread_meaning meaning = ncread_meaning_of_word(c, w);
        double code = strcmp(w->name, "G") == 0 ? w->value[0] : 0;
        asks = asks || (meaning == MEANS_NOTHING_KNOWN && code >= 43 && code < 44) ||
               (code > 0 && (meaning == MEANS_LENGTH || meaning == MEANS_TCP));
    }
    if (asks && !known && c->options->dialect == &ncread_fanuc)
        ncread_watch_unasked(c, c->line, c->block,
                             "the tool's length goes on without its number, H", 0);
}

/* A work offset G110 or with a number behind it: G15 H1, G154 P5. */
static void set_offset_g(struct ncread *c, double code, const struct ncread_word *number)
{
    char text[60];
    double value = number ? number->value[0] : 0;
    if (number)
        snprintf(text, sizeof text, "G%.6g %c%.6g", code, *number->name, value);
    else
        snprintf(text, sizeof text, "G%.6g", code);
    set_offset(c, 1000 * code + value, text);
}

/* G54 P3 of Fanuc is G54.1 P3, unless P is of another word. */
static bool counts_offsets(const struct ncread *c)
{
    static const double plain[] = {0, 1, 17, 18, 19, 20, 21, 40, 43, 49, 54, 80, 90, 91, 94};
    bool own = c->options->dialect == &ncread_fanuc;
    for (size_t i = 0; i < c->words.n; i++) {
        const struct ncread_word *w = &c->words.item[i];
        bool is_plain = strcmp(w->name, "G") != 0;
        for (size_t k = 0; k < sizeof plain / sizeof *plain; k++)
            is_plain = is_plain || w->value[0] == plain[k];
        own = own && is_plain && strcmp(w->name, "M") != 0;
    }
    return own;
}

static void watch_g(struct ncread *c, const struct ncread_word *g)
{
    double code = g->value[0], offset = code;
    char text[60];
    const struct ncread_word *p = ncread_word_find(&c->words, "P");
    enum ncread_meaning meaning = ncread_meaning_of_word(c, g);
    if (meaning == MEANS_OFFSET)
        set_offset_g(c, code, takes_length(c) ? NULL : ncread_word_find(&c->words, "H"));
    if (meaning == MEANS_NOTHING_KNOWN && code == 154) /* of Haas: P1 to P99 */
        set_offset_g(c, code, p);
    if (meaning != MEANS_NOTHING_KNOWN)
        return;
    snprintf(text, sizeof text, "G%.6g", code);
    if (p && (fabs(code - 54.1) < 1e-6 || (code == 54 && counts_offsets(c)))) {
        offset = 54.1 + p->value[0];
        snprintf(text, sizeof text, "G54.1 P%.6g", p->value[0]);
    }
    if ((code >= 54 && code < 59.95) || (code >= 500 && code <= 599))
        set_offset(c, offset, text);
}

/* The spindle turns clockwise, 1, or anticlockwise, -1. */
static void set_sense(struct ncread *c, int turns)
{
    if (!c->watch.cuts)
        c->watch.turns = turns;
    set_value(c, SENSE, turns);
}

void ncread_watch_speed(struct ncread *c, double speed)
{
    c->speed = speed;
    set_value(c, SPEED, speed);
}

bool ncread_watch_still(const struct ncread *c)
{
    return (c->watch.known[SPEED] || c->watch.changed[SPEED]) && !(c->speed > 0);
}

bool ncread_watch_tool(const struct ncread *c)
{
    return c->watch.known[TOOL];
}

bool ncread_watch_edge(const struct ncread *c, double *edge)
{
    *edge = c->watch.value[EDGE];
    return c->watch.known[EDGE];
}

static void watch_m(struct ncread *c, double code)
{
    if (code == 3 || code == 13)
        set_sense(c, 1);
    else if (code == 4 || code == 14)
        set_sense(c, -1);
    if (code == 7 || code == 8 || code == 13 || code == 14)
        set_value(c, COOLANT, 1);
    else if (code == 9)
        set_value(c, COOLANT, 0);
    else if (code == 60 && c->watch.cuts)
        set_value(c, PALLET, (double)c->line);
}

/* The block has that block of the machine file in it, and not in a comment. */
static bool has_block(const char *text, const char *block)
{
    char own[60];
    if (!block || !*block || strcmp(block, "none") == 0)
        return false;
    snprintf(own, sizeof own, "%.*s", (int)strcspn(block, "|"), block);
    for (size_t n = strlen(own); n && own[n - 1] == ' '; n--)
        own[n - 1] = '\0';
    const char *at = *own ? strstr(text, own) : NULL;
    size_t n = strlen(own);
    return at && (at == text || at[-1] == ' ') && !isdigit((unsigned char)at[n]) && at[n] != '.' &&
           strcspn(text, "(;") >= (size_t)(at - text);
}

/* Coolant by words of the machine's own. */
static void watch_own_coolant(struct ncread *c)
{
    for (int i = 0; i < NCREAD_COOLANTS; i++)
        if (has_block(c->text, c->options->coolant[i]))
            set_value(c, COOLANT, 1);
    if (has_block(c->text, c->options->coolant_off))
        set_value(c, COOLANT, 0);
}

/* The block waits, or is a limit: S is no speed of the spindle (G4 S30 of Siemens, G26 S9000). */
static bool waits_or_limits(const struct ncread *c)
{
    for (size_t i = 0; i < c->words.n; i++) {
        const struct ncread_word *w = &c->words.item[i];
        bool g = strcmp(w->name, "G") == 0 && w->values == 1;
        if (g && (w->value[0] == 4 || w->value[0] == 25 || w->value[0] == 26))
            return true;
    }
    return false;
}

/* True where the block switches on the compensation of a radius. */
static bool takes_radius(const struct ncread *c)
{
    for (size_t i = 0; i < c->words.n; i++) {
        const struct ncread_word *w = &c->words.item[i];
        if (strcmp(w->name, "G") == 0 && w->values == 1 && w->value[0] >= 41 && w->value[0] < 43)
            return true;
    }
    return false;
}

/* True where the block has a work offset that is a word of the control's own. */
static bool sets_offset(const struct ncread *c)
{
    for (size_t i = 0; i < c->words.n; i++)
        if (ncread_meaning_of_word(c, &c->words.item[i]) == MEANS_OFFSET)
            return true;
    return false;
}

void ncread_watch_words(struct ncread *c)
{
    for (size_t i = 0; i < c->words.n; i++) {
        const struct ncread_word *w = &c->words.item[i];
        if (w->values == 0 && strcmp(w->name, "T") == 0)
            set_value(c, TOOL, named(c->text));
        if (w->values != 1 || w->name[1])
            continue;
        switch (w->name[0]) {
        case 'G':
            watch_g(c, w);
            break;
        case 'M':
            watch_m(c, w->value[0]);
            break;
        case 'T':
            set_value(c, TOOL, w->value[0]);
            break;
        case 'D':
            if (!takes_radius(c)) /* with G41 it is that of the radius */
                set_value(c, EDGE, w->value[0]);
            break;
        case 'H':
            if (takes_length(c) || !sets_offset(c)) /* G15 H1 of Okuma */
                set_value(c, LENGTH, w->value[0]);
            break;
        case 'S':
            if (!waits_or_limits(c))
                ncread_watch_speed(c, w->value[0]);
            break;
        default:
            break;
        }
    }
    watch_number(c);
    watch_own_coolant(c);
    ncread_lost_words(c);
    ncread_home_words(c);
}

void ncread_watch_text(struct ncread *c, int n, const char *const word[])
{
    if (ncread_tool_called(n, word))
        set_value(c, TOOL, *word[2] == '"' ? named(c->text) : strtod(word[2], NULL));
    if (ncread_tool_called(n, word) && c->tcp && ncread_ours(c))
        ncread_watch_remark(c, c->line, c->block,
                            "a tool is called where tool centre point control is on");
    if (n > 2 && strcmp(word[0], "CYCL") == 0 &&
        (strncmp(word[2], "7.", 2) == 0 || strcmp(word[2], "247") == 0))
        set_offset_text(c);
    if (n > 0 && strcmp(word[0], "TRANS") == 0)
        set_offset_text(c);
    watch_own_coolant(c);
    for (int i = 0; i < n; i++)
        if (word[i][0] == 'M')
            watch_m(c, strtod(word[i] + 1, NULL));
    ncread_home_text(c, n, word);
    ncread_lost_text(c);
}

void ncread_watch_remark(struct ncread *c, size_t line, long block, const char *text)
{
    struct nc_remark *remark = array_push(&c->motion->remark);
    *remark = (struct nc_remark){.line = line, .block = (int)block};
    snprintf(remark->text, sizeof remark->text, "%s", text);
}

void ncread_watch_unasked(struct ncread *c, size_t line, long block, const char *text,
                          unsigned unless)
{
    ncread_watch_remark(c, line, block, text);
    struct nc_remark *remark = &c->motion->remark.item[c->motion->remark.n - 1];
    remark->notice = !ncread_ours(c);
    remark->unless = unless;
}

/* The spindle's speed or its sense, which a new tool may bring along. */
static void tell_spindle(struct ncread *c, enum watched what)
{
    const struct ncread_watch *w = &c->watch;
    char text[120];
    if (w->changed[TOOL] || (what == SENSE && !w->known[what]))
        return;
    if (what == SENSE)
        snprintf(text, sizeof text,
                 "the spindle turns the other way amid the program, and cuts follow");
    else if (w->known[what])
        snprintf(text, sizeof text,
                 "the spindle's speed changes from %g to %g amid the program, and cuts follow",
                 w->value[what], w->now[what]);
    else
        snprintf(text, sizeof text,
                 "the spindle's speed becomes %g amid the program, and cuts follow", w->now[what]);
    ncread_watch_unasked(c, w->line[what], w->block[what], text, NC_ASKED_SPEEDS);
}

static void tell_change(struct ncread *c, enum watched what)
{
    static const char *const name[] = {"the work offset", "the tool", "the tool's offset D",
                                       "the tool's offset H"};
    const struct ncread_watch *w = &c->watch;
    char text[120];
    if (what == SPEED || what == SENSE) {
        tell_spindle(c, what);
        return;
    }
    if (what == COOLANT && w->now[what] != 0)
        return;
    if (what == PALLET) {
        ncread_watch_unasked(c, w->line[what], w->block[what],
                             "the pallet changes amid the program (M60), and cuts follow", 0);
        return;
    }
    if (what == COOLANT)
        snprintf(text, sizeof text, "the coolant goes off, and cuts follow");
    else if (what == WORK_OFFSET && w->now[what] > 1000)
        snprintf(text, sizeof text, "the work offset changes amid the program, and cuts follow");
    else if (what == TOOL && (w->now[what] < 0 || (w->known[what] && w->value[what] < 0)))
        snprintf(text, sizeof text, "the tool changes amid the program, and cuts follow");
    else if (w->known[what])
        snprintf(text, sizeof text, "%s changes from %g to %g amid the program, and cuts follow",
                 name[what], w->value[what], w->now[what]);
    else
        snprintf(text, sizeof text, "%s becomes %g amid the program, and cuts follow", name[what],
                 w->now[what]);
    ncread_watch_remark(c, w->line[what], w->block[what], text);
}

void ncread_watch_skip(struct ncread *c, const char *line)
{
    if (*line != '/' || c->watch.skips)
        return;
    c->watch.skips = true;
    ncread_watch_unasked(c, c->line, c->block,
                         "a block that a switch of the control leaves out (/): it is judged as run",
                         NC_ASKED_SKIPS);
}

/* A number of a tool, 0: none is known, -1: it has a name. */
static int number_of(const struct ncread_watch *w, enum watched what)
{
    if (!w->known[what])
        return 0;
    return w->value[what] < 0 ? -1 : w->value[what] < 1e9 ? (int)w->value[what] : 0;
}

static void tell_first(const struct ncread *c)
{
    const struct ncread_watch *w = &c->watch;
    c->motion->coolant = w->known[COOLANT] && w->value[COOLANT] != 0;
    snprintf(c->motion->work, sizeof c->motion->work, "%s", w->work);
    c->motion->turns = w->turns;
    c->motion->speed = c->speed;
    c->motion->tool = number_of(w, TOOL);
    c->motion->offset = number_of(w, ncread_lost_edge(c) ? EDGE : LENGTH);
}

void ncread_watch_cut(struct ncread *c)
{
    struct ncread_watch *w = &c->watch;
    for (int k = 0; k < NCREAD_WATCHED && w->cuts; k++)
        if (w->changed[k])
            tell_change(c, (enum watched)k);
    for (int k = 0; k < NCREAD_WATCHED && w->cuts; k++) {
        if (w->changed[k]) {
            w->known[k] = true;
            w->value[k] = w->now[k];
        }
        w->changed[k] = false;
    }
    if (!w->cuts && !w->known[WORK_OFFSET] && c->options->dialect->offsets)
        ncread_watch_remark(c, c->line, c->block, "cuts without a work offset, G54 or another");
    if (!w->cuts && !c->home.called && c->options->dialect == &ncread_heidenhain && ncread_ours(c))
        ncread_watch_remark(c, c->line, c->block, "cuts before a tool is called");
    if (!w->cuts && !w->known[SPEED] && ncread_ours(c))
        ncread_watch_remark(c, c->line, c->block, "cuts before a speed of the spindle, S, is said");
    if (!w->cuts) {
        ncread_lost_tell(c);
        tell_first(c);
    }
    w->cuts = true;
}
