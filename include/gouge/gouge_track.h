/*
 * gouge_track - the guard points that a tool comes near to along its way, kept at hand.
 *
 * Motions that follow each other, and curves fitted to one run again and again, ask about the same
 * places.  So the guard points next to a straight piece of the way, and a little beyond, are kept:
 * places that go along with it ask these few alone.  The answers are those of gouge.h, digit by
 * digit.  One track is for one thread.
 */
#ifndef CLOUDMILL_GOUGE_TRACK_H
#define CLOUDMILL_GOUGE_TRACK_H

#include "gouge/gouge.h"

/* What was gathered beside one piece of the way. */
struct gouge_beside {
    struct vec3 from, to;
    double within;   /* all guard points no farther than this from it, mm, */
    size_t first, n; /* of the track's points */
};

struct gouge_track {
    struct gouge_besides {
        size_t n, cap;
        struct gouge_beside *item;
    } beside;
    struct vec3s point;
    size_t at;         /* of beside: used last */
    struct vec3s near; /* guard points that it comes near to: for use within a motion */
};

void gouge_track_free(struct gouge_track *track);

/* gouge_depth_along of the track's guard, always the same one.  Quick where a piece is straight and
 * short. */
double gouge_track_depth(struct gouge_track *track, const struct gouge_check *guard, struct vec3 a,
                         struct vec3 b, double radius);

#endif
