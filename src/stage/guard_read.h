/*
 * guard_read - the scan that the ball is kept clear of: read, placed as the mesh is, and made into
 * a gouge check.
 */
#ifndef CLOUDMILL_GUARD_READ_H
#define CLOUDMILL_GUARD_READ_H

#include "base/cli.h"
#include "base/unmet.h"
#include "gouge/gouge.h"
#include "mesh/mesh.h"
#include "stage/gouge_options.h"

/* The scan that guards. */
struct guard_scan {
    struct vec3s point;         /* of all its files, placed, mm; none: no scan guards */
    struct vec3s facet;         /* of those that are meshes: close points of their facets */
    size_t meshes;              /* so many of them ... */
    size_t open;                /* ... of which so many have a border */
    bool named;                 /* the stream was made from it: its head says these very points */
    struct scan_sources source; /* what a stream is to name: also where it can't be had */
};

/*
 * Reads it.  Files are placed as `named` says that the mesh was (turned, shifted, or from other
 * units), those of -g too.  If the scan that `stream` ("the mesh") names was piped in, can't be
 * read, or is not what it was (number and hash of its points), this is said, with what guards
 * `instead`, and there are no points; but for a piped one it is unmet, and said under -q, too.
 * Of a file that is a mesh its facets stand for what is between its corners: where they are large
 * for a ball of this radius (mm; 0: not known) points on them are added, and close ones are kept
 * beside them, for a ball sinks between corners at the mesh's border.
 * -1: a file of -g can't be read or has no points.
 */
int guard_scan_read(const struct guard_choice *choice, const struct scan_sources *named,
                    double radius, const char *stream, const char *instead, struct guard_scan *scan,
                    struct unmets *unmet, struct error *error);

void guard_scan_free(struct guard_scan *scan);

/* Close points of the mesh that a path names, with its corners, for a ball of this radius, mm.
 * -1, and why not: it was piped in, is gone, or is not what it was (`why->system`: it is there and
 * can't be read). */
int guard_mesh_read(const struct scan_source *named, double radius, struct vec3s *points,
                    struct error *why);

/* What is made of the points: guard_points.h. */
struct guard_read_options {
    double radius;    /* of the ball, mm */
    double tolerance; /* of the path, mm: the ball sinks between points by a fifth of it at most */
    double
        noise; /* of the scan, mm; negative: as found where it is above a tenth of the tolerance */
    double effort; /* effort.h */
    int threads;
    struct unmets *unmet;           /* sharp edges that it does not know; NULL: only said */
    struct vec3s certain, doubtful; /* what becomes of it: its points (guard_points.h), ... */
    struct vec3s curtain;           /* ... those that hang under its rims (roof.h) ... */
    struct vec3s believed; /* ... and with a mesh its points as they are, no outliers, ... */
    struct vec3s facets;   /* ... where it is itself a mesh, close points of its facets */
};

/*
 * The gouge check of the scan's points, which are freed, and of the mesh's sharp edges.  Of a
 * scan whose files are all meshes its facets are the part, as they are: nothing is looked for
 * between them or beyond their rim, nor noise; and below closed ones is no material.  NULL if
 * there are too many points, or if the mesh is clearly elsewhere: more of its vertices than
 * guard_scan_near allows further than `near` mm from every point of the scan.  rule->noise becomes
 * what was taken out.
 */
struct gouge_check *guard_read(struct guard_scan *scan, const struct mesh *mesh, double near,
                               struct guard_read_options *rule, struct error *error);

/* The same for a path, whose points are not known yet: the scan's points stay for a later look. */
struct gouge_check *guard_read_scan(struct guard_scan *scan, struct guard_read_options *rule,
                                    struct error *error);

/* That look: -1 if more than half of the places, which are `what`, are further than `near` mm from
 * every point of the scan, of the named one 95 of a hundred, since its mesh may have been extended
 * far beyond it; but a place that has points over and under it, seen from above no further beside
 * it, is on a wall of it. */
int guard_scan_near(const struct guard_scan *scan, const struct vec3s *place, const char *what,
                    double near, int threads, struct error *error);

#endif
