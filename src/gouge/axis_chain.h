/*
 * axis_chain - the points of runs that are cut one after the other, with the angles of the rotary
 * axes at each of them: what the files of axis_calm.h share.
 */
#ifndef CLOUDMILL_AXIS_CHAIN_H
#define CLOUDMILL_AXIS_CHAIN_H

#include "gouge/axis_calm.h"
#include "gouge/holder_sweep.h"
#include "machine/rotary_cost.h"

#define AXIS_CHAIN_SPARE RADIANS(0.6) /* of play, for rounding off where its bound turns */
#define AXIS_CHAIN_POLE 1e-9 /* radians: an axis that leans less is at the pole, and stays */

#define AXIS_CHAIN_FAR 1.0 /* mm: clearances beyond are all the same */

/* What the guard said of a station. */
struct axis_asked {
    bool given;
    struct vec3 axis;
    double clear; /* mm, no more than AXIS_CHAIN_FAR */
};

/* A point of the chain. */
struct axis_station {
    struct run_point *point;
    double along; /* the path of the ball's centre, mm */
    struct vec3 rule;
    double allow; /* how far the axis may be off it, radians */
    struct rotary_angles was, angles;
    bool begins; /* of a run */
    double part; /* of the way from `was` to `angles`, 0 to 1 */
    double far;  /* how far the axis may be off the one it had: less where that is not clear */

    /* As it was looked at last. */
    struct rotary_angles seen;
    struct vec3 axis; /* with those angles */
    bool moved;       /* `axis` is that of the angles, not the point's own */
    bool fresh;       /* its angles are not those that it was looked at with before */
    double clear;     /* mm, no more than AXIS_CHAIN_FAR */
    bool bad;         /* not clear, or not from the station before */

    struct axis_asked free, hit; /* as the guard was asked last: clear, and not */
};

struct axis_chain {
    const struct axis_calm_options *options;
    struct rotary_frame frame;
    struct axis_station *at;
    size_t n;
    double spare; /* how much further off its rule an axis may be now, radians */
    double reach; /* of flute, shank and holder from the ball's centre, mm */
};

/* The runs end to end, each station with the axis that it has; the caller frees `at`. */
struct axis_chain axis_chain_of(const struct axis_calm_options *options,
                                const struct axis_calm_run run[], size_t n);

/* The axis is at the pole of the rotary axes. */
bool axis_chain_at_pole(const struct axis_station *s);

/* How many threads work on its stations. */
int axis_chain_threads(const struct axis_chain *c);

/* The station may have the angles, as far as no guard is asked. */
bool axis_chain_may_have(const struct axis_chain *c, const struct axis_station *s,
                         struct rotary_angles a);

/* The mean of the angles over `half` mm before and after each station, less near the ends; the
 * caller frees it. */
struct rotary_angles *axis_chain_means(const struct axis_chain *c, double half);

/* The station's angles when it has gone this part of the way from those that it had. */
struct rotary_angles axis_chain_angles(const struct axis_station *s, double part);
bool axis_chain_same(struct rotary_angles a, struct rotary_angles b);

/* The station's point with the axis that it has now. */
struct run_point axis_chain_point(const struct axis_chain *c, const struct axis_station *s);

/* How far the tool is from the guard at the station with this axis, mm, no more than
 * AXIS_CHAIN_FAR.  The guard is asked only where what it said before, of other axes, does not tell:
 * no point of the tool is further from where it was than the reach times what the axis has moved.
 * If not `exact`, what is returned is a bound on the same side of the slack, a lower one if
 * clear. */
double axis_chain_clearance(const struct axis_chain *c, const struct holder_sweep *sweep,
                            struct axis_station *s, struct vec3 axis, bool exact);

/* Looks at the stations that have moved since: those at which the tool would not be clear, or to
 * which it would not come, are bad, and counted. */
size_t axis_chain_find_bad(struct axis_chain *c);

/*
 * Stations that were held back because the tool was not clear, and those near them, once more as
 * they are now: their angles come nearer to the mean over lengths that become smaller, each as far
 * as the tool is clear there and on the ways to its neighbours.  Near a place where an axis has to
 * be far off its rule others may be so, too, so that it comes there slowly.
 */
void axis_chain_ease(struct axis_chain *c);

/* Where the axis of one station is off an even turn between its neighbours, since only so the tool
 * is clear there, the stations before and after it turn towards it and back, a little each mm, as
 * far as the tool is clear then: an axis that flutters is worse for a machine than one that turns
 * for longer. */
void axis_chain_lead_to_lone(struct axis_chain *c);

#endif
