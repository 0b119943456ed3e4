/*
 * scan - the scan that a path is guarded against, brought to where the mesh is.
 */
#ifndef CLOUDMILL_SCAN_H
#define CLOUDMILL_SCAN_H

#include "cli.h"
#include "mesh.h"

/*
 * Appends the points of all files to `points`, in the mesh's mm: placed as the mesh was, when its
 * stream says that it was placed (turned, shifted, or from other units), else as they are.
 * -1 when a file can't be read, has no points, or when the mesh is clearly elsewhere: more than
 * half of its vertices further than `near` mm from every point of the scan.
 */
int scan_read(const struct cli_list *files, const struct mesh *mesh, double near,
              struct vec3s *points, struct error *error);

#endif
