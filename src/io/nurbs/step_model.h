/*
 * step_model - the faces of a STEP file's solids and shells (ISO 10303-42 topology, as AP203, AP214
 * and AP242 use it), wherever its assemblies place them.
 */
#ifndef CLOUDMILL_STEP_MODEL_H
#define CLOUDMILL_STEP_MODEL_H

#include "nurbs/patch.h"
#include "step.h"

/*
 * Appends all faces, in mm.  Lengths and angles are in the units of each representation's context;
 * `mm` > 0 takes the place of the file's own unit of length.  Components of assemblies are placed
 * by ITEM_DEFINED_TRANSFORMATION and MAPPED_ITEM, as often as they are used.  Surfaces that are not
 * read go to patches->left, faces with curves that are not read count them in patch->ignored.  A
 * file without a face is an error.
 */
int step_surfaces(const struct step *step, double mm, struct patches *patches, struct error *error);

#endif
