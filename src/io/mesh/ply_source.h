/*
 * ply_source - the rows behind the head of a PLY file, value by value, whatever their format.
 */
#ifndef CLOUDMILL_PLY_SOURCE_H
#define CLOUDMILL_PLY_SOURCE_H

#include "base/error.h"
#include "ply_head.h"
#include "base/reader.h"

struct ply_source {
    struct reader *reader;
    enum ply_format format;
    const struct ply_element *element; /* whose rows are being read ... */
    size_t row;                        /* ... and the number of this one, from 0 */
    const char *at, *end;              /* ASCII: what is left of the row's line */
};

/* All four: 0, or -1 with the row's place in the message.  A row of an ASCII file is a line. */
int ply_row_begin(struct ply_source *s, struct error *error);
int ply_row_end(struct ply_source *s, struct error *error);

/* The next value of the row; nan and inf where they stand.  Ending early is an error. */
int ply_value(struct ply_source *s, enum ply_type type, double *value, struct error *error);

/* The next value as the length of a list: a whole number, not negative. */
int ply_length(struct ply_source *s, enum ply_type type, size_t *length, struct error *error);

/* Passes over one value or list. */
int ply_skip(struct ply_source *s, const struct ply_property *property, struct error *error);

/* Nothing but empty lines may follow the last element. */
int ply_finish(struct ply_source *s, struct error *error);

/* An error at the row's place: `file:line: ` or, in a binary file, `file: `. */
int ply_error(const struct ply_source *s, struct error *error, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
