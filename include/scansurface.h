/*
 * scansurface - the surface that the points of a scan stand for, as points that are dense enough to
 * keep a ball off it.
 *
 * A ball sinks between points that are far apart, and rides on the crests of the noise of points
 * that are near.  So where the scan is sparse, points of a quadric through the neighbours of each
 * point are put between; and where points are spread about such a quadric as noise is, they are
 * brought to it.  Points where no quadric fits (edges, walls, hair) stay as they are.
 */
#ifndef CLOUDMILL_SCANSURFACE_H
#define CLOUDMILL_SCANSURFACE_H

#include "array.h"
#include "vec.h"

struct scansurface_rule {
    double radius; /* of the ball, mm */
    double sink;   /* how deep it may sink between points, mm */
    double noise;  /* standard deviation of what is taken out, mm; 0: nothing; negative: as found */
    double least;  /* noise found below this stays, mm */
    int threads;   /* as of parallel_for */
};

struct scansurface {
    struct vec3s point;
    double noise;        /* standard deviation of what was taken out, mm; 0: nothing was */
    size_t moved, added; /* points brought to their quadrics, points put between */
};

/*
 * Noise is what spreads 32 neighbours about their quadric by no more than 16 of them, and all over
 * the scan alike; the shape of a part, however rough, spreads the wider neighbourhood more, and in
 * one place more than in another.  It is taken out by quadrics through as many neighbours, up to
 * 96, as it spreads alike; no point moves by more than six standard deviations.
 *
 * A point put between is nearest to the point whose quadric it is on, with a neighbour of that
 * beyond it: no hole is filled and no border moves.
 *
 * More than 400,000 points are taken as they are, but for a noise that is said.
 */
void scansurface_make(const struct vec3 *point, size_t n, const struct scansurface_rule *rule,
                      struct scansurface *surface);

#endif
