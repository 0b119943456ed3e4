/*
 * ncread_fanuc - blocks of the Fanuc 30i family (operator's manual B-63944 and the design notes).
 *
 * G43.4: X Y Z are the tip in the frame of the work, rotary words and tip go in proportion.
 * G43.5: I J K is the tool axis, which swings on the great circle.  G06.2: a B-spline from the
 * place where the tool is (its first pole), a knot in each block and the last ones alone.
 */
#ifndef CLOUDMILL_NCREAD_FANUC_H
#define CLOUDMILL_NCREAD_FANUC_H

#include "ncread/ncread.h"

enum fanuc_move {
    MOVE_NONE = -1,
    MOVE_RAPID,
    MOVE_LINE,
    MOVE_CW,
    MOVE_CCW,
    MOVE_SPACE, /* G02.4, a point on the way and then the end */
    MOVE_SPLINE = 6
};

/* What one block says besides its modal words. */
struct ncread_fanuc_block {
    struct ncread_place to;
    bool named; /* X Y Z or a rotary word */
    bool centre_named[3], knot_named, weight_named, radius_named;
    double centre[3], weight, radius; /* centre[2] is K: a knot under G06.2 */
    bool machine, home, spline_begins;
    bool tool; /* G43.4 or G43.5 stands in this block */
};

/* The words of a block into the control's modal state and *b. */
int ncread_fanuc_words(struct ncread *c, struct ncread_fanuc_block *b, struct error *error);

#endif
