/*
 * path_part - one of several parts of a path, for several machines: parts are whole passes, follow
 * each other without gaps, and hold about as much work each.  A path without passes is all in its
 * first part.
 */
#ifndef CLOUDMILL_PATH_PART_H
#define CLOUDMILL_PATH_PART_H

#include "base/error.h"
#include "io/path/path.h"

/* Part `k` of `n`, 1 ... n; n 0: the whole. */
struct path_part {
    long k, n;
};

#define PATH_PART_MOST 10000

/* Reads `K/N`.  -1: it is none, or more than PATH_PART_MOST parts. */
int path_part_read(const char *text, struct path_part *part, struct error *error);

/* How much of the whole the parts before end with: element [from, to) of `n` belong to this part,
 * by an even division.  It is what the places where a pass begins are compared with. */
void path_part_share(struct path_part part, size_t n, size_t *from, size_t *to);

/* True if the part holds the start, or the end, of the whole. */
static inline bool path_part_first(struct path_part part)
{
    return part.k <= 1;
}

static inline bool path_part_last(struct path_part part)
{
    return part.k == part.n;
}

/* The items [from, to) of the path that are this part: from the first pass that begins in its
 * share to the first one that begins after it. */
void path_part_items(struct path_part part, const struct path *path, size_t *from, size_t *to);

#endif
