/*
 * cloud - a scan before it is a mesh.
 *
 * In: points as files give them, in any order, mm.  Out: points that lie on the surface, with what
 * is known of them; what a mesh or a guard is made of.  The stages, in the order of cloud2mesh:
 *
 *   1. Extent and mean spacing of the points, seen from above: plan_extent.h.
 *   2. Points twice, outliers and points under others go: outliers.h (the local outlier factor of
 *      Breunig, Kriegel, Ng, Sander 2000; Tukey's biweight).
 *   3. The noise of the scan, one standard deviation: noise.h; whether scans lie over each other:
 *      sheets.h.  Who decides by 2 and 3 what is believed of a scan: believed.h.
 *   4. Where one projection does not serve, the cloud is divided by orientation (Chui, Chiu, Yu
 *      2007, section 7): segment.h; how, segment_steps.h: normals on one side of the surface (Hoppe
 *      et al. 1992), connected components, surfaces continued beyond sharp edges.
 *   5. Points on walls come last: wall_points.h.
 *   6. Holes, which no facet is to bridge: holes.h.
 *   7. The surface continued beyond its outer border: extend.h.
 *
 * A scan that a ball is kept clear of is looked at by 1 to 3 too, and gets points between its own
 * where these are far apart: upsample.h.
 */
#ifndef CLOUDMILL_CLOUD_CLOUD_H
#define CLOUDMILL_CLOUD_CLOUD_H

#include "cloud/believed.h"
#include "cloud/extend.h"
#include "cloud/holes.h"
#include "cloud/noise.h"
#include "cloud/outliers.h"
#include "cloud/plan_extent.h"
#include "cloud/segment.h"
#include "cloud/upsample.h"
#include "cloud/wall_points.h"

#endif
