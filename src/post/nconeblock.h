/*
 * nconeblock - a straight motion at feed as one block: most motions of a path are, and a bound
 * shows that they may be.
 */
#ifndef CLOUDMILL_NCONEBLOCK_H
#define CLOUDMILL_NCONEBLOCK_H

#include "post/ncstep.h"

/*
 * The whole motion to a pose.  1, and nothing is done: the pose is out of reach, or one block may
 * be too far off the motion.
 */
int nc_one_block(struct nc_step *step, const struct pose *to);

#endif
