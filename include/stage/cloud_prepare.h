/*
 * cloud_prepare - scanned points as files give them, made ready for a mesh: read, placed, cleaned;
 * and what was skipped or taken out is said.
 */
#ifndef CLOUDMILL_CLOUD_PREPARE_H
#define CLOUDMILL_CLOUD_PREPARE_H

#include <stdbool.h>

#include "cloud/sheets.h"
#include "io/cloud/cloud.h"
#include "math/point_grid.h"
#include "base/error.h"
#include "mesh/mesh.h"
#include "math/vec.h"

/* Reads all files as one cloud, in their own units, and says what was skipped.  Returns 0, in
 * *scan what the files are, and in *left_out how many rows were no points; -1: an error with its
 * place. */
int cloud_prepare_read(char **file, int files, int threads, struct vec3s *points,
                       struct scan_sources *scan, size_t *left_out, struct error *error);

/* Says what was skipped of a file. */
void say_skipped(const char *file, const struct cloud_count *count);

/* The same, of its rows without data alone. */
void say_no_data(const char *file, const struct cloud_count *count);

/* Unit, matrix (a file, or NULL), lowest leftmost point as origin (paper 1, 3.1), in this order,
 * into the points and the mesh's record of its place.  -1: the matrix cannot be read. */
int cloud_prepare_place(struct vec3s *points, const char *unit, const char *matrix, bool to_origin,
                        struct mesh_origin *origin, struct error *error);

/* What is known of a cloud that was cleaned. */
struct cloud_prepare {
    size_t twice, outliers, under; /* taken out: outliers.h */
    double noise;                  /* noise.h, mm */
    struct vec3s covered;          /* those under others that were: a mesh by parts has room */
};

enum cloud_prepare_drop { CLOUD_PREPARE_KEEP, CLOUD_PREPARE_DROP_OUTLIERS, CLOUD_PREPARE_DROP };

/* The noise that vertices are to be rid of, mm: what the user says of it or, negative, what was
 * measured, unless that is so little, by the `spacing` of the points, that it does not matter
 * beside the facets. */
double cloud_prepare_noise(double asked, double measured, double spacing);

/*
 * Takes out points that are there twice and, as `drop` says, outliers or these and points under a
 * roof, and measures the noise; says what it found.  `spacing` is the mean spacing, mm, `noise`
 * what the user says of it (believed.h); with 0 all points are believed.  The points
 * are in the order of point_grid.h afterwards, whatever it was.  The caller frees what is covered.
 * -1: too many of them.
 */
int cloud_prepare_clean(struct vec3s *points, double spacing, double noise,
                        enum cloud_prepare_drop drop, int threads,
                        struct cloud_prepare *cloud_prepare, struct error *error);

/*
 * Writes the points that are believed, as they were read (`raw`), to a file, and those that are not
 * to FILE.outliers; it is decided on them as placed, in the same order.  `name`: of the scan, for
 * the comment at the head of both.  *kept gets the points of the first.  -1: too many points.
 */
int cloud_prepare_write_clean(const char *file, const char *name, const struct vec3s *raw,
                              const struct vec3s *placed, double noise, int threads,
                              struct vec3s *kept, struct error *error);

/* Says where, and how far apart, if there are two sheets. */
void say_sheets(const struct sheets *sheets);

#endif
