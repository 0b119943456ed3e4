/* ncread_lost - see ncread_lost.h. */
#include "ncread_lost.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "ncread/ncread_made.h"
#include "ncread_state.h"

/* Ten times the number of a G word, -1: it is none that is kept. */
static int tenths(double code)
{
    return code >= 0 && 10 * code < NCREAD_LOST_G - 0.5 ? (int)lround(10 * code) : -1;
}

static const char *const reset_word[NCREAD_LOST_RESETS] = {"TRAFOOF", "CYCLE800", "PLANE RESET",
                                                           "FUNCTION RESET TCPM", "M129"};

/* Programs of ncpost that the control's file is of. */
static bool is_made(const struct ncread *c)
{
    return c->options->text && ncread_ours(c) &&
           ncread_made_for(c->options->head, c->options->control);
}

/* Tool centre point control is on since the last block, and where a rotary axis stands is not
 * known: by some controls' parameters it is what the words after it are reckoned from. */
static void look_at_frame(struct ncread *c)
{
    bool goes_on = c->tcp && !c->lost.tcp, known = true;
    c->lost.tcp = c->tcp;
    for (int i = 0; i < c->options->kinematics.n; i++)
        known = known && c->here.turned[i];
    if (goes_on && !known && is_made(c) &&
        strstr(c->options->text->section[SECTION_APPROACH], "{rotary.start}"))
        ncread_watch_remark(c, c->line, c->block,
                            "tool centre point control goes on before all rotary axes go to where "
                            "they start");
}

void ncread_lost_text(struct ncread *c)
{
    look_at_frame(c);
    for (int k = 0; k < NCREAD_LOST_RESETS && !c->watch.cuts; k++) { /* the first cut asks for it */
        const char *s = strstr(c->text, reset_word[k]);
        c->lost.reset[k] = c->lost.reset[k] || (s && s < c->text + strcspn(c->text, ";"));
    }
}

void ncread_lost_words(struct ncread *c)
{
    ncread_lost_text(c);
    for (size_t i = 0; i < c->words.n; i++) {
        const struct ncread_word *w = &c->words.item[i];
        int code = strcmp(w->name, "G") == 0 && w->values == 1 ? tenths(w->value[0]) : -1;
        if (code >= 0)
            c->lost.g[code] = true;
        c->lost.oriwks = c->lost.oriwks || strcmp(w->name, "ORIWKS") == 0;
    }
}

/* One of them, named with the first cut. */
static void tell(struct ncread *c, const char *word, const char *where)
{
    char text[120];
    snprintf(text, sizeof text, "cuts without %.20s before it, which the control's file has %s",
             word, where);
    ncread_watch_remark(c, c->line, c->block, text);
}

/* What begins a line of the file, is in every program of this unit: *s behind the conditions. */
static bool stands_always(const struct ncread *c, const char **s)
{
    const char *unit = c->unit == INCH ? "{?inch}" : "{?mm}";
    if (strncmp(*s, unit, strlen(unit)) == 0)
        *s += strlen(unit);
    return strncmp(*s, "{?", 2) != 0 && strncmp(*s, "{line}", 6) != 0;
}

/* The G words of a line that are no fields. */
static void look_at_line(struct ncread *c, const char *s, size_t n, const char *where)
{
    const char *end = s + n;
    char word[20];
    while (s < end && *s != '(' && *s != ';') {
        size_t more = strcspn(s, " |\n");
        char *behind;
        double code = *s == 'G' ? strtod(s + 1, &behind) : -1;
        bool whole = *s == 'G' && isdigit((unsigned char)s[1]) && behind == s + more;
        int k = whole ? tenths(code) : -1;
        if (k >= 0 && !c->lost.g[k]) {
            snprintf(word, sizeof word, "G%.6g", code);
            tell(c, word, where);
        }
        s += more + (s + more < end);
    }
}

static void look_at_section(struct ncread *c, enum control_section section, const char *where)
{
    const char *next;
    for (const char *s = c->options->text->section[section]; *s; s = next) {
        size_t n = strcspn(s, "\n");
        next = s + n + (s[n] == '\n');
        const char *from = s;
        if (stands_always(c, &from))
            look_at_line(c, from, n - (size_t)(from - s), where);
    }
}

/* Those of the key `safe`, which the start has as a line. */
static void look_at_safe(struct ncread *c)
{
    const char *safe = c->options->safe;
    if (!safe || strchr(safe, '{') ||
        !strstr(c->options->text->section[SECTION_START], "\n{safe}\n"))
        return;
    for (size_t n; *safe; safe += n + (safe[n] == '|')) {
        n = strcspn(safe, "|");
        look_at_line(c, safe, n, "at its start");
    }
}

/* The word stands in it, and no letter or digit follows. */
static bool has_word(const char *text, const char *word)
{
    const char *s = strstr(text, word);
    return s && !isalnum((unsigned char)s[strlen(word)]) && s[strlen(word)] != '.';
}

/* Those of the key `safe` that end tool centre point control or a tilted plane, of a program that
 * has the first on. */
static void look_at_resets(struct ncread *c)
{
    const char *safe = c->options->safe;
    for (int k = 0; k < NCREAD_LOST_RESETS && safe && c->tcp; k++)
        if (has_word(safe, reset_word[k]) && !c->lost.reset[k])
            tell(c, reset_word[k], "at its start");
}

bool ncread_lost_edge(const struct ncread *c)
{
    const char *change = c->options->tool_change;
    return change && strstr(change, "D{offset}");
}

/* A tool that is selected is not in the spindle yet; the edge of Siemens is its length. */
static void look_at_tool(struct ncread *c)
{
    const char *change = c->options->tool_change;
    double edge;
    if (!change || strchr(change, '?') || !ncread_watch_tool(c))
        return;
    if (has_word(change, "M6") && !c->tool.changes)
        tell(c, "M6", "with the tool");
    if (has_word(change, "D1") && (!ncread_watch_edge(c, &edge) || edge != 1))
        tell(c, "D1", "with the tool");
    if (ncread_lost_edge(c) && !ncread_watch_edge(c, &edge))
        tell(c, "D", "with the tool");
}

void ncread_lost_tell(struct ncread *c)
{
    const struct control_text *text = c->options->text;
    bool linuxcnc = c->options->dialect == &ncread_linuxcnc;
    bool siemens = c->options->dialect == &ncread_siemens;
    if (!is_made(c))
        return;
    look_at_section(c, SECTION_START, "at its start");
    look_at_section(c, SECTION_APPROACH, "in its approach");
    look_at_safe(c);
    look_at_resets(c);
    look_at_tool(c);
    /* without both it blends corners as far as it likes */
    if (linuxcnc && has_word(text->section[SECTION_START], "G61") && !c->lost.g[610] &&
        !c->lost.g[640])
        tell(c, "G61 or G64", "at its start");
    if (siemens && c->tcp && strstr(text->section[SECTION_APPROACH], "ORIWKS") && !c->lost.oriwks)
        tell(c, "ORIWKS", "after TRAORI");
}
