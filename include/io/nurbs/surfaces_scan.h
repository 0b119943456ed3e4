/*
 * surfaces_scan - the scan that surfaces were fitted to, as files of surfaces name it: lines for
 * people at their head,
 *
 *     cloudmill scan POINTS HASH NAME       for each file of it, as in cloudmill-mesh(5)
 *     cloudmill place M11 ... M44           where it is not as it was read
 */
#ifndef CLOUDMILL_SURFACES_SCAN_H
#define CLOUDMILL_SURFACES_SCAN_H

#include <stdbool.h>

#include "mesh/scan_source.h"

/* These lines, each ended by '\n'; for the caller to free. */
char *surfaces_scan_text(const struct scan_sources *scan);

/* Takes one of them, without its end; false: the line is another. */
bool surfaces_scan_line(const char *line, struct scan_sources *scan);

#endif
