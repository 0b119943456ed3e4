/*
 * ply_source - a PLY file of any format: its head (elements, properties, and what the mesh stream
 * says of itself in comments), then its rows, value by value.
 */
#ifndef CLOUDMILL_PLY_SOURCE_H
#define CLOUDMILL_PLY_SOURCE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "base/reader.h"
#include "mesh/mesh.h"

enum ply_format { PLY_ASCII, PLY_LITTLE_ENDIAN, PLY_BIG_ENDIAN };

enum ply_type {
    PLY_INT8,
    PLY_UINT8,
    PLY_INT16,
    PLY_UINT16,
    PLY_INT32,
    PLY_UINT32,
    PLY_FLOAT32,
    PLY_FLOAT64
};

enum { PLY_NAME_MAX = 32 };

struct ply_property {
    char name[PLY_NAME_MAX]; /* cut short when longer: then it is an unknown one */
    enum ply_type type;      /* of the value, or of each value of a list */
    bool list;
    enum ply_type length_type; /* of a list's length */
};

struct ply_element {
    char name[PLY_NAME_MAX];
    size_t count; /* rows, as the head says: to be believed when they have been read */
    struct {
        size_t n, cap;
        struct ply_property *item;
    } property;
};

struct ply_head {
    enum ply_format format;
    struct {
        size_t n, cap;
        struct ply_element *item;
    } element;
};

/*
 * Reads from `ply` to `end_header`; comments of the mesh stream go to *origin.  What is not a
 * PLY head, an unknown format or type, and a count that is no whole number are errors.  The caller
 * frees the head in either case.
 */
int ply_head_read(struct reader *r, struct ply_head *head, struct mesh_origin *origin,
                  struct error *error);

void ply_head_free(struct ply_head *head);

/* The element of this name, NULL when there is none; the same for an element's property, not a
 * list: its index, or -1. */
const struct ply_element *ply_head_element(const struct ply_head *head, const char *name);
int ply_element_property(const struct ply_element *element, const char *name);

struct ply_source {
    struct reader *reader;
    enum ply_format format;
    const struct ply_element *element; /* whose rows are being read ... */
    size_t row;                        /* ... and the number of this one, from 0 */
    const char *at, *end;              /* ASCII: what is left of the row's line */
};

/*
 * The next row of an ASCII file, if it is n plain numbers and a line end, which is what nearly all
 * are: its length in bytes, for ply_row_take, else 0, and nothing is read.
 */
size_t ply_row_numbers(const struct ply_source *s, size_t n, double *value);
void ply_row_take(struct ply_source *s, size_t length);

/* All four: 0, or -1 with the row's place in the message.  A row of an ASCII file is a line. */
int ply_row_begin(struct ply_source *s, struct error *error);
int ply_row_end(struct ply_source *s, struct error *error);

/* The next value of the row; nan and inf where they stand.  Ending early is an error. */
int ply_value(struct ply_source *s, enum ply_type type, double *value, struct error *error);

/* The next value as the length of a list: a whole number, not negative. */
int ply_length(struct ply_source *s, enum ply_type type, size_t *length, struct error *error);

/* Skips one value or list. */
int ply_skip(struct ply_source *s, const struct ply_property *property, struct error *error);

/* Nothing but empty lines may follow the last element. */
int ply_finish(struct ply_source *s, struct error *error);

/* An error at the row's place: `file:line: ` or, in a binary file, `file: `. */
int ply_error(const struct ply_source *s, struct error *error, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
