/*
 * nurbs_report - tables about NURBS surfaces, and messages about their skin.
 */
#ifndef CLOUDMILL_NURBS_REPORT_H
#define CLOUDMILL_NURBS_REPORT_H

#include "nurbs/concave_radius.h"
#include "nurbs/patch.h"
#include "nurbs/skin.h"
#include "nurbs/tessellate.h"

/* A table `entity,u,v,x,y,z,nx,ny,nz` with n x n places of each surface, v fastest, over its range
 * and untrimmed; normals along dS/du x dS/dv, at a knot those of the span after it.  15 digits. */
void nurbs_report_grid(const char *file, const struct patches *patches, int n);

/* A table `surface,radius,u,v,x,y,z`: the smallest concave radius of each surface and its place
 * (concave_radius_find_all), 0 at a hollow edge of its own; then the sharpest hollow edge of all,
 * and last the largest ball that fits. */
void nurbs_report_radii(const char *file, const struct patches *patches,
                        const struct concave_radius *concave, const struct patch_mesh *mesh);

/* The surface whose approximation, or that of its trimming, is farthest off what the file has, and
 * how far, mm; NULL: none is off. */
const struct patch *nurbs_report_roughest(const struct patches *patches, double *rough);

/* Tells of each body whether it is closed, its genus, area and volume, and of open edges the loops
 * they form, with note(). */
void nurbs_report_skin(const struct patches *patches, const struct skin *skin);

#endif
