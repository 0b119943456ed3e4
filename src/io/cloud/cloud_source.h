/*
 * cloud_source - what the readers of the several cloud formats share: where lines come from and
 * points and counts go to.
 */
#ifndef CLOUDMILL_CLOUD_SOURCE_H
#define CLOUDMILL_CLOUD_SOURCE_H

#include "io/cloud/cloud.h"
#include "cloud_row.h"
#include "base/reader.h"

struct cloud_source {
    struct reader *reader;
    struct vec3s *points;
    struct cloud_count *count;
};

/* The next line, as reader_line; a NUL byte in it is an error. */
int cloud_line(struct cloud_source *s, char **line, size_t *n, struct error *error);

/* Takes in a row that was read from the last line: 0, or -1 when it is no row of three numbers. */
int cloud_take(struct cloud_source *s, const struct cloud_row *row, struct error *error);

/* An error at the last line. */
int cloud_error(const struct cloud_source *s, struct error *error, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
