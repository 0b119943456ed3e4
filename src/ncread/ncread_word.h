/*
 * ncread_word - the words of one block of a program, as strictly as the controls read them.
 */
#ifndef CLOUDMILL_NCREAD_WORD_H
#define CLOUDMILL_NCREAD_WORD_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"

enum { WORD_VALUES = 6, WORD_TEXT = 40 };

enum word_kind {
    WORD_ADDRESS, /* X1.5  G43.4  M30 */
    WORD_SET,     /* A3=0.5  I1=AC(2.)  PL=1  PO[X]=(1,2,3)  T="BALL" */
    WORD_NAME,    /* TRAORI  CIP */
    WORD_CALL     /* CYCLE832(0.01,11,0.1) */
};

struct ncread_word {
    enum word_kind kind;
    char name[WORD_TEXT]; /* X  A3  PO[X]  TRAORI */
    bool absolute;        /* AC() */
    bool by;              /* IC(): from where the axis is */
    bool shortest;        /* DC() */
    bool pointed;         /* its number has a decimal point */
    int values;           /* 0: a text or nothing */
    double value[WORD_VALUES];
};

struct ncread_words {
    size_t n, cap;
    struct ncread_word *item;
};

/*
 * Reads one number as a control takes it: an optional sign, digits, an optional point; no exponent,
 * no -0, no more than 9 digits before and 9 after the point.  -1 with the text otherwise.
 */
int ncread_word_number(const char **s, double *value, bool *pointed, struct error *error);

/* The words of a Fanuc block: letters with a number each, comments in ( ) and after `;`; a block
 * that begins with `/` is read as any other. */
int ncread_word_fanuc(const char *line, struct ncread_words *words, struct error *error);

/* The words of a Siemens block, up to a comment after `;`; `/` as there. */
int ncread_word_siemens(const char *line, struct ncread_words *words, struct error *error);

/* The word of this name, NULL: not in the block. */
const struct ncread_word *ncread_word_find(const struct ncread_words *words, const char *name);

#endif
