/*
 * company - which borders run side by side, and which only touch or cross.
 */
#ifndef CLOUDMILL_COMPANY_H
#define CLOUDMILL_COMPANY_H

#include "guests.h"

/* A vertex that meets the border of a sheet. */
struct companion {
    size_t vertex;
    int sheet;
    size_t run;    /* the companion that stands for the whole run */
    double length; /* of the run, in the one that stands for it, mm */
};

struct company {
    size_t n, cap;
    struct companion *item; /* by vertex and sheet */
    double least;           /* mm: a shorter run only touches */
};

/* Runs of border edges of which both ends meet the border of one other sheet, or of the same sheet
 * half its range away; those count that are ten gaps long. */
void company_find(const struct meeting *m, struct company *company);

/* Does the border at this vertex run along the sheet's? */
bool company_has(const struct company *company, size_t vertex, int sheet);

/* Of the guests of a border edge of the sheet those whose border runs along it. */
void company_keep(const struct company *company, int sheet, struct guests *guests);

void company_free(struct company *company);

#endif
