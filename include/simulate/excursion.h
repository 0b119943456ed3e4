/*
 * excursion - a cut that leaves the part in mid-course and comes back: a wrong pole or coefficient
 * throws the ball up where everything beside it is cut.
 *
 * Looked at are curves (B-splines, and polynomials one after the other), which are made to follow
 * the part, and pairs of straight blocks that go up and come back at a sharp angle, amid a link,
 * too.  Up is along the tool, at the top or where the curve begins or ends, for a pole thrown past
 * the other end of the tool turns it over.  A curve also counts if it ends over the part, up the
 * tool or up Z, and a straight block comes down again, and so does the end of any block there if a
 * curve comes down from it at a sharp angle.
 * A few straight blocks count that turn off the row at a sharp angle, go far aside, and turn back
 * onto it so.
 * Links from pass to pass, up, across and down in blocks of their own or as a curve that is off the
 * part over more spans than a pole reaches, do not count, nor does a pass that goes out beside the
 * part.  Lengths in mm.
 */
#ifndef CLOUDMILL_EXCURSION_H
#define CLOUDMILL_EXCURSION_H

#include "simulate/centre_path.h"

struct excursion_options {
    double radius; /* of the ball */
    double band;   /* as of deviation_map: further off it is no longer on the part */
};

struct excursion {
    size_t count;   /* how many */
    double height;  /* of the highest: how far the ball is off all points */
    size_t piece;   /* where that is, of the motion */
    struct vec3 at; /* the ball's centre there */
};

/* The excursions of a path that deviation_map_run has looked at, over n points of the part. */
struct excursion excursion_find(const struct nc_motion *motion, const struct centre_path *path,
                                const struct vec3 *point, size_t n,
                                const struct excursion_options *options);

#endif
