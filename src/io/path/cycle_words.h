/*
 * cycle_words - the words and numbers behind CYCLE, as the systems name and order them: Creo (PTC,
 * CL Output for Holemaking Cycles), NX, CATIA, SolidWorks CAM and generic APT.
 */
#ifndef CLOUDMILL_CYCLE_WORDS_H
#define CLOUDMILL_CYCLE_WORDS_H

#include "path_parse.h"

enum cycle_number {
    CYCLE_DEPTH,
    CYCLE_CLEAR,   /* CLEAR */
    CYCLE_RAPID,   /* RAPTO */
    CYCLE_RETRACT, /* RTRCTO, RETURN */
    CYCLE_STEP,
    CYCLE_NEXT,  /* of the steps behind the first, the smallest */
    CYCLE_DWELL, /* seconds */
    CYCLE_FEED,  /* mm/min */
    CYCLE_PITCH,
    CYCLE_TPI, /* turns an inch */
    CYCLE_NUMBERS
};

/* What one CYCLE says; NAN: not said.  Lengths are in the unit of the stream. */
struct cycle_words {
    enum path_cycle_kind kind;
    bool home; /* RTRCTO,AUTO: the tool leaves as high as it was */
    double value[CYCLE_NUMBERS];
};

/* The kind of hole that a word means; -1: none. */
int cycle_kind(const char *word);

/*
 * The words of the statement, the first of which is a kind.  Numbers without a name are, in this
 * order, depth, feed, turns an inch (of a tap, when there are four), clearance, step; named ones
 * may stand between them, as CATIA has INCR.  Other words are counted as unknown, with their
 * number; -1 for numbers that cannot be told and for holes that cannot be made from above.
 */
int cycle_words(struct path_parse *p, struct cycle_words *words);

#endif
