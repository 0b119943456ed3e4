/*
 * step_face - a face of a STEP file (ISO 10303-42): its surface, and its bounds of edges, of the
 * corners of a polygon, or of a vertex.
 */
#ifndef CLOUDMILL_STEP_FACE_H
#define CLOUDMILL_STEP_FACE_H

#include "step_geometry.h"

/*
 * Appends the face of `v`, whose attributes `face` has, as a patch with what `patch` says of it:
 * its number, its shell.  A surface of a kind that is not read is counted as left out; -1: the file
 * is not what it should be.
 */
int step_face(const struct step_place *place, const struct step_values *v,
              const struct step_value *face, struct patch patch, struct patches *patches,
              struct error *error);

#endif
