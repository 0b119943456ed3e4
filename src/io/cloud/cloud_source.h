/*
 * cloud_source - what the readers of the several cloud formats share: where lines come from, and
 * where points and counts go to.
 */
#ifndef CLOUDMILL_CLOUD_SOURCE_H
#define CLOUDMILL_CLOUD_SOURCE_H

#include "base/aside.h"
#include "base/reader.h"
#include "cloud_text.h"
#include "io/cloud/cloud.h"

struct cloud_source {
    struct reader *reader;
    struct vec3s *points;
    size_t first; /* of the points, from which on they are of this file */
    struct cloud_count *count;
    int threads; /* that parse rows, as in parallel.h */
    void (*take)(void *context, const struct vec3 *point, size_t n); /* NULL: `points` keeps all */
    void *context;
    struct aside *aside; /* takes them while others are read, NULL: `take` is */
    struct vec3s *taken; /* what is being taken; it and `points` change places */
};

/* Hands on the points so far, where they are taken; a reader may do so when it will not come back
 * to them. */
void cloud_hand_on(struct cloud_source *s);

/* The next line, as reader_line; a NUL byte in it is an error. */
int cloud_line(struct cloud_source *s, char **line, size_t *n, struct error *error);

/* Appends the point of a row that was read from the last line: 0, or -1 when the row does not hold
 * three numbers. */
int cloud_take(struct cloud_source *s, const struct cloud_row *row, struct error *error);

/* The same of a point of a binary file: one that is not finite is counted and left out. */
void cloud_take_point(struct cloud_source *s, struct vec3 p);

/* An error at the last line. */
int cloud_error(const struct cloud_source *s, struct error *error, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* The readers: each reads to the end of the input, with the errors of cloud_read. */
int cloud_text_read(struct cloud_source *source, struct error *error);
int cloud_obj_read(struct cloud_source *source, struct error *error); /* Wavefront, v lines */
int cloud_pcd_read(struct cloud_source *source, struct error *error); /* of PCL */
int cloud_las_read(struct cloud_source *source, struct error *error); /* not compressed */

/*
 * PTX, the grid of a terrestrial scanner, one scan or several after each other:
 *
 *     columns                      each a whole number alone on its line
 *     rows
 *     x y z                        four lines: scanner's place and axes
 *     m11 m12 m13 m14              four lines: [x y z 1] times this matrix is the point
 *     x y z intensity [r g b]      columns * rows cells; 0 0 0: nothing was measured
 */
int cloud_ptx_read(struct cloud_source *source, struct error *error);

/* The line is a statement of an OBJ file: one of its keywords and a blank after it. */
bool cloud_obj_statement(const char *line, size_t n);

#endif
