/*
 * scansmooth - the vertices of a mesh moved from noisy points of the scan onto the surface that the
 * scan stands for, with its normals and curvatures.
 *
 * A robust quadric (Tukey's biweight) through the nearest points of the scan; the vertex goes to its
 * foot on it.  How many points is a trade: through k points of noise sigma the foot is uncertain by
 * about 2 sigma / sqrt(k) within the cloud and by more at its border, but the wider the
 * neighbourhood, the more of the surface is no quadric.  So the widest neighbourhood is taken whose
 * foot agrees with those of its nearer halves within what noise explains (O. Lepski's rule, Theory
 * of Probability and its Applications 35, 1991).  Where even few points are bent too much, as on a rib
 * or in a groove, they are taken from a neighbourhood that is six times as long the way it runs; that
 * way is the one in which such a neighbourhood is fitted best (not on meshes of more than about
 * 70,000 vertices, for its time).
 */
#ifndef CLOUDMILL_SCANSMOOTH_H
#define CLOUDMILL_SCANSMOOTH_H

#include "buckets.h"
#include "mesh.h"

struct scansmooth {
    size_t moved;    /* vertices on a quadric now */
    size_t kept;     /* where no quadric explains the points (an edge): not moved */
    size_t thin;     /* too few points for a quadric: not moved, the facets' normal */
    size_t at;       /* the vertex that was moved farthest */
    double farthest; /* by so much, mm */
    double error;    /* one standard deviation of the moved vertices, mm, as the fits have it */
    size_t typical;  /* neighbourhood that most vertices begin with */
};

/*
 * `sigma` > 0: the noise, one standard deviation (noise.h).  `neighbours`: so many points for all
 * quadrics; 0: chosen, from 24 to 384 by a sample of the vertices and then for each.  The mesh gets
 * normals and kmax.  The result does not depend on the number of threads.
 */
struct scansmooth scansmooth(struct mesh *mesh, const struct buckets *buckets, double sigma,
                             size_t neighbours, int threads);

#endif
