/*
 * cloud - reading scanned points from text as scanners write it, and from the point formats of
 * other programs.  The door of this folder.
 *
 * In: a file.  Out: its points in the file's own units, and counts of what was left out.  The
 * stages: the format by its first lines (cloud.c); the rows, read by what the formats share
 * (cloud_source.h): free text and PTS (cloud_text.h; nearly all rows by cloud_plain.h), OBJ, PTX
 * and PCD (cloud_formats.c), LAS (cloud_las.c), PLY, STL, OFF (io/mesh).  Beside it matrix.h, the
 * file that places a cloud, and cloud_spool.h, where points are set aside.
 */
#ifndef CLOUDMILL_CLOUD_H
#define CLOUDMILL_CLOUD_H

#include <stdbool.h>

#include "base/error.h"
#include "math/vec.h"

/* What was read and what was skipped, for messages. */
struct cloud_count {
    size_t points;
    size_t comments;         /* lines */
    size_t heads;            /* heading lines before the first point (names, prose, a count) */
    size_t not_finite;       /* rows with nan, inf or a number too large: left out */
    size_t not_measured;     /* empty cells of a PTX grid: left out */
    size_t no_data;          /* rows whose z stands for nothing measured: left out */
    double mark;             /* the z of the first of them */
    size_t withheld;         /* points that a LAS file marks as deleted: left out */
    size_t facets;           /* of a mesh (STL, PLY, OFF), whose corners alone are taken */
    bool indexed;            /* the first column numbers the rows: x y z are the next three */
    bool placed;             /* x y z are the columns that a heading calls so, not the first */
    size_t columns;          /* most columns of a row, of those that were read one by one */
    size_t first_not_finite; /* line of the first of them, 0: the format has no lines */
    size_t open_end;         /* line of a last row without a line end, of text; 0: it has one */
};

/*
 * Appends the points of one file (NULL or "-": standard input) to `points`, in the file's own
 * units, and fills *count anew.  Accepts, recognised by content, not by the file's name:
 *   - rows of x y z and any further columns, separated by blanks, tabs, commas or semicolons, with
 *     a decimal comma where semicolons or blanks separate the columns; comments after # // or ;
 *     and heading lines before the first row (names, prose, a count of points alone on its line);
 *     where a heading names as many columns as there are, x y z are those that it calls so
 *   - PTS, PTX (its 4 x 4 matrix applied), ASCII PCD, OBJ (its v lines)
 *   - PLY, ASCII or binary (its vertices)
 * Rows whose z is -9999, -99999, -32767 or -32768, as grids of heights mark cells without data, are
 * left out and counted.
 * A row that is no row in the middle of the data is an error with its line; so are binary and
 * compressed files, UTF-16, a last row cut short, and a count that is not met.  `threads` as in
 * parallel.h: rows of a large text are parsed by so many; what comes of it is the same.
 */
int cloud_read(const char *file, int threads, struct vec3s *points, struct cloud_count *count,
               struct error *error);

/* The same, with the points handed to `take` block by block, in their order, as they are read: text
 * is nowhere whole.  Those before an error were handed on too.  With more than one thread (0: as
 * parallel.h) `take` is called by another, while the next block is read; all is done on return. */
int cloud_read_blocks(const char *file,
                      void (*take)(void *context, const struct vec3 *point, size_t n),
                      void *context, int threads, struct cloud_count *count, struct error *error);

/* Rows, cells and points that were left out, together. */
size_t cloud_left_out(const struct cloud_count *count);

/* Millimetres in a unit: "mm" 1, "cm" 10, "m" 1000, "um" 0.001, "inch" and "in" 25.4; else 0. */
double cloud_unit(const char *name);

#endif
