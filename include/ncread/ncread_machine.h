/*
 * ncread_machine - what a reader of programs needs of a machine file: the rotary axes as matrices,
 * and the travel and largest feed of each axis.
 */
#ifndef CLOUDMILL_NCREAD_MACHINE_H
#define CLOUDMILL_NCREAD_MACHINE_H

#include "machine/machine.h"
#include "simulate/verify_kinematics.h"

/* The axes from the keys type, axes, axis.* and centre.* themselves. */
struct verify_kinematics ncread_rig(const struct machine *machine);

#endif
