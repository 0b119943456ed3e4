/*
 * link - from the end of one strip to the start of the next: with the tool down, on a low arch, or
 * over the clearance plane, by a retract and an approach.
 */
#ifndef CLOUDMILL_LINK_H
#define CLOUDMILL_LINK_H

#include <stdbool.h>

#include "gouge/gouge_lift.h"

struct link_options {
    const struct gouge_lift_options *lift; /* the guard, and how clear of it the ball must be */
    const struct holder *holder;           /* kept clear too, where it has parts */
    double radius;                         /* of the ball, mm */
    double limit;                          /* highest lift of a low link, mm */
    double rate;      /* fastest turn of the axis on a low link, radians/mm; 0: any */
    double clearance; /* z of the tip on the clearance plane, mm */
    double approach;  /* last bit of the way down, mm */
};

/*
 * Appends the points between two to `link`: a low arch from centre to centre (a tenth of its length
 * high, for there may be material just outside the border of the guard), lifted further where that
 * is not clear.  They touch nothing; the ends themselves are not appended.  Without a guard it is a
 * straight line.  False if a lift above the limit would be needed, if the lines between are not
 * clear within the tolerance, if the holder touches, or if the axis would turn too fast.
 */
bool link_low(const struct link_options *options, const struct run_point *from,
              const struct run_point *to, struct run *link);

/* The centre of the ball from a point to the clearance plane; an approach is the same reversed. */
struct retract {
    struct vec3 near; /* the approach distance off the point */
    struct vec3 out;  /* straight on, on the clearance plane or beside the part */
    struct vec3 top;  /* with the tip on the clearance plane */
    bool clear;       /* ball, shank and holder touch nothing */
};

/*
 * Along the tool axis; a flat axis: out beside the part, then up.  What the ball does along its own
 * axis the shank above it has done before, so that this is free wherever the tool fits at all.
 * Where it is not clear, straight up in z; where neither is, along the axis and not `clear`.
 */
struct retract link_retract(const struct link_options *options, const struct run_point *p);

#endif
