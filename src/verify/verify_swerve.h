/*
 * verify_swerve - one place of a cut that is off an even course: a digit or a sign that is wrong in
 * one block.  The ball's centre goes there and back, while before and after it the course is one
 * line; or the tool axis does, which is steady before and after it.  Where the part bends the ball
 * or the axis, they turn in more blocks than two, or go on otherwise than they came.
 */
#ifndef CLOUDMILL_VERIFY_SWERVE_H
#define CLOUDMILL_VERIFY_SWERVE_H

#include "verify/verify.h"

/* Adds the worst of each, if there is one, as a fault. */
void verify_swerve(struct verdict *v);

#endif
