/*
 * scan_source - the scan that a mesh was made from and a path is guarded by, as streams name it: so
 * that a later tool reads the same points again, and knows when they are others.
 */
#ifndef CLOUDMILL_SCAN_SOURCE_H
#define CLOUDMILL_SCAN_SOURCE_H

#include <stdint.h>

#include "math/transform.h"
#include "math/vec.h"

/* One file of a scan. */
struct scan_source {
    char *name;      /* as it was given, relative to the folder it was read in; "-": was piped in */
    uint64_t points; /* how many it has */
    uint64_t hash;   /* of their coordinates: scan_source_hash */
};

/* All files of a scan; none: no scan is named. */
struct scan_sources {
    size_t n, cap;
    struct scan_source *item;
    bool placed;            /* `place` is more than the identity */
    struct transform place; /* from the numbers of the files to mm of the mesh or path */
};

/*
 * 64 bits that change when a coordinate changes or a point is missing, and not with the order of
 * the points: the sum of a hash of each (steps as FNV-1a's, 64 bits at a time, with a shift after
 * each).  No defence against intent.  -0 counts as 0.  That of all points is the sum of those of
 * parts of them.
 */
uint64_t scan_source_hash(const struct vec3 *point, size_t n);

/* Adds a file with these points, as they were read. */
void scan_sources_add(struct scan_sources *scan, const char *name, const struct vec3 *point,
                      size_t n);

/* The same of a file of which count and hash are known. */
void scan_sources_add_known(struct scan_sources *scan, const char *name, size_t points,
                            uint64_t hash);

/* Adds a file as a stream names it: points, hash (16 digits) and name, with this separator between
 * them.  False if the text is no such thing. */
bool scan_sources_read(struct scan_sources *scan, const char *text, char separator);

struct scan_sources scan_sources_copy(const struct scan_sources *scan);
void scan_sources_free(struct scan_sources *scan);

#endif
