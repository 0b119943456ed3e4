/*
 * nurbs_report - tables about NURBS surfaces, and what there is to say of their trimming.
 */
#ifndef CLOUDMILL_NURBS_REPORT_H
#define CLOUDMILL_NURBS_REPORT_H

#include "nurbs/concave_radius.h"
#include "nurbs/patch.h"
#include "nurbs/tessellate.h"

/* A table `entity,u,v,x,y,z,nx,ny,nz` with n x n places of each surface, v fastest, over its range
 * and untrimmed; normals along dS/du x dS/dv, at a knot those of the span behind it.  15 digits. */
void nurbs_report_grid(const char *file, const struct patches *patches, int n);

/* A table `surface,radius,u,v,x,y,z`: where each surface is most tightly hollow
 * (concave_radius_find_all), and last the largest ball that fits all of them. */
void nurbs_report_radii(const char *file, const struct patches *patches,
                        const struct concave_radius *hollow);

/* Says of each surface's sheet what its trimming left unclear; curves in space further than `fine`
 * mm off their surface. */
void nurbs_report_trimming(const struct patches *patches, const struct sheet *sheet, double fine);

#endif
