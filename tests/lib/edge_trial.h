/* edge_trial - a scan of a shape without points on its edges, for tests of how these are found. */
#ifndef CLOUDMILL_TESTS_EDGE_TRIAL_H
#define CLOUDMILL_TESTS_EDGE_TRIAL_H

#include "cloud/edge_steps.h"

struct edge_trial {
    struct vec3s scan;
    struct point_grid grid;
    struct edge_points_options options;
    struct edge_work work;
};

/* A scan of z = height(x, y) over 20 x 20 mm about the origin: a grid of 0.5 mm, or lines 0.8 mm
 * apart with points 0.2 mm apart along x; moved by `sigma` along z.  Places 0.2 mm apart are to be
 * put on edges. */
void edge_trial_make(struct edge_trial *trial, double (*height)(double x, double y), bool lines,
                     double sigma);
/* The same of a scan that is given, which it takes, its points so far apart. */
void edge_trial_of(struct edge_trial *trial, struct vec3s scan, double spacing, double sigma);
void edge_trial_free(struct edge_trial *trial);

/* A ridge along y = x / 4, 45 degrees steep. */
double edge_trial_roof(double x, double y);

/* Above zero, by its distance, on one side of the ridge. */
double edge_trial_side(double x, double y);

#endif
