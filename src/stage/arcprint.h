/*
 * arcprint - a piece of a fitted motion with the digits of the path stream.
 */
#ifndef CLOUDMILL_ARCPRINT_H
#define CLOUDMILL_ARCPRINT_H

#include "arcfit/arcfit.h"
#include "base/num.h"
#include "io/path/path.h"

enum {
    PATH_COORDINATE = 6, /* decimals of lengths in the path stream */
    PATH_VECTOR = 9,
    ARCPRINT_MAX = 16 * NUM_MAX
};

struct printed {
    struct arc_piece piece; /* as it is read back */
    struct path_arc arc;    /* radius 0: a straight line */
    struct deviation off;   /* from the reference */
};

struct printeds {
    size_t n, cap;
    struct printed *item;
};

/* The piece through its rounded ends, beginning at `from` (as printed); a line where it is shorter
 * than a thousandth of a millimetre, or rounding leaves nothing of its turn. */
struct printed arcprint_piece(const struct arc_piece *piece, struct vec3 from);

/* All pieces that follow a reference, beginning at its first point, in the place of what is in
 * `printed`.  Returns how far they are off it: infinitely where they do not lead to its end.
 * `before`: others that follow the same reference, of which the same ones are not measured again;
 * or NULL. */
struct deviation arcprint_pieces(const struct reference *reference, const struct pieces *pieces,
                                 const struct printeds *before, struct printeds *printed);

/* How many equal chords keep within `sagitta` mm of the piece, at the tracked point and at the
 * other one, `offset` mm along the axis: a power of two, at most 4096. */
int arcprint_chords(const struct arc_piece *piece, double offset, double sagitta);

/* The arc as a comment, "$$ CIRCLE/...", in at most ARCPRINT_MAX bytes. */
void arcprint_comment(const struct path_arc *arc, char *text);

#endif
