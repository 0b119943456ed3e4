/*
 * iges_text - free-format parameters in the records of an IGES file.
 */
#ifndef CLOUDMILL_IGES_TEXT_H
#define CLOUDMILL_IGES_TEXT_H

#include "iges.h"

/* A place in the text of some records. */
struct iges_cursor {
    const char *name; /* of the file */
    const struct iges_record *record;
    size_t records;
    size_t width;  /* columns that hold text: 72 in the global section, 64 for parameters */
    int entity;    /* whose parameters they are, 0: the global section */
    size_t column; /* of the next character, from 0 */
    char comma, semicolon;
};

/* The next character without taking it, '\0' at the end of the records. */
char iges_peek(struct iges_cursor *c);

/* Takes the next character. */
char iges_take(struct iges_cursor *c);

/*
 * The next parameter: 1, or 2 when it is the last one before the record delimiter, or -1.  A text
 * is copied to `text`, cut to its size.  Numbers may have exponents by E or D.
 */
int iges_next(struct iges_cursor *c, struct iges_value *value, char *text, size_t size,
              struct error *error);

/* The file's line that the cursor stands in. */
size_t iges_line(const struct iges_cursor *c);

#endif
