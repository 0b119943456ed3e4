/*
 * rest_passes - strips over what the passes have left of a scan (coverage.h), straight from its
 * points.
 *
 * Left are flanks nearly parallel to the planes of the passes, places beyond the mesh, and others
 * where that is too coarse.  So the points that are left are cut by planes across those of the
 * passes, or where they face along these by those of the passes, or level ones: each point goes, in
 * its tangent plane, to the nearest of a family of planes a step apart; the points of a plane in
 * their order are strips.  Where that makes short ones, of points that are few, these are strips
 * from each to the nearest instead, in no plane.
 */
#ifndef CLOUDMILL_REST_PASSES_H
#define CLOUDMILL_REST_PASSES_H

#include "toolpath/coverage.h"
#include "toolpath/slice.h"

struct rest_options {
    struct vec3 planes; /* the normal of the planes of the passes, unit */
    bool turned;        /* along them first, not across */
    bool rough;         /* points and their directions as they are, not moved nor evened */
    double step;        /* of the planes, mm */
    double gap;         /* strips go on over what is cut, if it is no longer than this, mm */
    double longest;     /* strips shorter than this are given up: their points become strips from
                           each to the next, wherever they are, mm; 0: none is */
};

/* A strip, and the normal of its plane. */
struct rest_strip {
    struct vec3 planes;
    struct contacts contact;
};

struct rest_strips {
    size_t n, cap;
    struct rest_strip *item;
};

/* The strips over the points that are left, each next one near the end of the one before. */
struct rest_strips rest_passes_find(const struct coverage_point *point, size_t n,
                                    const struct rest_options *options);

void rest_strips_free(struct rest_strips *strips);

#endif
