/*
 * off - meshes from OFF text: OFF, COFF (with colours), NOFF (with normals).
 */
#ifndef CLOUDMILL_OFF_H
#define CLOUDMILL_OFF_H

#include "base/error.h"
#include "mesh/mesh.h"
#include "base/reader.h"

/*
 * From a reader that stands at the start of the file.  The counts follow the first word or are in
 * the next line, then there is a line for each vertex and each face; what follows the numbers
 * needed is colour and skipped, like empty lines and what follows a `#`.  Polygons
 * become fans of triangles.  Fewer lines than the counts say, an index out of range, a number that
 * is not finite are errors.
 */
int off_read(struct reader *r, struct mesh *mesh, struct error *error);

#endif
