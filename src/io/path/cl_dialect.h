/*
 * cl_dialect - CL files of CAM systems, known by their words (design/2-streams.md).
 *
 * A system is one row of the table in cl_dialect.c: how it shows, and its own words.  What they all
 * share (GOTO, CIRCLE, CYCLE, FEDRAT...) is read the same way whatever system it is.
 */
#ifndef CLOUDMILL_CL_DIALECT_H
#define CLOUDMILL_CL_DIALECT_H

#include "path_parse.h"

struct cl_dialect {
    const char *name;
    bool (*shows)(const struct apt *apt); /* the statement is this system's and no other's */
    const struct path_row *rows;          /* its own words */
    size_t n;
};

/* Finds out from this statement whose stream it is, if it shows. */
void cl_sniff(struct path_parse *p);

/* Ends a NURBS of NX when the statement is none of its parts: 0, or -1. */
int cl_nurbs_end(struct path_parse *p);

/*
 * Adds the motion on a B-spline, which it takes over, from where the tool is: its knots as long as
 * it is, and the same in straight pieces.  -1: it cannot be cut.
 */
int cl_add_curve(struct path_parse *p, struct bspline curve);

/* Statements from BEGIN NURBS_SIEMENS to END NURBS (CATIA): 1 it was one, 0 it was none, -1. */
int cl_catia_nurbs(struct path_parse *p);

extern const struct cl_dialect cl_creo, cl_nx, cl_catia, cl_solidworks, cl_makino;

#endif
