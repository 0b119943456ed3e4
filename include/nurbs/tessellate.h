/*
 * tessellate - one NURBS patch as triangles: vertices with exact points, normals and curvatures.
 */
#ifndef CLOUDMILL_TESSELLATE_H
#define CLOUDMILL_TESSELLATE_H

#include "mesh/mesh.h"
#include "nurbs/patch.h"

/* The triangles of one patch.  Where the surface may have a kink (nurbs_axis_breaks) each side has
 * vertices of its own, so that a vertex belongs to one piece of the surface. */
struct sheet {
    struct uvs at;
    struct vec3s point, normal; /* normals along dS/du x dS/dv */
    struct doubles k1, k2;      /* as nurbs_place */
    struct ints piece;          /* of each vertex (tessellate_piece) */
    struct faces face;          /* counter-clockwise seen from where the normals point */
    double error;               /* how far a triangle is off at most, mm: at its middle and those of
                                   its sides; with a tolerance, at nine places more */
    struct vec3 error_at;       /* where */
    bool too_fine;              /* the tolerance needs more than TESSELLATE_CELLS_MAX: not made */
    double gap;         /* between curves of a loop, where it is more than a little, mm ... */
    struct vec3 gap_at; /* ... and where: a straight line of the range is taken there */
    double off;         /* how far trimming curves in space lie off the surface, mm */
    size_t lost;        /* of these, loops that do not close on the surface: left out */
    enum patch_side side;
    size_t unclear;          /* places in which the trimming crosses itself */
    bool refused;            /* for one of these, and emptied (nurbs_report.h) */
    size_t lines_u, lines_v; /* of the grid */
};

#define TESSELLATE_CELLS_MAX 4000000

struct tessellate_options {
    int n;            /* cells in each direction, or 0: as many as the tolerance needs */
    double tolerance; /* mm: of the trimming, and where n is 0 of the surface */
    int threads;      /* for this patch; as in parallel.h */
};

/*
 * The cells of a grid of parameter lines, two triangles each, cut off along the trimming.  To a
 * tolerance the grid is made finer until every triangle keeps it, or until finer grids hardly help:
 * sheet->error tells.  Trimming that crosses itself is followed more closely, to see whether it
 * does.
 */
void tessellate(const struct patch *patch, struct tessellate_options how, struct sheet *sheet);

/* The surface with its range narrowed to one piece (it shares the memory of the surface). */
struct nurbs tessellate_piece(const struct nurbs *surface, int piece);

void sheet_free(struct sheet *sheet);

#endif
