/*
 * post_template - the blocks of a program that stand as text in a machine or control file
 * (machine/template.h), with what this program fills in.
 */
#ifndef CLOUDMILL_POST_TEMPLATE_H
#define CLOUDMILL_POST_TEMPLATE_H

#include "dialect.h"

/* How the control's programs look. */
struct nc_format_options nc_format_of(const struct machine *machine);

/* The blocks of a machine's key, `|` between them; `none`: no block. */
void nc_template(struct nc_program *p, const char *text);

/* The blocks of a section of the control's file. */
void nc_section(struct nc_program *p, enum control_section section);

#endif
