/*
 * nurbs_report - tables about NURBS surfaces.
 */
#ifndef CLOUDMILL_NURBS_REPORT_H
#define CLOUDMILL_NURBS_REPORT_H

#include "hollow.h"
#include "patch.h"

/* A table `entity,u,v,x,y,z,nx,ny,nz` with n x n places of each surface, v fastest, over its range
 * and untrimmed; normals along dS/du x dS/dv, at a knot those of the span behind it.  15 digits. */
void nurbs_report_grid(const char *file, const struct patches *patches, int n);

/* A table `surface,radius,u,v,x,y,z`: where each surface is most tightly hollow (hollow_find_all),
 * and last the largest ball that fits all of them. */
void nurbs_report_radii(const char *file, const struct patches *patches,
                        const struct hollow *hollow);

#endif
