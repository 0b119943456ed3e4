/* ncread_tool - see ncread_tool.h. */
#include "ncread_tool.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"

#include "ncread_state.h"

static const struct machine_tool *tool_of(const struct ncread *c, int number)
{
    for (size_t i = 0; i < c->options->tools; i++)
        if (c->options->tool[i].number == number)
            return &c->options->tool[i];
    return NULL;
}

/* The number of the tool that is called by a name, with quotes or without; 0: no such name. */
static int tool_named(const struct ncread *c, const char *name, size_t n)
{
    for (size_t i = 0; i < c->options->tools; i++) {
        const char *own = c->options->tool[i].name;
        if (n > 0 && strlen(own) == n && strncmp(own, name, n) == 0)
            return c->options->tool[i].number;
    }
    return 0;
}

/* NAME of `T="NAME"` or `"NAME"`. */
static int tool_quoted(const struct ncread *c, const char *text)
{
    const char *open = strchr(text, '"'), *close = open ? strchr(open + 1, '"') : NULL;
    return close ? tool_named(c, open + 1, (size_t)(close - open - 1)) : 0;
}

/* Lengths play no part before the place is said anew with them. */
static void switch_on(struct ncread *c, int tool)
{
    if (c->tool.on != tool && c->options->tools > 0)
        memset(c->here.known, 0, sizeof c->here.known);
    c->tool.on = tool;
}

static void take_tool(struct ncread *c, int tool)
{
    c->tool.held = tool;
    if (c->options->dialect == &ncread_siemens) { /* D1 is on with a tool */
        switch_on(c, tool);
        c->length = true;
    }
}

static void read_word(struct ncread *c, const struct ncread_word *w)
{
    const struct ncread_word *h = ncread_word_find(&c->words, "H");
    bool one = w->kind == WORD_ADDRESS && !w->name[1];
    enum ncread_meaning meaning = ncread_meaning_of_word(c, w);
    double code = w->value[0];
    bool on = meaning == MEANS_LENGTH || meaning == MEANS_TCP || meaning == MEANS_TCP_VECTORS;
    bool off = meaning == MEANS_LENGTH_OFF || meaning == MEANS_TCP_OFF;
    if (one && *w->name == 'G' && meaning == MEANS_NOTHING_KNOWN) {
        on = fabs(code - 43) < 0.01 || fabs(code - 43.4) < 0.01 || fabs(code - 43.5) < 0.01;
        off = fabs(code - 49) < 0.01;
    } else if (strcmp(w->name, "D") == 0 && c->options->dialect == &ncread_siemens) {
        on = code > 0;
        off = code == 0;
        c->length = on;
    }
    if (on && h)
        switch_on(c, (int)h->value[0]);
    else if (on && (meaning == MEANS_NOTHING_KNOWN || c->tool.on == 0))
        switch_on(c, c->tool.held);
    else if (off)
        switch_on(c, 0);
}

static void read_tool(struct ncread *c)
{
    bool change = false;
    const struct ncread_word *t = ncread_word_find(&c->words, "T");
    if (t && t->values > 0)
        c->tool.asked = (int)t->value[0];
    else if (t)
        c->tool.asked = tool_quoted(c, c->text);
    for (size_t i = 0; i < c->words.n; i++) {
        const struct ncread_word *w = &c->words.item[i];
        change = change || (w->kind == WORD_ADDRESS && *w->name == 'M' && w->value[0] == 6);
    }
    c->tool.changes = c->tool.changes || change;
    if (change || (t && !c->tool.changes))
        take_tool(c, c->tool.asked);
}

void ncread_tool_words(struct ncread *c)
{
    read_tool(c);
    if (ncread_meaning_of(c, "G43") == MEANS_NEVER) /* it is in the work offset */
        c->tool.on = c->tool.held;
    for (size_t i = 0; i < c->words.n; i++)
        read_word(c, &c->words.item[i]);
}

void ncread_tool_stops(struct ncread *c)
{
    if (!c->watch.cuts && ncread_ours(c))
        c->spindle = false;
}

bool ncread_tool_called(int n, const char *const word[])
{
    return n > 2 && strcmp(word[0], "TOOL") == 0 && strcmp(word[1], "CALL") == 0 &&
           (*word[2] == '"' || isdigit((unsigned char)*word[2]));
}

void ncread_tool_text(struct ncread *c, int n, const char *const word[])
{
    if (!ncread_tool_called(n, word))
        return;
    ncread_tool_stops(c);
    c->tool.held = *word[2] == '"' ? tool_quoted(c, c->text) : (int)strtol(word[2], NULL, 10);
    switch_on(c, c->tool.held);
    c->length = *word[2] == '"' || c->tool.held != 0; /* TOOL CALL 0: none is in the spindle */
}

/* A tool of a head without tool-centre-point control, without whose length its tip is not known. */
static int length_missing(struct ncread *c, struct error *error)
{
    char text[120];
    for (int i = 0; i < c->options->kinematics.n; i++)
        if (!c->options->kinematics.axis[i].table) {
            snprintf(text, sizeof text,
                     "cuts with tool %d, whose length is not in the machine file", c->tool.held);
            return ncread_error(c, error, text);
        }
    return 0;
}

int ncread_tool_piece(struct ncread *c, struct nc_piece *piece, struct error *error)
{
    const struct machine_tool *held = tool_of(c, c->tool.held), *on = tool_of(c, c->tool.on);
    bool lengths = false;
    for (size_t i = 0; i < c->options->tools; i++)
        lengths = lengths || !isnan(c->options->tool[i].length);
    if (!lengths)
        return 0;
    if (!held || isnan(held->length))
        return piece->rapid || !piece->table ? 0 : length_missing(c, error);
    piece->length = held->length;
    if (c->tool.on == 0)
        piece->beyond = -held->length;
    else if (on && !isnan(on->length)) /* else H is a number of the shop's own: taken as right */
        piece->beyond = on->length - held->length;
    return 0;
}
