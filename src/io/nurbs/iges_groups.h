/*
 * iges_groups - the groups (402) that an IGES file keeps its loose faces in: a part of an assembly,
 * as systems write them that have no solids.
 */
#ifndef CLOUDMILL_IGES_GROUPS_H
#define CLOUDMILL_IGES_GROUPS_H

#include "iges.h"

/* The number of the group that each entity is directly in, from 1, of several the first; 0: none.
 * Groups are the forms 1, 7, 14 and 15.  The caller frees the array; NULL: an error. */
int *iges_groups(const struct iges *iges, struct error *error);

#endif
