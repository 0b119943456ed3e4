/*
 * arc_output - printed pieces as items of a path, with their contacts, and what a control sees of
 * them.
 */
#ifndef CLOUDMILL_ARC_OUTPUT_H
#define CLOUDMILL_ARC_OUTPUT_H

#include "arcprint.h"
#include "stage/arcrun.h"

/* Where the pieces come from. */
struct arc_output {
    const struct arcrun_options *options;
    const struct run_point *point;     /* of the dense run, as many as the reference has */
    const struct reference *reference; /* that the pieces follow */
};

/* Appends the pieces to the path, and adds what they are to the report. */
void arc_output_add(const struct arc_output *output, const struct printeds *printed,
                    struct path *out, struct arcrun_report *report);

#endif
