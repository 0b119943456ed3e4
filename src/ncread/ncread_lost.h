/*
 * ncread_lost - words that a control's file has before the first cut, so that nothing of the
 * program before is still on, and that a program of ncpost lacks there: somebody took them out.
 */
#ifndef CLOUDMILL_NCREAD_LOST_H
#define CLOUDMILL_NCREAD_LOST_H

#include <stdbool.h>

struct ncread;

enum { NCREAD_LOST_G = 10000, NCREAD_LOST_RESETS = 5 };

/* Which stood in the program so far. */
struct ncread_lost {
    bool g[NCREAD_LOST_G]; /* by ten times their number */
    bool oriwks;
    bool tcp;                       /* tool centre point control was on before the block */
    bool reset[NCREAD_LOST_RESETS]; /* words that end what the program before may have left on */
};

/* The words of the block just read. */
void ncread_lost_words(struct ncread *c);

/* The same of a block of plain language. */
void ncread_lost_text(struct ncread *c);

/* D of the tool's call is the number of its length, as the control's file says (Fagor). */
bool ncread_lost_edge(const struct ncread *c);

/* The first cut begins: remarks what is missing. */
void ncread_lost_tell(struct ncread *c);

#endif
