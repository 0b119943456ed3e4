/*
 * cloud_plain - the common rows of a text, fast: reading a cloud spends most of its time here, so
 * that this goes over the text once, copies nothing, and tests no more than it must to know that a
 * row is plain.
 */
#ifndef CLOUDMILL_CLOUD_PLAIN_H
#define CLOUDMILL_CLOUD_PLAIN_H

#include "base/array.h"
#include "cloud_text.h"

/* Have the numbers of a column as many decimals in nearly each of the first rows?  The last byte
 * before `end` is a LF.  Then num_even reads them faster. */
bool cloud_plain_even(const char *text, const char *end);

/* Text of two parts and more is read by several threads, all of it, whatever they find. */
enum { CLOUD_PLAIN_PART = 1 << 17 /* bytes for one of them */, CLOUD_PLAIN_PARTS = 16 };

/*
 * Reads whole lines from [text, end), where the last byte is a LF, as long as they are three
 * numbers of this style in the first three columns, and any columns after them.  Appends up
 * to `most` points; *rows says how many.  Returns how many bytes they took; the line after them,
 * if there is one, is for cloud_row_read.  `threads` as in parallel.h: they change nothing but the
 * time.
 */
size_t cloud_plain_rows(const struct cloud_options *style, bool even, int threads, const char *text,
                        const char *end, size_t most, struct vec3s *points, size_t *rows);

#endif
