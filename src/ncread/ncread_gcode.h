/*
 * ncread_gcode - the G code that Fanuc and LinuxCNC share (ISO 6983): modal G words, the words of
 * places, centres and radii, moves in the frame of the machine.
 */
#ifndef CLOUDMILL_NCREAD_GCODE_H
#define CLOUDMILL_NCREAD_GCODE_H

#include "ncread_state.h"

/* What moves are on, in ncread.move. */
enum gcode_move {
    MOVE_NONE = -1,
    MOVE_RAPID,
    MOVE_LINE,
    MOVE_CW,
    MOVE_CCW,
    MOVE_SPACE, /* Fanuc's G02.4: a point on the way and then the end */
    MOVE_SPLINE = 6
};

/* What one block says besides its modal words. */
struct gcode_block {
    struct ncread_place to;
    bool named; /* X Y Z or a rotary word */
    bool moved; /* one that is not 0 */
    bool centre_named[3], radius_named;
    double centre[3], radius; /* centre[2] is K: a knot under G06.2 */
    bool machine, home;       /* G53, G28 */
    bool bare;                /* axis words beside its G are no place */
    bool spline_begins;       /* G06.2 stands in this block */
    bool tool;                /* G43.4 or G43.5 stands in this block */
};

/*
 * Takes a G word, in tenths: straight moves and arcs, planes, units, absolute words, kind of feed,
 * and those that do not change where the tool goes.  1: taken, 0: it is none of these, -1: it must
 * not stand here.
 */
int ncread_gcode_g(struct ncread *c, int tenths, struct error *error);

/* A G word, in tenths, is one of a list. */
bool ncread_gcode_among(int tenths, const int *list, size_t n);
#define IS_G_OF(tenths, list) ncread_gcode_among(tenths, list, sizeof(list) / sizeof *(list))

/* An error where the block has a word that is not read as the control's file says (`unread`). */
int ncread_gcode_check(struct ncread *c, struct error *error);

/* X Y Z A B C, I J K, R and F of a block: true when the word is one of them. */
bool ncread_gcode_address(struct ncread *c, const struct ncread_word *w, struct gcode_block *b);

/* A block that is no words but a statement which the control's file gives a meaning,
 * #RTCP ON: 1; another: 0. */
int ncread_gcode_statement(struct ncread *c, const char *line, struct error *error);

/* After a move to a place of the machine: the axes that the block names are not known any more. */
void ncread_gcode_forget(struct ncread *c);

/* The same of all axes. */
void ncread_gcode_forget_all(struct ncread *c);

/* The block names I, J or K. */
bool ncread_gcode_centred(const struct gcode_block *b);

/* The centre of an arc: I J K from where the piece begins, or from the zero under G90.1. */
struct vec3 ncread_gcode_centre(const struct ncread *c, const struct gcode_block *b,
                                const struct nc_piece *piece);

/* The block moves the tool: it names a place, or is an arc round to where it begins, G2 I5. */
bool ncread_gcode_goes(const struct ncread *c, const struct gcode_block *b);

#endif
