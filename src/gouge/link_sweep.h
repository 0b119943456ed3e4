/*
 * link_sweep - the whole tool swept along the straight motions of a link or a retract, as a path is
 * judged in the end.
 */
#ifndef CLOUDMILL_LINK_SWEEP_H
#define CLOUDMILL_LINK_SWEEP_H

#include "gouge/gouge_refit.h"
#include "gouge/link.h"

/* Of the tolerance: what a way at feed may be in the part. */
#define LINK_FEED 0.95

/* What of the whole tool is too deep on straight motions of its tip. */
struct link_sweep {
    struct gouge_refit_options tool;
    struct gouge_track track;
    struct gouges gouges;
};

/* Of the tool of these options; all of it is freed by link_sweep_end. */
struct link_sweep link_sweep_begin(const struct link_options *options);
void link_sweep_end(struct link_sweep *s);

/* Adds what is too deep from one point to the next to s->gouges. */
void link_sweep_to(struct link_sweep *s, const struct run_point *from, const struct run_point *to);

/* The direction out of the material, as far as the point knows. */
struct vec3 link_outward(const struct run_point *p);

#endif
