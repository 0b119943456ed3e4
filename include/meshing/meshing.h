/*
 * meshing - from the points of a scan to its mesh.
 *
 * In: points of one projection, seen along z, those on walls last (cloud/cloud.h).  Out: a mesh
 * (mesh/mesh.h) with rows, whose vertices are points of the scan or, where that is noisy, places on
 * the surface that its points lie about.  Two ways to the vertices:
 *
 *   by a spacing (Chui, Chiu, Yu 2007, section 3.2)
 *      1. an oblique grid of equilateral triangles over the points: grid.h
 *      2. the point that each of its nodes takes: reposition.h
 *      3. facets between those that have one: grid_mesh.h
 *   within an error
 *      1. rows, halved and shortened until the points are within the error of the facets between
 *         them: adaptive_rows.h (Douglas, Peucker 1973); how, adaptive_rows_steps.h
 *      2. points between the rows where these do not come near enough: greedy_insert.h (Garland,
 *         Heckbert 1995)
 *      3. rows keep clear of creases and walls that a grid has found before: feature_zone.h
 *
 *   by other ways that paper 1 reviews
 *      a rectangular grid by interpolation: lin_grid.h (Lin, Liu 1998)
 *      a triangulation of the points, all or few: delaunay_mesh.h (Choi 1988); their border,
 *      scan_border.h; how, delaunay.h, delaunay_thin.h
 *
 * Then, for both of the first: normals and curvatures from the scan, scan_normals.h; with noise,
 * vertices moved onto the surface, smooth_nodes.h; creases, walls and ribs, feature/feature.h.  The
 * meshes of the parts of a divided cloud are joined: mesh_join.h.  stage/cloudmesh.h puts all this
 * together.
 */
#ifndef CLOUDMILL_MESHING_H
#define CLOUDMILL_MESHING_H

#include "meshing/adaptive_rows.h"
#include "meshing/delaunay_mesh.h"
#include "meshing/feature_zone.h"
#include "meshing/greedy_insert.h"
#include "meshing/grid.h"
#include "meshing/grid_mesh.h"
#include "meshing/lin_grid.h"
#include "meshing/mesh_join.h"
#include "meshing/reposition.h"
#include "meshing/scan_normals.h"
#include "meshing/smooth_nodes.h"

#endif
