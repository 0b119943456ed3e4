/*
 * ncread_tool - which tool is in the spindle, and whose length the control reckons with.
 *
 * Where the machine file has lengths of tools, a piece of the motion gets the length of the tool
 * that makes it, and how much longer the one is that H, D or TOOL CALL has switched on: with the
 * length of another tool the tip is not where the program says.
 */
#ifndef CLOUDMILL_NCREAD_TOOL_H
#define CLOUDMILL_NCREAD_TOOL_H

#include "base/error.h"
#include "simulate/nc_motion.h"

struct ncread;

struct ncread_tool {
    int asked;    /* T, 0: none yet */
    int held;     /* in the spindle, 0: not known */
    int on;       /* whose length is on, 0: none */
    bool changes; /* M6 was read: T alone only brings a tool near */
    bool told;    /* of a length that is not known */
};

/* The words of the block just read, for controls with G code; for Klartext its words as text. */
void ncread_tool_words(struct ncread *c);
void ncread_tool_text(struct ncread *c, int n, const char *const word[]);

/* The words of a TOOL CALL that names a tool; TOOL CALL S900 says but another speed. */
bool ncread_tool_called(int n, const char *const word[]);

/* The lengths into a piece.  -1: it cuts with a tool of a head whose length is not known. */
int ncread_tool_piece(struct ncread *c, struct nc_piece *piece, struct error *error);

/* The tool is changed, for which the spindle stops; of a program of ncpost before it cuts, for amid
 * it another tool is told. */
void ncread_tool_stops(struct ncread *c);

#endif
