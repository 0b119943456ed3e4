/*
 * ncread_meaning - words that a reader does not know by itself: what the key `words` of a control's
 * file says of them, and how they are told.
 *
 *     words = G234: tcp | G49: length.off | G43: never | {hash}RTCP ON: tcp
 *     words = G: unread | G0-G4: read | G17-G19: read
 *
 * A letter alone stands for all of its words that have no entry of their own.  A word without a
 * meaning is named once, at the end, and taken to have no effect where its kind cannot move the
 * tool (M of a machine's maker); else, and every G, it is refused.
 */
#ifndef CLOUDMILL_NCREAD_MEANING_H
#define CLOUDMILL_NCREAD_MEANING_H

#include "base/error.h"
#include "ncread_word.h"

struct ncread;

enum ncread_meaning {
    MEANS_IDLE,        /* moves nothing */
    MEANS_OFFSET,      /* the work offset, with its number H */
    MEANS_TCP,         /* tool-centre-point control on, with the tool's length */
    MEANS_TCP_VECTORS, /* the same, the tool axis as I J K */
    MEANS_TCP_OFF,
    MEANS_LENGTH, /* the tool's length on, off */
    MEANS_LENGTH_OFF,
    MEANS_NEVER,      /* of G43: the length is always on, no word is needed */
    MEANS_HOME,       /* to a place of the machine */
    MEANS_MACHINE_ON, /* X Y Z are those of the machine from here on, and no more */
    MEANS_MACHINE_OFF,
    MEANS_MM, /* lengths are millimetres, inches */
    MEANS_INCH,
    MEANS_END,    /* of the program */
    MEANS_READ,   /* as the dialect reads it: nothing of its own is known */
    MEANS_UNREAD, /* something else than in the dialect, or nothing: refused */
    MEANS_NOTHING_KNOWN
};

/* What the file says of a word, as `G54.1` or any text between blanks. */
enum ncread_meaning ncread_meaning_of(const struct ncread *c, const char *word);
enum ncread_meaning ncread_meaning_of_word(const struct ncread *c, const struct ncread_word *w);

/* Does what it says to the state. */
int ncread_meaning_apply(struct ncread *c, enum ncread_meaning meaning, struct error *error);

/* The key itself: -1 with what is wrong with it. */
int ncread_meaning_check(const char *words, struct error *error);

/* A word of which nothing is known but that it moves nothing: remembered, to be told once. */
void ncread_meaning_note(struct ncread *c, const char *word);

/* A G or M number, in tenths, whose words move the tool or change where it goes, and that is not
 * read: cycles, subprograms, scaling and the like; what it is, NULL: none of these. */
const char *ncread_meaning_moves(char letter, int tenths);

/* A name of Siemens whose value moves the tool or shapes its path, and that is not read: an axis
 * beyond X Y Z, a radius or angle of polar places, a corner. */
bool ncread_meaning_shapes(const char *name);

/* Tells the words that were noted. */
void ncread_meaning_tell(struct ncread *c);

#endif
