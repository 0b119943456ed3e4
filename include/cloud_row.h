/*
 * cloud_row - one row of a text of points: how its columns are parted, and what it holds.
 */
#ifndef CLOUDMILL_CLOUD_ROW_H
#define CLOUDMILL_CLOUD_ROW_H

#include <stdbool.h>
#include <stddef.h>

#include "vec.h"

/* How the rows of a text are written; the same for the whole of it. */
struct cloud_style {
    char parting;     /* what parts the columns: ' ' (blanks and tabs), ',' or ';' */
    char point;       /* decimal point: '.' or ',', 0: only whole numbers so far */
    size_t column[3]; /* which columns are x, y and z, from 0 */
};

enum cloud_row_kind {
    CLOUD_POINT,
    CLOUD_NOT_FINITE, /* a coordinate is nan, inf or beyond 1e30 */
    CLOUD_EMPTY,
    CLOUD_COMMENT, /* begins with # // or, where semicolons part no columns, ; */
    CLOUD_SHORT,   /* numbers, but no column for z (or x or y) */
    CLOUD_WORD     /* a coordinate's column is no number */
};

struct cloud_row {
    enum cloud_row_kind kind;
    struct vec3 p;
    size_t columns; /* before a comment */
    size_t numbers; /* columns from the first one on that are numbers */
    char point;     /* decimal point of the coordinates, 0: none had one */
    const char *word; /* CLOUD_WORD: the column ... */
    int word_n;       /* ... and as much of it as a message shows */
};

/* Reads the n bytes at line (with a '\0' behind) as a row.  May change the line meanwhile. */
struct cloud_row cloud_row_read(const struct cloud_style *style, char *line, size_t n);

/*
 * Finds the style in which a line is a row with a point; `heading`, where not NULL, is the line
 * before it: when it names columns x, y and z, and as many columns as the row has, it says which
 * they are; else they are the first three.  False when there is no such style; *row is then what
 * comes closest.
 */
bool cloud_row_sniff(const char *heading, char *line, size_t n, struct cloud_style *style,
                     struct cloud_row *row);

/*
 * The common rows, fast: reads whole lines from [text, end), where the last byte is a line end, as
 * long as they are three numbers of this style in the first three columns, and whatever columns
 * behind them.  Appends up to `most` points; *rows says how many.  Returns how many bytes they
 * took; the line behind them is for cloud_row_read.
 */
size_t cloud_row_run(const struct cloud_style *style, const char *text, const char *end,
                     size_t most, struct vec3s *points, size_t *rows);

#endif
