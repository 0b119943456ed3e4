/*
 * surfaces - NURBS surfaces from any file that holds them, recognised by content: IGES, STEP, or
 * plain text.  The door of this folder.
 *
 * In: a file.  Out: trimmed patches (nurbs/patch.h) in mm, and counts of what was not read.  Two
 * stages, what the file is made of and what that means:
 *
 *   IGES 5.3             iges.h; iges_curve.h, iges_surface.h, iges_construct.h, iges_trim.h
 *   STEP, ISO 10303-21   step.h; step_geometry.h, step_model.h (ISO 10303-42)
 *   text                 nurbs_text.h, cloudmill-nurbs(5)
 */
#ifndef CLOUDMILL_SURFACES_H
#define CLOUDMILL_SURFACES_H

#include "nurbs/patch.h"

/* What a file says of its unit, for messages; of IGES alone. */
struct surfaces_unit {
    char flag[16];  /* name of its unit flag, empty: none */
    char other[16]; /* the name beside the flag where it says something else, or empty */
    double scale;   /* model space scale */
    bool missing;   /* a STEP file that states none */
};

/* Appends the surfaces of a file (NULL or "-": standard input), in mm.  `mm` > 0 is the file's unit
 * whatever it says itself. */
int surfaces_read(const char *file, double mm, struct patches *patches, struct surfaces_unit *unit,
                  struct error *error);

/* Says what the files have that is not read: kinds of trimming curves and of surfaces.  False when
 * there is anything. */
bool surfaces_tell(const struct patches *patches);

/* Says what a file tells of its unit; `taken`: the name of the unit asked for instead, or NULL. */
void surfaces_tell_unit(const char *file, const struct surfaces_unit *unit, const char *taken);

#endif
