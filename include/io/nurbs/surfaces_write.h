/*
 * surfaces_write - NURBS surfaces out, in mm: as plain text, cloudmill-nurbs(5), or as IGES 5.3.
 */
#ifndef CLOUDMILL_SURFACES_WRITE_H
#define CLOUDMILL_SURFACES_WRITE_H

#include "base/out.h"
#include "nurbs/patch.h"

/* Loops must be polygons of straight lines in the parameters.  `remark`: lines for people at the
 * head, each ended by '\n'; in IGES a longer one than 72 characters goes on after a backslash. */
void surfaces_write_text(struct out *out, const struct patches *patches, const char *remark);

/*
 * The same as rational B-spline surfaces (entity 128), those with loops trimmed (144): one for each
 * loop that runs counter-clockwise, with the clockwise ones inside it (142 with a 126 of the first
 * degree, in the parameters).
 */
void surfaces_write_iges(struct out *out, const struct patches *patches, const char *remark);

#endif
