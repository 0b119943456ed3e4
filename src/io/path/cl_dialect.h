/*
 * cl_dialect - the words of one CAM system in its CL files.
 *
 * A system is one row of the table in cl_dialect.c: how to recognize it, and its own words.  What
 * all systems share (GOTO, CIRCLE, CYCLE, FEDRAT...) is read the same way for each (path_parse.h).
 */
#ifndef CLOUDMILL_CL_DIALECT_H
#define CLOUDMILL_CL_DIALECT_H

#include "path_parse.h"

struct cl_dialect {
    const char *name;
    bool (*recognize)(const struct apt *apt); /* only this system writes such a statement */
    const struct path_row *rows;              /* its own words */
    size_t n;
};

/* Sets p->dialect if this statement shows who wrote the stream. */
void cl_sniff(struct path_parse *p);

/* Ends a NURBS of NX when the statement is none of its parts: 0, or -1. */
int cl_nx_nurbs_end(struct path_parse *p);

/*
 * Adds the motion on a B-spline from where the tool is, and takes over the curve.  Its knots are
 * scaled to its length; its fallback are straight lines.  -1: the curve cannot be flattened.
 */
int cl_add_curve(struct path_parse *p, struct bspline curve);

/* Statements from BEGIN NURBS_SIEMENS to END NURBS (CATIA): 1: it was one; 0: it was not; -1. */
int cl_catia_nurbs(struct path_parse *p);

extern const struct cl_dialect cl_creo, cl_nx, cl_catia, cl_solidworks, cl_makino;

#endif
