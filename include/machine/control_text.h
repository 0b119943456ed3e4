/*
 * control_text - a control's programs as text: how numbers, comments and block numbers look, and
 * the blocks around the motions, section by section (cloudmill-control(5)).
 *
 * It is part of a struct machine and read with it: a control file has the same lines as a machine
 * file, the keys below and [sections].  Those of the controls in control.h are built in, from
 * controls/fanuc.txt and so on; others name one of them, or each other, by `base`.
 */
#ifndef CLOUDMILL_CONTROL_TEXT_H
#define CLOUDMILL_CONTROL_TEXT_H

#include <stdbool.h>

#include "base/error.h"

enum control_section {
    SECTION_START,    /* the head of the program */
    SECTION_TOOL,     /* the tool into the spindle, which turns */
    SECTION_APPROACH, /* from there up to the first motion with it */
    SECTION_RETRACT,  /* from its last motion home */
    SECTION_CHANGE,   /* between that and another tool */
    SECTION_END,      /* the end of the program */
    CONTROL_SECTIONS
};

enum { CONTROL_SECTION_SIZE = 2000 };

struct control_text {
    char title[60];
    int dialect;      /* enum control_id whose motions the program has; CONTROLS: none yet */
    char comment[40]; /* "({text})" */
    bool comment_capitals;
    int comment_width;
    char number[40];  /* "N{n}" */
    bool tcp;         /* it can have tool-centre-point control */
    bool number_all;  /* every line has one, comments too, from 0 by 1 */
    bool point, sign; /* X12. and X+12 */
    char words[600];  /* what words of its own mean to ncverify */
    char section[CONTROL_SECTIONS][CONTROL_SECTION_SIZE]; /* lines, each with its '\n' */
};

/* The names of the sections in their order. */
const char *control_section_name(enum control_section section);

/* The section that a line `[name]` begins, CONTROL_SECTIONS: it begins none. */
enum control_section control_section_find(const char *line);

/* Adds a line, checked; -1 with what is wrong with it. */
int control_section_add(struct control_text *text, enum control_section section, const char *line,
                        struct error *error);

/* A field, as `{coolant}`, stands in some section. */
bool control_text_has(const struct control_text *text, const char *field);

/* The file of a control of control.h, NULL: the name is none of them. */
const char *control_text_built_in(const char *name);

#endif
