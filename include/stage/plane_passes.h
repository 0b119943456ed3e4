/*
 * plane_passes - parallel planes through a mesh as the passes of a tool path.
 */
#ifndef CLOUDMILL_PLANE_PASSES_H
#define CLOUDMILL_PLANE_PASSES_H

#include "toolpath/border_surface.h"
#include "nurbs/project.h"
#include "toolpath/passes.h"
#include "stage/toolpath.h"

struct plane_passes {
    struct pass_options rule; /* to be filled first */
    int threads;              /* as of parallel_for */
    struct projection *on;    /* contact points are put on these surfaces; NULL: stay on the mesh */
    double reach;             /* of a point to its surface, mm */
    struct border_surface
        *border_surface;     /* strips run out to the border of this scan; NULL: to the mesh's */
    double steepest, beyond; /* as of struct scallop_options */
    bool extended;           /* the mesh goes beyond the scan on purpose */
    bool region;             /* the mesh is a region of the scan's: strips end at its border */

    struct slice *cut;
    struct doubles height; /* of the planes, along their normal, mm */
    double widest;         /* distance of two planes, mm */
    bool steep;            /* the scallop that was asked for can't be kept */
    size_t left_out;       /* points that face away */
    size_t beside;         /* points without a surface */
};

/* Upright planes at `angle` radians about z, the next one always towards the upper right; for a
 * ball of this radius. */
struct pass_options plane_passes_upright(double angle, double radius);

/* The planes of a part with a projection of its own: along its rows, perpendicular to the plane
 * that these lie in. */
struct pass_options plane_passes_along(const struct mesh_part *part, double radius);

/* Planes across `normal` (unit; 0: any upright ones), `step` mm apart, through all of the mesh are
 * no more than can be made in reasonable time and memory: 100,000, and 20 million points, as each
 * crosses the facets between its neighbours.  -1: they are, the error says how many. */
int plane_passes_bounded(const struct mesh *mesh, struct vec3 normal, double step,
                         struct error *error);

/* What they cut is no longer than toolpath_length_bounded allows, as far as the areas of the facets
 * tell.  -1: it is, the error says about how long. */
int plane_passes_short(const struct plane_passes *p, const struct mesh *mesh, struct error *error);

/* How far apart the planes are in the mean, mm; infinite for one. */
double plane_passes_apart(const struct plane_passes *p);

/* Planes at equal distances of at most `step` mm. */
void plane_passes_equal(struct plane_passes *p, const struct mesh *mesh, double step);

/* Planes so far apart that the ball leaves no cusp higher than h mm; says where that can't be kept
 * (scallop.h). */
void plane_passes_scallop(struct plane_passes *p, const struct mesh *mesh, double h);

/*
 * The angle of upright planes, of DIRECTIONS over half a turn, at which the tool cuts the fewest
 * millimetres for cusps of at most h mm: the chains of up to LOOKED_AT planes are measured, for
 * all.  *length is their length, about.
 */
double plane_passes_best(const struct mesh *mesh, double radius, double h, double *length);

/* Can be read: degrees as text, or `auto`. */
bool plane_passes_direction_read(const char *text);

/* The angle that --direction asks for, radians: `auto` is plane_passes_best, which is then said. */
double plane_passes_direction(const char *text, const struct mesh *mesh, double radius, double h);

/* Has the strips of upright planes lengthened to the border of the scan of -g (pass_extend.h), if
 * there is one and the mesh states how far apart its vertices are and has no parts. */
void plane_passes_run_out(struct plane_passes *p, const struct mesh *mesh);

/* Gives the strips of n sets of planes, one after the other, to the toolpath, in as many layers as
 * the options say, and has them cut.  -1: no plane crosses anything that faces the tool. */
int plane_passes_make(struct plane_passes *set, size_t n, struct toolpath *t, struct error *error);

void plane_passes_free(struct plane_passes *p);

#endif
