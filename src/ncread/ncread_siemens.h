/*
 * ncread_siemens - blocks of the Sinumerik 840D sl and ONE (NC programming manual and the design
 * notes).
 *
 * Under TRAORI X Y Z are the tip in the frame of the work; the axis by A3= B3= C3= on the great
 * circle (ORIVECT), by rotary words in proportion (ORIAXES) or by a second point (ORICURVE).
 */
#ifndef CLOUDMILL_NCREAD_SIEMENS_H
#define CLOUDMILL_NCREAD_SIEMENS_H

#include "ncread/ncread.h"

enum siemens_move {
    MOVE_NONE,
    MOVE_RAPID,
    MOVE_LINE,
    MOVE_CW,
    MOVE_CCW,
    MOVE_CIP,
    MOVE_POLY,
    MOVE_BSPLINE
};

/* A polynomial's end and coefficients, PO[X]=(end, a2, a3, a4, a5). */
struct polynomial {
    bool named;
    double value[NC_MOTION_DEGREE];
};

/* What one block says besides its modal words. */
struct ncread_siemens_block {
    struct ncread_place to;
    bool named;   /* a word that moves something */
    bool machine; /* SUPA */
    bool turns;   /* rotary words */
    int vector_n, head_n, middle_n;
    double vector[3], middle[3], head[3];
    bool centre_named, radius_named;
    struct vec3 centre; /* absolute */
    double radius;
    double length; /* PL */
    double weight; /* PW, of a pole; weighs: named */
    bool weighs;
    struct polynomial tip[3], second[3];
};

/* The words of a block into the control's modal state and *b. */
int ncread_siemens_words(struct ncread *c, struct ncread_siemens_block *b, struct error *error);

#endif
