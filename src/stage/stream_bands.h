/*
 * stream_bands - the rows of a cloud_stream's grid in bands, and the points about each of them.
 *
 * A band has as many rows as have no more points about them than may be in memory.  To look at the
 * whole cloud for each band would take longer the more of them there are; so its points are told
 * apart in one look, and set aside in a spool for each band (io/cloud/cloud_spool.h), the points
 * between two bands in both.  Where there is no room for that all are looked at for each band.
 */
#ifndef CLOUDMILL_STREAM_BANDS_H
#define CLOUDMILL_STREAM_BANDS_H

#include "stage/cloud_stream.h"

/* The row of the grid that a point is in; beside the grid the nearest one. */
int stream_row(const struct grid *grid, const struct vec3 *p);

struct stream_band {
    int first, last;           /* rows */
    int low, high;             /* rows of the points about them */
    size_t n;                  /* these */
    struct cloud_spool *spool; /* they are in it; NULL: in none */
};

struct stream_bands {
    size_t n, cap;
    struct stream_band *item;
};

/* All rows; of_row[]: how many points there are in each; `about`: rows on both sides of a band
 * whose points it needs.  A row with more than `at_a_time` about it is a band of its own. */
struct stream_bands stream_bands_of(const struct grid *grid, const size_t *of_row, int about,
                                    size_t at_a_time);

/* Appends the points of band k in the order of the cloud, which must not be asked for twice; bands
 * from the first one on.  -1: the file cannot be read again. */
int stream_bands_points(struct stream_bands *bands, size_t k, struct cloud_stream *stream,
                        struct vec3s *points, struct error *error);

void stream_bands_free(struct stream_bands *bands);

/* Shows all points of the file, as placed, to `see`.  -1: also where they are others than before.
 */
int cloud_stream_look(struct cloud_stream *stream,
                      void (*see)(void *context, const struct vec3 *point, size_t n), void *context,
                      struct error *error);

#endif
