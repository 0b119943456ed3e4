/*
 * cloud_run - the common rows of a cloud, fast: the companion of cloud_row_read, which reads them
 * all and can say what is wrong with one.
 */
#ifndef CLOUDMILL_CLOUD_RUN_H
#define CLOUDMILL_CLOUD_RUN_H

#include <stddef.h>

#include "cloud_row.h"
#include "math/vec.h"

/*
 * Reads whole lines from [text, end), where the last byte is a LF, as long as they are three
 * numbers of this style in the first three columns, and whatever columns behind them.  Appends up
 * to `most` points; *rows says how many.  Returns how many bytes they took; the line behind them,
 * if there is one, is for cloud_row_read.
 */
size_t cloud_run(const struct cloud_options *style, const char *text, const char *end, size_t most,
                 struct vec3s *points, size_t *rows);

#endif
