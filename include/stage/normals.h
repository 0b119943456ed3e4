/*
 * normals - the ways to estimate the normals of a mesh: one table, which --normals of the tools
 * takes its words from.
 *
 * A new estimator is a function of the type below and a row in normals.c.
 */
#ifndef CLOUDMILL_NORMALS_H
#define CLOUDMILL_NORMALS_H

#include <stdbool.h>

#include "base/error.h"
#include "math/point_grid.h"
#include "mesh/mesh.h"
#include "meshing/meshing.h"

/* Points that a quadric goes through unless it is said; and what the mesh says that its vertices
 * may be off: so many standard deviations. */
enum { NORMALS_NEIGHBOURS = 40 };
#define LEDGER_SIGMAS 3.0

/* What is to be said of vertices that were rid of noise, of all parts of a cloud together. */
struct smoothed_parts {
    size_t n;                 /* parts */
    double noise;             /* one standard deviation, mm, of all of them */
    size_t vertices;          /* of these: */
    size_t thin, moved, kept; /* as of struct smooth_nodes */
    size_t points[2];         /* that most vertices of a part begin with: the fewest and the most */
    double error[2]; /* of the vertices moved, one standard deviation, mm: the least and the most
                        of a part */
};

/* What normals are estimated from, besides the mesh. */
struct normals_options {
    struct vec3 *point; /* of the scan, which are sorted; NULL: there is only the mesh */
    size_t n;
    const struct point_grid *scan; /* they, sorted already; NULL: they are not */
    double spacing;                /* mean spacing of the points, mm */
    double noise; /* of the points, one standard deviation, mm, that vertices are rid of; 0: none */
    int neighbours; /* points that a surface goes through; 0: chosen */
    int threads;
    double *certain; /* vertices that have theirs: meshing/node_heights.h; NULL: none */
    double effort;   /* effort.h */
    struct smoothed_parts *parts; /* they get what is said of noise; NULL: it is said at once */
    bool silent;                  /* a trial: nothing is said */
    bool explained; /* vertices are rid of noise only where a surface soon explains the points */
};

struct normal_estimator {
    const char *name; /* as --normals has it */
    bool of_scan;     /* cloud2mesh has it ... */
    bool of_mesh;     /* ... and meshnorm, whose mesh may have normals */
    bool of_surface;  /* they are those of the surface that the points lie on, not of the facets */
    /* Fills mesh->normal, and what else follows from the surface: mesh->kmax, the places of
     * vertices, the ledger and its maker.  -1 and why. */
    int (*estimate)(struct mesh *mesh, const struct normals_options *options, struct error *error);
};

/* The words of --normals, "one|two", of cloud2mesh or else of meshnorm: the default first; and the
 * estimator of word k. */
const char *normals_words(bool of_scan);
const struct normal_estimator *normals_find(bool of_scan, int k);

/* Says how far vertices are off their quadrics, the worst of which is `at`; and how they were
 * moved, one to `at` the farthest. */
void say_fitted(const struct scan_normals *r, size_t vertices, struct vec3 at);
void say_smoothed(const struct smooth_nodes *r, size_t vertices, struct vec3 at,
                  const struct normals_options *options);

/* Says that of all parts, none: nothing. */
void say_smoothed_parts(const struct smoothed_parts *all);

/* The estimator of that name. */
const struct normal_estimator *normals_of(const char *name);

#endif
