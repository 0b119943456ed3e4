/*
 * upsample_surface - the surface about a point of a sparse scan that points are put on
 * (cloud/upsample.h): one of the second or third degree, or, where an edge explains the points
 * better, of few facets.  Lengths in mm.
 */
#ifndef CLOUDMILL_UPSAMPLE_SURFACE_H
#define CLOUDMILL_UPSAMPLE_SURFACE_H

#include "cloud/upsample.h"
#include "math/least_planes.h"
#include "math/quadric.h"

/* The fewest points of a surface, the nearest that are looked at, those of a cubic, and the most
 * that some are picked of where the nearest are on two lines. */
enum { UPSAMPLE_FEWEST = 16, UPSAMPLE_NEAR = 32, UPSAMPLE_FEW = 24, UPSAMPLE_LINES = 256 };

/* A neighbourhood, nearest first. */
struct upsample_hood {
    size_t n;
    uint32_t index[UPSAMPLE_NEAR];
    double distance2[UPSAMPLE_NEAR];
    struct vec3 point[UPSAMPLE_NEAR];
};

/* Of point i; of several in one place, this one first. */
void upsample_hood_find(const struct upsample *fill, size_t i, size_t k,
                        struct upsample_hood *near);

struct upsample_surface {
    struct quadric q;
    bool facetted;              /* it is the facets, in the frame of the quadric */
    struct least_planes facets; /* of heights upwards, so that no hollow parts them */
    double spread;              /* of the points about the quadric; HUGE_VAL: there is none */
};

/* Through the neighbourhood of point i.  No facets: upsample_facets_find. */
void upsample_surface_find(const struct upsample_hood *near, struct upsample_surface *surface);

/* The same, or, where these are on two lines of a scan that is on lines, as at its border, which
 * carry none, through as few points of a wider neighbourhood (up to UPSAMPLE_LINES) that are as far
 * apart along lines as these are. */
void upsample_surface_about(const struct upsample *fill, const struct upsample_hood *near,
                            struct upsample_surface *surface);

/* Through the first k points: of the second or third degree, as leaves less.  Returns the spread,
 * HUGE_VAL: there is none. */
double upsample_surface_fit(const struct upsample_hood *near, size_t k, struct vec3 origin,
                            struct vec3 guess, struct quadric *q);

/* Facets in its place, where the points about i are farther off it than `even`, and as many as
 * facets take are as near to these: a surface that bends goes below an edge between points.  False:
 * it stays as it is. */
bool upsample_facets_find(const struct upsample *fill, size_t i, double even,
                          struct upsample_surface *surface);

/* Facets in its place, in the frame of surface->q, where these explain the noisy points about p
 * (fill->noise) and no one surface of the second or third degree does as well, by more than chance:
 * a smooth surface through points on both sides of a blunt edge goes below that.  *reach: how far
 * these points are, mm.  False: it stays as it is. */
bool upsample_facets_explain(const struct upsample *fill, struct vec3 p,
                             struct upsample_surface *surface, double *reach);

/* Distance of a point from the surface, to first order (of facets along the normal of the quadric's
 * frame): positive on the side of that. */
double upsample_surface_off(const struct upsample_surface *surface, struct vec3 p);

/* The point over u, v. */
struct vec3 upsample_surface_at(const struct upsample_surface *surface, double u, double v);

#endif
