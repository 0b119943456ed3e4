/*
 * post_setup - what a program will be like, before it is planned: in which frame, with drilling
 * cycles of the control or without, with tool-centre-point control or without; and the plan.
 */
#ifndef CLOUDMILL_POST_SETUP_H
#define CLOUDMILL_POST_SETUP_H

#include "post/dialect.h"

/* What the user chose. */
struct nc_post_options {
    bool plane, inch;
    enum nc_axis_words axis;
};

/*
 * Brings path and machine into the program's frame and fills the plan.  Holes stay drilling cycles
 * where the tool stands upright in that frame; else they become motions.  Where vectors, which
 * leave the rotary axes to the control, find no way within the travel, rotary words are taken, with
 * which the tool may turn back off the part.  -1, and *unmet where the
 * machine cannot get there: the error says the place.
 */
int nc_settle(struct nc_program *p, struct nc_plan *plan, struct path *path,
              struct machine *machine, const struct dialect *dialect, struct nc_post_options choice,
              bool *unmet, struct error *error);

#endif
