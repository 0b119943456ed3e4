/*
 * iges - an IGES file (versions 1 to 5.3, fixed-width ASCII) as directory entries and their
 * parameters; what the entities mean is in iges_curve.h and iges_surface.h.
 *
 * Lines of 80 columns with the section's letter in column 73, with or without line ends between
 * them.  Sequence numbers, the counts of the terminate section and the pointers between directory
 * and parameters are checked: a file that is cut or mixed up is an error with its line.
 */
#ifndef CLOUDMILL_IGES_H
#define CLOUDMILL_IGES_H

#include "mesh/scan_source.h"
#include "base/error.h"
#include "base/reader.h"

struct iges_record {
    char text[81];
    size_t line; /* of the file */
};

struct iges_records {
    size_t n, cap;
    struct iges_record *item;
};

struct iges_entity {
    int type, form;
    int number;   /* sequence number of its first directory line, odd */
    size_t first; /* its first parameter line, from 1 ... */
    size_t lines; /* ... and how many */
    int matrix;   /* of its transformation (type 124), 0: none */
    size_t at;    /* line of the file */
};

struct iges_entities {
    size_t n, cap;
    struct iges_entity *item;
};

struct iges {
    char *name;               /* of the file */
    char comma, semicolon;    /* the file's own delimiters of parameters and of records */
    double unit;              /* mm in one of the file's units, its model scale worked in */
    double scale;             /* model space scale as the file has it */
    char unit_name[16];       /* of the unit flag */
    char unit_text[16];       /* what the file calls it beside the flag */
    struct scan_sources scan; /* that its start section names: surfaces_scan.h */
    struct iges_records global, parameter;
    struct iges_entities entity;
};

/* One parameter: a number, a text (Hollerith), or nothing, which means the default. */
struct iges_value {
    enum iges_kind { IGES_DEFAULT, IGES_NUMBER, IGES_TEXT } kind;
    double number; /* 0 unless it is one */
    size_t line;   /* of the file */
};

struct iges_values {
    size_t n, cap;
    struct iges_value *item; /* item[0] is the entity type */
    size_t line;             /* where the entity's parameters begin */
};

/* Reads the whole of an IGES file from a reader that stands at its start. */
int iges_read(struct reader *r, struct iges *iges, struct error *error);

/* The entity of that number, or NULL when there is none. */
const struct iges_entity *iges_entity(const struct iges *iges, int number);

/* All parameters of an entity up to its record delimiter.  The caller frees them (array_free). */
int iges_values(const struct iges *iges, const struct iges_entity *entity,
                struct iges_values *values, struct error *error);

/* A parameter as a whole number, -1 when it is none, is missing or is out of min..max; `what` is
 * for the message. */
int iges_whole(const struct iges *iges, const struct iges_values *values, size_t index, long min,
               long max, const char *what, long *number, struct error *error);

/* -1 when one of the parameters from..to - 1 that are there is a text, or a number above `most`. */
int iges_numbers(const struct iges *iges, const struct iges_values *values, size_t from, size_t to,
                 double most, struct error *error);

/* The entity that parameter `index` points to; -1 when there is none of that number. */
int iges_pointer(const struct iges *iges, const struct iges_values *values, size_t index,
                 const struct iges_entity **entity, struct error *error);

void iges_free(struct iges *iges);

#endif
