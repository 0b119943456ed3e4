/*
 * simulate - what a program does to a part, evaluated by formulas of this folder alone.  The door.
 *
 * In: a motion (nc_motion.h), as programs are read into it, and points of the part.  Out: how deep
 * the ball goes and what it leaves, what shaft and holder run into, what is left of the stock, what
 * the axes do.  It is the judge's half of the suite: nothing here is shared with what fits, guards
 * or writes tool paths, so that a mistake made there is not made here once more.
 *
 * Stages:
 *   1. nc_motion.h          pieces of a motion, evaluated anywhere: lines, arcs, polynomials,
 *                           rational B-splines (de Boor), the tool axis on the great circle, by
 *                           rotary axes or by a second point;
 *      verify_kinematics.h  the machine's rotary axes (Paden-Kahan subproblems);
 *   2. centre_path.h        where the ball's centre goes, as straight segments;
 *   3. deviation_map.h      the ball rolled over the points: gouges and material left;
 *      part_coverage.h      each point cut, out of the tool's reach, or left;
 *      unseen_wall.h        where walls may stand that a scan has no points on;
 *      excursion.h          a cut that leaves the part and comes back;
 *      path_compare.h       a program against the path that it was made from;
 *   4. tool_shape.h         flute, shank and holder as a body of revolution;
 *      holder_collision.h   that body against points or stock, by clearance bounds;
 *      under_scan.h         that body and the ball in the material under a scan;
 *   5. stock.h              the stock as columns (dexels), cut by capsules;
 *      stock_block.h        the block that it is at first; stock_rest.h: what is left on the part;
 *      stock_simulate.h     the motion run over it, pass by pass;
 *   6. axis_limits.h        travel, turns, speeds and time of each axis.
 */
#ifndef CLOUDMILL_SIMULATE_H
#define CLOUDMILL_SIMULATE_H

#include "simulate/axis_limits.h"
#include "simulate/centre_path.h"
#include "simulate/part_coverage.h"
#include "simulate/deviation_map.h"
#include "simulate/excursion.h"
#include "simulate/holder_collision.h"
#include "simulate/machine_time.h"
#include "simulate/nc_motion.h"
#include "simulate/path_compare.h"
#include "simulate/stock_block.h"
#include "simulate/stock_rest.h"
#include "simulate/stock_simulate.h"
#include "simulate/under_scan.h"
#include "simulate/unseen_wall.h"

#endif
