/*
 * believed - which points of a scan are believed, and how noisy they are: the one decision that a
 * mesh is made by, a ball is kept clear by, and a program is judged by.
 *
 *   noise      noise.h: one standard deviation, and whether it is the scanner's
 *   outliers   outliers.h: points that nothing else of the scan bears out
 *   sheets     sheets.h: scans over each other that do not meet
 *   rounding   rounding.h: heights that were rounded, spread where that makes noise of it
 */
#ifndef CLOUDMILL_BELIEVED_H
#define CLOUDMILL_BELIEVED_H

#include "base/error.h"
#include "cloud/noise.h"
#include "cloud/sheets.h"
#include "math/point_grid.h"

struct believed_options {
    double noise; /* standard deviation that the user says, mm; negative: measured; 0: every point
                     is believed as it is */
    int threads;  /* as of parallel_for */
};

struct believed {
    struct noise noise; /* as measured, of the points that are there once */
    double sigma;       /* what points may be off their surface by: what the user says, or the noise
                           measured where it is the scanner's and there are no two sheets but at
                           a few places (or of the even places, noise.h); else 0 */
    size_t outliers, beneath; /* points of these marks (outliers.h) */
    struct sheets sheets;
    double apart; /* half their distance, mm; 0 where there are none but at a few places */
};

/* Marks outliers in out[] as outliers.h does, in the order of the grid, beside what is marked; no
 * point of the grid may be there twice. */
struct believed believed_in_grid(const struct point_grid *point_grid,
                                 const struct believed_options *options, unsigned char *out);

/*
 * The same of n points in any order, which stay in it: out[i] becomes the mark of an outlier (and
 * of each that is equal to one), else 0.  -1: too many points.
 */
int believed_find(const struct vec3 *point, size_t n, const struct believed_options *options,
                  unsigned char *out, struct believed *believed, struct error *error);

/* Takes the mark off points that are beneath the surface: who guards or judges believes them. */
void believed_keep_beneath(unsigned char *out, size_t n);

/*
 * Spreads heights that were rounded, unless each point is believed as it is, or even so there is no
 * noise, or none that can be told from the shape: whatever noise is said, so that all who look at a
 * scan do the same.  `noise`, threads: as of the options.  Returns the step that they were rounded
 * to; 0: they stay as they are.
 */
double believed_unround(struct vec3 *point, size_t n, double noise, int threads);

#endif
