/*
 * iges_global - the global section of an IGES file: its delimiters, its unit, its scale.
 */
#ifndef CLOUDMILL_IGES_GLOBAL_H
#define CLOUDMILL_IGES_GLOBAL_H

#include "iges.h"

/* Reads iges->global and fills in what comes from it.  What is left out has its default: `,` and
 * `;`, inches, scale 1.  A unit flag that IGES does not know and a scale that is not positive are
 * errors. */
int iges_global(struct iges *iges, struct error *error);

#endif
