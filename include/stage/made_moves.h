/*
 * made_moves - rapid moves that a path does not have and its program needs: a retract so that a
 * rotary axis can turn, the turn, the return.  Nobody has looked at them before, so they are held
 * against the scan that the path names, or the mesh that it was made on.
 */
#ifndef CLOUDMILL_MADE_MOVES_H
#define CLOUDMILL_MADE_MOVES_H

#include "base/unmet.h"
#include "curve/motion.h"
#include "gouge/gouge_refit.h"
#include "io/path/path.h"

/* From pose to pose, straight, mm. */
struct made_move {
    struct pose from, to;
    unsigned line; /* of the path, after which it is made */
};

struct made_moves {
    size_t n, cap;
    struct made_move *item;
};

/* The tool of a path, as long as its lengths are mm; how deep it may go is not said. */
struct gouge_refit_options made_moves_tool(const struct path *path);

/*
 * Sweeps the tool along each of the moves through the points of the scan that the path names, but
 * for outliers, or of the mesh; says with `unmet` where it goes deeper than `deep` mm and the
 * scan's noise explain, how deep, and for which line.  A scan that is not there is said, a mesh
 * that is not is unmet, and nothing is found.  -1: it is there, and cannot be read.
 */
int made_moves_check(const struct made_moves *moves, const struct path *path,
                     struct gouge_refit_options tool, double deep, int threads,
                     struct unmets *unmet, struct error *error);

#endif
