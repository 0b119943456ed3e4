/*
 * off - meshes from OFF text: OFF, COFF (with colours), NOFF (with normals).
 */
#ifndef CLOUDMILL_OFF_H
#define CLOUDMILL_OFF_H

#include "base/error.h"
#include "mesh/mesh.h"
#include "base/reader.h"

/*
 * From a reader that stands at the start of the file.  The counts stand behind the first word or in
 * the next line, then there is a line for each vertex and each face; what follows the numbers
 * needed is colour and passed over, and so are empty lines and what is behind a `#`.  Polygons
 * become fans of triangles.  Fewer lines than the counts say, an index out of range, a number that
 * is not finite are errors.
 */
int off_read(struct reader *r, struct mesh *mesh, struct error *error);

#endif
