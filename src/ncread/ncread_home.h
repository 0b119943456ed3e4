/*
 * ncread_home - how high the tool is where nothing follows it: on the way to a place of the
 * machine, and at rapid without tool-centre-point control while rotary axes are turned.
 *
 * Z goes home, or by a word to where it is known, before X, Y and the rotary axes go.  What is
 * wrong whatever the part is a remark; what depends on how high the part is a blind move of the
 * motion, which the judge looks at.
 */
#ifndef CLOUDMILL_NCREAD_HOME_H
#define CLOUDMILL_NCREAD_HOME_H

#include <stdbool.h>

struct ncread;
struct ncread_place;

struct ncread_home {
    bool high;           /* Z is at a place of the machine */
    bool raised;         /* or was raised from where it was known */
    bool z, xy, turn;    /* this block names Z; X or Y; a rotary axis */
    bool called;         /* a tool was called, of Klartext */
    bool strayed, early; /* remarked: a place of the work, a move before Z is known, ... */
    bool low;            /* ... a Z of the machine that may be low */
};

/* The words of the block just read, before it moves; for Klartext its words as text. */
void ncread_home_words(struct ncread *c);
void ncread_home_text(struct ncread *c, int n, const char *const word[]);

/* The block goes to a place of the work; tracked: where the tip goes is known. */
void ncread_home_go(struct ncread *c, const struct ncread_place *to, bool rapid, bool tracked);

#endif
