/*
 * nctemplate - blocks that a machine file words itself (template.h), or a control's own.
 */
#ifndef CLOUDMILL_NCTEMPLATE_H
#define CLOUDMILL_NCTEMPLATE_H

#include "post/dialect.h"

/* Writes the blocks of the machine's template or, where that is empty, of the control's own. */
void nc_template(struct nc_program *p, const char *own, const char *usual);

#endif
