/*
 * delaunay_thin - a triangulation of few points of a scan that comes near to all of them
 * (delaunay_mesh.h).
 */
#ifndef CLOUDMILL_DELAUNAY_THIN_H
#define CLOUDMILL_DELAUNAY_THIN_H

#include "delaunay.h"
#include "meshing/delaunay_mesh.h"
#include "meshing/scan_border.h"

/* Puts points into an empty triangulation of them; returns which triangles are surface, for the
 * caller to free. */
bool *delaunay_thin(struct delaunay *d, const struct vec3 *point, const struct scan_border *border,
                    const struct delaunay_mesh_options *options);

#endif
