/*
 * gouge_track - the guard points that a tool comes near to along its way, kept at hand.
 *
 * Motions that follow each other, and curves fitted to one run again and again, ask about the same
 * places.  So what is found about a place serves the next ones beside it:
 *
 *   ball    the guard points next to a straight piece of the way, and a little beyond: places that
 *           go along with it ask these few alone
 *   holder  how far it is from the guard in one pose: poses that are not farther from that one have
 *           no need to be asked about; and what the last few poses were answered
 *
 * The answers are those of gouge.h, digit by digit.  One track is for one thread.
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

/* A pose of the holder, and what was answered. */
struct gouge_pose {
    struct vec3 ball, axis;
    double below, clear;
};

enum { GOUGE_POSES = 4 };

struct gouge_track {
    struct gouge_besides {
        size_t n, cap;
        struct gouge_beside *item;
    } beside;
    struct vec3s point;
    size_t at; /* of beside: used last */

    /* A pose of the holder, and what it is clear by at least; 0: none is known. */
    struct vec3 ball, axis;
    double clear;
    struct gouge_pose pose[GOUGE_POSES];
    size_t poses;              /* asked so far: the last ones are kept */
    struct kdtree_touch touch; /* the guard point that it was nearest to, last */
};

void gouge_track_free(struct gouge_track *track);

/* gouge_depth_along of the track's guard, always the same one.  Quick where a piece is straight and
 * short. */
double gouge_track_depth(struct gouge_track *track, const struct gouge_check *guard, struct vec3 a,
                         struct vec3 b, double radius);

/* gouge_holder of the track's guard and always the same holder. */
double gouge_track_holder(struct gouge_track *track, const struct gouge_check *guard,
                          const struct holder *holder, struct vec3 ball, struct vec3 axis,
                          double below);

/* True if the holder's every place is `least` mm, more than 0, or more from the guard in this pose
 * (gouge_holder_clear). */
bool gouge_track_clear(struct gouge_track *track, const struct gouge_check *guard,
                       const struct holder *holder, struct vec3 ball, struct vec3 axis,
                       double least);

#endif
