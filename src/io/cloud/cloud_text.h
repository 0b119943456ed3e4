/*
 * cloud_text - a cloud as free text: rows of x y z with comments, a heading before the first row,
 * and, as PTS files have it, a count of the rows that follow alone on a line.
 */
#ifndef CLOUDMILL_CLOUD_TEXT_H
#define CLOUDMILL_CLOUD_TEXT_H

#include <stdbool.h>
#include <stddef.h>

#include "math/vec.h"

/* How the rows of a text are written; the same for the whole of it. */
struct cloud_options {
    char delimiter;   /* what separates the columns: ' ' (blanks and tabs), ',' or ';' */
    char point;       /* decimal point: '.' or ',', 0: only whole numbers so far */
    size_t column[3]; /* which columns are x, y and z, from 0 */
};

static inline bool cloud_is_blank(char c)
{
    return c == ' ' || c == '\t';
}

enum cloud_row_kind {
    CLOUD_POINT,
    CLOUD_NOT_FINITE, /* a coordinate is nan, inf or beyond CLOUD_TOO_LARGE */
    CLOUD_EMPTY,
    CLOUD_COMMENT, /* begins with # // or, where semicolons separate no columns, ; */
    CLOUD_SHORT,   /* numbers, but no column for z (or x or y) */
    CLOUD_WORD     /* a coordinate's column is no number */
};

struct cloud_row {
    enum cloud_row_kind kind;
    struct vec3 p;
    size_t columns;   /* before a comment */
    size_t numbers;   /* columns from the first one on that are numbers */
    char point;       /* decimal point of the coordinates, 0: none had one */
    const char *word; /* CLOUD_WORD: the column ... */
    int word_n;       /* ... and as much of it as a message shows */
};

/* Beyond this a coordinate counts as not finite: its fourth power, in the sums of a quadric through
 * many points, still is. */
#define CLOUD_TOO_LARGE 1e30

/* Reads the n bytes at line (with a '\0' after them) as a row.  May change the line meanwhile. */
struct cloud_row cloud_row_read(const struct cloud_options *style, char *line, size_t n);

#endif
