/*
 * boundary_match - which borders run side by side, and which only touch or cross.
 */
#ifndef CLOUDMILL_BOUNDARY_MATCH_H
#define CLOUDMILL_BOUNDARY_MATCH_H

#include "t_vertices.h"

/* A vertex that meets the border of a sheet. */
struct boundary_pair {
    size_t vertex;
    int sheet;
    size_t run;    /* the companion that stands for the whole run */
    double length; /* of the run, in the one that stands for it, mm */
};

struct boundary_match {
    size_t n, cap;
    struct boundary_pair *item; /* by vertex and sheet */
    double least;               /* mm: a shorter run only touches */
};

/* Runs of border edges of which both ends meet the border of one other sheet, or of the same sheet
 * half its range away; those count that are ten gaps long. */
void boundary_match_find(const struct meeting *m, struct boundary_match *company);

/* Does the border at this vertex run along the sheet's? */
bool boundary_match_has(const struct boundary_match *company, size_t vertex, int sheet);

/* Of the guests of a border edge of the sheet those whose border runs along it. */
void boundary_match_keep(const struct boundary_match *company, int sheet,
                         struct t_vertices *guests);

void boundary_match_free(struct boundary_match *company);

#endif
