/*
 * template - text with fields in braces for what a program fills in: blocks that a machine file
 * words itself, and whole programs that a control file words (cloudmill-control(5)).
 *
 * A field is {NAME} or, filled with zeros to a width, {NAME:4}.  {?NAME} and {?!NAME} are
 * conditions: the block is written only where it holds, or where it does not.  What stands for
 * blocks of its own ({head}, {home} ...) is alone in its line but for conditions, and belongs to
 * the sections of a control file, never to a key: so no template contains itself.  A block whose
 * words all stand already is left out.
 */
#ifndef CLOUDMILL_TEMPLATE_H
#define CLOUDMILL_TEMPLATE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"

enum template_word {
    /* numbers and texts */
    TEMPLATE_TOOL,
    TEMPLATE_OFFSET,
    TEMPLATE_RPM,
    TEMPLATE_NEXT,        /* the number of the tool that comes next */
    TEMPLATE_TOLERANCE,   /* ncpost's share, mm */
    TEMPLATE_ORIENTATION, /* that of the tool axis, degrees */
    TEMPLATE_LEVEL,       /* the tolerance as 1 (0.1 mm, for speed) to 10 (0.001 mm) */
    TEMPLATE_A,           /* of a tilted plane, degrees: about X, the turned Y ... */
    TEMPLATE_B,
    TEMPLATE_I, /* ... Euler's about Z, the turned X, the turned Z */
    TEMPLATE_J,
    TEMPLATE_K,
    TEMPLATE_SPA, /* spatial angles: about X, then about Y, both of the frame that is not tilted */
    TEMPLATE_SPB,
    TEMPLATE_PROGRAM,  /* its number */
    TEMPLATE_NAME,     /* its name, as the control takes it */
    TEMPLATE_WORK,     /* the work offset */
    TEMPLATE_SECONDS,  /* of a dwell */
    TEMPLATE_LENGTH_Z, /* key length.off.z */
    TEMPLATE_HASH,     /* # itself, which starts a comment in these files */
    TEMPLATE_N,        /* of the key `number` alone: the number of the block */
    TEMPLATE_TEXT,     /* of the key `comment` alone: the comment */
    /* words of a block in a section */
    TEMPLATE_LINE,  /* no word: the line has no block number */
    TEMPLATE_RAPID, /* G0, where it is not on */
    TEMPLATE_X,     /* of the first place; left out where it is said already */
    TEMPLATE_Y,
    TEMPLATE_Z,
    TEMPLATE_X_ABOVE, /* of the place above that in the frame of the work, for a tilted plane */
    TEMPLATE_Y_ABOVE,
    TEMPLATE_ROTARY_START, /* all rotary axes as the tool leaves home (key tcp.frame) */
    TEMPLATE_ROTARY,       /* those that stand otherwise at the first place */
    TEMPLATE_AXIS,         /* the same, or the vector, as the program says the tool axis */
    TEMPLATE_ROTARY_ZERO,  /* all at zero */
    /* blocks in a section */
    TEMPLATE_HEAD,       /* the comments that say what the program is */
    TEMPLATE_SPINDLE,    /* S and M3 or M4 */
    TEMPLATE_SPINDLE_ON, /* M3 or M4, M5, M9, M1, or the machine's keys of these names */
    TEMPLATE_SPINDLE_OFF,
    TEMPLATE_COOLANT_OFF,
    TEMPLATE_STOP_OPTIONAL,
    TEMPLATE_NO_TOOL, /* a comment, where the path names no tool */
    TEMPLATE_COOLANT,
    TEMPLATE_HOME, /* the machine's keys of these names; text before them begins their block */
    TEMPLATE_SAFE,
    TEMPLATE_START,
    TEMPLATE_END,
    TEMPLATE_TOOL_CHANGE,
    TEMPLATE_TCP_ON,
    TEMPLATE_TCP_OFF,
    TEMPLATE_PLANE_ON,
    TEMPLATE_PLANE_OFF,
    TEMPLATE_SMOOTH_ON,
    TEMPLATE_SMOOTH_OFF,
    TEMPLATE_CLAMP_ON,
    TEMPLATE_CLAMP_OFF,
    TEMPLATE_NONE,
    TEMPLATE_PLANE = TEMPLATE_A,
    TEMPLATE_FIRST_WORD = TEMPLATE_LINE,
    TEMPLATE_FIRST_BLOCK = TEMPLATE_HEAD,
    TEMPLATE_FIRST_KEY = TEMPLATE_HOME
};

enum template_condition {
    WHEN_MM,
    WHEN_INCH,
    WHEN_TCP,       /* tool-centre-point control is used */
    WHEN_ZERO,      /* ... with the rotary axes at zero (key tcp.frame) */
    WHEN_HAS_TCP,   /* the machine has it (key tcp) */
    WHEN_OFF_HOME,  /* key length.off, where the machine has no tcp.off of its own */
    WHEN_OFF_ALONE, /* ... and there is no tilted plane: else alone */
    WHEN_OFF_Z,
    WHEN_ROTARY,  /* the tool axis is rotary words */
    WHEN_VECTORS, /* it is vectors */
    WHEN_AXES,    /* the program has rotary words */
    WHEN_TURNED,  /* ... or the control turns them for a tilted plane */
    WHEN_PLANE,   /* a tilted plane */
    WHEN_SMOOTH,  /* key smooth */
    WHEN_TOOL,    /* the tool has a number */
    WHEN_CALLED,  /* and was called just before */
    WHEN_RPM,     /* the spindle turns */
    WHEN_CCW,     /* against the clock */
    WHEN_CUTCOM,  /* radius compensation is on */
    WHEN_INVERSE, /* feeds are inverse time */
    WHEN_G17,     /* that plane is on */
    WHEN_NAMED,   /* a name was asked for */
    WHEN_SPLINES, /* the program has B-splines or polynomials */
    WHEN_CURVES,  /* and some of them turn the tool */
    WHEN_NEXT,    /* a tool comes next, and the key tool.next */
    WHEN_STOP,    /* key tool.stop */
    WHEN_WORK,    /* another work offset than the one that was said */
    WHEN_NONE
};

enum { TEMPLATE_WIDTH_MAX = 20 };

/* A field of a text. */
struct template_field {
    enum template_word word;           /* TEMPLATE_NONE: a condition */
    enum template_condition condition; /* WHEN_NONE: a word */
    bool negated;
    int width;     /* zeros in front up to it, 0: none */
    size_t length; /* in the text, with its braces */
};

/* Where a template stands. */
enum template_place {
    TEMPLATE_IN_KEY,     /* blocks of a machine, `|` between */
    TEMPLATE_IN_SECTION, /* a line of a section */
    TEMPLATE_IN_NUMBER,  /* key `number` */
    TEMPLATE_IN_COMMENT  /* key `comment` */
};

/* The field that `text` begins with: false, and none, where that is no brace or no field. */
bool template_field(const char *text, struct template_field *field);

/* -1: a brace that does not end, an unknown field, or one that may not stand at that place. */
int template_check(const char *text, enum template_place place, struct error *error);

#endif
