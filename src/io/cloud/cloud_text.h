/*
 * cloud_text - a cloud as free text: rows of x y z with comments, a heading before the first row,
 * and, as PTS files have it, a count of the rows that follow alone on a line.
 */
#ifndef CLOUDMILL_CLOUD_TEXT_H
#define CLOUDMILL_CLOUD_TEXT_H

#include "cloud_source.h"

/* Reads to the end of the input; errors as those of cloud_read. */
int cloud_text_read(struct cloud_source *source, struct error *error);

#endif
