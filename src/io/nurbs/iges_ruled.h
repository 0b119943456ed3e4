/*
 * iges_ruled - the ruled surface of an IGES file (118): straight lines between places of two curves
 * that are at the same part of their length (form 0), or of their parameters as the file counts
 * them (form 1); the second curve may run backwards (IGES 5.3, entity 118).
 */
#ifndef CLOUDMILL_IGES_RULED_H
#define CLOUDMILL_IGES_RULED_H

#include "iges.h"
#include "iges_parameters.h"
#include "math/transform.h"
#include "nurbs/curve_length.h"
#include "nurbs/patch.h"

/* One of the two curves, in pieces. */
struct iges_side {
    struct patch_loop piece;
    struct iges_ranges range;    /* the file's parameters (form 1) */
    struct curve_length *length; /* of each piece (form 0), or NULL */
    double whole;                /* length or width of the parameters */
    bool back;
};

/* The curves of an entity 118: 0, 1 when one is of a kind that is not read, or -1.  The caller
 * frees both sides in any case (iges_ruled_free). */
int iges_ruled_read(const struct iges *iges, const struct iges_entity *entity,
                    struct iges_side side[2], struct error *error);

/* Do both curves, as NURBS that run over 0..1 with each piece of a side over the same width, have
 * what belongs together at the same parameter?  Then the surface is a NURBS, not approximated. */
bool iges_ruled_exact(const struct iges_side side[2]);

/* That parameter at a part (0..1) of the curve's length or parameters. */
double iges_ruled_own(const struct iges_side *side, double part);

/* The surface, placed: u is the part, 0..1, but where it is exact as above; `rough` rises to how
 * far it is off. */
struct nurbs iges_ruled_surface(const struct iges_side side[2], const struct transform *place,
                                double *rough);

void iges_ruled_free(struct iges_side side[2]);

#endif
