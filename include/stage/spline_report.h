/*
 * spline_report - the report of bsplfit, with the columns of the tables of paper 2: points,
 * control points, percentage of reduction, C1 and C2; and the proven distance both ways.
 */
#ifndef CLOUDMILL_SPLINE_REPORT_H
#define CLOUDMILL_SPLINE_REPORT_H

#include <stdio.h>

#include "splinefit/spline_run.h"

struct spline_report {
    size_t points, splines, poles;
    size_t polylines; /* splines that fell back to degree 1 with a pole at each point */
    size_t spans;
    size_t cut;                 /* curves whose search was cut short */
    double shortest;            /* knot span, mm, from place to place; */
    size_t shorter;             /* how many are shorter than the least length asked for */
    struct fit_error deviation; /* the largest of each */
    struct deviation worst;     /* the largest of each */
    double spent;               /* of the tolerance, mm: the worst distance, and what dense
                                   data took */
};

/* Counts one piece, and its knot spans shorter than `least` mm; unless `table` is NULL, writes its
 * row. */
void spline_report_add(struct spline_report *report, size_t pass, double least,
                       const struct spline_run_piece *piece, FILE *table);

/* The headings of the table, and its last row. */
void spline_report_head(FILE *table);
void spline_report_totals(const struct spline_report *report, FILE *table);

/* Percentage of reduction. */
double spline_report_fewer(size_t points, size_t poles);

/* What a piece spent of the tolerance, mm. */
double spline_report_spent(const struct spline_run_piece *piece);

#endif
