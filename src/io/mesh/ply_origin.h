/*
 * ply_origin - what a mesh says of itself, as comments in the head of a PLY file:
 *
 *     comment cloudmill mesh 1
 *     comment spacing 4
 *     comment direction 12.5
 *     comment source scan.xyz
 *     comment scan 26493 0123456789abcdef scan.xyz    points, hash, name: scan_source.h
 *     comment place 1 0 0 -5 ...       16 numbers, row by row
 *     comment extended 2.0000
 *     comment noise 0.0197
 *     comment ledger cloud2mesh 0.0120
 *     comment surface 4.634000 1.2 3.4 5.6 part.igs:7    smallest concave radius, its place, name
 *     comment surface none part.igs:9
 *     comment unmet cloud2mesh off by 0.06 mm ...    what the stages so far could not keep
 */
#ifndef CLOUDMILL_PLY_ORIGIN_H
#define CLOUDMILL_PLY_ORIGIN_H

#include "base/error.h"
#include "mesh/mesh.h"
#include "base/out.h"

/* Says nothing: zeros, and NAN for the ledger. */
struct mesh_origin ply_origin_none(void);

/* Takes over what one comment says (its text after `comment `); a comment of another program is
 * ignored.  A word that should be a number and is none is an error without a place. */
int ply_origin_read(struct mesh_origin *origin, const char *comment, struct error *error);

/* Writes the comments, those that say something.  The ledger has four decimals, rounded up; the
 * other numbers read back as they were. */
void ply_origin_write(struct out *out, const struct mesh_origin *origin);

#endif
