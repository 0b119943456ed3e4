/* blocks - what the unit tests of a program's words share: a writer of G code, and its block. */
#ifndef CLOUDMILL_TEST_BLOCKS_H
#define CLOUDMILL_TEST_BLOCKS_H

#include <string.h>

#include "post/dialect.h"

static struct machine machine;
static struct nc_plan plan;
static struct nc_program p;

/* Fanuc words, millimetres, three digits, without block numbers, of a plan with this ability. */
static inline void blocks_begin(struct nc_ability ability)
{
    static const struct nc_format_options style = {
        .open = "(", .close = ")", .comment_width = 80, .point = true, .number = "N"};
    machine = machine_default();
    ability.unit = 1;
    ability.digits = (struct machine_digits){3, 3, 4, 3, 1};
    plan = (struct nc_plan){.ability = ability};
    p = (struct nc_program){.control = CONTROL_fanuc, .machine = &machine, .plan = &plan};
    nc_writer_begin(&p.w, NULL, style, 0, 99999);
}

/* What the block says so far; it is taken back. */
static inline const char *said(void)
{
    static char text[NC_LINE_MAX + 1];
    memcpy(text, p.w.line, p.w.n);
    text[p.w.n] = '\0';
    nc_drop(&p.w);
    return text;
}

#endif
